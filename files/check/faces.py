"""trimesh reads the faces that we write: PLY, STL, glTF and the meshes of OBJ."""

import numpy
import trimesh

from plain import FOLDER, check, done


def loaded(name):
    """The mesh of a file, its z axis up, and the normals of its corners, if it has them."""
    mesh = trimesh.load(FOLDER / name, process=False)
    if isinstance(mesh, trimesh.Scene):
        (node,) = mesh.graph.nodes_geometry
        turn, name_of_mesh = mesh.graph[node]
        mesh = mesh.geometry[name_of_mesh]
        # In glTF y is up.
        mesh.apply_transform(numpy.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]]) @ turn)
    normals = None if name.endswith(("stl", "obj")) else mesh.vertex_normals.copy()
    return mesh, normals


for ending, triangles in (("obj", 12), ("ply", 12), ("stl", 12), ("glb", 12)):
    cube, _ = loaded(f"cube.{ending}")
    cube.merge_vertices(merge_norm=True, merge_tex=True)
    numbers = (len(cube.faces), len(cube.vertices), cube.area, cube.volume, *cube.extents)
    check(cube.is_watertight and numbers == (triangles, 8, 62.0, 30.0, 2.0, 3.0, 5.0), f"cube.{ending}: {numbers}")

# The graph of x² + y² over [-1, 1]², 48 steps either way: how far the corners are from it, and their normals from its own.
for ending, near in (("ply", 1e-14), ("stl", 2.5e-7), ("glb", 2.5e-7)):
    bowl, normals = loaded(f"bowl.{ending}")
    x, y, z = bowl.vertices.T
    off = numpy.abs(x * x + y * y - z).max()
    check(len(bowl.faces) == 2 * 48 * 48 and off <= near, f"bowl.{ending}: {len(bowl.faces)} faces, {off}")
    if normals is not None:
        up = numpy.stack([-2 * x, -2 * y, numpy.ones_like(x)], axis=1)
        up /= numpy.linalg.norm(up, axis=1)[:, None]
        turned = numpy.abs(normals - up).max()
        check(turned <= near, f"bowl.{ending}: normals are off by {turned}")
    # The integral of sqrt(1 + 4 x² + 4 y²): the faces have less, by the square of a step.
    t = (numpy.arange(2000) + 0.5) / 1000 - 1
    area = numpy.sqrt(1 + 4 * (t[:, None] ** 2 + t[None] ** 2)).sum() / 1e6
    check(0 < area - bowl.area < 1e-2, f"bowl.{ending}: {bowl.area}, not {area}")
    print(f"trimesh reads {ending.upper()}: a cube, and {len(bowl.faces)} faces with corners within {off:.0e} of the surface")
done()
