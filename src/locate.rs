//! Which span holds a parameter.

use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::space::SplineSpace;

impl<T: Scalar> SplineSpace<T> {
    /// The index `k` of the span that holds `x` in `[t_k, t_{k+1})`; the last span also holds its end.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], also for NaN.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, SplineSpace};
    /// let space = SplineSpace::clamped(1, [0.0, 1.0, 2.0])?;
    /// assert_eq!([0.0, 0.5, 1.0, 2.0].map(|x| space.locate(&x)), [Ok(1), Ok(1), Ok(2), Ok(2)]);
    /// assert!(matches!(space.locate(&2.5), Err(Error::OutsideDomain { .. })));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[inline]
    pub fn locate(&self, x: &T) -> Result<usize> {
        let (a, b) = self.domain();
        if !(x >= a && x <= b) {
            return Err(self.outside(x));
        }
        if x == b {
            return Ok(self.last_span());
        }
        let candidates = &self.knots()[self.degree()..=self.unrolled_dim()];
        Ok(self.degree() + candidates.partition_point(|t| t <= x) - 1)
    }

    /// The index `k` of the span that holds `x` in `(t_k, t_{k+1}]`; the first span also holds its start.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], also for NaN.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let space = SplineSpace::clamped(1, [0.0, 1.0, 2.0])?;
    /// assert_eq!([0.0, 0.5, 1.0, 2.0].map(|x| space.locate_left(&x)), [Ok(1), Ok(1), Ok(1), Ok(2)]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn locate_left(&self, x: &T) -> Result<usize> {
        let (a, b) = self.domain();
        if !(x >= a && x <= b) {
            return Err(self.outside(x));
        }
        let candidates = &self.knots()[self.degree() + 1..=self.unrolled_dim()];
        Ok(self.degree() + candidates.partition_point(|t| t < x))
    }

    /// As [`locate`](Self::locate), fast if `x` is in span `hint` or the one after it. Any `hint` will do.
    ///
    /// # Errors
    /// As [`locate`](Self::locate).
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let space = SplineSpace::clamped(1, [0.0, 1.0, 2.0])?;
    /// assert_eq!((space.locate_near(&1.5, 1), space.locate_near(&1.5, usize::MAX)), (Ok(2), Ok(2)));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[inline]
    pub fn locate_near(&self, x: &T, hint: usize) -> Result<usize> {
        let t = self.knots();
        let holds = |k: usize| k < self.unrolled_dim() && t[k] <= *x && *x < t[k + 1];
        match hint {
            k if k >= self.degree() && holds(k) => Ok(k),
            k if k >= self.degree() && holds(k.saturating_add(1)) => Ok(k + 1),
            _ => self.locate(x),
        }
    }

    #[cold]
    fn outside(&self, x: &T) -> Error {
        let (a, b) = self.domain();
        Error::OutsideDomain { parameter: x.to_string(), start: a.to_string(), end: b.to_string() }
    }
}
