"""The golden cases of the library, `tests/golden/cases.json`, over fractions and over floats."""

import json
import re
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from symspline import Rational, Space, Spline

FILE = Path(__file__).resolve().parents[2] / "tests" / "golden" / "cases.json"
CASES = json.loads(FILE.read_text(encoding="utf-8"))["cases"]
#: The categories that tests run: how many cases each has, and the fields they are run over.
RUN = {}
NUMBER = re.compile(r"-?\d+(/\d+)?\Z")
NUMBERS = {"exact": Fraction, "float": float}
TEXTS = {"id", "note", "norm", "regime", "name", "variant"}


def read(value, number):
    """The JSON value with its texts of numbers as numbers."""
    if isinstance(value, str) and NUMBER.match(value):
        return number(Fraction(value))
    if isinstance(value, list):
        return [read(x, number) for x in value]
    if isinstance(value, dict):
        return {key: x if key in TEXTS else read(x, number) for key, x in value.items()}
    return value


def golden(category, count, *, fields=("exact", "float")):
    """Runs a test on every case of a category, of which there are `count`, over both fields."""
    cases = CASES[category]
    assert len(cases) == count and category not in RUN, category
    RUN[category] = count, fields
    rows = [pytest.param(Case(case, NUMBERS[field]), id=f"{case['id']}-{field}") for case in cases for field in fields]
    return pytest.mark.parametrize("case", rows)


class Case:
    """A case: what is given in the field of the test, and what is expected."""

    def __init__(self, case, number):
        self.case, self.number = case, number
        self.is_exact = number is Fraction

    def __getitem__(self, key):
        return read(self.case[key], self.number)

    def has(self, key):
        return self.case.get(key) is not None

    def check(self, found, expected, factor=256, size=None):
        """Equal over fractions; over floats within a number of roundings of the largest number (or of `size`)."""
        found, expected = flat(found), flat(read(expected, Fraction))
        assert len(found) == len(expected)
        if self.is_exact:
            assert found == expected
            assert all(isinstance(x, Fraction) for x in found)
            return
        size = size or max((abs(float(x)) for x in expected), default=0.0)
        allowed = factor * np.finfo(float).eps * size
        for x, y in zip(found, expected):
            assert abs(Fraction(float(x)) - y) <= allowed, (x, float(y))

    def key(self, found, key, factor=256, size=None):
        self.check(found, self.case[key], factor, size)


def flat(value):
    """All numbers in lists in lists."""
    if isinstance(value, (list, tuple, np.ndarray)):
        return [x for inner in value for x in flat(inner)]
    return [value]


def space_of(case, degree="p", knots="U"):
    return Space(case[degree], case[knots])


def curve_of(case, degree="n"):
    return Spline(space_of(case, degree), case["P"])


def function_of(case, coeffs="alpha"):
    return Spline(space_of(case, "q", "V"), case[coeffs])


def nurbs_of(case):
    return Rational(space_of(case), case["P"], case["w"])


def check_spline(case, spline, degree, knots, coeffs, factor=256):
    assert spline.space.degree == case[degree]
    case.key(spline.space.knots, knots, 1)
    case.key(spline.coeffs, coeffs, factor)
