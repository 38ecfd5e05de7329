//! A curve with its derivative scaled.
//!
//! ```text
//! D(t) = C(a) + ∫_a^t α C'          [Miura, (1)]
//! D' = α C',   κ_D = κ / |α|        [Miura, (3)], (5) corrected
//! ```
//! With `C` of degree `n` and `α` of degree `q`, `D` has degree `n + q`; the tangent keeps its direction at every
//! parameter where `α > 0`.

use crate::error::Result;
use crate::scalar::Scalar;
use crate::spline::{Curve, Function};

impl<T: Scalar, const N: usize> Curve<T, N> {
    /// The curve that starts where this one does and has its derivative multiplied by `alpha`.
    ///
    /// For `C` of degree `n` an `alpha` of degree `n - 1` keeps the continuity of `C` with the fewest knots. The
    /// result is clamped. A periodic curve comes back open, since nothing holds its ends together.
    ///
    /// The sign of `alpha` is not looked at: where it vanishes the result stands still, where it is negative the
    /// tangent is reversed.
    ///
    /// # Errors
    /// [`DomainMismatch`](crate::Error::DomainMismatch); [`Discontinuous`](crate::Error::Discontinuous) if the curve
    /// may jump; [`NotFinite`](crate::Error::NotFinite) on overflow.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Analyse, Curve, Function, SplineSpace};
    /// let points = vec![vector![0.0, 0.0], vector![1.0, 2.0], vector![2.0, 0.0]];
    /// let curve = Curve::new(SplineSpace::bezier(2, 0.0, 1.0)?, points)?;
    /// let alpha = Function::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![1.0, 2.0])?;
    /// let tuned = curve.fine_tuned(&alpha)?;
    /// let ratio = tuned.curvature_at(&0.5)? / curve.curvature_at(&0.5)?;
    /// assert!((ratio - 1.0 / 1.5).abs() < 1e-15);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn fine_tuned(&self, alpha: &Function<T>) -> Result<Self> {
        let scaled = self.derivative()?.times(alpha)?.clamped_ends()?;
        scaled.antiderivative()?.translated(&self.at(self.domain().0)?)
    }
}
