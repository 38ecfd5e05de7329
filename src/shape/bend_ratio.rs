//! The cross ratio of a bend.
//!
//! ```text
//! R = (1 - s) O + s P,   P' = (1 - t) O + t P,   t = λ s / (1 + (λ - 1) s),   λ = t (1 - s) / (s (1 - t))
//! ```
//! [NURBS, (11.56) to (11.58)]. With `λ = 1` the point goes to `R`, with `λ = 0` to the centre, and for `λ -> ∞` it stays
//! where it is. The denominator vanishes for `s = 1 / (1 - λ)`. Points on the other side of that pole would come out behind the
//! centre, having gone through infinity: they are refused. So a negative `λ` takes `s > 1 / (1 - λ)`, and a positive one with
//! `s > 1` must be above `1 - 1/s`.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::error::shape::ShapeError;
use crate::scalar::Scalar;
use crate::spline::Function;
use crate::tensor::spline::TensorSpline;

/// The share `t` of the way from the centre that the bent point is at, from the share `s` that the bend curve is at.
///
/// # Errors
/// [`ShapeError::BeyondInfinity`] at or beyond the pole, where `t` would be negative, and for a negative `s`.
///
/// # Examples
/// ```
/// use symspline::shape::bend_ratio::bent_share;
/// use symspline::{Q, Scalar};
/// assert_eq!(bent_share(&Q::frac(2, 5), &Q::frac(1, 2))?, Q::frac(1, 4));
/// // Away from the bend curve, and too far away.
/// assert_eq!(bent_share(&Q::frac(2, 5), &Q::int(-2))?, Q::int(4));
/// assert!(bent_share(&Q::frac(2, 5), &Q::int(-1)).is_err());
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn bent_share<T: Scalar>(s: &T, lambda: &T) -> Result<T> {
    let beyond = || ShapeError::BeyondInfinity { ratio: lambda.to_string(), share: s.to_string() };
    let below = T::one() - s + lambda.clone() * s;
    if below.is_zero() || *s < T::zero() {
        return Err(beyond().into());
    }
    let t = lambda.clone() * s / below;
    if t >= T::zero() && t.is_finite() { Ok(t) } else { Err(beyond().into()) }
}

/// The bent point `P' = (1 - t) O + t P`.
///
/// # Errors
/// As [`bent_share`].
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Q, Scalar, bent_point};
/// let q = |x: i64, y: i64| vector![Q::int(x), Q::int(y)];
/// let bent = bent_point(&q(1, -2), &q(5, 6), &Q::frac(2, 5), &Q::frac(1, 2))?;
/// assert_eq!(bent, q(2, 0));
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn bent_point<T: Scalar, C: Coeff<T>>(centre: &C, point: &C, s: &T, lambda: &T) -> Result<C> {
    Ok(centre.plus_scaled(&bent_share(s, lambda)?, &point.minus(centre)))
}

/// The cross ratio of a bend: one number, or a function of the nodes of the control points.
#[derive(Clone, Debug, PartialEq)]
pub enum CrossRatio<T: Scalar> {
    /// The same everywhere.
    Constant(T),
    /// A function of the parameter along which the shape is bent.
    Along(Function<T>),
    /// A function of both parameters of a surface.
    Over(TensorSpline<T>),
}

impl<T: Scalar> From<T> for CrossRatio<T> {
    fn from(ratio: T) -> Self {
        Self::Constant(ratio)
    }
}

impl<T: Scalar> From<Function<T>> for CrossRatio<T> {
    fn from(ratio: Function<T>) -> Self {
        Self::Along(ratio)
    }
}

impl<T: Scalar> From<TensorSpline<T>> for CrossRatio<T> {
    fn from(ratio: TensorSpline<T>) -> Self {
        Self::Over(ratio)
    }
}
