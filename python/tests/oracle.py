"""Splines by their definition, over any numbers: what the library is compared with."""

from fractions import Fraction

import pytest


def basis(knots, degree, i, x, left=False):
    """Basis function i at x by the recursion of Cox and de Boor; right limits, or left ones."""
    t = knots
    if degree == 0:
        inside = t[i] < x <= t[i + 1] if left else t[i] <= x < t[i + 1]
        return Fraction(int(inside))
    value = Fraction(0)
    if t[i + degree] != t[i]:
        value += (x - t[i]) / (t[i + degree] - t[i]) * basis(t, degree - 1, i, x, left)
    if t[i + degree + 1] != t[i + 1]:
        value += (t[i + degree + 1] - x) / (t[i + degree + 1] - t[i + 1]) * basis(t, degree - 1, i + 1, x, left)
    return value


def value(knots, degree, coeffs, x):
    """The value at x; at the end of the domain the left limit."""
    end = knots[len(knots) - degree - 1]
    return sum(c * basis(knots, degree, i, x, x == end) for i, c in enumerate(coeffs))


def derivative(knots, degree, coeffs):
    """Knots and coefficients of the derivative."""
    t, p = knots, degree
    steps = [(i, t[i + p + 1] - t[i + 1]) for i in range(len(coeffs) - 1)]
    return t[1:-1], [p * (coeffs[i + 1] - coeffs[i]) / h if h else Fraction(0) for i, h in steps]


def splipy():
    """The package, where it can be imported: its last one for an old Python is for an old numpy."""
    return pytest.importorskip("splipy", exc_type=ImportError)
