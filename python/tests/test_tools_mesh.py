"""Meshes and subdivision."""

from fractions import Fraction

import numpy as np
import pytest
from symspline import Mesh, Space, Spline, Surface, SymsplineError
from symspline.mesh import CatmullClark, ControlPolygon, DooSabin, mesh_from_obj, mesh_to_obj

CORNERS = [[k & 1, k >> 1 & 1, k >> 2] for k in range(8)]
FACES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]]
CUBE = Mesh(CORNERS, FACES)


def test_counts():
    assert (CUBE.vertex_count, CUBE.edge_count, CUBE.face_count) == (8, 12, 6)
    assert CUBE.is_closed and CUBE.euler_characteristic == 2
    assert CUBE.edges[CUBE.edge_between(0, 1)] in [(0, 1), (1, 0)]
    assert CUBE.points.dtype == object and CUBE.to_float().points.dtype == np.float64
    with pytest.raises(SymsplineError):
        Mesh(CORNERS, [*FACES, [0, 1, 9]])
    with pytest.raises(SymsplineError):
        CUBE.edge_between(0, 8)


@pytest.mark.parametrize("rule", [CatmullClark, DooSabin])
def test_subdivision_keeps_the_topology(rule):
    fine = rule(CUBE).refined(2).mesh
    assert fine.is_closed and fine.euler_characteristic == 2 and fine.vertex_count > 50
    assert rule(CUBE).refined(0) == rule(CUBE)


def test_limit_points_stay_where_they_are():
    surface = CatmullClark(CUBE)
    limits = surface.limit_points()
    # The old vertices come first, and the surface is the same.
    for before, after in zip(limits, surface.refined(2).limit_points()):
        assert list(before) == list(after)
    # All eight are at the same distance from the centre, by symmetry.
    centre = np.array([Fraction(1, 2)] * 3)
    assert len({sum((p - centre) ** 2) for p in limits}) == 1
    normals = CatmullClark(CUBE.to_float()).limit_normals()
    for corner, normal in zip(CORNERS, normals):
        outward = (np.array(corner) - 0.5) / np.linalg.norm(np.array(corner) - 0.5)
        assert np.allclose(normal, outward)


def test_on_a_grid_the_rule_is_that_of_splines():
    points = [[k // 3, k % 3, k * k % 5] for k in range(9)]
    mesh = Mesh(points, [[0, 3, 4, 1], [1, 4, 5, 2], [3, 6, 7, 4], [4, 7, 8, 5]])
    surface = DooSabin(mesh, boundary="smooth")
    line = Space(2, [0, 0, 0, 1, 1, 1])
    spline = Surface(line, line, np.array(mesh.points).reshape(3, 3, 3))
    assert list(surface.limit_points()[3]) == list(spline(1, 1))
    assert list(surface.converted().mesh.points[0]) == list(mesh.points[0])


def test_springs_come_to_rest():
    alpha = np.ones(12)
    alpha[0] = 2.0
    tuned = DooSabin(CUBE).fine_tuned(alpha, fixed=[6])
    assert tuned.converged and tuned.energy < tuned.energy_before
    assert tuned.energy == pytest.approx(sum(tuned.terms))
    unchanged = DooSabin(CUBE).fine_tuned(np.ones(12))
    assert np.allclose(unchanged.surface.mesh.points, unchanged.invariant.mesh.points, atol=1e-6)
    with pytest.raises(SymsplineError, match="stretchy"):
        DooSabin(CUBE).fine_tuned(alpha, stretchy=1.0)


def test_chaikin_is_bisection():
    polygon = ControlPolygon([[0, 0], [4, 0], [4, 4]])
    assert list(polygon.refined().points[0]) == [1, 0]
    curve = polygon.curve()
    fine = polygon.refined(3)
    knots = fine.curve().space.knots
    assert len(fine.points) == 24 and polygon.is_closed
    for joint in fine.joints():
        assert any(list(curve(Fraction(k, 8))) == list(joint) for k in range(int(8 * knots[2]), 8 * 3 + 1))
    cubic = polygon.converted()
    assert cubic.degree == 3
    assert list(cubic.curve()(1)) == list(curve(1))


def test_meshes_have_no_arithmetic():
    f = Spline(Space.bezier(1), [1, 2])
    for make in (lambda: f + CUBE, lambda: CUBE * f, lambda: f.cross(CUBE)):
        with pytest.raises(SymsplineError) as caught:
            make()
        assert caught.value.kind == "NoSuch" and caught.value.data["operation"]


def test_obj_text():
    text = mesh_to_obj(CUBE)
    again = mesh_from_obj(text)
    assert np.array_equal(again.points, CUBE.to_float().points) and again.faces == CUBE.faces
    with pytest.raises(SymsplineError) as caught:
        mesh_from_obj("v 0 0 0\nv 1 0 nan\n")
    assert "2" in str(caught.value)
