"""Weights moved: against rational curves evaluated by their definition, over fractions."""

import math
from fractions import Fraction

import numpy as np
import pytest
from oracle import value
from symspline import Rational, RationalSurface, Space, Spline, SymsplineError
from symspline.shape import (
    WeightPairPull,
    WeightPull,
    between_nodes,
    cross_ratio,
    halfway_knot,
    halfway_knot_or_copy,
    with_weights,
)

KNOTS = [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4]
SPACE = Space(3, KNOTS)
POINTS = [[0, 0], [1, 2], [3, 3], [5, 3], [7, 2], [8, 0], [9, 1]]
WEIGHTS = [1, 2, 1, 3, 1, 1, 1]
NURBS = Rational(SPACE, POINTS, WEIGHTS)
LINE = Space(2, [0, 0, 0, 1, 2, 2, 2])
NET = [[[i, j, i * j % 3] for j in range(4)] for i in range(4)]
SURFACE = RationalSurface(LINE, LINE, NET, [[1 + (i + j) % 2 for j in range(4)] for i in range(4)])
X = Fraction(7, 5)


def point(weights, x=X):
    """The point of the curve with other weights."""
    above = [value(KNOTS, 3, [w * p[k] for w, p in zip(weights, POINTS)], x) for k in range(2)]
    below = value(KNOTS, 3, weights, x)
    return [a / below for a in above]


def changed(**new):
    return [new.get(f"w{i}", w) for i, w in enumerate(WEIGHTS)]


def test_points_at_fractions_and_weights():
    pull = WeightPull(NURBS, X, 3)
    for weight in [0, 1, 3, Fraction(22, 7)]:
        expected = point(changed(w3=weight))
        assert list(pull.point_at_weight(weight)) == expected
        assert list(pull.point_at(pull.fraction_for(weight))) == expected
    third = point(WEIGHTS)
    assert list(pull.point_at(Fraction(1, 3))) == [(2 * a + b) / 3 for a, b in zip(third, POINTS[3])]
    # The weight is a cross ratio.
    four = [pull.control_point, pull.point_at_weight(0), pull.point_at_weight(1), pull.point]
    assert cross_ratio(np.array(four)) == 3


def test_distances_over_floats():
    pull = WeightPull(NURBS.to_float(), 1.4, 3)
    way = [float(b) - float(a) for a, b in zip(point(WEIGHTS), POINTS[3])]
    assert pull.distance == pytest.approx(math.hypot(*way), rel=1e-13)
    assert pull.fraction_of(-0.25) == pytest.approx(-0.25 / math.hypot(*way), rel=1e-13)
    weight = pull.weight_for_distance(0.5)
    moved = point(changed(w3=Fraction(weight)))
    assert math.dist(list(map(float, moved)), list(map(float, point(WEIGHTS)))) == pytest.approx(0.5, rel=1e-12)
    exact = WeightPull(NURBS, X, 3)
    for refused in (lambda: exact.distance, lambda: exact.fraction_of(1), lambda: exact.weight_for_distance(1)):
        assert kind_of(refused) == "Fields"


def test_a_weight_of_zero_becomes_one():
    # The middle weight is zero, so the curve runs between the ends: t² / ((1 - t)² + t²) from 0 to 2.
    lifted = Rational(Space.bezier(2), homogeneous=[[0, 0, 1], [0, 0, 0], [2, 0, 1]])
    t = Fraction(1, 3)
    at = Fraction(2 * t * t) / ((1 - t) ** 2 + t * t)
    pull = WeightPull.from_zero(lifted, t, 1, [1, 6])
    assert pull.weight == 0 and list(pull.point) == [at, 0] and list(pull.control_point) == [1, 6]
    moved = pull.applied(lifted, Fraction(1, 4))
    assert list(moved(t)) == [at + (1 - at) / 4, Fraction(3, 2)]
    # w 2 t (1 - t) is the share of the point beside the others.
    rest = (1 - t) ** 2 + t * t
    assert pull.weight_for(Fraction(1, 4)) == rest / 3 / (2 * t * (1 - t))
    assert kind_of(lambda: WeightPull.from_zero(NURBS, X, 3, [1, 1])) == "Weight"
    assert kind_of(lambda: WeightPull.from_zero(lifted, t, 1, [1, 6], within=(0, 1))) == "EmptyRange"
    assert kind_of(lambda: WeightPull.from_zero(lifted, t, 1, [1, 6, 2])) == "Dimensions"


def test_two_weights_along_the_line_to_the_leg():
    pull = WeightPairPull.on_leg(NURBS, X, 2)
    assert pull.weights == (1, 3) and pull.shares == WeightPairPull(NURBS, X, 2, 3).shares
    start, base = point(WEIGHTS), point(changed(w2=0, w3=0))
    assert list(pull.point) == start and list(pull.base) == base
    # The goal is on the leg, and on the line from the base through the point.
    (x, y), (a, b), (c, d) = pull.goal, POINTS[2], POINTS[3]
    assert (x - a) * (d - b) == (y - b) * (c - a) and a < x < c
    assert (start[0] - base[0]) * (y - base[1]) == (start[1] - base[1]) * (x - base[0])
    first, second = pull.weights_along(Fraction(1, 4))
    assert second == 3 * first
    assert point(changed(w2=first, w3=second)) == [(3 * p + q) / 4 for p, q in zip(start, pull.goal)]
    tau = sum(pull.shares)
    assert pull.limits == (-tau / (1 - tau), 1)
    assert list(pull.moved_along(NURBS, Fraction(1, 4))(X)) == point(changed(w2=first, w3=second))
    narrow = WeightPairPull.on_leg(NURBS, X, 2, within=(Fraction(1, 2), 6))
    low, high = narrow.limits
    assert narrow.weights_along(low) == (Fraction(1, 2), Fraction(3, 2)) and narrow.weights_along(high) == (2, 6)
    assert kind_of(lambda: narrow.weights_along(high + Fraction(1, 100))) == "WeightOutOfRange"


def test_of_surfaces_and_distances():
    pull = WeightPairPull(SURFACE, (X, 1), (1, 1), (2, 1))
    new = pull.weights_along(Fraction(1, 5))
    moved = with_weights(SURFACE, [((1, 1), new[0]), ((2, 1), new[1])])
    assert list(moved(X, 1)) == [(4 * p + q) / 5 for p, q in zip(SURFACE(X, 1), pull.goal)]
    rounded = WeightPairPull(SURFACE.to_float(), (1.4, 1.0), (1, 1), (2, 1))
    way = math.dist([float(c) for c in pull.point], [float(c) for c in pull.goal])
    assert rounded.distance == pytest.approx(way, rel=1e-13)
    assert rounded.fraction_of(2.0) == pytest.approx(2 / way, rel=1e-13)
    assert kind_of(lambda: pull.distance) == kind_of(lambda: pull.fraction_of(1)) == "Fields"


def test_nodes_halve_legs():
    nodes = SPACE.greville
    for k in range(SPACE.dim - 1):
        assert between_nodes(SPACE, k) == (nodes[k] + nodes[k + 1]) / 2
    # With another copy of the knot at 1/2 two nodes are around 3/4.
    space = Space.clamped(2, [0, Fraction(1, 2), Fraction(3, 2), 2])
    assert kind_of(lambda: halfway_knot(space, Fraction(3, 4))) == "KnotThere"
    knot, regime, leg = halfway_knot_or_copy(space, Fraction(3, 4))
    finer = space.refined([knot]).greville
    assert knot == Fraction(1, 2) and (finer[leg] + finer[leg + 1]) / 2 == Fraction(3, 4)
    assert regime in ("central", "left_gap", "right_gap")
    assert halfway_knot_or_copy(SPACE, between_nodes(SPACE, 3)) == (None, "there", 3)


def kind_of(make):
    with pytest.raises(SymsplineError) as caught:
        make()
    return caught.value.kind


def test_refusals():
    assert kind_of(lambda: WeightPairPull.on_leg(SURFACE, 1, 0)) == "NoSuch"
    assert kind_of(lambda: WeightPairPull.on_leg(Spline(SPACE, POINTS), 1, 0)) == "NoSuch"
    assert kind_of(lambda: WeightPairPull.on_leg(NURBS, X, 6)) == "IndexOutOfRange"
    assert kind_of(lambda: WeightPairPull.on_leg(NURBS, 9, 2)) == "OutsideDomain"
    assert kind_of(lambda: WeightPairPull.on_leg(NURBS, X, 2).weights_along(1)) == "PullTooFar"
    assert kind_of(lambda: WeightPull(NURBS, X, 3).point_at_weight(-100)) == "Pole"
    assert kind_of(lambda: between_nodes(SPACE, 6)) == "IndexOutOfRange"
    assert kind_of(lambda: halfway_knot_or_copy(Space.bezier(1), Fraction(1, 2))) == "DegreeTooLow"
