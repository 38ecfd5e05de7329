//! Nodes: where the influence of a coefficient is near its largest.

use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::space::SplineSpace;

impl<T: Scalar> SplineSpace<T> {
    /// Node `i`, the Greville abscissa `(t_{i+1} + ... + t_{i+p}) / p` [NURBS, (11.4)], of a coefficient of the unrolled
    /// space.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`].
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// assert_eq!(SplineSpace::clamped(2, [0.0, 1.0, 3.0])?.node(2)?, 2.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn node(&self, i: usize) -> Result<T> {
        let length = self.unrolled_dim();
        if i < length { Ok(self.mean_of_knots(i)) } else { Err(Error::IndexOutOfRange { index: i, length }) }
    }

    /// The coefficient with influence at `x` whose node is nearest to `x`, the first of two [NURBS, (11.5)]; an unrolled
    /// index.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let space = SplineSpace::clamped(3, [0.0, 1.0, 2.0, 3.0])?;
    /// assert_eq!((space.nearest_node(&0.1)?, space.nearest_node(&1.4)?), (0, 2));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn nearest_node(&self, x: &T) -> Result<usize> {
        let k = self.locate(x)?;
        let distance = |i: usize| (self.mean_of_knots(i) - x).magnitude();
        let nearer = |best: (usize, T), i: usize| {
            let here = distance(i);
            if here < best.1 { (i, here) } else { best }
        };
        let first = k - self.degree();
        Ok((first + 1..=k).fold((first, distance(first)), nearer).0)
    }

    /// The last coefficient whose node is at or before `x`, of those with influence on the span of `x`; the next node is
    /// after `x`, but at the end of the domain.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`ShapeError::NoNodeBefore`] in an unclamped space before its first node.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let space = SplineSpace::clamped(3, [0.0, 1.0, 2.0, 3.0])?;
    /// assert_eq!((space.node_before(&0.1)?, space.node_before(&1.4)?), (0, 2));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn node_before(&self, x: &T) -> Result<usize> {
        let k = self.locate(x)?;
        let found = (k - self.degree()..=k).rev().find(|i| self.mean_of_knots(*i) <= *x);
        found.ok_or_else(|| ShapeError::NoNodeBefore { parameter: x.to_string() }.into())
    }
}
