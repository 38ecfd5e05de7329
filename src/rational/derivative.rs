//! Derivatives of rational splines as rational splines.
//!
//! ```text
//! (a / w)^(k) = n_k / w^(k+1)        n_0 = a,    n_k = n_(k-1)' w - k n_(k-1) w'
//! ```
//! The degree grows by that of `w` with each order; the quotient rule again and again would double it.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::limits::check_degree;
use crate::rational::domain::{Domain, Interval, Rectangle};
use crate::rational::spline::Rational;
use crate::scalar::Scalar;
use crate::tensor::along::Direction;
use crate::weighted::Weighted;

impl<D: Domain<T>, T: Scalar, C: Coeff<T>> Rational<D, T, C> {
    /// The derivative of so many orders along each direction.
    fn derived(&self, orders: &[usize]) -> Result<Self> {
        check_degree(orders.iter().fold(0, |sum, order| sum.saturating_add(*order)))?;
        let weight = self.denominator()?;
        let times = |a: &T, b: &T| a.clone() * b;
        let mut found: Option<(D::Spline<C>, D::Spline<T>)> = None;
        let mut done = 0;
        for (direction, order) in orders.iter().enumerate().filter(|(_, order)| **order > 0) {
            let lifted = D::derivative(self.lifted(), direction)?;
            for _ in 0..*order {
                done += 1;
                let factor = -T::int(done);
                let difference = |mut rise: C, fall: &C| {
                    rise.add_scaled(&factor, fall);
                    rise
                };
                found = Some(match found {
                    None => {
                        let numerator = D::product(self.lifted(), &lifted, |a, d| {
                            difference(d.point.scaled(&a.weight), &a.point.scaled(&d.weight))
                        });
                        (numerator?, D::product(&weight, &weight, times)?)
                    }
                    Some((numerator, power)) => {
                        let slope = D::derivative(&numerator, direction)?;
                        let rise = D::product(&slope, &weight, C::scaled)?;
                        let fall = D::product(&numerator, &lifted, |n, d| n.scaled(&d.weight))?;
                        let numerator = D::paired(&rise, &fall, |rise, fall| difference(rise.clone(), fall));
                        (numerator?, D::product(&power, &weight, times)?)
                    }
                });
            }
        }
        let Some((numerator, power)) = found else {
            return Ok(self.clone());
        };
        let pair = |point: &C, weight: &T| Weighted { point: point.clone(), weight: weight.clone() };
        Self::known(D::paired(&numerator, &power, pair)?)
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
        self.nth_derivative(1)
    }

    /// The derivative of order `order`, of `order + 1` times the degree; of order 0 the spline itself.
    ///
    /// # Errors
    /// As [`derivative`](Self::derivative); [`Error::DegreeTooHigh`](crate::Error::DegreeTooHigh).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, RationalFunction, Scalar};
    /// let [one, x] = [0, 1].map(|power| Function::monomial(power, Q::int(1), Q::int(2)));
    /// let inverse = RationalFunction::from_quotient(&one?, &x?)?;
    /// assert_eq!(inverse.nth_derivative(3)?.at(&Q::int(2))?, Q::frac(-6, 16));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn nth_derivative(&self, order: usize) -> Result<Self> {
        self.derived(&[order])
    }
}

impl<T: Scalar, C: Coeff<T>> Rational<Rectangle, T, C> {
    /// The partial derivative along `direction`, of twice the degrees.
    ///
    /// # Errors
    /// As [`TensorSpline::derivative`](crate::TensorSpline::derivative) and [`TensorSpline::product_by`](crate::TensorSpline::product_by).
    pub fn derivative(&self, direction: Direction) -> Result<Self> {
        match direction {
            Direction::U => self.partial(1, 0),
            Direction::V => self.partial(0, 1),
        }
    }

    /// The partial derivative of order `k` in `u` and `l` in `v`, of `k + l + 1` times the degrees; of order 0 the surface itself.
    ///
    /// # Errors
    /// As [`derivative`](Self::derivative); [`Error::DegreeTooHigh`](crate::Error::DegreeTooHigh).
    ///
    /// # Examples
    /// ```
    /// use symspline::{NurbsSurface, Q, Scalar, SplineSpace};
    /// use nalgebra::vector;
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let corners = [[0, 0], [0, 1], [1, 0], [1, 1]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
    /// let patch = NurbsSurface::new(line.clone(), line, corners.to_vec(), [1, 2, 3, 4].map(Q::int).to_vec())?;
    /// let (u, v) = (Q::frac(1, 3), Q::frac(1, 2));
    /// assert_eq!(patch.partial(2, 1)?.at(&u, &v)?, patch.derivatives_at(&u, &v, 3)?[2][1]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn partial(&self, k: usize, l: usize) -> Result<Self> {
        self.derived(&[k, l])
    }
}
