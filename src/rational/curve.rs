//! Rational curves and functions: construction and conversion.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::exact::Q;
use crate::ops::convert::{image, rounded};
use crate::rational::domain::Interval;
use crate::rational::spline::{Rational, weigh_points};
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;

impl<T: Scalar, C: Coeff<T>> Rational<Interval, T, C> {
    /// The rational spline with control points `points` and `weights` in `space`.
    ///
    /// # Errors
    /// As [`Spline::new`]; [`Weight`](crate::Error::Weight) for a weight that is not positive.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, RationalFunction, SplineSpace};
    /// let space = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let f = RationalFunction::new(space.clone(), vec![0.0, 1.0], vec![1.0, 3.0])?;
    /// assert_eq!(f.at(&0.5)?, 0.75);
    /// let wrong = RationalFunction::new(space, vec![0.0, 1.0], vec![1.0, 0.0]);
    /// assert_eq!(wrong.unwrap_err(), Error::Weight { index: 1, weight: "0".into() });
    /// # Ok::<(), Error>(())
    /// ```
    pub fn new(space: SplineSpace<T>, points: Vec<C>, weights: Vec<T>) -> Result<Self> {
        Self::weighing(Spline::new(space, weigh_points(&points, weights)?)?)
    }

    /// The space of numerator and denominator.
    pub fn space(&self) -> &SplineSpace<T> {
        self.lifted().space()
    }

    /// The degree of numerator and denominator.
    pub fn degree(&self) -> usize {
        self.lifted().degree()
    }

    /// Start and end of the domain.
    pub fn domain(&self) -> (&T, &T) {
        self.lifted().domain()
    }

    /// The same spline over another field, as [`Spline::map_scalars`].
    ///
    /// # Errors
    /// As [`Spline::map_scalars`] and [`from_lifted`](Self::from_lifted).
    pub fn map_scalars<U: Scalar>(
        &self,
        convert: impl FnMut(&T) -> Result<U>,
    ) -> Result<Rational<Interval, U, C::Over<U>>> {
        Rational::from_lifted(self.lifted().map_scalars(convert)?)
    }
}

impl<C: Coeff<f64>> Rational<Interval, f64, C> {
    /// The same spline over the rationals, without loss, as [`Spline::to_exact`].
    ///
    /// # Errors
    /// As [`Spline::to_exact`].
    pub fn to_exact(&self) -> Result<Rational<Interval, Q, C::Over<Q>>> {
        self.map_scalars(image)
    }
}

impl<C: Coeff<Q>> Rational<Interval, Q, C> {
    /// The same spline with knots, weights and weighted points correctly rounded, as [`Spline::to_f64`].
    ///
    /// # Errors
    /// As [`Spline::to_f64`].
    pub fn to_f64(&self) -> Result<Rational<Interval, f64, C::Over<f64>>> {
        self.map_scalars(rounded)
    }
}
