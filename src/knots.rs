//! Knot vectors: the non-decreasing sequences on which spline spaces stand.

use crate::error::{Error, Result};
use crate::scalar::Scalar;
use std::ops::Deref;
use std::sync::Arc;

/// A non-decreasing sequence of finite knots, shared by every space and spline that stands on it.
///
/// Knots are compared with `==`: two knots are the same knot or they are not. Data whose equal knots differ by
/// rounding passes once through [`snapped`](Self::snapped), the only tolerance below the fitting tools.
///
/// # Examples
/// ```
/// use symspline::KnotVector;
/// let knots = KnotVector::new([0.0, 0.0, 1.0, 2.0, 2.0])?;
/// assert_eq!(knots.multiplicities(), [(0.0, 2), (1.0, 1), (2.0, 2)]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct KnotVector<T>(Arc<[T]>);

impl<T: Scalar> KnotVector<T> {
    /// Checks that the knots are finite and in order.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::KnotsDecrease`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, KnotVector};
    /// assert_eq!(KnotVector::new([0.0, 2.0, 1.0]).unwrap_err(), Error::KnotsDecrease { index: 2 });
    /// assert!(matches!(KnotVector::new([0.0, f64::NAN]), Err(Error::NotFinite { what: "knot", index: 1 })));
    /// ```
    pub fn new(values: impl IntoIterator<Item = T>) -> Result<Self> {
        let values: Arc<[T]> = values.into_iter().collect();
        // Most often all is well: look at all of them without a branch first.
        let finite = values.iter().fold(true, |all, t| all & t.is_finite());
        let ordered = values.windows(2).fold(true, |all, pair| all & (pair[0] <= pair[1]));
        if finite && ordered {
            return Ok(Self(values));
        }
        match values.iter().position(|t| !t.is_finite()) {
            Some(index) => Err(Error::NotFinite { what: "knot", index }),
            None => {
                let before = values.windows(2).position(|pair| pair[1] < pair[0]);
                Err(Error::KnotsDecrease { index: before.expect("some knots are not in order") + 1 })
            }
        }
    }

    /// The knots as a slice.
    pub fn as_slice(&self) -> &[T] {
        &self.0
    }

    /// The distinct knots, each with the number of its copies.
    pub fn multiplicities(&self) -> Vec<(T, usize)> {
        self.chunk_by(T::eq).map(|copies| (copies[0].clone(), copies.len())).collect()
    }

    /// The first span whose length has no finite inverse.
    pub(crate) fn narrow_span(&self) -> Option<usize> {
        let narrow = |pair: &[T]| {
            let width = if pair[0] == pair[1] { T::one() } else { pair[1].clone() - &pair[0] };
            !(T::one() / width).is_finite()
        };
        // Most often there is none: look at all without a branch first.
        let any = self.windows(2).fold(false, |any, pair| any | narrow(pair));
        any.then(|| self.windows(2).position(narrow)).flatten()
    }

    /// The same knots with near ones made equal: a knot at most `tolerance` above the first of its cluster takes the
    /// value of that first one. So the last knots, and with them the end of a domain, may move down.
    ///
    /// `tolerance` is a parameter difference, in the unit of the knots.
    ///
    /// # Errors
    /// [`Error::BadTolerance`] unless `tolerance` is finite and not negative.
    ///
    /// # Examples
    /// ```
    /// use symspline::KnotVector;
    /// let knots = KnotVector::new([0.0, 0.3, 0.1 + 0.2, 1.0])?;
    /// assert_eq!(knots.multiplicities().len(), 4);
    /// assert_eq!(knots.snapped(&1e-12)?.multiplicities(), [(0.0, 1), (0.3, 2), (1.0, 1)]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn snapped(&self, tolerance: &T) -> Result<Self> {
        if !tolerance.is_finite() || *tolerance < T::zero() {
            return Err(Error::BadTolerance { tolerance: tolerance.to_string() });
        }
        let mut snapped: Vec<T> = Vec::with_capacity(self.len());
        for t in self.iter() {
            let kept = match snapped.last() {
                Some(first) if t.clone() - first <= *tolerance => first.clone(),
                _ => t.clone(),
            };
            snapped.push(kept);
        }
        Ok(Self(snapped.into()))
    }
}

impl<T> Deref for KnotVector<T> {
    type Target = [T];

    #[inline]
    fn deref(&self) -> &[T] {
        &self.0
    }
}
