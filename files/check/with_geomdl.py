"""geomdl reads what we write, and we read what it writes, with the same points on both."""

import math

from geomdl import BSpline, NURBS, exchange, multi

from plain import FOLDER, check, done, domains, items, size, value, we_read


def theirs(shape, shares):
    """Points of a shape of geomdl at shares of its domain."""
    ends = [shape.domain] if shape.pdimension == 1 else shape.domain
    place = [a + (b - a) * share for (a, b), share in zip(ends, shares)]
    point = shape.evaluate_single(place[0] if shape.pdimension == 1 else place)
    return [*point, 0.0][:3]


def compare(ours, shapes, what):
    worst = 0.0
    check(len(ours) == len(shapes), f"{what}: {len(ours)} and {len(shapes)}")
    for (_, spline), shape in zip(ours, shapes):
        for i in range(1, 12):
            shares = [i * k % 12 / 12 for k in (1, 5)]
            place = [a + (b - a) * share for (a, b), share in zip(domains(spline), shares)]
            worst = max(worst, math.dist(value(spline, place), theirs(shape, shares)) / size(spline))
    check(worst <= 1e-11, f"{what}: {worst}")
    print(f"{what}: {len(ours)} by values, which differ by {worst:.1e} of the size at most")


def shapes():
    cubic = BSpline.Curve()
    cubic.degree = 3
    cubic.ctrlpts = [[0, 0], [1, 2], [3, 0], [4, 4], [6, 1]]
    cubic.knotvector = [0, 0, 0, 0, 0.4, 1, 1, 1, 1]
    arc = NURBS.Curve()
    arc.degree = 2
    arc.ctrlpts = [[1, 0, 0], [1, 1, 0], [0, 1, 0.5]]
    arc.weights = [1, 0.7, 2]
    arc.knotvector = [0, 0, 0, 1, 1, 1]
    bump = BSpline.Surface()
    bump.degree_u, bump.degree_v = 1, 2
    bump.set_ctrlpts([[i, j, (i * j) % 3 / 7] for i in range(3) for j in range(4)], 3, 4)
    bump.knotvector_u, bump.knotvector_v = [0, 0, 0.3, 1, 1], [0, 0, 0, 0.6, 1, 1, 1]
    # geomdl takes points times weights here.
    shell = NURBS.Surface()
    shell.degree_u, shell.degree_v = 1, 2
    weights = [1, 0.5, 1, 1, 2, 1]
    points = [[0, 0, 0], [0, 1, 0], [0, 2, 1], [1, 0, 0], [1, 0.5, 0], [1, 2, 1]]
    shell.set_ctrlpts([[x * w for x in p] + [w] for p, w in zip(points, weights)], 2, 3)
    shell.knotvector_u, shell.knotvector_v = [0, 0, 1, 1], [0, 0, 0, 1, 1, 1]
    pair = multi.CurveContainer()
    pair.add(arc)
    pair.add(arc)
    return {"cubic": [cubic], "arc": [arc], "bump": [bump], "shell": [shell], "pair": [pair, arc, arc]}


for kind in ("curves", "surfaces"):
    compare(items(f"{kind}.json"), exchange.import_json(str(FOLDER / f"{kind}.geomdl.json")), f"geomdl reads {kind}")
for name, (written, *members) in shapes().items():
    exchange.export_json(written, str(FOLDER / f"{name}.geomdl.json"))
    compare(we_read(f"{name}.geomdl.json"), members or [written], f"we read the {name} of geomdl")
done()
