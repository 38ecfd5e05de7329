"""Types of the tools in `_symspline`: functions and classes of fine_tune, shape, deform, mesh, analysis and files."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from os import PathLike
from typing import Any, Literal, TypeAlias, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._symspline import Rational, RationalSurface, Space, Spline, Surface

Number: TypeAlias = int | Fraction | float
Numbers: TypeAlias = NDArray[Any]  # float64, or objects: fractions
Point: TypeAlias = Number | ArrayLike  # a number, or numbers
Index: TypeAlias = int | tuple[int, int]
Shape: TypeAlias = Spline | Surface | Rational | RationalSurface
Curve: TypeAlias = Spline | Rational
AnySurface: TypeAlias = Surface | RationalSurface
Scales: TypeAlias = Space | tuple[Space, Space]
Hold: TypeAlias = Literal["start", "points", "tangents", "curvatures"]
Norm: TypeAlias = Literal["l2", "coefficients"]
Path: TypeAlias = Literal["uv", "vu", "both"]
Edge: TypeAlias = Literal["u_start", "u_end", "v_start", "v_end"]
Fit: TypeAlias = Literal["free", "position", "tangent", "curvature"]
Edges: TypeAlias = Fit | Mapping[Edge, Fit]
Direction: TypeAlias = Literal["u", "v"]
Condition: TypeAlias = str | tuple[Any, ...]
Interval: TypeAlias = tuple[Number, Number]
Finer: TypeAlias = int | Number

# fine_tune

class HeldCurve:
    curve: Spline
    image: Spline
    squared_scale: Number
    similar: Interval | None

class HeldSurface:
    surface: Surface
    forced: Number

class Approximation:
    spline: Spline | Surface
    bound: Number

class Relaxed:
    curve: Spline
    energy_before: float
    energy: float
    length_deviation: float
    angle_deviation: float
    iterations: int
    gradient: float
    converged: bool

class LocallyTuned:
    before: Spline | None
    after: Spline | None
    tuned: HeldCurve
    order: int
    portion: Interval
    def joined(self) -> Spline: ...
    def reduced(self, tolerance: Number) -> Approximation: ...
    def in_original_space(self) -> Approximation: ...

class NearestScale:
    def __init__(
        self, shape: Spline | Surface, scales: Scales, conditions: Sequence[Condition], norm: Norm = "l2", *, path: Path = "both"
    ) -> None: ...
    @overload
    def to(self, wanted: Spline, *, signed: bool = False) -> Spline: ...
    @overload
    def to(self, wanted: Surface, *, signed: bool = False) -> Surface: ...

class FineTuner:
    spaces: list[Space]
    def __init__(
        self,
        shape: Spline | Surface,
        scales: Scales,
        *,
        hold: Hold | None = None,
        conditions: Sequence[Condition] | None = None,
        norm: Norm = "l2",
        path: Path = "both",
        edges: Edges | None = None,
        signed: bool = False,
    ) -> None: ...
    def tuned(self, alpha: Spline | Surface | ArrayLike) -> Spline | Surface: ...
    def tune_into(self, alpha: NDArray[np.float64], out: NDArray[np.float64]) -> None: ...

@overload
def fine_tuned(shape: Spline, alpha: Spline, path: Path = "both", *, signed: bool = False) -> Spline: ...
@overload
def fine_tuned(shape: Surface, alpha: Surface, path: Path = "both", *, signed: bool = False) -> Surface: ...
def fine_tuned_from(surface: Surface, alpha: Surface, edge: Edge, *, signed: bool = False) -> Surface: ...
@overload
def fine_tuned_holding(
    shape: Spline, alpha: Spline, hold: Hold = "points", *, path: Path = "both", edges: Edges | None = None, signed: bool = False
) -> HeldCurve: ...
@overload
def fine_tuned_holding(
    shape: Surface, alpha: Surface, hold: Hold = "points", *, path: Path = "both", edges: Edges | None = None, signed: bool = False
) -> HeldSurface: ...
@overload
def fine_tuned_on(
    shape: Spline, alpha: Spline, hold: Hold = "points", *, path: Path = "both", edges: Edges | None = None, signed: bool = False
) -> LocallyTuned: ...
@overload
def fine_tuned_on(
    shape: Surface, alpha: Surface, hold: Hold = "points", *, path: Path = "both", edges: Edges | None = None, signed: bool = False
) -> tuple[HeldSurface, Surface]: ...
def fine_tuned_on_by_nearest(curve: Spline, wanted: Spline, order: int = 1, norm: Norm = "l2") -> LocallyTuned: ...
def fine_tuned_within(
    curve: Spline, alpha: Spline, tolerance: Number, hold: Hold = "points", *, signed: bool = False
) -> Approximation: ...
def fine_tuned_closed(
    curve: Spline,
    alpha: Spline,
    *,
    signed: bool = False,
    stretch: float = 1.0,
    bend: float = 2.0,
    uniform: bool = ...,
    fixed: Sequence[int] = (),
    iterations: int = 2000,
    tolerance: float = 1e-9,
) -> Relaxed: ...
def scale_for_curvature_ratio(scales: Space, ratio: Spline) -> Approximation: ...
def scale_moments(curve: Spline, scales: Space, x: Number, y: Number) -> Numbers: ...
def dragged(spline: Spline, x: Number, to: Point, norm: Norm = "coefficients") -> Spline: ...
def path_gap(surface: Surface, alpha: Surface) -> Approximation: ...

# shape

class Drag:
    indices: list[int]
    matrix: Numbers
    def __init__(
        self,
        shape: Shape,
        at: Point,
        by: Literal["nearest", "neighbours"] = "nearest",
        *,
        index: Index | None = None,
        shares: Sequence[tuple[Index, Number]] | None = None,
        gamma: Point | None = None,
    ) -> None: ...
    def applied(self, shape: Shape, by: ArrayLike) -> Shape: ...

class Constraints:
    shape: Shape
    rows: Numbers
    matrix: Drag
    def __init__(
        self,
        shape: Shape,
        constraints: Sequence[tuple[Point, Index] | Mapping[int, Number]],
        *,
        holding: Sequence[Index] | None = None,
        freeing: Sequence[Index] | None = None,
        weights: Sequence[tuple[Index, Number]] | None = None,
        nearly: bool = False,
        relief: Literal["knots", "degree"] | None = None,
    ) -> None: ...
    def dragged(self, shape: Shape, changes: ArrayLike) -> Shape: ...
    def met(self, shape: Shape, targets: ArrayLike) -> Shape: ...

class CurvatureHandle:
    def __init__(
        self, curve: Curve, x: Number, *, holding: Sequence[int] | None = None, weights: Sequence[tuple[int, Number]] | None = None
    ) -> None: ...
    def pushed(self, curve: Curve, by: Point) -> Curve: ...
    def slid(self, curve: Curve, amount: Number) -> Curve: ...
    def scaled(self, curve: Curve, factor: Number) -> Curve: ...
    def set(self, curve: Curve, kappa: float) -> Curve: ...

class WeightPull:
    weight: Number
    share: Number
    point: Any
    control_point: Any
    limits: tuple[Number | None, Number | None]
    def __init__(self, shape: Rational | RationalSurface, at: Point, index: Index, *, within: Interval | None = None) -> None: ...
    def weight_for(self, fraction: Number) -> Number: ...
    def fraction_for(self, weight: Number) -> Number: ...
    def fraction_near(self, target: Point) -> Number: ...
    def applied(self, shape: Shape, fraction: Number) -> Shape: ...

class WeightPairPull:
    weights: Interval
    shares: Interval
    base: Any
    def __init__(
        self, shape: Rational | RationalSurface, at: Point, first: Index, second: Index, *, within: Interval | None = None
    ) -> None: ...
    def coordinates(self, target: Point, tolerance: Number = 0) -> Interval: ...
    def weights_for(self, target: Point, tolerance: Number = 0) -> Interval: ...
    def moved_to(self, shape: Shape, target: Point, tolerance: Number = 0) -> Shape: ...
    def moved_along(self, shape: Shape, fraction: Number) -> Shape: ...

class Reshaped:
    shape: Shape
    inserted: list[tuple[Direction, Number]]
    moved: int
    removed: list[tuple[Direction, Number]]
    bound: Number

class Flattened:
    shape: Shape
    projected: list[int]
    flat: list[list[Interval]]
    changed: list[Interval] | None

def confined(shape: Shape, x: Number, start: Number, end: Number, direction: Direction = "u") -> tuple[Shape, int]: ...
def leg_point(
    shape: Shape, index: Index, target: Point, tolerance: Number, direction: Direction = "u"
) -> tuple[Number, Shape, int]: ...
def node_placing_knot(space: Space, x: Number) -> Number | None: ...
def nodes_around(space: Space, x: Number) -> tuple[int, int]: ...
def halfway_knot(space: Space, x: Number) -> tuple[Number | None, str, int]: ...
def local_ranges(space: Space, start: Number, end: Number) -> list[tuple[int, int]]: ...
def with_tangent(curve: Curve, x: Number, direction: Point) -> Curve: ...
def weight_derivatives(shape: Rational | RationalSurface, at: Point, index: Index, order: int) -> list[Any]: ...
def with_weights(shape: Rational | RationalSurface, weights: Sequence[tuple[Index, Number]]) -> Shape: ...
def control_points(shape: Shape) -> Numbers: ...
def derivative_at(shape: Shape, at: Point, order: Index) -> Any: ...
def warped(
    shape: Shape,
    start: Point,
    end: Point,
    displacement: Callable[[Any, Any], Any],
    *,
    vector: Point | None = None,
    refine: Finer | tuple[Finer | None, Finer | None] | None = None,
    thinned: Number | None = None,
    shares: Literal["nodes", "chords"] | ArrayLike | None = None,
) -> Reshaped: ...
def carried(points: ArrayLike, before: Point, pivot: Point, after: Point, place: Point) -> Numbers: ...
def bump(weight: Number, t: Point) -> Number: ...
def flattened(
    shape: Shape,
    origin: Point,
    *,
    line: Point | None = None,
    normal: Point | None = None,
    along: Point | None = None,
    local: Any = None,
    whole: Any = None,
    side: Literal["positive", "negative"] | None = None,
    in_front_of: Sequence[tuple[Point, Point]] = (),
    segments: Sequence[tuple[Point, Point]] = (),
    polygons: Sequence[ArrayLike] = (),
    balls: Sequence[tuple[Point, Number]] = (),
    refine: Finer | None = None,
    until_flat: int | None = None,
) -> Flattened: ...
def bent(
    shape: Shape,
    centre: Point,
    ratio: Number | Spline | Surface,
    *,
    radius: Number | None = None,
    about: Point | None = None,
    normal: Point | None = None,
    axis: Point | None = None,
    direction: Direction = "u",
    interval: Interval | None = None,
    refine: Finer | None = None,
    tails: bool = True,
) -> Shape: ...
def bent_point(o: Point, p: Point, s: Number, ratio: Number) -> Any: ...

# deform

Breadth: TypeAlias = str | tuple[Any, ...] | Sequence[int]
Forces: TypeAlias = Sequence[tuple[Point, Point]]

class Material:
    weights: Numbers
    def __init__(self, stretching: Number, bending: Number, hardness: Number = 0) -> None: ...
    @staticmethod
    def of_orders(weights: ArrayLike) -> Material: ...
    def energy(self, shape: Spline | Surface) -> Number: ...
    def matrix(self, space: Space) -> Numbers: ...

class Elastic:
    moving: list[list[int]]
    def __init__(
        self,
        shape: Shape,
        material: Material | Sequence[Material],
        breadth: Breadth | Sequence[Breadth],
        *,
        spread: Literal["hat", "point"] = "hat",
    ) -> None: ...
    def responses(self, at: Point) -> list[Numbers]: ...
    def pull(self, shape: Shape, at: Point) -> Pull: ...
    def pushed(self, shape: Shape, forces: Forces = (), *, at_breaks: ArrayLike | None = None, density: Shape | None = None) -> Shape: ...
    def displacements(
        self, shape: Shape, forces: Forces = (), *, at_breaks: ArrayLike | None = None, density: Shape | None = None
    ) -> tuple[list[int], Numbers]: ...
    def anchored(
        self,
        shape: Shape,
        constraints: Sequence[tuple[Point, Index] | Mapping[int, Number]],
        *,
        holding: Sequence[Index] | None = None,
    ) -> Anchored: ...

class Pull:
    give: Number
    response: tuple[list[int], Numbers]
    def force_for(self, change: Point) -> Any: ...
    def pushed(self, shape: Shape, force: Point) -> Shape: ...
    def moved_to(self, shape: Shape, target: Point) -> tuple[Shape, Any]: ...

class Anchored:
    def dragged(self, shape: Shape, changes: ArrayLike) -> tuple[Shape, Numbers]: ...
    def met(self, shape: Shape, targets: ArrayLike) -> tuple[Shape, Numbers]: ...
    def pushed(
        self, shape: Shape, forces: Forces = (), *, at_breaks: ArrayLike | None = None, density: Shape | None = None
    ) -> tuple[Shape, Numbers]: ...
    def relaxed(self, shape: Shape) -> tuple[Shape, Numbers]: ...

class Sculptor:
    shape: Shape
    edits: tuple[int, int]
    def __init__(
        self,
        shape: Shape,
        material: Material | Sequence[Material],
        *,
        reach: Breadth | Sequence[Breadth] | None = None,
        spread: Literal["hat", "point"] = "hat",
        limit: int | None = None,
    ) -> None: ...
    def grab(self, at: Point, reach: Breadth | Sequence[Breadth] | None = None) -> None: ...
    def drag_to(self, target: Point) -> Any: ...
    def push(self, force: Point) -> None: ...
    def push_all(self, body: Elastic, forces: Forces = (), *, at_breaks: ArrayLike | None = None, density: Shape | None = None) -> None: ...
    def commit(self) -> bool: ...
    def cancel(self) -> bool: ...
    def undo(self) -> bool: ...
    def redo(self) -> bool: ...
    def resolution(self, at: Point) -> list[int]: ...
    def refine(self, at: Point, distances: ArrayLike, counts: int | Sequence[int]) -> int: ...
    def move_points(self, indices: Sequence[int], by: ArrayLike) -> None: ...
    def set(
        self, *, material: Material | Sequence[Material] | None = None, reach: Breadth | Sequence[Breadth] | None = None
    ) -> None: ...

# mesh

Boundary: TypeAlias = Literal["open", "smooth", "corners"]

class Mesh:
    points: Numbers
    faces: list[list[int]]
    edges: list[tuple[int, int]]
    vertex_count: int
    edge_count: int
    face_count: int
    euler_characteristic: int
    is_closed: bool
    valences: list[int]
    is_exact: bool
    def __init__(self, points: ArrayLike, faces: Sequence[Sequence[int]]) -> None: ...
    def edge_between(self, v: int, w: int) -> int | None: ...
    def to_exact(self) -> Mesh: ...
    def to_float(self) -> Mesh: ...

class CatmullClark:
    mesh: Mesh
    intervals: Numbers | None
    def __init__(self, mesh: Mesh, intervals: ArrayLike | None = None, *, boundary: Boundary = "smooth") -> None: ...
    def refined(self, depth: int = 1) -> CatmullClark: ...
    def limit_points(self) -> list[Numbers | None]: ...
    def limit_normals(self) -> list[Numbers | None]: ...
    def limit_mesh(self) -> Mesh: ...

class RelaxedMesh:
    surface: CatmullClark
    invariant: CatmullClark
    energy_before: float
    energy: float
    terms: tuple[float, float, float]
    iterations: int
    gradient: float
    converged: bool
    length_deviation: float
    angle_deviation: float

class DooSabin:
    mesh: Mesh
    intervals: Numbers | None
    def __init__(self, mesh: Mesh, intervals: ArrayLike | None = None, *, boundary: Boundary = "smooth") -> None: ...
    def refined(self, depth: int = 1) -> DooSabin: ...
    def limit_points(self) -> Numbers: ...
    def limit_normals(self) -> list[Numbers | None]: ...
    def limit_mesh(self) -> Mesh: ...
    def converted(self) -> CatmullClark: ...
    def fine_tuned(
        self,
        alpha: ArrayLike,
        *,
        stretch: float = 1.0,
        bend: float = 1.0,
        shape: float = 1.0,
        uniform: bool = ...,
        fixed: Sequence[int] = (),
        fixed_corners: Sequence[int] = (),
        moving: Sequence[int] | None = None,
        descend: Literal["conjugate_gradients", "gauss_newton"] = ...,
        iterations: int = 2000,
        tolerance: float = 1e-7,
    ) -> RelaxedMesh: ...

class ControlPolygon:
    degree: int
    points: Numbers
    intervals: Numbers
    is_closed: bool
    def __init__(
        self,
        points: ArrayLike,
        degree: int = 2,
        *,
        intervals: ArrayLike | None = None,
        boundary: Boundary | None = None,
    ) -> None: ...
    def refined(self, depth: int = 1) -> ControlPolygon: ...
    def joints(self) -> Numbers: ...
    def converted(self) -> ControlPolygon: ...
    def curve(self) -> Spline: ...

def loop_lengths(mesh: Mesh) -> list[int]: ...
def mesh_from_obj(text: str) -> Mesh: ...
def mesh_to_obj(mesh: Mesh) -> str: ...

# analysis

Bounds: TypeAlias = tuple[float, float]

class Zero:
    low: Number
    high: Number
    along: bool
    multiplicity: int
    before: int | None
    after: int | None

class Event:
    kind: str
    low: Number
    high: Number
    along: bool
    curvature_before: Bounds
    curvature_after: Bounds
    turn: float

class CurvatureProfile:
    events: list[Event]
    samples: tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]
    runs: list[tuple[Number, Number, int]]
    def __init__(self, curve: Curve, tolerance: float | None = None) -> None: ...
    def count(self, kind: str) -> int: ...
    def trend_on(self, a: Number, b: Number) -> int | None: ...
    def comb_scale(self, length: float) -> float: ...
    def log_log(self) -> NDArray[np.float64]: ...

class ArcLength:
    total: float
    bound: float
    def __init__(self, curve: Curve, accuracy: float = 1e-12) -> None: ...
    def at(self, parameters: ArrayLike) -> NDArray[np.float64]: ...
    def parameter_at(self, lengths: ArrayLike) -> NDArray[np.float64]: ...
    def evenly(self, count: int) -> NDArray[np.float64]: ...

class Foot:
    parameter: Any
    point: NDArray[np.float64]
    distance: float

class Nearest:
    feet: list[Foot]
    along: list[tuple[Any, Any]]
    bound: float

class Projector:
    def __init__(self, shape: Shape) -> None: ...
    def feet(self, points: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]: ...
    def nearest(self, point: Point, accuracy: float = 1e-9) -> Nearest: ...
    def parameters_of(self, point: Point, tolerance: float = 1e-9) -> list[Any]: ...

class Meeting:
    parameters: tuple[float, float]
    ranges: tuple[Bounds, Bounds]
    point: NDArray[np.float64]
    is_proved: bool
    passage: Literal["crosses", "touches", "ends", "unknown"] | None
    along: float | None

class Meetings:
    meetings: list[Meeting]
    overlaps: list[tuple[Bounds, tuple[Any, Any]]]

class SurfaceCurvatures:
    mean: float
    greatest: float
    least: float
    directions: tuple[NDArray[np.float64], NDArray[np.float64]] | None

def curvature(curve: Curve, parameters: ArrayLike) -> NDArray[np.float64]: ...
def curvature_comb(curve: Curve, parameters: ArrayLike, scale: float) -> NDArray[np.float64]: ...
def curvature_squared(curve: Curve) -> Rational: ...
def torsion(curve: Curve) -> Rational: ...
def torsion_at(curve: Curve, x: Number) -> Number: ...
def bend_condition(curve: Curve, *, slope: bool = False) -> Spline: ...
def total_curvature(curve: Curve, accuracy: float = 1e-9) -> Bounds: ...
def turning_angle(curve: Curve) -> Bounds: ...
def zeros(function: Curve) -> list[Zero]: ...
def crossings(curve: Curve, normal: Point, offset: Number) -> list[Zero]: ...
def feet(curve: Curve, point: Point) -> list[Zero]: ...
def frames(curve: Curve, parameters: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...
def rotation_minimising_frames(
    curve: Curve, parameters: ArrayLike, start: Point | None = None
) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...
def intersections(first: Curve, second: Curve, tolerance: float = 1e-9) -> Meetings: ...
@overload
def meet_line(shape: Curve, origin: Point, direction: Point, tolerance: float = 1e-9) -> list[Zero]: ...
@overload
def meet_line(shape: AnySurface, origin: Point, direction: Point, tolerance: float = 1e-9) -> Meetings: ...
def gaussian_curvature(surface: AnySurface, u: Number, v: Number) -> Number: ...
def surface_curvatures(surface: AnySurface, u: float, v: float) -> SurfaceCurvatures: ...

# files

Value: TypeAlias = Shape | Mesh | Number | ArrayLike
Values: TypeAlias = Value | Mapping[str, Value] | Sequence[Value] | Sequence[tuple[str | None, Value]]

def read(path: str | PathLike[str]) -> list[tuple[str | None, Any]]: ...
def write(path: str | PathLike[str], values: Values) -> None: ...
def loads(content: str | bytes, format: str = "json") -> list[tuple[str | None, Any]]: ...
def dumps(values: Values, format: str = "json") -> bytes: ...
def formats() -> list[tuple[str, bool, bool]]: ...
