"""Files: what is written is read again."""

from fractions import Fraction

import numpy as np
import pytest
from symspline import Mesh, Rational, RationalSurface, Space, Spline, Surface, SymsplineError
from symspline.files import dumps, formats, loads, read, write

LINE = Space(1, [0, 0, Fraction(1, 3), Fraction(1, 3)])
SHAPES = {
    "C": Spline(LINE, [[0, 0], [1, 2]]),
    "f": Spline(LINE, [0.5, 0.25]),
    "S": Surface(LINE, LINE, [[[0, 0, 0], [0, 1, 2]], [[1, 0, 3], [1, 1, 4]]]),
    "R": Rational(LINE, [[0, 0], [1, 2]], [1, Fraction(2, 3)]),
    "T": RationalSurface(LINE, LINE, [[[0, 0], [0, 1]], [[1, 0], [1, 1]]], [[1, 2], [3, 4]]),
    "M": Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]),
    "x": Fraction(2, 7),
}


def test_all_kinds(tmp_path):
    path = tmp_path / "shapes.json"
    write(path, SHAPES)
    assert dict(read(path)) == SHAPES
    ((name, curve),) = loads(dumps(SHAPES["C"]).decode())
    assert name is None and curve == SHAPES["C"]
    assert [value for _, value in loads(dumps([SHAPES["C"], SHAPES["M"]]))] == [SHAPES["C"], SHAPES["M"]]
    assert ("json", True, True) in formats()


def test_points_are_values():
    ((_, point),) = loads(dumps({"p": [1, Fraction(1, 2), 3]}))
    assert list(point) == [1, Fraction(1, 2), 3]
    assert np.array_equal(loads(dumps({"p": np.array([1.0, 2.0])}))[0][1], [1.0, 2.0])


def test_errors_name_the_file_and_the_place(tmp_path):
    path = tmp_path / "broken.json"
    path.write_text('{"format": "symspline",\n "version": 1, "items": [}')
    with pytest.raises(SymsplineError) as caught:
        read(path)
    assert caught.value.kind == "File" and str(path) in caught.value.data["file"]
    assert "2" in caught.value.data["place"]
    with pytest.raises(SymsplineError, match="json"):
        read(tmp_path / "shapes.unknown")
    with pytest.raises(SymsplineError):
        read(tmp_path / "missing.json")
