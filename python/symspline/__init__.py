"""Exact spline algebra, fine tuning and shape tools for curves and surfaces."""

from ._symspline import (
    Extremum,
    Rational,
    RationalSurface,
    Space,
    Spline,
    Surface,
    SymsplineError,
    __version__,
)

__all__ = [
    "Extremum",
    "Rational",
    "RationalSurface",
    "Space",
    "Spline",
    "Surface",
    "SymsplineError",
    "__version__",
]
