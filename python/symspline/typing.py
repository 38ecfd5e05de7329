"""Names for what the methods of this package take and give, for annotations."""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any, Literal, Union

import numpy as np
from numpy.typing import NDArray

#: An exact number, or a float.
Number = Union[Fraction, float]
#: What is taken for a number: whole numbers and fractions are exact.
NumberLike = Union[int, Fraction, float, np.generic]
#: An array of ``float64``, or of fractions as objects.
Array = NDArray[Any]
#: An array, or numbers in lists in lists.
ArrayLike = Union[NumberLike, NDArray[Any], Sequence[Any]]
#: A direction of a surface.
Direction = Literal["u", "v", 0, 1]
#: How smooth a spline of a reduced degree is: see ``Space.reduced``.
Continuity = Union[Literal["kept", "breaks"], int]
#: How many derivatives are kept at the ends, the value counting as the first.
Contact = Union[int, tuple[int, int]]
