//! The same function, or nearly, with the lowest degree and the fewest knots.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::ops::bound::{Approximation, check_tolerance, left_of, sum_above};
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
    /// removed with what is left of it. End values of clamped splines are kept, unless the degree becomes 0.
    /// The result is no smallest one. Degrees above half of [`MAX_DEGREE`](crate::limits::MAX_DEGREE) stay.
    ///
    /// # Errors
    /// [`Error::BadTolerance`].
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
                // Degrees too high for products, and numbers at the end of the range, can still lose knots.
                Ok(_)
                | Err(Error::Singular { .. } | Error::NotFinite { .. } | Error::DegreeTooHigh { .. }) => {
                    break;
                }
                Err(other) => return Err(other),
            }
        }
        let thin = near.spline.without_spare_knots(&left_of(tolerance, &near.bound))?;
        let both = sum_above(thin.bound, &near.bound);
        // Rounding up may not pass what is certain.
        let bound = if both < *tolerance { both } else { tolerance.clone() };
        Ok(Approximation { spline: thin.spline, bound })
    }
}

#[cfg(test)]
mod tests {
    use crate::space::SplineSpace;
    use crate::spline::Function;

    #[test]
    fn what_cannot_be_projected_can_lose_knots() {
        let high = Function::monomial(300, 0.0, 1.0).unwrap().inserted(&[0.5]).unwrap();
        let simple = high.simplified_within(&1e-3).unwrap();
        assert_eq!((simple.spline.degree(), simple.spline.space().breaks().len()), (300, 2));
        let huge = Function::new(SplineSpace::uniform(3, 3, 0.0, 1.0).unwrap(), vec![f64::MAX; 6]).unwrap();
        assert!(huge.simplified_within(&1.0).is_ok());
    }

    #[test]
    fn singular_rings_keep_their_knots() {
        let ring = SplineSpace::uniform_periodic(100, 4, 0.0, 1.0).unwrap();
        let ring = Function::new(ring, vec![0.0, 0.99, -0.25, -0.92]).unwrap();
        assert!(ring.without_spare_knots(&1e9).is_ok());
    }
}
