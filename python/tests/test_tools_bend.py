"""Bends about curves, surfaces and callables, towards axes beside surfaces: against geometry."""

from fractions import Fraction

import numpy as np
import pytest
from symspline import Rational, RationalSurface, Space, Spline, Surface, SymsplineError
from symspline.shape import OffsetAxis, bent, bent_point, bent_share, control_points, cross_ratio

# Pythagorean triples, so that distances are fractions.
TRIPLES = Spline(Space.bezier(2), [[3, 4], [0, 7], [-6, 8]])
WEIGHTED = Rational(Space.bezier(2), [[3, 4], [0, 7], [-6, 8]], [1, 2, 1])
HALF = Fraction(1, 2)


@pytest.mark.parametrize("curve", [TRIPLES, WEIGHTED], ids=["curve", "nurbs"])
@pytest.mark.parametrize("ratio", [1, HALF])
def test_about_a_straight_curve_is_about_a_line(curve, ratio):
    segment = Spline.segment((-10, 2), (10, 2))
    found = bent(curve, [0, 0], ratio, about=segment)
    assert found.is_exact and found == bent(curve, [0, 0], ratio, about=[0, 2], normal=[0, 1])
    for before, after in zip(control_points(curve), control_points(found)):
        t = bent_share(2 / before[1], ratio)
        assert list(after) == [t * x for x in before]
    assert bent(curve, [0, 0], ratio, about=Rational.from_polynomial(segment)) == found


def test_points_come_to_lie_on_the_curve():
    parabola = Spline(Space.bezier(2), [[-4, -3], [0, 5], [4, -3]])
    found = bent(TRIPLES.to_float(), [0.0, -1.0], 1.0, about=parabola)
    for before, after in zip(control_points(TRIPLES), control_points(found)):
        assert after[1] == pytest.approx(1 - after[0] ** 2 / 4, abs=1e-9)
        away = np.array(before, float) + [0, 1]
        assert abs(np.cross(np.append(away, 0), np.append(after + [0, 1], 0))[2]) < 1e-9


def test_about_a_surface():
    line = Space.bezier(1)
    plane = Surface(line, line, [[[-9, -9, 2], [-9, 9, 2]], [[9, -9, 2], [9, 9, 2]]])
    curve = Spline(Space.bezier(2), [[0, 1, 3], [1, 1, 5], [2, 0, 4]])
    found = bent(curve, [0, 0, 0], 2, about=plane)
    expected = bent(curve, [0, 0, 0], 2, about=[0, 0, 2], normal=[0, 0, 1])
    assert not found.is_exact and expected.is_exact
    assert np.allclose(found.coeffs, np.array(expected.coeffs, float), atol=1e-8)


def test_about_what_a_callable_says():
    seen = []

    def round_five(centre, point):
        seen.append((list(centre), list(point)))
        return Fraction(5, {25: 5, 49: 7, 100: 10}[sum(point**2)])

    found = bent(TRIPLES, [0, 0], HALF, about=round_five)
    assert found == bent(TRIPLES, [0, 0], HALF, radius=5)
    assert seen == [([0, 0], list(p)) for p in TRIPLES.coeffs]
    assert found != bent(TRIPLES, [0, 0], HALF, about=lambda o, p: 1)
    wrong = KeyError("mine")

    def refuse(centre, point):
        raise wrong

    with pytest.raises(KeyError) as caught:
        bent(TRIPLES, [0, 0], 1, about=refuse)
    assert caught.value is wrong
    with pytest.raises(TypeError):
        bent(TRIPLES, [0, 0], 1, about=lambda o, p: "far")
    with pytest.raises(SymsplineError) as caught:
        bent(TRIPLES, [0, 0], 1, about=lambda o, p: None)
    assert caught.value.kind == "NoBendPoint"


SQUARE = Space.bezier(2)
# z = x² + y² over the unit square.
BOWL = Surface(SQUARE, SQUARE, [[[i * HALF, j * HALF, (i == 2) + (j == 2)] for j in range(3)] for i in range(3)])


@pytest.mark.parametrize("direction", ["u", "v"])
@pytest.mark.parametrize("rational", [False, True])
def test_the_axis_is_beside_the_isocurve(direction, rational):
    surface = RationalSurface.from_polynomial(BOWL) if rational else BOWL
    axis = OffsetAxis(surface, 0.25, 0.5, direction)

    def point(w):
        x, y = (0.25, w) if direction == "u" else (w, 0.25)
        normal = np.array([-2 * x, -2 * y, 1])
        return np.array([x, y, x * x + y * y]) + 0.5 * normal / np.linalg.norm(normal)

    ws = np.linspace(0, 1, 4001)
    points = np.array([point(w) for w in ws])
    assert np.allclose([axis.point(w) for w in ws[::100]], points[::100], atol=1e-14)
    for away in np.random.default_rng(5).uniform(-1, 2, (20, 3)):
        least = np.linalg.norm(points - away, axis=1).min()
        found = axis.centre_of(away)
        assert np.linalg.norm(found - away) == pytest.approx(least, abs=1e-6)
        assert np.linalg.norm(points - found, axis=1).min() < 1e-3


def test_a_surface_is_bent_towards_an_axis():
    line = Space.bezier(1)
    flat = Surface(line, line, [[[0, 0, 0], [0, 3, 0]], [[4, 0, 0], [4, 3, 0]]])
    axis = OffsetAxis(flat, 0.5, 1.0)
    assert axis.point(0.5) == pytest.approx([2, 1.5, 1])
    fine = flat.elevate("u", 4)
    found = bent(fine, axis, 1, radius=1)
    assert np.allclose(found.coeffs, bent(fine.to_float(), [2, 0, 1], 1, radius=1, axis=[0, 1, 0]).coeffs)
    assert np.allclose(np.hypot(found.coeffs[..., 0] - 2, found.coeffs[..., 2] - 1), 1)
    assert np.allclose(found.coeffs[..., 1], np.array(fine.coeffs[..., 1], float))


def test_shares_and_cross_ratios():
    for s, r in [(Fraction(2, 5), HALF), (Fraction(2, 5), -2), (3, Fraction(9, 10)), (Fraction(1, 3), 7)]:
        t = r * s / (1 + (r - 1) * s)
        assert bent_share(s, r) == t and list(bent_point([1, -2], [5, 6], s, r)) == [1 + 4 * t, -2 + 8 * t]
    assert bent_share(Fraction(2, 5), -1) is None and bent_share(0.4, 0.5) == pytest.approx(0.25)
    a, b, c, d = 0, 6, 2, Fraction(7, 2)
    ratio = Fraction(c - a, c - b) / (Fraction(d - a) / (d - b))
    assert cross_ratio([a, b, c, d]) == ratio
    assert cross_ratio([[1 + x, 2 - 3 * x] for x in (a, b, c, d)]) == ratio
    assert cross_ratio([[1.0, x, 2 * x] for x in (a, b, c, float(d))], 1e-12) == pytest.approx(float(ratio))


def kind_of(make):
    with pytest.raises(SymsplineError) as caught:
        make()
    return caught.value.kind


def test_refusals():
    cube = [[0, 0, 0], [1, 1, 1], [2, 0, 0]]
    curve = Spline(Space.bezier(2), cube)
    assert kind_of(lambda: bent(curve, [0, 0, -1], 1, about=TRIPLES)) == "NoSuch"
    assert kind_of(lambda: bent(TRIPLES, [0, 0], 1, about=BOWL)) == "NoSuch"
    assert kind_of(lambda: bent(curve, [0, 0, -1], 1, about=curve)) == "NoSuch"
    assert kind_of(lambda: bent(Spline.monomial(1), [0], 1, radius=1)) == "NoSuch"
    assert kind_of(lambda: bent(TRIPLES, OffsetAxis(BOWL, 0.5, 1.0), 1, radius=1)) == "NoSuch"
    assert kind_of(lambda: bent(curve, OffsetAxis(BOWL, 0.5, 1.0), 1, radius=1, axis=[0, 0, 1])) == "Word"
    for keywords in ({}, {"about": TRIPLES, "radius": 1}, {"about": [0, 0]}, {"about": TRIPLES, "normal": [0, 1]}, {"about": len, "radius": 5}):
        assert kind_of(lambda keywords=keywords: bent(TRIPLES, [0, 0], 1, **keywords)) == "Word"
    assert kind_of(lambda: OffsetAxis(TRIPLES, 0.5, 1.0)) == "NoSuch"
    assert kind_of(lambda: OffsetAxis(BOWL, 1.5, 1.0)) == "OutsideDomain"
    assert kind_of(lambda: OffsetAxis(BOWL, 0.5, float("nan"))) == "NotFinite"
    assert kind_of(lambda: cross_ratio([1, 2, 3])) == "Shape"
    assert kind_of(lambda: cross_ratio([1, 1, 2, 3])) == "Coincide"
    assert kind_of(lambda: cross_ratio([[0, 0], [1, 0], [2, 1], [3, 0]])) == "NotOnLine"
