from fractions import Fraction

import numpy as np
import pytest
from symspline import Space, Spline, SymsplineError


def test_whole_numbers_are_exact():
    curve = Spline(Space(2, [0, 0, 0, 1, 1, 1]), [[0, 0], [1, 2], [2, 0]])
    assert list(curve(Fraction(1, 3))) == [Fraction(2, 3), Fraction(8, 9)]
    assert curve(0.5).dtype == np.float64


def test_errors_have_kind_and_data():
    curve = Spline(Space(1, [0, 0, 1, 1]), [0, 1])
    with pytest.raises(SymsplineError) as caught:
        curve(2)
    assert caught.value.kind == "OutsideDomain"
    assert caught.value.data == {"parameter": "2", "start": "0", "end": "1"}
