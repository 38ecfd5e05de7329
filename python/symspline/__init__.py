"""Exact spline algebra, fine tuning and shape tools for curves and surfaces."""

from ._symspline import Space, Spline, SymsplineError, __version__

__all__ = ["Space", "Spline", "SymsplineError", "__version__"]
