"""Subdivision: meshes with the rules of Doo and Sabin and of Catmull and Clark, and polygons."""

from ._symspline import (
    CatmullClark,
    ControlPolygon,
    DooSabin,
    Mesh,
    RelaxedMesh,
    loop_lengths,
    mesh_from_obj,
    mesh_to_obj,
)
