"""Options of the tools: each does what its words say, over fractions where that can be."""

from fractions import Fraction

import numpy as np
import pytest
from symspline import Mesh, Rational, Space, Spline, Surface, SymsplineError
from symspline.analysis import CurvatureProfile, bend_condition, torsion_at, zeros
from symspline.deform import Elastic, Material, Sculptor
from symspline.fine_tune import NearestScale
from symspline.mesh import CatmullClark, DooSabin
from symspline.shape import (
    Constraints,
    Drag,
    WeightPairPull,
    WeightPull,
    bent,
    flattened,
    warped,
)

SPACE = Space(3, [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4])
POINTS = [[0, 0], [1, 2], [3, 3], [5, 3], [7, 2], [8, 0], [9, 1]]
CURVE = Spline(SPACE, POINTS)
NURBS = Rational(SPACE, POINTS, [1, 2, 1, 3, 1, 1, 1])
LINE = Space(2, [0, 0, 0, 1, 2, 2, 2])
SURFACE = Surface(LINE, LINE, [[[i, j, i * j % 3] for j in range(4)] for i in range(4)])
X = Fraction(7, 5)


def test_shares_and_indices_of_surfaces():
    at, by = (X, Fraction(1, 2)), [1, 2, 3]
    one = Drag(SURFACE, at, index=(1, 2))
    assert one.indices == [1 * 4 + 2] and one.matrix.shape == (1, 1)
    two = Drag(SURFACE, at, shares=[((1, 2), 1), ((2, 1), 3)]).applied(SURFACE, by)
    first, second = two.coeffs[1, 2] - SURFACE.coeffs[1, 2], two.coeffs[2, 1] - SURFACE.coeffs[2, 1]
    assert list(3 * first) == list(second) and list(two(*at)) == list(SURFACE(*at) + np.array(by))
    with pytest.raises(SymsplineError) as caught:
        Drag(SURFACE, X)
    assert caught.value.kind == "Dimensions"


def test_the_share_of_the_second_neighbour():
    drag = Drag(CURVE, X, "neighbours", gamma=Fraction(1, 4))
    (first,), (second,) = drag.matrix
    assert 3 * second == first


def test_a_float_among_the_options_makes_floats():
    assert Drag(CURVE, X, shares=[(2, Fraction(1, 2))]).matrix.dtype == object
    drag = Drag(CURVE, X, shares=[(2, 0.5)])
    assert drag.matrix.dtype == np.float64 and not drag.applied(CURVE, [1, 2]).is_exact
    near = [NearestScale(CURVE, Space.bezier(1, 0, 4), [("coefficient", 0, x)]) for x in (2, 2.0)]
    assert [n.to(Spline(Space.bezier(1, 0, 4), [1, 1])).is_exact for n in near] == [True, False]
    assert isinstance(WeightPull(NURBS, X, 2, within=(1, 4)).weight, Fraction)
    assert isinstance(WeightPull(NURBS, X, 2, within=(1.0, 4.0)).weight, float)


def test_what_cannot_be_met_together():
    wrong = [{0: 1}, {0: 1}]
    with pytest.raises(SymsplineError):
        Constraints(CURVE, wrong).dragged(CURVE, [[0, 0], [2, 0]])
    nearly = Constraints(CURVE, wrong, nearly=True).dragged(CURVE, [[0, 0], [2, 0]])
    assert list(nearly.coeffs[0]) == [1, 0]


def test_relief_gives_freedom():
    short = Spline(Space(1, [0, 0, 1, 1]), [[0, 0], [1, 0]])
    wishes = [(Fraction(1, 4), 0), (Fraction(1, 2), 0), (Fraction(3, 4), 0)]
    with pytest.raises(SymsplineError):
        Constraints(short, wishes)
    for relief in ["knots", "degree"]:
        held = Constraints(short, wishes, relief=relief)
        bentline = held.dragged(held.shape, [[0, 1], [0, 0], [0, 1]])
        assert [bentline(x)[1] for x, _ in wishes] == [1, 0, 1]


def test_limits_of_weights():
    pull = WeightPull(NURBS, X, 3, within=(1, 12))
    push, most = pull.limits
    assert pull.weight_for(most) == 12 and pull.weight_for(push) == 1
    assert pull.fraction_for(12) == most and pull.weight == 3
    target = pull.point + (pull.control_point - pull.point) * Fraction(1, 5)
    assert pull.fraction_near(target) == Fraction(1, 5)
    pair = WeightPairPull(NURBS, X, 2, 3)
    moved = pair.moved_along(NURBS, Fraction(1, 3))(X)
    # On the line from the base through the point, a third of the way to the leg.
    (a, b), (c, d) = moved - NURBS(X), NURBS(X) - pair.base
    assert a * d == b * c and (a, b) != (0, 0)
    ratio = [moved_weight / weight for moved_weight, weight in zip(pair.weights_for(moved), pair.weights)]
    assert ratio[0] == ratio[1]


def test_a_warp_is_thinned_and_refined():
    plain = warped(CURVE, 1, 3, lambda share, _: [0, 0], refine=Fraction(1, 4))
    knots = [knot for direction, knot in plain.inserted if direction == "u"]
    assert set(knots) >= {Fraction(5, 4), Fraction(3, 2), Fraction(7, 4)}
    thinned = warped(CURVE, 1, 3, lambda share, _: [0, 0], refine=Fraction(1, 4), thinned=Fraction(1, 1000))
    assert thinned.removed and thinned.bound <= Fraction(1, 1000)
    assert len(thinned.shape.coeffs) < len(plain.shape.coeffs)
    along = warped(SURFACE, (0, 0), (2, 2), lambda share, _: None, refine=(None, 3))
    assert {direction for direction, _ in along.inserted} == {"v"}


def test_which_projections_are_accepted():
    top = {"origin": [0, 1], "line": [1, 0]}
    everything = flattened(CURVE, **top).projected
    assert everything == list(range(7))
    assert flattened(CURVE, **top, side="negative").projected == [0, 5]
    assert flattened(CURVE, **top, segments=[([2, 1], [6, 1])]).projected == [2, 3]
    assert flattened(CURVE, **top, balls=[([7, 1], 1)]).projected == [4, 5]
    assert flattened(CURVE, **top, in_front_of=[([4, 0], [1, 0])]).projected == [3, 4, 5, 6]
    assert flattened(CURVE, **top, whole=(0, 1)).projected == [0, 1, 2, 3]
    flat = flattened(CURVE, **top, local=(1, 3), until_flat=60)
    assert flat.flat and all(flat.shape(x)[1] == 1 for interval in flat.flat for pair in interval for x in pair)
    plane = {"origin": [0, 0, 0], "normal": [0, 0, 1]}
    square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    assert flattened(SURFACE, **plane, polygons=[square]).projected == [0, 1, 4, 5]
    disc = flattened(SURFACE, **plane, local=("disc", [1, 1], 4)).projected
    assert set(disc) >= {5, 6, 9, 10}


def test_tails_of_bends():
    line = Spline(Space(1, [0, 0, 1, 2, 3, 3]), [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0]])
    bend = {"centre": [1.0, -5.0], "ratio": 1.0, "radius": 5.0, "interval": (1.0, 3.0), "refine": 8}
    with_tails, without = bent(line, **bend), bent(line, **bend, tails=False)
    assert np.allclose(without(0.5), [0.5, 0.0])
    assert np.allclose(with_tails(2.0)[1], without(2.0)[1])
    assert np.allclose(np.linalg.norm(without.coeffs[-2] - np.array([1.0, -5.0])), 5.0)
    grown = Spline(Space(1, [0.0, 0.0, 3.0, 3.0]), [1.0, 2.0])
    other = bent(line, **{**bend, "ratio": grown})
    assert not np.allclose(other.coeffs, with_tails.coeffs)


def test_anchors_and_pushes():
    line = Spline(Space(3, [0] * 4 + list(range(1, 9)) + [9] * 4), [[i, 0] for i in range(12)])
    body = Elastic(line, Material(1, 2), ("ends", 1))
    held = body.anchored(line, [(4, 0), (4, 1)])
    pushed, reactions = held.pushed(line, [(2, [0, 1])])
    assert list(pushed(4)) == list(line(4)) and pushed(2)[1] > 0 and reactions.shape == (2, 2)
    back, _ = held.met(pushed, [line(4) + np.array([0, 1]), [1, 0]])
    assert list(back(4)) == list(line(4) + np.array([0, 1]))


def test_more_of_the_sculptor():
    line = Spline(Space(3, [0] * 4 + list(range(1, 9)) + [9] * 4), [[i, 0] for i in range(12)])
    sculptor = Sculptor(line, Material(1, 2))
    assert sculptor.resolution(4) == [10]
    sculptor.grab(4, ("nearest", 4))
    sculptor.push([0, 1])
    assert sculptor.shape(4)[1] > 0
    assert sculptor.cancel() and sculptor.shape == line and not sculptor.cancel()
    sculptor.move_points([3, 5], [[0, 1], [0, 2]])
    assert [list(sculptor.shape.coeffs[i]) for i in [3, 5]] == [[3, 1], [5, 2]]
    with pytest.raises(SymsplineError):
        sculptor.move_points([3], [[0, 1], [0, 2]])
    before = sculptor.shape
    sculptor.push_all(Elastic(line, Material(1, 2), "all"), [(4, [0, 1])])
    assert sculptor.shape == Elastic(before, Material(1, 2), "all").pushed(before, [(4, [0, 1])])
    sculptor.set(material=Material(0, 1), reach=("nearest", 3))
    assert sculptor.resolution(4) == [3] and sculptor.edits == (2, 0)


def test_boundaries_of_meshes():
    mesh = Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2, 3]])
    points = {b: CatmullClark(mesh, boundary=b).refined(2).mesh.points for b in ["smooth", "corners"]}
    assert [0, 0, 0] in points["corners"].tolist() and [0, 0, 0] not in points["smooth"].tolist()
    with pytest.raises(SymsplineError, match="empty"):
        CatmullClark(mesh, boundary="open").refined(2)
    grid = Mesh(
        [[i, j, 0] for i in range(3) for j in range(3)], [[0, 3, 4, 1], [1, 4, 5, 2], [3, 6, 7, 4], [4, 7, 8, 5]]
    )
    limits = CatmullClark(grid, boundary="open").limit_points()
    assert [list(p) if p is not None else None for p in limits] == [None] * 4 + [[1, 1, 0]] + [None] * 4
    uneven = DooSabin(mesh, [[1, 2], [1, 1], [1, 1], [1, 1]])
    assert uneven.intervals.tolist() == [[1, 2], [1, 1], [1, 1], [1, 1]]
    assert uneven.refined() != DooSabin(mesh).refined()
    assert CatmullClark(mesh, [1.0, 1, 1, 1]).mesh.points.dtype == np.float64
    with pytest.raises(SymsplineError):
        CatmullClark(mesh, boundary="closed")


def test_conditions_and_graphs():
    parabola = Spline(Space(2, [-1, -1, -1, 1, 1, 1]), [[-1, 1], [0, -1], [1, 1]])
    assert [zero.low for zero in zeros(bend_condition(parabola, slope=True))] == [0]
    assert zeros(bend_condition(parabola)) == []
    profile = CurvatureProfile(parabola)
    graph = profile.log_log()
    assert graph.shape[1] == 2 and len(graph) > 10
    assert profile.comb_scale(1.0) > 0
    cubic = Spline(Space(3, [0] * 4 + [1] * 4), [[0, 0, 0], [1, 0, 0], [2, 1, 0], [3, 3, 3]])
    assert torsion_at(cubic, 0) == 1 and isinstance(torsion_at(cubic, 0.0), float)
    corner = Spline(Space(1, [0, 0, 1, 2, 2]), [[0, 0], [1, 0], [2, Fraction(1, 1000)]])
    assert CurvatureProfile(corner).count("corner") == 1
    assert CurvatureProfile(corner, 0.01).count("corner") == 0
