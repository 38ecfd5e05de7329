//! The hand-written bounds as candidates.

use crate::bounds::plain::{self, Plain};
use crate::bounds::surface::Patches;
use crate::bounds::table::Table;
use crate::bounds::{direct, elevate, flat, interpolate, lifted, point, project, reduce, refine, remove};
use crate::candidates::{CurvePoints, Operator, Operator2, Operators, Parts, SurfacePoints};
use crate::data::{CurveData, Point, SurfaceData};
use crate::measure::Column;

/// The table of a polynomial curve.
pub struct Polynomial(Table);

/// The table of a rational curve.
pub struct Fraction(Table);

impl CurvePoints for Polynomial {
    const COLUMN: Column = Column::Bound;
    type Point = Point;

    fn of(data: &CurveData) -> Self {
        Self(Table::new(&data.knots, &flat(&data.points)))
    }

    fn at(&self, x: f64) -> Point {
        point(self.0.at(x))
    }

    fn coordinates(point: Point) -> Point {
        point
    }

    fn derivatives(&self, x: f64) -> [Point; 3] {
        self.0.derivatives(x).map(point)
    }

    fn fill(&self, xs: &[f64], out: &mut Vec<Point>) {
        out.resize(xs.len(), [0.0; 3]);
        self.0.fill(xs, out, point);
    }
}

impl CurvePoints for Fraction {
    const COLUMN: Column = Column::Bound;
    const DERIVATIVES: bool = false;
    type Point = Point;

    fn of(data: &CurveData) -> Self {
        Self(Table::new(&data.knots, &lifted(&data.points, &data.weights)))
    }

    fn at(&self, x: f64) -> Point {
        project(self.0.at(x))
    }

    fn coordinates(point: Point) -> Point {
        point
    }

    fn derivatives(&self, _: f64) -> [Point; 3] {
        unreachable!("not offered")
    }

    fn fill(&self, xs: &[f64], out: &mut Vec<Point>) {
        out.resize(xs.len(), [0.0; 3]);
        self.0.fill(xs, out, project);
    }
}

/// A curve without a table.
pub struct Direct {
    knots: Vec<f64>,
    points: Vec<Point>,
}

impl CurvePoints for Direct {
    const COLUMN: Column = Column::Direct;
    const DERIVATIVES: bool = false;
    type Point = Point;

    fn of(data: &CurveData) -> Self {
        Self { knots: data.knots.clone(), points: data.points.clone() }
    }

    fn at(&self, x: f64) -> Point {
        direct::curve(&self.knots, &self.points, x)
    }

    fn coordinates(point: Point) -> Point {
        point
    }

    fn derivatives(&self, _: f64) -> [Point; 3] {
        unreachable!("not offered")
    }
}

/// A surface without a table.
pub struct DirectSurface {
    side: usize,
    knots: Vec<f64>,
    points: Vec<Point>,
}

impl SurfacePoints for DirectSurface {
    const COLUMN: Column = Column::Direct;
    const TANGENTS: bool = false;
    type Point = Point;

    fn of(data: &SurfaceData) -> Self {
        Self { side: data.side(), knots: data.knots.clone(), points: data.points.clone() }
    }

    fn at(&self, u: f64, v: f64) -> Point {
        direct::surface(&self.knots, self.side, &self.points, u, v)
    }

    fn coordinates(point: Point) -> Point {
        point
    }

    fn tangents(&self, _: f64, _: f64) -> [Point; 3] {
        unreachable!("not offered")
    }

    fn normal(&self, _: f64, _: f64) -> Point {
        unreachable!("not offered")
    }
}

/// The table of a polynomial surface.
pub struct PolynomialPatches(Patches);

/// The table of a rational surface.
pub struct FractionPatches(Patches);

impl SurfacePoints for PolynomialPatches {
    const COLUMN: Column = Column::Bound;
    type Point = Point;

    fn of(data: &SurfaceData) -> Self {
        Self(Patches::new(&data.knots, data.side(), &flat(&data.points)))
    }

    fn at(&self, u: f64, v: f64) -> Point {
        point(self.0.at(u, v))
    }

    fn coordinates(point: Point) -> Point {
        point
    }

    fn tangents(&self, u: f64, v: f64) -> [Point; 3] {
        self.0.tangents(u, v).map(point)
    }

    fn normal(&self, u: f64, v: f64) -> Point {
        let [_, [a, b, c, _], [d, e, f, _]] = self.0.tangents(u, v);
        let [x, y, z] = [b * f - c * e, c * d - a * f, a * e - b * d];
        let inverse = 1.0 / (x * x + y * y + z * z).sqrt();
        [x * inverse, y * inverse, z * inverse]
    }

    fn grid(&self, us: &[f64], vs: &[f64], out: &mut Vec<Point>) {
        self.0.grid(us, vs, out);
    }
}

impl SurfacePoints for FractionPatches {
    const COLUMN: Column = Column::Bound;
    const TANGENTS: bool = false;
    type Point = Point;

    fn of(data: &SurfaceData) -> Self {
        Self(Patches::new(&data.knots, data.side(), &lifted(&data.points, &data.weights)))
    }

    fn at(&self, u: f64, v: f64) -> Point {
        project(self.0.at(u, v))
    }

    fn coordinates(point: Point) -> Point {
        point
    }

    fn tangents(&self, _: f64, _: f64) -> [Point; 3] {
        unreachable!("not offered")
    }

    fn normal(&self, _: f64, _: f64) -> Point {
        unreachable!("not offered")
    }
}

pub struct Bounds;

impl Operators for Bounds {
    const COLUMN: Column = Column::Bound;
    type Curve = Plain;
    type Pieces = Plain;

    fn curve(data: &CurveData) -> Plain {
        Plain { degree: data.degree, knots: data.knots.clone(), points: data.points.clone() }
    }

    fn parts(f: &Plain) -> Parts {
        Parts { degree: f.degree, knots: f.knots.clone(), points: f.points.clone() }
    }

    fn joined(f: &Plain) -> Parts {
        Self::parts(f)
    }

    const REFINE: Operator2<Plain, [f64]> = Some(|f, _| refine::refine(f));
    const ELEVATE: Operator<Plain> = Some(elevate::elevate);
    const REMOVE: Operator<Plain> = Some(|f| {
        let (coarse, residual) = remove::remove(f);
        assert!(residual < 1e-9, "the knots are superfluous");
        coarse
    });
    const REDUCE: Operator<Plain> = Some(|f| {
        let (cubic, residual) = reduce::reduce(f);
        assert!(residual < 1e-9, "the quartic is an elevated cubic");
        cubic
    });
    const DERIVE: Operator<Plain> = Some(plain::derivative);
    const INTEGRATE: Operator<Plain> = Some(plain::antiderivative);
    const SPLIT: Operator<Plain> = Some(plain::split);
    const INTERPOLATE: Operator<[Point], Plain> = Some(interpolate::interpolate);
}
