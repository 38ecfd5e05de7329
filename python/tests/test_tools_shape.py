"""Shape tools: what each promises, over fractions with `==`."""

from fractions import Fraction

import numpy as np
import pytest
from symspline import Rational, RationalSurface, Space, Spline, Surface, SymsplineError
from symspline.analysis import curvature, curvature_squared
from symspline.shape import (
    Constraints,
    CurvatureHandle,
    Drag,
    WeightPull,
    bent,
    bump,
    confined,
    control_points,
    derivative_at,
    flattened,
    warped,
    with_tangent,
    with_weights,
)

SPACE = Space(3, [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4])
POINTS = [[0, 0], [1, 2], [3, 3], [5, 3], [7, 2], [8, 0], [9, 1]]
CURVE = Spline(SPACE, POINTS)
NURBS = Rational(SPACE, POINTS, [1, 2, 1, 3, 1, 1, 1])
LINE = Space(2, [0, 0, 0, 1, 2, 2, 2])
NET = [[[i, j, i * j % 3] for j in range(4)] for i in range(4)]
SURFACE = Surface(LINE, LINE, NET)
NURBS_SURFACE = RationalSurface(LINE, LINE, NET, [[1 + (i + j) % 2 for j in range(4)] for i in range(4)])
X = Fraction(7, 5)
SHAPES = [(CURVE, X, [1, 2]), (NURBS, X, [1, 2]), (SURFACE, (X, 1), [1, 2, 3]), (NURBS_SURFACE, (X, 1), [1, 2, 3])]
KINDS = pytest.mark.parametrize(("shape", "at", "by"), SHAPES, ids=["curve", "nurbs", "surface", "nurbs surface"])


def value(shape, at):
    return shape(*at) if isinstance(at, tuple) else shape(at)


@KINDS
@pytest.mark.parametrize("how", ["nearest", "neighbours"])
def test_a_point_moves_by_exactly_this_vector(shape, at, by, how):
    moved = Drag(shape, at, how).applied(shape, by)
    assert list(value(moved, at)) == list(value(shape, at) + np.array(by))
    assert control_points(moved).shape == control_points(shape).shape


def test_a_float_makes_floats():
    assert control_points(Drag(CURVE, 1.4).applied(CURVE, [1, 2])).dtype == np.float64
    assert control_points(Drag(CURVE, X).applied(CURVE, [1, 2])).dtype == object


def test_a_control_point_is_confined():
    finer, k = confined(NURBS, X, Fraction(1, 2), Fraction(5, 2))
    pulled = Drag(finer, X, index=k).applied(finer, [0, 1])
    assert list(pulled(X)) == list(NURBS(X) + np.array([0, 1]))
    for x in [0, Fraction(1, 3), Fraction(1, 2), Fraction(5, 2), 3, 4]:
        assert list(pulled(x)) == list(NURBS(x))


def test_a_weight_pulls_a_third_of_the_way():
    pull = WeightPull(NURBS, X, 3)
    nearer = pull.applied(NURBS, Fraction(1, 3))
    assert list(3 * nearer(X)) == list(2 * NURBS(X) + np.array(POINTS[3]))
    assert nearer == with_weights(NURBS, [(3, pull.weight_for(Fraction(1, 3)))])
    with pytest.raises(SymsplineError):
        WeightPull(NURBS, X, 3, within=(1, 4)).applied(NURBS, Fraction(99, 100))
    with pytest.raises(SymsplineError) as caught:
        WeightPull(CURVE, X, 3)
    assert caught.value.kind == "NoSuch"


@KINDS
def test_constraints_hold(shape, at, by):
    is_curve = not isinstance(at, tuple)
    first, zero = (1, [0] * 2) if is_curve else ((1, 0), [0] * 3)
    held = Constraints(shape, [(at, 0 if is_curve else (0, 0)), (at, first)])
    turned = held.dragged(shape, [zero, by])
    assert list(value(turned, at)) == list(value(shape, at))
    assert list(derivative_at(turned, at, first)) == list(derivative_at(shape, at, first) + np.array(by))
    back = held.met(turned, [value(shape, at), derivative_at(shape, at, first)])
    assert back == shape


def test_constraints_move_as_little_as_possible():
    held = Constraints(CURVE, [(X, 0), (X, 1)])
    rows = np.array(held.rows, float)
    moved = held.dragged(CURVE, [[1, 0], [0, 1]])
    expected = np.linalg.pinv(rows) @ np.array([[1, 0], [0, 1]])
    assert np.allclose(np.array(moved.coeffs - CURVE.coeffs, float), expected, atol=1e-12)
    freer = Constraints(CURVE, [(X, 0)], holding=[2], weights=[(1, 5)]).dragged(CURVE, [[1, 0]])
    assert list(freer.coeffs[2]) == POINTS[2] and list(freer(X)) == list(CURVE(X) + np.array([1, 0]))


def test_functionals_are_constrained():
    held = Constraints(CURVE, [{0: -1, 6: 1}])
    moved = held.met(CURVE, [[12, 0]])
    assert list(moved.coeffs[6] - moved.coeffs[0]) == [12, 0]


def test_the_curvature_is_multiplied():
    handle = CurvatureHandle(CURVE, X)
    bentmore = handle.scaled(CURVE, 2)
    assert list(bentmore(X)) == list(CURVE(X))
    assert curvature_squared(bentmore)(X) == 4 * curvature_squared(CURVE)(X)
    slid = handle.slid(CURVE, 3)
    assert curvature_squared(slid)(X) == curvature_squared(CURVE)(X)
    rounded = Spline(SPACE, np.array(POINTS, float))
    assert curvature(CurvatureHandle(rounded, 1.4).set(rounded, 0.25), [1.4])[0] == pytest.approx(0.25)


def test_a_tangent_turns():
    turned = with_tangent(CURVE, X, [1, 1])
    dx, dy = derivative_at(turned, X, 1)
    assert dx == dy and list(turned(X)) == list(CURVE(X))


@pytest.mark.parametrize("shape", [CURVE, NURBS])
def test_a_warp_changes_nothing_outside(shape):
    found = warped(shape, 1, 3, lambda share, _: bump(4, share), vector=[0, 2], refine=10)
    assert found.moved > 0 and len(found.inserted) >= 10
    for x in [0, Fraction(1, 2), 1, 3, Fraction(7, 2), 4]:
        assert list(found.shape(x)) == list(shape(x))
    assert list(found.shape(2)) != list(shape(2))


def test_a_surface_is_warped():
    found = warped(SURFACE, (0, 0), (2, 2), lambda share, _: [0, 0, share[0] * share[1]], refine=(4, 4))
    assert found.moved > 0 and list(found.shape(0, 0)) == list(SURFACE(0, 0))
    assert control_points(found.shape).dtype == object


def test_exceptions_of_callables_come_out_as_they_are():
    wrong = KeyError("mine")

    def refuse(share, parameter):
        raise wrong

    with pytest.raises(KeyError) as caught:
        warped(CURVE, 0, 4, refuse)
    assert caught.value is wrong
    with pytest.raises(TypeError):
        warped(CURVE, 0, 4, lambda share, _: "far")
    with pytest.raises(SymsplineError):
        warped(CURVE, 0, 4, lambda share, _: [1, 2, 3])
    assert warped(CURVE, 0, 4, lambda share, _: None).shape == CURVE


def test_a_part_becomes_straight():
    found = flattened(CURVE, [0, 2], line=[1, 0], side="positive", refine=10)
    ((start, end),) = found.flat[0]
    for k in range(9):
        assert found.shape(start + (end - start) * Fraction(k, 8))[1] == 2
    assert list(found.shape(0)) == list(CURVE(0)) and found.projected
    local = flattened(CURVE, [0, 2], line=[1, 0], local=(0, 2), refine=6).shape
    assert [list(local(x)) for x in [2, 3, 4]] == [list(CURVE(x)) for x in [2, 3, 4]]
    plane = flattened(SURFACE, [0, 0, 1], normal=[0, 0, 1]).shape
    assert all(plane(u, v)[2] == 1 for u in [0, 1, 2] for v in [0, 1, 2])


def test_a_bend_with_ratio_one_goes_onto_the_circle():
    # Pythagorean triples, so that distances are fractions.
    curve = Spline(Space(2, [0, 0, 0, 1, 1, 1]), [[3, 4], [0, 7], [-6, 8]])
    round_one = bent(curve, [0, 0], 1, radius=5)
    assert all(sum(p**2) == 25 for p in round_one.coeffs)
    line = bent(curve, [0, 0], 1, about=[0, 2], normal=[0, 1])
    assert all(p[1] == 2 for p in line.coeffs)
    rounded = bent(CURVE, [4.5, -6.0], 2.0, radius=6.0, interval=(1.0, 3.0), refine=10)
    assert len(control_points(rounded)) > 7
    with pytest.raises(SymsplineError):
        bent(CURVE, [0, -1], 2, radius=6)
