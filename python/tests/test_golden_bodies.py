"""Golden values of elastic bodies and subdivision: equal over fractions, within roundings over floats."""

from fractions import Fraction

import numpy as np
from golden_cases import curve_of, flat, golden
from symspline import Mesh, Space, Spline, Surface
from symspline.deform import Elastic, Material
from symspline.mesh import CatmullClark, ControlPolygon, DooSabin, loop_lengths


def material_of(case, coeffs=None):
    coeffs = coeffs or case
    return Material(coeffs["alpha"], coeffs["beta"], coeffs["gamma"])


@golden("vassilev_matrices", 4)
def test_vassilev_matrices(case):
    space, zero = Space(case["p"], case["U"]), case.number(Fraction(0))
    for k in range(3):
        case.key(Material.of_orders([zero] * k + [zero + 1]).matrix(space), f"K{k}")


@golden("vassilev_segment", 1)
def test_vassilev_segment(case):
    p, h, zero = case["p"], case["h"], case.number(Fraction(0))
    space = Space(p, [i * h for i in range(2 * p + 2)])
    for k in range(3):
        case.key(Material.of_orders([zero] * k + [zero + 1]).matrix(space), f"K{k}s")


@golden("vassilev_move", 3)
def test_vassilev_move(case):
    curve, at = curve_of(case, "p"), case["u_f"]
    body = Elastic(curve, material_of(case), case["window"])
    pull = body.pull(curve, at)
    indices, response = pull.response
    assert indices == case["window"] == body.moving[0]
    case.key(response, "V_c", 4096)
    moved, force = pull.moved_to(curve, case["target"])
    case.key(force, "force", 4096)
    case.key(moved.coeffs, "P_out")


@golden("vassilev_forces", 1)
def test_vassilev_forces(case):
    space, zero = Space(case["p"], case["U"]), case.number(Fraction(0))
    curve = Spline(space, [[zero, zero]] * space.dim)
    body = Elastic(curve, material_of(case), case["window"])
    places, moves = body.displacements(curve, at_breaks=case["dF"])
    assert places == case["window"]
    case.key(moves, "dV", 4096)


@golden("vassilev_surface_move", 2)
def test_vassilev_surface_move(case):
    surface = Surface(Space(case["p"], case["U"]), Space(case["q"], case["V"]), case["P"])
    materials = [material_of(case, case[key]) for key in ["coeff_u", "coeff_v"]]
    body, at = Elastic(surface, materials, [case["window_u"], case["window_v"]]), (case["u_f"], case["v_f"])
    for response, moving, key in zip(body.responses(at), body.moving, ["V_u", "V_v"]):
        case.key(np.array(response)[moving], key, 4096)
    moved, force = body.pull(surface, at).moved_to(surface, case["target"])
    case.key(force, "force", 4096)
    case.key(moved.coeffs, "P_out")


@golden("face_rules", 3)
def test_face_rules(case):
    n = case["n"]
    # The face at one end of a prism, whose other vertices do not matter.
    sides = [[(i + 1) % n, i, n + i, n + (i + 1) % n] for i in range(n)]
    faces = [list(range(n)), *sides, list(range(2 * n - 1, n - 1, -1))]
    rest = [[case.number(Fraction(x)) for x in (i, i * i, 7)] for i in range(n)]
    surface = DooSabin(Mesh(case["polygon"] + rest, faces))
    case.key(surface.refined().mesh.points[:n], "doo_sabin")
    case.key(surface.converted().mesh.points[:n], "convert")
    case.key(surface.limit_points()[0], "centroid")


@golden("chaikin_closed", 1)
def test_chaikin_closed(case):
    case.key(ControlPolygon(case["polygon"]).refined().points, "out")


@golden("valence3_limit", 1)
def test_valence3_limit(case):
    faces = [[0, 1, 4, 2], [0, 2, 5, 3], [0, 3, 6, 1], [1, 6, 7, 4], [2, 4, 7, 5], [3, 5, 7, 6]]
    points = case["P"] + [[case.number(Fraction(x)) for x in (100, -50, 30)]]
    surface = DooSabin(Mesh(points, faces))
    triangle = 6 + 12
    case.key(surface.refined().limit_points()[triangle], "doo_sabin_limit")
    converted = surface.converted()
    centre = converted.mesh.vertex_count + converted.mesh.edge_count + triangle
    case.key(converted.refined().limit_points()[centre], "nurccs_limit")


@golden("nonuniform_cubic_midpoint", 1)
def test_nonuniform_cubic_midpoint(case):
    one = case.number(Fraction(1))
    polygon = ControlPolygon(case["P"], 3, intervals=[one, *case["intervals"], one], boundary="open")
    case.key(polygon.refined().points[2:7:2], "edge_points")


@golden("nurccs_grid", 3)
def test_nurccs_grid(case):
    n = 5
    points = [[*p, case.number(Fraction(0))] for row in case["P"] for p in row]
    faces = [[v, v + n, v + n + 1, v + 1] for i in range(n - 1) for j in range(n - 1) for v in [i * n + j]]
    mesh = Mesh(points, faces)
    e, f = case["e"], case["f"]
    intervals = [f[min(v, w) % n] if v // n == w // n else e[min(v, w) // n] for v, w in mesh.edges]
    fine = CatmullClark(mesh, intervals).refined().mesh.points[:, :2]
    v, edges = 2 * n + 2, mesh.vertex_count
    case.key(fine[v], "vertex")
    for w, key in [(v - n, "u_minus"), (v + n, "u_plus"), (v - 1, "v_minus"), (v + 1, "v_plus")]:
        case.key(fine[edges + mesh.edge_between(v, w)], f"edge_{key}")
    first = mesh.vertex_count + mesh.edge_count
    places = [first + i * (n - 1) + j for i, j in [(1, 1), (2, 1), (2, 2), (1, 2)]]
    case.key(fine[places], "faces")


@golden("conversion_topology", 2)
def test_conversion_topology(case):
    faces, zero = case["faces"], case.number(Fraction(0))
    converted = DooSabin(Mesh([[zero] * 3] * (1 + max(flat(faces))), faces)).converted()
    mesh, intervals = converted.mesh, list(converted.intervals)
    assert [mesh.vertex_count, mesh.edge_count, mesh.face_count] == [case[k] for k in ["V_out", "E_out", "F_out"]]
    assert intervals.count(0) == case["zero_interval_edges"]
    assert intervals.count(1) == case["unit_interval_edges"]
    assert sorted(loop_lengths(mesh)) == case["loop_lengths"]
    assert sum(mesh.valences) == case["m2"]
