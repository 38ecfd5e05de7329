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


def integral(f, a, b):
    """Of a polynomial of degree five at most, by its values inside."""
    values = [w * f(a + (b - a) * Fraction(k, 6)) for k, w in zip(range(1, 6), [11, -14, 26, -14, 11])]
    return sum(values[1:], values[0]) * Fraction(b - a, 20)


def gram(knots, degree, order):
    """Inner products of the derivatives of an order of all basis functions, up to degree two of these."""
    n = len(knots) - degree - 1
    functions = []
    for i in range(n):
        t, p, coeffs = list(knots), degree, [Fraction(int(i == j)) for j in range(n)]
        for _ in range(order):
            t, coeffs = derivative(t, p, coeffs)
            p -= 1
        functions.append((t, p, coeffs))
    spans = [(a, b) for a, b in zip(knots[degree:n], knots[degree + 1 : n + 1]) if a < b]

    def inner(f, g):
        return sum((integral(lambda x: value(*f, x) * value(*g, x), a, b) for a, b in spans), Fraction(0))

    return [[inner(f, g) for g in functions] for f in functions]
