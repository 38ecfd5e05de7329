//! Interpolation of values and derivatives.
//!
//! A parameter that stands `r` times in a row takes `r` data: the value, the first derivative, and so on up to order `r - 1`
//! (Hermite's problem, in the convention of [deBoor, 2001]). All data together are one banded system, whose rows are those of the
//! [basis functions](SplineSpace::basis) and their derivatives.

use crate::build::collocate::{check_data, jets, solved};
use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The spline of `space` with these values and derivatives, of which there are as many as coefficients.
    ///
    /// Datum `k` is the derivative at `parameters[k]` of the order that tells how many parameters before it are the same:
    ///
    /// ```text
    /// parameters   a      b      b       b        c
    /// data         f(a)   f(b)   f'(b)   f''(b)   f(c)
    /// ```
    /// Derivatives are those from the right, at the end of the domain from the left, as [`derivatives_at`](Self::derivatives_at)
    /// has them. Without repetitions this is [`interpolating`](Self::interpolating). Exact over an exact field, and linear in the
    /// number of data.
    ///
    /// # Errors
    /// Those of [`interpolating`](Self::interpolating), [`Error::Undetermined`] too if a coefficient has no datum of its own;
    /// [`Error::DegreeTooLow`] for derivatives beyond the degree.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, Scalar, SplineSpace};
    /// let q = |values: &[i64]| values.iter().map(|&x| Q::int(x)).collect::<Vec<_>>();
    /// let space = SplineSpace::bezier(3, Q::int(0), Q::int(1))?;
    /// let ease = Function::osculating(&space, &q(&[0, 0, 1, 1]), &q(&[0, 0, 1, 0]))?;
    /// assert_eq!(ease.coeffs(), q(&[0, 0, 1, 1]));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "Hermite")]
    pub fn osculating(space: &SplineSpace<T>, parameters: &[T], data: &[C]) -> Result<Self> {
        check_data(space, parameters, data)?;
        if parameters.len() != space.dim() {
            return Err(Error::CoefficientCount { expected: space.dim(), found: parameters.len() });
        }
        let jets = jets(space, parameters)?;
        let values = jets.iter().zip(data).map(|(datum, value)| datum.scaled(value));
        solved(space, jets.iter().map(|datum| &datum.row), values)
    }
}
