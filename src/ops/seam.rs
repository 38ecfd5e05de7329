//! The seam of a ring put elsewhere.
//!
//! Where a periodic spline begins is a matter of numbering: from the new seam on, knots and coefficients are the same ones,
//! those that come round after the old end moved on by a period.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::knots::KnotVector;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The same periodic spline over `[x, x + period]`, with `x` a knot.
    ///
    /// `x` is inserted if it is no knot; the old seam stays one. Left of `x` parameters grow by a period: `g(y) = f(y)` from `x`
    /// to the old end, and `g(y + period) = f(y)` before. In `f64` knots that move on are rounded sums; coefficients are those
    /// of the spline with `x` inserted, in another order. At the end of the domain all parameters grow by a period.
    ///
    /// # Errors
    /// [`Error::NotPeriodic`] for an open spline; [`Error::OutsideDomain`]; in `f64` [`Error::SpanOutOfRange`] if knots are
    /// too near for rounded sums, [`Error::EmptyDomain`] if the period vanishes beside `x`, [`Error::NotFinite`] on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let ring = Function::new(SplineSpace::periodic(2, [0.0, 1.0, 2.0], 4.0)?, vec![0.0, 2.0, 1.0])?;
    /// let turned = ring.with_seam_at(&1.0)?;
    /// assert_eq!(turned.domain(), (&1.0, &5.0));
    /// assert_eq!(turned.at(&4.5)?, ring.at(&0.5)?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn with_seam_at(&self, x: &T) -> Result<Self> {
        if !self.space().is_periodic() {
            return Err(Error::NotPeriodic);
        }
        self.space().locate(x)?;
        let is_knot = self.space().breaks().iter().any(|(t, _)| t == x);
        let finer = if is_knot { self.clone() } else { self.inserted(std::slice::from_ref(x))? };
        let (space, p) = (finer.space(), finer.degree());
        let ((start, end), period) = (space.domain(), space.length());
        // The old end of the domain is where the old seam goes, without rounding.
        let moved = |t: &T| if t == start { end.clone() } else { t.clone() + &period };
        let (before, from): (Vec<&T>, Vec<&T>) = space.round_knots().iter().partition(|t| *t < x);
        let round = KnotVector::new(from.into_iter().cloned().chain(before.into_iter().map(moved)))?;
        let target =
            SplineSpace::joined(p, &round, if x == start { end.clone() } else { x.clone() + &period })?;
        // Coefficient 0 has the last copy of the seam for its knot p, as always.
        let skipped = space.knots().partition_point(|t| t <= x) - 1 - p;
        let coeffs = (0..space.dim()).map(|i| finer.coeff((i + skipped) % space.dim()).clone()).collect();
        Spline::new(target, coeffs)
    }
}
