//! Sums, differences and multiples of surfaces, in the unions of their spaces.

use crate::coeff::{Coeff, check_pair};
use crate::error::Result;
use crate::ops::signs::signs;
use crate::scalar::Scalar;
use crate::tensor::spline::TensorSpline;

impl<T: Scalar, C: Coeff<T>> TensorSpline<T, C> {
    /// The sum.
    ///
    /// # Errors
    /// [`DomainMismatch`](crate::Error::DomainMismatch), [`DegreeTooHigh`](crate::Error::DegreeTooHigh).
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

    /// The sum `self + weight * other`.
    ///
    /// # Errors
    /// As [`sum`](Self::sum).
    ///
    /// # Examples
    /// ```
    /// use symspline::{SplineSpace, TensorSpline};
    /// let [line, parabola] = [1, 2].map(|degree| SplineSpace::bezier(degree, 0.0, 1.0));
    /// let grid = TensorSpline::new(line.clone()?, line?, vec![0.0, 1.0, 2.0, 5.0])?;
    /// let one = TensorSpline::constant(parabola.clone()?, parabola?, 1.0)?;
    /// assert_eq!(grid.plus_scaled(&2.0, &one)?.at(&0.5, &0.5)?, 4.0);
    /// assert_eq!(&grid + &grid, grid * 2.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn plus_scaled(&self, weight: &T, other: &Self) -> Result<Self> {
        check_pair(&self.coeffs()[0], &other.coeffs()[0])?;
        self.paired_by(other, |c, d| c.plus_scaled(weight, d))
    }

    /// Coefficients paired in the unions of the spaces.
    pub(crate) fn paired_by<A: Coeff<T>, B: Coeff<T>>(
        &self,
        other: &TensorSpline<T, A>,
        pair: impl Fn(&C, &A) -> B,
    ) -> Result<TensorSpline<T, B>> {
        let (u, v) = (self.u().union(other.u())?, self.v().union(other.v())?);
        let (f, g) = (self.embedded(&u, &v)?, other.embedded(&u, &v)?);
        TensorSpline::new(u, v, f.coeffs().iter().zip(g.coeffs()).map(|(c, d)| pair(c, d)).collect())
    }

    /// The multiple `factor * self`.
    ///
    /// # Errors
    /// [`NotFinite`](crate::Error::NotFinite).
    pub fn scaled(&self, factor: &T) -> Result<Self> {
        self.map_coeffs(|c| c.scaled(factor))
    }

    /// The surface moved by `by`.
    ///
    /// # Errors
    /// [`NotFinite`](crate::Error::NotFinite).
    pub fn translated(&self, by: &C) -> Result<Self> {
        check_pair(&self.coeffs()[0], by)?;
        self.map_coeffs(|c| c.plus_scaled(&T::one(), by))
    }

    /// Whether both describe the same function. Over `f64` rounding makes that rare.
    ///
    /// # Errors
    /// As [`sum`](Self::sum).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Direction, SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// assert!(grid.same_function(&grid.elevated(Direction::U, 1)?)?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn same_function(&self, other: &Self) -> Result<bool> {
        Ok(self.difference(other)?.coeffs().iter().all(C::vanishes))
    }
}

signs!([T: Scalar, C: Coeff<T>] TensorSpline<T, C>, T);
