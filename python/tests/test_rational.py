"""Rational functions and curves."""

import math
import pickle
from fractions import Fraction

import numpy as np
import oracle
import pytest
from hypothesis import given
from hypothesis import strategies as st
from strategies import places, spaces, splines
from symspline import Rational, Space, Spline, SymsplineError

HALF = Fraction(1, 2)
weights = st.fractions(min_value=Fraction(1, 4), max_value=8, max_denominator=6)


@st.composite
def rationals(draw, dim=2):
    points = draw(splines(dim=dim, jumps=False, least=1, most=3))
    n = points.space.dim
    return Rational(points.space, points.coeffs, draw(st.lists(weights, min_size=n, max_size=n)))


@given(rationals(), places)
def test_values_are_quotients_by_the_definition(f, x):
    w, points, knots = f.weights, f.points, f.space.knots.tolist()
    below = oracle.value(knots, f.degree, w, x)
    above = [oracle.value(knots, f.degree, list(w * column), x) for column in points.T]
    assert f(x).tolist() == [a / below for a in above]
    assert f.denominator(x) == below and f.numerator(x).tolist() == above


@given(rationals(), rationals(), places)
def test_signs_and_operators(f, g, x):
    a, b = f(x), g(x)
    assert (f + g)(x).tolist() == (a + b).tolist() and (f - g)(x).tolist() == (a - b).tolist()
    assert (f @ g)(x) == a @ b and f.cross(g)(x) == a[0] * b[1] - a[1] * b[0]
    assert (f + (1, 2))(x).tolist() == [a[0] + 1, a[1] + 2] and (3 * f)(x).tolist() == (3 * a).tolist()
    assert (f * f.coordinate(0))(x).tolist() == (a * a[0]).tolist()
    assert (np.array([[1, 2]], dtype=object) @ f)(x) == a[0] + 2 * a[1]
    for same in (f.elevate(), f.embedded(f.space.bisected()), f.clamped_ends(), f.reversed().reversed()):
        assert same(x).tolist() == a.tolist() and f.same_function(same)
    assert f.moebius(0, 1, 1).same_function(f)
    assert f.derivative()(x).tolist() == f.derivatives_at(x, 1)[1].tolist()
    if 0 < x < 1:
        left, right = f.split(x)
        assert left.same_function(f.restricted(0, x)) and right(x).tolist() == a.tolist()


@given(rationals())
def test_nothing_is_lost(f):
    for g in (f, f.to_float()):
        assert pickle.loads(pickle.dumps(g)) == g
        assert Rational(g.space, homogeneous=g.homogeneous) == g
    assert Rational(f.space, f.points, f.weights) == f


def test_a_weight_of_zero():
    half = Rational(Space.bezier(2), homogeneous=[[1, 0, 1], [0, 1, 0], [-1, 0, 1]])
    assert half(HALF).tolist() == [0, 1] and pickle.loads(pickle.dumps(half)) == half
    with pytest.raises(SymsplineError):
        half.points


def test_conics_are_on_their_curves():
    circle = Rational.circle((1, 2), 5)
    for x in (Fraction(k, 31) for k in range(32)):
        p = circle(x) - np.array([1, 2], dtype=object)
        assert p @ p == 25
    arc = Rational.arc((0, 0), (5, 0), (-3, -4))
    assert arc(1).tolist() == [-3, -4] and arc(Fraction(9, 10)) @ arc(Fraction(9, 10)) == 25
    turn = Rational.arc_by_angles((1, 0), 2, 0, -math.pi)
    assert np.allclose(turn(0.5), [1, -2])
    ellipse = Rational.ellipse((0, 0, 0), (2, 0, 0), (0, 1, 1))
    x, y, z = ellipse(Fraction(1, 7))
    assert x * x / 4 + y * y == 1 and y == z
    assert Rational.conic([[0, 0], [1, 1], [2, 0]], [1, 1, 1]).same_function(
        Rational.from_polynomial(Spline(Space.bezier(2), [[0, 0], [1, 1], [2, 0]]))
    )
    assert not Rational.circle((0.5, 0), 1).is_exact and not Rational.circle((1, 0), 0.5).is_exact


def test_splipy_evaluates_alike():
    splipy = oracle.splipy()
    circle = Rational.circle((0.0, 0.0), 1.0)
    controls = np.asarray(circle.homogeneous)
    other = splipy.Curve(splipy.BSplineBasis(3, circle.space.knots), controls, rational=True, raw=True)
    xs = np.linspace(0, 1, 21)
    assert np.allclose(circle(xs), other.evaluate(xs), atol=1e-14)
    inner = xs[1:-1] + 0.003
    assert np.allclose(circle.derivatives_at(inner, 1)[:, 1], other.derivative(inner), atol=1e-12)


def test_long_arrays():
    circle = Rational.circle((0.0, 0.0), 1.0)
    values = circle(np.linspace(0, 1, 20_000))
    assert values.shape == (20_000, 2) and np.allclose(np.hypot(*values.T), 1, atol=1e-14)


def test_polynomials_near_by():
    circle = Rational.circle((0.0, 0.0), 1.0)
    near, bound = circle.polynomial_within(1e-6)
    assert bound <= 1e-6 and isinstance(near, Spline) and near.degree == 3
    assert circle.polynomial_within(1e-8, 5)[0].degree == 5
    finer = Rational.circle((0, 0), 1).inserted([Fraction(1, 3)] * 2)
    assert finer.without_spare_knots(0)[0].same_function(finer)
    assert finer.simplified_within(0)[1] == 0
    x, y = circle.bounding_box(1e-9)
    assert abs(y[0].value + 1) < 1e-8 and abs(x[1].bound - 1) < 1e-8
    assert circle.coordinate(0).range(1e-3)[1].bound >= 1
    assert circle.control_box()[0].tolist() == [-1, -1]


@given(spaces(least=1, most=3, jumps=False), places)
def test_rational_basis_functions_sum_to_one(space, x):
    one = Rational(space, [1] * space.dim, range(1, space.dim + 1))
    rows = one.basis_derivatives(x, 2)
    assert sum(rows[0][1]) == 1 and sum(rows[1][1]) == 0 == sum(rows[2][1])


@pytest.mark.parametrize(
    ("make", "kind"),
    [
        (lambda: Rational(Space.bezier(1), [1, 2], [1]), "CoefficientCount"),
        (lambda: Rational(Space.bezier(1), [1, 2]), "Arguments"),
        (lambda: Rational(Space.bezier(1), [1, 2], [1, 1], [[1, 1], [1, 1]]), "Arguments"),
        (lambda: Rational(Space.bezier(1), homogeneous=[1, 2]), "Shape"),
        (lambda: Rational(Space.bezier(1), [1, 2], [1, -1]), None),
        (lambda: Rational.circle((0, 0, 0), 1), "Dimensions"),
        (lambda: Rational.arc((0, 0), (1, 0), (2, 0)), "NotOnCircle"),
        (lambda: Rational.circle((0, 0), 1)(3), "OutsideDomain"),
        (lambda: Rational.circle((0, 0), 1).moebius(0, 1, -1), "Ratio"),
        (lambda: Rational.circle((0, 0), 1) ** 2, "NoSuch"),
        (lambda: Rational.from_quotient(Spline.monomial(1), Spline.monomial(1)), "Pole"),
    ],
)
def test_errors(make, kind):
    with pytest.raises(SymsplineError) as caught:
        make()
    assert kind is None or caught.value.kind == kind
