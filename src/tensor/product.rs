//! Products of surfaces: with scalar surfaces, dot, cross, or any bilinear pairing.
//!
//! Both factors are cut into Bezier pieces along `v`. Then the operator of one variable multiplies along `u`, its pairing
//! of two rows being the Bernstein product of their pieces, and the columns are put together again.

use crate::bernstein::Shares;
use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::limits::check_dim;
use crate::row::Row;
use crate::scalar::Scalar;
use crate::spline::Spline;
use crate::tensor::along::Direction;
use crate::tensor::spline::{Surface, TensorSpline};
use crate::vector::{cross2, cross3, dot};
use std::ops::Mul;

impl<T: Scalar, C: Coeff<T>> TensorSpline<T, C> {
    /// The product under any pairing of coefficients that is linear in both.
    ///
    /// The result lies in the [product spaces](crate::SplineSpace::product_space). Nothing checks that `pair` is
    /// bilinear.
    ///
    /// # Errors
    /// [`DomainMismatch`](Error::DomainMismatch), [`DegreeTooHigh`](Error::DegreeTooHigh), [`TooLarge`](Error::TooLarge) also
    /// if the Bezier pieces together are too many; [`NotFinite`](Error::NotFinite) on overflow.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// let pairs = grid.product_by(&grid, |x, y| vector![x * y, 0.0])?;
    /// assert_eq!(pairs.at(&1.0, &1.0)?, vector![25.0, 0.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn product_by<A: Coeff<T>, B: Coeff<T>>(
        &self,
        other: &TensorSpline<T, A>,
        pair: impl Fn(&C, &A) -> B,
    ) -> Result<TensorSpline<T, B>> {
        let (across, target) = (self.u().product_space(other.u())?, self.v().product_space(other.v())?);
        let (p, q) = (self.v().degree(), other.v().degree());
        check_dim(across.pieces(across.degree())?.dim().saturating_mul(target.pieces(p + q)?.dim()))?;
        let left = self.embedded(self.u(), &target.pieces(p)?)?;
        let right = other.embedded(other.u(), &target.pieces(q)?)?;
        let shares = Shares::new(p, q);
        let rows = left
            .spline_of_rows()
            .product_by(&right.spline_of_rows(), |row, others| Row(shares.multiply(row, others, &pair)))?;
        let pieces = TensorSpline::from_spline_of_rows(rows, target.pieces(p + q)?)?;
        pieces.along(Direction::V, |columns| {
            let coeffs = target.recomposed(&target.ends(), columns.coeffs(), &[]);
            Spline::new(target.clone(), coeffs)
        })
    }

    /// The product with a scalar surface.
    ///
    /// # Errors
    /// As [`product_by`](Self::product_by).
    ///
    /// # Examples
    /// ```
    /// use symspline::{SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// assert_eq!(grid.times(&grid)?.at(&0.5, &0.5)?, 4.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn times(&self, factor: &TensorSpline<T>) -> Result<Self> {
        self.product_by(factor, |c, w| c.scaled(w))
    }
}

impl<T: Scalar, const N: usize> Surface<T, N> {
    /// The dot product of two surfaces, a scalar surface.
    ///
    /// # Errors
    /// As [`product_by`](TensorSpline::product_by).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{SplineSpace, Surface};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let square = Surface::new(
    ///     line.clone(),
    ///     line,
    ///     vec![vector![0.0, 0.0], vector![0.0, 1.0], vector![1.0, 0.0], vector![1.0, 1.0]],
    /// )?;
    /// assert_eq!(square.dot(&square)?.at(&0.5, &1.0)?, 1.25);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn dot(&self, other: &Self) -> Result<TensorSpline<T>> {
        self.product_by(other, dot)
    }

    /// Coordinate `axis` as a scalar surface.
    ///
    /// # Errors
    /// [`IndexOutOfRange`](Error::IndexOutOfRange).
    pub fn coordinate(&self, axis: usize) -> Result<TensorSpline<T>> {
        if axis >= N {
            return Err(Error::IndexOutOfRange { index: axis, length: N });
        }
        self.map_coeffs(|c| c[axis].clone())
    }
}

impl<T: Scalar> Surface<T, 2> {
    /// The cross product `x_1 y_2 - y_1 x_2` of two plane surfaces, a scalar surface.
    ///
    /// # Errors
    /// As [`product_by`](TensorSpline::product_by).
    pub fn cross(&self, other: &Self) -> Result<TensorSpline<T>> {
        self.product_by(other, cross2)
    }
}

impl<T: Scalar> Surface<T, 3> {
    /// The cross product of two surfaces in space.
    ///
    /// # Errors
    /// As [`product_by`](TensorSpline::product_by).
    pub fn cross(&self, other: &Self) -> Result<Self> {
        self.product_by(other, cross3)
    }
}

impl<T: Scalar, C: Coeff<T>> Mul<&TensorSpline<T, C>> for &TensorSpline<T> {
    type Output = TensorSpline<T, C>;

    /// The [product](TensorSpline::times) of a scalar surface and any surface.
    ///
    /// # Panics
    /// With the text of its error.
    fn mul(self, other: &TensorSpline<T, C>) -> TensorSpline<T, C> {
        other.times(self).unwrap_or_else(|error| panic!("{error}"))
    }
}
