//! monstertruck-geometry.

use crate::candidates::{CurvePoints, Operator, Operator2, Operators, Parts, SurfacePoints, join};
use crate::data::{CurveData, Point, SurfaceData};
use crate::measure::Column;
use monstertruck_geometry::prelude::{
    BsplineCurve, BsplineSurface, EuclideanSpace, KnotVector, NurbsCurve, NurbsSurface, ParametricCurve,
    ParametricSurface, ParametricSurface3D, Point3, Vector3, Vector4,
};

const COLUMN: Column = Column::Monstertruck;

pub type Polynomial = BsplineCurve<Point3>;
pub type Fraction = NurbsCurve<Vector4>;
pub type PolynomialSurface = BsplineSurface<Point3>;
pub type FractionSurface = NurbsSurface<Vector4>;

fn curve(data: &CurveData) -> BsplineCurve<Point3> {
    let points = data.points.iter().map(|point| (*point).into()).collect();
    BsplineCurve::new(KnotVector::from(data.knots.clone()), points)
}

fn surface(data: &SurfaceData) -> BsplineSurface<Point3> {
    let points: Vec<Point3> = data.points.iter().map(|point| (*point).into()).collect();
    let net = points.chunks(data.side()).map(<[_]>::to_vec).collect();
    let knots = || KnotVector::from(data.knots.clone());
    BsplineSurface::new((knots(), knots()), net)
}

macro_rules! curve_points {
    ($kind:ty, $of:expr) => {
        impl CurvePoints for $kind {
            const COLUMN: Column = COLUMN;
            type Point = Vector3;

            fn of(data: &CurveData) -> Self {
                let of: fn(&CurveData) -> Self = $of;
                of(data)
            }

            fn at(&self, x: f64) -> Vector3 {
                self.evaluate(x).to_vec()
            }

            fn coordinates(point: Vector3) -> Point {
                point.into()
            }

            fn derivatives(&self, x: f64) -> [Vector3; 3] {
                let all = ParametricCurve::derivatives(self, 2, x);
                [all[0], all[1], all[2]]
            }
        }
    };
}

curve_points!(BsplineCurve<Point3>, curve);
curve_points!(NurbsCurve<Vector4>, |data| {
    Self::try_from_bspline_and_weights(curve(data), data.weights.clone()).expect("one weight a point")
});

macro_rules! surface_points {
    ($kind:ty, $of:expr) => {
        impl SurfacePoints for $kind {
            const COLUMN: Column = COLUMN;
            type Point = Vector3;

            fn of(data: &SurfaceData) -> Self {
                let of: fn(&SurfaceData) -> Self = $of;
                of(data)
            }

            fn at(&self, u: f64, v: f64) -> Vector3 {
                self.evaluate(u, v).to_vec()
            }

            fn coordinates(point: Vector3) -> Point {
                point.into()
            }

            fn tangents(&self, u: f64, v: f64) -> [Vector3; 3] {
                [self.evaluate(u, v).to_vec(), self.derivative_u(u, v), self.derivative_v(u, v)]
            }

            fn normal(&self, u: f64, v: f64) -> Vector3 {
                ParametricSurface3D::normal(self, u, v)
            }
        }
    };
}

surface_points!(BsplineSurface<Point3>, surface);
surface_points!(NurbsSurface<Vector4>, |data| {
    let weights = data.weights.chunks(data.side()).map(<[_]>::to_vec).collect();
    Self::try_from_bspline_and_weights(surface(data), weights).expect("one weight a point")
});

pub struct Monstertruck;

impl Operators for Monstertruck {
    const COLUMN: Column = COLUMN;
    type Curve = BsplineCurve<Vector3>;
    type Pieces = Vec<BsplineCurve<Vector3>>;

    fn curve(data: &CurveData) -> Self::Curve {
        let points = data.points.iter().map(|point| (*point).into()).collect();
        BsplineCurve::new(KnotVector::from(data.knots.clone()), points)
    }

    fn parts(curve: &Self::Curve) -> Parts {
        let mut knots = curve.knot_vector().to_vec();
        let mut points: Vec<Point> = curve.control_points().iter().map(|c| (*c).into()).collect();
        let degree = curve.degree();
        // Derivatives keep one knot too many at either end, with a coefficient that never counts.
        if knots[0] == knots[degree + 1] {
            knots = knots[1..knots.len() - 1].to_vec();
            points = points[1..points.len() - 1].to_vec();
        }
        Parts { degree, knots, points }
    }

    fn joined(pieces: &Self::Pieces) -> Parts {
        join(pieces.iter().map(Self::parts))
    }

    const REFINE: Operator2<Self::Curve, [f64]> = Some(|curve, knots| {
        let mut fine = curve.clone();
        for t in knots {
            fine.add_knot(*t);
        }
        fine
    });
    const ELEVATE: Operator<Self::Curve> = Some(|curve| {
        let mut raised = curve.clone();
        raised.elevate_degree();
        raised
    });
    const REMOVE: Operator<Self::Curve> = Some(|curve| {
        let mut coarse = curve.clone();
        coarse.optimize();
        coarse
    });
    const DERIVE: Operator<Self::Curve> = Some(BsplineCurve::derivation);
    const SPLIT: Operator<Self::Curve, Self::Pieces> = Some(BsplineCurve::bezier_decomposition);
    // Parameters and knots it takes from outside.
    const INTERPOLATE: Operator<[Point], Self::Curve> = Some(|points| {
        let vectors: Vec<_> = points.iter().map(|point| nalgebra::SVector::from(*point)).collect();
        let parameters = symspline::chord_length(&vectors).expect("points differ");
        let space = symspline::interpolation_space(3, &parameters).expect("parameters differ");
        let pairs: Vec<(f64, Vector3)> =
            parameters.into_iter().zip(points.iter().map(|p| (*p).into())).collect();
        BsplineCurve::interpolate(KnotVector::from(space.knots().to_vec()), pairs)
    });
}
