//! The equations of one knot that is to go: one of them is left out, and what it lacks is the change.

use crate::coeff::Coeff;
use crate::ops::bound::{epsilon, largest, size};
use crate::ops::unblend::{Parts, best_to_drop, lack, unblend, unblend_best};
use crate::ops::zone::Zone;
use crate::scalar::{Scalar, larger_size};

/// Which side of a knot keeps its coefficients where both cannot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Keep {
    /// The left one.
    Left,
    /// The right one.
    Right,
}

/// Which equation is left out.
pub(super) enum Choice {
    /// The one with the smallest error.
    Best,
    /// The one in the middle, and of two the one that leaves a side alone.
    Side(Keep),
    /// Of these the one with the smallest error.
    Among(Vec<usize>),
}

/// The equations of one knot, from the coefficient before the first that it blends to the one after the last.
pub(super) struct Trial<T, C> {
    pub(super) blends: Vec<Parts<T>>,
    /// The coefficients as they are, and solved.
    pub(super) before: Vec<C>,
    pub(super) after: Vec<C>,
}

/// What a removal does: the equation left out, counted from the first index, and the change.
pub(super) struct Change<T> {
    pub(super) first: isize,
    pub(super) dropped: usize,
    /// The bound of what the dropped equation lacks, on the support of its basis function.
    pub(super) main: T,
    /// The bound of what the others lack by rounding.
    pub(super) rest: T,
    /// Whether nothing changes.
    pub(super) none: bool,
}

impl<T: Scalar, C: Coeff<T>> Trial<T, C> {
    pub(super) fn empty() -> Self {
        Self { blends: Vec::new(), before: Vec::new(), after: Vec::new() }
    }

    /// Solves all equations but one, and returns which.
    pub(super) fn solve(&mut self, choice: &Choice) -> usize {
        let last = self.blends.len() - 1;
        let dropped = match choice {
            Choice::Best => return unblend_best(&self.blends, &mut self.after),
            Choice::Among(ks) if ks.len() == last + 1 => return unblend_best(&self.blends, &mut self.after),
            Choice::Among(ks) => {
                let best = best_to_drop(&self.blends);
                ks.iter().copied().min_by_key(|k| k.abs_diff(best)).expect("one to choose")
            }
            Choice::Side(Keep::Left) => last.div_ceil(2),
            Choice::Side(Keep::Right) => last / 2,
        };
        unblend(&self.blends, dropped, &mut self.after);
        dropped
    }

    /// Whether the change is within `zone` in the directions that the spline does not know of, but for rounding.
    pub(super) fn is_within(&self, change: &Change<T>, zone: &Zone<'_, T, C>) -> bool {
        let dropped = change.dropped;
        let beyond = |i: usize| (zone.beyond)(&self.lack(dropped, i));
        let jump = self.blends.len() == 2;
        let size = if jump { larger_size(beyond(0), beyond(1)) } else { beyond(dropped) };
        if T::EXACT {
            return size.is_zero();
        }
        let share = T::int(16 * self.blends.len() as i64) * epsilon::<T>();
        size <= share * larger_size(largest(&self.before), largest(&self.after))
    }

    fn lack(&self, dropped: usize, i: usize) -> C {
        lack(&self.blends, dropped, i, &self.before[i], &self.after)
    }

    /// What changes if equation `dropped` is left out, but for rounding.
    pub(super) fn change(&self, first: isize, dropped: usize) -> Change<T> {
        let lack = self.lack(dropped, dropped);
        let mut none = lack.vanishes();
        let mut main = if none { T::zero() } else { size(&lack) };
        if self.blends.len() == 2 {
            // A jump is shared out.
            let other = self.lack(dropped, 1 - dropped);
            none &= other.vanishes();
            main = larger_size(main, size(&other));
        }
        Change { first, dropped, main, rest: T::zero(), none }
    }

    /// Adds what the other equations lack, checked with their own rounding.
    pub(super) fn add_rounding(&mut self, change: &mut Change<T>) {
        if T::EXACT {
            return;
        }
        let (dropped, n) = (change.dropped, self.blends.len() - 1);
        for i in (1..n).filter(|&i| i != dropped) {
            self.before[i] = self.lack(dropped, i);
            change.none &= self.before[i].vanishes();
        }
        // What the dropped equation lacks counts apart, and its coefficient does no harm in the other list.
        self.before[dropped] = self.before[dropped].zero_like();
        let (lacks, solved) = (largest(&self.before[1..n.max(1)]), largest(&self.after));
        change.rest = lacks + solved * T::int(8) * epsilon::<T>();
    }
}
