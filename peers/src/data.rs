//! The splines and parameters that all candidates get, and their exact values.
//!
//! Break `i` is `i + 0.3 sin i`, number `k` of the coefficients `cos(0.7 k)`, weight `i` is `1 + 0.5 cos i`: uneven
//! and smooth, and the same as in the benches of the library.

use nalgebra::SVector;
use symspline::{Curve, NurbsCurve, NurbsSurface, Q, SplineSpace, Surface, TensorSpline};

pub type Point = [f64; 3];

/// A spline curve in space: what constructors of all crates ask for.
#[derive(Clone, Debug)]
pub struct CurveData {
    pub degree: usize,
    pub knots: Vec<f64>,
    pub points: Vec<Point>,
    /// Used by the rational candidates.
    pub weights: Vec<f64>,
}

/// A surface in space with the same knots in both directions; `points[i * n + j]`.
#[derive(Clone, Debug)]
pub struct SurfaceData {
    pub degree: usize,
    pub knots: Vec<f64>,
    pub points: Vec<Point>,
    pub weights: Vec<f64>,
}

pub fn uneven(i: usize) -> f64 {
    i as f64 + 0.3 * (i as f64).sin()
}

pub fn wave(k: usize) -> f64 {
    (0.7 * k as f64).cos()
}

fn points(count: usize) -> Vec<Point> {
    (0..count).map(|i| [0, 1, 2].map(|axis| wave(3 * i + axis))).collect()
}

fn weights(count: usize) -> Vec<f64> {
    (0..count).map(|i| 1.0 + 0.5 * (i as f64).cos()).collect()
}

/// Clamped knots over the uneven breaks, simple inside.
pub fn knots(degree: usize, spans: usize) -> Vec<f64> {
    let breaks = (0..=spans).map(uneven);
    let end = uneven(spans);
    std::iter::repeat_n(uneven(0), degree).chain(breaks).chain(std::iter::repeat_n(end, degree)).collect()
}

impl CurveData {
    pub fn new(degree: usize, spans: usize) -> Self {
        let n = degree + spans;
        Self { degree, knots: knots(degree, spans), points: points(n), weights: weights(n) }
    }

    pub fn end(&self) -> f64 {
        self.knots[self.knots.len() - 1]
    }

    pub fn space(&self) -> SplineSpace<f64> {
        SplineSpace::new(self.degree, self.knots.iter().copied()).expect("the knots are valid")
    }

    pub fn vectors(&self) -> Vec<SVector<f64, 3>> {
        self.points.iter().map(|point| SVector::from(*point)).collect()
    }

    pub fn exact(&self) -> Curve<Q, 3> {
        let curve = Curve::new(self.space(), self.vectors()).expect("one point a basis function");
        curve.to_exact().expect("all numbers are finite")
    }

    pub fn exact_rational(&self) -> NurbsCurve<Q, 3> {
        let exact = self.exact();
        let weights = self.weights.iter().map(|w| q(*w)).collect();
        NurbsCurve::new(exact.space().clone(), exact.coeffs().to_vec(), weights)
            .expect("weights are positive")
    }
}

impl SurfaceData {
    pub fn new(degree: usize, spans: usize) -> Self {
        let n = (degree + spans).pow(2);
        Self { degree, knots: knots(degree, spans), points: points(n), weights: weights(n) }
    }

    /// The number of control points in one direction.
    pub fn side(&self) -> usize {
        self.knots.len() - self.degree - 1
    }

    pub fn end(&self) -> f64 {
        self.knots[self.knots.len() - 1]
    }

    pub fn space(&self) -> SplineSpace<f64> {
        SplineSpace::new(self.degree, self.knots.iter().copied()).expect("the knots are valid")
    }

    pub fn vectors(&self) -> Vec<SVector<f64, 3>> {
        self.points.iter().map(|point| SVector::from(*point)).collect()
    }

    fn exact_parts(&self) -> (SplineSpace<Q>, Vec<SVector<Q, 3>>) {
        let space =
            SplineSpace::new(self.degree, self.knots.iter().map(|t| q(*t))).expect("the knots are valid");
        let points = self.points.iter().map(|point| SVector::from(point.map(q))).collect();
        (space, points)
    }

    pub fn exact(&self) -> Surface<Q, 3> {
        let (space, points) = self.exact_parts();
        TensorSpline::new(space.clone(), space, points).expect("one point a product of basis functions")
    }

    pub fn exact_rational(&self) -> NurbsSurface<Q, 3> {
        let (space, points) = self.exact_parts();
        let weights = self.weights.iter().map(|w| q(*w)).collect();
        NurbsSurface::new(space.clone(), space, points, weights).expect("weights are positive")
    }
}

/// The number itself as a fraction.
pub fn q(x: f64) -> Q {
    Q::try_from(x).expect("all numbers are finite")
}

/// The rounded components of exact vectors, one after the other.
pub fn rounded<'a>(vectors: impl IntoIterator<Item = &'a SVector<Q, 3>>) -> Vec<f64> {
    vectors.into_iter().flat_map(|vector| vector.iter().map(Q::to_f64).collect::<Vec<_>>()).collect()
}

/// `count` parameters from 0 to `end`, both included.
pub fn sorted(count: usize, end: f64) -> Vec<f64> {
    (0..count).map(|i| end * i as f64 / (count - 1) as f64).collect()
}

/// Numbers in `[0, end)` from a congruential generator: no cache or predictor follows it.
pub fn random(count: usize, end: f64) -> Vec<f64> {
    let next =
        |s: &u64| Some(s.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407));
    let states = std::iter::successors(Some(1), next).skip(1).take(count);
    states.map(|s: u64| end * ((s >> 11) as f64 / (1_u64 << 53) as f64)).collect()
}
