//! Fine tuning of what is near a polynomial curve: a rational curve, say.
//!
//! Let `S` be within `τ` of `R`, a curve without jumps, and let `D_R` and `D_S` be the curves with the derivatives `α R'` and `α S'` that start at `R(a)` and
//! `S(a)`. With `E = R - S`, by parts,
//!
//! ```text
//! D_R(t) - D_S(t) = E(a) + ∫_a^t α E' = E(a) (1 - α(a)) + α(t) E(t) - ∫_a^t E dα
//! |D_R - D_S| <= τ (|1 - α(a)| + max |α| + V(α))
//! ```
//! where `V` is the total variation, `∫ |α'|` and the heights of jumps. It is not more than that of the coefficients,
//! `Σ |c_i+1 - c_i|`, since knot insertion never raises theirs.

use crate::error::Result;
use crate::fine_tune::scale::Scale;
use crate::ops::bound::{Approximation, finite};
use crate::scalar::Scalar;
use crate::spline::{Curve, Function};

impl<T: Scalar, const N: usize> Approximation<Curve<T, N>, T> {
    /// The [fine-tuned](Curve::fine_tuned) approximation, and how far it is at most from the fine-tuned curve that was
    /// approximated, whether that is a spline or not.
    ///
    /// ```text
    /// |D_R - D_S| <= bound · (|1 - α(a)| + max |α| + V(α))
    /// ```
    /// The approximated curve may not jump. Over inexact fields what rounding does to the tuning itself is not counted.
    ///
    /// # Errors
    /// As [`Curve::fine_tuned`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Function, circle};
    /// let near = circle(&vector![0.0, 0.0], &1.0)?.polynomial_within(&1e-9)?;
    /// let spiral = near.fine_tuned(&Function::monomial(1, 0.0, 1.0)?.translated(&1.0)?)?;
    /// assert!(spiral.bound <= 3.0 * 1e-9);
    /// // α(1) E(1) less ∫ R, which is zero for the whole circle: the end is α(1) R(1) - α(0) R(0) away from the start.
    /// assert!((spiral.spline.at(&1.0)?[0] - 2.0).abs() < 0.2);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn fine_tuned<'a>(&self, alpha: impl Into<Scale<'a, Function<T>>>) -> Result<Self> {
        let alpha = alpha.into().function()?;
        let spline = self.spline.fine_tuned(Scale::Signed(alpha))?;
        let opened = alpha.clamped_ends()?;
        let start = (T::one() - &opened.coeffs()[0]).magnitude();
        let factor = start + alpha.size_bound()? + variation(opened.coeffs());
        Ok(Self { spline, bound: finite(self.bound.clone() * factor)? })
    }
}

/// The total variation of some coefficients, `Σ |c_i+1 - c_i|`.
pub(crate) fn variation<T: Scalar>(coeffs: &[T]) -> T {
    coeffs.windows(2).fold(T::zero(), |sum, c| sum + (c[1].clone() - &c[0]).magnitude())
}
