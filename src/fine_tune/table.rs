//! Fine tuning of one curve as a table: `D` is linear in `α` but for its start, and the differences of its control points
//! depend on few values of `α` each.
//!
//! ```text
//! d_0 = C(a),   d_{i+1} = d_i + Σ_j α_j l_ij          l_ij: control point i of φ_j C', times (τ_{i+m+1} - τ_i) / (m + 1)
//! ```
//!
//! with `φ_j` the basis of the scale functions, `m` and `τ` degree and knots of `φ_j C'`. So tuning takes a short sum for
//! each control point.
//!
//! Where curve and scale functions are periodic, `φ_j C'` may stay periodic: the last leg leads back to `d_0`, provided that
//! the legs sum to zero, and `d_0` is such that `D(a) = C(a)`.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::functional::weigh;
use crate::limits::check_entries;
use crate::map::LinearMap;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Curve;
use nalgebra::SVector;
use std::ops::Range;

/// The table of a curve and a space of scale functions.
#[derive(Clone, Debug)]
pub(crate) struct Table<T, const N: usize> {
    /// `C(a)`.
    start: SVector<T, N>,
    /// For a ring, how far before `D(a)` the point `d_0` is, from the values of `α`.
    lead: Option<Vec<SVector<T, N>>>,
    /// The space of the tuned curves.
    pub space: SplineSpace<T>,
    /// The space of the scale functions.
    pub scales: SplineSpace<T>,
    /// For each axis the differences of control points as rows over the values of `α`.
    legs: Vec<LinearMap<T>>,
}

impl<T: Scalar, const N: usize> Table<T, N> {
    /// The table for clamped results.
    ///
    /// # Errors
    /// [`DomainMismatch`](crate::Error::DomainMismatch), [`Discontinuous`](crate::Error::Discontinuous),
    /// [`NotFinite`](crate::Error::NotFinite), [`TooLarge`](crate::Error::TooLarge).
    pub(crate) fn open(curve: &Curve<T, N>, scales: &SplineSpace<T>) -> Result<Self> {
        Self::over(curve.derivative()?.clamped_ends()?, scales, curve.at(curve.domain().0)?)
    }

    /// The table for periodic results, which are right where the legs sum to zero; curve and scale functions are periodic.
    ///
    /// # Errors
    /// As [`open`](Self::open).
    pub(crate) fn ring(curve: &Curve<T, N>, scales: &SplineSpace<T>) -> Result<Self> {
        Self::over(curve.derivative()?, scales, curve.at(curve.domain().0)?)
    }

    /// The map over a derivative that is a ring, or clamped.
    fn over(speed: Curve<T, N>, scales: &SplineSpace<T>, start: SVector<T, N>) -> Result<Self> {
        let ring = speed.space().is_periodic();
        let opened = if ring { scales.clone() } else { scales.clamped_ends()? };
        let opening = scales.embedding(&opened)?;
        let product = speed.space().multiplication(&opened)?;
        let scaled = speed.space().product_space(&opened)?;
        check_entries(scaled.dim(), N * (scales.degree() + 1))?;
        let legs = |axis: usize| {
            let speeds: Vec<T> = speed.coeffs().iter().map(|c| c[axis].clone()).collect();
            let table = product.fix_left(&speeds)?.after(&opening)?;
            let mut legs = LinearMap::empty(table.source_dim(), table.target_dim());
            for (i, (first, weights)) in table.rows().enumerate() {
                let mass = scaled.mass(i);
                legs.push(first, |row| row.extend(weights.iter().map(|w| mass.clone() * w)));
            }
            Ok(legs)
        };
        let mut table = Self {
            start,
            lead: None,
            space: scaled.antiderivative_space()?,
            scales: scales.clone(),
            legs: (0..N).map(legs).collect::<Result<_>>()?,
        };
        if ring {
            let at_start = table.space.basis(table.space.domain().0)?;
            let mut lead = vec![SVector::zeros(); scales.dim()];
            // From d_0 to d_i, unrolled: once more around where the indices wrap.
            let dim = table.space.dim();
            for (i, weight) in (at_start.first()..).zip(at_start.weights()) {
                for leg in 0..i {
                    let around = table.moments(leg % dim..leg % dim + 1);
                    lead.iter_mut()
                        .zip(&around)
                        .for_each(|(sum, moment)| Coeff::add_scaled(sum, weight, moment));
                }
            }
            table.lead = Some(lead);
        }
        Ok(table)
    }

    /// Writes the control points of the curve tuned by `alpha` to `points`, as many as both spaces say.
    pub(crate) fn tune_into(&self, alpha: &[T], points: &mut [SVector<T, N>]) {
        let start = match &self.lead {
            Some(lead) => self.start.minus(&weigh(0, alpha, lead)),
            None => self.start.clone(),
        };
        self.walk(start, alpha, 0, points, |place| place.clone());
    }

    /// Writes the control points from the one with index `from`, which is at `place`, each as `put` makes it.
    pub(crate) fn walk(
        &self,
        mut place: SVector<T, N>,
        alpha: &[T],
        from: usize,
        points: &mut [SVector<T, N>],
        put: impl Fn(&SVector<T, N>) -> SVector<T, N>,
    ) {
        // A leg after each, but after the last one of a curve that is open.
        let legs = self.legs.first().map_or(0, LinearMap::target_dim);
        let (walked, last) = points.split_at_mut(legs);
        for (i, point) in (from..).zip(&mut walked[from..]) {
            *point = put(&place);
            for (x, legs) in place.iter_mut().zip(&self.legs) {
                let (first, weights) = legs.row(i);
                *x += weigh(first, weights, alpha);
            }
        }
        last.iter_mut().for_each(|point| *point = put(&place));
    }

    /// The sum of some legs as points to be weighed with the values of `α`.
    pub(crate) fn moments(&self, legs: Range<usize>) -> Vec<SVector<T, N>> {
        let mut moments = vec![SVector::zeros(); self.scales.dim()];
        for (axis, map) in self.legs.iter().enumerate() {
            for (first, weights) in legs.clone().map(|i| map.row(i)) {
                for (k, weight) in weights.iter().enumerate() {
                    let j = (first + k) % self.scales.dim();
                    moments[j][axis] += weight;
                }
            }
        }
        moments
    }
}
