"""Curvature, zeros, lengths, nearest points, meetings: known answers."""

import math
from fractions import Fraction

import numpy as np
import pytest
from symspline import Rational, Space, Spline, Surface, SymsplineError
from symspline.analysis import (
    ArcLength,
    CurvatureProfile,
    Projector,
    crossings,
    curvature,
    curvature_comb,
    curvature_squared,
    feet,
    frames,
    gaussian_curvature,
    intersections,
    meet_line,
    rotation_minimising_frames,
    surface_curvatures,
    torsion,
    total_curvature,
    turning_angle,
    zeros,
)

BEZIER = Space(2, [0, 0, 0, 1, 1, 1])
# A quarter of the unit circle: fractions all along.
QUARTER = Rational(BEZIER, [[1, 0], [1, 1], [0, 1]], [1, 1, 2])
PARABOLA = Spline(Space(2, [-1, -1, -1, 1, 1, 1]), [[-1, 1], [0, -1], [1, 1]])


def test_a_circle_has_curvature_one():
    squared = curvature_squared(QUARTER)
    assert all(squared(Fraction(k, 7)) == 1 for k in range(8))
    assert np.allclose(curvature(QUARTER, [0.0, 0.3, 1.0]), 1.0)
    profile = CurvatureProfile(QUARTER)
    assert [run[2] for run in profile.runs] == [0]
    low, high = total_curvature(QUARTER)
    assert low <= math.pi / 2 <= high and high - low < 1e-8
    low, high = turning_angle(QUARTER)
    assert low <= math.pi / 2 <= high
    length = ArcLength(QUARTER)
    assert abs(length.total - math.pi / 2) <= length.bound + 1e-15
    assert np.allclose(length.at(length.evenly(4)), np.linspace(0, math.pi / 2, 5))
    assert np.allclose(length.parameter_at([0.0, length.total]), [0, 1])


def test_a_parabola_has_one_vertex():
    profile = CurvatureProfile(PARABOLA)
    (event,) = [event for event in profile.events if event.kind == "maximum"]
    assert event.low == event.high == 0 and event.curvature_before[0] <= 2 <= event.curvature_before[1]
    assert profile.count("maximum") == 1 and profile.trend_on(-1, 0) == 1 and profile.trend_on(0, 1) == -1
    at, kappa, _ = profile.samples
    assert np.allclose(kappa, curvature(PARABOLA, at))
    # A tooth of length 2 * 0.5 at the vertex, on the outer side.
    assert np.allclose(curvature_comb(PARABOLA, [0.0], 0.5), [[0.0, -1.0]])
    with pytest.raises(SymsplineError):
        curvature(PARABOLA, [2.0])


def test_a_jump_has_two_sides():
    # y = x² and, from 0 on, y = 2 x²: the curvature jumps from 2 to 4.
    left = Spline(Space(2, [-1, -1, -1, 0, 0, 0]), [[-1, 1], [Fraction(-1, 2), 0], [0, 0]])
    right = Spline(Space(2, [0, 0, 0, 1, 1, 1]), [[0, 0], [Fraction(1, 2), 0], [1, 2]])
    (jump,) = [event for event in CurvatureProfile(left.join_continuous(right)).events if event.kind == "jump"]
    assert jump.low == 0 and jump.curvature_before[0] <= 2 <= jump.curvature_before[1]
    assert jump.curvature_after[0] <= 4 <= jump.curvature_after[1]


def test_torsion_of_the_cubic():
    cubic = Spline(
        Space(3, [0] * 4 + [1] * 4),
        [[0, 0, 0], [Fraction(1, 3), 0, 0], [Fraction(2, 3), Fraction(1, 3), 0], [1, 1, 1]],
    )
    assert torsion(cubic)(0) == 3
    points, axes = frames(cubic, [0.0, 0.5])
    assert points.shape == (2, 3) and axes.shape == (2, 3, 3)
    assert np.allclose(axes[0], np.eye(3)) and np.allclose(axes[1] @ axes[1].T, np.eye(3))
    _, still = rotation_minimising_frames(cubic, [0.0, 0.01, 0.02])
    assert np.allclose(still[0, 0], [1, 0, 0])


def test_zeros_are_counted():
    # 6 (x - 1/3)(x - 1/2) = 1 - 5 x + 6 x².
    function = Spline(BEZIER, [1, Fraction(-3, 2), 2])
    first, second = zeros(function)
    assert (first.low, second.low) == (Fraction(1, 3), Fraction(1, 2))
    assert (first.before, first.after, second.before, second.after) == (1, -1, -1, 1)
    (twice,) = zeros(Spline(BEZIER, [Fraction(1, 4), Fraction(-1, 4), Fraction(1, 4)]))
    assert twice.multiplicity == 2 and twice.low == Fraction(1, 2)
    (all_along,) = zeros(Spline(BEZIER, [0, 0, 0]))
    assert all_along.along


def test_places_on_curves():
    assert [zero.low for zero in crossings(PARABOLA, [0, 1], Fraction(1, 4))] == [Fraction(-1, 2), Fraction(1, 2)]
    assert [zero.low for zero in meet_line(PARABOLA, [0, 0], [1, 1])] == [0, 1]
    assert 0 in [foot.low for foot in feet(PARABOLA, [0, -1])]
    nearest = Projector(PARABOLA).nearest([0.0, 1.0])
    # t² + (t² - 1)² is least where t² = 1/2.
    assert np.allclose(sorted(foot.parameter for foot in nearest.feet), [-math.sqrt(0.5), math.sqrt(0.5)])
    assert nearest.feet[0].distance == pytest.approx(math.sqrt(0.75)) and nearest.bound <= math.sqrt(0.75)
    found = Projector(PARABOLA).feet([[0.0, -1.0], [0.0, -3.0]])
    assert np.allclose(found[0], 0, atol=1e-6) and np.allclose(found[2], [1, 3])
    assert np.allclose(found[1], [[0, 0], [0, 0]], atol=1e-6)
    parameter, point, _ = Projector(PARABOLA).feet([[0.75, 0.4]])
    assert np.allclose(point, PARABOLA.to_float()(parameter)) and point[0, 0] > 0 and point[0, 1] != point[0, 0]
    assert np.allclose(Projector(PARABOLA).parameters_of([0.5, 0.25]), [0.5])


def test_curves_meet():
    line = Spline(Space(1, [0, 0, 1, 1]), [[-1, Fraction(1, 4)], [1, Fraction(1, 4)]])
    meetings = intersections(PARABOLA, line).meetings
    assert [round(m.parameters[0], 9) for m in meetings] == [-0.5, 0.5]
    assert all(m.is_proved and m.passage == "crosses" for m in meetings)


def test_surfaces():
    line = Space(2, [-1, -1, -1, 1, 1, 1])
    # z = x² + y²: both curvatures are 2 at the origin, and K = 4.
    bowl = Surface(
        line,
        line,
        [[[x, y, (1 if x else -1) + (1 if y else -1)] for y in [-1, 0, 1]] for x in [-1, 0, 1]],
    )
    assert bowl(Fraction(1, 2), Fraction(1, 3))[2] == Fraction(1, 4) + Fraction(1, 9)
    assert gaussian_curvature(bowl, 0, 0) == 4
    found = surface_curvatures(bowl, 0.0, 0.0)
    assert (found.mean, found.greatest, found.least, found.directions) == (2.0, 2.0, 2.0, None)
    (meeting,) = meet_line(bowl, [0, 0, 5], [0, 0, -1]).meetings
    assert meeting.along == pytest.approx(5) and meeting.is_proved
    at, _, distances = Projector(bowl).feet([[0.0, 0.0, -1.0]])
    assert np.allclose(at, [[0, 0]], atol=1e-6) and np.allclose(distances, [1])


def test_zeros_tell_whether_the_sign_changes():
    x = Spline.monomial(1, -1, 1)
    for power in (1, 2, 3, 4):
        (zero,) = zeros(x**power)
        assert zero.changes_sign == (power % 2 == 1) and zero.multiplicity == power
    # At the end of the domain there is nothing on one side.
    (zero,) = zeros(Spline.monomial(1))
    assert zero.before is None and not zero.changes_sign


def test_profiles_are_compared():
    ellipses = [CurvatureProfile(Rational.ellipse([0, 0], [a, 0], [0, 1])) for a in (2, 3)]
    rounded = CurvatureProfile(Rational.ellipse([0, 0], [2, 0], [0, 1]).to_float())
    assert ellipses[0].differs_at(ellipses[1]) is ellipses[0].differs_at(rounded) is rounded.differs_at(ellipses[1]) is None
    kinds = [[event.kind for event in profile.events] for profile in ellipses]
    assert kinds[0] == kinds[1] and len(kinds[0]) >= 4
    other = CurvatureProfile(Spline(Space.bezier(3), [[0, 0], [1, 2], [2, -2], [3, 0]]))
    wanted = [event.kind for event in other.events]
    first = next(i for i, (a, b) in enumerate(zip([*kinds[0], None], [*wanted, None])) if a != b)
    assert ellipses[0].differs_at(other) == other.differs_at(rounded) == first
