"""Fine tuning: its defining identities, over fractions with `==`."""

from fractions import Fraction

import numpy as np
import pytest
from symspline import Space, Spline, Surface, SymsplineError
from symspline.analysis import curvature_squared
from symspline.fine_tune import (
    FineTuner,
    NearestScale,
    dragged,
    fine_tuned,
    fine_tuned_closed,
    fine_tuned_from,
    fine_tuned_holding,
    fine_tuned_on,
    fine_tuned_on_by_nearest,
    fine_tuned_within,
    path_gap,
    scale_for_curvature_ratio,
)
from symspline.shape import derivative_at

KNOTS = [0, 0, 0, 1, 2, 3, 3, 3]
CURVE = Spline(Space(2, KNOTS), [[0, 0], [1, 2], [3, 2], [4, 0], [6, 1]])
ALPHA = Spline(Space(1, [0, 0, 3, 3]), [1, Fraction(3, 2)])
# Further than two polynomials of these degrees can agree by chance, in every span.
PLACES = [Fraction(k, 7) for k in range(22)]


def test_the_derivative_is_multiplied_and_the_curvature_divided():
    tuned = fine_tuned(CURVE, ALPHA)
    assert list(tuned(0)) == list(CURVE(0))
    before, after = curvature_squared(CURVE), curvature_squared(tuned)
    for x in PLACES:
        assert list(derivative_at(tuned, x, 1)) == list(ALPHA(x) * derivative_at(CURVE, x, 1))
        assert after(x) * ALPHA(x) ** 2 == before(x)


def test_a_float_anywhere_makes_floats_of_the_whole():
    rounded = Spline(Space(1, [0, 0, 3, 3]), [1.0, 1.5])
    for curve, alpha in [(CURVE, rounded), (Spline(CURVE.space, np.array(CURVE.coeffs, float)), ALPHA)]:
        tuned = fine_tuned(curve, alpha)
        assert tuned.coeffs.dtype == np.float64
        assert np.allclose(tuned.coeffs, np.array(fine_tuned(CURVE, ALPHA).coeffs, float), atol=1e-14)


def test_scale_functions_are_positive_unless_they_are_signed():
    alpha = Spline(ALPHA.space, [1, -1])
    with pytest.raises(SymsplineError) as caught:
        fine_tuned(CURVE, alpha)
    assert caught.value.kind == "NotPositive" or "positive" in str(caught.value)
    assert list(derivative_at(fine_tuned(CURVE, alpha, signed=True), 3, 1)) == list(-derivative_at(CURVE, 3, 1))


@pytest.mark.parametrize(("hold", "order"), [("points", 0), ("tangents", 1), ("curvatures", 2)])
def test_ends_are_held(hold, order):
    held = fine_tuned_holding(CURVE, ALPHA, hold)
    for x in [0, 3]:
        for k in range(order + 1):
            assert list(derivative_at(held.curve, x, k)) == list(derivative_at(CURVE, x, k))
    # The similarity is a rotation and scaling of the free curve.
    free = fine_tuned(CURVE, ALPHA)
    for x in PLACES[:-1]:
        was, image = derivative_at(free, x, 1), derivative_at(held.image, x, 1)
        assert sum(image**2) == held.squared_scale * sum(was**2)


def test_words_are_checked():
    with pytest.raises(SymsplineError, match='"tangents"'):
        fine_tuned_holding(CURVE, ALPHA, "ends")
    with pytest.raises(SymsplineError) as caught:
        fine_tuned(CURVE, CURVE)
    assert caught.value.kind == "Dimensions"
    with pytest.raises(SymsplineError):
        NearestScale(CURVE, ALPHA.space, [("enf",)])


def test_the_nearest_scale_meets_its_conditions():
    scales = Space(2, [0, 0, 0, 1, 2, 3, 3, 3])
    wanted = dragged(Spline(scales, [1] * 5), Fraction(3, 2), 2)
    assert wanted(Fraction(3, 2)) == 2
    conditions = ["end", ("scale", 1, Fraction(5, 4)), ("coefficient", 0, 1)]
    nearest = NearestScale(CURVE, scales, conditions).to(wanted)
    assert nearest(1) == Fraction(5, 4) and nearest.coeffs[0] == 1
    tuned = fine_tuned(CURVE, nearest)
    assert list(tuned(3)) == list(CURVE(3))
    tuner = FineTuner(CURVE, scales, conditions=conditions)
    assert tuner.tuned(wanted) == tuned
    assert tuner.spaces == [tuned.space]


def test_a_tuner_writes_into_arrays():
    curve = Spline(CURVE.space, np.array(CURVE.coeffs, float))
    tuner = FineTuner(curve, ALPHA.space)
    out = np.zeros((tuner.spaces[0].dim, 2))
    for top in [1.5, 2.0]:
        tuner.tune_into(np.array([1.0, top]), out)
        assert np.array_equal(out, tuner.tuned(np.array([1.0, top])).coeffs)
    with pytest.raises(SymsplineError):
        tuner.tune_into(np.array([1.0, 2.0]), np.zeros((3, 2)))
    with pytest.raises(SymsplineError):
        tuner.tune_into(np.array([1.0, 2.0]), np.zeros((2, tuner.spaces[0].dim)).T[:, :1])


def test_closed_curves_stay_closed():
    polygon = [[0, 0], [4, 0], [5, 3], [1, 4]]
    curve = Spline(Space(2, [0, 1, 2, 3], 4), polygon)
    alpha = Spline(Space(1, [0, 1, 2, 3], 4), [1, 2, 1, 1])
    open_one = fine_tuned(curve, alpha)
    assert list(open_one(0)) != list(open_one(4))
    tuned = FineTuner(curve, alpha.space, conditions=["end", "area"]).tuned(alpha)
    assert list(tuned(0)) == list(tuned(4))
    relaxed = fine_tuned_closed(curve, alpha)
    assert relaxed.converged and relaxed.energy < relaxed.energy_before
    assert np.allclose(relaxed.curve(0.0), relaxed.curve(4.0))


def test_a_portion_is_tuned_alone():
    portion = Space(2, [Fraction(1, 2)] * 3 + [1, 2] + [Fraction(5, 2)] * 3)
    alpha = dragged(Spline(portion, [1] * 5), Fraction(3, 2), 2)
    for local in [
        fine_tuned_on(CURVE, alpha, "tangents"),
        fine_tuned_on_by_nearest(CURVE, Spline(portion, alpha.coeffs), 1),
    ]:
        whole = local.joined()
        for x in [0, Fraction(1, 3), Fraction(1, 2), Fraction(5, 2), Fraction(8, 3), 3]:
            assert list(whole(x)) == list(CURVE(x))
        assert list(whole(Fraction(3, 2))) != list(CURVE(Fraction(3, 2)))
        assert local.portion == (Fraction(1, 2), Fraction(5, 2))
        near = local.reduced(Fraction(1, 100))
        assert near.spline.space.degree == 2 and near.bound <= Fraction(1, 100)
        for x in PLACES:
            assert sum((near.spline(x) - whole(x)) ** 2) <= near.bound**2


def test_the_degree_is_kept_within_a_tolerance():
    tolerance = Fraction(1, 1000)
    near = fine_tuned_within(CURVE, ALPHA, tolerance)
    exact = fine_tuned_holding(CURVE, ALPHA).curve
    assert near.spline.space.degree == 2 and near.bound <= tolerance
    assert all(sum((near.spline(x) - exact(x)) ** 2) <= tolerance**2 for x in PLACES)


def test_a_scale_for_a_ratio():
    ratio = Spline(Space(1, [0, 0, 3, 3]), [1, 2])
    scale = scale_for_curvature_ratio(Space(3, [0] * 4 + [1, 2] + [3] * 4), ratio)
    assert all(abs(scale.spline(x) * ratio(x) - 1) < Fraction(1, 20) for x in PLACES)


LINE = Space(2, [0, 0, 0, 1, 2, 2, 2])
SURFACE = Surface(LINE, LINE, [[[i, j + i % 2] for j in range(4)] for i in range(4)])
SCALE = Surface(LINE, LINE, [[1 + Fraction(i * j, 5) for j in range(4)] for i in range(4)])
NET = [(Fraction(a, 4), Fraction(b, 4)) for a in range(9) for b in range(9)]


def test_surfaces_are_scaled_along_a_path():
    tuned = fine_tuned(SURFACE, SCALE, "uv")
    for u, v in NET:
        assert list(derivative_at(tuned, (u, v), (0, 1))) == list(SCALE(u, v) * derivative_at(SURFACE, (u, v), (0, 1)))
    both, other = fine_tuned(SURFACE, SCALE), fine_tuned(SURFACE, SCALE, "vu")
    gap = path_gap(SURFACE, SCALE)
    for u, v in NET:
        assert list(2 * both(u, v)) == list(tuned(u, v) + other(u, v))
        assert sum((tuned(u, v) - other(u, v)) ** 2) <= gap.bound**2
    from_end = fine_tuned_from(SURFACE, SCALE, "v_end")
    assert all(list(from_end(u, 2)) == list(SURFACE(u, 2)) for u, _ in NET)


def test_edges_of_surfaces_are_held():
    held = fine_tuned_holding(SURFACE, SCALE, edges="position")
    for t in [Fraction(k, 4) for k in range(9)]:
        for at in [(0, t), (2, t), (t, 0), (t, 2)]:
            assert list(held.surface(*at)) == list(SURFACE(*at))
    part = Space(2, [Fraction(1, 2)] * 3 + [Fraction(3, 2)] * 3)
    local, whole = fine_tuned_on(SURFACE, Surface(part, part, [[1] * 3] * 3), path="uv", edges="curvature")
    assert local.forced == 0 and all(list(whole(*at)) == list(SURFACE(*at)) for at in NET)


def test_edges_of_surfaces_are_kept_by_the_scale():
    scales = Space(2, [0, 0, 0, Fraction(1, 2), 1, Fraction(3, 2), 2, 2, 2])
    values = np.full((6, 6), Fraction(1))
    values[2, 2] = Fraction(3)
    alpha, conditions = Surface(scales, scales, values), [("edge", "v_start"), ("edge", "v_end", 0)]
    nearest = NearestScale(SURFACE, (scales, scales), conditions, path="uv").to(alpha)
    kept = fine_tuned(SURFACE, nearest, "uv")
    for t in [Fraction(k, 4) for k in range(9)]:
        assert list(kept(t, 2)) == list(SURFACE(t, 2))
    tuner = FineTuner(SURFACE, (scales, scales), conditions=conditions, path="uv")
    assert tuner.tuned(alpha) == kept


SCALES = Space(2, [0, 0, 0] + [Fraction(k, 2) for k in range(1, 6)] + [3, 3, 3])


@pytest.mark.parametrize(
    "condition",
    [
        ("point", 2, [3, 2]),
        ("chord", 1, 2, [1, 0]),
        ("derivatives", 2, 2),
        ("scale", 2, Fraction(3, 2)),
        ("coefficient", 3, Fraction(3, 2)),
    ],
    ids=lambda condition: condition[0],
)
def test_each_condition_of_a_curve(condition):
    wanted = Spline(SCALES, [1, 1, 2, 1, Fraction(4, 3), 1, 1, 1])
    alpha = NearestScale(CURVE, SCALES, [condition]).to(wanted, signed=True)
    tuned = fine_tuned(CURVE, alpha, signed=True)
    word, *rest = condition
    if word == "point":
        assert list(tuned(2)) == [3, 2]
    elif word == "chord":
        assert list(tuned(2) - tuned(1)) == [1, 0]
    elif word == "derivatives":
        for k in [1, 2]:
            assert list(derivative_at(tuned, 2, k)) == list(derivative_at(CURVE, 2, k))
    elif word == "scale":
        assert alpha(2) == rest[1]
    else:
        assert alpha.coeffs[3] == rest[1]
    # Among those that meet it none is nearer than the nearest: it does not move again.
    assert NearestScale(CURVE, SCALES, [condition]).to(alpha, signed=True) == alpha


@pytest.mark.parametrize(
    "condition",
    [
        ("derivative", (1, 1), (0, 0), [2, 2]),
        ("derivative", (1, 1), (0, 1), [0, 2]),
        ("scale", (1, 1), 2),
        ("coefficient", (1, 2), 2),
        ("edge", "v_end", 1),
    ],
    ids=lambda condition: condition[0],
)
def test_each_condition_of_a_surface(condition):
    scales = Space(2, [0, 0, 0] + [Fraction(k, 3) for k in range(1, 6)] + [2, 2, 2])
    wanted = Surface(scales, scales, [[1 + Fraction(i * j % 3, 4) for j in range(8)] for i in range(8)])
    alpha = NearestScale(SURFACE, (scales, scales), [condition], path="uv").to(wanted, signed=True)
    tuned = fine_tuned(SURFACE, alpha, "uv", signed=True)
    if condition[0] == "derivative":
        assert list(derivative_at(tuned, *condition[1:3])) == condition[3]
    elif condition[0] == "scale":
        assert alpha(1, 1) == 2
    elif condition[0] == "coefficient":
        assert alpha.coeffs[1, 2] == 2
    else:
        for u in [0, Fraction(1, 3), 1, Fraction(5, 4), 2]:
            for k in [0, 1]:
                assert list(derivative_at(tuned, (u, 2), (0, k))) == list(derivative_at(SURFACE, (u, 2), (0, k)))
