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
use crate::ops::bound::{Approximation, check_tolerance, finite, largest, left_of};
use crate::rational::domain::Domain;
use crate::rational::spline::Rational;
use crate::scalar::Scalar;
use crate::weighted::Weighted;

impl<D: Domain<T>, T: Scalar, C: Coeff<T>> Rational<D, T, C> {
    /// An approximation within `tolerance`, a distance between points, by `operator`, which is given the lifted spline and
    /// the tolerance that holds there.
    ///
    /// # Errors
    /// [`Error::BadTolerance`]; [`Error::Weight`] if a weight is not positive; those of `operator`;
    /// [`Error::OutOfTolerance`] if its bound is above the tolerance it was given; [`Error::NotFinite`] on overflow.
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
        let homogeneous = |point: C| Weighted { point, weight: T::one() };
        let points: Vec<Weighted<T, C>> = self.points()?.into_iter().map(homogeneous).collect();
        let reach = finite(largest(&points))?;
        let smaller = |w: T, v: &T| if *v < w { v.clone() } else { w };
        let least = self.weights().skip(1).fold(D::coeffs(self.lifted())[0].weight.clone(), smaller);
        // Each quotient is at most one, so that nothing overflows.
        let scale = if reach < *tolerance { tolerance } else { &reach };
        let shares = reach.clone() / scale + tolerance.clone() / scale;
        let allowed = left_of(&(tolerance.clone() / scale / shares * &least), &T::zero());
        let Approximation { spline, bound } = operator(self.lifted(), &allowed)?;
        let within = bound <= allowed;
        if !within {
            return Err(Error::OutOfTolerance { bound: bound.to_string(), tolerance: allowed.to_string() });
        }
        let bound = finite(bound.clone() / (least - &bound) * reach)?;
        // Rounding up may not pass what is certain.
        let bound = if bound < *tolerance { bound } else { tolerance.clone() };
        Ok(Approximation { spline: Self::from_lifted(spline)?, bound })
    }
}
