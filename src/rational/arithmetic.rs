//! Sums, products and quotients of rational splines: products of the lifted splines under pairings of weighted points.
//!
//! ```text
//! a/w + b/v = (a v + b w) / (w v)      (a/w) (b/v) = a b / (w v)      (a/w) / (b/v) = a v / (w b)
//! ```

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::ops::signs::signs;
use crate::rational::domain::Domain;
use crate::rational::spline::Rational;
use crate::scalar::Scalar;
use crate::vector::{Crossed, dot};
use crate::weighted::Weighted;
use nalgebra::SVector;

impl<D: Domain<T>, T: Scalar, C: Coeff<T>> Rational<D, T, C> {
    /// The sum. If both have the same denominator it is kept; otherwise degrees add.
    ///
    /// # Errors
    /// As [`Spline::product_by`](crate::Spline::product_by).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, RationalFunction, Scalar};
    /// let [one, x] = [0, 1].map(|power| Function::monomial(power, Q::int(1), Q::int(2)));
    /// let (one, x) = (one?, x?);
    /// let inverse = RationalFunction::from_quotient(&one, &x)?;
    /// let sum = inverse.sum(&RationalFunction::from_polynomial(&x)?)?;
    /// assert_eq!(sum.at(&Q::int(2))?, Q::frac(5, 2));
    /// assert_eq!(inverse.sum(&inverse)?.degree(), 1);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn sum(&self, other: &Self) -> Result<Self> {
        self.plus_scaled(&T::one(), other)
    }

    /// The difference `self - other`.
    ///
    /// # Errors
    /// As [`sum`](Self::sum).
    pub fn difference(&self, other: &Self) -> Result<Self> {
        self.plus_scaled(&-T::one(), other)
    }

    /// The sum `self + factor * other`.
    ///
    /// # Errors
    /// As [`sum`](Self::sum).
    pub fn plus_scaled(&self, factor: &T, other: &Self) -> Result<Self> {
        if self.denominator()? == other.denominator()? {
            let sum = |a: &Weighted<T, C>, b: &Weighted<T, C>| Weighted {
                point: a.point.plus_scaled(factor, &b.point),
                weight: a.weight.clone(),
            };
            return Self::known(D::paired(self.lifted(), other.lifted(), sum)?);
        }
        let lifted = D::product(self.lifted(), other.lifted(), |a: &Weighted<T, C>, b| {
            let mut point = a.point.scaled(&b.weight);
            point.add_scaled(&(a.weight.clone() * factor), &b.point);
            Weighted { point, weight: a.weight.clone() * &b.weight }
        });
        // A product of positive denominators.
        Self::known(lifted?)
    }

    /// The multiple `factor * self`.
    ///
    /// # Errors
    /// [`NotFinite`](crate::Error::NotFinite).
    pub fn scaled(&self, factor: &T) -> Result<Self> {
        let scale = |c: &Weighted<T, C>| Weighted { point: c.point.scaled(factor), weight: c.weight.clone() };
        Self::known(D::map_coeffs(self.lifted(), scale)?)
    }

    /// The spline moved by `by`.
    ///
    /// # Errors
    /// [`NotFinite`](crate::Error::NotFinite).
    pub fn translated(&self, by: &C) -> Result<Self> {
        let moved = |c: &Weighted<T, C>| Weighted {
            point: c.point.plus_scaled(&c.weight, by),
            weight: c.weight.clone(),
        };
        Self::known(D::map_coeffs(self.lifted(), moved)?)
    }

    /// Whether both describe the same function. Over `f64` rounding makes that rare.
    ///
    /// # Errors
    /// As [`sum`](Self::sum).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, RationalFunction, Scalar, SplineSpace};
    /// let space = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let [f, g] = [1, 2].map(|w| {
    ///     RationalFunction::new(space.clone(), [3, 4].map(Q::int).to_vec(), [w, 3 * w].map(Q::int).to_vec())
    /// });
    /// assert!(f?.same_function(&g?)?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn same_function(&self, other: &Self) -> Result<bool> {
        let difference = self.difference(other)?;
        Ok(D::coeffs(difference.lifted()).iter().all(|c| c.point.vanishes()))
    }

    /// The product with a scalar rational spline.
    ///
    /// # Errors
    /// As [`Spline::product_by`](crate::Spline::product_by).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, RationalFunction, Scalar};
    /// let [one, x] = [0, 1].map(|power| Function::monomial(power, Q::int(1), Q::int(2)));
    /// let inverse = RationalFunction::from_quotient(&one?, &x?)?;
    /// assert_eq!(inverse.times(&inverse)?.at(&Q::int(2))?, Q::frac(1, 4));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn times(&self, factor: &Rational<D, T>) -> Result<Self> {
        self.product_by(factor, |c, w| c.scaled(w))
    }

    /// The quotient by a scalar rational spline.
    ///
    /// # Errors
    /// As [`times`](Self::times); [`Pole`](crate::Error::Pole) if the divisor has a zero,
    /// [`Undecided`](crate::Error::Undecided) if that could not be decided.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, Function, Q, RationalFunction, Scalar};
    /// let x = RationalFunction::from_polynomial(&Function::monomial(1, Q::int(-2), Q::int(-1))?)?;
    /// assert_eq!(x.times(&x)?.divided(&x)?.at(&Q::int(-2))?, Q::int(-2));
    /// let through_zero = RationalFunction::from_polynomial(&Function::monomial(1, Q::int(-2), Q::int(1))?)?;
    /// assert_eq!(through_zero.divided(&through_zero).unwrap_err(), Error::Pole);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn divided(&self, divisor: &Rational<D, T>) -> Result<Self> {
        let pair = |a: &Weighted<T, C>, b: &Weighted<T>| Weighted {
            point: a.point.scaled(&b.weight),
            weight: a.weight.clone() * &b.point,
        };
        Self::from_lifted(D::product(self.lifted(), divisor.lifted(), pair)?)
    }

    /// The product under any pairing of points that is linear in both.
    ///
    /// # Errors
    /// As [`Spline::product_by`](crate::Spline::product_by).
    pub fn product_by<A: Coeff<T>, B: Coeff<T>>(
        &self,
        other: &Rational<D, T, A>,
        pair: impl Fn(&C, &A) -> B,
    ) -> Result<Rational<D, T, B>> {
        let lifted = D::product(self.lifted(), other.lifted(), |a: &Weighted<T, C>, b: &Weighted<T, A>| {
            Weighted { point: pair(&a.point, &b.point), weight: a.weight.clone() * &b.weight }
        });
        Rational::known(lifted?)
    }
}

impl<D: Domain<T>, T: Scalar, const N: usize> Rational<D, T, SVector<T, N>> {
    /// The dot product, a scalar rational spline.
    ///
    /// # Errors
    /// As [`Spline::product_by`](crate::Spline::product_by).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, RationalFunction, Scalar, circle};
    /// use nalgebra::vector;
    /// let unit = circle(&vector![Q::int(0), Q::int(0)], &Q::int(1))?;
    /// let squared = unit.dot(&unit)?;
    /// let one = Function::constant(squared.space().clone(), Q::int(1))?;
    /// assert!(squared.same_function(&RationalFunction::from_polynomial(&one)?)?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn dot(&self, other: &Self) -> Result<Rational<D, T>> {
        self.product_by(other, dot)
    }

    /// The cross product: of plane splines a scalar one, of splines in space one in space.
    ///
    /// # Errors
    /// As [`Spline::product_by`](crate::Spline::product_by).
    pub fn cross(&self, other: &Self) -> Result<Rational<D, T, <SVector<T, N> as Crossed<T>>::Product>>
    where
        SVector<T, N>: Crossed<T>,
    {
        self.product_by(other, SVector::<T, N>::crossed)
    }

    /// Coordinate `axis` as a scalar rational spline.
    ///
    /// # Errors
    /// [`IndexOutOfRange`](crate::Error::IndexOutOfRange).
    pub fn coordinate(&self, axis: usize) -> Result<Rational<D, T>> {
        if axis >= N {
            return Err(Error::IndexOutOfRange { index: axis, length: N });
        }
        let entry = |c: &Weighted<T, SVector<T, N>>| Weighted {
            point: c.point[axis].clone(),
            weight: c.weight.clone(),
        };
        Rational::known(D::map_coeffs(self.lifted(), entry)?)
    }
}

signs!([D: Domain<T>, T: Scalar, C: Coeff<T>] Rational<D, T, C>, T);
