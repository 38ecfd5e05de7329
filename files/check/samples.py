"""Curves and surfaces of many kinds, written as our JSON and converted to the other formats by the program."""

import json
import random

from plain import FOLDER, convert

dice = random.Random(1)


def numbers(count, size=1.0):
    return [dice.uniform(-size, size) for _ in range(count)]


def knots(count):
    """Knots that grow by steps with all digits."""
    all = [dice.uniform(-1, 1)]
    while len(all) < count:
        all.append(all[-1] + dice.uniform(0.2, 2.2))
    return all


def spaces(p):
    """The spaces of a degree and their dimensions: Bézier, clamped with double knots, unclamped, periodic with single and double seams."""
    ends = [dice.uniform(-2, -1)] * (p + 1) + [dice.uniform(1, 2)] * (p + 1)
    inner = knots(5)
    double = [inner[2]] * (2 if p > 1 else 1)
    clamped = [inner[0]] * (p + 1) + [inner[1]] + double + [inner[3]] + [inner[4]] * (p + 1)
    ring = knots(p + 3)
    yield "Bézier", {"degree": p, "knots": ends}, p + 1
    yield "clamped", {"degree": p, "knots": clamped}, len(clamped) - p - 1
    yield "unclamped", {"degree": p, "knots": knots(2 * p + 5)}, p + 4
    yield "periodic", {"degree": p, "knots": ring, "end": ring[-1] + 0.7}, p + 3
    if p > 1:
        yield "periodic, seamed", {"degree": p, "knots": [ring[0], *ring], "end": ring[-1] + 0.7}, p + 4


def both(name, kind, over, dim, count, size):
    """A polynomial and a rational spline."""
    points = [numbers(dim, size) for _ in range(count)]
    yield {"name": name, "value": {kind[0]: {"field": "float", **over, "points": points}}}
    weights = [dice.uniform(0.5, 2.5) for _ in range(count)]
    yield {"name": f"rational {name}", "value": {kind[1]: {"field": "float", **over, "points": points, "weights": weights}}}


def curves():
    for p in (1, 2, 3, 5, 9, 16):
        for word, space, count in spaces(p):
            for dim, size in ((2, 1.0), (3, 1e3)):
                name = f"{word.replace('é', 'e')} curve of degree {p} in {dim}D"
                yield from both(name, ("spline", "rational"), {"space": space}, dim, count, size)
    for size in (1e-5, 1e6, 1e12):
        space = {"degree": 3, "knots": [0.0] * 4 + [1e-3 * size] + [size] * 4}
        yield from both(f"curve of size {size}", ("spline", "rational"), {"space": space}, 3, 5, size)


def surfaces():
    for p, q in ((1, 1), (2, 3), (4, 2)):
        for u_word, u, rows in spaces(p):
            for v_word, v, columns in spaces(q):
                name = f"surface of degree {p} ({u_word}) and {q} ({v_word})".replace("é", "e")
                yield from both(name, ("surface", "rational_surface"), {"u": u, "v": v}, 3, rows * columns, 100.0)


def cube():
    points = [[x, y, z] for x in (0.0, 2.0) for y in (0.0, 3.0) for z in (0.0, 5.0)]
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    yield {"name": "cube", "value": {"mesh": {"field": "float", "points": points, "faces": faces}}}


def bowl():
    """The graph of x² + y²."""
    space = {"degree": 2, "knots": [-1.0] * 3 + [1.0] * 3}
    x, square = (-1.0, 0.0, 1.0), (1.0, -1.0, 1.0)
    points = [[x[i], x[j], square[i] + square[j]] for i in range(3) for j in range(3)]
    yield {"name": "bowl", "value": {"surface": {"field": "float", "u": space, "v": space, "points": points}}}


for name, values, endings in (
    ("curves", curves(), ("dxf", "step", "iges", "obj", "geomdl.json")),
    ("surfaces", surfaces(), ("step", "iges", "obj", "geomdl.json")),
    ("cube", cube(), ("obj", "ply", "stl", "glb")),
    ("bowl", bowl(), ("ply", "stl", "glb")),
):
    text = json.dumps({"format": "symspline", "version": 1, "items": list(values)})
    (FOLDER / f"{name}.given.json").write_text(text)
    # Of the points that give the same product with their weight the program has one: that is compared.
    convert(f"{name}.given.json", f"{name}.json")
    for ending in endings:
        convert(f"{name}.json", f"{name}.{ending}")
