//! Linear rational (Moebius) changes of the parameter: the degree stays, knots and weights change.
//!
//! The map of `[s_0, s_1]` onto `[a, b]` with ratio `ρ > 0` is
//!
//! ```text
//! (x - a) / (b - x) = ρ (s - s_0) / (s_1 - s)
//! ```
//! With `λ(s) = ((s_1 - s) + ρ (s - s_0)) / (s_1 - s_0)`, the lifted spline times `λ(s)^p` is a spline in `s` again, and
//! its coefficients are `c_i Π_j λ(s_{i+j})`, `j = 1 ... p`: its polar form takes each argument on its own [NURBS, section 6.4].

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::rational::domain::{Interval, Rectangle};
use crate::rational::spline::Rational;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;
use crate::tensor::along::Direction;

impl<T: Scalar, C: Coeff<T>> Rational<Interval, T, C> {
    /// The same curve over `[start, end]`, its parameter changed by the Moebius map with the given ratio.
    ///
    /// Of the speed that the affine map onto `[start, end]` would give, the curve starts with `ratio` times as much and ends
    /// with a `ratio`-th. The result is clamped, a periodic spline opened.
    ///
    /// # Errors
    /// [`Error::EmptyDomain`]; [`Error::Ratio`] unless the ratio is positive and finite; in `f64` those of
    /// [`SplineSpace::new`] if rounding makes distinct knots coincide, and [`Error::NotFinite`] on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, RationalFunction, Scalar};
    /// let x = RationalFunction::from_polynomial(&Function::monomial(1, Q::int(0), Q::int(1))?)?;
    /// // x = 3 s / (1 + 2 s)
    /// let faster = x.moebius(&Q::int(0), &Q::int(1), &Q::int(3))?;
    /// assert_eq!(faster.at(&Q::frac(1, 2))?, Q::frac(3, 4));
    /// assert_eq!(faster.derivatives_at(&Q::int(0), 1)?[1], Q::int(3));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn moebius(&self, start: &T, end: &T, ratio: &T) -> Result<Self> {
        // Positive factors: the denominator stays positive.
        Self::known(projectively(self.lifted(), start, end, ratio)?)
    }
}

impl<T: Scalar, C: Coeff<T>> Rational<Rectangle, T, C> {
    /// The same surface with its parameter in `direction` changed, as for [curves](Rational::moebius).
    ///
    /// # Errors
    /// [`Error::EmptyDomain`], [`Error::Ratio`].
    pub fn moebius(&self, direction: Direction, start: &T, end: &T, ratio: &T) -> Result<Self> {
        Self::known(self.lifted().along(direction, |rows| projectively(rows, start, end, ratio))?)
    }
}

/// The spline `λ(s)^p f(x(s))`.
fn projectively<T: Scalar, C: Coeff<T>>(
    f: &Spline<T, C>,
    start: &T,
    end: &T,
    ratio: &T,
) -> Result<Spline<T, C>> {
    if !(start < end && start.is_finite() && end.is_finite()) {
        return Err(Error::EmptyDomain { start: start.to_string(), end: end.to_string() });
    }
    if !(*ratio > T::zero() && ratio.is_finite()) {
        return Err(Error::Ratio { ratio: ratio.to_string() });
    }
    let f = f.clamped_ends()?;
    let (a, b) = f.domain();
    let moved = |x: &T| {
        if x == a {
            return start.clone();
        }
        if x == b {
            return end.clone();
        }
        let (before, after) = (x.clone() - a, (b.clone() - x) * ratio);
        (end.clone() * &before + start.clone() * &after) / (before + after)
    };
    let knots: Vec<T> = f.space().knots().iter().map(moved).collect();
    let length = end.clone() - start;
    let factor = |s: &T| ((end.clone() - s) + (s.clone() - start) * ratio) / &length;
    let factors: Vec<T> = knots.iter().map(factor).collect();
    let coeff = |(i, c): (usize, &C)| {
        let product = factors[i + 1..=i + f.degree()].iter().fold(T::one(), |product, s| product * s);
        c.scaled(&product)
    };
    let coeffs = f.coeffs().iter().enumerate().map(coeff).collect();
    Spline::new(SplineSpace::new(f.degree(), knots)?, coeffs)
}
