//! Derivatives of rational splines as rational splines.
//!
//! ```text
//! (a / w)' = (a' w - a w') / w²
//! ```

use crate::coeff::Coeff;
use crate::error::Result;
use crate::rational::domain::{Domain, Interval, Rectangle};
use crate::rational::spline::Rational;
use crate::scalar::Scalar;
use crate::tensor::along::Direction;
use crate::weighted::Weighted;

impl<D: Domain<T>, T: Scalar, C: Coeff<T>> Rational<D, T, C> {
    /// The quotient rule, from the derivative of the lifted spline.
    fn quotient_rule(&self, derivative: &D::Spline<Weighted<T, C>>) -> Result<Self> {
        let numerator = D::product(self.lifted(), derivative, |a, d| {
            let mut rise = d.point.scaled(&a.weight);
            rise.add_scaled(&-d.weight.clone(), &a.point);
            rise
        });
        let weight = self.denominator()?;
        let square = D::product(&weight, &weight, |a, b| a.clone() * b)?;
        let pair = |point: &C, weight: &T| Weighted { point: point.clone(), weight: weight.clone() };
        Self::known(D::paired(&numerator?, &square, pair)?)
    }
}

impl<T: Scalar, C: Coeff<T>> Rational<Interval, T, C> {
    /// The derivative, of twice the degree.
    ///
    /// # Errors
    /// As [`Spline::derivative`](crate::Spline::derivative) and [`Spline::product_by`](crate::Spline::product_by).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, RationalFunction, Scalar};
    /// let [one, x] = [0, 1].map(|power| Function::monomial(power, Q::int(1), Q::int(2)));
    /// let inverse = RationalFunction::from_quotient(&one?, &x?)?;
    /// assert_eq!(inverse.derivative()?.at(&Q::int(2))?, Q::frac(-1, 4));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn derivative(&self) -> Result<Self> {
        self.quotient_rule(&self.lifted().derivative()?)
    }
}

impl<T: Scalar, C: Coeff<T>> Rational<Rectangle, T, C> {
    /// The partial derivative along `direction`, of twice the degrees.
    ///
    /// # Errors
    /// As [`TensorSpline::derivative`](crate::TensorSpline::derivative) and [`TensorSpline::product_by`](crate::TensorSpline::product_by).
    pub fn derivative(&self, direction: Direction) -> Result<Self> {
        self.quotient_rule(&self.lifted().derivative(direction)?)
    }
}
