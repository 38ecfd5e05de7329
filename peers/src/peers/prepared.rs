//! symspline's evaluators: splines prepared for many values.

use crate::candidates::{CurvePoints, SurfacePoints};
use crate::data::{CurveData, Point, SurfaceData};
use crate::measure::Column;
use crate::peers::symspline::{curve, inside};
use nalgebra::SVector;
use symspline::{
    Evaluate, Evaluator, NurbsCurve, NurbsSurface, RationalEvaluator, Surface, SurfaceEvaluator, Weighted,
};

type Vector = SVector<f64, 3>;
type Lifted = Weighted<f64, Vector>;

/// An evaluator, whose parameters are numbers or pairs.
pub struct Prepared<E>(E);

pub type Polynomial = Prepared<Evaluator<f64, Vector>>;
pub type Fraction = Prepared<RationalEvaluator<Evaluator<f64, Lifted>>>;
pub type PolynomialSurface = Prepared<SurfaceEvaluator<f64, Vector>>;
pub type FractionSurface = Prepared<RationalEvaluator<SurfaceEvaluator<f64, Lifted>>>;

/// How an evaluator is made.
trait Make<D> {
    fn make(data: &D) -> Self;
}

impl Make<CurveData> for Evaluator<f64, Vector> {
    fn make(data: &CurveData) -> Self {
        curve(data).evaluator().expect("the coefficients are small")
    }
}

impl Make<CurveData> for RationalEvaluator<Evaluator<f64, Lifted>> {
    fn make(data: &CurveData) -> Self {
        let curve = NurbsCurve::new(data.space(), data.vectors(), data.weights.clone());
        curve.and_then(|curve| curve.evaluator()).expect("weights are positive")
    }
}

impl Make<SurfaceData> for SurfaceEvaluator<f64, Vector> {
    fn make(data: &SurfaceData) -> Self {
        let surface = Surface::new(data.space(), data.space(), data.vectors());
        surface.and_then(|surface| surface.evaluator()).expect("the coefficients are small")
    }
}

impl Make<SurfaceData> for RationalEvaluator<SurfaceEvaluator<f64, Lifted>> {
    fn make(data: &SurfaceData) -> Self {
        let surface = NurbsSurface::new(data.space(), data.space(), data.vectors(), data.weights.clone());
        surface.and_then(|surface| surface.evaluator()).expect("weights are positive")
    }
}

impl<E> CurvePoints for Prepared<E>
where
    E: Evaluate<Parameter = f64, Value = Vector, Derivatives<3> = [Vector; 3]> + Make<CurveData> + 'static,
{
    const COLUMN: Column = Column::Prepared;
    type Point = Vector;

    fn of(data: &CurveData) -> Self {
        Self(E::make(data))
    }

    fn at(&self, x: f64) -> Vector {
        inside(self.0.at(&x))
    }

    fn coordinates(point: Vector) -> Point {
        point.into()
    }

    fn derivatives(&self, x: f64) -> [Vector; 3] {
        inside(self.0.derivatives_at::<3>(&x))
    }

    fn fill(&self, xs: &[f64], out: &mut Vec<Vector>) {
        out.resize(xs.len(), Vector::zeros());
        inside(self.0.eval_into(xs, out));
    }

    fn fill_derivatives(&self, xs: &[f64], out: &mut Vec<[Vector; 3]>) {
        out.resize(xs.len(), [Vector::zeros(); 3]);
        inside(self.0.eval_derivatives_into::<3>(xs, out));
    }
}

impl<E> SurfacePoints for Prepared<E>
where
    E: Evaluate<Parameter = (f64, f64), Value = Vector, Derivatives<2> = [[Vector; 2]; 2]>
        + Make<SurfaceData>
        + 'static,
{
    const COLUMN: Column = Column::Prepared;
    type Point = Vector;

    fn of(data: &SurfaceData) -> Self {
        Self(E::make(data))
    }

    fn at(&self, u: f64, v: f64) -> Vector {
        inside(self.0.at(&(u, v)))
    }

    fn coordinates(point: Vector) -> Point {
        point.into()
    }

    fn tangents(&self, u: f64, v: f64) -> [Vector; 3] {
        let [[value, along_v], [along_u, _]] = inside(self.0.derivatives_at::<2>(&(u, v)));
        [value, along_u, along_v]
    }

    fn normal(&self, u: f64, v: f64) -> Vector {
        let [_, along_u, along_v] = self.tangents(u, v);
        along_u.cross(&along_v).normalize()
    }

    fn fill(&self, pairs: &[(f64, f64)], out: &mut Vec<Vector>) {
        out.resize(pairs.len(), Vector::zeros());
        inside(self.0.eval_into(pairs, out));
    }
}
