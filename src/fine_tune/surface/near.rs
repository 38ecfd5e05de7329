//! Fine tuning of what is near a polynomial surface: a rational surface, say.
//!
//! Let `S` be within `τ` of `R`, a surface without jumps, and `E = R - S`. Along the edge and then along `v`, by parts,
//!
//! ```text
//! T_R - T_S = E(a, c) (1 - α(a, c)) + α E - ∫_a^u E dα(., c) - ∫_c^v E dα(u, .)
//! |T_R - T_S| <= τ (|1 - α(a, c)| + max |α| + V(α(., c)) + max_u V(α(u, .)))
//! ```
//! where `V` is the total variation, at most that of the coefficients, as for [curves](crate::fine_tune::approximate). Along the
//! other path directions are exchanged, and the mean of two paths has the mean of both bounds.

use crate::error::Result;
use crate::fine_tune::approximate::variation;
use crate::fine_tune::scale::Scale;
use crate::ops::bound::{Approximation, finite, largest};
use crate::scalar::{Scalar, larger};
use crate::tensor::along::Direction::{self, U, V};
use crate::tensor::spline::{Surface, TensorSpline};

use super::path::Path;

impl<T: Scalar, const N: usize> Approximation<Surface<T, N>, T> {
    /// The [fine-tuned](Surface::fine_tuned) approximation, and how far it is at most from the fine-tuned surface that was
    /// approximated, whether that is a spline or not.
    ///
    /// ```text
    /// |T_R - T_S| <= bound · (|1 - α(a, c)| + max |α| + V(α(., c)) + max_u V(α(u, .)))
    /// ```
    /// for the path that ends in `v`. The approximated surface may not jump. Over inexact fields what rounding does to the tuning
    /// itself is not counted.
    ///
    /// # Errors
    /// As [`Surface::fine_tuned`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::{SVector, vector};
    /// use symspline::{NurbsSurface, Path, SplineSpace, TensorSpline};
    /// let [line, parabola] = [1, 2].map(|degree| SplineSpace::bezier(degree, 0.0, 1.0));
    /// let (line, parabola) = (line?, parabola?);
    /// // A quarter of a cylinder.
    /// let arc = [vector![1.0, 0.0, 0.0], vector![1.0, 1.0, 0.0], vector![0.0, 1.0, 0.0]];
    /// let points = arc.into_iter().flat_map(|p| [p, p + SVector::z()]).collect();
    /// let half = 0.5_f64.sqrt();
    /// let quarter = NurbsSurface::new(parabola, line.clone(), points, vec![1.0, 1.0, half, half, 1.0, 1.0])?;
    /// let alpha = TensorSpline::new(line.clone(), line, vec![1.0, 1.0, 1.0, 2.0])?;
    /// let tuned = quarter.polynomial_within(&1e-6)?.fine_tuned(&alpha, Path::Both)?;
    /// assert!(tuned.bound <= 4.0 * 1e-6);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn fine_tuned<'a>(&self, alpha: impl Into<Scale<'a, TensorSpline<T>>>, path: Path) -> Result<Self> {
        let alpha = alpha.into().function()?;
        let spline = self.spline.fine_tuned(Scale::Signed(alpha), path)?;
        let opened = alpha.clamped_ends()?;
        let start = (T::one() - &opened.coeffs()[0]).magnitude() + largest(opened.coeffs());
        let along = |last: Direction| {
            let lines = if last == V { opened.clone() } else { opened.transposed() };
            let edge: Vec<T> = lines.rows().map(|row| row[0].clone()).collect();
            variation(&edge) + lines.rows().map(variation).fold(T::zero(), larger)
        };
        let ways = match path {
            Path::UThenV => along(V),
            Path::VThenU => along(U),
            Path::Both => (along(V) + along(U)) * T::frac(1, 2),
        };
        Ok(Self { spline, bound: finite(self.bound.clone() * (start + ways))? })
    }
}
