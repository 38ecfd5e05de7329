"""Surfaces, polynomial and rational."""

import pickle
from fractions import Fraction

import numpy as np
import oracle
import pytest
import scipy.interpolate
from hypothesis import given
from strategies import places, surfaces
from symspline import Rational, RationalSurface, Space, Spline, Surface, SymsplineError

HALF = Fraction(1, 2)
LINE = Space.bezier(1)


def saddle():
    """The graph of `u * v`."""
    return Surface(LINE, LINE, [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]])


def exactly(s, u, v):
    def row(coeffs):
        return oracle.value(s.v.knots.tolist(), s.v.degree, coeffs, v)

    net = np.asarray(s.coeffs).reshape(s.u.dim, s.v.dim, -1)
    axes = range(net.shape[2])
    return [oracle.value(s.u.knots.tolist(), s.u.degree, [row(list(r[:, k])) for r in net], u) for k in axes]


@given(surfaces(), places, places)
def test_values_are_those_of_the_definition(s, u, v):
    assert s(u, v).tolist() == exactly(s, u, v) == s.grid([u], [v])[0, 0].tolist()
    assert s.derivatives_at(u, v, 0)[0, 0].tolist() == exactly(s, u, v)
    assert s.isocurve("u", u)(v).tolist() == s.isocurve(1, v)(u).tolist() == exactly(s, u, v)


@given(surfaces(), places, places)
def test_operators_keep_values(s, u, v):
    value = s(u, v).tolist()
    same = [s.elevate("u"), s.inserted("v", [HALF]) if HALF not in s.v.breaks else s, s.clamped_ends(), s.simplified()]
    same += [s.embedded(s.u.bisected(), s.v.elevate()), s.reversed(0).reversed("u"), s.transposed().transposed()]
    same += [s.projected(s.u, s.v)[0], s.elevate("u").degree_lowered("u")[0], s.antiderivative("u").derivative("u")]
    for other in same:
        assert other(u, v).tolist() == value and s.same_function(other)
    assert s.transposed()(v, u).tolist() == value
    assert s.antiderivative("u").isocurve("u", u).antiderivative()(v).tolist() == s.integral((0, 0), (u, v)).tolist()
    if 0 < u < 1:
        left, right = s.split("u", u)
        assert left(u, v).shape == (3,) and right(u, v).tolist() == value and left.same_function(s.restricted("u", 0, u))


@given(surfaces(most=1), surfaces(most=1), places, places)
def test_signs_are_those_of_the_values(s, t, u, v):
    a, b = s(u, v), t(u, v)
    x = s.coordinate(0)
    assert (s + t)(u, v).tolist() == (a + b).tolist() and (s - t)(u, v).tolist() == (a - b).tolist()
    assert (s @ t)(u, v) == a @ b and s.cross(t)(u, v).tolist() == np.cross(a, b).tolist()
    assert (x * t)(u, v).tolist() == (a[0] * b).tolist() and (x**2)(u, v) == a[0] ** 2
    assert (s + (1, 2, 3))(u, v).tolist() == [a[0] + 1, a[1] + 2, a[2] + 3]
    assert (s / (x * x + 1))(u, v).tolist() == (a / (a[0] ** 2 + 1)).tolist()
    assert (np.eye(3, dtype=int)[:2] @ s)(u, v).tolist() == a[:2].tolist()
    assert s.plus_scaled(2, t).same_function(s + 2 * t)


@given(surfaces())
def test_nothing_is_lost(s):
    rational = RationalSurface.from_polynomial(s)
    for one in (s, s.to_float(), rational, rational.to_float()):
        assert pickle.loads(pickle.dumps(one)) == one


def test_forms_and_volumes():
    s = saddle()
    e, f, g = s.first_form_at(1, 2 * HALF)
    assert (e, f, g) == (2, 1, 2) and s.normal_at(1, 1).tolist() == [-1, -1, 1]
    assert [form(1, 1) for form in s.first_form()] == [2, 1, 2] and s.normal()(1, 1).tolist() == [-1, -1, 1]
    assert np.allclose(s.unit_normal_at(0, 0), [0, 0, 1]) and s.second_form_at(0, 0) == (0, 1, 0)
    assert [form(0, 0) for form in s.scaled_second_form()] == [0, 1, 0]
    assert s.vector_area().tolist() == [-HALF, -HALF, 1]
    assert s.tangents_at(HALF, 1)[1].tolist() == [1, 0, 1] and s.partial(1, 1)(0, 0).tolist() == [0, 0, 1]
    plane = Surface(LINE, LINE, [[[0, 0], [0, 2]], [[3, 0], [3, 2]]])
    assert plane.area_moment((0, 0)) == 6 and plane.area_moment((1, 0)) == 9
    assert saddle().volume_moment((0, 0, 0)) == -Fraction(1, 12)
    rational = RationalSurface.from_polynomial(s)
    assert rational.first_form_at(1, 1) == (2, 1, 2) and rational.normal_at(1, 1).tolist() == [-1, -1, 1]
    assert s.composed(Spline.segment((0, 0), (1, 1)))(HALF).tolist() == [HALF, HALF, HALF**2]
    assert s.integral().tolist() == [HALF, HALF, HALF**2] and s.moment(1, 0).tolist()[0] == Fraction(1, 3)


def test_places_on_surfaces_are_u_and_v():
    line = Space.bezier(1)
    least, greatest = Surface(line, line, [[0, -1], [1, 0]]).range(Fraction(1, 100))
    assert greatest.parameter.tolist() == [1, 0] and least.parameter.tolist() == [0, 1]
    long = Surface(Space.uniform(1, 2, 0, 4), line, [[0, 1], [5, 2], [3, 7]])
    finer = long.inserted("u", [3]).inserted("v", [HALF])
    kept, bound = finer.without_spare_knots_on((2, 0), (4, 1), 0)
    assert bound == 0 and kept.same_function(long) and kept.u == long.u


def test_what_is_along_u_is_not_along_v():
    x, y = (Surface(LINE, LINE, rows) for rows in ([[0, 0], [1, 1]], [[0, 1], [0, 1]]))
    f = x * x * y
    assert f.partial(2, 0)(HALF, 1) == 2 and f.partial(1, 1)(HALF, 1) == 1 and f.partial(0, 1)(HALF, 1) == Fraction(1, 4)
    assert f.moment(1, 0) == Fraction(1, 8) and f.moment(0, 1) == Fraction(1, 9)
    assert f.integral((0, HALF), (1, 1)) == Fraction(1, 8) and f.integral((HALF, 0), (1, 1)) == Fraction(7, 48)
    assert f.tangents_at(HALF, 1).tolist() == [Fraction(1, 4), 1, Fraction(1, 4)]
    assert f.tangents_at(0.5, 1).dtype == np.float64 and f.tangents_at(0.5, 1).tolist() == [0.25, 1, 0.25]
    stretched = Surface(LINE, LINE, [[[0, 0], [0, 1]], [[3, 1], [3, 2]]])
    assert stretched.first_form_at(0, 0) == (10, 1, 1) and [g(0, 0) for g in stretched.first_form()] == [10, 1, 1]


def test_ranges_of_surfaces():
    z = saddle().coordinate(2)
    least, greatest = z.range(Fraction(1, 100))
    assert greatest.parameter.tolist() == [1, 1] and greatest.value == 1 and least.bound == 0
    assert z.coefficient_range() == (0, 1) and (z + 1).positive_bound() > 0
    assert len(saddle().bounding_box(0.1)) == 3 and saddle().control_box()[1].tolist() == [1, 1, 1]


def test_scipy_and_splipy_are_witnesses():
    splipy = oracle.splipy()
    u, v = Space.clamped(3, [0.0, 0.5, 1.0]), Space.clamped(2, [0.0, 0.3, 1.0])
    s = Surface(u, v, np.random.default_rng(6).normal(size=(5, 4, 3)))
    us, vs = np.linspace(0, 1, 7), np.linspace(0, 1, 5)
    other = splipy.Surface(splipy.BSplineBasis(4, u.knots), splipy.BSplineBasis(3, v.knots), s.coeffs, raw=True)
    assert np.allclose(s.grid(us, vs), other.evaluate(us, vs), atol=1e-14)
    assert np.allclose(s(us[:, None], vs), s.grid(us, vs), atol=1e-14)
    if hasattr(scipy.interpolate, "NdBSpline"):
        places = np.stack(np.meshgrid(us, vs, indexing="ij"), -1)
        assert np.allclose(s.to_scipy()(places), s.grid(us, vs), atol=1e-14)
        assert Surface.from_scipy(s.to_scipy()) == s
    weights = np.random.default_rng(7).random((5, 4)) + 0.5
    rational = RationalSurface(u, v, s.coeffs, weights)
    raw = splipy.Surface(
        splipy.BSplineBasis(4, u.knots), splipy.BSplineBasis(3, v.knots), rational.homogeneous, rational=True, raw=True
    )
    assert np.allclose(rational.grid(us, vs), raw.evaluate(us, vs), atol=1e-13)
    assert np.allclose(rational.derivatives_at(0.4, 0.6, 1)[1, 0], raw.derivative(0.4, 0.6, d=(1, 0)), atol=1e-12)


def test_shapes_are_broadcast():
    s = saddle()
    assert s(0.5, np.zeros(3)).shape == (3, 3) and s(np.zeros((2, 1)), np.zeros(4)).shape == (2, 4, 3)
    assert s.coordinate(0)(HALF, [0, 1]).tolist() == [HALF, HALF]
    many = np.random.default_rng(8).random((2, 20_000))
    assert np.allclose(s(*many)[:, 2], many[0] * many[1], atol=1e-14)
    with pytest.raises(ValueError):
        s(np.zeros(2), np.zeros(3))


def test_rational_surfaces():
    sphere_like = RationalSurface(LINE, LINE, saddle().coeffs, [[1, 2], [3, 4]])
    assert sphere_like.weights.tolist() == [[1, 2], [3, 4]] and sphere_like.points.tolist() == saddle().coeffs.tolist()
    assert sphere_like.isocurve("u", 0) == Rational(LINE, [[0, 0, 0], [0, 1, 0]], [1, 2])
    assert sphere_like.moebius("u", 0, 1, 2).domain == ((0, 1), (0, 1))
    assert sphere_like.denominator(1, 1) == 4 and sphere_like.numerator(1, 1).tolist() == [4, 4, 4]
    near, bound = sphere_like.to_float().polynomial_within(1e-3)
    assert isinstance(near, Surface) and bound <= 1e-3
    assert sphere_like.transposed()(0, 1).tolist() == sphere_like(1, 0).tolist()
    assert (sphere_like + saddle()).same_function(saddle() + sphere_like)
    assert sphere_like.coordinate(0).range(0.1)[1].value == 1


EDGES = [Spline.segment((0, 0, z), (1, z, z)) for z in (5, 7)]


def test_skins():
    sections = [Spline.segment((0, 0, z), (1, z, z)) for z in (0, 1, 3)]
    skin = Surface.skin(sections, 2)
    assert skin.is_exact and skin.isocurve("v", HALF).same_function(sections[1])
    placed = Surface.skin(sections, 2, [0, Fraction(1, 3), 1])
    assert placed.isocurve("v", Fraction(1, 3)).same_function(sections[1])
    assert not Surface.skin(sections, 2, spacing="chord").is_exact
    assert Surface.skin(sections, 2, closed=True).v.is_periodic
    tangents = Spline.segment((0, 0, 1), (0, 0, 1))
    held = Surface.skin(sections, 3, start=tangents)
    assert held.derivatives_at(0, 0, 1)[0, 1].tolist() == [0, 0, 1]


def test_skins_in_a_space():
    sections = [Spline.segment((0, k, 0), (1, k, k * k % 3)) for k in range(4)]
    space = Space.clamped(2, [0, Fraction(1, 3), 1])
    at = [0, Fraction(1, 4), Fraction(3, 4), 1]
    skin = Surface.skin(sections, None, at, space=space)
    assert skin.v == space and skin.is_exact
    for x, section in zip(at, sections):
        for u in (0, Fraction(1, 3), 1):
            assert skin(u, x).tolist() == section(u).tolist()
    assert Surface.skin(sections, parameters=at, space=space.to_float()).v == space.to_float()


@pytest.mark.parametrize("exact", [True, False])
def test_skins_go_on_from_surfaces(exact):
    def bent(k):
        return Spline(Space.bezier(2), [[0, k, 0], [1, k, 2 - k], [2, k, k * k]])

    before, after = Surface.skin([bent(0), bent(1), bent(2)], 2), Surface.skin([bent(4), bent(6)], 1)
    sections = [bent(2), bent(3), bent(4)]
    if not exact:
        before, after, sections = before.to_float(), after.to_float(), [s.to_float() for s in sections]
    skin = Surface.skin(sections, 3, continuing=(before, 2), continued_by=after, tolerance=0 if exact else 1e-12)
    assert skin.is_exact == exact
    for u in (0, Fraction(1, 3), Fraction(4, 5)):
        start, end = skin.derivatives_at(u, 0, 1)[0, 1], skin.derivatives_at(u, 1, 1)[0, 1]
        first, last = 2 * before.derivatives_at(u, 1, 1)[0, 1], after.derivatives_at(u, 0, 1)[0, 1]
        if exact:
            assert start.tolist() == first.tolist() and end.tolist() == last.tolist()
        assert np.allclose(np.array([start, end], float), np.array([first, last], float), atol=1e-12)
        assert np.allclose(np.array(skin(u, HALF), float), np.array(sections[1](u), float), atol=1e-12)


def test_less_knots():
    s = saddle().inserted("u", [HALF])
    assert s.removed("u", HALF)[0] == saddle() and s.simplified_within(0)[0].same_function(s)
    assert s.without_spare_knots_on((0, 0), (1, 1), 0)[0].same_function(s)


@pytest.mark.parametrize(
    ("make", "kind"),
    [
        (lambda: Surface(LINE, LINE, [1, 2, 3, 4]), "Shape"),
        (lambda: Surface(LINE, Space.bezier(2), [[1, 2], [3, 4], [5, 6]]), "Shape"),
        (lambda: saddle()(0, 2), "OutsideDomain"),
        (lambda: saddle().elevate("v", 10**6), "DegreeTooHigh"),
        (lambda: saddle().area_moment((0, 0)), "Dimensions"),
        (lambda: saddle().coordinate(0).normal(), "Dimensions"),
        (lambda: saddle() + Spline.monomial(1), "NoSuch"),
        (lambda: saddle().composed(Spline.monomial(1)), "Dimensions"),
        (lambda: Surface.skin([], 1), "TooFewSections"),
        (lambda: Surface.skin(EDGES), "Word"),
        (lambda: Surface.skin(EDGES, 1, space=LINE), "Word"),
        (lambda: Surface.skin(EDGES, 2, start=EDGES[0], continuing=saddle()), "Word"),
        (lambda: Surface.skin(EDGES, space=Space.bezier(1, HALF, 1)), "OutsideDomain"),
        (lambda: Surface.skin(EDGES, closed=True, space=LINE), "SpaceNotClosed"),
        (lambda: Surface.skin(EDGES, 2, continuing=saddle()), "EdgeElsewhere"),
        (lambda: Surface.skin(EDGES, 2, continued_by=(saddle(), -1), tolerance=100), "Ratio"),
        (lambda: Surface.skin(EDGES, 2, continuing=saddle().coordinate(0)), "Dimensions"),
        (lambda: Surface.skin([Spline.monomial(1), Spline.segment((0, 0), (1, 1))], 1), "Dimensions"),
        (lambda: Surface.constant(Space.uniform(1, 2**20), Space.uniform(1, 2**20), 1), "TooLarge"),
        (lambda: RationalSurface(LINE, LINE, [[1, 2], [3, 4]], [[1, 2]]), "Shape"),
        (lambda: saddle().grid([[0]], [0]), "Shape"),
        (lambda: saddle().derivatives_at(0, 0, 10**9), "TooLarge"),
    ],
)
def test_errors(make, kind):
    with pytest.raises(SymsplineError) as caught:
        make()
    assert caught.value.kind == kind


def test_directions_have_names():
    with pytest.raises(ValueError, match="direction"):
        saddle().derivative("w")
    with pytest.raises(ValueError, match="direction"):
        saddle().derivative(2)
