"""Open CASCADE through its Python bindings (cadquery-ocp): points cost a call each, operations are C++ throughout."""

from collections.abc import Iterable

from OCP.BSplCLib import BSplCLib
from OCP.Geom import Geom_BezierCurve, Geom_BSplineCurve, Geom_BSplineSurface
from OCP.GeomAdaptor import GeomAdaptor_Curve
from OCP.GeomConvert import GeomConvert_BSplineCurveToBezierCurve
from OCP.gp import gp_Pnt, gp_Vec

import inputs
from questions import Answer, Interpolant, Pieces, Points, Spline, Way, refined_curve

try:
    from OCP.collections import Array1_double as Reals
    from OCP.collections import Array1_gp_Pnt as PointArray
    from OCP.collections import Array1_int as Integers
    from OCP.collections import Array2_gp_Pnt as PointGrid
except ImportError:
    from OCP.TColgp import TColgp_Array1OfPnt as PointArray
    from OCP.TColgp import TColgp_Array2OfPnt as PointGrid
    from OCP.TColStd import TColStd_Array1OfInteger as Integers
    from OCP.TColStd import TColStd_Array1OfReal as Reals

NAME = "OCCT (Python)"
SINGLES = 2000
TOLERANCE = 1e-9


def _filled(array: object, values: Iterable[object]) -> object:
    for i, value in enumerate(values, 1):
        array.SetValue(i, value)
    return array


def _reals(numbers: list[float]) -> Reals:
    return _filled(Reals(1, len(numbers)), numbers)


def _integers(numbers: list[int]) -> Integers:
    return _filled(Integers(1, len(numbers)), numbers)


def _points(rows: list[list[float]]) -> PointArray:
    return _filled(PointArray(1, len(rows)), (gp_Pnt(*row) for row in rows))


def _multiplicities(spans: int) -> Integers:
    p = inputs.DEGREE
    return _integers([p + 1, *[1] * (spans - 1), p + 1])


def _curve() -> Geom_BSplineCurve:
    poles, knots = _points(inputs.points(inputs.CONTROLS)), _reals(inputs.breaks(inputs.SPANS))
    return Geom_BSplineCurve(poles, knots, _multiplicities(inputs.SPANS), inputs.DEGREE)


def _fine() -> Geom_BSplineCurve:
    spline = refined_curve()
    knots = sorted(set(spline.knots))
    return Geom_BSplineCurve(_points(spline.coeffs), _reals(knots), _multiplicities(len(knots) - 1), spline.degree)


def _surface() -> Geom_BSplineSurface:
    n, p, spans = inputs.SURFACE_CONTROLS, inputs.DEGREE, inputs.SURFACE_SPANS
    poles = PointGrid(1, n, 1, n)
    for k, row in enumerate(inputs.points(n * n)):
        poles.SetValue(k // n + 1, k % n + 1, gp_Pnt(*row))
    knots, multiplicities = _reals(inputs.breaks(spans)), _multiplicities(spans)
    return Geom_BSplineSurface(poles, knots, knots, multiplicities, multiplicities, p, p)


def _xyz(p: gp_Pnt | gp_Vec) -> list[float]:
    return [p.X(), p.Y(), p.Z()]


def _rows(poles: PointArray) -> list[list[float]]:
    return [_xyz(poles.Value(i)) for i in range(poles.Lower(), poles.Upper() + 1)]


def _spline(curve: Geom_BSplineCurve) -> Spline:
    poles = [_xyz(curve.Pole(i)) for i in range(1, curve.NbPoles() + 1)]
    knots = [curve.Knot(i) for i in range(1, curve.NbKnots() + 1) for _ in range(curve.Multiplicity(i))]
    return Spline(curve.Degree(), knots, poles)


def _curve_points(curve: Geom_BSplineCurve) -> list[Way]:
    adaptor = GeomAdaptor_Curve(curve)
    ways = []
    for order, xs in [("sorted", inputs.sorted_parameters()), ("random", inputs.random_parameters())]:
        few = inputs.part(xs, SINGLES)

        def single(xs: list[float] = few) -> list[gp_Pnt]:
            return [adaptor.Value(x) for x in xs]

        def at_few(values: list[gp_Pnt], xs: list[float] = few) -> Answer:
            return Points(xs, [[_xyz(p) for p in values]])

        how = "GeomAdaptor_Curve.Value"
        ways.append(Way(f"curve point, single, {order}", how, single, at_few, len(few)))
    return ways


def _derivatives(curve: Geom_BSplineCurve, surface: Geom_BSplineSurface) -> list[Way]:
    xs, pairs = inputs.part(inputs.random_parameters(), SINGLES), inputs.part(inputs.random_pairs(), SINGLES)

    def jets(at: object, parameters: list) -> list[list[gp_Pnt | gp_Vec]]:
        result = []
        for x in parameters:
            jet = [gp_Pnt(), gp_Vec(), gp_Vec()]
            at(x, jet)
            result.append(jet)
        return result

    def answer(parameters: list, rows: list[list[gp_Pnt | gp_Vec]]) -> Answer:
        return Points(parameters, [[_xyz(row[k]) for row in rows] for k in range(3)])

    return [
        Way(
            "curve point and 2 derivatives, single, random",
            "Geom_BSplineCurve.D2",
            lambda: jets(lambda x, jet: curve.D2(x, *jet), xs),
            lambda rows: answer(xs, rows),
            len(xs),
        ),
        Way(
            "surface point, single, random",
            "Geom_BSplineSurface.Value",
            lambda: [surface.Value(u, v) for u, v in pairs],
            lambda values: Points(pairs, [[_xyz(p) for p in values]]),
            len(pairs),
        ),
        Way(
            "surface point and first derivatives, random",
            "Geom_BSplineSurface.D1",
            lambda: jets(lambda x, jet: surface.D1(*x, *jet), pairs),
            lambda rows: answer(pairs, rows),
            len(pairs),
        ),
    ]


def _refined(curve: Geom_BSplineCurve, knots: Reals, once: Integers) -> Geom_BSplineCurve:
    result = Geom_BSplineCurve(curve)
    result.InsertKnots(knots, once)
    return result


def _elevated(curve: Geom_BSplineCurve) -> Geom_BSplineCurve:
    result = Geom_BSplineCurve(curve)
    result.IncreaseDegree(inputs.DEGREE + 1)
    return result


def _thinned(fine: Geom_BSplineCurve) -> Geom_BSplineCurve:
    """The inserted knots have even indices."""
    result = Geom_BSplineCurve(fine)
    for index in range(2 * inputs.SPANS, 0, -2):
        result.RemoveKnot(index, 0, TOLERANCE)
    return result


def _beziers(curve: Geom_BSplineCurve) -> list[Geom_BezierCurve]:
    pieces = GeomConvert_BSplineCurveToBezierCurve(curve)
    return [pieces.Arc(i) for i in range(1, pieces.NbArcs() + 1)]


def _interpolation() -> Way:
    parameters, knots = inputs.interpolation_parameters(), inputs.interpolation_knots()
    given, flat, contacts = _reals(parameters), _reals(knots), _integers([0] * inputs.CONTROLS)
    data = _points(inputs.points(inputs.CONTROLS))

    def interpolated() -> PointArray:
        poles = PointArray(data)
        BSplCLib.Interpolate_s(inputs.DEGREE, flat, given, contacts, poles)
        return poles

    def answer(poles: PointArray) -> Answer:
        return Interpolant(Spline(inputs.DEGREE, knots, _rows(poles)), parameters)

    how = "BSplCLib.Interpolate with given parameters and knots"
    return Way("interpolate 1000 points", how, interpolated, answer)


def _operations(curve: Geom_BSplineCurve) -> list[Way]:
    knots, once, fine = _reals(inputs.middles()), _integers([1] * inputs.SPANS), _fine()
    return [
        Way(
            "refine every span",
            "Geom_BSplineCurve.InsertKnots on a copy",
            lambda: _refined(curve, knots, once),
            _spline,
        ),
        Way("elevate by one", "Geom_BSplineCurve.IncreaseDegree on a copy", lambda: _elevated(curve), _spline),
        Way("remove inserted knots", "Geom_BSplineCurve.RemoveKnot on a copy", lambda: _thinned(fine), _spline),
        _interpolation(),
        Way(
            "Bezier pieces",
            "GeomConvert_BSplineCurveToBezierCurve",
            lambda: _beziers(curve),
            lambda arcs: Pieces([[_xyz(arc.Pole(i)) for i in range(1, arc.NbPoles() + 1)] for arc in arcs]),
        ),
    ]


def ways() -> list[Way]:
    curve, surface = _curve(), _surface()
    return _curve_points(curve) + _derivatives(curve, surface) + _operations(curve)
