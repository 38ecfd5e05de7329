//! The part of a shape that a tool works on: more knots there first, then the control points that have influence nowhere
//! else.

use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::limits::{MAX_DIM, check_dim};
use crate::ops::trial::Keep;
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::space::SplineSpace;
use crate::tensor::along::Direction;
use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::ops::Range;

/// How many knots an interval gets: the middle of its longest span again and again, the first of several [NURBS,
/// section 11.4].
///
/// The ends of the interval become knots in any case.
///
/// # Examples
/// ```
/// use symspline::{Refinement, SplineSpace};
/// let space = SplineSpace::clamped(3, [0.0, 1.0, 2.0, 4.0])?;
/// assert_eq!(Refinement::Count(3).knots(&space, &0.5, &4.0)?, [0.5, 1.5, 2.5, 3.0]);
/// assert_eq!(Refinement::Spacing(1.0).knots(&space, &1.0, &4.0)?, [3.0]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Refinement<T> {
    /// This many knots besides the ends of the interval.
    Count(usize),
    /// As many as it takes that no span of the interval is longer.
    Spacing(T),
}

/// A span of an interval; longer ones are greater, of equal ones the first.
struct Stretch<T> {
    start: T,
    end: T,
    length: T,
}

impl<T: Scalar> Stretch<T> {
    fn new(start: T, end: T) -> Self {
        let length = end.clone() - &start;
        Self { start, end, length }
    }

    /// The two halves; none if there is no number between the ends.
    fn halves(self) -> Option<(Self, T, Self)> {
        let middle = self.start.clone() + self.length / T::int(2);
        let between = self.start < middle && middle < self.end;
        between.then(|| (Self::new(self.start, middle.clone()), middle.clone(), Self::new(middle, self.end)))
    }
}

impl<T: Scalar> Ord for Stretch<T> {
    fn cmp(&self, other: &Self) -> Ordering {
        let by_length = self.length.partial_cmp(&other.length);
        let by_place = other.start.partial_cmp(&self.start);
        by_length.unwrap_or(Ordering::Equal).then(by_place.unwrap_or(Ordering::Equal))
    }
}

impl<T: Scalar> PartialOrd for Stretch<T> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<T: Scalar> PartialEq for Stretch<T> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<T: Scalar> Eq for Stretch<T> {}

impl<T: Scalar> Refinement<T> {
    /// The knots to insert between `start` and `end`, ascending.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::EmptyDomain`] unless `start < end`; [`Error::TooLarge`];
    /// [`Error::BadTolerance`] for a spacing that is not positive; [`Error::SpanOutOfRange`] if no number is left between
    /// two knots.
    pub fn knots(&self, space: &SplineSpace<T>, start: &T, end: &T) -> Result<Vec<T>> {
        if start >= end {
            return Err(Error::EmptyDomain { start: start.to_string(), end: end.to_string() });
        }
        space.locate(start)?;
        let last = space.locate_left(end)?;
        let mut breaks: Vec<T> = space.breaks().into_iter().map(|(t, _)| t).collect();
        breaks.retain(|t| start < t && t < end);
        let inner = breaks.len();
        breaks.insert(0, start.clone());
        breaks.push(end.clone());
        let has =
            |t: &T| space.knots().binary_search_by(|k| k.partial_cmp(t).unwrap_or(Ordering::Equal)).is_ok();
        let mut new: Vec<T> = [start, end].into_iter().filter(|t| !has(t)).cloned().collect();
        let mut heap: BinaryHeap<Stretch<T>> =
            breaks.windows(2).map(|ends| Stretch::new(ends[0].clone(), ends[1].clone())).collect();
        let is_done = |added: usize, longest: &T| match self {
            Self::Count(count) => added == *count,
            Self::Spacing(spacing) => longest <= spacing,
        };
        match self {
            Self::Count(count) => check_dim(count.saturating_add(inner))?,
            Self::Spacing(spacing) if *spacing > T::zero() && spacing.is_finite() => {
                // There will be at least so many spans.
                if spacing.clone() * T::int(MAX_DIM as i64) < end.clone() - start {
                    return check_dim(usize::MAX).map(|()| Vec::new());
                }
            }
            Self::Spacing(spacing) => return Err(Error::BadTolerance { tolerance: spacing.to_string() }),
        }
        let mut added = 0;
        while let Some(longest) = heap.pop() {
            if is_done(added, &longest.length) {
                break;
            }
            check_dim(space.dim() + added)?;
            let (left, middle, right) = longest.halves().ok_or(Error::SpanOutOfRange { index: last })?;
            heap.extend([left, right]);
            new.push(middle);
            added += 1;
        }
        new.sort_by(|s, t| s.partial_cmp(t).unwrap_or(Ordering::Equal));
        Ok(new)
    }

    /// The same shape with these knots along `direction`.
    ///
    /// # Errors
    /// Those of [`knots`](Self::knots) and of the insertion.
    pub fn of<S: Controlled<T>>(&self, shape: &S, direction: Direction, start: &T, end: &T) -> Result<S> {
        let knots = self.knots(shape.space_along(direction), start, end)?;
        shape.inserted_along(direction, &knots)
    }
}

impl<T: Scalar> SplineSpace<T> {
    /// The coefficients without influence in the domain outside `[start, end]`, which are knots: `s ..= e - p - 1`, with `t_s`
    /// the first copy of `start` and `t_e` the last one of `end` [NURBS, (11.40)].
    ///
    /// What is beyond the ends of the domain does not count: where the interval ends with an unclamped space, so do the
    /// coefficients. In a periodic space they are unrolled indices; [`slot`](Self::slot) gives their places. There the seam
    /// lets nothing through, but the whole domain has all coefficients: those with their nodes in it.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`ShapeError::NoKnot`] if an end is none.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let space = SplineSpace::clamped(2, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0])?;
    /// assert_eq!(space.local_coeffs(&1.0, &5.0)?, 3..7);
    /// assert_eq!(space.local_coeffs(&1.0, &3.0)?, 3..3);
    /// let unclamped = SplineSpace::new(2, (0..9).map(f64::from))?;
    /// assert_eq!(unclamped.local_coeffs(&2.0, &4.0)?, 0..2);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn local_coeffs(&self, start: &T, end: &T) -> Result<Range<usize>> {
        self.locate(start)?;
        self.locate_left(end)?;
        let t = self.knots();
        let (first, past) = (t.partition_point(|k| k < start), t.partition_point(|k| k <= end));
        for (place, knot) in [(Some(first), start), (past.checked_sub(1), end)] {
            if place.and_then(|i| t.get(i)) != Some(knot) {
                return Err(ShapeError::NoKnot { value: knot.to_string() }.into());
            }
        }
        let (at_start, at_end) = (start == self.domain().0, end == self.domain().1);
        if self.is_periodic() && at_start && at_end {
            let first = (0..self.degree()).take_while(|i| self.mean_of_knots(*i) < *start).count();
            return Ok(first..first + self.dim());
        }
        let first = if at_start && !self.is_periodic() { 0 } else { first };
        let past = if at_end && !self.is_periodic() { t.len() } else { past };
        let end = past.saturating_sub(self.degree() + 1);
        Ok(first..end.max(first))
    }

    /// The knots inside the domain of which one copy can be removed so that the change stays in `[start, end]`, which are
    /// knots: a range of indices [NURBS, (11.41)].
    ///
    /// Removing a copy leaves out one of the equations of its insertion, the one in the middle, and of two in the middle
    /// the one that leaves the side `keep` alone, as [`Spline::without_knot`](crate::Spline::without_knot) does. The change
    /// is a multiple of one basis function `N_m`, and `m` must be one of the [`local_coeffs`](Self::local_coeffs). With `t_r`
    /// the last of the `s` copies of the knot
    ///
    /// ```text
    /// m = r - p - 1 + ⌈(p - s + 2) / 2⌉ keeping the left, ⌊ ⌋ keeping the right
    /// ```
    /// which for simple knots gives the ranges of the book. The indices are those of the unrolled knots, and all copies
    /// of a knot are in the range. It holds for one removal: afterwards there are fewer knots.
    ///
    /// # Errors
    /// As [`local_coeffs`](Self::local_coeffs).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Keep, SplineSpace};
    /// let space = SplineSpace::clamped(2, (0..9).map(f64::from))?;
    /// assert_eq!(space.removable_knots(&1.0, &7.0, Keep::Left)?, 4..8);
    /// assert_eq!(space.removable_knots(&1.0, &7.0, Keep::Right)?, 5..9);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn removable_knots(&self, start: &T, end: &T, keep: Keep) -> Result<Range<usize>> {
        let local = self.local_coeffs(start, end)?;
        let (t, p, (a, b)) = (self.knots(), self.degree(), self.domain());
        let all = local.len() == self.dim();
        let mut range: Option<Range<usize>> = None;
        let mut first = t.partition_point(|k| k <= a);
        while t[first] < *b {
            let copies = t[first..].iter().take_while(|k| **k == t[first]).count();
            // The equations blend the coefficients from `first + copies - 1 - p` to `first - 1`.
            let equations = p + 1 - copies;
            let dropped = match keep {
                Keep::Left => (equations + 1).div_ceil(2),
                Keep::Right => equations.div_ceil(2),
            };
            if all || local.contains(&(first + copies + dropped - p - 2)) {
                range = Some(range.map_or(first, |range| range.start)..first + copies);
            }
            first += copies;
        }
        Ok(range.unwrap_or(local.start..local.start))
    }
}
