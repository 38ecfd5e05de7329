"""Elastic bodies: forces, targets, least energy."""

from fractions import Fraction

import numpy as np
import pytest
from symspline import Space, Spline, Surface, SymsplineError
from symspline.deform import Elastic, Material, Sculptor
from symspline.shape import derivative_at

SPACE = Space(3, [0] * 4 + list(range(1, 9)) + [9] * 4)
LINE = Spline(SPACE, [[i, 0] for i in range(12)])
MATERIAL = Material(1, 2)
AT = Fraction(7, 2)


def test_a_pull_takes_the_point_to_its_target():
    body = Elastic(LINE, MATERIAL, ("around", AT, 8))
    pull, curve, forces = body.pull(LINE, AT), LINE, []
    for _ in range(3):
        target = curve(AT) + np.array([0, 1])
        curve, force = pull.moved_to(curve, target)
        assert list(curve(AT)) == list(target)
        forces.append(list(force))
    assert forces[0] == forces[1] == list(pull.force_for([0, 1]))
    still = [i for i in range(12) if i not in body.moving[0]]
    assert len(still) == 4 and all(list(curve.coeffs[i]) == list(LINE.coeffs[i]) for i in still)


def test_energy_is_that_of_the_matrix():
    for material in [MATERIAL, Material(1, 0, 3), Material.of_orders([0, 0, 1])]:
        moves = np.array([Fraction(k * k % 5) for k in range(12)])
        assert material.energy(Spline(SPACE, moves)) == moves @ material.matrix(SPACE) @ moves


def test_anchored_shapes_have_least_energy():
    body = Elastic(LINE, MATERIAL, ("ends", 1), spread="point")
    held = body.anchored(LINE, [(AT, 0), (AT, 1)])
    bentline, reactions = held.dragged(LINE, [[0, 1], [0, 0]])
    assert reactions.shape == (2, 2)
    assert list(bentline(AT)) == list(LINE(AT) + np.array([0, 1]))
    relaxed, _ = held.relaxed(bentline)
    least = MATERIAL.energy(relaxed)
    # Any other curve with the same constrained values and the same ends costs more.
    rows = np.array([[0] * 12, [0] * 12], dtype=object)
    for i in range(12):
        unit = Spline(SPACE, [int(i == j) for j in range(12)])
        rows[0, i], rows[1, i] = unit(AT), derivative_at(unit, AT, 1)
    for m in [5, 6, 7]:
        # Movements of three coefficients that cancel in both rows.
        i, j = 3, 4
        det = rows[0, i] * rows[1, j] - rows[1, i] * rows[0, j]
        a = -(rows[0, m] * rows[1, j] - rows[1, m] * rows[0, j]) / det
        b = -(rows[0, i] * rows[1, m] - rows[1, i] * rows[0, m]) / det
        for sign in [1, -1]:
            coeffs = relaxed.coeffs.copy()
            for place, amount in [(i, a), (j, b), (m, Fraction(1))]:
                coeffs[place] = coeffs[place] + np.array([0, sign * amount * Fraction(1, 50)])
            other = Spline(SPACE, coeffs)
            assert list(other(AT)) == list(relaxed(AT))
            assert MATERIAL.energy(other) > least


def test_forces_add_up():
    body = Elastic(LINE, MATERIAL, "all")
    single = [(Fraction(k), [0, Fraction(k, 20)]) for k in range(1, 4)]
    together = body.pushed(LINE, single)
    one_by_one = LINE
    for force in single:
        one_by_one = body.pushed(one_by_one, [force])
    assert together == one_by_one
    places, moves = body.displacements(LINE, single)
    assert np.array_equal(LINE.coeffs[places] + moves, together.coeffs[places])
    with pytest.raises(SymsplineError):
        body.pushed(LINE, [(10, [0, 1])])


def test_a_density_is_what_many_forces_add_up_to():
    body = Elastic(LINE, MATERIAL, "all", spread="point")
    wind = Spline(Space(1, [0, 0, 9, 9]), [[0, 0], [0, 9]])
    blown = body.pushed(LINE, density=wind)
    # The midpoint rule with many forces, each of the size of its cell.
    cells = 900
    places = [Fraction(2 * k + 1, 200) for k in range(cells)]
    many = body.pushed(LINE, [(x, [0, x / 100]) for x in places])
    assert np.allclose(np.array(blown.coeffs, float), np.array(many.coeffs, float), atol=1e-3)
    assert list(blown.coeffs[0]) == [0, 0] and blown.coeffs[5][1] > 0


def test_surfaces_are_pulled():
    flat = Space(2, [0, 0, 0, 1, 2, 3, 3, 3])
    plane = Surface(flat, flat, [[[i, j, 0] for j in range(5)] for i in range(5)])
    body = Elastic(plane, MATERIAL, ["all", "all"])
    at = (Fraction(3, 2), 1)
    up, _ = body.pull(plane, at).moved_to(plane, plane(*at) + np.array([0, 0, 1]))
    assert list(up(*at)) == list(plane(*at) + np.array([0, 0, 1]))
    assert list(up(0, 1)) == list(plane(0, 1))


def test_a_sculptor_undoes():
    sculptor = Sculptor(LINE, MATERIAL, reach=("nearest", 6), limit=10)
    sculptor.grab(AT)
    sculptor.drag_to([AT, 2])
    shown = sculptor.shape
    assert list(shown(AT)) == [AT, 2]
    assert sculptor.commit() and sculptor.edits == (1, 0)
    assert sculptor.refine(AT, [1], 6) > 0
    assert sculptor.undo() and sculptor.undo() and sculptor.shape == LINE
    assert sculptor.redo() and sculptor.shape == shown
    with pytest.raises(SymsplineError):
        sculptor.drag_to([0, 0])


def test_materials_are_checked():
    with pytest.raises(SymsplineError):
        Material(-1, 2)
    with pytest.raises(SymsplineError):
        Elastic(LINE, MATERIAL, ("sideways", 3))
    assert Elastic(LINE, Material(1.0, 2), "all").pushed(LINE, [(1, [0, 1])]).coeffs.dtype == np.float64
