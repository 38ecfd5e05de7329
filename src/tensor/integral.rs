//! Integrals and moments over the domain.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::scalar::Scalar;
use crate::spline::Spline;
use crate::tensor::along::Direction::U;
use crate::tensor::spline::TensorSpline;

impl<T: Scalar, C: Coeff<T>> TensorSpline<T, C> {
    /// The integral `∬ S du dv` over the domain.
    ///
    /// # Errors
    /// [`NotFinite`](crate::Error::NotFinite) on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// assert_eq!(grid.integral()?, 2.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn integral(&self) -> Result<C> {
        self.contracted(U, Spline::integral)?.integral()
    }

    /// The integral over the rectangle from `start` to `end`, both `(u, v)`; of opposite sign for each direction in which
    /// `end` is before `start`.
    ///
    /// # Errors
    /// As [`Spline::integral_between`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let one = TensorSpline::constant(line.clone(), line, 1.0)?;
    /// assert_eq!(one.integral_between((&0.0, &1.0), (&0.5, &0.5))?, -0.25);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn integral_between(&self, start: (&T, &T), end: (&T, &T)) -> Result<C> {
        self.contracted(U, |rows| rows.integral_between(start.0, end.0))?.integral_between(start.1, end.1)
    }

    /// The moment `∬ u^k v^l S du dv` over the domain.
    ///
    /// # Errors
    /// As [`Spline::moment`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar, SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let one = TensorSpline::constant(line.clone(), line, Q::int(1))?;
    /// assert_eq!(one.moment(1, 2)?, Q::frac(1, 6));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn moment(&self, k: usize, l: usize) -> Result<C> {
        self.contracted(U, |rows| rows.moment(k))?.moment(l)
    }
}
