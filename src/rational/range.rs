//! Between which values a rational function runs, and in which box a rational curve or surface lies.
//!
//! With positive weights a value is a mean of control values, on every patch: so the enclosure of polynomials serves, each
//! coefficient standing for its quotient.

use crate::error::Result;
use crate::ops::enclose::Enclosure;
use crate::ops::range::{box_of, each_axis};
use crate::rational::domain::Domain;
use crate::rational::spline::Rational;
use crate::scalar::Scalar;
use nalgebra::SVector;

impl<D: Domain<T>, T: Scalar> Rational<D, T> {
    /// The least and the greatest value, each enclosed as by [`Function::range`](crate::Function::range).
    ///
    /// # Errors
    /// As [`Function::range`](crate::Function::range); [`Weight`](crate::Error::Weight) if a weight is not positive.
    ///
    /// # Examples
    /// ```
    /// use symspline::{RationalFunction, SplineSpace};
    /// // 2 x (1 - x) / (1 - x (1 - x)) is 2/3 at most, in the middle.
    /// let space = SplineSpace::bezier(2, 0.0, 1.0)?;
    /// let hill = RationalFunction::new(space, vec![0.0, 2.0, 0.0], vec![1.0, 0.5, 1.0])?;
    /// let range = hill.range(&1e-9)?;
    /// assert!((range.greatest.value - 2.0 / 3.0).abs() < 1e-9);
    /// assert_eq!((range.greatest.parameter, range.least.bound), (0.5, 0.0));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn range(&self, accuracy: &T) -> Result<Enclosure<T, D::Parameter>> {
        self.check_weights()?;
        D::range(self.lifted(), accuracy)
    }
}

impl<D: Domain<T>, T: Scalar, const N: usize> Rational<D, T, SVector<T, N>> {
    /// The lowest and the highest corner of the box of the control points, in which the spline lies.
    ///
    /// # Errors
    /// [`Weight`](crate::Error::Weight) if a weight is not positive.
    pub fn control_box(&self) -> Result<(SVector<T, N>, SVector<T, N>)> {
        Ok(box_of(&self.points()?))
    }

    /// The range of every coordinate, enclosed as by [`range`](Rational::range): a box that is too large by `accuracy` at
    /// most on every side.
    ///
    /// # Errors
    /// As [`range`](Rational::range).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Q, Scalar, circle};
    /// let circle = circle(&vector![Q::int(5), Q::int(0)], &Q::int(2))?;
    /// let [x, y] = circle.bounding_box(&Q::frac(1, 1000))?;
    /// assert_eq!([x.least.bound, x.greatest.bound, y.least.bound, y.greatest.bound], [3, 7, -2, 2].map(Q::int));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn bounding_box(&self, accuracy: &T) -> Result<[Enclosure<T, D::Parameter>; N]> {
        each_axis(|axis| self.coordinate(axis)?.range(accuracy))
    }
}
