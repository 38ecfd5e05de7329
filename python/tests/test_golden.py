"""The golden values of `tests/golden/cases.json`, as `tests/golden/*.rs` check them, through this package.

Over fractions everything must be equal. Over floats indices and knots must be equal, and numbers may be off by
``factor * eps * size``, with the size of the largest number of the answer or, for derivatives, of what they are made of.
"""

import json
import math
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from symspline import Rational, RationalSurface, Space, Spline, SymsplineError

CASES = Path(__file__).parents[2] / "tests" / "golden" / "cases.json"
GOLDEN = json.loads(CASES.read_text())["cases"] if CASES.exists() else {}
pytestmark = pytest.mark.skipif(not GOLDEN, reason="the golden values are not beside this package")
EPSILON = float(np.finfo(float).eps)


class Case:
    """A case over fractions or, rounded to nearest, over floats."""

    def __init__(self, data, exact):
        self.data, self.exact = data, exact

    def number(self, text):
        x = Fraction(text)
        return x if self.exact else float(x)

    def __getitem__(self, key):
        """Numbers in the field of the case; counts, words and null as they are."""

        def of(value):
            if isinstance(value, list):
                return [of(entry) for entry in value]
            return self.number(value) if isinstance(value, str) else value

        return of(self.data[key])

    def space(self, degree="p", knots="U"):
        return Space(self[degree], self[knots])

    def curve(self):
        return Spline(self.space(), self["P"])

    def nurbs(self):
        return Rational(self.space(), self["P"], self["w"])


def of_spline(f, coeffs=None):
    coeffs = np.asarray(f.coeffs if coeffs is None else coeffs)
    return [f.degree, f.space.dim], f.space.knots.tolist(), coeffs.reshape(f.space.dim, -1).tolist()


def golden_spline(case, degree, knots, coeffs):
    return [case[degree], len(case[coeffs])], case[knots], case[coeffs]


def largest(*numbers):
    return max((abs(float(x)) for x in np.asarray(numbers, dtype=object).ravel()), default=0.0)


def shortest_span(knots):
    return min(float(b - a) for a, b in zip(knots, knots[1:]) if b > a)


def derivative_size(size, degree, knots, order):
    h = shortest_span(knots)
    return size * math.prod(2 * max(degree - d, 1) / h for d in range(order))


def rational_size(size, degree, knots, weights, order):
    spread = largest(weights) / min(float(w) for w in np.ravel(weights))
    return derivative_size(size, degree, knots, order) * spread**order


def points_size(case, _rows, _k):
    return largest(case["P"])


def curve_size(case, _rows, k):
    return derivative_size(largest(case["P"]), case["p"], case["U"], k)


def basis_size(case, _rows, k):
    return derivative_size(1.0, case["p"], case["U"], k)


def integral_size(case, _rows, _k):
    return largest(case["P"]) * float(case["U"][-1] - case["U"][0])


def nurbs_size(case, _rows, k):
    return rational_size(largest(case["P"]), case["p"], case["U"], case["w"], k)


def nurbs_basis_size(case, _rows, k):
    return rational_size(1.0, case["p"], case["U"], case["w"], k)


def nurbs_surface_size(case, _rows, k):
    across, weights = case["K"] + 1, case["w"]
    size = rational_size(largest(case["P"]), case["p"], case["U"], weights, k // across)
    return rational_size(size, case["q"], case["V"], weights, k % across)


def basis(case):
    space = case.space()
    rows = space.basis_derivatives(case["u"], case["K"])
    assert list(space.basis(case["u"])[1]) == list(rows[0][1])
    return [space.locate(case["u"]), *(first for first, _ in rows)], space.knots.tolist(), [list(row) for _, row in rows]


def degree_reduction(case):
    lowered, bound = case.curve().degree_lowered(case["t"])
    integers, knots, rows = of_spline(lowered)
    if case.exact:
        try:
            assert case.curve().degree_reduced_exactly(case["t"]) == lowered and bound == 0
        except SymsplineError as error:
            assert error.kind == "NotReducible"
            rows = []
    elif bound > 1e-9:
        rows = []
    return integers, knots, rows


def golden_reduction(case):
    if case["P_out"] is None:
        return [case["p_out"], len(case["U_out"]) - case["p_out"] - 1], case["U_out"], []
    return golden_spline(case, "p_out", "U_out", "P_out")


def knot_removal(case):
    removed, _ = case.curve().removed(case["u"], 10**6, 0 if case.exact else 1e-12)
    integers, knots, rows = of_spline(removed)
    return [*integers, case.curve().space.dim - removed.space.dim], knots, rows


def knot_removal_forced(case):
    keep = "right" if case.data["variant"] == "keep_right" else "left"
    dropped, _, changed = case.curve().without_knot(case["r"], keep)
    integers, knots, rows = of_spline(dropped)
    return integers, [*knots, *changed], rows


def golden_forced(case):
    integers, knots, rows = golden_spline(case, "p", "U_out", "P_out")
    return integers, [*knots, *case["changed"]], rows


def product(case):
    factor = Spline(case.space("q", "V"), case["a"])
    found = case.curve() * factor
    assert not case.exact or found == factor * case.curve()
    return of_spline(found)


def antiderivative(case):
    f, start = case.curve(), case["start"]
    return of_spline(f.antiderivative() + (start if f.dimension > 1 else start[0]))


def gram(case):
    matrix = case.space().gram(case.space("p2", "U2"), case["k"], case["k2"], a=case["a"], b=case["b"])
    return [], [], matrix.tolist()


def nurbs_basis_ders(case):
    one = Rational(case.space(), [1] * len(case["w"]), case["w"])
    rows = one.basis_derivatives(case["u"], case["K"])
    return [first + one.degree for first, _ in rows], [], [list(row) for _, row in rows]


def nurbs_surface_ders(case):
    surface = RationalSurface(case.space(), case.space("q", "V"), case["P"], case["w"])
    found = surface.derivatives_at(case["u"], case["v"], case["K"])
    return [], [], found.reshape(-1, surface.dimension).tolist()


def knot_insertion_rational(case):
    f = case.nurbs().inserted(case["insert"])
    return [f.degree], f.space.knots.tolist(), [*f.points.tolist(), f.weights.tolist()]


def rows_of(found):
    return [], [], [np.atleast_1d(row).tolist() for row in found]


def golden_rows(key):
    return lambda case: ([], [], case[key])


CATEGORIES = {
    # Name: how many cases, the factor over floats, what is found, what is expected, the size.
    "basis": (22, 4, basis, lambda c: ([c["span"]] + [c["span"] - c["p"]] * len(c["ders"]), c["U"], c["ders"]), basis_size),
    "curve_ders": (3, 4, lambda c: rows_of(c.curve().derivatives_at(c["u"], c["K"])), golden_rows("ders"), curve_size),
    "hodograph": (3, 4, lambda c: of_spline(c.curve().derivative()), lambda c: golden_spline(c, "p_out", "U_out", "P_out"), None),
    "knot_insertion": (8, 4, lambda c: of_spline(c.curve().inserted(c["insert"])), lambda c: golden_spline(c, "p", "U_out", "P_out"), None),
    "degree_elevation": (6, 4, lambda c: of_spline(c.curve().elevated(c["t"])), lambda c: golden_spline(c, "p_out", "U_out", "P_out"), None),
    "degree_reduction": (7, 16, degree_reduction, golden_reduction, None),
    "knot_removal": (
        3,
        16,
        knot_removal,
        lambda c: ([c["p"], len(c["P_out"]), c["max_removable"]], c["U_out"], c["P_out"]),
        None,
    ),
    "knot_removal_forced": (5, 16, knot_removal_forced, golden_forced, None),
    "product": (7, 8, product, lambda c: golden_spline(c, "degree", "W", "Q"), None),
    "antiderivative": (5, 4, antiderivative, lambda c: golden_spline(c, "p_out", "U_out", "P_out"), None),
    "definite_integral": (
        10,
        4,
        lambda c: rows_of([c.curve().integral(c["a"], c["b"])]),
        lambda c: ([], [], [c["value"]]),
        integral_size,
    ),
    "gram": (9, 8, gram, golden_rows("matrix"), None),
    "nurbs_ders": (6, 8, lambda c: rows_of(c.nurbs().derivatives_at(c["u"], c["K"])), golden_rows("ders"), nurbs_size),
    "nurbs_basis_ders": (
        5,
        8,
        nurbs_basis_ders,
        lambda c: ([c["span"]] * len(c["ders"]), [], c["ders"]),
        nurbs_basis_size,
    ),
    "nurbs_surface_ders": (
        2,
        8,
        nurbs_surface_ders,
        lambda c: ([], [], [row for rows in c["ders"] for row in rows]),
        nurbs_surface_size,
    ),
    "knot_insertion_rational": (
        1,
        4,
        knot_insertion_rational,
        lambda c: ([c["p"]], c["U_out"], [*c["P_out"], c["w_out"]]),
        None,
    ),
}


def cases():
    return [(name, data) for name in CATEGORIES for data in GOLDEN.get(name, [])]


@pytest.mark.parametrize(("name", "data"), cases(), ids=lambda value: value if isinstance(value, str) else value["id"])
def test_case(name, data):
    _, factor, found, expected, size = CATEGORIES[name]
    exact, inexact = Case(data, True), Case(data, False)
    truth = expected(exact)
    assert found(exact) == truth

    integers, knots, rows = found(inexact)
    assert integers == truth[0] and knots == [float(t) for t in truth[1]] and len(rows) == len(truth[2])
    for k, (row, right) in enumerate(zip(rows, truth[2])):
        assert len(row) == len(right) and all(isinstance(x, float) for x in row)
        allowed = factor * EPSILON * (size(exact, truth[2], k) if size else largest(*(x for r in truth[2] for x in r)))
        for x, q in zip(row, right):
            assert abs(Fraction(x) - q) <= allowed


def test_every_case_is_counted():
    assert {name: len(GOLDEN[name]) for name in CATEGORIES} == {name: entry[0] for name, entry in CATEGORIES.items()}
    assert len(cases()) == 102
