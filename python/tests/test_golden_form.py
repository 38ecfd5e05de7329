"""Golden values of warps, flat parts and bends: equal over fractions, within roundings over floats."""

import numpy as np
from golden_cases import curve_of, golden
from symspline import Space, Spline
from symspline.shape import bent, bent_point, bump, carried, flattened, local_ranges, warped


@golden("local_range", 5)
def test_local_range(case):
    free, left, right = local_ranges(Space(case["p"], case["U"]), case["u_s"], case["u_e"])
    assert list(range(*free)) == case["free"]
    assert free[0] == case["s"] and free[1] + case["p"] == case["e"]
    both = (max(left[0], right[0]), min(left[1], right[1]))
    keys = ["removable"] * 3 if case["p"] % 2 else [f"removable_{k}" for k in ["keep_left", "keep_right", "either"]]
    for key, (start, end) in zip(keys, [left, right, both]):
        if key in case.case:
            assert case[key] == ([start, end - 1] if start < end else None if case[key] is None else [])


@golden("warp_f", 8)
def test_warp_f(case):
    case.key(bump(case["w3"], case["t"]), "f")


@golden("warp_f2", 8)
def test_warp_f2(case):
    case.key(bump(case["w33"], (case["s"], case["t"])), "f")


@golden("warp_curve", 1)
def test_warp_curve(case):
    curve, w = curve_of(case, "p"), case["w3"]
    vector = [case["d"] * x for x in case["W"]]
    found = warped(curve, case["u_s"], case["u_e"], lambda share, _: bump(w, share), vector=vector, shares=case["t"])
    assert found.moved == len(case["t"]) and found.inserted == []
    case.key(found.shape.coeffs, "P_out")
    chords = warped(curve, case["u_s"], case["u_e"], lambda s, _: bump(w, s), vector=vector, shares="chords")
    assert np.allclose(np.array(chords.shape.coeffs, float), np.array(found.shape.coeffs, float), atol=1e-13)


def polygon(points):
    """The curve of degree 1 through points."""
    count = len(points)
    return Spline(Space(1, [0] + list(range(count)) + [count - 1]), points)


@golden("flatten_line", 4)
def test_flatten_line(case):
    found = flattened(polygon(case["P"]), case["Q"], line=case["dir"], along=case["W"])
    case.key(found.shape.coeffs, "P_out")


@golden("flatten_plane", 2)
def test_flatten_plane(case):
    found = flattened(polygon(case["P"]), case["Q"], normal=case["N"], along=case["W"])
    case.key(found.shape.coeffs, "P_out")


@golden("bend_point", 12)
def test_bend_point(case):
    found = bent_point(case["O"], case["P"], case["s"], case["lam"])
    if case.has("P_out"):
        case.key(found, "P_out")
    else:
        assert found is None


@golden("bend_circle", 3)
def test_bend_circle(case):
    found = bent(polygon([case["P"]] * 2), case["O"], case["lam"], radius=case["r"])
    case.key(found.coeffs[0], "P_out")


@golden("bend_cylinder", 3)
def test_bend_cylinder(case):
    found = bent(polygon([case["P"]] * 2), case["Q"], case["lam"], radius=case["r"], axis=case["V"])
    case.key(found.coeffs[1], "P_out")


@golden("bend_rest", 2)
def test_bend_rest(case):
    check_rest(case)


@golden("bend_rest3", 1)
def test_bend_rest3(case):
    check_rest(case)


def check_rest(case):
    case.key(carried(case["rest"], case["P_t1"], case["P_t"], case["Phat_t1"], case["Phat_t"]), "rest_out")
