"""Whatever goes in, an exception of Python comes out, or a result: nothing panics, hangs or fills the memory."""

import inspect
import os
import random
from fractions import Fraction

import numpy as np
import pytest
from symspline import Mesh, Rational, RationalSurface, Space, Spline, Surface, _symspline
from symspline.analysis import ArcLength, CurvatureProfile, Projector
from symspline.deform import Elastic, FullEnergy, Load, Material, Relaxation, Sculptor
from symspline.fine_tune import FineTuner, NearestScale, fine_tuned_on
from symspline.mesh import CatmullClark, ControlPolygon, DooSabin
from symspline.shape import (
    Constraints,
    Coupled,
    CurvatureHandle,
    CurveGravity,
    Drag,
    Gravity,
    OffsetAxis,
    Polygons,
    WeightPairPull,
    WeightPull,
)

LINE = Space.bezier(1)
RING = Space(2, [0.0, 1.0, 2.0], 3.0)
CUBIC = Space.uniform(3, 4)
CURVE = Spline(CUBIC, [[k, k * k % 5] for k in range(CUBIC.dim)])
SPATIAL = Spline(CUBIC, np.random.default_rng(1).normal(size=(CUBIC.dim, 3)))
FUNCTION = Spline(LINE, [1, 2])
NURBS = Rational(CUBIC, CURVE.coeffs, [1 + k % 3 for k in range(CUBIC.dim)])
SADDLE = Surface(LINE, LINE, [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]])
WEIGHTED = RationalSurface(LINE, LINE, SADDLE.coeffs, [[1, 1], [1, 2]])
CUBE = Mesh(
    [[k & 1, k >> 1 & 1, k >> 2] for k in range(8)],
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]],
)
MATERIAL = Material(1, 1)
ELASTIC = Elastic(CURVE, MATERIAL, "all")
SHEET = Elastic(SADDLE, Material(1, 1, 1), ["whole", "whole"])
HALF = Fraction(1, 2)
OBJECTS = [
    LINE,
    RING,
    CURVE,
    CURVE.to_float(),
    SPATIAL,
    FUNCTION,
    Spline.closed(2, [[0, 0], [4, 0], [0, 3]]),
    NURBS,
    SADDLE,
    WEIGHTED,
    CUBE,
    CatmullClark(CUBE),
    DooSabin(CUBE),
    ControlPolygon([[0, 0], [4, 0], [4, 4]]),
    MATERIAL,
    ELASTIC,
    ELASTIC.pull(CURVE, HALF),
    ELASTIC.anchored(CURVE, [(HALF, 0)]),
    Sculptor(CURVE, MATERIAL, reach="all"),
    SHEET,
    Load([(HALF, [0, 1])]),
    Load(along=[(CURVE, [0, 0, 1], 5)], over=[(((0, 0), (1, 1)), [0, 0, 1], 4)]),
    FullEnergy.thin_plate(1, 1),
    Relaxation(CUBIC, MATERIAL, "all", HALF),
    Drag(CURVE, HALF),
    Constraints(CURVE, [(HALF, 0)]),
    Coupled(CURVE, [(HALF, 0)], ["area", ("along", HALF, 1, [0, 1])]),
    CurvatureHandle(CURVE, HALF),
    WeightPull(NURBS, HALF, 2),
    WeightPairPull(NURBS, HALF, 2, 3),
    Gravity([[[0, 0], [1, 1]]], 1),
    CurveGravity([CURVE], 1.0),
    Polygons([[[0, 0], [1, 0], [0, 1]]]),
    OffsetAxis(SADDLE, HALF, 1.0),
    FineTuner(CURVE, LINE),
    NearestScale(CURVE, LINE, ["end"]),
    fine_tuned_on(CURVE, Spline(Space.bezier(1, Fraction(1, 4), HALF), [1, 2])),
    ArcLength(CURVE),
    CurvatureProfile(CURVE),
    Projector(CURVE),
]
WORDS = ["abc", "", "u", "l2", "points", "uv", "nearest", "end", "json", "whole", b"12"]
NUMBERS = [0, 1, 2, -1, 0.5, HALF, 1e-3, float("nan"), float("inf"), 1e308, -(10**40), 2**62, 2**63, 2**64, 10**400, True]
POINTS = [[0, 1], (HALF, 0.5), [1, 2, 3], [], [[]], [[1, 2], [3]], [[0, 0], [1, 1], [2, 0]], np.zeros((2, 2)), np.zeros((0, 3))]
OTHERS = [None, {}, {1: 2}, {0: 1.0}, [(HALF, 0)], ["end"], ["area"], [("along", HALF, 0, (1, 2))], [("isocurve", "u", HALF)], [("point", HALF, (1, 2))], [[(0, 1)]], object(), len, ...]
JUNK = OBJECTS + WORDS + NUMBERS + POINTS + OTHERS
CALLABLES = [value for value in vars(_symspline).values() if inspect.isbuiltin(value)]
CALLABLES += [value for value in vars(_symspline).values() if inspect.isclass(value) and not issubclass(value, Exception)]


SIGNS = ["__call__", "__add__", "__mul__", "__matmul__", "__truediv__", "__pow__"]


def attempts(call, count):
    """Calls with junk, and how many had a result."""
    chance = random.Random(call.__qualname__)
    try:
        wanted = len(inspect.signature(call).parameters)
    except ValueError:
        wanted = 2
    passed = 0
    for _ in range(count):
        number = chance.choice([wanted, wanted, max(wanted - 1, 0), chance.randint(0, 3)])
        try:
            call(*(chance.choice(JUNK) for _ in range(number)))
            passed += 1
        except Exception:  # noqa: BLE001, a panic of Rust is no Exception
            pass
    return passed


def methods():
    names = [(of, name) for of in OBJECTS for name in dir(of) if callable(getattr(type(of), name))]
    return [getattr(of, name) for of, name in names if name in SIGNS or not name.startswith("_")]


@pytest.mark.parametrize("call", CALLABLES + methods(), ids=lambda call: call.__qualname__)
def test_junk_makes_exceptions(call, tmp_path, monkeypatch):
    # Names of files are among the words.
    monkeypatch.chdir(tmp_path)
    attempts(call, int(os.environ.get("JUNK", "12")))


def test_some_of_it_has_results():
    assert sum(attempts(method, 20) for method in methods()) > 1000
