"""Splines as plain data - degrees, full knots, rows of points in space, rows of weights - and their values by the definition."""

import json
import math
import subprocess
import sys
from pathlib import Path

PROGRAM, FOLDER = sys.argv[1], Path(sys.argv[2])
failures = 0


def check(holds, what):
    global failures
    if not holds:
        failures += 1
        print("DIFFERS:", what)


def done():
    sys.exit(f"{failures} differ" if failures else 0)


def convert(given, wanted, *more):
    """What the program makes of a file in the folder."""
    subprocess.run([PROGRAM, "convert", FOLDER / given, FOLDER / wanted, *more], check=True)


def unrolled(space):
    """The full knots of a space in our JSON, and which control point each of the unrolled ones is."""
    degree, knots = space["degree"], space["knots"]
    if "end" not in space:
        return knots, list(range(len(knots) - degree - 1))
    m, end = len(knots), space["end"]
    seam, period = knots.count(knots[0]), end - knots[0]
    full = []
    for j in range(m + 2 * degree + 2 - seam):
        turns, i = divmod(j - (degree + 1 - seam), m)
        full.append(knots[i] if turns == 0 else end if turns == 1 and i < seam else knots[i] + period * turns)
    return full, [i % m for i in range(m + degree + 1 - seam)]


def plain(item):
    """A spline of our JSON."""
    (kind, form), = item["value"].items()
    spaces = [form["space"]] if "space" in form else [form["u"], form["v"]]
    knots, picks = zip(*map(unrolled, spaces))
    count = 1 if len(spaces) == 1 else max(picks[1]) + 1
    order = [i * count + j for i in picks[0] for j in (picks[1] if len(spaces) == 2 else [0])]
    in_space = [(*p, 0.0)[:3] for p in form["points"]]
    weights = form.get("weights")
    return {
        "degrees": [space["degree"] for space in spaces],
        "knots": [list(all) for all in knots],
        "points": [tuple(map(float, in_space[i])) for i in order],
        "weights": [float(weights[i]) for i in order] if weights else None,
    }


def items(name):
    """The names and splines of a JSON file in the folder."""
    return [(item.get("name"), plain(item)) for item in json.loads((FOLDER / name).read_text())["items"]]


def we_read(name):
    """What the program reads in a file of another format."""
    convert(name, name + ".json")
    return items(name + ".json")


def bits(x):
    return [bits(y) for y in x] if isinstance(x, (list, tuple)) else None if x is None else float(x).hex()


def same(left, right):
    """Whether all numbers are, bit by bit."""
    return left["degrees"] == right["degrees"] and all(
        bits(left[key]) == bits(right[key]) for key in ("knots", "points", "weights")
    )


def along(p, t, coeffs, x):
    """The value of a spline by the definition: de Boor's."""
    k = max(i for i in range(p, len(coeffs)) if t[i] <= x and t[i] < t[i + 1])
    d = coeffs[k - p : k + 1]
    for r in range(1, p + 1):
        for j in range(p, r - 1, -1):
            i = k - p + j
            a = (x - t[i]) / (t[i + p - r + 1] - t[i])
            d[j] = [(1 - a) * y + a * z for y, z in zip(d[j - 1], d[j])]
    return d[p]


def value(spline, place):
    weights = spline["weights"] or [1.0] * len(spline["points"])
    lifted = [[*(w * c for c in point), w] for point, w in zip(spline["points"], weights)]
    for p, t, x in reversed(list(zip(spline["degrees"], spline["knots"], place))):
        n = len(t) - p - 1
        lifted = [along(p, t, lifted[i : i + n], x) for i in range(0, len(lifted), n)]
    return [c / lifted[0][3] for c in lifted[0][:3]]


def domains(spline):
    return [(t[p], t[-p - 1]) for p, t in zip(spline["degrees"], spline["knots"])]


def size(spline):
    return max(abs(c) for point in spline["points"] for c in point)


def covered(spline, pieces):
    """Whether the pieces are the whole domain: those of a curve lie end to end, to the last digits."""
    whole = domains(spline)
    parts = sorted(domains(piece) for piece in pieces)
    if len(whole) == 2:
        parts, whole = [sum(parts[0], ())] if len(parts) == 1 else [], sum(whole, ())
        return bool(parts) and all(math.isclose(x, y, rel_tol=1e-13, abs_tol=1e-13) for x, y in zip(parts[0], whole))
    ends = [whole[0][0], *(part[0][1] for part in parts)]
    starts = [*(part[0][0] for part in parts), whole[0][1]]
    return all(math.isclose(x, y, rel_tol=1e-13, abs_tol=1e-13) for x, y in zip(ends, starts))


def compare(ours, theirs, what, all_exact=False, tolerance=1e-11):
    """Readers cut curves where they have kinks, and take knots beyond the domain off: then values are compared."""
    check(len(ours) == len(theirs), f"{what}: {len(ours)} items, {len(theirs)} are read")
    exact, valued, worst = 0, 0, 0.0
    for (name, spline), pieces in zip(ours, theirs):
        if len(pieces) == 1 and same(spline, pieces[0]):
            exact += 1
            continue
        if all_exact or not covered(spline, pieces):
            check(False, f"{what}: {name}")
            continue
        valued += 1
        for piece in pieces:
            for i in range(1, 12):
                place = [a + (b - a) * (i * k % 12) / 12 for (a, b), k in zip(domains(piece), (1, 5))]
                worst = max(worst, math.dist(value(spline, place), value(piece, place)) / size(spline))
    check(worst <= tolerance, f"{what}: values differ by {worst} of the size")
    print(f"{what}: {exact} bit by bit, {valued} by values, which differ by {worst:.1e} of the size at most")
