"""Golden values of control points, weights, constraints: equal over fractions, within roundings over floats."""

from fractions import Fraction

import numpy as np
import pytest
from golden_cases import golden, nurbs_of
from symspline import Rational, RationalSurface, Space, Spline, Surface, SymsplineError
from symspline.shape import (
    Constraints,
    Drag,
    WeightPairPull,
    WeightPull,
    control_points,
    halfway_knot,
    leg_point,
    node_placing_knot,
    nodes_around,
    weight_derivatives,
)


@golden("node_placing", 5)
def test_node_placing(case):
    space = Space(case["p"], case["U"])
    assert nodes_around(space, case["u_bar"])[0] == case["k"]
    try:
        case.check(node_placing_knot(space, case["u_bar"]), case.case["u_hat"], size=1.0)
    except SymsplineError as error:
        assert error.kind == "KnotThere"
        assert case["u_hat"] in list(space.knots)


@golden("move_one_control", 4)
def test_move_one_control(case):
    curve, u = nurbs_of(case), case["u_bar"]
    drag = Drag(curve, u)
    assert drag == Drag(curve, u, index=case["k"])
    moved = drag.applied(curve, np.array(case["target"]) - curve(u))
    case.key(control_points(moved), "P_out")


@golden("move_two_controls", 8)
def test_move_two_controls(case):
    curve, u = nurbs_of(case), case["u_bar"]
    gamma = None if case["gamma_is_default"] else case["gamma"]
    drag = Drag(curve, u, "neighbours", gamma=gamma)
    if case.is_exact:
        k, gamma = case["k"], case["gamma"]
        assert drag == Drag(curve, u, shares=[(k, 1 - gamma), (k + 1, gamma)])
    moved = drag.applied(curve, np.array(case["target"]) - curve(u))
    case.key(control_points(moved), "P_out")


@golden("inverse_knot_insertion", 2)
def test_inverse_knot_insertion(case):
    knot, finer, place = leg_point(nurbs_of(case), case["k"], case["target"], case.number(Fraction(1, 1 << 30)))
    assert place == case["index_out"]
    case.key(knot, "u_hat")
    case.key(control_points(finer), "P_out")
    case.key(finer.weights, "w_out")


def check_constraints(case, shape, constraints, columns, **wishes):
    held = Constraints(shape, constraints, **wishes)
    case.check(held.rows[:, columns], case.case["B"], size=1e3)
    assert set(held.matrix.indices) <= set(columns)
    matrix = np.full((len(columns), len(constraints)), case.number(Fraction(0)))
    for i, row in zip(held.matrix.indices, held.matrix.matrix):
        matrix[columns.index(i)] = row
    case.check(matrix, case.case["A"], 4096)
    return held


@golden("constraint_curve", 10)
def test_constraint_curve(case):
    space = Space(case["p"], case["U"])
    points = case["P"] if case.has("P") else [[case.number(Fraction(0))] * 2] * space.dim
    curve = Rational(space, points, case["w"]) if case.has("w") else Spline(space, points)
    constraints = [(u, k) for u, k in case["constraints"]]
    if not case.has("A"):
        with pytest.raises(SymsplineError) as caught:
            Constraints(curve, constraints, freeing=case["free"])
        assert caught.value.kind == "Overdetermined"
        return
    held = check_constraints(case, curve, constraints, case["free"], freeing=case["free"])
    if case.has("P_out"):
        case.key(control_points(held.dragged(curve, case["dD"])), "P_out")


@golden("constraint_surface", 3)
def test_constraint_surface(case):
    u, v = Space(case["p"], case["U"]), Space(case["q"], case["V"])
    shape = RationalSurface(u, v, case["P"], case["w"]) if case.has("w") else Surface(u, v, case["P"])
    columns = [(s % u.dim) * v.dim + s // u.dim for s in case["CpInd"]]
    constraints = [((x, y), (k, m)) for x, y, k, m in case["constraints"]]
    fixed = [tuple(index) for index in case["fixed"]]
    held = check_constraints(case, shape, constraints, columns, holding=fixed)
    case.key(control_points(held.dragged(shape, case["dD"])), "P_out")


@golden("fowler", 6)
def test_fowler(case):
    rows, zero = case["F"], case.number(Fraction(0))
    count = len(rows[0])
    space = Space(count - 1, [zero] * count + [zero + 1] * count)
    curve = Spline(space, [[zero, zero]] * count)
    held = Constraints(curve, [dict(enumerate(row)) for row in rows])
    case.key(held.dragged(curve, case["b"]).coeffs, "d", 4096)


@golden("weight_one", 6)
def test_weight_one(case):
    curve, u = nurbs_of(case), case["u_bar"]
    pull = WeightPull(curve, u, case["k"])
    case.key(pull.weight_for(case["lam"]), "w_new")
    case.key(pull.share, "R_k")
    case.key(pull.point, "point")
    case.key(pull.applied(curve, case["lam"])(u), "point_new")


@golden("weight_one_distance", 2)
def test_weight_one_distance(case):
    curve, u = nurbs_of(case), case["u_bar"]
    pull, fraction = WeightPull(curve, u, case["k"]), case["signed_d"] / case["PkP"]
    case.key(pull.weight_for(fraction), "w_new")
    case.key(pull.applied(curve, fraction)(u), "point_new")


@golden("weight_surface", 1)
def test_weight_surface(case):
    u, v = Space(case["p"], case["U"]), Space(case["q"], case["V"])
    surface, at = RationalSurface(u, v, case["P"], case["w"]), (case["u"], case["v"])
    pull = WeightPull(surface, at, (case["k"], case["l"]))
    case.key(pull.weight_for(case["lam"]), "w_new")
    case.key(pull.share, "R_kl")
    case.key(pull.applied(surface, case["lam"])(*at), "point_new")


@golden("weight_two", 3)
def test_weight_two(case):
    curve, u, k = nurbs_of(case), case["u_bar"], case["k"]
    pull = WeightPairPull(curve, u, k, k + 1)
    tolerance = 0 if case.is_exact else 1e-9
    case.key(pull.weights_for(case["target"], tolerance), "w_new")
    case.key(pull.coordinates(case["target"], tolerance), "target_bary")
    case.check(pull.shares, [case.case["a_k"], case.case["a_k1"]])
    case.key(pull.base, "R")
    case.key(pull.moved_to(curve, case["target"], tolerance)(u), "target")


@golden("weight_derivatives", 2)
def test_weight_derivatives(case):
    found = weight_derivatives(nurbs_of(case), case["u"], case["k"], len(case["ders"]))
    case.key(found[1:], "ders")


@golden("halfway_knot", 6)
def test_halfway_knot(case):
    space = Space(case["p"], case["U"])
    knot, regime, leg = halfway_knot(space, case["u_bar"])
    case.key(knot, "u_hat")
    assert regime == case["regime"]
    assert [leg, leg + 1] == case["leg"]
    assert nodes_around(space, case["u_bar"])[1] == case["k"]
