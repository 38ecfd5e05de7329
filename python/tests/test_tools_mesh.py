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


def test_springs_are_watched():
    alpha = np.ones(12)
    alpha[0] = 2.0
    told = []
    tuned = DooSabin(CUBE).fine_tuned(alpha, watch=lambda *progress: told.append(progress))
    assert tuned == DooSabin(CUBE).fine_tuned(alpha)
    steps, energies, gradients = zip(*told)
    assert list(steps) == list(range(len(told))) and len(told) in (tuned.iterations, tuned.iterations + 1)
    assert energies[0] == pytest.approx(tuned.energy_before) and energies[-1] < energies[0]
    assert min(gradients) > 0
    stopped = DooSabin(CUBE).fine_tuned(alpha, watch=lambda step, energy, gradient: step >= 2)
    assert stopped.iterations == 2 and not stopped.converged and tuned.energy < stopped.energy < stopped.energy_before


def test_exceptions_of_who_watches_come_out_as_they_are():
    alpha = np.full(12, 1.5)
    wrong, calls = KeyError("mine"), []

    def refuse(step, energy, gradient):
        calls.append(step)
        if step == 1:
            raise wrong

    with pytest.raises(KeyError) as caught:
        DooSabin(CUBE).fine_tuned(np.tile([1.0, 2.0], 6), watch=refuse)
    assert caught.value is wrong and calls == [0, 1]
    with pytest.raises(TypeError):
        DooSabin(CUBE).fine_tuned(alpha, watch=lambda: None)
    with pytest.raises(SymsplineError):
        DooSabin(CUBE).fine_tuned(alpha[1:], watch=refuse)


FAN = [[0, 1, 4, 2], [0, 2, 5, 3], [0, 3, 6, 1], [4, 1, 7]]


@pytest.mark.parametrize("faces", [FACES, FAN], ids=["cube", "with a boundary"])
def test_neighbours_by_the_lists_of_faces(faces):
    mesh = Mesh([[k, k * k % 7, Fraction(k % 3, 2)] for k in range(8)], faces)
    sides = [list(zip(face, face[1:] + face[:1])) for face in faces]
    starts = np.cumsum([0, *map(len, faces)])
    edges = [frozenset(edge) for edge in mesh.edges]
    for f, face in enumerate(faces):
        assert [edges[e] for e in mesh.edges_of(f)] == [frozenset(side) for side in sides[f]]
        assert list(mesh.centroid(f)) == [sum(column) / len(face) for column in zip(*(mesh.points[v] for v in face))]
    for v in range(8):
        around = mesh.faces_at(v)
        assert sorted(around) == [f for f, face in enumerate(faces) if v in face]
        assert mesh.corners_at(v) == [starts[f] + faces[f].index(v) for f in around]
        assert {e for e, ends in enumerate(edges) if v in ends} == set(mesh.edges_at(v)) and len(mesh.edges_at(v)) == mesh.valences[v]
        # Counter-clockwise: the side that comes into a face is the one that leaves the next.
        for f, g in zip(around, around[1:]):
            before = faces[f][faces[f].index(v) - 1]
            assert (v, before) in sides[g]
        assert [edges[e] for e in mesh.edges_at(v)][: len(around)] == [frozenset(next(s for s in sides[f] if s[0] == v)) for f in around]
    for e, (a, b) in enumerate(mesh.edges):
        beside = mesh.faces_beside(e)
        assert (a, b) in sides[beside[0]] and all((b, a) in sides[f] for f in beside[1:])
        assert sorted(beside) == [f for f in range(len(faces)) if (a, b) in sides[f] or (b, a) in sides[f]]


def test_boundaries_are_chains_of_vertices():
    assert CUBE.boundaries == []
    mesh = Mesh([[k, k * k % 7, k % 3] for k in range(8)], FAN)
    (chain,) = mesh.boundaries
    sides = {(a, b) for face in FAN for a, b in zip(face, face[1:] + face[:1])}
    alone = {(a, b) for a, b in sides if (b, a) not in sides}
    assert set(zip(chain, chain[1:] + chain[:1])) == alone and len(chain) == len(alone)
    ring = Mesh([[k, k * k % 7, k % 3] for k in range(8)], [[k, (k + 1) % 4, (k + 1) % 4 + 4, k + 4] for k in range(4)])
    assert sorted(map(len, ring.boundaries)) == [4, 4] and sorted(sum(ring.boundaries, [])) == list(range(8))


def test_indices_beyond_are_refused():
    for call, index in [(CUBE.edges_at, 8), (CUBE.faces_at, 8), (CUBE.corners_at, 8), (CUBE.edges_of, 6), (CUBE.faces_beside, 12), (CUBE.centroid, 6)]:
        call(index - 1)
        with pytest.raises(SymsplineError) as caught:
            call(index)
        assert caught.value.kind == "IndexOutOfRange" and caught.value.data == {"index": index, "length": index}


def test_short_intervals_are_raised():
    converted = DooSabin(CUBE).converted()
    least = Fraction(1, 20)
    shown = converted.with_least_interval(least)
    assert 0 in converted.intervals and list(shown.intervals) == [max(x, least) for x in converted.intervals]
    assert shown.mesh == converted.mesh and shown.boundary == converted.boundary
    rounded = CatmullClark(CUBE.to_float(), np.arange(12.0)).with_least_interval(3.5)
    assert list(rounded.intervals) == [max(x, 3.5) for x in range(12)]
    assert CatmullClark(CUBE).with_least_interval(1) == CatmullClark(CUBE)
    with pytest.raises(SymsplineError):
        converted.with_least_interval(float("inf"))


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
