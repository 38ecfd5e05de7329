//! What a candidate has to offer to enter a race: points of curves, points of surfaces, operators.
//!
//! The calls are static, so that everything may be inlined as in a program that uses one crate.

use crate::data::{CurveData, Point, SurfaceData};
use crate::measure::Column;

/// A curve that gives points.
pub trait CurvePoints: Sized + 'static {
    const COLUMN: Column;
    /// Whether there are derivatives.
    const DERIVATIVES: bool = true;
    type Point: Copy + 'static;

    fn of(data: &CurveData) -> Self;
    fn at(&self, x: f64) -> Self::Point;
    fn coordinates(point: Self::Point) -> Point;

    /// The value and two derivatives.
    fn derivatives(&self, x: f64) -> [Self::Point; 3];

    /// Many points, by the crate's own batch if it has one.
    fn fill(&self, xs: &[f64], out: &mut Vec<Self::Point>) {
        out.clear();
        out.extend(xs.iter().map(|x| self.at(*x)));
    }

    fn fill_derivatives(&self, xs: &[f64], out: &mut Vec<[Self::Point; 3]>) {
        out.clear();
        out.extend(xs.iter().map(|x| self.derivatives(*x)));
    }
}

/// A surface that gives points.
pub trait SurfacePoints: Sized + 'static {
    const COLUMN: Column;
    /// Whether there are tangents and normals.
    const TANGENTS: bool = true;
    type Point: Copy + 'static;

    fn of(data: &SurfaceData) -> Self;
    fn at(&self, u: f64, v: f64) -> Self::Point;
    fn coordinates(point: Self::Point) -> Point;

    /// The value and the first derivatives.
    fn tangents(&self, u: f64, v: f64) -> [Self::Point; 3];

    /// The normal of unit length.
    fn normal(&self, u: f64, v: f64) -> Self::Point;

    fn fill(&self, pairs: &[(f64, f64)], out: &mut Vec<Self::Point>) {
        out.clear();
        out.extend(pairs.iter().map(|(u, v)| self.at(*u, *v)));
    }

    /// Row by row: all `vs` for the first of `us`, and so on. Both are even and span the domain.
    fn grid(&self, us: &[f64], vs: &[f64], out: &mut Vec<Self::Point>) {
        out.clear();
        out.extend(us.iter().flat_map(|u| vs.iter().map(|v| self.at(*u, *v))));
    }
}

/// A curve as it is checked: degree, knots, coefficients.
#[derive(Clone, Debug)]
pub struct Parts {
    pub degree: usize,
    pub knots: Vec<f64>,
    pub points: Vec<Point>,
}

/// An operator of a crate, `None` where it has no such thing.
pub type Operator<C, R = C> = Option<fn(&C) -> R>;

/// An operator of an argument beside the curve.
pub type Operator2<C, A> = Option<fn(&C, &A) -> C>;

/// Operators on curves. What they get is built beforehand and is not timed.
pub trait Operators {
    const COLUMN: Column;
    type Curve: 'static;
    type Pieces: 'static;

    fn curve(data: &CurveData) -> Self::Curve;
    fn parts(curve: &Self::Curve) -> Parts;

    /// The pieces as one spline with knots of full multiplicity.
    fn joined(pieces: &Self::Pieces) -> Parts;

    /// Inserts a knot in the middle of each span; the knots are at hand.
    const REFINE: Operator2<Self::Curve, [f64]> = None;
    const ELEVATE: Operator<Self::Curve> = None;
    /// Takes out all knots that are superfluous, found by itself.
    const REMOVE: Operator<Self::Curve> = None;
    /// Lowers the degree of a curve that was elevated.
    const REDUCE: Operator<Self::Curve> = None;
    const DERIVE: Operator<Self::Curve> = None;
    const INTEGRATE: Operator<Self::Curve> = None;
    const SPLIT: Operator<Self::Curve, Self::Pieces> = None;
    /// The cubic through points at their chord lengths from 0 to 1; knots are means of three of these.
    const INTERPOLATE: Operator<[Point], Self::Curve> = None;
}

/// Parts of pieces that follow each other, as one spline.
pub fn join(pieces: impl IntoIterator<Item = Parts>) -> Parts {
    let mut joined = Parts { degree: 0, knots: Vec::new(), points: Vec::new() };
    for piece in pieces {
        joined.degree = piece.degree;
        let order = piece.degree + 1;
        joined.knots.truncate(joined.points.len());
        joined.knots.extend(piece.knots);
        joined.points.extend(piece.points);
        debug_assert_eq!(joined.knots.len(), joined.points.len() + order);
    }
    joined
}
