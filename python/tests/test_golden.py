"""The golden values of `tests/golden/cases.json`, as `tests/golden/*.rs` check them, through this package.

Over fractions everything must be equal. Over floats indices and knots must be equal, and numbers may be off by
``factor * eps * size``, with the size of the largest number of the answer or, for derivatives, of what they are made of.
"""

import math
from fractions import Fraction

import numpy as np
import pytest
from golden_cases import CASES, NUMBERS, RUN, Case, curve_of, nurbs_of, space_of
from symspline import Rational, RationalSurface, Space, Spline, SymsplineError

EPSILON = float(np.finfo(float).eps)


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
    space = space_of(case)
    rows = space.basis_derivatives(case["u"], case["K"])
    assert list(space.basis(case["u"])[1]) == list(rows[0][1])
    return [space.locate(case["u"]), *(first for first, _ in rows)], space.knots.tolist(), [list(row) for _, row in rows]


def degree_reduction(case):
    lowered, bound = curve_of(case, "p").degree_lowered(case["t"])
    integers, knots, rows = of_spline(lowered)
    if case.is_exact:
        try:
            assert curve_of(case, "p").degree_reduced_exactly(case["t"]) == lowered and bound == 0
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
    removed, _ = curve_of(case, "p").removed(case["u"], 10**6, 0 if case.is_exact else 1e-12)
    integers, knots, rows = of_spline(removed)
    return [*integers, curve_of(case, "p").space.dim - removed.space.dim], knots, rows


def knot_removal_forced(case):
    keep = "right" if case.case["variant"] == "keep_right" else "left"
    dropped, _, changed = curve_of(case, "p").without_knot(case["r"], keep)
    integers, knots, rows = of_spline(dropped)
    return integers, [*knots, *changed], rows


def golden_forced(case):
    integers, knots, rows = golden_spline(case, "p", "U_out", "P_out")
    return integers, [*knots, *case["changed"]], rows


def product(case):
    factor = Spline(space_of(case, "q", "V"), case["a"])
    found = curve_of(case, "p") * factor
    assert not case.is_exact or found == factor * curve_of(case, "p")
    return of_spline(found)


def antiderivative(case):
    f, start = curve_of(case, "p"), case["start"]
    return of_spline(f.antiderivative() + (start if f.dimension > 1 else start[0]))


def gram(case):
    matrix = space_of(case).gram(space_of(case, "p2", "U2"), case["k"], case["k2"], a=case["a"], b=case["b"])
    return [], [], matrix.tolist()


def nurbs_basis_ders(case):
    one = Rational(space_of(case), [1] * len(case["w"]), case["w"])
    rows = one.basis_derivatives(case["u"], case["K"])
    return [first + one.degree for first, _ in rows], [], [list(row) for _, row in rows]


def nurbs_surface_ders(case):
    surface = RationalSurface(space_of(case), space_of(case, "q", "V"), case["P"], case["w"])
    found = surface.derivatives_at(case["u"], case["v"], case["K"])
    return [], [], found.reshape(-1, surface.dimension).tolist()


def knot_insertion_rational(case):
    f = nurbs_of(case).inserted(case["insert"])
    return [f.degree], f.space.knots.tolist(), [*f.points.tolist(), f.weights.tolist()]


def rows_of(found):
    return [], [], [np.atleast_1d(row).tolist() for row in found]


def golden_rows(key):
    return lambda case: ([], [], case[key])


CATEGORIES = {
    # Name: how many cases, the factor over floats, what is found, what is expected, the size.
    "basis": (22, 4, basis, lambda c: ([c["span"]] + [c["span"] - c["p"]] * len(c["ders"]), c["U"], c["ders"]), basis_size),
    "curve_ders": (3, 4, lambda c: rows_of(curve_of(c, "p").derivatives_at(c["u"], c["K"])), golden_rows("ders"), curve_size),
    "hodograph": (3, 4, lambda c: of_spline(curve_of(c, "p").derivative()), lambda c: golden_spline(c, "p_out", "U_out", "P_out"), None),
    "knot_insertion": (8, 4, lambda c: of_spline(curve_of(c, "p").inserted(c["insert"])), lambda c: golden_spline(c, "p", "U_out", "P_out"), None),
    "degree_elevation": (6, 4, lambda c: of_spline(curve_of(c, "p").elevate(c["t"])), lambda c: golden_spline(c, "p_out", "U_out", "P_out"), None),
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
        lambda c: rows_of([curve_of(c, "p").integral(c["a"], c["b"])]),
        lambda c: ([], [], [c["value"]]),
        integral_size,
    ),
    "gram": (9, 8, gram, golden_rows("matrix"), None),
    "nurbs_ders": (6, 8, lambda c: rows_of(nurbs_of(c).derivatives_at(c["u"], c["K"])), golden_rows("ders"), nurbs_size),
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


RUN.update({name: (entry[0], tuple(NUMBERS)) for name, entry in CATEGORIES.items()})


def cases():
    return [(name, data) for name, entry in CATEGORIES.items() for data in CASES[name][: entry[0]]]


@pytest.mark.parametrize(("name", "data"), cases(), ids=lambda value: value if isinstance(value, str) else value["id"])
def test_case(name, data):
    _, factor, found, expected, size = CATEGORIES[name]
    exact, inexact = (Case(data, number) for number in NUMBERS.values())
    truth = expected(exact)
    assert found(exact) == truth

    integers, knots, rows = found(inexact)
    assert integers == truth[0] and knots == [float(t) for t in truth[1]] and len(rows) == len(truth[2])
    for k, (row, right) in enumerate(zip(rows, truth[2])):
        assert len(row) == len(right) and all(isinstance(x, float) for x in row)
        allowed = factor * EPSILON * (size(exact, truth[2], k) if size else largest(*(x for r in truth[2] for x in r)))
        for x, q in zip(row, right):
            assert abs(Fraction(x) - q) <= allowed
