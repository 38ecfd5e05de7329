"""Forces on shapes: along curves and over areas of the parameter plane, and what bodies make of loads."""

import pickle
from fractions import Fraction

import numpy as np
import pytest
from oracle import basis, gram, integral
from symspline import Rational, RationalSurface, Space, Spline, Surface, SymsplineError
from symspline.deform import Elastic, Load, Material, Sculptor

U, V = Space(2, [0, 0, 0, 1, 2, 2, 2]), Space(1, [0, 0, 1, 3, 3])
SHEET = Surface(U, V, [[[x, y, x * y] for y in V.greville] for x in U.greville])
MATERIAL = Material(1, 2, 1)
BODY = Elastic(SHEET, MATERIAL, ["whole", "whole"], spread="point")
FLOATS = Elastic(SHEET.to_float(), MATERIAL, ["whole", "whole"], spread="point")
UP = [0, 1, 2]
WIND = Surface(Space(1, [0, 0, 2, 2]), Space(1, [0, 0, 3, 3]), [[[1, 0, 2], [0, 1, 0]], [[3, 1, 1], [0, 0, 5]]])
PATH = Spline(Space.bezier(2), [[0, 0], [1, 3], [2, 1]])
RISING = Spline(Space.bezier(1), [[0, 0, 1], [0, 2, 0]])
WHOLE = ((0, 0), (2, 3))


def shares(space, x):
    knots, p = list(space.knots), space.degree
    end = knots[-p - 1]
    return np.array([basis(knots, p, i, x, x == end) for i in range(space.dim)])


def load_at(u, v, force):
    """How a force at a point loads all control points."""
    return np.multiply.outer(np.outer(shares(U, u), shares(V, v)).ravel(), np.array(force))


def wind(u, v):
    """The values of the surface by its corners."""
    x, y = Fraction(u) / 2, Fraction(v) / 3
    a, b, c, d = (np.array(p) for p in ([1, 0, 2], [0, 1, 0], [3, 1, 1], [0, 0, 5]))
    return (1 - x) * ((1 - y) * a + y * b) + x * ((1 - y) * c + y * d)


def over(inside, force, low, high, m, n):
    """The load of a force in the middles of cells."""
    cell = Fraction(high[0] - low[0], m) * Fraction(high[1] - low[1], n)
    total = 0
    for i in range(m):
        for j in range(n):
            u = low[0] + Fraction(2 * i + 1, 2 * m) * (high[0] - low[0])
            v = low[1] + Fraction(2 * j + 1, 2 * n) * (high[1] - low[1])
            if inside(u, v):
                total = total + cell * load_at(u, v, force(u, v))
    return total


def anywhere(u, v):
    return True


@pytest.mark.parametrize(("force", "value"), [(RISING, lambda t: [0, 2 * t, 1 - t]), (UP, lambda t: UP)])
def test_a_force_along_a_path_is_many_forces(force, value):
    expected = 0
    for k in range(7):
        t = Fraction(2 * k + 1, 14)
        u, v = 2 * t, 6 * t - 5 * t * t
        expected = expected + load_at(u, v, value(t)) / Fraction(7)
    assert np.array_equal(BODY.load(SHEET, Load(along=[(PATH, force, 7)])), expected)
    twice = BODY.load(SHEET, Load([((1, 1), UP)], along=[(PATH, force, 7), (PATH, force, 7)]))
    assert np.array_equal(twice, 2 * expected + load_at(1, 1, UP))


@pytest.mark.parametrize(("force", "value"), [(RISING, lambda t: [0, 2 * t, 1 - t]), (UP, lambda t: UP)])
def test_without_samples_it_is_the_integral(force, value):
    # The path meets u = 1 at 1/2 and v = 1 at 1/5; between them the load has degree five.
    expected = 0
    for a, b in [(Fraction(0), Fraction(1, 5)), (Fraction(1, 5), Fraction(1, 2)), (Fraction(1, 2), Fraction(1))]:
        expected = expected + integral(lambda t: load_at(2 * t, 6 * t - 5 * t * t, value(t)), a, b)
    found = FLOATS.load(SHEET, Load(along=[(PATH, force, None)]))
    assert found.dtype == np.float64 and np.abs(found - expected.astype(float)).max() < 1e-14
    with pytest.raises(SymsplineError) as caught:
        BODY.load(SHEET, Load(along=[(PATH, force, None)]))
    assert caught.value.kind == "NoSuch"


def test_a_force_over_a_rectangle():
    found = BODY.load(SHEET, Load(over=[(((0, 1), (2, 2)), WIND, (4, 3))]))
    assert np.array_equal(found, over(anywhere, wind, (0, 1), (2, 2), 4, 3))
    assert np.array_equal(BODY.load(SHEET, Load(over=[(((2, 2), (0, 1)), WIND, (4, 3))])), found)
    rounded = FLOATS.load(SHEET, Load(over=[(((0, 1), (2, 2)), WIND, (4, 3))]))
    assert np.abs(rounded - found.astype(float)).max() < 1e-14


def test_a_force_over_a_polygon_and_over_what_is_in_one_of_two():
    def constant(u, v):
        return UP

    triangle = ("polygon", [[0, 0], [2, 0], [0, 3]])
    found = BODY.load(SHEET, Load(over=[(triangle, UP, 6)]))
    assert np.array_equal(found, over(lambda u, v: u / 2 + v / 3 <= 1, constant, (0, 0), (2, 3), 6, 6))
    ring = [WHOLE, ((0, 1), (1, 2))]
    found = BODY.load(SHEET, Load(over=[(ring, UP, Fraction(1, 2))]))
    assert np.array_equal(found, over(lambda u, v: not (u < 1 < v < 2), constant, (0, 0), (2, 3), 4, 6))


@pytest.mark.parametrize("rational", [True, False])
def test_a_force_inside_a_curve(rational):
    centre, r = np.array([1.0, 1.5]), 0.8
    if rational:
        curve = Rational.circle(list(centre), r)
        low, high = centre - r, centre + r

        def inside(u, v):
            return (u - 1) ** 2 + (v - 1.5) ** 2 < r * r
    else:
        # Between a line and a parabola.
        curve = Spline(Space(2, [0, 0, 0, 1, 1, 2, 2, 2]), [[0.5, 0.5], [1.0, 3.5], [1.5, 0.5], [1.0, 0.5], [0.5, 0.5]])
        low, high = np.array([0.5, 0.5]), np.array([1.5, 2.0])

        def inside(u, v):
            t = u - 0.5
            return 0.5 < v < 0.5 + 6 * t * (1 - t)

    count = 36
    middles = (2 * np.arange(count) + 1) / (2 * count)
    us, vs = low[0] + middles * (high[0] - low[0]), low[1] + middles * (high[1] - low[1])
    # No middle is so near the curve that the box, which is found to 1e-9, could tell.
    near = [inside(u + a, v + b) != inside(u, v) for u in us for v in vs for a in (-1e-6, 1e-6) for b in (-1e-6, 1e-6)]
    assert not any(near)
    cell = np.prod(high - low) / count**2
    expected = sum(cell * load_at(u, v, [0, 0, 1]).astype(float) for u in us for v in vs if inside(u, v))
    found = FLOATS.load(SHEET, Load(over=[(curve, [0, 0, 1], count)]))
    assert np.abs(found - expected).max() < 1e-7
    with pytest.raises(SymsplineError) as caught:
        BODY.load(SHEET, Load(over=[(curve, [0, 0, 1], count)]))
    assert caught.value.kind == "NoSuch"


@pytest.mark.parametrize("varying", [True, False])
def test_a_pressure_goes_along_the_normals(varying):
    # The sheet is (u, v, uv), with normals (-v, -u, 1).
    pressure = Surface(Space(1, [0, 0, 2, 2]), Space(0, [0, 3]), [[1], [5]]) if varying else 3

    def force(u, v):
        return np.array([-v, -u, 1]) * (1 + 2 * u if varying else 3)

    found = BODY.load(SHEET, Load(pressure=[(WHOLE, pressure, (3, 5))]))
    assert np.array_equal(found, over(anywhere, force, (0, 0), (2, 3), 3, 5))
    weighted = RationalSurface(U, V, SHEET.coeffs, np.full((4, 3), 2))
    assert np.array_equal(BODY.load(weighted, Load(pressure=[(WHOLE, pressure, (3, 5))])), found)


def test_all_that_push_take_a_load():
    load = Load([((1, 1), UP)], along=[(PATH, RISING, 5)], over=[(WHOLE, WIND, 4)], pressure=[(WHOLE, 2, 3)])
    body = Elastic(SHEET, MATERIAL, ["all", "all"], spread="point")
    total = load_at(1, 1, UP)
    total = total + BODY.load(SHEET, Load(along=load.along)) + BODY.load(SHEET, Load(over=load.over, pressure=load.pressure))
    assert np.array_equal(body.load(SHEET, load), total)
    pushed = body.pushed(SHEET, load)
    moved = (pushed.coeffs - SHEET.coeffs).reshape(12, 3)
    # K_u D K_v = load for those that move.
    ku, kv = (sum(np.array(gram(list(s.knots), s.degree, k)) * w for k, w in enumerate([1, 1, 2][: s.degree + 1])) for s in (U, V))
    stiffness = np.kron(ku, kv)
    free = [3 * i + 1 for i in (1, 2)]
    assert np.array_equal((stiffness @ moved)[free], total[free]) and not moved[[0, 1, 2, 3, 5, 9, 11]].any()
    places, moves = body.displacements(SHEET, load)
    assert places == free and np.array_equal(moves, moved[free])
    assert np.array_equal(body.solved(total), moved)
    at = (Fraction(1, 2), 2)
    still, reactions = BODY.anchored(SHEET, [(at, (0, 0))]).pushed(SHEET, load)
    assert still(*at).tolist() == SHEET(*at).tolist()
    moved = (still.coeffs - SHEET.coeffs).reshape(12, 3)
    assert np.array_equal(stiffness @ moved, total + load_at(*at, reactions[0]))
    sculptor = Sculptor(SHEET, MATERIAL)
    sculptor.push_all(body, load)
    assert sculptor.shape == pushed and sculptor.undo() and sculptor.shape == SHEET


def test_curves_have_loads():
    space = Space(3, [0] * 4 + [1, 2, 4, 4, 4, 4])
    curve = Spline(space, [[k, k * k % 5] for k in range(space.dim)])
    body = Elastic(curve, MATERIAL, ("ends", 1), spread="point")
    density = Spline(Space(1, [0, 0, 4, 4]), [[0, 4], [8, 0]])

    def weighed(x):
        values = [basis(list(space.knots), 3, i, x) for i in range(space.dim)]
        return np.multiply.outer(np.array(values), np.array([2 * x, 4 - x]))

    expected = sum(integral(weighed, a, b) for a, b in [(0, 1), (1, 2), (2, 4)])
    load = Load(density=density)
    assert np.array_equal(body.load(curve, load), expected)
    assert np.array_equal(body.load(curve, [], density=density.to_float()), expected)
    assert body.pushed(curve, load) == body.pushed(curve, density=density)
    both = body.load(curve, Load([(2, [0, 1])]), density=density) - expected
    assert [list(row) for row in both] == [[0, basis(list(space.knots), 3, i, 2)] for i in range(space.dim)]
    assert body.load(curve.to_float(), Load(at_breaks=[[0, 1]] * 4)).shape == (6, 2)
    # Constant forces are spread as the integrals of the basis functions.
    sums = body.load(curve, at_breaks=[[0, 1]] * 4)[:, 1]
    assert list(sums) == [Fraction(space.knots[i + 4] - space.knots[i]) / 4 for i in range(6)]


@pytest.mark.parametrize(
    ("load", "kind"),
    [
        (Load(along=[(PATH, RISING, 0)]), "NoSamples"),
        (Load(along=[(PATH, RISING, 2**40)]), "TooLarge"),
        (Load(along=[(Spline(Space.bezier(1), [[0, 0], [3, 3]]), UP, 5)]), "LeavesDomain"),
        (Load(along=[(PATH, Spline(Space.bezier(0, 0, 2), [UP]), 5)]), "DomainMismatch"),
        (Load(along=[(PATH, 1, 5)]), "Dimensions"),
        (Load(along=[(RISING, UP, 5)]), "NoSuch"),
        (Load(along=[(PATH, SHEET, 5)]), "NoSuch"),
        (Load(over=[(WHOLE, UP, 0)]), "NoSamples"),
        (Load(over=[([], UP, 3)]), "NoSamples"),
        (Load(over=[(WHOLE, UP, (2**40, 2**40))]), "TooLarge"),
        (Load(over=[(WHOLE, UP, -0.5)]), "BadTolerance"),
        (Load(over=[(((0, 0), (2, 4)), UP, 3)]), "OutsideDomain"),
        (Load(over=[(((0, 0), (2, 4, 5)), UP, 3)]), "Dimensions"),
        (Load(over=[(("polygon", [[0, 0], [1, 1]]), UP, 3)]), "TooFewPoints"),
        (Load(over=[(WHOLE, PATH, 3)]), "NoSuch"),
        (Load(pressure=[(WHOLE, UP, 3)]), "Dimensions"),
        (Load(over=[(WHOLE, [0, float("nan"), 1], 3)]), "NotFinite"),
    ],
)
def test_bad_loads_are_refused(load, kind):
    with pytest.raises(SymsplineError) as caught:
        BODY.load(SHEET, load)
    assert caught.value.kind == kind


def test_what_a_shape_does_not_have():
    curve = Spline(U, [0, 1, 2, 3])
    rod, heights = Elastic(curve, MATERIAL, "whole"), SHEET.coordinate(2)
    for load in [Load(along=[(PATH, 1, 5)]), Load(over=[(WHOLE, 1, 5)]), Load(pressure=[(WHOLE, 1, 5)])]:
        with pytest.raises(SymsplineError) as caught:
            rod.pushed(curve, load)
        assert caught.value.kind == "NoSuch"
    with pytest.raises(SymsplineError) as caught:
        BODY.pushed(heights, Load(pressure=[(WHOLE, 1, 5)]))
    assert caught.value.kind == "NoSuch"
    with pytest.raises(SymsplineError) as caught:
        BODY.load(RationalSurface(U, V, SHEET.coeffs, np.full((4, 3), 2)), density=WIND)
    assert caught.value.kind == "NoSuch"
    with pytest.raises(SymsplineError) as caught:
        FLOATS.load(SHEET, Load(over=[(PATH, UP, 5)]))
    assert caught.value.kind == "OpenBoundary"
    with pytest.raises(SymsplineError) as caught:
        BODY.load(SHEET, Load(density=WIND), density=WIND)
    assert caught.value.kind == "Word"
    for area in [[[WHOLE]], ("circle", [[0, 0]]), 3, SHEET, (1, 2, 3)]:
        with pytest.raises(SymsplineError) as caught:
            Load(over=[(area, UP, 3)])
        assert caught.value.kind == "Word"
    with pytest.raises(SymsplineError) as caught:
        Load(over=[(("polygon", [0, 0, 1, 0, 1, 1]), UP, 3)])
    assert caught.value.kind == "Shape"
    for wrong in [{"along": [(PATH, UP)]}, {"over": [(WHOLE, UP)]}, {"forces": [3]}]:
        with pytest.raises((TypeError, ValueError)):
            Load(**wrong)


def test_loads_are_data():
    areas = [WHOLE, ("polygon", [[0, 0], [2, 0], [0, 3]]), Rational.circle([1, 1], 1), [WHOLE, ("polygon", [[0, 0], [1, 0], [0, 1]])]]
    cells = [(4, 5), Fraction(1, 3), 0.5, (6, 6)]
    load = Load(
        [((1, 1), UP), ((Fraction(1, 3), 2), [0.5, 0, 0])],
        at_breaks=np.ones((9, 3)),
        density=WIND,
        along=[(PATH, RISING, 3), (PATH, UP, None)],
        over=[(area, UP, c) for area, c in zip(areas, cells)],
        pressure=[(areas[0], 2, 7)],
    )
    again = pickle.loads(pickle.dumps(load))
    assert again == load and repr(again) == repr(load) and repr(Load()) == "<Load: none>"
    assert repr(load) == "<Load: 2 single, 1 at breaks, 1 density, 2 along curves, 4 over areas, 1 pressure>"
    assert again.density == WIND and again.at_breaks.shape == (9, 3) and again.pressure[0][2] == (7, 7)
    assert [c for _, _, c in again.over] == cells and again.along[0] == (PATH, RISING, 3)
    assert Load(over=[(areas[1], UP, 3)]) != Load(over=[(areas[0], UP, 3)])
    assert Load(along=[(PATH, UP, 3)]) != Load(along=[(PATH, UP, 4)])


def test_a_curve_on_a_surface_meets_one_in_space():
    body = Elastic(SHEET, Material(1, 1, 1), ["whole", "whole"])
    parameters = [Fraction(k, 3) for k in range(4)]
    held = body.anchored(SHEET, [(PATH(t), (0, 0)) for t in parameters])
    target = Spline(Space.bezier(2), [[0, 0, 0], [1, 2, 5], [2, 1, 3]])
    met, forces = held.met_curve(SHEET, target.to_float())
    assert met.is_exact and forces.shape == (4, 3)
    assert all(met(*PATH(t)).tolist() == target(t).tolist() for t in parameters)
    for wrong in [PATH, SHEET, 3]:
        with pytest.raises(SymsplineError) as caught:
            held.met_curve(SHEET, wrong)
        assert caught.value.kind == "NoSuch"


def test_a_sculptor_takes_another_spread():
    line = Spline(Space.uniform(3, 6), [[k, 0] for k in range(9)])
    at, material = Fraction(1, 7), Material(1, 2)
    sculptor = Sculptor(line, material)
    assert sculptor.start is None and sculptor.force is None and sculptor.pull is None
    shown = {}
    for spread in ["hat", "point"]:
        sculptor.set(spread=spread)
        sculptor.grab(at)
        sculptor.push([0, 1])
        shown[spread] = sculptor.shape
        assert list(sculptor.start) == list(line(at)) and list(sculptor.force) == [0, 1]
        body = Elastic(line, material, "all", spread=spread)
        assert shown[spread] == body.pull(line, at).pushed(line, [0, 1])
        assert sculptor.pull.give == body.pull(line, at).give
        assert sculptor.elastic(at).pushed(line, [(at, [0, 1])]) == shown[spread]
        assert sculptor.cancel()
    assert shown["hat"] != shown["point"]
    with pytest.raises(SymsplineError) as caught:
        sculptor.set(spread="wide")
    assert caught.value.kind == "Word"
