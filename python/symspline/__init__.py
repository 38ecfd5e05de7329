"""Exact spline algebra, fine tuning and shape tools for curves and surfaces."""

from . import analysis, deform, files, fine_tune, mesh, shape
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
from .mesh import Mesh

__all__ = [
    "Extremum",
    "Mesh",
    "Rational",
    "RationalSurface",
    "Space",
    "Spline",
    "Surface",
    "SymsplineError",
    "__version__",
    "analysis",
    "deform",
    "files",
    "fine_tune",
    "mesh",
    "shape",
]
