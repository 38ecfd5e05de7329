//! The pieces of plane curves, polynomial and rational, as Bernstein coefficients of weighted points of unit size.

use crate::analysis::meet::casteljau::{Line, restrict};
use crate::analysis::meet::system::Pair;
use crate::error::{Error, Result};
use crate::rational::domain::Interval;
use crate::rational::spline::Rational;
use crate::spline::Curve;
use nalgebra::SVector;

/// How often a piece is halved at most to make its weights positive.
const HALVINGS: usize = 64;

mod sealed {
    /// Only the curves of this file have it.
    pub trait Sealed {}
    impl Sealed for crate::spline::Curve<f64, 2> {}
    impl Sealed for crate::rational::spline::NurbsCurve<f64, 2> {}
}

/// Curves of the plane, polynomial and rational.
pub trait PlaneCurve: sealed::Sealed {
    /// The distinct knots.
    #[doc(hidden)]
    fn ends(&self) -> Vec<f64>;

    /// The Bernstein coefficients between neighbouring `ends`, `(x, y, weight)` with `x` and `y` multiplied by the
    /// weight.
    #[doc(hidden)]
    fn weighted(&self, ends: &[f64]) -> Result<(usize, Vec<[f64; 3]>)>;
}

impl PlaneCurve for Curve<f64, 2> {
    fn ends(&self) -> Vec<f64> {
        self.space().ends()
    }

    fn weighted(&self, ends: &[f64]) -> Result<(usize, Vec<[f64; 3]>)> {
        Ok((self.degree(), self.bernstein(ends)?.iter().map(|c| [c[0], c[1], 1.0]).collect()))
    }
}

impl PlaneCurve for Rational<Interval, f64, SVector<f64, 2>> {
    fn ends(&self) -> Vec<f64> {
        self.space().ends()
    }

    fn weighted(&self, ends: &[f64]) -> Result<(usize, Vec<[f64; 3]>)> {
        let pieces = self.lifted().bernstein(ends)?;
        Ok((self.degree(), pieces.iter().map(|c| [c.point[0], c.point[1], c.weight]).collect()))
    }
}

/// A piece of a curve.
#[derive(Clone, Debug)]
pub(crate) struct Arc {
    /// From where to where.
    pub sides: Pair,
    /// `(x w, y w, w)` with positive weights, the greatest about one.
    pub coeffs: Vec<[f64; 3]>,
    /// The lowest and the highest corner of the box of the control points.
    pub corners: [Pair; 2],
}

impl Arc {
    fn new(sides: Pair, coeffs: Vec<[f64; 3]>) -> Self {
        let mut corners = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for c in &coeffs {
            for k in 0..2 {
                corners[0][k] = corners[0][k].min(c[k] / c[2]);
                corners[1][k] = corners[1][k].max(c[k] / c[2]);
            }
        }
        Self { sides, coeffs, corners }
    }

    /// The parameter of the curve at `x` of the piece.
    pub(crate) fn parameter(&self, x: f64) -> f64 {
        let [a, b] = self.sides;
        if x == 1.0 { b } else { (a + (b - a) * x).clamp(a, b) }
    }

    /// The greatest magnitude of a coordinate times weight.
    pub(crate) fn size(&self) -> f64 {
        self.coeffs.iter().map(|c| c[0].abs().max(c[1].abs())).fold(0.0, f64::max)
    }

    /// The least and the greatest weight.
    pub(crate) fn weights(&self) -> Pair {
        self.coeffs.iter().fold([f64::INFINITY, 0.0], |[low, high], c| [low.min(c[2]), high.max(c[2])])
    }

    /// A bound of the derivative over the unit interval: that of a rational piece is at most
    /// `p max |P_{i+1} - P_i| (max w / min w)²`.
    pub(crate) fn speed(&self) -> f64 {
        let point = |c: &[f64; 3]| [c[0] / c[2], c[1] / c[2]];
        let steps = self.coeffs.windows(2).map(|pair| {
            let [a, b] = [point(&pair[0]), point(&pair[1])];
            (b[0] - a[0]).hypot(b[1] - a[1])
        });
        let [low, high] = self.weights();
        let ratio = if low == high { 1.0 } else { (high / low).powi(2) };
        (self.coeffs.len() - 1) as f64 * steps.fold(0.0, f64::max) * ratio
    }

    pub(crate) fn start(&self) -> Pair {
        let c = &self.coeffs[0];
        [c[0] / c[2], c[1] / c[2]]
    }

    pub(crate) fn end(&self) -> Pair {
        let c = &self.coeffs[self.coeffs.len() - 1];
        [c[0] / c[2], c[1] / c[2]]
    }
}

/// The pieces of a curve, in order, with positive weights.
pub(crate) fn arcs(curve: &impl PlaneCurve) -> Result<Vec<Arc>> {
    let ends = curve.ends();
    let (p, all) = curve.weighted(&ends)?;
    let mut arcs = Vec::with_capacity(ends.len() - 1);
    for (sides, coeffs) in ends.windows(2).zip(all.chunks_exact(p + 1)) {
        // Halves are taken from the end of the list: the left one first.
        let mut open = vec![(0, [sides[0], sides[1]], coeffs.to_vec())];
        while let Some((depth, sides, coeffs)) = open.pop() {
            if coeffs.iter().all(|c| c[2] > 0.0) {
                arcs.push(Arc::new(sides, coeffs));
                continue;
            }
            let [a, b] = sides;
            let middle = a + 0.5 * (b - a);
            if depth == HALVINGS || middle <= a || middle >= b {
                return Err(Error::Undecided);
            }
            let part = |from: f64, to: f64| {
                let mut part = coeffs.clone();
                restrict(&mut part, Line::whole(p + 1), from, to);
                part
            };
            open.push((depth + 1, [middle, b], part(0.5, 1.0)));
            open.push((depth + 1, [a, middle], part(0.0, 0.5)));
        }
    }
    let finite = |arc: &Arc| arc.corners.iter().flatten().all(|x| x.is_finite());
    match arcs.iter().position(|arc| !finite(arc)) {
        Some(index) => Err(Error::NotFinite { what: "control point of piece", index }),
        None => Ok(arcs),
    }
}

/// The greatest magnitude of a coordinate.
pub(crate) fn extent(arcs: &[Arc]) -> f64 {
    arcs.iter().flat_map(|arc| arc.corners.iter().flatten()).fold(0.0, |size, x| size.max(x.abs()))
}

/// The exponent of two that takes `size` to about one.
pub(crate) fn unit_exponent(size: f64) -> i32 {
    if size == 0.0 { 0 } else { (-size.log2().ceil()).clamp(-1100.0, 1100.0) as i32 }
}

/// `x 2^exponent`, without an overflow on the way.
pub(crate) fn shifted(x: f64, exponent: i32) -> f64 {
    let half = exponent / 2;
    x * 2.0_f64.powi(half) * 2.0_f64.powi(exponent - half)
}

/// Points multiplied by a power of two, the weights of each piece brought to about one.
pub(crate) fn scaled(arcs: Vec<Arc>, exponent: i32) -> Vec<Arc> {
    let scale = |arc: Arc| {
        let weight = unit_exponent(arc.weights()[1]);
        let scale = |c: &[f64; 3]| {
            let [x, y] = [c[0], c[1]].map(|x| shifted(x, exponent + weight));
            [x, y, shifted(c[2], weight)]
        };
        Arc::new(arc.sides, arc.coeffs.iter().map(scale).collect())
    };
    arcs.into_iter().map(scale).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rational::spline::NurbsCurve;
    use crate::space::SplineSpace;
    use crate::spline::Spline;
    use crate::weighted::Weighted;
    use nalgebra::vector;

    #[test]
    fn weights_become_positive() {
        let weights = [1.0, -0.4, 1.0];
        let lifted = weights.map(|weight| Weighted { point: vector![weight, 1.0], weight });
        let space = SplineSpace::bezier(2, 0.0, 1.0).unwrap();
        let curve = NurbsCurve::from_lifted(Spline::new(space, lifted.to_vec()).unwrap()).unwrap();
        let arcs = arcs(&curve).unwrap();
        assert!(arcs.len() > 1 && arcs.iter().all(|arc| arc.weights()[0] > 0.0));
        assert!(arcs.windows(2).all(|pair| pair[0].sides[1] == pair[1].sides[0]));
        for arc in &arcs {
            let at = curve.at(&arc.sides[0]).unwrap();
            assert!((0..2).all(|k| (at[k] - arc.start()[k]).abs() < 1e-13));
        }
    }

    #[test]
    fn sizes_become_one() {
        for size in [1e-320, 1e-200, 0.5, 1.0, 3.0, 1e300, f64::MAX] {
            let unit = shifted(size, unit_exponent(size));
            assert!((0.4..=1.0).contains(&unit), "{size:e}: {unit}");
        }
    }
}
