"""geomdl (NURBS-Python), pure Python; it has no antiderivative or product."""

from copy import deepcopy

from geomdl import BSpline, fitting, operations

import inputs
from questions import Answer, Interpolant, Pieces, Points, Spline, Way, elevated_curve, refined_curve

NAME = "geomdl"
SINGLES, BATCH = 200, 2000


def _curve(spline: Spline | None = None) -> BSpline.Curve:
    knots = inputs.clamped(inputs.DEGREE, inputs.SPANS)
    spline = spline or Spline(inputs.DEGREE, knots, inputs.points(inputs.CONTROLS))
    curve = BSpline.Curve(normalize_kv=False)
    curve.degree = spline.degree
    curve.ctrlpts = spline.coeffs
    curve.knotvector = spline.knots
    return curve


def _surface() -> BSpline.Surface:
    surface = BSpline.Surface(normalize_kv=False)
    surface.degree_u = surface.degree_v = inputs.DEGREE
    n = inputs.SURFACE_CONTROLS
    surface.set_ctrlpts(inputs.points(n * n), n, n)
    surface.knotvector_u = surface.knotvector_v = inputs.clamped(inputs.DEGREE, inputs.SURFACE_SPANS)
    return surface


def _spline(curve: BSpline.Curve) -> Spline:
    return Spline(curve.degree, curve.knotvector, curve.ctrlpts)


def _points(curve: BSpline.Curve) -> list[Way]:
    ways = []
    for order, all_parameters in [("sorted", inputs.sorted_parameters()), ("random", inputs.random_parameters())]:
        few, many = inputs.part(all_parameters, SINGLES), inputs.part(all_parameters, BATCH)

        def single(xs: list[float] = few) -> list[list[float]]:
            return [curve.evaluate_single(x) for x in xs]

        def batch(xs: list[float] = many) -> list[list[float]]:
            return curve.evaluate_list(xs)

        def at_few(values: list[list[float]], xs: list[float] = few) -> Answer:
            return Points(xs, [values])

        def at_many(values: list[list[float]], xs: list[float] = many) -> Answer:
            return Points(xs, [values])

        ways.append(Way(f"curve point, single, {order}", "Curve.evaluate_single", single, at_few, len(few)))
        how = "Curve.evaluate_list, 2000 points"
        ways.append(Way(f"curve point, batch, {order}", how, batch, at_many, len(many)))
    few = inputs.part(inputs.random_parameters(), SINGLES)
    ways.append(
        Way(
            "curve point and 2 derivatives, single, random",
            "Curve.derivatives",
            lambda: [curve.derivatives(x, 2) for x in few],
            lambda rows: Points(few, list(zip(*rows, strict=True))),
            len(few),
        )
    )
    return ways


def _surfaces() -> list[Way]:
    surface = _surface()
    few, many = inputs.part(inputs.random_pairs(), SINGLES), inputs.part(inputs.random_pairs(), BATCH)

    def jets(rows: list[list[list[list[float]]]]) -> Answer:
        return Points(few, [[r[i][j] for r in rows] for i, j in [(0, 0), (1, 0), (0, 1)]])

    return [
        Way(
            "surface point, single, random",
            "Surface.evaluate_single",
            lambda: [surface.evaluate_single(x) for x in few],
            lambda values: Points(few, [values]),
            len(few),
        ),
        Way(
            "surface point, batch, random",
            "Surface.evaluate_list, 2000 points",
            lambda: surface.evaluate_list(many),
            lambda values: Points(many, [values]),
            len(many),
        ),
        Way(
            "surface point and first derivatives, random",
            "Surface.derivatives",
            lambda: [surface.derivatives(u, v, 1) for u, v in few],
            jets,
            len(few),
        ),
    ]


def _thinned(fine: BSpline.Curve, knots: list[float]) -> BSpline.Curve:
    curve = deepcopy(fine)
    for x in knots:
        operations.remove_knot(curve, [x], [1])
    return curve


def _refined(curve: BSpline.Curve, knots: list[float]) -> BSpline.Curve:
    """`operations.refine_knotvector` would also raise the multiplicity of every knot to the degree."""
    result = deepcopy(curve)
    for x in knots:
        operations.insert_knot(result, [x], [1])
    return result


def _derivative(curve: BSpline.Curve) -> Answer:
    """The knots of the result are normalised to [0, 1]: back to the domain."""
    a, b = inputs.break_at(0), inputs.break_at(inputs.SPANS)
    knots = curve.knotvector
    if knots[-1] != b:
        knots = [a + (b - a) * x for x in knots]
    return Spline(curve.degree, knots, curve.ctrlpts)


def _interpolant(curve: BSpline.Curve) -> Answer:
    parameters = fitting.compute_params_curve(inputs.points(inputs.CONTROLS))
    return Interpolant(_spline(curve), parameters)


def _operations(curve: BSpline.Curve) -> list[Way]:
    knots, data = inputs.middles(), inputs.points(inputs.CONTROLS)
    fine, elevated = _curve(refined_curve()), _curve(elevated_curve())
    return [
        Way("refine every span", "operations.insert_knot, knot by knot", lambda: _refined(curve, knots), _spline),
        Way(
            "elevate by one",
            "operations.degree_operations",
            lambda: operations.degree_operations(deepcopy(curve), [1]),
            _spline,
        ),
        Way("derivative", "operations.derivative_curve", lambda: operations.derivative_curve(curve), _derivative),
        Way(
            "interpolate 1000 points",
            "fitting.interpolate_curve with its own parameters",
            lambda: fitting.interpolate_curve(data, inputs.DEGREE),
            _interpolant,
        ),
        Way(
            "Bezier pieces",
            "operations.decompose_curve",
            lambda: operations.decompose_curve(curve),
            lambda pieces: Pieces([piece.ctrlpts for piece in pieces]),
        ),
        Way(
            "remove inserted knots",
            "operations.remove_knot, knot by knot",
            lambda: _thinned(fine, knots),
            _spline,
        ),
        Way(
            "reduce an elevated curve",
            "operations.degree_operations",
            lambda: operations.degree_operations(deepcopy(elevated), [-1]),
            _spline,
        ),
    ]


def ways() -> list[Way]:
    curve = _curve()
    return _points(curve) + _surfaces() + _operations(curve)
