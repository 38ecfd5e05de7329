"""Constraints that tie coordinates together: against least squares of numpy and areas by the shoelace formula."""

from fractions import Fraction

import numpy as np
import pytest
from oracle import basis
from symspline import Rational, RationalSurface, Space, Spline, Surface, SymsplineError
from symspline.shape import Constraints, Coupled, control_points, derivative_at

SPACE = Space(3, [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4])
POINTS = [[0, 0], [1, 2], [3, 3], [5, 3], [7, 2], [8, 0], [9, 1]]
WEIGHTS = [1, 2, 1, 3, 1, 1, 1]
LINE = Space(2, [0, 0, 0, 1, 2, 2, 2])
NET = [[[i, j, i * j % 3] for j in range(4)] for i in range(4)]
NET_WEIGHTS = [[1 + (i + j) % 2 for j in range(4)] for i in range(4)]
X, Y = Fraction(7, 5), Fraction(5, 2)
CURVE, SURFACE = Spline(SPACE, POINTS), Surface(LINE, LINE, NET)
SHAPES = [
    (CURVE, X, Y, [2, 1]),
    (Rational(SPACE, POINTS, WEIGHTS), X, Y, [2, 1]),
    (SURFACE, (X, 1), (1, Fraction(1, 2)), [2, 1, -1]),
    (RationalSurface(LINE, LINE, NET, NET_WEIGHTS), (X, 1), (1, Fraction(1, 2)), [2, 1, -1]),
]
KINDS = pytest.mark.parametrize(("shape", "x", "y", "n"), SHAPES, ids=["curve", "nurbs", "surface", "nurbs surface"])


def value(shape, at):
    return shape(*at) if isinstance(at, tuple) else shape(at)


def shares(shape, at):
    """The share of each control point in the point at a place."""
    if isinstance(at, tuple):
        u, v = ([basis(list(s.knots), s.degree, i, x) for i in range(s.dim)] for s, x in zip((shape.u, shape.v), at))
        row = np.array([a * b for a in u for b in v])
    else:
        row = np.array([basis(list(shape.space.knots), shape.space.degree, i, at) for i in range(shape.space.dim)])
    if isinstance(shape, (Rational, RationalSurface)):
        row = row * np.array(shape.weights).ravel()
    return row / sum(row)


@KINDS
@pytest.mark.parametrize("exact", [True, False])
def test_a_point_slides_along_a_line_with_the_least_movement(shape, x, y, n, exact):
    shape = shape if exact else shape.to_float()
    held = Coupled(shape, [(y, 0 if not isinstance(y, tuple) else (0, 0))], [("along", x, 0 if not isinstance(x, tuple) else (0, 0), n)])
    moved = held.dragged(shape, [[0] * len(n)], [3])
    before, after = value(shape, x), value(moved, x)
    assert shape.is_exact == moved.is_exact == exact
    if exact:
        assert sum((after - before) * np.array(n)) == 3 and list(value(moved, y)) == list(value(shape, y))
    rows = [np.kron(np.array(shares(shape, y), float), axis) for axis in np.eye(len(n))]
    rows.append(np.kron(np.array(shares(shape, x), float), np.array(n, float)))
    least = np.linalg.pinv(np.array(rows)) @ np.array([0.0] * len(n) + [3.0])
    found = np.array(control_points(moved) - control_points(shape), float).ravel()
    assert np.allclose(found, least, atol=1e-12)


def test_components_are_functionals_of_coordinates():
    # y of control point 2 less x of control point 5 grows by 4, with the price of the latter 9 times as high: (18/5, -2/5).
    row = {2 * 2 + 1: 1, 5 * 2: -1}
    moved = Coupled(CURVE, [], [row], weights=[(5, 9)]).dragged(CURVE, [], [4])
    change = control_points(moved) - control_points(CURVE)
    assert change[2, 1] == Fraction(18, 5) and change[5, 0] == Fraction(-2, 5)
    assert np.count_nonzero(change) == 2
    held = Coupled(CURVE, [], [row], holding=[5]).dragged(CURVE, [], [4])
    assert (control_points(held) - control_points(CURVE)).ravel()[5] == 4


def test_derivatives_are_tied():
    held = Coupled(CURVE, [], [("along", X, 1, [0, 1]), ("along", X, 2, [1, 1])])
    moved = held.dragged(CURVE, [], [1, -2])
    first, second = (derivative_at(moved, X, k) - derivative_at(CURVE, X, k) for k in (1, 2))
    assert first[1] == 1 and sum(second) == -2


def shoelace(points):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(points, points[1:])) / Fraction(2)


def test_the_area_grows_to_first_order():
    corners = [[1, 0], [3, 1], [2, 4], [-1, 3], [-2, 0]]
    polygon = Spline(Space.clamped(1, range(5)), corners)
    held = Coupled(polygon, [(0, 0), (4, 0)], ["area"])
    moved = held.dragged(polygon, [[0, 0], [0, 0]], [Fraction(1, 3)])
    change = moved.coeffs - polygon.coeffs
    # The area is a quadratic form of the corners.
    assert shoelace(moved.coeffs) - shoelace(corners) - shoelace(change) == Fraction(1, 3)
    assert list(moved.coeffs[0]) == corners[0] and list(moved.coeffs[4]) == corners[4]
    rounded = Coupled(polygon, [(0, 0), (4, 0)], ["area"]).dragged(polygon.to_float(), [[0, 0], [0, 0]], [1 / 3])
    assert np.allclose(np.array(rounded.coeffs, float), np.array(moved.coeffs, float), atol=1e-15)


@pytest.mark.parametrize("shape", [SURFACE, SHAPES[3][0]], ids=["surface", "nurbs surface"])
@pytest.mark.parametrize("direction", ["u", "v"])
def test_isocurves_are_met(shape, direction):
    held = Constraints(shape, [("isocurve", direction, X), ("isocurve", direction, 0)])
    edge = shape.isocurve(direction, 0)
    wanted = [[k, 7 - k, k * k] for k in range(4)]
    moved = held.met(shape, wanted + control_points(edge).tolist())
    assert moved.is_exact and moved.isocurve(direction, 0) == edge
    assert control_points(moved.isocurve(direction, X)).tolist() == wanted


def test_points_along_a_path_are_moved():
    path = Spline(Space.bezier(2), [[0, 1], [1, 0], [2, 2]])
    held = Constraints(SURFACE, [("along", path, 3), ((0, 0), (0, 0))])
    moved = held.dragged(SURFACE, [[0, 0, 1], [0, 2, 0], [3, 0, 0], [0, 0, 0]])
    for t, by in zip((0, Fraction(1, 2), 1), ([0, 0, 1], [0, 2, 0], [3, 0, 0])):
        place = path(t)
        assert list(moved(*place) - SURFACE(*place)) == by
    assert list(moved(0, 0)) == list(SURFACE(0, 0))
    # A float anywhere makes floats.
    assert not Constraints(SURFACE, [("along", path.to_float(), 3)]).shape.is_exact
    for constraint in (("isocurve", "u", 0), ("along", path, 2)):
        assert kind_of(lambda constraint=constraint: Constraints(CURVE, [constraint])) == "NoSuch"
    assert kind_of(lambda: Constraints(SURFACE, [("along", Spline.monomial(1), 2)])) == "NoSuch"
    assert kind_of(lambda: Constraints(SURFACE, [("along", path, 0)])) == "TooFewPoints"
    assert kind_of(lambda: Constraints(SURFACE, [("isocurve", "u", 3)])) == "OutsideDomain"
    with pytest.raises(TypeError):
        Constraints(SURFACE, [("isoline", "u", 1)])


def kind_of(make):
    with pytest.raises(SymsplineError) as caught:
        make()
    return caught.value.kind


def test_refusals():
    assert kind_of(lambda: Coupled(CURVE, [], [("across", X, 0, [1, 0])])) == "Word"
    assert kind_of(lambda: Coupled(CURVE, [], ["volume"])) == "Word"
    assert kind_of(lambda: Coupled(SURFACE, [], ["area"])) == "NoSuch"
    assert kind_of(lambda: Coupled(Rational(SPACE, POINTS, WEIGHTS), [], ["area"])) == "NoSuch"
    assert kind_of(lambda: Coupled(Spline.monomial(2), [], [{0: 1}])) == "NoSuch"
    assert kind_of(lambda: Coupled(CURVE, [], [("along", X, 0, [1, 0, 0])])) == "Dimensions"
    assert kind_of(lambda: Coupled(CURVE, [], [("along", 5, 0, [1, 0])])) == "OutsideDomain"
    assert kind_of(lambda: Coupled(CURVE, [], [{14: 1}])) == "IndexOutOfRange"
    held = Coupled(CURVE, [(X, 0)], [{0: 1}])
    assert kind_of(lambda: held.dragged(CURVE, [], [1])) == "CoefficientCount"
    assert kind_of(lambda: held.dragged(CURVE, [[0, 0]], [1, 2])) == "CoefficientCount"
    assert kind_of(lambda: held.dragged(SURFACE, [[0, 0]], [1])) == "NoSuch"
