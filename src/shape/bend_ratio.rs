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
use crate::scalar::Scalar;
use crate::spline::Function;
use crate::tensor::spline::TensorSpline;

/// The share `t` of the way from the centre that the bent point is at, from the share `s` that the bend curve is at: none at or
/// beyond the pole, where `t` would be negative, and for a negative `s`.
///
/// # Examples
/// ```
/// use symspline::shape::bend_ratio::bent_share;
/// use symspline::{Q, Scalar};
/// assert_eq!(bent_share(&Q::frac(2, 5), &Q::frac(1, 2)), Some(Q::frac(1, 4)));
/// // Away from the bend curve, and too far away.
/// assert_eq!(bent_share(&Q::frac(2, 5), &Q::int(-2)), Some(Q::int(4)));
/// assert_eq!(bent_share(&Q::frac(2, 5), &Q::int(-1)), None);
/// ```
pub fn bent_share<T: Scalar>(s: &T, lambda: &T) -> Option<T> {
    // Over a great ratio, so that no product overflows.
    let (above, below) = if lambda.magnitude() > T::one() {
        (s.clone(), (T::one() - s) / lambda + s)
    } else {
        (lambda.clone() * s, T::one() - s + lambda.clone() * s)
    };
    if below.is_zero() || *s < T::zero() || !lambda.is_finite() {
        return None;
    }
    let t = above / below;
    (t >= T::zero() && t.is_finite()).then_some(t)
}

/// The bent point `P' = (1 - t) O + t P`, if there is a [`bent_share`] `t`.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Q, Scalar, bent_point};
/// let q = |x: i64, y: i64| vector![Q::int(x), Q::int(y)];
/// let bent = bent_point(&q(1, -2), &q(5, 6), &Q::frac(2, 5), &Q::frac(1, 2));
/// assert_eq!(bent, Some(q(2, 0)));
/// ```
pub fn bent_point<T: Scalar, C: Coeff<T>>(centre: &C, point: &C, s: &T, lambda: &T) -> Option<C> {
    Some(centre.plus_scaled(&bent_share(s, lambda)?, &point.minus(centre)))
}

/// The cross ratio of a bend: one number, or a function of the nodes of the control points. Nodes outside the domain count as at its
/// end, in a ring as in its place in the domain.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn great_and_small_ratios_keep_their_meaning() {
        assert_eq!(bent_share(&2.0, &1e308), Some(1.0));
        assert_eq!(bent_share(&1e300, &1e300), Some(1.0));
        assert_eq!(bent_share(&0.5, &-1e308), Some(1.0));
        assert_eq!(bent_share(&0.5, &1e-308), Some(1e-308));
        // Behind the bend curve, where the pole is near: s = 1 / (1 - λ) = 2.
        assert!(bent_share(&2.0, &0.5).is_none() && bent_share(&1.9, &0.5).is_some());
        assert_eq!(bent_share(&1.0, &-3.0), Some(1.0));
        for (s, lambda) in [(f64::NAN, 1.0), (0.5, f64::NAN), (0.5, f64::INFINITY), (1.0, 0.0), (-0.5, 2.0)] {
            assert_eq!(bent_share(&s, &lambda), None, "{s} {lambda}");
        }
    }
}
