//! Approximation of rational splines by approximating what they are in homogeneous coordinates.
//!
//! With `f = n / w` and an approximation `(ñ, w̃)` of `(n, w)` to `ε`, the new quotient `g = ñ / w̃` has
//!
//! ```text
//! f - g = ((n - ñ) - f (w - w̃)) / w̃      |f - g| <= ε √(1 + |f|²) / (w_min - ε)
//! ```
//! Control points bound `|f|`, and the least weight is `w_min`. So to stay within `τ` it takes
//! `ε = τ w_min / (√(1 + |f|²) + τ)`.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::ops::bound::{Approximation, check_tolerance};
use crate::rational::domain::Domain;
use crate::rational::spline::Rational;
use crate::scalar::{Scalar, larger};
use crate::weighted::Weighted;

impl<D: Domain<T>, T: Scalar, C: Coeff<T>> Rational<D, T, C> {
    /// An approximation within `tolerance`, a distance between points, by `operator`, which is given the lifted spline and
    /// the tolerance that holds there.
    ///
    /// # Errors
    /// [`Error::BadTolerance`]; [`Error::Weight`] if a weight is not positive; those of `operator`;
    /// [`Error::OutOfTolerance`] if its bound is above the tolerance it was given.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Q, Scalar, circle};
    /// let circle = circle(&vector![Q::int(0), Q::int(0)], &Q::int(1))?;
    /// let refined = circle.through(|lifted| lifted.inserted(&[Q::frac(1, 3), Q::frac(1, 3)]))?;
    /// let back = refined.approximated(&Q::int(0), |lifted, tolerance| lifted.without_spare_knots(tolerance))?;
    /// assert!(back.spline.same_function(&circle)?);
    /// // Half a circle is one quadratic, with a weight of zero: one more knot could go.
    /// assert_eq!((back.bound, back.spline.space().dim()), (Q::int(0), 7));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn approximated(
        &self,
        tolerance: &T,
        operator: impl FnOnce(
            &D::Spline<Weighted<T, C>>,
            &T,
        ) -> Result<Approximation<D::Spline<Weighted<T, C>>, T>>,
    ) -> Result<Approximation<Self, T>> {
        check_tolerance(tolerance)?;
        let farthest = self.points()?.iter().map(C::squared_size).fold(T::zero(), larger);
        let reach = (T::one() + farthest).root_above();
        let smaller = |w: T, v: &T| if *v < w { v.clone() } else { w };
        let least = self.weights().skip(1).fold(D::coeffs(self.lifted())[0].weight.clone(), smaller);
        let allowed = tolerance.clone() * &least / (reach.clone() + tolerance);
        let Approximation { spline, bound } = operator(self.lifted(), &allowed)?;
        let within = bound <= allowed;
        if !within {
            return Err(Error::OutOfTolerance { bound: bound.to_string(), tolerance: allowed.to_string() });
        }
        let bound = bound.clone() * reach / (least - bound);
        Ok(Approximation { spline: Self::from_lifted(spline)?, bound })
    }
}
