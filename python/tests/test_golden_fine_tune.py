"""Golden values of fine tuning and curvature: equal over fractions, within roundings over floats."""

from fractions import Fraction

import numpy as np
import pytest
from golden_cases import check_spline, curve_of, flat, function_of, golden, read
from symspline import Space, Spline, Surface, SymsplineError
from symspline.analysis import curvature, curvature_squared
from symspline.fine_tune import (
    FineTuner,
    NearestScale,
    fine_tuned,
    fine_tuned_closed,
    fine_tuned_holding,
    fine_tuned_on,
    scale_moments,
)
from symspline.shape import derivative_at


@golden("fine_tune", 10)
def test_fine_tune(case):
    tuned = fine_tuned(curve_of(case), function_of(case), signed=True)
    check_spline(case, tuned, "degree", "W", "Q")
    knots = sorted(set(read(case.case["W"], Fraction)))
    h = float(min(b - a for a, b in zip(knots, knots[1:])))
    size = max(abs(float(x)) for x in flat(read(case.case["Q"], Fraction)))
    for sample in case.case["samples"]:
        t = read(sample["t"], case.number)
        for k, key in enumerate(["D", "D1", "D2"]):
            case.check(derivative_at(tuned, t, k), sample[key], size=size * (2 * tuned.space.degree / h) ** k)


@golden("fine_tune_end", 14)
def test_fine_tune_end(case):
    curve, alpha = curve_of(case), function_of(case)
    check_spline(case, fine_tuned(curve, alpha, signed=True), "degree", "W", "Q_free")
    hold = ["points", "tangents", "curvatures"][case["j"]]
    if not case.has("Q"):
        with pytest.raises(SymsplineError) as caught:
            fine_tuned_holding(curve, alpha, hold, signed=True)
        assert caught.value.kind == "NoChord"
    elif case.is_exact and curve.coeffs.shape[1] == 3:
        with pytest.raises(SymsplineError) as caught:
            fine_tuned_holding(curve, alpha, hold, signed=True)
        assert caught.value.kind == "NoSuch"
    else:
        check_spline(case, fine_tuned_holding(curve, alpha, hold, signed=True).curve, "degree", "W", "Q")
        tuner = FineTuner(curve, alpha.space, hold=hold, signed=True)
        case.key(tuner.tuned(alpha.coeffs).coeffs, "Q", 1024)


@golden("local_fine_tune", 2)
def test_local_fine_tune(case):
    curve, alpha = curve_of(case), function_of(case)
    local = fine_tuned_on(curve, alpha, ["points", "tangents", "curvatures"][case["j"]], signed=True)
    check_spline(case, local.tuned.curve, "degree", "W", "Q")
    case.check(local.portion, [case.case["a"], case.case["b"]])
    whole = local.joined()
    for sample in case.case["samples"]:
        case.check(whole(read(sample["t"], case.number)), sample["point"])


NORMS = {"coef": "coefficients", "L2": "l2"}


@golden("alpha_preserve_ends", 6)
def test_alpha_preserve_ends(case):
    curve, wanted = curve_of(case), function_of(case, "alpha0")
    conditions = ["end"] + [("coefficient", int(i), value) for i, value in case["fixed"].items()]
    norm = NORMS[case["norm"]]
    size = max(abs(float(x)) for key in ["Q", "moments", "alpha"] for x in flat(read(case.case[key], Fraction)))
    alpha = NearestScale(curve, wanted.space, conditions, norm).to(wanted, signed=True)
    case.key(alpha.coeffs, "alpha", size=size)
    tuner = FineTuner(curve, wanted.space, conditions=conditions, norm=norm, signed=True)
    case.key(tuner.tuned(wanted).coeffs, "Q", size=size)
    start, end = wanted.space.knots[0], wanted.space.knots[-1]
    case.key(scale_moments(curve, wanted.space, start, end), "moments", size=size)


def ring(case, degree, m):
    return Space(degree, [case.number(Fraction(k, m)) for k in range(m)], case.number(Fraction(1)))


@golden("closed_alpha_preserve", 2)
def test_closed_alpha_preserve(case):
    polygon = case["polygon"]
    curve = Spline(ring(case, 2, len(polygon)), polygon)
    wanted = Spline(ring(case, 1, len(polygon)), case["a0"])
    norm = NORMS[case["norm"]]
    case.key(NearestScale(curve, wanted.space, ["end"], norm).to(wanted).coeffs, "a")
    tuned = FineTuner(curve, wanted.space, conditions=["end"], norm=norm).tuned(wanted)
    check_ring(case, tuned)


def check_ring(case, tuned):
    """Over a ring the list may start elsewhere: it is the same list turned."""
    found, expected = [list(p) for p in tuned.coeffs], read(case.case["Q"], Fraction)
    starts = range(len(expected))
    turned = [found[k:] + found[:k] for k in starts]
    distance = [max(abs(Fraction(x) - y) for p, q in zip(one, expected) for x, y in zip(p, q)) for one in turned]
    case.check(turned[distance.index(min(distance))], case.case["Q"])


@golden("closed_quadratic_to_cubic", 2)
def test_closed_quadratic_to_cubic(case):
    quadratic = Spline(ring(case, 2, len(case["polygon"])), case["polygon"])
    cubic = quadratic.elevate()
    assert cubic.degree == 3 and cubic.space.is_periodic and cubic.space.dim == len(case["Q"])
    case.key(quadratic.space.knots, "U", 1)
    case.key(cubic.space.knots[:-1], "U_hat", 1)
    case.key(cubic.coeffs, "Q", 4)
    for spline, key in [(quadratic, "P_wrapped"), (cubic, "Q_wrapped")]:
        slots = [spline.space.slot(i) for i in range(len(case[key]))]
        case.key(spline.coeffs[slots], key, 4)


@golden("closed_fine_tune_open", 2)
def test_closed_fine_tune_open(case):
    polygon, m = case["polygon"], len(case["polygon"])
    tuned = fine_tuned(Spline(ring(case, 2, m), polygon), Spline(ring(case, 1, m), case["a"]), signed=True)
    doubled = Space(3, [case.number(Fraction(k, m)) for k in range(-1, m + 2) for _ in range(2)])
    controls = tuned.embedded(doubled).coeffs
    size = max(abs(float(x)) for x in flat(read(case.case["Q"], Fraction)))
    case.key(controls, "Q", 4)
    case.key(np.diff(controls, axis=0)[: 2 * m], "legs", 4, size)
    case.key(tuned(1) - tuned(0), "drift", 8, size)


@golden("closed_spring", 2, fields=("float",))
def test_closed_spring(case):
    polygon, m = case["polygon"], len(case["polygon"])
    # The lengths of the file are of the curve over a ring of length m.
    curve = Spline(Space(2, [float(k) for k in range(m)], float(m)), polygon)
    alpha = Spline(Space(1, [float(k) for k in range(m)], float(m)), case["a"])
    relaxed = fine_tuned_closed(curve, alpha, stretch=case["k_l"], bend=case["k_a"], tolerance=1e-11)
    assert relaxed.converged
    assert abs(relaxed.energy_before - case["E_initial"]) < 1e-8
    assert abs(relaxed.energy - case["E_min"]) < 1e-8


def surface_of(case):
    surface = Surface(Space(case["p"], case["U"]), Space(case["q"], case["V"]), case["P"])
    alpha = Surface(Space(case["alpha_p"], case["alpha_U"]), Space(case["alpha_q"], case["alpha_V"]), case["alpha"])
    return surface, alpha


@golden("surface_T", 4)
def test_surface_T(case):
    surface, alpha = surface_of(case)
    for path, key in [("uv", "T_uv"), ("vu", "T_vu"), ("both", "T")]:
        case.check(fine_tuned(surface, alpha, path, signed=True).coeffs, case.case[key]["P"])


@golden("surface_T_boundary", 2)
def test_surface_T_boundary(case):
    surface, alpha = surface_of(case)
    for path, key, edges in [
        ("uv", "T_uv", {"v_start": "position", "v_end": "position"}),
        ("vu", "T_vu", {"u_start": "position", "u_end": "position"}),
    ]:
        held = fine_tuned_holding(surface, alpha, path=path, edges=edges, signed=True)
        case.check(held.surface.coeffs, case.case[key]["P"])
    both = fine_tuned_holding(surface, alpha, path="both", edges="position", signed=True)
    if case.is_exact:
        assert (both.forced == 0) == case["border_is_one"]


@golden("surface_alpha_border", 3)
def test_surface_alpha_border(case):
    surface, alpha = surface_of(case)
    case.check(fine_tuned(surface, alpha, "both", signed=True).coeffs, case.case["T"]["P"])


def check_curvature(case):
    """The squared curvature as a function, over fractions; the curvature itself, over floats."""
    curve, squared = curve_of(case, "p"), float(Fraction(case.case["kappa2"]))
    if case.is_exact:
        case.key(curvature_squared(curve)(case["t"]), "kappa2")
    (found,) = curvature(curve, [float(case["t"])])
    assert abs(found**2 - squared) <= 256 * np.finfo(float).eps * squared
    return found


@golden("curvature2d", 3)
def test_curvature2d(case):
    assert (check_curvature(case) < 0) == (case["N"] < 0)


@golden("curvature3d", 3)
def test_curvature3d(case):
    assert check_curvature(case) >= 0
