"""Splipy: operators are matrices, mostly dense; it has no removal, antiderivative or product."""

import numpy
from splipy import BSplineBasis, Curve, Surface, curve_factory

import inputs
from questions import Answer, Interpolant, Pieces, Points, Spline, Way, elevated_curve

NAME = "Splipy"
SINGLES = 500


def _basis(knots: list[float]) -> BSplineBasis:
    return BSplineBasis(inputs.DEGREE + 1, knots)


def _curve() -> Curve:
    points = numpy.array(inputs.points(inputs.CONTROLS))
    return Curve(_basis(inputs.clamped(inputs.DEGREE, inputs.SPANS)), points)


def _spline(curve: Curve) -> Spline:
    return Spline(curve.order(0) - 1, curve.knots(0, with_multiplicities=True), curve.controlpoints)


def _points(curve: Curve) -> list[Way]:
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

        ways.append(Way(f"curve point, single, {order}", "Curve.evaluate", single, at_few, len(few)))
        ways.append(Way(f"curve point, batch, {order}", "Curve.evaluate", batch, at_many, len(many)))
    return ways


def _derivatives(curve: Curve) -> list[Way]:
    few = inputs.part(inputs.random_parameters(), SINGLES)
    many = numpy.array(inputs.part(inputs.sorted_parameters(), 10 * SINGLES))
    return [
        Way(
            "curve point and 2 derivatives, single, random",
            "Curve.evaluate, Curve.derivative twice",
            lambda: [[curve(x), curve.derivative(x), curve.derivative(x, d=2)] for x in few],
            lambda rows: Points(few, list(zip(*rows, strict=True))),
            len(few),
        ),
        Way(
            "curve point and 2 derivatives, batch, sorted",
            "Curve.evaluate, Curve.derivative twice, 5000 points",
            lambda: [curve(many), curve.derivative(many), curve.derivative(many, d=2)],
            lambda values: Points(many, values),
            len(many),
        ),
    ]


def _surfaces() -> list[Way]:
    n, basis = inputs.SURFACE_CONTROLS, _basis(inputs.clamped(inputs.DEGREE, inputs.SURFACE_SPANS))
    surface = Surface(basis, basis, numpy.array(inputs.points(n * n)).reshape(n, n, 3), raw=True)
    pairs = numpy.array(inputs.part(inputs.random_pairs(), 10 * SINGLES))
    few, (xs, ys) = inputs.part(pairs, SINGLES), pairs.T
    us, vs = (numpy.array(x) for x in inputs.grid())
    grid = [(u, v) for u in us for v in vs]

    def tangents() -> list[numpy.ndarray]:
        along = [surface.derivative(xs, ys, d=d, tensor=False) for d in [(1, 0), (0, 1)]]
        return [surface(xs, ys, tensor=False), *along]

    return [
        Way(
            "surface point, single, random",
            "Surface.evaluate",
            lambda: [surface(u, v) for u, v in few],
            lambda values: Points(few, [values]),
            len(few),
        ),
        Way(
            "surface point, batch, random",
            "Surface.evaluate, 5000 points",
            lambda: surface(xs, ys, tensor=False),
            lambda values: Points(pairs, [values]),
            len(pairs),
        ),
        Way(
            "surface grid",
            "Surface.evaluate",
            lambda: surface(us, vs),
            lambda values: Points(grid, [values.reshape(-1, 3)]),
            len(grid),
        ),
        Way(
            "surface point and first derivatives, random",
            "Surface.evaluate, Surface.derivative twice, 5000 points",
            tangents,
            lambda values: Points(pairs, values),
            len(pairs),
        ),
    ]


def _elevated(curve: Curve) -> Curve:
    return curve.clone().raise_order(1)


def _operations(curve: Curve) -> list[Way]:
    knots, inner = inputs.middles(), inputs.breaks(inputs.SPANS)[1:-1]
    high = elevated_curve()
    elevated = Curve(BSplineBasis(high.degree + 1, high.knots), numpy.array(high.coeffs))
    parameters, data = inputs.interpolation_parameters(), numpy.array(inputs.points(inputs.CONTROLS))
    basis = _basis(inputs.interpolation_knots())
    return [
        Way("refine every span", "Curve.insert_knot on a copy", lambda: curve.clone().insert_knot(knots), _spline),
        Way("elevate by one", "Curve.raise_order on a copy", lambda: _elevated(curve), _spline),
        Way("reduce an elevated curve", "Curve.lower_order", lambda: elevated.lower_order(1), _spline),
        Way("derivative", "Curve.get_derivative_curve", curve.get_derivative_curve, _spline),
        Way(
            "interpolate 1000 points",
            "curve_factory.interpolate with given parameters and knots",
            lambda: curve_factory.interpolate(data, basis, parameters),
            lambda c: Interpolant(_spline(c), parameters),
        ),
        Way(
            "Bezier pieces",
            "Curve.split at all knots",
            lambda: curve.split(inner),
            lambda pieces: Pieces([piece.controlpoints for piece in pieces]),
        ),
    ]


def ways() -> list[Way]:
    curve = _curve()
    return _points(curve) + _derivatives(curve) + _surfaces() + _operations(curve)
