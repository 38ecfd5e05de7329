"""A reader of free-form OBJ made of the words of the format reads what we write."""

from plain import FOLDER, compare, done, items


def splines(name):
    vertices, plane = [], []
    for line in (FOLDER / name).read_text().splitlines():
        word, *rest = line.split()
        if word == "v" or word == "vp":
            numbers = [float(x) for x in rest]
            point, weight = (numbers[:3], numbers[3:]) if word == "v" else ([*numbers[:2], 0.0], numbers[2:])
            (vertices if word == "v" else plane).append((tuple(point), weight))
        elif word == "cstype":
            rational = rest[0] == "rat"
        elif word == "deg":
            degrees, knots = [int(x) for x in rest], []
        elif word in ("curv", "curv2", "surf"):
            ends = {"curv": 2, "curv2": 0, "surf": 4}[word]
            points = [(plane if word == "curv2" else vertices)[int(i) - 1] for i in rest[ends:]]
        elif word == "parm":
            knots.append([float(x) for x in rest[1:]])
        elif word == "end":
            # Of a surface the index of u runs first.
            rows = len(knots[0]) - degrees[0] - 1
            points = [point for i in range(rows) for point in points[i::rows]]
            weights = [weight for _, (weight,) in points] if rational else None
            yield {"degrees": degrees, "knots": knots, "points": [point for point, _ in points], "weights": weights}


for kind in ("curves", "surfaces"):
    compare(items(f"{kind}.json"), [[s] for s in splines(f"{kind}.obj")], f"a reader of OBJ reads {kind}", all_exact=True)
done()
