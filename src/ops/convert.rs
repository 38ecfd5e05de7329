//! From `f64` to exact rationals without loss, and back with one rounding.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::exact::Q;
use crate::spline::Spline;

impl<C: Coeff<f64>> Spline<f64, C> {
    /// The same spline over the rationals: every double is a fraction, so nothing is lost.
    ///
    /// The two describe the same function exactly; what was rounded before stays rounded.
    ///
    /// # Errors
    /// None for a valid open spline. A periodic one is unrolled anew in exact arithmetic, where knots that rounding
    /// had made equal or distinct may no longer be so.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, Scalar};
    /// let square = Function::monomial(2, 0.0, 1.0)?.to_exact()?;
    /// assert_eq!(square.at(&Q::frac(1, 3))?, Q::frac(1, 9));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn to_exact(&self) -> Result<Spline<Q, C::Over<Q>>> {
        self.map_scalars(image)
    }
}

impl<C: Coeff<Q>> Spline<Q, C> {
    /// The same spline with knots and coefficients correctly rounded to `f64`.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for numbers beyond the range of `f64`; those of a space whose knots fall together.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, Scalar};
    /// let line = Function::monomial(1, Q::int(0), Q::frac(1, 3))?.to_f64()?;
    /// assert_eq!(line.coeffs(), [0.0, 1.0 / 3.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn to_f64(&self) -> Result<Spline<f64, C::Over<f64>>> {
        self.map_scalars(rounded)
    }
}

/// A double as the fraction that it is.
pub(crate) fn image(x: &f64) -> Result<Q> {
    Q::try_from(*x)
}

/// The nearest double, if there is one.
pub(crate) fn rounded(x: &Q) -> Result<f64> {
    match x.to_f64() {
        nearest if nearest.is_finite() => Ok(nearest),
        _ => Err(Error::NotFinite { what: "value", index: 0 }),
    }
}
