"""Shapes, meshes and results of tools come back from a pickle as they were."""

import pickle
from fractions import Fraction

import numpy as np
import pytest
from symspline import Mesh, Rational, RationalSurface, Space, Spline, Surface
from symspline.analysis import CurvatureProfile, Projector, intersections, meet_line, surface_curvatures, zeros
from symspline.deform import FullEnergy, Load, Material
from symspline.fine_tune import FineTuner, fine_tuned_closed, fine_tuned_holding, scale_for_curvature_ratio
from symspline.mesh import CatmullClark, ControlPolygon, DooSabin
from symspline.shape import Gravity, flattened, warped

HALF = Fraction(1, 2)
LINE = Space.bezier(1)
CURVE = Spline(Space.bezier(2), [[0, 0], [1, 2], [2, 0]])
ARCH = Spline(Space.bezier(2), [[0, 0], [1, Fraction(1, 2)], [2, 0]])
ALPHA = Spline(LINE, [1, 2])
SADDLE = Surface(LINE, LINE, [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]])
CUBE = Mesh(
    [[k & 1, k >> 1 & 1, k >> 2] for k in range(8)],
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]],
)
TRIANGLE = Spline(Space(2, [0.0, 1.0, 2.0], 3.0), [[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]])
RESULTS = [
    CURVE,
    SADDLE,
    Rational.circle([0, 0], 1),
    RationalSurface(LINE, LINE, [[1, 2], [3, 4]], [[1, 1], [1, 2]]),
    CUBE,
    CUBE.to_float(),
    Material(1, Fraction(1, 3)),
    FullEnergy.thin_plate(1, Fraction(1, 3)),
    Load([((HALF, 0), [0, 0, 1])], over=[(((0, 0), (1, 1)), [0, 0, 1], 3)]),
    CatmullClark(CUBE, boundary="corners"),
    CatmullClark(CUBE, [1 + k % 2 for k in range(12)]),
    DooSabin(CUBE, [[1, 2]] * 12, "open"),
    fine_tuned_holding(CURVE, ALPHA),
    fine_tuned_holding(SADDLE, Surface(LINE, LINE, [[1.0, 2.0], [2.0, 3.0]])),
    fine_tuned_closed(TRIANGLE, Spline(Space(1, [0.0, 1.0, 2.0], 3.0), [1.0, 2.0, 1.0])),
    scale_for_curvature_ratio(LINE, ALPHA),
    DooSabin(CUBE).fine_tuned(np.ones(12)),
    warped(CURVE, 0, 1, lambda share, parameter: (0, 1)),
    flattened(CURVE, [0, 0], line=[1, 0]),
    Gravity([[[0, 0], [4, 0]]], 2).pull((1, HALF)),
    Spline.monomial(2).range(Fraction(1, 100))[0],
    SADDLE.coordinate(2).range(Fraction(1, 100))[1],
    zeros(Spline.monomial(1) - Fraction(1, 3))[0],
    CurvatureProfile(CURVE).events[0],
    Projector(CURVE).nearest([1.0, 3.0]),
    intersections(CURVE, ARCH),
    meet_line(SADDLE, [0.5, 0.5, -1.0], [0.0, 0.0, 1.0]),
    surface_curvatures(SADDLE, 0.25, 0.5),
]


@pytest.mark.parametrize("value", RESULTS, ids=lambda value: type(value).__name__)
def test_they_come_back(value):
    again = pickle.loads(pickle.dumps(value))
    assert type(again) is type(value) and again == value and repr(again) == repr(value)


def test_control_polygons_come_back():
    for polygon in (
        ControlPolygon([[0, 0], [4, 0], [4, 4]]),
        ControlPolygon([[0, 0], [4, 0], [4, 4], [0, 5]], 3, [1, 1, 2, 1, 1], "open"),
        ControlPolygon([[0.0, 0], [4, 0], [4, 4], [0, 5]], boundary="smooth").refined(),
    ):
        again = pickle.loads(pickle.dumps(polygon))
        assert again.points.tolist() == polygon.points.tolist() and again.curve() == polygon.curve()
        assert again.refined().points.tolist() == polygon.refined().points.tolist()


def test_results_differ_where_their_fields_do():
    held = fine_tuned_holding(CURVE, ALPHA)
    other = type(held)(held.curve, held.image, held.squared_scale + 1, held.similar)
    assert other != held and other.squared_scale == held.squared_scale + 1
    with pytest.raises(AttributeError):
        held.squared_scale = 1


def test_prepared_tools_are_made_where_they_are_needed():
    with pytest.raises(TypeError, match="pickle"):
        pickle.dumps(FineTuner(CURVE, LINE))
