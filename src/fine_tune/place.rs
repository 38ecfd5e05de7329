//! A portion put in the place of what a spline was there, knots and coefficients.

use crate::error::Result;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use std::iter::repeat_n;
use std::ops::Range;

/// The smallest space that holds the splines of `space` with a portion from the clamped space `portion` in place, where
/// derivatives up to `orders` agree at its ends.
pub(crate) fn room_for<T: Scalar>(
    space: &SplineSpace<T>,
    portion: &SplineSpace<T>,
    orders: [usize; 2],
) -> Result<SplineSpace<T>> {
    let (p, (a, b), (start, end)) = (portion.degree(), portion.domain(), space.domain());
    let raised = clamped_beside(space.elevated(p - space.degree())?, (a, b))?;
    let (present, ring) = (raised.breaks(), raised.is_periodic());
    // A portion from the seam of a ring to the seam has both its ends there.
    let orders = if ring && a == start && b == end { [orders[0].min(orders[1]); 2] } else { orders };
    let mut added = Vec::new();
    for (t, count) in portion.breaks() {
        let held = if t == *a { Some(orders[0]) } else { (t == *b).then_some(orders[1]) };
        // The seam of a ring is known by its start.
        let (t, again) = if ring && t == *end { (start, a == start) } else { (&t, false) };
        let wanted = held.map_or(count, |order| p.saturating_sub(order));
        if !again {
            added.extend(repeat_n(t.clone(), wanted.saturating_sub(copies(&present, t))));
        }
    }
    raised.refined(&added)
}

/// The space with clamped ends where those of an open domain are also ends of a portion.
pub(crate) fn clamped_beside<T: Scalar>(space: SplineSpace<T>, (a, b): (&T, &T)) -> Result<SplineSpace<T>> {
    let (p, (start, end)) = (space.degree(), space.domain());
    if space.is_periodic() || (a != start && b != end) {
        return Ok(space);
    }
    let t = space.knots();
    let outer = |clamped: bool, x: &T, knots: &[T]| if clamped { vec![x.clone(); p] } else { knots.to_vec() };
    let before = outer(a == start, a, &t[..p]);
    let after = outer(b == end, b, &t[t.len() - p..]);
    space.with_outer_knots(&before, &after)
}

/// How many copies of `t` there are among `breaks`.
pub(crate) fn copies<T: Scalar>(breaks: &[(T, usize)], t: &T) -> usize {
    let place = breaks.partition_point(|(s, _)| s < t);
    breaks.get(place).filter(|(s, _)| s == t).map_or(0, |(_, copies)| *copies)
}

/// The basis functions of a portion that have all their knots in a whole space too.
#[derive(Clone, Debug)]
pub(crate) struct Inside {
    /// The index in the whole space of the first.
    pub first: usize,
    /// The indices in the portion.
    pub inner: Range<usize>,
}

impl Inside {
    /// Those of the clamped space `portion` in `space`, of one degree.
    pub(crate) fn of<T: Scalar>(space: &SplineSpace<T>, portion: &SplineSpace<T>) -> Self {
        let (p, (a, b), breaks) = (portion.degree(), portion.domain(), space.breaks());
        let lacking = |t: &T| (p + 1).saturating_sub(copies(&breaks, t));
        Self {
            first: space.knots().partition_point(|t| t < a),
            inner: lacking(a)..portion.dim().saturating_sub(lacking(b)),
        }
    }

    /// The same without those of the portion that are not among `which`.
    pub(crate) fn among(self, which: &Range<usize>) -> Self {
        let start = self.inner.start.max(which.start);
        let first = self.first + start - self.inner.start;
        Self { first, inner: start..self.inner.end.min(which.end) }
    }

    /// Copies these coefficients of the portion to the whole.
    pub(crate) fn copy<C: Clone>(self, portion: &[C], whole: &mut [C]) {
        // None in degree 0, where nothing can be tuned.
        let inner = portion.get(self.inner).unwrap_or_default();
        // In a ring too: these do not go over the seam, so that no index wraps.
        whole.iter_mut().skip(self.first).zip(inner).for_each(|(c, tuned)| c.clone_from(tuned));
    }
}
