//! Fine tuning of one curve by many scale functions: the map `α ↦ D` as a table.
//!
//! `D` is linear in `α` but for its start, and the differences of its control points depend on few values of `α` each:
//!
//! ```text
//! d_0 = C(a),   d_{i+1} = d_i + Σ_j α_j l_ij          l_ij: control point i of φ_j C', times (τ_{i+m+1} - τ_i) / (m + 1)
//! ```
//!
//! with `φ_j` the basis of the scale functions, `m` and `τ` degree and knots of `φ_j C'`. So tuning takes a short sum for each
//! control point, while a value of `α` is dragged.

use crate::error::{Error, Result};
use crate::functional::weigh;
use crate::limits::check_entries;
use crate::map::LinearMap;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Curve;
use nalgebra::SVector;

/// A curve prepared for fine tuning by scale functions of one space, made by [`Curve::fine_tuning`].
///
/// # Examples
/// ```
/// use nalgebra::{SVector, vector};
/// use symspline::{Curve, Function, SplineSpace};
/// let points = vec![vector![0.0, 0.0], vector![1.0, 2.0], vector![2.0, 0.0]];
/// let curve = Curve::new(SplineSpace::bezier(2, 0.0, 1.0)?, points)?;
/// let tuning = curve.fine_tuning(&SplineSpace::bezier(1, 0.0, 1.0)?)?;
/// let mut places = vec![SVector::zeros(); tuning.space().dim()];
/// for last in [1.0, 1.5, 2.0] {
///     tuning.tune_into(&[1.0, last], &mut places)?;
/// }
/// let alpha = Function::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![1.0, 2.0])?;
/// assert_eq!(places, curve.fine_tuned(&alpha)?.coeffs());
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct FineTuning<T, const N: usize> {
    start: SVector<T, N>,
    space: SplineSpace<T>,
    values: usize,
    /// For each axis the differences of control points as rows over the values of `α`.
    legs: Vec<LinearMap<T>>,
}

impl<T: Scalar, const N: usize> Curve<T, N> {
    /// The map from scale functions in `scales` to [fine-tuned](Self::fine_tuned) curves, for dragging.
    ///
    /// # Errors
    /// As [`fine_tuned`](Self::fine_tuned); [`TooLarge`](Error::TooLarge).
    pub fn fine_tuning(&self, scales: &SplineSpace<T>) -> Result<FineTuning<T, N>> {
        let speed = self.derivative()?.clamped_ends()?;
        let opened = scales.clamped_ends()?;
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
        Ok(FineTuning {
            start: self.at(self.domain().0)?,
            space: scaled.antiderivative_space()?,
            values: scales.dim(),
            legs: (0..N).map(legs).collect::<Result<_>>()?,
        })
    }
}

impl<T: Scalar, const N: usize> FineTuning<T, N> {
    /// The space of the tuned curves.
    pub fn space(&self) -> &SplineSpace<T> {
        &self.space
    }

    /// The curve tuned by the scale function with these coefficients.
    ///
    /// # Errors
    /// [`CoefficientCount`](Error::CoefficientCount); [`NotFinite`](Error::NotFinite) on overflow.
    pub fn tuned(&self, alpha: &[T]) -> Result<Curve<T, N>> {
        let mut points = vec![SVector::zeros(); self.space.dim()];
        self.tune_into(alpha, &mut points)?;
        Curve::new(self.space.clone(), points)
    }

    /// Writes the control points of the [tuned](Self::tuned) curve to `points`; nothing is allocated and nothing searched.
    ///
    /// # Errors
    /// [`CoefficientCount`](Error::CoefficientCount) unless `alpha` has as many values as its space and `points` as many places as
    /// [`space`](Self::space). Then `points` is as it was.
    pub fn tune_into(&self, alpha: &[T], points: &mut [SVector<T, N>]) -> Result<()> {
        let lengths = [(self.values, alpha.len()), (self.space.dim(), points.len())];
        if let Some(&(expected, found)) = lengths.iter().find(|(expected, found)| expected != found) {
            return Err(Error::CoefficientCount { expected, found });
        }
        let mut place = self.start.clone();
        let (last, others) = points.split_last_mut().expect("a space has a coefficient");
        for (i, point) in others.iter_mut().enumerate() {
            point.clone_from(&place);
            for (x, legs) in place.iter_mut().zip(&self.legs) {
                let (first, weights) = legs.row(i);
                *x += weigh(first, weights, alpha);
            }
        }
        *last = place;
        Ok(())
    }
}
