//! The part of a spline that a removal of knots may change.

use crate::scalar::Scalar;
use crate::space::SplineSpace;

/// An interval, and for the coefficients of a surface what of them is outside in the other direction.
pub(crate) struct Zone<'a, T, C> {
    pub start: T,
    pub end: T,
    /// The size of the part of a change that is outside.
    pub beyond: &'a dyn Fn(&C) -> T,
}

impl<'a, T: Scalar, C> Zone<'a, T, C> {
    /// The interval from `start` to `end` of the domain, and what is beyond an end of the domain where it ends there; of a ring
    /// all, if it is the whole domain. A coefficient with its support inside has no influence elsewhere in the domain.
    pub(crate) fn of(space: &SplineSpace<T>, (start, end): (&T, &T), beyond: &'a dyn Fn(&C) -> T) -> Self {
        let (t, (a, b)) = (space.knots(), space.domain());
        let (at_start, at_end) = (start == a, end == b);
        let (mut start, mut end) = (start.clone(), end.clone());
        let open = !space.is_periodic();
        // A turn more in a ring, for indices of other turns.
        let further = if open { T::zero() } else { space.length() };
        if at_start && (open || at_end) {
            start = t[0].clone() - &further;
        }
        if at_end && (open || at_start) {
            end = t[t.len() - 1].clone() + further;
        }
        Self { start, end, beyond }
    }

    /// Whether the interval from `a` to `b` is inside, in a ring with the given period at any turn.
    pub(crate) fn holds(&self, (a, b): (&T, &T), period: Option<&T>) -> bool {
        let inside = |shift: &T| self.start <= a.clone() + shift && b.clone() + shift <= self.end;
        match period {
            None => self.start <= *a && *b <= self.end,
            Some(period) => [T::zero(), period.clone(), -period.clone()].iter().any(inside),
        }
    }
}
