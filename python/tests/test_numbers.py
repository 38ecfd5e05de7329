"""Numbers and arrays of every kind, in and out."""

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from symspline import Space, Spline, SymsplineError

SPACE = Space.bezier(2)


def test_arrays_of_every_layout():
    points = np.random.default_rng(1).normal(size=(3, 2))
    plain = Spline(SPACE, points)
    wide = np.zeros((6, 4))
    wide[::2, ::2] = points
    assert Spline(SPACE, np.asfortranarray(points)) == plain
    assert Spline(SPACE, wide[::2, ::2]) == plain
    assert Spline(SPACE, points[::-1])(0).tolist() == points[-1].tolist()
    assert Spline(SPACE, points.tolist()) == plain and Spline(SPACE, tuple(map(tuple, points))) == plain
    assert Spline(SPACE, list(points)) == plain and Spline(SPACE, points.astype(object)) == plain
    assert Spline(SPACE, points.astype(">f8")) == plain


@pytest.mark.parametrize("kind", ["int8", "int16", "int32", "int64", "uint8", "uint64"])
def test_whole_numbers_are_exact(kind):
    f = Spline(SPACE, np.array([1, 2, 3], dtype=kind))
    assert f.is_exact and f.coeffs.tolist() == [1, 2, 3]
    assert Spline(SPACE, [np.dtype(kind).type(1), 2, 3]).is_exact


@pytest.mark.parametrize("kind", ["float16", "float32", "longdouble"])
def test_other_floats_are_floats(kind):
    f = Spline(SPACE, np.array([1, 2, 3], dtype=kind))
    assert not f.is_exact and f.coeffs.dtype == np.float64 and f.coeffs.tolist() == [1, 2, 3]
    assert not Spline(SPACE, [np.dtype(kind).type(1), 2, 3]).is_exact


def test_big_numbers_stay():
    big = 10**40
    f = Spline(SPACE, [big, Fraction(1, big), -big])
    assert f.coeffs.tolist() == [big, Fraction(1, big), -big]
    assert Spline(SPACE, np.array([2**63], dtype="uint64").tolist() * 3).coeffs[0] == 2**63
    assert Spline(SPACE, np.full(3, 2**64 - 1, dtype="uint64")).coeffs[0] == 2**64 - 1


def test_single_values_and_arrays_without_axes():
    f = Spline(SPACE, [0.0, 1.0, 4.0])
    assert isinstance(f(0.5), float) and isinstance(f(np.float32(0.5)), float) and isinstance(f(np.array(0.5)), float)
    assert f(np.array([])).shape == (0,) and f([]).shape == (0,) and f(np.zeros((2, 0))).shape == (2, 0)
    assert Spline(SPACE, [[0, 1], [1, 1], [2, 2]])(np.zeros((0, 3))).shape == (0, 3, 2)
    assert f(True) == f(1) and f(Decimal("0.5")) == f(0.5)
    exact = f.to_exact()
    assert exact(np.array([0, 1])).dtype == object and exact([0, 0.5]).dtype == np.float64
    assert exact(np.array([Fraction(1, 2), Fraction(1, 3)], dtype=object)).tolist() == [exact(Fraction(1, 2)), exact(Fraction(1, 3))]


def test_results_are_plain_arrays_of_their_own():
    points = np.ones((3, 2))
    f = Spline(SPACE, points)
    points[:] = 7
    assert f.coeffs.tolist() == [[1, 1]] * 3
    coeffs = f.coeffs
    coeffs[:] = 7
    assert f.coeffs.tolist() == [[1, 1]] * 3 and coeffs.flags.writeable and coeffs.flags.c_contiguous


@pytest.mark.parametrize("bad", [float("nan"), float("inf"), -float("inf")])
def test_no_infinities(bad):
    f = Spline(SPACE, [0.0, 1.0, 4.0])
    for make in (
        lambda: Spline(SPACE, [0, bad, 1]),
        lambda: f(bad),
        lambda: f([0.5, bad]),
        lambda: f.to_exact()(bad),
        lambda: f + bad,
        lambda: f * bad,
        lambda: f.inserted([bad]),
        lambda: f.reparametrised(0, bad),
        lambda: Space(1, [0, 0, bad, 1]),
        lambda: Spline(SPACE, [0, bad, 1], exact=True),
        lambda: f.simplified_within(bad),
    ):
        with pytest.raises(SymsplineError):
            make()


JUNK = [None, "abc", "1/2", b"12", object(), {}, {1: 2}, {1, 2}, 1j, [1j, 2, 3], ["a", 1, 2], [None] * 3, [[1], 2, 3]]
JUNK += [np.array(["a", "b", "c"]), np.zeros(3, dtype=complex), np.array([None] * 3)]
JUNK += [np.array(["2020-01-01"] * 3, dtype="datetime64[D]"), type, lambda x: x, float, ...]


@pytest.mark.parametrize("junk", JUNK, ids=repr)
def test_junk_is_refused(junk):
    f = Spline(SPACE, [0, 1, 4])
    for make in (
        lambda: Spline(SPACE, junk),
        lambda: Spline(junk, [1, 2, 3]),
        lambda: f(junk),
        lambda: f + junk,
        lambda: junk * f,
        lambda: junk @ f,
        lambda: f.inserted(junk),
        lambda: f.restricted(0, junk),
        lambda: f.elevate(junk),
        lambda: f.embedded(junk),
        lambda: f.inner(junk),
        lambda: f.degree_reduced(1, junk),
        lambda: f.without_knot(3, junk),
        lambda: f.transformed(junk),
        lambda: Spline.least_squares(SPACE, [0, 1], [0, 1], junk),
        lambda: Spline.from_scipy(junk),
        lambda: Space(1, junk),
        lambda: f**junk,
    ):
        with pytest.raises((SymsplineError, TypeError, ValueError, AttributeError)):
            make()


def test_sequences_that_lie():
    class Endless:
        def __len__(self):
            return 3

        def __iter__(self):
            return iter(range(10**9))

    class Failing:
        def __len__(self):
            raise ZeroDivisionError

    class Short:
        def __len__(self):
            return 3

        def __iter__(self):
            return iter([1])

    for odd in (Endless(), Short()):
        with pytest.raises(SymsplineError):
            Spline(SPACE, odd)
    with pytest.raises((TypeError, ZeroDivisionError)):
        Spline(SPACE, Failing())
    itself = []
    itself.append(itself)
    with pytest.raises(SymsplineError):
        Spline(SPACE, itself)


@pytest.mark.parametrize("number", [-1, 2**64, 2**100, 1.5])
def test_counts_are_counts(number):
    f = Spline(SPACE, [0, 1, 4])
    for make in (lambda: f.elevate(number), lambda: f.derivative(number), lambda: Space(number, [0, 1]), lambda: f**number):
        with pytest.raises((OverflowError, TypeError)):
            make()
