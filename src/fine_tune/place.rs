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
    let mut raised = space.elevated(p - space.degree())?;
    if !raised.is_periodic() && (a == start || b == end) {
        let t = raised.knots();
        let outer = |clamped: bool, x: &T, knots: &[T]| {
            if clamped { vec![x.clone(); p] } else { knots.to_vec() }
        };
        let before = outer(a == start, a, &t[..p]);
        let after = outer(b == end, b, &t[t.len() - p..]);
        raised = raised.with_outer_knots(&before, &after)?;
    }
    let (present, ring) = (raised.breaks(), raised.is_periodic());
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

/// How many copies of `t` there are among `breaks`.
fn copies<T: Scalar>(breaks: &[(T, usize)], t: &T) -> usize {
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
}
