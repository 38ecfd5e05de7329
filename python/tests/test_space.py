"""Spaces: constructors, what they tell, spaces made of them, matrices."""

import copy
import pickle
from fractions import Fraction

import numpy as np
import oracle
import pytest
from hypothesis import given
from hypothesis import strategies as st
from oracle import value
from strategies import places, spaces, splines
from symspline import Space, Spline, SymsplineError

HALF = Fraction(1, 2)


def test_constructors_agree():
    assert Space.bezier(2) == Space(2, [0, 0, 0, 1, 1, 1]) == Space.clamped(2, [0, 1]) == Space.uniform(2, 1)
    assert Space.uniform(1, 2) == Space(1, [0, 0, HALF, 1, 1])
    assert Space.uniform_periodic(2, 4, 0, 4) == Space(2, [0, 1, 2, 3], end=4)
    assert Space.snapped(1, [0.0, 1e-12, 1.0, 1.0], 1e-9) == Space(1, [0.0, 0.0, 1.0, 1.0])
    assert Space.for_interpolation(3, range(5)).dim == 5
    assert Space.for_approximation(3, range(9), 6).dim == 6


def test_what_a_space_tells():
    space = Space.clamped(2, [0, 1, 1, 3])
    assert (space.degree, space.dim, space.domain) == (2, 5, (0, 3))
    assert (space.is_clamped, space.is_periodic, space.is_exact) == (True, False, True)
    assert list(space.knots) == [0, 0, 0, 1, 1, 3, 3, 3]
    assert list(space.breaks) == [0, 1, 3] and space.multiplicities == [3, 2, 3]
    assert list(space.greville) == [0, HALF, 1, 2, 3]
    assert space.knots_round is None
    ring = Space(2, [0, 1, 3], end=4)
    assert ring.is_periodic and list(ring.knots_round) == [0, 1, 3]
    assert [ring.slot(i) for i in range(5)] == [0, 1, 2, 0, 1]


def test_floats_and_fractions():
    exact, inexact = Space(1, [0, 0, HALF, 1, 1]), Space(1, [0, 0, 0.5, 1, 1])
    assert exact.is_exact and not inexact.is_exact and exact != inexact
    assert exact.to_float() == inexact and inexact.to_exact() == exact
    assert Space(1, [0, 0, 0.5, 1, 1], exact=True) == exact
    assert Space(1, [0, 0, HALF, 1, 1], exact=False) == inexact
    assert Space(1, [0, 1], end=2.0) == Space(1, [0, 1], end=2).to_float()
    assert exact.union(inexact) == inexact


def test_made_of_others():
    s, t = Space.clamped(2, [0, 1, 2]), Space.clamped(1, [0, HALF, 2])
    assert s.refined([HALF]) == Space.clamped(2, [0, HALF, 1, 2])
    assert s.bisected() == Space.clamped(2, [0, HALF, 1, Fraction(3, 2), 2])
    assert s.elevate() == Space.clamped(3, [0, 1, 1, 2]) and s.elevate().reduced() == s
    assert s.elevate().reduced(continuity="kept") == s and s.reduced(1, "breaks").breaks.tolist() == [0, 1, 2]
    assert s.elevate(3).reduced(1, 0).multiplicities[1] == 4
    assert s.derivative_space() == Space.clamped(1, [0, 1, 2])
    assert s.derivative_space().antiderivative_space() == s
    assert s.union(t).contains(s) and s.union(t).contains(t) and not s.contains(t)
    assert s.product_space(t).degree == 3
    assert s.reversed() == s and s.reparametrised(1, 3).domain == (1, 3)
    assert s.pieces(1).multiplicities == [2, 2, 2]
    assert s.unclamped_ends().clamped_ends() == s
    assert s.with_outer_knots([-2, -1], [3, 4]).knots.tolist() == [-2, -1, 0, 1, 2, 3, 4]


@given(spaces(), places)
def test_basis_functions_are_those_of_the_definition(space, x):
    first, values = space.basis(x)
    dense = [Fraction(0)] * space.dim
    dense[first : first + len(values)] = values
    knots = space.knots.tolist()
    assert dense == [oracle.basis(knots, space.degree, i, x, x == 1) for i in range(space.dim)]
    assert sum(values) == 1
    assert list(space.evaluation([x])[0]) == dense
    assert list(space.basis_derivatives(x, 0)[0][1]) == list(values)


@given(spaces(least=1, jumps=False))
def test_matrices_are_operators(space):
    coeffs = np.array([Fraction(i * i % 7, i + 1) for i in range(space.dim)], dtype=object)
    f = Spline(space, coeffs)
    assert list(space.differentiation() @ coeffs) == list(f.derivative().coeffs)
    assert list(space.antidifferentiation() @ coeffs) == list(f.antiderivative().coeffs)
    target = space.elevate().bisected()
    assert list(space.embedding(target) @ coeffs) == list(f.embedded(target).coeffs)
    assert coeffs @ space.gram() @ coeffs == f.inner(f)
    first, weights = space.integral_between(0, Fraction(1, 3))
    assert weights @ coeffs[first : first + len(weights)] == f.integral(0, Fraction(1, 3))
    first, weights = space.moment(2)
    assert weights @ coeffs[first : first + len(weights)] == f.moment(2)


def test_multiplication_is_the_product():
    s, t = Space.clamped(1, [0, 1, 2]), Space.bezier(2, 0, 2)
    a, b = np.array([1, 5, 2], dtype=object), np.array([3, -1, 4], dtype=object)
    table = s.multiplication(t)
    assert table.shape == (s.product_space(t).dim, 3, 3)
    assert [a @ layer @ b for layer in table] == list((Spline(s, a) * Spline(t, b)).coeffs)


def test_powers_and_duals():
    space = Space.clamped(3, [0, 1, 1, 2])
    assert Spline(space, space.monomial_coeffs(3))(HALF) == HALF**3
    assert Spline(space, space.marsden_coeffs(5))(HALF) == Fraction(9, 2) ** 3
    f = Spline(space, [3, 1, 4, 1, 5, 9])
    for i in range(space.dim):
        x, from_left, weights = space.dual_functional(i)
        if not from_left:
            assert weights @ f.derivatives_at(x, 3) == f.coeffs[i]
    span = space.locate(HALF)
    first, weights = space.polar(span, [HALF] * 3)
    assert weights @ f.coeffs[first : first + 4] == f(HALF)


@given(splines(dim=1, periodic=True), places, places)
def test_restriction_and_reversal_are_maps(f, a, b):
    space, knots = f.space, list(f.space.knots)
    # A ring is laid out as an open spline: the coefficients round again.
    coeffs = [f.coeffs[i % space.dim] for i in range(len(knots) - space.degree - 1)]
    reversal = space.reversal()
    assert sorted(map(list, reversal)) == sorted(map(list, np.eye(space.dim, dtype=int)))
    mirrored = Spline(space.reversed(), reversal @ f.coeffs)
    # Away from knots, where limits from both sides agree.
    for x in [Fraction(k, 37) for k in range(1, 37)]:
        assert mirrored(1 - x) == value(knots, space.degree, coeffs, x)
    if a < b:
        target, matrix = space.restricted_space(a, b), space.restriction(a, b)
        assert target.domain == (a, b) and matrix.shape == (target.dim, space.dim)
        part = list(matrix @ f.coeffs)
        for x in [a + (b - a) * Fraction(k, 37) for k in range(1, 37)]:
            assert value(list(target.knots), target.degree, part, x) == value(knots, space.degree, coeffs, x)


@given(spaces(periodic=True))
def test_recomposition_undoes_pieces(space):
    back = space.recomposition() @ space.embedding(space.pieces(space.degree))
    assert (back == np.eye(space.dim, dtype=int)).all()


def test_composition_is_a_map():
    space, inner = Space.clamped(2, [0, Fraction(1, 4), Fraction(2, 3), 1]), Spline.monomial(2)
    f = [3, -1, 4, 1, 5]
    target, matrix = space.composition(Spline(Space.clamped(1, [0, HALF, 1]), [0, Fraction(1, 4), 1]))
    assert target.degree == 2 and matrix.shape == (target.dim, space.dim)
    for x in [Fraction(k, 37) for k in range(38)]:
        y = x / 2 if x < HALF else Fraction(1, 4) + (x - HALF) * Fraction(3, 2)
        assert value(list(target.knots), 2, list(matrix @ f), x) == value(list(space.knots), 2, f, y)
    lines = Space.clamped(1, [0, Fraction(1, 4), 1])
    target, matrix = lines.composition(inner)
    assert target == Space.clamped(2, [0, HALF, HALF, 1]) and (matrix @ [0, 1, 4]).tolist() == [0, 0, 1, 2, 4]
    with pytest.raises(SymsplineError) as caught:
        space.composition(Spline.segment((0, 0), (1, 1)))
    assert caught.value.kind == "Dimensions"


@given(spaces(periodic=True), st.integers(1, 9))
def test_supports_and_even_parameters(space, count):
    knots = list(space.knots)
    for i in range(len(knots) - space.degree - 1):
        assert space.support(i) == (knots[i], knots[i + space.degree + 1])
    steps = count if space.is_periodic else max(count - 1, 1)
    assert list(space.even_parameters(count)) == [Fraction(k, steps) for k in range(count)]


@given(spaces(periodic=True))
def test_equal_spaces_have_equal_hashes_and_come_back(space):
    for again in (pickle.loads(pickle.dumps(space)), copy.copy(space), copy.deepcopy(space), space.to_exact()):
        assert again == space and hash(again) == hash(space)
    assert len({space, space.to_float(), space.elevate()}) == 3


def test_negative_zero_hashes_as_zero():
    a, b = Space(1, [0.0, 0.0, 1.0, 1.0]), Space(1, [-0.0, -0.0, 1.0, 1.0])
    assert a == b and hash(a) == hash(b)


@pytest.mark.parametrize(
    ("make", "kind"),
    [
        (lambda: Space(2, [0, 1]), "TooFewKnots"),
        (lambda: Space(1, [0, 0, 2, 1]), "KnotsDecrease"),
        (lambda: Space(1, [0.0, float("nan"), 1.0, 1.0]), "NotFinite"),
        (lambda: Space(10**6, [0, 1]), "DegreeTooHigh"),
        (lambda: Space.uniform(3, 10**15), "TooLarge"),
        (lambda: Space.uniform(3, 2**64 - 1), "TooLarge"),
        (lambda: Space(1, [[0, 0, 1, 1]]), "Shape"),
        (lambda: Space.bezier(1).refined([2]), "OutsideDomain"),
        (lambda: Space.bezier(1).union(Space.bezier(1, 0, 2)), "DomainMismatch"),
        (lambda: Space.bezier(1).bisected().embedding(Space.bezier(1)), "TooSmooth"),
        (lambda: Space.uniform(1, 2**20).evaluation([0.5] * 1000), "TooLarge"),
        (lambda: Space.bezier(2).support(3), "IndexOutOfRange"),
        (lambda: Space.bezier(2).even_parameters(0), "TooFewPoints"),
        (lambda: Space.bezier(2).even_parameters(10**15), "TooLarge"),
        (lambda: Space.bezier(2).restriction(HALF, HALF), "EmptyDomain"),
        (lambda: Space.bezier(2).restricted_space(0, 2), "OutsideDomain"),
        (lambda: Space.uniform(1, 2**20).reversal(), "TooLarge"),
        (lambda: Space.bezier(2).slot(10**9) and Space.bezier(2).polar(7, [0, 0]), "EmptySpan"),
    ],
)
def test_errors(make, kind):
    with pytest.raises(SymsplineError) as caught:
        make()
    assert caught.value.kind == kind
    assert isinstance(caught.value.data, dict)
    assert all(isinstance(x, (int, str, dict, list)) for x in caught.value.data.values())
