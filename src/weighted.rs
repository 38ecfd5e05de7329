//! Weighted points: the homogeneous coordinates in which rational splines are splines.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::scalar::Scalar;

/// A point times its weight, together with the weight: a coefficient like any other.
///
/// # Examples
/// ```
/// use symspline::{Coeff, Weighted};
/// let mut middle = Weighted::new(&4.0, 3.0).scaled(&0.5);
/// middle.add_scaled(&0.5, &Weighted::new(&0.0, 1.0));
/// assert_eq!(middle.project(), 3.0);
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Weighted<T, C = T> {
    /// weight * point.
    pub point: C,
    /// The weight.
    pub weight: T,
}

impl<T: Scalar, C: Coeff<T>> Weighted<T, C> {
    /// `point` with `weight`.
    pub fn new(point: &C, weight: T) -> Self {
        Self { point: point.scaled(&weight), weight }
    }

    /// The point that is meant, `point / weight`. Over `f64` it is not finite if the weight is zero.
    ///
    /// # Panics
    /// Over a field without infinities if the weight is zero.
    #[inline]
    pub fn project(&self) -> C {
        let inverse = T::one() / &self.weight;
        if inverse.is_finite() {
            return self.point.scaled(&inverse);
        }
        // A weight near the end of the range of floating point.
        let up = T::int(1 << 60);
        self.point.scaled(&up).scaled(&(T::one() / (self.weight.clone() * up)))
    }
}

impl<T: Scalar, C: Coeff<T>> Coeff<T> for Weighted<T, C> {
    type Over<U: Scalar> = Weighted<U, C::Over<U>>;

    fn zero_like(&self) -> Self {
        Self { point: self.point.zero_like(), weight: T::zero() }
    }

    #[inline]
    fn add_scaled(&mut self, weight: &T, other: &Self) {
        self.point.add_scaled(weight, &other.point);
        self.weight.add_scaled(weight, &other.weight);
    }

    #[inline]
    fn scale(&mut self, weight: &T) {
        self.point.scale(weight);
        self.weight.scale(weight);
    }

    #[inline]
    fn divide(&mut self, divisor: &T) {
        self.point.divide(divisor);
        self.weight.divide(divisor);
    }

    fn components(&self) -> impl Iterator<Item = &T> {
        self.point.components().chain([&self.weight])
    }

    fn try_map<U: Scalar>(&self, mut f: impl FnMut(&T) -> Result<U>) -> Result<Self::Over<U>> {
        Ok(Weighted { point: self.point.try_map(&mut f)?, weight: f(&self.weight)? })
    }

    #[inline]
    fn combine<'a>(terms: impl Iterator<Item = (&'a T, &'a Self)> + Clone) -> Option<Self> {
        let point = C::combine(terms.clone().map(|(w, c)| (w, &c.point)))?;
        Some(Self { point, weight: T::combine(terms.map(|(w, c)| (w, &c.weight)))? })
    }

    fn same_shape(&self, other: &Self) -> bool {
        self.point.same_shape(&other.point)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiny_weights_have_points() {
        for weight in [1e-300, 1e-310, 5e-324] {
            let point: f64 = Weighted { point: 2.0 * weight, weight }.project();
            assert!((point - 2.0).abs() <= 2.0 * f64::EPSILON, "{weight}");
        }
        assert!(!Weighted { point: 0.0, weight: 0.0 }.project().is_finite());
    }
}
