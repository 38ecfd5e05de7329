"""Spaces and splines for laws."""

from fractions import Fraction

from hypothesis import strategies as st
from symspline import Space, Spline, Surface

fractions = st.fractions(min_value=-20, max_value=20, max_denominator=12)
#: Places in the unit interval, ends included.
places = st.fractions(min_value=0, max_value=1, max_denominator=30)


@st.composite
def spaces(draw, least=0, most=4, periodic=False, jumps=True):
    """Clamped spaces on [0, 1] with knots up to full multiplicity (or without jumps), and rings."""
    degree = draw(st.integers(least, most))
    copies = st.integers(1, degree + 1 if jumps else degree)
    inner = draw(st.lists(st.tuples(st.integers(1, 11), copies), max_size=4, unique_by=lambda k: k[0]))
    knots = [Fraction(k, 12) for k, m in sorted(inner) for _ in range(m)]
    if periodic and draw(st.booleans()):
        return Space(degree, [0, *knots], end=1)
    return Space.clamped(degree, [0, *knots, 1])


@st.composite
def splines(draw, dim=None, **kinds):
    """Functions (dim 1) and curves in the given dimension, or any."""
    space = draw(spaces(**kinds))
    dim = draw(st.integers(1, 3)) if dim is None else dim
    point = fractions if dim == 1 else st.lists(fractions, min_size=dim, max_size=dim)
    return Spline(space, draw(st.lists(point, min_size=space.dim, max_size=space.dim)))


@st.composite
def surfaces(draw, dim=3, most=2):
    """Surfaces in the given dimension."""
    u, v = draw(spaces(most=most)), draw(spaces(most=most))
    numbers = draw(st.lists(fractions, min_size=u.dim * v.dim * dim, max_size=u.dim * v.dim * dim))
    points = numbers if dim == 1 else [numbers[k : k + dim] for k in range(0, len(numbers), dim)]
    return Surface(u, v, [points[i * v.dim : (i + 1) * v.dim] for i in range(u.dim)])
