//! The part of a spline that a removal of knots may change.

use crate::scalar::Scalar;

/// An interval, and for the coefficients of a surface what of them is outside in the other direction.
pub(crate) struct Zone<'a, T, C> {
    pub start: T,
    pub end: T,
    /// The size of the part of a change that is outside.
    pub beyond: &'a dyn Fn(&C) -> T,
}

impl<T: Scalar, C> Zone<'_, T, C> {
    /// Whether the interval from `a` to `b` is inside, in a ring with the given period at any turn.
    pub(crate) fn holds(&self, (a, b): (&T, &T), period: Option<&T>) -> bool {
        let inside = |shift: &T| self.start <= a.clone() + shift && b.clone() + shift <= self.end;
        match period {
            None => self.start <= *a && *b <= self.end,
            Some(period) => [T::zero(), period.clone(), -period.clone()].iter().any(inside),
        }
    }
}
