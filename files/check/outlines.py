"""svgelements and fontTools read the same outlines as we do."""

import json
import math
import os
import re
from io import StringIO

from fontTools.pens.recordingPen import DecomposingRecordingPen
from fontTools.ttLib import TTFont
from svgelements import SVG, Arc, Close, CubicBezier, Line, Move, Path, QuadraticBezier, Shape

from plain import FOLDER, check, convert, done, domains, items, value, we_read

# svgelements takes conjugate diameters for axes: arcs are only turned, mirrored and scaled evenly here.
DRAWING = """<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10">
<path transform="skewX(10) skewY(-5) scale(2 .5)" d="M1 2l3-1.5h2v4H1z m1 1q1 2 3 0t2 1c1 1 2-1 3 0s1 3 2 .5z"/>
<g transform="translate(3 -2) rotate(30)"><g transform="scale(2 -2)">
<path d="M0 0A3 2 20 0 1 4 1a1 1 0 1 0 2 2 3 5 70 1 1-1-1"/><circle cx="1" cy="2" r="3"/></g></g>
<ellipse cx="3" cy="4" rx="2" ry="1" transform="matrix(.6 .8 -.8 .6 1 2)"/>
<rect x="1" y="2" width="5" height="3"/><rect x="1" y="2" width="5" height="3" rx="1" ry=".5"/>
<line x1="1" y1="2" x2="3" y2="-4"/><polyline points="0 0 1 2,3 1 5 5"/><polygon points="0,0 4,1 2 5"/>
</svg>"""


def subpaths(name):
    """Each subpath of a drawing in the coordinates of the drawing."""
    # The window of the picture is no transform of its elements.
    text = re.sub(' viewBox="[^"]*"', "", (FOLDER / name).read_text())
    for shape in SVG.parse(StringIO(text), reify=True).elements():
        if isinstance(shape, Shape):
            for part in Path(shape).reify().as_subpaths():
                pieces = [piece for piece in part if not isinstance(piece, Move)]
                yield [piece for piece in pieces if not (isinstance(piece, Close) and piece.start == piece.end)]


def on_ellipse(arc, point):
    """How far a point is from the ellipse of an arc, in the size of the ellipse."""
    x, y = point[0] - arc.center.x, point[1] - arc.center.y
    turn = arc.get_rotation().as_radians
    u, v = x * math.cos(turn) + y * math.sin(turn), y * math.cos(turn) - x * math.sin(turn)
    return abs(math.hypot(u / arc.rx, v / arc.ry) - 1)


def compare(name, tolerance, what):
    """Each piece is over one unit of our parameter, an arc over one for each begun quarter."""
    ours, theirs = [spline for _, spline in we_read(name)], list(subpaths(name))
    check(len(ours) == len(theirs), f"{what}: {len(ours)} and {len(theirs)} subpaths")
    worst, count = 0.0, 0
    for spline, pieces in zip(ours, theirs):
        k, end = 0, domains(spline)[0][1]
        for number, piece in enumerate(pieces):
            units = end - k - (len(pieces) - number - 1) if len(pieces) == 1 else 1
            if isinstance(piece, Arc) and len(pieces) > 1:
                units = math.ceil(abs(piece.sweep) / (math.pi / 2) - 1e-9)
            for i in range(1, 8):
                found = value(spline, [k + units * i / 8])
                if isinstance(piece, Arc):
                    off = on_ellipse(piece, found)
                else:
                    point = piece.point(i / 8)
                    off = math.dist(found[:2], (point.x, point.y)) / max(abs(point.x), abs(point.y), 1)
                worst = max(worst, off)
            k, count = k + units, count + 1
        check(k == end, f"{what}: {k} pieces and not {end}")
    check(worst <= tolerance, f"{what}: {worst}")
    print(f"{what}: {count} pieces, which differ by {worst:.1e} at most")


def letters(font, text):
    """The contours of a text as control points of lines and parabolas."""
    glyphs, names, widths = font.getGlyphSet(), font.getBestCmap(), font["hmtx"]
    shift = 0
    for letter in text:
        pen = DecomposingRecordingPen(glyphs)
        glyphs[names[ord(letter)]].draw(pen)
        for kind, points in pen.value:
            points = [(x + shift, y) for x, y in (p for p in points if p)]
            if kind == "moveTo":
                contour = [points[0]]
            elif kind == "lineTo":
                contour.append(points[0])
            elif kind == "qCurveTo":
                # Between two points that are off the curve there is one on it.
                for p, q in zip(points[:-1], points[1:-1]):
                    contour += [p, ((p[0] + q[0]) / 2, (p[1] + q[1]) / 2)]
                contour += points[-2:]
            else:
                yield contour
        shift += widths[names[ord(letter)]][0]


(FOLDER / "drawing.svg").write_text(DRAWING)
compare("drawing.svg", 1e-12, "svgelements and we read a drawing")
plane = [item for item in json.loads((FOLDER / "curves.json").read_text())["items"] if "2D" in item["name"]]
low = [item for item in plane if "spline" in item["value"] and item["value"]["spline"]["space"]["degree"] <= 3]
for name, some in (("cubics", low), ("plane", [item for item in plane if "degree 9" not in item["name"] and "degree 16" not in item["name"]])):
    (FOLDER / f"{name}.json").write_text(json.dumps({"format": "symspline", "version": 1, "items": some}))
    convert(f"{name}.json", f"{name}.svg")
    compare(f"{name}.svg", 1e-12, f"svgelements and we read our own {name}")
# The drawing against the splines themselves: pieces over equal shares of nothing, so by the ends of each.
drawn = we_read("cubics.svg")
for (name, spline), (_, again) in zip(items("cubics.json"), drawn):
    breaks = sorted({t for t in spline["knots"][0] if domains(spline)[0][0] <= t <= domains(spline)[0][1]})
    check(len(breaks) == domains(again)[0][1] + 1, f"{name}: {len(breaks) - 1} pieces")
    for k, (a, b) in enumerate(zip(breaks, breaks[1:])):
        for i in range(1, 8):
            off = math.dist(value(spline, [a + (b - a) * i / 8]), value(again, [k + i / 8]))
            check(off <= 1e-13, f"{name} in SVG is off by {off}")
print(f"splines of degree 3 and less in SVG: {len(drawn)} are the same piece by piece")

TEXT = "Qé8 &@ß"
FONT = os.path.abspath("assets/fonts/DejaVuSans.ttf")
convert(FONT, "letters.json", "--text", TEXT)
found, told = items("letters.json"), list(letters(TTFont(FONT), TEXT))
check(len(found) == len(told), f"{len(found)} contours, not {len(told)}")
for (name, spline), contour in zip(found, told):
    points = {point[:2] for point in spline["points"]}
    check(all((float(x), float(y)) in points for x, y in contour), f"the outline of {name}")
print(f"fontTools: {len(told)} contours have the same points")
done()
