"""SciPy: values, derivatives and integrals of splines; it has no elevation, removal, reduction or product."""

import numpy
from scipy import interpolate

import inputs
from questions import Answer, Interpolant, Pieces, Points, Spline, Way

NAME = "SciPy"
SINGLES = 2000


def _spline(s: interpolate.BSpline) -> Spline:
    """SciPy fills coefficients up with zeros that mean nothing."""
    return Spline(s.k, s.t, s.c[: len(s.t) - s.k - 1])


def _curve() -> interpolate.BSpline:
    knots = numpy.array(inputs.clamped(inputs.DEGREE, inputs.SPANS))
    return interpolate.BSpline(knots, numpy.array(inputs.points(inputs.CONTROLS)), inputs.DEGREE)


def _curve_points(curve: interpolate.BSpline) -> list[Way]:
    ways = []
    for order, all_parameters in [("sorted", inputs.sorted_parameters()), ("random", inputs.random_parameters())]:
        few, many = inputs.part(all_parameters, SINGLES), numpy.array(all_parameters)

        def single(xs: list[float] = few) -> list[numpy.ndarray]:
            return [curve(x) for x in xs]

        def batch(xs: numpy.ndarray = many) -> numpy.ndarray:
            return curve(xs)

        def at_few(values: list[numpy.ndarray], xs: list[float] = few) -> Answer:
            return Points(xs, [values])

        def at_many(values: numpy.ndarray, xs: numpy.ndarray = many) -> Answer:
            return Points(xs, [values])

        ways.append(Way(f"curve point, single, {order}", "BSpline.__call__", single, at_few, len(few)))
        ways.append(Way(f"curve point, batch, {order}", "BSpline.__call__", batch, at_many, len(many)))
    return ways


def _derivatives(curve: interpolate.BSpline) -> list[Way]:
    few, many = inputs.part(inputs.random_parameters(), SINGLES), numpy.array(inputs.sorted_parameters())
    return [
        Way(
            "curve point and 2 derivatives, single, random",
            "three calls of BSpline",
            lambda: [[curve(x, order) for order in range(3)] for x in few],
            lambda rows: Points(few, list(zip(*rows, strict=True))),
            len(few),
        ),
        Way(
            "curve point and 2 derivatives, batch, sorted",
            "three calls of BSpline",
            lambda: [curve(many, order) for order in range(3)],
            lambda values: Points(many, values),
            len(many),
        ),
    ]


def _surfaces() -> list[Way]:
    n = inputs.SURFACE_CONTROLS
    knots = numpy.array(inputs.clamped(inputs.DEGREE, inputs.SURFACE_SPANS))
    coeffs = numpy.array(inputs.points(n * n)).reshape(n, n, 3)
    surface = interpolate.NdBSpline((knots, knots), coeffs, inputs.DEGREE)
    axes = [(knots, knots, numpy.ascontiguousarray(coeffs[:, :, axis]).ravel(), 3, 3) for axis in range(3)]
    pairs = numpy.array(inputs.random_pairs())
    few = inputs.part(pairs, SINGLES)
    us, vs = (numpy.array(x) for x in inputs.grid())
    grid = [(u, v) for u in us for v in vs]
    orders = [(0, 0), (1, 0), (0, 1)]
    return [
        Way(
            "surface point, single, random",
            "NdBSpline.__call__",
            lambda: [surface(x) for x in few],
            lambda values: Points(few, [[v.reshape(3) for v in values]]),
            len(few),
        ),
        Way(
            "surface point, batch, random",
            "NdBSpline.__call__",
            lambda: surface(pairs),
            lambda values: Points(pairs, [values]),
            len(pairs),
        ),
        Way(
            "surface grid",
            "bisplev for every coordinate",
            lambda: [interpolate.bisplev(us, vs, tck) for tck in axes],
            lambda values: Points(grid, [numpy.stack(values, axis=-1).reshape(-1, 3)]),
            len(grid),
        ),
        Way(
            "surface point and first derivatives, random",
            "three calls of NdBSpline, in a batch",
            lambda: [surface(pairs, nu=order) for order in orders],
            lambda values: Points(pairs, values),
            len(pairs),
        ),
    ]


def _refined(curve: interpolate.BSpline, knots: list[float]) -> interpolate.BSpline:
    for x in knots:
        curve = curve.insert_knot(x)
    return curve


def _bezier(axes: list[interpolate.BSpline]) -> list[interpolate.BPoly]:
    """`PPoly.from_spline` takes splines with scalar values only."""
    return [interpolate.BPoly.from_power_basis(interpolate.PPoly.from_spline(axis)) for axis in axes]


def _pieces(polys: list[interpolate.BPoly]) -> Answer:
    """`c[j, i]` is control point `j` of piece `i`; pieces between equal knots are empty."""
    controls = numpy.stack([poly.c for poly in polys], axis=-1).transpose(1, 0, 2)
    return Pieces(controls[numpy.diff(polys[0].x) > 0])


def _operations(curve: interpolate.BSpline) -> list[Way]:
    knots = inputs.middles()
    parameters, data = numpy.array(inputs.interpolation_parameters()), numpy.array(inputs.points(inputs.CONTROLS))
    given = numpy.array(inputs.interpolation_knots())
    axes = [interpolate.BSpline(curve.t, numpy.ascontiguousarray(c), curve.k) for c in curve.c.T]
    return [
        Way("refine every span", "BSpline.insert_knot, knot by knot", lambda: _refined(curve, knots), _spline),
        Way("derivative", "BSpline.derivative", curve.derivative, _spline),
        Way("antiderivative", "BSpline.antiderivative", curve.antiderivative, _spline),
        Way(
            "interpolate 1000 points",
            "make_interp_spline with given parameters and knots",
            lambda: interpolate.make_interp_spline(parameters, data, inputs.DEGREE, given),
            lambda s: Interpolant(_spline(s), parameters),
        ),
        Way(
            "Bezier pieces",
            "PPoly.from_spline, BPoly.from_power_basis for every coordinate",
            lambda: _bezier(axes),
            _pieces,
        ),
    ]


def ways() -> list[Way]:
    curve = _curve()
    return _curve_points(curve) + _derivatives(curve) + _surfaces() + _operations(curve)
