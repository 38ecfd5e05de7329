"""Files of symspline read by ezdxf and OpenCASCADE, and files of theirs read by symspline.

Control points, knots and weights are compared bit by bit; where a reader cuts a curve into edges, values are.
"""

import ezdxf
from OCP.BRep import BRep_Tool
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeFace
from OCP.collections import Array1_double, Array1_gp_Pnt, Array1_int, Array2_double, Array2_gp_Pnt
from OCP.Geom import Geom_BSplineCurve, Geom_BSplineSurface
from OCP.gp import gp_Pnt
from OCP.IFSelect import IFSelect_RetDone
from OCP.IGESControl import IGESControl_Reader, IGESControl_Writer
from OCP.Message import Message, Message_Gravity
from OCP.STEPControl import STEPControl_AsIs, STEPControl_Reader, STEPControl_Writer
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS

from plain import FOLDER, check, compare, done, items, we_read

# Its readers tell of every step.
for printer in Message.DefaultMessenger_s().Printers():
    printer.SetTraceLevel(Message_Gravity.Message_Fail)


def of_occt(g):
    """A spline of OpenCASCADE. It drops weights that are all equal; its own periodic spaces are opened."""
    if isinstance(g, Geom_BSplineCurve):
        if g.IsPeriodic():
            g.SetNotPeriodic()
        n, rational = g.NbPoles(), g.IsRational()
        full = [[g.Knot(i) for i in range(1, g.NbKnots() + 1) for _ in range(g.Multiplicity(i))]]
        places, degrees = [(i,) for i in range(1, n + 1)], [g.Degree()]
    else:
        g.IsUPeriodic() and g.SetUNotPeriodic()
        g.IsVPeriodic() and g.SetVNotPeriodic()
        rational = g.IsURational() or g.IsVRational()
        u = [g.UKnot(i) for i in range(1, g.NbUKnots() + 1) for _ in range(g.UMultiplicity(i))]
        v = [g.VKnot(i) for i in range(1, g.NbVKnots() + 1) for _ in range(g.VMultiplicity(i))]
        full, degrees = [u, v], [g.UDegree(), g.VDegree()]
        places = [(i, j) for i in range(1, g.NbUPoles() + 1) for j in range(1, g.NbVPoles() + 1)]
    poles = [g.Pole(*place) for place in places]
    return {
        "degrees": degrees,
        "knots": full,
        "points": [(p.X(), p.Y(), p.Z()) for p in poles],
        "weights": [g.Weight(*place) for place in places] if rational else None,
    }


# --- geometry in shapes of OpenCASCADE


def geometry(shape, faces):
    explorer = TopExp_Explorer(shape, TopAbs_FACE if faces else TopAbs_EDGE)
    while explorer.More():
        if faces:
            yield BRep_Tool.Surface_s(TopoDS.Face(explorer.Current()))
        else:
            yield BRep_Tool.Curve_s(TopoDS.Edge(explorer.Current()), 0.0, 1.0)
        explorer.Next()


def occt_reads(reader, name, faces):
    """The splines of each root of a file."""
    check(reader.ReadFile(str(FOLDER / name)) == IFSelect_RetDone, f"{name} is refused")
    reader.TransferRoots()
    shapes = [reader.Shape(i) for i in range(1, reader.NbShapes() + 1)]
    return [[of_occt(g) for g in geometry(shape, faces)] for shape in shapes]


# --- what we write


def read_by_others():
    curves, surfaces = items("curves.json"), items("surfaces.json")
    compare(curves, [[g] for shape in occt_reads(STEPControl_Reader(), "curves.step", False) for g in shape], "OCCT reads STEP curves")
    compare(surfaces, [[g] for shape in occt_reads(STEPControl_Reader(), "surfaces.step", True) for g in shape], "OCCT reads STEP surfaces")
    compare(curves, occt_reads(IGESControl_Reader(), "curves.iges", False), "OCCT reads IGES curves")
    compare(surfaces, occt_reads(IGESControl_Reader(), "surfaces.iges", True), "OCCT reads IGES surfaces")
    drawing = ezdxf.readfile(FOLDER / "curves.dxf")
    audit = drawing.audit()
    check(not audit.errors and not audit.fixes, f"ezdxf finds {audit.errors} {audit.fixes}")
    splines = []
    for entity in drawing.modelspace():
        name = entity.get_xdata("SYMSPLINE")[0].value
        weights = list(entity.weights) or None
        told = {"degrees": [entity.dxf.degree], "knots": [list(entity.knots)], "weights": weights}
        splines.append((name, {**told, "points": [tuple(map(float, p)) for p in entity.control_points]}))
    check([name for name, _ in splines] == [name for name, _ in curves], "ezdxf reads other names")
    compare(curves, [[spline] for _, spline in splines], "ezdxf reads DXF curves", all_exact=True)


# --- what others write


def array(kind, values):
    all = kind(1, len(values))
    for i, x in enumerate(values, 1):
        all.SetValue(i, x)
    return all


def grid(kind, values, rows):
    columns = len(values) // rows
    all = kind(1, rows, 1, columns)
    for i, x in enumerate(values):
        all.SetValue(i // columns + 1, i % columns + 1, x)
    return all


def to_occt(spline):
    knots = []
    for full in spline["knots"]:
        distinct = sorted(set(full))
        knots.append((array(Array1_double, distinct), array(Array1_int, [full.count(t) for t in distinct])))
    points = [gp_Pnt(*p) for p in spline["points"]]
    weights = spline["weights"] or [1.0] * len(points)
    if len(knots) == 1:
        (t, m), = knots
        poles = array(Array1_gp_Pnt, points)
        return Geom_BSplineCurve(poles, array(Array1_double, weights), t, m, spline["degrees"][0], False)
    rows = len(spline["knots"][0]) - spline["degrees"][0] - 1
    (t, m), (s, n) = knots
    poles, weights = grid(Array2_gp_Pnt, points, rows), grid(Array2_double, weights, rows)
    return Geom_BSplineSurface(poles, weights, t, s, m, n, *spline["degrees"], False, False)


def is_smooth(curve):
    """Whether OpenCASCADE keeps a curve in one piece."""
    p, t = curve["degrees"][0], curve["knots"][0]
    return p > 1 and not any(t[p] < x < t[-p - 1] and t.count(x) >= p for x in t)


def written_by_others():
    smooth = [(n, s) for n, s in items("curves.json") if is_smooth(s)]
    surfaces = [(n, s) for n, s in items("surfaces.json") if min(s["degrees"]) > 1]
    edges = [BRepBuilderAPI_MakeEdge(to_occt(s)).Edge() for _, s in smooth]
    faces = [BRepBuilderAPI_MakeFace(to_occt(s), 1e-7).Face() for _, s in surfaces]
    for shapes, splines, what in ((edges, smooth, "curves"), (faces, surfaces, "surfaces")):
        step, iges = STEPControl_Writer(), IGESControl_Writer("MM", 0)
        for shape in shapes:
            step.Transfer(shape, STEPControl_AsIs)
            iges.AddShape(shape)
        iges.ComputeModel()
        step.Write(str(FOLDER / f"occt_{what}.step"))
        iges.Write(str(FOLDER / f"occt_{what}.iges"))
        for ending in ("step", "iges"):
            size = len(splines[0][1]["degrees"])
            found = [s for _, s in we_read(f"occt_{what}.{ending}") if len(s["degrees"]) == size]
            near(splines, found, f"we read {what} of OCCT in {ending.upper()}", 1e-12 if ending == "step" else 1e-9)
            reader = STEPControl_Reader() if ending == "step" else IGESControl_Reader()
            theirs = [[g] for shape in occt_reads(reader, f"occt_{what}.{ending}", what == "surfaces") for g in shape]
            if what == "surfaces" or ending == "iges":
                # Of its 10 digits OCCT makes periodic surfaces of IGES, whose periods then do not quite agree with all knots.
                told = [(n, s) for (n, _), s in zip(splines, found)]
                compare(told, theirs, f"OCCT reads its own {what} in {ending.upper()} as we do", tolerance=1e-9)
    drawing = ezdxf.new("R2010")
    model = drawing.modelspace()
    drawing.appids.new("SYMSPLINE")
    for name, s in items("curves.json"):
        spline = model.add_spline(degree=s["degrees"][0])
        spline.control_points, spline.knots, spline.weights = s["points"], s["knots"][0], s["weights"] or []
        spline.set_xdata("SYMSPLINE", [(1000, name)])
    drawing.saveas(FOLDER / "ezdxf.dxf")
    compare(items("curves.json"), [[s] for _, s in we_read("ezdxf.dxf")], "we read DXF of ezdxf", all_exact=True)
    check([n for n, _ in we_read("ezdxf.dxf")] == [n for n, _ in items("curves.json")], "names of ezdxf")


def near(ours, theirs, what, tolerance):
    """OpenCASCADE writes 12 digits of knots in STEP, and 10 of weights in IGES: the numbers agree so far."""
    check(len(ours) == len(theirs), f"{what}: {len(ours)} items, {len(theirs)} are read")
    worst = 0.0
    for (name, left), right in zip(ours, theirs):
        for key in ("points", "knots", "weights"):
            flat = [[x for row in s[key] or [] for x in (row if isinstance(row, (list, tuple)) else [row])] for s in (left, right)]
            check(left["degrees"] == right["degrees"] and len(flat[0]) == len(flat[1]), f"{what}: {name} has other {key}")
            size = max(map(abs, flat[0]), default=1.0)
            worst = max([worst, *(abs(x - y) / size for x, y in zip(*flat))])
    check(worst <= tolerance, f"{what}: {worst}")
    print(f"{what}: {len(ours)}, the numbers differ by {worst:.1e} of the largest at most")


read_by_others()
written_by_others()
done()
