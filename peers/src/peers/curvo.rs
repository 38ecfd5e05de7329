//! curvo: everything is rational, points have four coordinates.
//!
//! Batches go through its evaluators, which remember the span; the grid through `regular_sample_points`.

use crate::candidates::{CurvePoints, Operator, Operator2, Operators, Parts, SurfacePoints, join};
use crate::data::{CurveData, Point, SurfaceData};
use crate::measure::Column;
use crate::peers::symspline::TOLERANCE;
use curvo::prelude::{Decompose, Interpolation, NurbsCurve3D, NurbsSurface3D};
use nalgebra::{Point3, Point4, Vector3};

const COLUMN: Column = Column::Curvo;

/// A curve with weights 1.
pub struct Polynomial(NurbsCurve3D<f64>);

/// A curve with the weights of the data.
pub struct Fraction(NurbsCurve3D<f64>);

fn curve(data: &CurveData, weights: &[f64]) -> NurbsCurve3D<f64> {
    let points = data.points.iter().zip(weights).map(|(p, w)| lifted(p, *w)).collect();
    NurbsCurve3D::try_new(data.degree, points, data.knots.clone()).expect("the data are valid")
}

fn lifted([x, y, z]: &Point, w: f64) -> Point4<f64> {
    Point4::new(w * x, w * y, w * z, w)
}

fn array<const K: usize>(values: Vec<Vector3<f64>>) -> [Point3<f64>; K] {
    std::array::from_fn(|k| Point3::from(values[k]))
}

macro_rules! curve_points {
    ($kind:ident, $weights:expr) => {
        impl CurvePoints for $kind {
            const COLUMN: Column = COLUMN;
            type Point = Point3<f64>;

            fn of(data: &CurveData) -> Self {
                let weights: fn(&CurveData) -> Vec<f64> = $weights;
                Self(curve(data, &weights(data)))
            }

            fn at(&self, x: f64) -> Point3<f64> {
                self.0.point_at(x)
            }

            fn coordinates(point: Point3<f64>) -> Point {
                point.into()
            }

            fn derivatives(&self, x: f64) -> [Point3<f64>; 3] {
                array(self.0.rational_derivatives(x, 2))
            }

            fn fill(&self, xs: &[f64], out: &mut Vec<Point3<f64>>) {
                let mut evaluator = self.0.evaluator();
                out.clear();
                out.extend(xs.iter().map(|x| evaluator.point_at(*x)));
            }

            fn fill_derivatives(&self, xs: &[f64], out: &mut Vec<[Point3<f64>; 3]>) {
                let mut evaluator = self.0.evaluator();
                out.clear();
                out.extend(xs.iter().map(|x| array(evaluator.rational_derivatives(*x, 2))));
            }
        }
    };
}

curve_points!(Polynomial, |data| vec![1.0; data.points.len()]);
curve_points!(Fraction, |data| data.weights.clone());

/// A surface with weights 1.
pub struct PolynomialSurface(NurbsSurface3D<f64>);

/// A surface with the weights of the data.
pub struct FractionSurface(NurbsSurface3D<f64>);

fn surface(data: &SurfaceData, weights: &[f64]) -> NurbsSurface3D<f64> {
    let points: Vec<_> = data.points.iter().zip(weights).map(|(p, w)| lifted(p, *w)).collect();
    let net = points.chunks(data.side()).map(<[_]>::to_vec).collect();
    NurbsSurface3D::new(data.degree, data.degree, data.knots.clone(), data.knots.clone(), net)
}

macro_rules! surface_points {
    ($kind:ident, $weights:expr) => {
        impl SurfacePoints for $kind {
            const COLUMN: Column = COLUMN;
            type Point = Point3<f64>;

            fn of(data: &SurfaceData) -> Self {
                let weights: fn(&SurfaceData) -> Vec<f64> = $weights;
                Self(surface(data, &weights(data)))
            }

            fn at(&self, u: f64, v: f64) -> Point3<f64> {
                self.0.point_at(u, v)
            }

            fn coordinates(point: Point3<f64>) -> Point {
                point.into()
            }

            fn tangents(&self, u: f64, v: f64) -> [Point3<f64>; 3] {
                let all = self.0.rational_derivatives(u, v, 1);
                [all[0][0], all[1][0], all[0][1]].map(Point3::from)
            }

            fn normal(&self, u: f64, v: f64) -> Point3<f64> {
                self.0.normal_at(u, v).normalize().into()
            }

            fn fill(&self, pairs: &[(f64, f64)], out: &mut Vec<Point3<f64>>) {
                let mut evaluator = self.0.evaluator();
                out.clear();
                out.extend(pairs.iter().map(|(u, v)| evaluator.point_at(*u, *v)));
            }

            fn grid(&self, us: &[f64], vs: &[f64], out: &mut Vec<Point3<f64>>) {
                *out = self.0.regular_sample_points(us.len() - 1, vs.len() - 1).concat();
            }
        }
    };
}

surface_points!(PolynomialSurface, |data| vec![1.0; data.points.len()]);
surface_points!(FractionSurface, |data| data.weights.clone());

pub struct Curvo;

impl Operators for Curvo {
    const COLUMN: Column = COLUMN;
    type Curve = NurbsCurve3D<f64>;
    type Pieces = Vec<NurbsCurve3D<f64>>;

    fn curve(data: &CurveData) -> Self::Curve {
        curve(data, &vec![1.0; data.points.len()])
    }

    fn parts(curve: &Self::Curve) -> Parts {
        let points = curve.dehomogenized_control_points().into_iter().map(Into::into).collect();
        Parts { degree: curve.degree(), knots: curve.knots().to_vec(), points }
    }

    fn joined(pieces: &Self::Pieces) -> Parts {
        join(pieces.iter().map(Self::parts))
    }

    const REFINE: Operator2<Self::Curve, [f64]> = Some(|curve, knots| {
        let mut fine = curve.clone();
        fine.try_refine_knot(knots.to_vec()).expect("the knots are inside");
        fine
    });
    const ELEVATE: Operator<Self::Curve> =
        Some(|curve| curve.try_elevate_degree(curve.degree() + 1).expect("the degree is low"));
    const REMOVE: Operator<Self::Curve> = Some(|curve| {
        let mut coarse = curve.clone();
        coarse.try_reduce_knots(Some(TOLERANCE)).expect("knots are inside");
        coarse
    });
    const SPLIT: Operator<Self::Curve, Self::Pieces> =
        Some(|curve| curve.try_decompose().expect("the curve is valid"));
    const INTERPOLATE: Operator<[Point], Self::Curve> = Some(|points| {
        let points: Vec<Point3<f64>> = points.iter().map(|point| (*point).into()).collect();
        NurbsCurve3D::interpolate(&points, 3).expect("points differ")
    });
}
