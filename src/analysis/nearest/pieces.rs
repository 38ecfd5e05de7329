//! The Bernstein pieces of a curve or surface, at unit size and with positive weights.

use crate::analysis::nearest::scale::Scale;
use crate::analysis::nearest::split::{count, halve};
use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::ops::patch::Patch;
use crate::space::SplineSpace;
use crate::weighted::Weighted;
use nalgebra::SVector;

/// How many halvings at most make the weights of a patch positive.
const HALVINGS: usize = 20_000;

/// A patch is kept whole if it has more coefficients than this.
const LARGE: usize = 64;

/// Inner weights of a piece are no smaller than this share of those at corners, which the spline has: a control point
/// with next to no weight may be anywhere, and the size of all is that of the largest.
const LIGHT: f64 = 1.0 / 64.0;

/// From where to where in each direction.
pub(super) type Sides = [(f64, f64); 2];

/// A span of a curve or patch of a surface, or a part of one.
#[derive(Clone, Debug)]
pub(super) struct Root {
    /// The parameters of the whole.
    span: Sides,
    /// Which part of it this is; `(0, 1)` is the whole.
    part: Sides,
}

impl Root {
    /// The parameter in the domain of the local one, which runs from 0 to 1.
    pub(super) fn global(&self, axis: usize, t: f64) -> f64 {
        let ((a, b), (low, high)) = (self.span[axis], self.part[axis]);
        let s = low + t * (high - low);
        // Both ends are knots, without rounding.
        if s == 1.0 { b } else { (a + s * (b - a)).clamp(a, b) }
    }

    /// The local parameter of one in the domain.
    pub(super) fn local(&self, axis: usize, x: f64) -> f64 {
        let ((a, b), (low, high)) = (self.span[axis], self.part[axis]);
        if a == b { 0.0 } else { ((x - a) / (b - a) - low) / (high - low) }
    }

    /// The length in the domain.
    pub(super) fn width(&self, axis: usize) -> f64 {
        let ((a, b), (low, high)) = (self.span[axis], self.part[axis]);
        (high - low) * (b - a)
    }
}

/// A direction of the domain.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    pub(super) domain: (f64, f64),
    pub(super) periodic: bool,
    /// The knots where there may be a jump.
    pub(super) torn: Vec<f64>,
}

impl Axis {
    pub(super) fn of(space: &SplineSpace<f64>) -> Self {
        let (a, b) = space.domain();
        let torn = space.breaks().into_iter().filter(|(_, copies)| *copies > space.degree()).map(|(t, _)| t);
        Self { domain: (*a, *b), periodic: space.is_periodic(), torn: torn.collect() }
    }

    /// The second direction of a curve.
    pub(super) fn none() -> Self {
        Self { domain: (0.0, 0.0), periodic: false, torn: Vec::new() }
    }
}

/// The coefficients of a piece: points, or weighted ones.
pub(super) trait Lifted<const N: usize>: Coeff<f64> {
    /// Whether all have the same weight.
    const PLAIN: bool;

    /// The point times its weight.
    fn point(&self) -> &SVector<f64, N>;

    /// The weight.
    fn weight(&self) -> f64;
}

impl<const N: usize> Lifted<N> for SVector<f64, N> {
    const PLAIN: bool = true;

    fn point(&self) -> &SVector<f64, N> {
        self
    }

    fn weight(&self) -> f64 {
        1.0
    }
}

impl<const N: usize> Lifted<N> for Weighted<f64, SVector<f64, N>> {
    const PLAIN: bool = false;

    fn point(&self) -> &SVector<f64, N> {
        &self.point
    }

    fn weight(&self) -> f64 {
        self.weight
    }
}

/// All pieces.
#[derive(Clone, Debug)]
pub(super) struct Pieces<const N: usize> {
    pub(super) degrees: [usize; 2],
    pub(super) axes: [Axis; 2],
    pub(super) roots: Vec<Root>,
    /// The points times their weights, of each piece [`count`] of them.
    pub(super) points: Vec<SVector<f64, N>>,
    /// The weights, in each piece of unit size; none if all are one.
    pub(super) weights: Vec<f64>,
    pub(super) scale: Scale,
}

impl<const N: usize> Pieces<N> {
    /// The pieces that these patches make, each cut into a few if it bends much.
    pub(super) fn new<C: Lifted<N>, const D: usize>(
        patches: Vec<Patch<f64, D, C>>,
        axes: [Axis; 2],
    ) -> Result<Self> {
        let at = |d: usize| patches.first().and_then(|patch| patch.degrees.get(d)).copied().unwrap_or(0);
        let degrees = [at(0), at(1)];
        let mut pieces = Self {
            degrees,
            axes,
            roots: Vec::new(),
            points: Vec::new(),
            weights: Vec::new(),
            scale: Scale::of(0.0),
        };
        for patch in patches {
            let side = |d: usize| patch.sides.get(d).copied().unwrap_or((0.0, 0.0));
            let whole = Root { span: [side(0), side(1)], part: [(0.0, 1.0); 2] };
            pieces.cut(whole, patch.coeffs)?;
        }
        pieces.bring_to_size()
    }

    /// Adds a patch in parts of positive weights that do not bend much.
    fn cut<C: Lifted<N>>(&mut self, whole: Root, coeffs: Vec<C>) -> Result<()> {
        let n = count(self.degrees);
        let (mut open, mut coeffs, mut halvings) = (vec![(whole, 0)], coeffs, 0);
        while let Some((root, depth)) = open.pop() {
            let first = coeffs.len() - n;
            let piece = &coeffs[first..];
            let Some(axis) = self.axis_to_cut(piece, depth) else {
                let largest = piece.iter().map(C::weight).fold(0.0, f64::max);
                let scale = Scale::of(largest);
                if !C::PLAIN {
                    self.weights.extend(piece.iter().map(|c| scale.down(c.weight())));
                }
                let points = piece
                    .iter()
                    .map(|c| if C::PLAIN { *c.point() } else { c.point().map(|x| scale.down(x)) });
                self.points.extend(points);
                self.roots.push(root);
                coeffs.truncate(first);
                continue;
            };
            halvings += 1;
            if halvings > HALVINGS {
                return Err(Error::Undecided);
            }
            halve(&mut coeffs, first, self.degrees, axis, false);
            let (low, high) = root.part[axis];
            let middle = 0.5 * (low + high);
            let (mut lower, mut upper) = (root.clone(), root);
            (lower.part[axis], upper.part[axis]) = ((low, middle), (middle, high));
            open.extend([(upper, depth + 1), (lower, depth + 1)]);
        }
        Ok(())
    }

    /// In which direction a piece is to be halved, if at all: for weights well above zero always, and a few times for bends.
    fn axis_to_cut<C: Lifted<N>>(&self, piece: &[C], depth: usize) -> Option<usize> {
        let [p, q] = self.degrees;
        let corners = [0, q, p * (q + 1), p * (q + 1) + q].map(|k| piece[k].weight());
        let least = LIGHT * corners.into_iter().fold(f64::INFINITY, f64::min);
        let positive = piece.iter().all(|c| c.weight() > 0.0 && c.weight() >= least);
        if !positive {
            return Some(if q == 0 || (p > 0 && depth.is_multiple_of(2)) { 0 } else { 1 });
        }
        let dimensions = usize::from(p > 0) + usize::from(q > 0);
        if depth >= 2 * dimensions || piece.len() > LARGE {
            return None;
        }
        let quotient = |k: usize| piece[k].point() / piece[k].weight();
        (0..2).find(|&axis| self.degrees[axis] > 1 && bends(quotient, self.degrees, axis))
    }

    /// Scales all points so that the largest coordinate is about one.
    fn bring_to_size(mut self) -> Result<Self> {
        let weight = |k: usize| self.weights.get(k).copied().unwrap_or(1.0);
        let sizes = self.points.iter().enumerate().map(|(k, c)| c.amax() / weight(k));
        let size = sizes.fold(0.0, f64::max);
        if !size.is_finite() {
            return Err(Error::NotFinite { what: "control point of a piece", index: 0 });
        }
        self.scale = Scale::of(size);
        for c in &mut self.points {
            *c = c.map(|x| self.scale.down(x));
        }
        Ok(self)
    }
}

/// Whether a control polygon in direction `axis` turns by more than a quarter of a right angle or so.
fn bends<const N: usize>(point: impl Fn(usize) -> SVector<f64, N>, degrees: [usize; 2], axis: usize) -> bool {
    let [p, q] = degrees;
    let lines = if axis == 0 { q + 1 } else { p + 1 };
    (0..lines).any(|line| {
        let at = |i: usize| if axis == 0 { point(i * (q + 1) + line) } else { point(line * (q + 1) + i) };
        let last = degrees[axis];
        let polygon: f64 = (0..last).map(|i| length(&(at(i + 1) - at(i)))).sum();
        polygon > 1.03 * length(&(at(last) - at(0)))
    })
}

/// The length of a vector of any size.
fn length<const N: usize>(v: &SVector<f64, N>) -> f64 {
    let size = v.amax();
    if size > 0.0 && size.is_finite() { (v / size).norm() * size } else { size }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::vector;

    #[test]
    fn parts_keep_their_knots() {
        let root = Root { span: [(0.1, 0.7), (0.0, 0.0)], part: [(0.5, 1.0), (0.0, 1.0)] };
        assert_eq!((root.global(0, 1.0), root.global(1, 0.5)), (0.7, 0.0));
        assert!((root.local(0, root.global(0, 0.25)) - 0.25).abs() < 1e-15);
        assert!((root.width(0) - 0.3).abs() < 1e-15);
    }

    #[test]
    fn weights_become_positive() {
        // The weight 1 - 1.8 x (1 - x) has a negative coefficient in the middle if written as a quadratic of 1, -0.8, 1.
        let lift = |x: f64, weight: f64| Weighted { point: vector![x], weight };
        let coeffs = vec![lift(0.0, 1.0), lift(1.0, -0.8), lift(2.0, 1.0)];
        let patch = Patch { degrees: [2], sides: [(0.0, 1.0)], coeffs };
        let pieces = Pieces::new(vec![patch], [Axis::none(), Axis::none()]).unwrap();
        assert!(pieces.roots.len() > 1);
        assert!(pieces.weights.iter().all(|w| *w > 0.0));
    }

    #[test]
    fn next_to_no_weight_makes_no_far_point() {
        let lift = |x: f64, weight: f64| Weighted { point: vector![x], weight };
        let coeffs = vec![lift(1.0, 1.0), lift(1.0, 1e-17), lift(1.0, 1.0)];
        let patch = Patch { degrees: [2], sides: [(0.0, 1.0)], coeffs };
        let pieces = Pieces::new(vec![patch], [Axis::none(), Axis::none()]).unwrap();
        assert!(pieces.scale.up(1.0) <= 4.0);
    }
}
