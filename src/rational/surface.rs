//! Rational surfaces: construction, conversion, isocurves.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::exact::Q;
use crate::ops::convert::{image, rounded};
use crate::rational::domain::{Interval, Rectangle};
use crate::rational::spline::{Rational, weigh_points};
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::tensor::along::Direction;
use crate::tensor::spline::TensorSpline;

impl<T: Scalar, C: Coeff<T>> Rational<Rectangle, T, C> {
    /// The rational surface with control points and weights, row by row, over the spaces `u` and `v`.
    ///
    /// # Errors
    /// As [`TensorSpline::new`]; [`Weight`](crate::Error::Weight) for a weight that is not positive.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{NurbsSurface, SplineSpace};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let corners = vec![vector![0.0, 0.0, 0.0], vector![0.0, 1.0, 0.0], vector![1.0, 0.0, 0.0], vector![1.0, 1.0, 1.0]];
    /// let patch = NurbsSurface::new(line.clone(), line, corners, vec![1.0, 1.0, 1.0, 5.0])?;
    /// assert_eq!(patch.at(&0.5, &0.5)?, vector![0.75, 0.75, 0.625]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn new(u: SplineSpace<T>, v: SplineSpace<T>, points: Vec<C>, weights: Vec<T>) -> Result<Self> {
        Self::weighing(TensorSpline::new(u, v, weigh_points(&points, weights)?)?)
    }

    /// The space in `u`.
    pub fn u(&self) -> &SplineSpace<T> {
        self.lifted().u()
    }

    /// The space in `v`.
    pub fn v(&self) -> &SplineSpace<T> {
        self.lifted().v()
    }

    /// The rational curve on the surface at the parameter `x` in `direction`.
    ///
    /// # Errors
    /// As [`TensorSpline::isocurve`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Direction, NurbsSurface, SplineSpace};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let corners = vec![vector![0.0, 0.0], vector![0.0, 1.0], vector![1.0, 0.0], vector![1.0, 1.0]];
    /// let patch = NurbsSurface::new(line.clone(), line, corners, vec![1.0, 1.0, 1.0, 3.0])?;
    /// assert_eq!(patch.isocurve(Direction::U, &1.0)?.at(&0.5)?, vector![1.0, 0.75]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn isocurve(&self, direction: Direction, x: &T) -> Result<Rational<Interval, T, C>> {
        Rational::known(self.lifted().isocurve(direction, x)?)
    }

    /// The same surface over another field, as [`TensorSpline::map_scalars`].
    ///
    /// # Errors
    /// As [`TensorSpline::map_scalars`] and [`from_lifted`](Self::from_lifted).
    pub fn map_scalars<U: Scalar>(
        &self,
        convert: impl FnMut(&T) -> Result<U>,
    ) -> Result<Rational<Rectangle, U, C::Over<U>>> {
        Rational::from_lifted(self.lifted().map_scalars(convert)?)
    }
}

impl<C: Coeff<f64>> Rational<Rectangle, f64, C> {
    /// The same surface over the rationals, without loss, as [`TensorSpline::to_exact`].
    ///
    /// # Errors
    /// As [`TensorSpline::to_exact`].
    pub fn to_exact(&self) -> Result<Rational<Rectangle, Q, C::Over<Q>>> {
        self.map_scalars(image)
    }
}

impl<C: Coeff<Q>> Rational<Rectangle, Q, C> {
    /// The same surface, correctly rounded, as [`TensorSpline::to_f64`].
    ///
    /// # Errors
    /// As [`TensorSpline::to_f64`].
    pub fn to_f64(&self) -> Result<Rational<Rectangle, f64, C::Over<f64>>> {
        self.map_scalars(rounded)
    }
}
