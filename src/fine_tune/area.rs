//! The area under a fine-tuned curve as a quadratic form of the values of its scale function.
//!
//! ```text
//! A(D) = ½ ∫ (D - D(a)) × D' = aᵀ M a,     M_jk = ½ ∫ G_j × G_k',   G_j = ∫ φ_j C'
//! ```
//! Over a field that has no square roots a value of the form cannot be reached along every line. But where the curve itself
//! meets all other conditions `α = 1` has the area wanted, and a line through it meets the form in one other point, which is
//! rational: so areas are kept exactly.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::fine_tune::table::Table;
use crate::limits::check_entries;
use crate::scalar::{Scalar, larger};
use crate::space::SplineSpace;
use crate::spline::Curve;
use nalgebra::{DMatrix, SVector};

/// The form, symmetric.
#[derive(Clone, Debug)]
pub(crate) struct AreaForm<T> {
    matrix: DMatrix<T>,
}

impl<T: Scalar> AreaForm<T> {
    /// The form for fine-tuned versions of `curve` by scale functions in `scales`.
    ///
    /// # Errors
    /// [`Error::NotPlane`]; [`Error::TooLarge`]; those of [`Table::open`].
    pub(crate) fn of<const N: usize>(curve: &Curve<T, N>, scales: &SplineSpace<T>) -> Result<Self> {
        if N != 2 {
            return Err(Error::NotPlane { dimension: N });
        }
        let n = scales.dim();
        let table = Table::open(curve, scales)?;
        let space = &table.space;
        check_entries(n, n.max(space.dim()))?;
        let gram = space.gram(&space.derivative_space()?, 0, 0)?;
        let mut parts = Vec::with_capacity(n);
        for j in 0..n {
            let mut unit = vec![T::zero(); n];
            unit[j] = T::one();
            let mut points = vec![SVector::zeros(); space.dim()];
            table.walk(SVector::zeros(), &unit, 0, &mut points, SVector::clone);
            parts.push(points);
        }
        if !T::EXACT {
            // Of the order of one, so that products neither overflow nor vanish: only ratios of areas count.
            let sizes = parts.iter().flatten().flat_map(|point| point.iter().map(T::magnitude));
            let size = sizes.fold(T::zero(), larger);
            if !size.is_zero() {
                parts.iter_mut().flatten().for_each(|point| Coeff::divide(point, &size));
            }
        }
        // G_k' lives on a few spans, so that few of its products with the control points count.
        let weighed = |points: &Vec<SVector<T, N>>| {
            let part = Curve::new(space.clone(), points.clone())?;
            let weighed = gram.apply(part.derivative()?.coeffs())?;
            let first = weighed.iter().position(|h| !h.vanishes()).unwrap_or(0);
            let end = weighed.iter().rposition(|h| !h.vanishes()).map_or(first, |last| last + 1);
            Ok((first, weighed[first..end].to_vec()))
        };
        let weighed: Vec<_> = parts.iter().map(weighed).collect::<Result<_>>()?;
        let half = T::frac(1, 2);
        let area = |j: usize, k: usize| {
            let (first, weighed) = &weighed[k];
            let pairs = parts[j][*first..].iter().zip(weighed);
            let crosses = pairs.map(|(g, h)| g[0].clone() * &h[1] - g[1].clone() * &h[0]);
            crosses.fold(T::zero(), |sum, cross| sum + cross) * &half
        };
        let areas = DMatrix::from_fn(n, n, area);
        let matrix = DMatrix::from_fn(n, n, |j, k| (areas[(j, k)].clone() + &areas[(k, j)]) * &half);
        Ok(Self { matrix })
    }

    /// `M a`, half the gradient.
    pub(crate) fn half_gradient(&self, a: &[T]) -> Vec<T> {
        self.matrix.row_iter().map(|row| T::dot(row.iter().zip(a))).collect()
    }

    /// `aᵀ M a`.
    pub(crate) fn value(&self, a: &[T]) -> T {
        T::dot(self.half_gradient(a).iter().zip(a))
    }

    /// The size of the terms of `aᵀ M a`.
    pub(crate) fn size(&self, a: &[T]) -> T {
        let term = |(k, m): (usize, &T)| {
            let (i, j) = (k % a.len(), k / a.len());
            (a[i].clone() * m * &a[j]).magnitude()
        };
        self.matrix.iter().enumerate().map(term).fold(T::zero(), |sum, x| sum + x)
    }

    /// The other point with the area of all ones on the line from there to `a`.
    pub(crate) fn opposite(&self, a: &[T]) -> Option<Vec<T>> {
        let one = vec![T::one(); a.len()];
        let d: Vec<T> = a.iter().map(|x| x.clone() - T::one()).collect();
        let [along, bend] = [&one, &d].map(|x| T::dot(self.half_gradient(x).iter().zip(&d)));
        if d.iter().all(T::is_zero) {
            return Some(one);
        }
        if bend.is_zero() {
            return along.is_zero().then(|| a.to_vec());
        }
        let step = T::int(-2) * along / bend;
        Some(d.into_iter().map(|x| T::one() + step.clone() * x).collect())
    }
}
