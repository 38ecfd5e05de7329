"""Names for what this package takes and gives, for annotations."""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any, Literal, Union

import numpy as np
from numpy.typing import NDArray

from ._symspline import Rational, RationalSurface, Space, Spline, Surface

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
#: A shape of any kind.
Shape = Union[Spline, Surface, Rational, RationalSurface]
#: A shape of one parameter.
Curve = Union[Spline, Rational]
#: A shape of two parameters.
AnySurface = Union[Surface, RationalSurface]
#: The name of a control point, or an order of derivatives: of surfaces a pair.
Index = Union[int, tuple[int, int]]
#: A space of scale functions, of surfaces one for each direction.
Scales = Union[Space, tuple[Space, Space]]
#: An array of floats.
Floats = NDArray[np.float64]
#: Two bounds.
Bounds = tuple[float, float]
#: Constraints on a shape: places with orders of derivatives, or weights of control points; of surfaces isocurves and curves too.
ConstraintsLike = Sequence[
    Union[
        tuple[ArrayLike, Index],
        Mapping[int, NumberLike],
        tuple[Literal["isocurve"], Direction, NumberLike],
        tuple[Literal["along"], Spline, int],
    ]
]
