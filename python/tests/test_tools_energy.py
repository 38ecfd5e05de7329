"""Energies of surfaces with free weights, relaxation, motions that cost nothing."""

import pickle
from fractions import Fraction

import numpy as np
import pytest
from oracle import basis, gram, integral
from symspline import Rational, RationalSurface, Space, Spline, Surface, SymsplineError
from symspline.deform import Elastic, FullEnergy, Material, Relaxation

U, V = Space(2, [0, 0, 0, 1, 3, 3, 3]), Space(2, [0, 0, 0, 2, 2, 2])
WEIGHTS = [[0, 2, 5], [1, 4, 7], [3, 6, 8]]
FULL = FullEnergy(WEIGHTS)
COEFFS = np.array([[[Fraction(i * j + 1, 2), i - j * j] for j in range(V.dim)] for i in range(U.dim)])
SURFACE = Surface(U, V, COEFFS)


def grams(space):
    return [np.array(gram(list(space.knots), space.degree, k)) for k in range(3)]


def stiffness(weights):
    """By the products of the matrices of all orders."""
    gu, gv = grams(U), grams(V)
    return sum(np.kron(gu[k], gv[l]) * Fraction(weights[k][l]) for k in range(3) for l in range(3))


def test_weights_come_from_several_sides():
    assert FullEnergy.of_eight([1, 2, 3, 4, 5, 6, 7, 8]) == FULL
    assert FULL.weights.tolist() == WEIGHTS and FULL.weight(2, 1) == 6 and FULL.weight(9, 9) == 0
    plate = FullEnergy.thin_plate(3, Fraction(1, 2))
    assert plate.weights.tolist() == [[0, 3, Fraction(1, 2)], [3, 1, 0], [Fraction(1, 2), 0, 0]]
    product = FullEnergy.of_materials(Material(1, 2, 3), Material(5, 0, 7))
    assert product.weights.tolist() == [[21, 15], [7, 5], [14, 10]]
    assert FULL.with_weight((0, 0), 9).weights.tolist() == [[9, 2, 5], [1, 4, 7], [3, 6, 8]]
    assert FullEnergy([[1]]).with_weight((1, 3), 2).weights.tolist() == [[1, 0, 0, 0], [0, 0, 0, 2]]
    assert FullEnergy([[1, 0], [0, 0]]) == FullEnergy([[1]]) != FullEnergy([[1.0]])
    assert FullEnergy([[], [0, 1]]).weights.tolist() == [[0, 0], [0, 1]]
    for floats in [FULL.with_weight((0, 0), 0.5), FullEnergy.thin_plate(1, 0.5).with_weight((1, 0), 1), FullEnergy([[1], [0.5]])]:
        assert floats.weights.dtype == np.float64
    assert FullEnergy.of_materials(Material(1, 2), Material(1.0, 2)).weights.dtype == np.float64


def test_energy_and_gradient_are_those_of_the_matrix():
    k = stiffness(WEIGHTS)
    assert np.array_equal(FULL.matrix(U, V), k)
    points = COEFFS.reshape(-1, 2)
    assert FULL.energy(SURFACE) == sum(x @ k @ x for x in points.T)
    assert np.array_equal(FULL.gradient(SURFACE), k @ points)
    heights = SURFACE.coordinate(0)
    assert FULL.energy(heights) == points[:, 0] @ k @ points[:, 0]
    assert np.array_equal(FULL.gradient(heights), k @ points[:, 0])
    floats = SURFACE.to_float()
    exact = float(FULL.energy(SURFACE))
    assert isinstance(FULL.energy(floats), float) and abs(FULL.energy(floats) - exact) < 1e-13 * exact
    assert np.abs(FULL.gradient(floats) - (k @ points).astype(float)).max() < 1e-11
    rounded = FullEnergy.of_eight(np.arange(1.0, 9.0))
    assert isinstance(rounded.energy(SURFACE), float) and rounded.matrix(U, V).dtype == np.float64


@pytest.mark.parametrize("exact", [True, False])
@pytest.mark.parametrize("dim", [1, 3])
def test_a_load_is_answered(exact, dim):
    load = np.array([[Fraction(i * i % 7 - j) for j in range(dim)] for i in range(20)])[: U.dim * V.dim]
    load = load[:, 0] if dim == 1 else load
    load = load if exact else load.astype(float)
    moved = FULL.solved((U, V), load, [("ends", 1), ("range", 0, 2)])
    assert moved.shape == load.shape and (moved.dtype == np.float64) != exact
    free = [V.dim * i + j for i in range(1, U.dim - 1) for j in range(2)]
    answer = (stiffness(WEIGHTS) @ moved)[free] - load[free]
    assert not answer.any() if exact else np.abs(answer.astype(float)).max() < 1e-12
    assert not np.delete(moved, free, axis=0).any() and moved[free].any()


def test_a_full_energy_of_an_elastic_surface_is_its_own():
    material = Material(1, 2, 3)
    body = Elastic(SURFACE, material, [("ends", 1), "whole"])
    load = body.load(SURFACE, [((1, 1), [1, 2])])
    full = FullEnergy.of_materials(material, material)
    assert np.array_equal(full.solved((U, V), load, [("ends", 1), "whole"]), body.solved(load))
    points = COEFFS.reshape(-1, 2)
    assert np.array_equal(full.gradient(SURFACE), body.gradient(points))
    assert full.energy(SURFACE) == np.sum(points * body.gradient(points))


def test_what_full_energies_refuse():
    load = [0] * (U.dim * V.dim)
    cases = [
        (lambda: FullEnergy([[0, -1]]), "SurfaceWeight"),
        (lambda: FullEnergy([[float("nan")]]), "SurfaceWeight"),
        (lambda: FullEnergy([[0] * 1000]), "DegreeTooHigh"),
        (lambda: FullEnergy([[]] * 1000), "DegreeTooHigh"),
        (lambda: FullEnergy.of_eight([1] * 7), "Dimensions"),
        (lambda: FULL.with_weight((2**62, 0), 1), "DegreeTooHigh"),
        (lambda: FULL.energy(Spline(U, [0] * U.dim)), "NoSuch"),
        (lambda: FULL.gradient(RationalSurface(U, V, COEFFS, np.full((4, 3), 2))), "NoSuch"),
        (lambda: FULL.matrix(Space.uniform(1, 200), Space.uniform(1, 200)), "TooLarge"),
        (lambda: FULL.solved((U, V), load, ["whole", "whole"]), "LooseSurface"),
        (lambda: FULL.solved((U, V), load[1:], ["all", "all"]), "CoefficientCount"),
        (lambda: FULL.solved((U, V), load, ["all"]), "Dimensions"),
        (lambda: FULL.solved((U, V), [[0] * 4] * 12, ["all", "all"]), "Dimension"),
        (lambda: FULL.solved((U, V), 3, ["all", "all"]), "Shape"),
    ]
    for call, kind in cases:
        with pytest.raises(SymsplineError) as caught:
            call()
        assert caught.value.kind == kind


def test_full_energies_are_data():
    for energy in [FULL, FullEnergy.thin_plate(0.5, 1), FullEnergy([]), FullEnergy([[0.0]])]:
        again = pickle.loads(pickle.dumps(energy))
        assert again == energy and repr(again) == repr(energy)
    assert repr(FULL) == "<FullEnergy: exact, weights of 3 orders along u and 3 along v>"


SPACE = Space(2, [0, 0, 0, 1, 3, 4, 4, 4])
CURVE = Spline(SPACE, [[k, k * k % 5] for k in range(SPACE.dim)])
STEP = Fraction(1, 3)
MOVES = [1, 2, 3, 4]


def residual(relaxation_step, before, after, load):
    """(K0 + step K) (c' - c) - step (load - K c) of the coefficients that move."""
    order = grams(SPACE)
    k = order[1] * 2 + order[2] * 5
    left = (order[0] + k * relaxation_step) @ (after - before) - (load - k @ before) * relaxation_step
    return left[MOVES]


def test_a_step_of_relaxation():
    relaxation = Relaxation(SPACE, Material(2, 5), ("range", 1, 5), STEP)
    assert relaxation.length == STEP and relaxation.body.moving == [MOVES]
    curve, energies = CURVE, []
    for _ in range(3):
        after = relaxation.stepped(curve)
        assert not residual(STEP, curve.coeffs, after.coeffs, 0).any()
        assert list(after.coeffs[0]) == list(CURVE.coeffs[0])
        energies.append(Material(2, 5).energy(curve))
        curve = after
    assert energies[0] > energies[1] > energies[2] > Material(2, 5).energy(curve)
    load = np.array([[Fraction(k), Fraction(1, k + 1)] for k in range(SPACE.dim)])
    pushed = relaxation.stepped(CURVE, load)
    assert not residual(STEP, CURVE.coeffs, pushed.coeffs, load).any()
    weighted = Rational(SPACE, CURVE.coeffs, [1, 2, 1, 2, 1])
    assert np.array_equal(relaxation.stepped(weighted, load).points, pushed.coeffs)
    forces = [(2, [0, 1])]
    assert np.array_equal(relaxation.body.load(CURVE, forces), Elastic(CURVE, Material(1, 0), "all").load(CURVE, forces))


def test_relaxation_over_floats():
    relaxation = Relaxation(SPACE, Material(2, 5), ("range", 1, 5), 0.25)
    assert isinstance(relaxation.length, float)
    height = CURVE.coordinate(1)
    load = np.arange(5.0)
    after = relaxation.stepped(height, load)
    assert not after.is_exact
    assert np.abs(residual(0.25, height.to_float().coeffs, after.coeffs, load).astype(float)).max() < 1e-12


def test_what_relaxation_refuses():
    relaxation = Relaxation(SPACE, Material(2, 5), "all", 1)
    cases = [
        (lambda: Relaxation(SPACE, Material(2, 5), "all", 0), "Step"),
        (lambda: Relaxation(SPACE, Material(2, 5), "all", float("inf")), "Step"),
        (lambda: Relaxation(SPACE, Material(2, 5), ("nearest", 3), 1), "NoSuch"),
        (lambda: relaxation.stepped(Spline(U, [0] * U.dim)), "OtherSpace"),
        (lambda: relaxation.stepped(SURFACE), "NoSuch"),
        (lambda: relaxation.stepped(CURVE, [[0, 1]] * 4), "CoefficientCount"),
        (lambda: relaxation.stepped(CURVE, [0] * 10), "Dimensions"),
    ]
    for call, kind in cases:
        with pytest.raises(SymsplineError) as caught:
            call()
        assert caught.value.kind == kind
    with pytest.raises(TypeError, match="pickle"):
        pickle.dumps(relaxation)


def test_motions_that_cost_nothing():
    bending = Material(0, 1)
    free = bending.null_space(SPACE)
    order = grams(SPACE)
    assert free.shape == (2, 5) and not (order[2] @ free.T).any()
    # Two that do not follow from each other.
    assert any(free[0][i] * free[1][j] != free[0][j] * free[1][i] for i in range(5) for j in range(i))
    hinge = Space(2, [0, 0, 0, 1, 1, 2, 2, 2])
    (broken,) = bending.null_space(hinge, ("ends", 1))
    assert broken[1] != 0 and list(broken / broken[1]) == [0, 1, 2, 1, 0]
    assert Material(1, 0).null_space(SPACE, "all").shape == (0, 5)
    floats = bending.null_space(SPACE.to_float(), "whole")
    assert floats.shape == (2, 5) and np.abs(order[2].astype(float) @ floats.T).max() < 1e-13
    assert Material(0, 1.0).null_space(SPACE).dtype == np.float64


def test_bodies_of_curves_and_loads():
    body = Elastic(CURVE, Material(2, 5), "all")
    order = grams(SPACE)
    k = order[1] * 2 + order[2] * 5
    assert np.array_equal(body.gradient(CURVE.coeffs), k @ CURVE.coeffs)
    load = np.array([Fraction(3), 1, 4, 1, 5])
    moved = body.solved(load)
    assert list((k @ moved)[1:4]) == [1, 4, 1] and list(moved[[0, 4]]) == [0, 0]
    for call in [body.solved, body.gradient]:
        with pytest.raises(SymsplineError) as caught:
            call(load[1:])
        assert caught.value.kind == "CoefficientCount"
        with pytest.raises(SymsplineError) as caught:
            call(np.zeros((5, 0)))
        assert caught.value.kind == "Dimension"


def test_stiffness_by_quadrature():
    material = Material.of_orders([Fraction(1, 2), 2, 5])
    order = grams(SPACE)
    exact = (order[0] / 2 + order[1] * 2 + order[2] * 5).astype(float)
    assert np.abs(material.matrix_by_quadrature(SPACE) - exact).max() < 1e-13
    assert np.abs(material.matrix_by_quadrature(SPACE, 3) - exact).max() < 1e-13
    # One node sees of x * x the mean slope alone.
    line, parabola = Space.bezier(2), np.array([0.0, 0.0, 1.0])
    assert parabola @ Material(1, 0).matrix_by_quadrature(line, 1) @ parabola == 1
    with pytest.raises(SymsplineError) as caught:
        material.matrix_by_quadrature(SPACE, 2**40)
    assert caught.value.kind == "TooLarge"


@pytest.mark.parametrize("exact", [True, False])
def test_forcing_is_of_hats(exact):
    surface = SURFACE if exact else SURFACE.to_float()
    along_u, along_v = Elastic(surface, Material(1, 1), ["all", "all"]).forcing()
    assert (along_u.dtype == object) == exact
    for found, space, knots in [(along_u, U, [0, 0, 1, 3, 3]), (along_v, V, [0, 0, 2, 2])]:
        breaks = knots[1:-1]
        p, t = space.degree, list(space.knots)
        for j in range(len(breaks)):
            for i in range(space.dim):
                expected = sum(
                    integral(lambda x: basis(t, p, i, x) * basis(knots, 1, j, x), a, b)
                    for a, b in zip(breaks, breaks[1:])
                )
                assert found[j][i] == expected if exact else abs(found[j][i] - float(expected)) < 1e-15
