//! Nodes: where the influence of a coefficient is near its largest.

use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::ops::bound::epsilon;
use crate::scalar::{Scalar, larger};
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

    /// The knot whose insertion makes `x` a node, `p x - (t_{k+2} + ... + t_{k+p})` with `k` from
    /// [`node_before`](Self::node_before); node `k + 1` is then `x`. None if `x` is a node already, in floating point but for rounding [NURBS, (11.6)].
    ///
    /// A point that is moved by the coefficient of its node moves farthest of all, nearly, and the curve to both sides
    /// alike. In a periodic space the knot is in the domain.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`ShapeError::NoNodeBefore`], [`Error::DegreeTooLow`] for degree zero;
    /// [`ShapeError::KnotThere`] if that is a knot already, in floating point but for rounding: one more copy would let
    /// the curve lose a derivative, as [NURBS, Figure 11.5] shows; [`Error::TooFewKnots`] for a ring of fewer than `p`
    /// coefficients.
    ///
    /// # Examples
    /// ```
    /// use symspline::{ShapeError, SplineSpace};
    /// let space = SplineSpace::clamped(3, [0.0, 1.0, 2.0, 3.0, 4.0])?;
    /// assert_eq!(space.node_placing_knot(&1.5)?, Some(1.5));
    /// assert_eq!(space.refined(&[1.5])?.node(3)?, 1.5);
    /// let parabolas = SplineSpace::clamped(2, [0.0, 0.25, 0.5, 0.75, 1.0])?;
    /// let refused = ShapeError::KnotThere { knot: "0.5".into() };
    /// assert_eq!(parabolas.node_placing_knot(&0.5).unwrap_err(), refused.into());
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn node_placing_knot(&self, x: &T) -> Result<Option<T>> {
        let (p, t) = (self.degree(), self.knots());
        if p == 0 {
            return Err(Error::DegreeTooLow { degree: 0, needed: 1 });
        }
        let k = self.node_before(x)?;
        if self.mean_of_knots(k) == *x {
            return Ok(None);
        }
        // From x, so that no sum overflows.
        let knot = t[k + 2..=k + p].iter().fold(x.clone(), |knot, t| knot + (x.clone() - t));
        match self.placed(knot)? {
            // A node but for rounding: of k, or of the one after.
            (knot, true) if !T::EXACT && (knot == t[k + 1] || knot == t[k + p + 1]) => Ok(None),
            (knot, true) => Err(ShapeError::KnotThere { knot: knot.to_string() }.into()),
            (knot, false) => Ok(Some(knot)),
        }
    }

    /// Node `i`, in a ring brought into the domain; of an unclamped space not beyond its ends.
    pub(crate) fn node_inside(&self, i: usize) -> T {
        let ((a, b), mut node) = (self.domain(), self.mean_of_knots(i));
        // More than once in rings of less than p coefficients.
        while self.is_periodic() && node < *a {
            node += self.length();
        }
        while self.is_periodic() && node > *b {
            node -= self.length();
        }
        let node = larger(node, a.clone());
        if node > *b { b.clone() } else { node }
    }

    /// The coefficient whose node is nearest to `x`, wherever it has influence; its place in the list.
    pub(crate) fn coeff_at_node(&self, x: &T) -> usize {
        let (mut low, mut high) = (0, self.unrolled_dim() - 1);
        let (a, b) = self.domain();
        let round = b.clone() - a;
        let x = match self.is_periodic() {
            true if x < a => x.clone() + round,
            true if x >= b => x.clone() - round,
            _ => x.clone(),
        };
        // Nodes do not decrease.
        while low + 1 < high {
            let middle = low.midpoint(high);
            *(if self.mean_of_knots(middle) <= x { &mut low } else { &mut high }) = middle;
        }
        let distance = |i: usize| (self.mean_of_knots(i) - &x).magnitude();
        self.slot(if distance(high) < distance(low) { high } else { low })
    }

    /// A value, in a periodic space brought into the domain, and whether it is a knot; in floating point one that is so but
    /// for rounding is taken for it. Refuses rings so small that each knot counts twice for a coefficient.
    pub(crate) fn placed(&self, value: T) -> Result<(T, bool)> {
        if self.is_periodic() && self.dim() < self.degree() {
            return Err(Error::TooFewKnots { expected: self.degree(), found: self.dim() });
        }
        let (a, b) = self.domain();
        let period = b.clone() - a;
        let value = match self.is_periodic() {
            true if value < *a => value + period,
            true if value >= *b => value - period,
            _ => value,
        };
        let t = self.knots();
        let noise = if T::EXACT {
            T::zero()
        } else {
            let size = larger(a.magnitude(), b.magnitude());
            size * epsilon::<T>() * T::int(self.degree() as i64 + 2)
        };
        let near = |i: &usize| *i < t.len() && (t[*i].clone() - &value).magnitude() <= noise;
        let place = t.partition_point(|knot| *knot < value);
        let there = [place.wrapping_sub(1), place].into_iter().find(near);
        Ok(there.map_or((value, false), |i| (t[i].clone(), true)))
    }

    /// Where coefficient `i` of the unrolled space has influence: from `t_i` to `t_{i+p+1}`.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`].
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// assert_eq!(SplineSpace::clamped(2, [0.0, 1.0, 3.0])?.support(1)?, (&0.0, &3.0));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn support(&self, i: usize) -> Result<(&T, &T)> {
        let length = self.unrolled_dim();
        if i >= length {
            return Err(Error::IndexOutOfRange { index: i, length });
        }
        Ok((&self.knots()[i], &self.knots()[i + self.degree() + 1]))
    }
}
