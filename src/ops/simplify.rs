//! The same function, or nearly, with the lowest degree and the fewest knots.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::ops::bound::{Approximation, check_tolerance, epsilon};
use crate::ops::project::Contact;
use crate::ops::reduce::Continuity;
use crate::ops::removal::Limit;
use crate::scalar::Scalar;
use crate::spline::Spline;

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The same function with the lowest degree, and with the fewest knots of that degree.
    ///
    /// Outer knots and the seam of a ring are not looked for. Over `f64` only what the arithmetic finds exactly equal is
    /// simplified, which is little; use [`simplified_within`](Self::simplified_within) there.
    ///
    /// # Errors
    /// None for a valid spline, but [`Error::NotFinite`] on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, Scalar};
    /// let line = Function::monomial(1, Q::int(0), Q::int(2))?;
    /// assert_eq!(line.elevated(2)?.inserted(&[Q::int(1)])?.simplified()?, line);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn simplified(&self) -> Result<Self> {
        let mut f = self.clone();
        while f.degree() > 0 {
            match f.degree_reduced_exactly(1) {
                Ok(lower) => f = lower,
                Err(Error::NotReducible { .. }) => break,
                Err(other) => return Err(other),
            }
        }
        Ok(f.thinned(&Limit::Exact, |_, copies| copies)?.spline)
    }

    /// Nearly the same function with a lower degree and fewer knots, within `tolerance`.
    ///
    /// The degree is lowered by least squares as long as the tolerance allows and no knot has to be added; then knots are
    /// removed with what is left of it. End values of clamped splines are kept, unless a constant remains.
    /// The result is no smallest one.
    ///
    /// # Errors
    /// [`Error::BadTolerance`]; [`Error::NotFinite`] on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let f = Function::new(SplineSpace::clamped(2, [0.0, 1.0, 3.0])?, vec![0.0, 2.0, 1.0, 5.0])?;
    /// let simple = f.elevated(2)?.inserted(&[0.5, 2.0])?.simplified_within(&1e-10)?;
    /// assert_eq!(simple.spline.space(), f.space());
    /// assert!(simple.bound <= 1e-10);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn simplified_within(&self, tolerance: &T) -> Result<Approximation<Self, T>> {
        check_tolerance(tolerance)?;
        let mut near = Approximation { spline: self.clone(), bound: T::zero() };
        for by in 1..=self.degree() {
            let target = self.space().reduced_with(by, Continuity::Kept)?;
            let held = target.is_clamped() && target.dim() > 1;
            let lower = self.projected(&target, if held { Contact::both(1) } else { Contact::FREE });
            match lower {
                Ok(lower) if lower.bound <= *tolerance => near = lower,
                Ok(_) | Err(Error::Singular { .. }) => break,
                Err(other) => return Err(other),
            }
        }
        let left = tolerance.clone() - &near.bound;
        // What is left and the bound shall not add up to more than the tolerance by rounding.
        let left = if T::EXACT { left } else { left * (T::one() - T::int(8) * epsilon::<T>()) };
        let thin = near.spline.without_spare_knots(&left)?;
        Ok(Approximation { spline: thin.spline, bound: thin.bound + near.bound })
    }
}
