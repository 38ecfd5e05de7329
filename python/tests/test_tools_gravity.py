"""Gravity fields and polygons of the parameter plane: against a search over all legs, and over samples."""

from fractions import Fraction

import numpy as np
import pytest
from symspline import Space, Spline, SymsplineError
from symspline.shape import CurveGravity, Gravity, Polygons, warped

LINES = [[[0, 0], [4, 0], [4, 4]], [[1, 3], [-2, 3], [-2, -1], [0, -3]], [[6, 6]]]
GRID = [(Fraction(i, 3), Fraction(j, 2)) for i in range(-9, 21) for j in range(-7, 14)]


def nearest(point):
    """Squared distance, line, place and foot of the nearest place, the first of several."""
    found = []
    for line, corners in enumerate(LINES):
        for leg, (a, b) in enumerate(zip(corners, corners[1:] or corners)):
            (u, v), (x, y) = (point[0] - a[0], point[1] - a[1]), (b[0] - a[0], b[1] - a[1])
            share = min(max(Fraction(u * x + v * y) / (x * x + y * y), Fraction(0)), Fraction(1)) if x or y else Fraction(0)
            foot = (a[0] + share * x, a[1] + share * y)
            found.append(((foot[0] - point[0]) ** 2 + (foot[1] - point[1]) ** 2, line, leg + share, foot))
    return min(found, key=lambda one: one[0])


def test_polylines_pull_what_is_near():
    field = Gravity(LINES, Fraction(3, 2))
    assert field.squared_radius == Fraction(9, 4)
    pulled = 0
    for point in GRID:
        square, line, place, foot = nearest(point)
        found = field.pull(point)
        assert (found is None) == (square > Fraction(9, 4))
        if found is not None:
            pulled += 1
            assert (found.squared_distance, found.line, found.place, tuple(found.foot)) == (square, line, place, foot)
    assert 100 < pulled < len(GRID) - 100


def test_a_float_makes_floats():
    field = Gravity(LINES, 1.5)
    found = field.pull((1, 0.5))
    assert isinstance(found.squared_distance, float) and found.squared_distance == 0.25 and found.place == 0.25
    assert found.foot.dtype == np.float64 and field != Gravity(LINES, Fraction(3, 2))
    # Into the field of the polylines.
    assert Gravity(LINES, 1).pull((1.0, 0.5)).squared_distance == Fraction(1, 4)


def test_curves_pull_what_is_near():
    parabola = Spline(Space.bezier(2), [[0, 0], [1, 2], [2, 0]])
    line = Spline.segment((0, 3), (3, 3))
    field = CurveGravity([parabola, line], 0.75)
    t = np.linspace(0, 1, 20001)
    sampled = [np.stack([2 * t, 4 * t * (1 - t)], 1), np.stack([3 * t, 3 + 0 * t], 1)]
    hits = set()
    for point in np.random.default_rng(3).uniform((-1, -1), (4, 4), (200, 2)):
        distances = [np.linalg.norm(curve - point, axis=1) for curve in sampled]
        least = [d.min() for d in distances]
        found = field.pull(point)
        if abs(min(least) - 0.75) > 1e-3:
            assert (found is None) == (min(least) > 0.75)
        if found is not None:
            hits.add(found.line)
            assert found.line == int(np.argmin(least))
            assert np.sqrt(found.squared_distance) == pytest.approx(min(least), abs=1e-4)
            assert np.allclose(found.foot, (parabola, line)[found.line](found.place), atol=1e-9)
    assert hits == {0, 1}


def test_a_field_warps():
    field = Gravity([[[Fraction(1, 2), 0], [Fraction(1, 2), 1]]], Fraction(1, 4))
    curve = Spline.segment((0, 0), (1, 0)).elevate(2)
    found = warped(curve, 0, 1, lambda _, t: (0, 1) if field.pull((t, Fraction(1, 2))) else None, refine=9)
    heights = {t: height for t, height in zip(found.shape.space.greville, found.shape.coeffs[:, 1])}
    assert {t for t, height in heights.items() if height} == {t for t in heights if abs(t - Fraction(1, 2)) <= Fraction(1, 4)}


def test_polygons_by_the_even_odd_rule():
    star = Polygons([[(0, 3), (-2, -3), (3, 1), (-3, 1), (2, -3)]])
    assert star.contains((0, 2)) and star.contains((0, 1)) and not star.contains((0, 0))
    square, hole = [(0, 0), (6, 0), (6, 6), (0, 6)], [(2, 2), (4, 2), (4, 4), (2, 4)]
    region = Polygons([square, hole])
    for u, v in GRID:
        inside = 0 <= u <= 6 and 0 <= v <= 6 and not (2 < u < 4 and 2 < v < 4)
        assert region.contains((u, v)) == inside
    assert region == Polygons([square, hole]) and region != star
    assert Polygons([np.array(square, float)]).contains((0.1, 5.9))


def kind_of(make):
    with pytest.raises(SymsplineError) as caught:
        make()
    return caught.value.kind


def test_refusals():
    assert kind_of(lambda: Gravity([[]], 1)) == "Shape"
    assert kind_of(lambda: Gravity([np.zeros((0, 2))], 1)) == "TooFewPoints"
    assert kind_of(lambda: Gravity([[[0, 0, 0]]], 1)) == "Shape"
    assert kind_of(lambda: Gravity(LINES, -1)) == "BadTolerance"
    assert kind_of(lambda: Gravity([[[0.0, float("inf")]]], 1)) == "NotFinite"
    assert kind_of(lambda: Gravity(LINES, 1).pull((1, 2, 3))) == "Dimensions"
    assert kind_of(lambda: Gravity(LINES, 1).pull((1, float("nan")))) == "NotFinite"
    assert kind_of(lambda: CurveGravity([Spline.monomial(1)], 1)) == "NoSuch"
    assert kind_of(lambda: CurveGravity([Spline.segment((0, 0), (1, 0))], -1.0)) == "BadTolerance"
    assert kind_of(lambda: Polygons([[(0, 0), (1, 0)]])) == "TooFewPoints"
    assert kind_of(lambda: Polygons([[(0, 0), (1, 0), (0, 1)]]).contains((1,))) == "Dimensions"
