//! symspline by its public interface.

use crate::candidates::{CurvePoints, Operator, Operator2, Operators, Parts, SurfacePoints, join};
use crate::data::{CurveData, Point, SurfaceData};
use crate::measure::Column;
use nalgebra::SVector;
use symspline::{Curve, NurbsCurve, NurbsSurface, Surface, chord_length, interpolation_space};

type Vector = SVector<f64, 3>;

/// A value at a parameter of the domain. `expect` would look at the error by reference, for which the value takes a detour
/// through memory.
#[inline(always)]
pub fn inside<V>(value: symspline::Result<V>) -> V {
    match value {
        Ok(value) => value,
        Err(error) => panic!("{error}"),
    }
}

pub fn curve(data: &CurveData) -> Curve<f64, 3> {
    Curve::new(data.space(), data.vectors()).expect("one point a basis function")
}

fn array<const K: usize>(values: Vec<Vector>) -> [Vector; K] {
    values.try_into().expect("as many derivatives as were asked for")
}

impl CurvePoints for Curve<f64, 3> {
    const COLUMN: Column = Column::Symspline;
    type Point = Vector;

    fn of(data: &CurveData) -> Self {
        curve(data)
    }

    fn at(&self, x: f64) -> Vector {
        inside(Self::at(self, &x))
    }

    fn coordinates(point: Vector) -> Point {
        point.into()
    }

    fn derivatives(&self, x: f64) -> [Vector; 3] {
        array(inside(self.derivatives_at(&x, 2)))
    }

    fn fill(&self, xs: &[f64], out: &mut Vec<Vector>) {
        out.resize(xs.len(), Vector::zeros());
        inside(self.eval_into(xs, out));
    }
}

impl CurvePoints for NurbsCurve<f64, 3> {
    const COLUMN: Column = Column::Symspline;
    type Point = Vector;

    fn of(data: &CurveData) -> Self {
        Self::new(data.space(), data.vectors(), data.weights.clone()).expect("weights are positive")
    }

    fn at(&self, x: f64) -> Vector {
        inside(Self::at(self, &x))
    }

    fn coordinates(point: Vector) -> Point {
        point.into()
    }

    fn derivatives(&self, x: f64) -> [Vector; 3] {
        array(inside(self.derivatives_at(&x, 2)))
    }

    fn fill(&self, xs: &[f64], out: &mut Vec<Vector>) {
        *out = inside(self.eval(xs));
    }
}

impl SurfacePoints for Surface<f64, 3> {
    const COLUMN: Column = Column::Symspline;
    type Point = Vector;

    fn of(data: &SurfaceData) -> Self {
        Self::new(data.space(), data.space(), data.vectors()).expect("one point a product of basis functions")
    }

    fn at(&self, u: f64, v: f64) -> Vector {
        inside(Self::at(self, &u, &v))
    }

    fn coordinates(point: Vector) -> Point {
        point.into()
    }

    fn tangents(&self, u: f64, v: f64) -> [Vector; 3] {
        inside(self.tangents_at(&u, &v))
    }

    fn normal(&self, u: f64, v: f64) -> Vector {
        self.unit_normal_at(&u, &v).expect("the surface is regular")
    }

    fn fill(&self, pairs: &[(f64, f64)], out: &mut Vec<Vector>) {
        *out = inside(self.eval(pairs));
    }

    fn grid(&self, us: &[f64], vs: &[f64], out: &mut Vec<Vector>) {
        *out = inside(self.eval_grid(us, vs));
    }
}

impl SurfacePoints for NurbsSurface<f64, 3> {
    const COLUMN: Column = Column::Symspline;
    type Point = Vector;

    fn of(data: &SurfaceData) -> Self {
        Self::new(data.space(), data.space(), data.vectors(), data.weights.clone())
            .expect("weights are positive")
    }

    fn at(&self, u: f64, v: f64) -> Vector {
        inside(Self::at(self, &u, &v))
    }

    fn coordinates(point: Vector) -> Point {
        point.into()
    }

    fn tangents(&self, u: f64, v: f64) -> [Vector; 3] {
        inside(self.tangents_at(&u, &v))
    }

    fn normal(&self, u: f64, v: f64) -> Vector {
        self.unit_normal_at(&u, &v).expect("the surface is regular")
    }

    fn fill(&self, pairs: &[(f64, f64)], out: &mut Vec<Vector>) {
        *out = inside(self.eval(pairs));
    }

    fn grid(&self, us: &[f64], vs: &[f64], out: &mut Vec<Vector>) {
        *out = inside(self.eval_grid(us, vs));
    }
}

/// The tolerance of operators that take one.
pub const TOLERANCE: f64 = 1e-9;

pub struct Symspline;

impl Operators for Symspline {
    const COLUMN: Column = Column::Symspline;
    type Curve = Curve<f64, 3>;
    type Pieces = Vec<Curve<f64, 3>>;

    fn curve(data: &CurveData) -> Self::Curve {
        curve(data)
    }

    fn parts(curve: &Self::Curve) -> Parts {
        let points = curve.coeffs().iter().map(|c| (*c).into()).collect();
        Parts { degree: curve.degree(), knots: curve.space().knots().to_vec(), points }
    }

    fn joined(pieces: &Self::Pieces) -> Parts {
        join(pieces.iter().map(Self::parts))
    }

    const REFINE: Operator2<Self::Curve, [f64]> =
        Some(|curve, knots| curve.inserted(knots).expect("the knots are new"));
    const ELEVATE: Operator<Self::Curve> = Some(|curve| curve.elevated(1).expect("the degree is low"));
    const REMOVE: Operator<Self::Curve> =
        Some(|curve| curve.without_spare_knots(&TOLERANCE).expect("the tolerance is positive").spline);
    const REDUCE: Operator<Self::Curve> =
        Some(|curve| curve.degree_lowered(1).and_then(|f| f.within(&TOLERANCE)).expect("it was elevated"));
    const DERIVE: Operator<Self::Curve> = Some(|curve| curve.derivative().expect("the curve is smooth"));
    const INTEGRATE: Operator<Self::Curve> =
        Some(|curve| curve.antiderivative().expect("it is not periodic"));
    const SPLIT: Operator<Self::Curve, Self::Pieces> =
        Some(|curve| curve.bezier_pieces().expect("the size is small"));
    const INTERPOLATE: Operator<[Point], Self::Curve> = Some(|points| {
        let points: Vec<Vector> = points.iter().map(|point| (*point).into()).collect();
        let parameters = chord_length(&points).expect("points differ");
        let space = interpolation_space(3, &parameters).expect("parameters differ");
        Curve::interpolating(&space, &parameters, &points).expect("the knots are means of parameters")
    });
}
