"""Curves and surfaces as elastic bodies: materials, forces, constraints at least energy, a sculptor."""

from ._symspline import (
    Anchored,
    Elastic,
    FullEnergy,
    Load,
    Material,
    Pull,
    Relaxation,
    Sculptor,
)
