//! Which span holds a parameter, without a search where spans are of similar length.
//!
//! The domain is cut into twice as many equal buckets as there are spans. A parameter lies right of every knot of the buckets
//! before its own and left of every knot of those after it, whatever is rounded, because the bucket never decreases with the
//! parameter. So only the knots in its bucket are compared, as many as there are at most in one: of evenly spread knots one,
//! and never more than a binary search takes.

use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use std::hint::select_unpredictable;

/// The spans of a space, numbered from zero, and a guide to them.
#[derive(Clone, Debug)]
pub(crate) struct SpanIndex<T> {
    /// The ends of the spans, one more than there are spans.
    breaks: Vec<T>,
    /// How many buckets one unit of the parameter takes.
    per_unit: T,
    /// The first span that may hold a parameter of each bucket.
    guide: Vec<u32>,
    /// The first step of the search in a bucket, a power of two.
    reach: usize,
}

impl<T: Scalar> SpanIndex<T> {
    /// The spans of the domain of `space`.
    pub(crate) fn new(space: &SplineSpace<T>) -> Self {
        let breaks = space.ends();
        let spans = breaks.len() - 1;
        let per_unit = T::int(2 * spans as i64) / (breaks[spans].clone() - &breaks[0]);
        let mut index = Self { breaks, per_unit, guide: Vec::new(), reach: 0 };
        let buckets: Vec<usize> = index.breaks.iter().map(|t| index.bucket(t, 2 * spans + 2)).collect();
        let most = buckets.chunk_by(usize::eq).map(<[usize]>::len).max().unwrap_or(0);
        // Steps of `reach`, half of it, ..., 1 pass up to `2 reach - 1` knots.
        index.reach = (most + 1).next_power_of_two() / 2;
        let mut left = 0;
        for bucket in 0..=buckets[spans] {
            while left < spans && buckets[left + 1] < bucket {
                left += 1;
            }
            index.guide.push(left as u32);
        }
        index
    }

    /// The ends of the spans.
    pub(crate) fn breaks(&self) -> &[T] {
        &self.breaks
    }

    fn bucket(&self, x: &T, last: usize) -> usize {
        x.bucket(&self.breaks[0], &self.per_unit).min(last)
    }

    /// The span `s` that holds `x` in `[breaks[s], breaks[s + 1])`; the last one also holds its end.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], also for NaN.
    #[inline(always)]
    pub(crate) fn locate(&self, x: &T) -> Result<usize> {
        match self.find(x) {
            Some(span) => Ok(span),
            None => Err(self.outside(x)),
        }
    }

    #[inline(always)]
    fn find(&self, x: &T) -> Option<usize> {
        let last = self.breaks.len() - 1;
        if !(self.breaks[0] <= *x && *x <= self.breaks[last]) {
            return None;
        }
        let mut span = self.guide[self.bucket(x, self.guide.len() - 1)] as usize;
        let mut step = self.reach;
        while step > 0 {
            let probe = (span + step).min(last);
            // Which side of a knot a parameter lies on is a coin toss: no branch.
            span = select_unpredictable(self.breaks[probe] <= *x, probe, span);
            step /= 2;
        }
        Some(span.min(last - 1))
    }

    /// Start and end of a span.
    #[inline]
    pub(crate) fn ends(&self, span: usize) -> (&T, &T) {
        (&self.breaks[span], &self.breaks[span + 1])
    }

    #[cold]
    #[inline(never)]
    fn outside(&self, x: &T) -> Error {
        let (start, end) = (&self.breaks[0], &self.breaks[self.breaks.len() - 1]);
        Error::OutsideDomain { parameter: x.to_string(), start: start.to_string(), end: end.to_string() }
    }
}
