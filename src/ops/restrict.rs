//! Parts of a spline on parts of its domain. Parameters stay what they were.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::map::LinearMap;
use crate::parts::Parts;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;

impl<T: Scalar> SplineSpace<T> {
    /// The space with clamped ends of the restrictions to `[a, b]`.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`Error::EmptyDomain`]; in `f64` [`Error::SpanOutOfRange`] if `a` and `b` are hardly distinct.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let space = SplineSpace::clamped(1, [0.0, 1.0, 2.0])?.restricted_space(&0.5, &1.5)?;
    /// assert_eq!(space, SplineSpace::clamped(1, [0.5, 1.0, 1.5])?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn restricted_space(&self, a: &T, b: &T) -> Result<Self> {
        self.locate(a)?;
        self.locate(b)?;
        if a >= b {
            return Err(Error::EmptyDomain { start: a.to_string(), end: b.to_string() });
        }
        let end = |t: &T| vec![t.clone(); self.degree() + 1];
        let inner = self.parts().inner.into_iter().filter(|(t, _)| a < t && t < b).collect();
        Self::from_parts(self.degree(), Parts { left: end(a), inner, right: end(b) })
    }

    /// The restriction to `[a, b]` as a map to [`restricted_space`](Self::restricted_space).
    ///
    /// # Errors
    /// As [`restricted_space`](Self::restricted_space).
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let half = SplineSpace::bezier(2, 0.0, 1.0)?.restriction(&0.0, &0.5)?;
    /// assert_eq!(half.apply(&[0.0, 2.0, 0.0])?, [0.0, 1.0, 1.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn restriction(&self, a: &T, b: &T) -> Result<LinearMap<T>> {
        Ok(self.insertion_rows(&self.restricted_space(a, b)?))
    }
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The restriction to `[a, b]`, with clamped ends.
    ///
    /// A periodic spline gives an open one; to go over the seam, join two restrictions.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`Error::EmptyDomain`] unless `a < b`.
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// let part = Function::monomial(2, 0.0, 4.0)?.restricted(&1.0, &2.0)?;
    /// assert_eq!(part.domain(), (&1.0, &2.0));
    /// assert_eq!(part.coeffs(), [1.0, 2.0, 4.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn restricted(&self, a: &T, b: &T) -> Result<Self> {
        let target = self.space().restricted_space(a, b)?;
        let coeffs = self.space().inserted_coeffs(&target, self.coeffs());
        Spline::new(target, coeffs)
    }

    /// The two parts left and right of `x`. At a jump each takes its own limit.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::EmptyDomain`] if `x` is an end.
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// let (left, right) = Function::monomial(1, 0.0, 2.0)?.split(&0.5)?;
    /// assert_eq!((left.coeffs(), right.coeffs()), (&[0.0, 0.5][..], &[0.5, 2.0][..]));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn split(&self, x: &T) -> Result<(Self, Self)> {
        let (a, b) = self.domain();
        Ok((self.restricted(a, x)?, self.restricted(x, b)?))
    }
}
