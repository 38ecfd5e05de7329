"""splinepy, bindings of the C++ library SplineLib: batches go through one call; no derivative or product of splines."""

import numpy
import splinepy
from splinepy.helpme import fit

import inputs
from questions import Answer, Interpolant, Pieces, Points, Spline, Way, elevated_curve, refined_curve

NAME = "splinepy"
SINGLES = 2000
TOLERANCE = 1e-9


def _curve(spline: Spline | None = None) -> splinepy.BSpline:
    knots = inputs.clamped(inputs.DEGREE, inputs.SPANS)
    spline = spline or Spline(inputs.DEGREE, knots, inputs.points(inputs.CONTROLS))
    return splinepy.BSpline([spline.degree], [spline.knots], spline.coeffs)


def _surface() -> splinepy.BSpline:
    """The first index of its control points runs fastest."""
    n, knots = inputs.SURFACE_CONTROLS, inputs.clamped(inputs.DEGREE, inputs.SURFACE_SPANS)
    points = numpy.array(inputs.points(n * n)).reshape(n, n, 3).transpose(1, 0, 2).reshape(-1, 3)
    return splinepy.BSpline([inputs.DEGREE] * 2, [knots, knots], points)


def _spline(curve: splinepy.BSpline) -> Spline:
    return Spline(int(curve.degrees[0]), list(curve.knot_vectors[0]), numpy.array(curve.control_points))


def _point_ways(question: str, how: str, spline: splinepy.BSpline, single: bool, queries: list) -> Way:
    if single:
        xs = numpy.array(inputs.part(queries, SINGLES)).reshape(-1, 1, spline.para_dim)
        return Way(
            question,
            how,
            lambda: [spline.evaluate(x) for x in xs],
            lambda values: Points(inputs.part(queries, SINGLES), [[v[0] for v in values]]),
            len(xs),
        )
    xs = numpy.array(queries).reshape(-1, spline.para_dim)
    return Way(question, how, lambda: spline.evaluate(xs), lambda values: Points(queries, [values]), len(xs))


def _points(curve: splinepy.BSpline, surface: splinepy.BSpline) -> list[Way]:
    us, vs = inputs.grid()
    grid = [(u, v) for u in us for v in vs]
    parameters = {"sorted": inputs.sorted_parameters(), "random": inputs.random_parameters()}
    how = "BSpline.evaluate"
    return [
        *(_point_ways(f"curve point, single, {o}", how, curve, True, xs) for o, xs in parameters.items()),
        *(_point_ways(f"curve point, batch, {o}", how, curve, False, xs) for o, xs in parameters.items()),
        _point_ways("surface point, single, random", how, surface, True, inputs.random_pairs()),
        _point_ways("surface point, batch, random", how, surface, False, inputs.random_pairs()),
        _point_ways("surface grid", "BSpline.evaluate, point by point", surface, False, grid),
    ]


def _derivatives(curve: splinepy.BSpline, surface: splinepy.BSpline) -> list[Way]:
    few, many = inputs.part(inputs.random_parameters(), SINGLES), inputs.sorted_parameters()
    singles, queries = numpy.array(few).reshape(-1, 1, 1), numpy.array(many).reshape(-1, 1)
    pairs = numpy.array(inputs.random_pairs())
    orders, partials = [[0], [1], [2]], [[0, 0], [1, 0], [0, 1]]

    def by_order(values: numpy.ndarray) -> list[numpy.ndarray]:
        return list(values.transpose(1, 0, 2))

    return [
        Way(
            "curve point and 2 derivatives, single, random",
            "BSpline.derivative for orders 0, 1, 2",
            lambda: [curve.derivative(x, orders) for x in singles],
            lambda rows: Points(few, by_order(numpy.concatenate(rows))),
            len(few),
        ),
        Way(
            "curve point and 2 derivatives, batch, sorted",
            "BSpline.derivative for orders 0, 1, 2",
            lambda: curve.derivative(queries, orders),
            lambda values: Points(many, by_order(values)),
            len(many),
        ),
        Way(
            "surface point and first derivatives, random",
            "BSpline.derivative for three orders, in a batch",
            lambda: surface.derivative(pairs, partials),
            lambda values: Points(pairs, by_order(values)),
            len(pairs),
        ),
    ]


def _changed(curve: splinepy.BSpline, method: str, *arguments: object) -> splinepy.BSpline:
    result = curve.copy(saved_data=False)
    getattr(result, method)(*arguments)
    return result


def _thinned(fine: splinepy.BSpline, knots: list[float]) -> tuple[splinepy.BSpline, object]:
    """With the array of control points: version 0.2.1 frees it while the result still needs it."""
    result = fine.copy(saved_data=False)
    held = result.control_points
    result.remove_knots(0, knots, TOLERANCE)
    return result, held


def _operations(curve: splinepy.BSpline) -> list[Way]:
    knots = inputs.middles()
    fine, elevated = _curve(refined_curve()), _curve(elevated_curve())
    parameters, data = inputs.interpolation_parameters(), numpy.array(inputs.points(inputs.CONTROLS))
    queries = numpy.array(parameters).reshape(-1, 1)
    template = _curve(Spline(inputs.DEGREE, inputs.interpolation_knots(), inputs.points(inputs.CONTROLS)))

    def fitted() -> splinepy.BSpline:
        return fit.curve(data, fitting_spline=template, associated_queries=queries)[0]

    def pieces(patches: list) -> Answer:
        return Pieces([numpy.array(patch.control_points) for patch in patches])

    return [
        Way(
            "refine every span",
            "BSpline.insert_knots on a copy",
            lambda: _changed(curve, "insert_knots", 0, knots),
            _spline,
        ),
        Way(
            "elevate by one",
            "BSpline.elevate_degrees on a copy",
            lambda: _changed(curve, "elevate_degrees", [0]),
            _spline,
        ),
        Way(
            "remove inserted knots",
            "BSpline.remove_knots on a copy, control points kept alive",
            lambda: _thinned(fine, knots),
            lambda found: _spline(found[0]),
        ),
        Way(
            "reduce an elevated curve",
            "BSpline.reduce_degrees on a copy",
            lambda: _changed(elevated, "reduce_degrees", [0], TOLERANCE),
            _spline,
        ),
        Way(
            "interpolate 1000 points",
            "helpme.fit.curve with given parameters and knots",
            fitted,
            lambda c: Interpolant(_spline(c), parameters),
        ),
        Way("Bezier pieces", "BSpline.extract_bezier_patches", lambda: curve.extract.beziers(), pieces),
    ]


def ways() -> list[Way]:
    curve, surface = _curve(), _surface()
    return _points(curve, surface) + _derivatives(curve, surface) + _operations(curve)
