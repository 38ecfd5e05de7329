"""geomdl reads what we write and we read what it writes, with the same points on both."""

import json
import os
import subprocess
import sys
import tempfile

from geomdl import BSpline, NURBS, exchange, multi

CONVERT = sys.argv[1]
STEPS = 16


def ours(path):
    lines = subprocess.run([CONVERT, path], check=True, capture_output=True, text=True).stdout.splitlines()
    shapes = []
    for line in lines:
        dim, numbers = line.split(" ", 1)
        flat = json.loads(numbers)
        shapes.append([flat[i : i + int(dim)] for i in range(0, len(flat), int(dim))])
    return shapes


def steps(domain):
    a, b = domain
    return [b if i == STEPS else a + (b - a) * i / STEPS for i in range(STEPS + 1)]


def theirs(shape):
    if shape.pdimension == 1:
        return shape.evaluate_list(steps(shape.domain))
    u, v = shape.domain
    return shape.evaluate_list([(s, t) for s in steps(u) for t in steps(v)])


def same(found, expected, what):
    assert len(found) == len(expected), what
    for p, q in zip(found, expected):
        assert len(p) == len(q) and all(abs(x - y) <= 1e-13 * (1 + abs(y)) for x, y in zip(p, q)), (what, p, q)


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


with tempfile.TemporaryDirectory() as folder:
    for name, (written, *members) in shapes().items():
        members = members or [written]
        path, back = (os.path.join(folder, name + end) for end in (".json", ".back.geomdl.json"))
        exchange.export_json(written, path)
        for found, expected in zip(ours(path), members, strict=True):
            same(found, theirs(expected), name + " read")
        subprocess.run([CONVERT, path, back], check=True)
        for found, expected in zip(exchange.import_json(back), members, strict=True):
            same(theirs(found), theirs(expected), name + " written")
print("geomdl: the same points both ways")
