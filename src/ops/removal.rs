//! Removing knots one after the other, from left to right, each in a time that depends on the degree only.
//!
//! The last copy `t_r` of a knot `u` with `s` copies blends the coefficients `c_i`, `r - p <= i <= r - s`, with
//! `α_i = (u - t_i) / (t_{i+p+1} - t_i)`, and leaves `c_{r-p-1}` and `c_{r-s+1}` alone; going back is
//! [unblending](crate::ops::unblend) ([NURBS, (5.28)] writes down the same equations). What one equation lacks bounds the
//! change, on the support of one basis function; over inexact fields what the others lack by rounding is added. Every span
//! carries the sum of the bounds of the changes that reached it, so that the largest of them bounds the distance from the
//! spline at the start.
//!
//! Knots, coefficients and bounds stand in lists with one gap. What is in front of the gap has been looked at, and
//! what is removed widens it. A ring is numbered from the first copy of its seam, and indices wrap.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::knots::KnotVector;
use crate::ops::bound::{finite, sum_above};
use crate::ops::trial::{Change, Choice, Keep, Trial};
use crate::ops::zone::Zone;
use crate::scalar::{Scalar, larger_size};
use crate::space::SplineSpace;
use crate::spline::Spline;
use std::ops::Range;

/// Which changes are fine.
#[derive(Clone, Debug)]
pub(crate) enum Limit<T> {
    /// None at all, as far as the arithmetic of the field can tell.
    Exact,
    /// Those that keep the sum of bounds at or below a tolerance.
    Within(T),
    /// All.
    Forced,
}

/// A spline that loses knots from left to right.
pub(crate) struct Removal<T, C> {
    degree: usize,
    /// End of the domain and period of a ring.
    ring: Option<(T, T)>,
    knots: Vec<T>,
    coeffs: Vec<C>,
    /// What is known of the change on the span after each knot.
    bounds: Vec<T>,
    /// Whether a knot, by its last copy, was tried before.
    tried: Vec<bool>,
    /// The number of entries in front of the gap.
    head: usize,
    gap: usize,
    /// One removal on trial.
    trial: Trial<T, C>,
}

impl<T: Scalar, C: Coeff<T>> Removal<T, C> {
    pub(crate) fn new(f: &Spline<T, C>) -> Self {
        let (space, p) = (f.space(), f.degree());
        let (mut knots, mut coeffs, mut ring) = (space.knots().to_vec(), f.coeffs().to_vec(), None);
        if space.is_periodic() {
            knots = space.round_knots().to_vec();
            coeffs.rotate_left((p + 1 - copies(&knots)) % knots.len());
            ring = Some((space.domain().1.clone(), space.length()));
        }
        let (bounds, tried) = (vec![T::zero(); knots.len()], vec![false; knots.len()]);
        let head = if ring.is_some() { 0 } else { p + 1 };
        Self { degree: p, ring, knots, coeffs, bounds, tried, head, gap: 0, trial: Trial::empty() }
    }

    /// The number of knots, of a ring in one period.
    fn count(&self) -> usize {
        self.knots.len() - self.gap
    }

    /// Whether the windows of the equations of a ring would overlap themselves.
    pub(crate) fn is_tight(&self) -> bool {
        self.ring.is_some() && self.count() < self.degree + 2
    }

    /// The place of entry `j` in the lists.
    #[inline]
    fn place(&self, j: isize) -> usize {
        let j = match usize::try_from(j) {
            Ok(j) if j < self.count() => j,
            _ => j.rem_euclid(self.count() as isize) as usize,
        };
        if j < self.head { j } else { j + self.gap }
    }

    #[inline]
    fn knot(&self, j: isize) -> T {
        let knot = &self.knots[self.place(j)];
        match &self.ring {
            Some((_, period)) if !(0..self.count() as isize).contains(&j) => {
                knot.clone() + period.clone() * T::int(j.div_euclid(self.count() as isize) as i64)
            }
            _ => knot.clone(),
        }
    }

    /// Moves on to the next knot inside: its value and number of copies.
    pub(crate) fn advance(&mut self) -> Option<(T, usize)> {
        let rest = &self.knots[self.head + self.gap..];
        let u = rest
            .first()
            .filter(|u| self.ring.is_some() || *u < &self.knots[self.knots.len() - 1 - self.degree])?
            .clone();
        let copies = copies(rest);
        for _ in 0..copies {
            let (to, from) = (self.head, self.head + self.gap);
            if to < from {
                self.knots.swap(to, from);
                self.coeffs.swap(to, from);
                self.bounds.swap(to, from);
                self.tried.swap(to, from);
            }
            self.head += 1;
        }
        Some((u, copies))
    }

    /// Whether the knot before the gap was tried before.
    pub(crate) fn tried(&self) -> bool {
        self.tried[self.head - 1]
    }

    /// Removes up to `times` of the `copies` copies of the knot before the gap; returns how many it removed. What changes
    /// is in `zone`.
    pub(crate) fn remove(
        &mut self,
        copies: usize,
        times: usize,
        limit: &Limit<T>,
        zone: Option<&Zone<'_, T, C>>,
    ) -> usize {
        // The seam marks the ends of the domain.
        let seam = self.ring.is_some() && self.head == copies;
        let most = times.min(if seam { copies - 1 } else { copies });
        let fits = |this: &mut Self, gone: usize| {
            if this.is_tight() {
                return false;
            }
            let choice = zone.map_or(Choice::Best, |zone| Choice::Among(this.local(copies - gone, zone)));
            // Where no equation is left to the zone, all must hold.
            let (choice, all) = match choice {
                Choice::Among(equations) if equations.is_empty() => (Choice::Best, true),
                choice => (choice, false),
            };
            if all && !T::EXACT {
                return false;
            }
            let mut change = this.try_last(copies - gone, &choice);
            if (all && !change.none) || zone.is_some_and(|zone| !this.trial.is_within(&change, zone)) {
                return false;
            }
            if matches!(limit, Limit::Within(tolerance) if change.main > *tolerance) {
                return false;
            }
            this.trial.add_rounding(&mut change);
            let fine = this.allows(&change, limit);
            if fine {
                this.accept(&change);
            }
            fine
        };
        let gone = (0..most).find(|&gone| !fits(self, gone)).unwrap_or(most);
        if gone < copies {
            self.tried[self.head - 1] = true;
        }
        gone
    }

    /// Removes one of the `copies` copies of the knot before the gap in any case, keeping one side as it is; returns the
    /// interval where the spline changes.
    pub(crate) fn drop_one(&mut self, copies: usize, keep: Keep) -> (T, T) {
        let mut change = self.try_last(copies, &Choice::Side(keep));
        self.trial.add_rounding(&mut change);
        let i = change.first + change.dropped as isize;
        let changed = (self.knot(i), self.knot(i + self.degree as isize + 1));
        self.accept(&change);
        changed
    }

    /// The equations of the last of `copies` copies of the knot before the gap that may be left out: those of basis
    /// functions with supports in `zone`.
    fn local(&self, copies: usize, zone: &Zone<'_, T, C>) -> Vec<usize> {
        let (p, first) = (self.degree as isize, self.head as isize - self.degree as isize - 2);
        let period = self.ring.as_ref().map(|(_, period)| period);
        let all = if copies > self.degree { 0..2 } else { 1..self.degree + 2 - copies };
        let is_local = |k: &usize| {
            let i = first + *k as isize;
            zone.holds((&self.knot(i), &self.knot(i + p + 1)), period)
        };
        all.filter(is_local).collect()
    }

    /// Sets up and solves the equations of the last of `copies` copies of the knot before the gap.
    fn try_last(&mut self, copies: usize, choice: &Choice) -> Change<T> {
        let (p, r, s) = (self.degree as isize, self.head as isize - 1, copies as isize);
        let first = r - p - 1;
        let mut trial = std::mem::replace(&mut self.trial, Trial::empty());
        let u = self.knots[self.head - 1].clone();
        trial.blends.clear();
        trial.blends.push((T::one(), T::zero()));
        let blend = |from: &T, to: &T| {
            let (left, right) = (u.clone() - from, to.clone() - &u);
            let share = T::one() / (left.clone() + &right);
            (left * &share, right * share)
        };
        if self.ring.is_none() {
            // The supports begin in front of the gap and end behind it.
            let front = &self.knots[self.head - 1 - self.degree..self.head - copies];
            let supports = front.iter().zip(&self.knots[self.head + self.gap..]);
            trial.blends.extend(supports.map(|(from, to)| blend(from, to)));
        } else {
            trial.blends.extend((first + 1..=r - s).map(|i| blend(&self.knot(i), &self.knot(i + p + 1))));
        }
        trial.blends.push((T::zero(), T::one()));
        trial.before.clear();
        match usize::try_from(first) {
            Ok(first) => trial.before.extend_from_slice(&self.coeffs[first..=self.head - copies]),
            Err(_) => trial.before.extend((first..=r - s + 1).map(|i| self.coeffs[self.place(i)].clone())),
        }
        trial.after.clone_from(&trial.before);
        let dropped = trial.solve(choice);
        let change = trial.change(first, dropped);
        self.trial = trial;
        change
    }

    /// The spans whose bounds a change adds to: those of the dropped equation, and all.
    fn touched(&self, change: &Change<T>) -> [Range<isize>; 2] {
        let p = self.degree as isize;
        let (first, end) = (change.first, change.first + self.trial.blends.len() as isize + p);
        let main = change.first + change.dropped as isize;
        // A jump changes the spans on both sides.
        let main = if end - first == p + 2 { first..end } else { main..main + p + 1 };
        let count = self.count() as isize;
        let all = match &self.ring {
            _ if T::EXACT => main.clone(),
            // Once round, so that no span counts twice.
            Some(_) if end - first > count => main.start..main.start + count,
            _ => first..end,
        };
        let inside = if self.ring.is_some() { isize::MIN..isize::MAX } else { p..count - p - 1 };
        [main, all].map(|spans| spans.start.max(inside.start)..spans.end.min(inside.end))
    }

    fn allows(&self, change: &Change<T>, limit: &Limit<T>) -> bool {
        match limit {
            Limit::Forced => true,
            Limit::Exact => change.none,
            Limit::Within(tolerance) => {
                let both = sum_above(change.main.clone(), &change.rest);
                let [main, mut all] = self.touched(change);
                all.all(|j| {
                    let added = if main.contains(&j) { &both } else { &change.rest };
                    sum_above(self.bounds[self.place(j)].clone(), added) <= *tolerance
                })
            }
        }
    }

    /// Puts the solved coefficients in place and takes out the knot.
    fn accept(&mut self, change: &Change<T>) {
        if !(change.main.is_zero() && change.rest.is_zero()) {
            let both = sum_above(change.main.clone(), &change.rest);
            let [main, all] = self.touched(change);
            for j in all {
                let place = self.place(j);
                let added = if main.contains(&j) { &both } else { &change.rest };
                self.bounds[place] = sum_above(self.bounds[place].clone(), added);
            }
        }
        let r = self.head - 1;
        if let Ok(first) = usize::try_from(change.first) {
            let solved = &mut self.trial.after;
            self.coeffs[first..first + solved.len()].swap_with_slice(solved);
            self.coeffs[first + change.dropped..=r].rotate_left(1);
        } else {
            for k in 0..self.trial.after.len() {
                let place = self.place(change.first + k as isize);
                std::mem::swap(&mut self.coeffs[place], &mut self.trial.after[k]);
            }
            for i in change.first + change.dropped as isize..r as isize {
                let (to, from) = (self.place(i), self.place(i + 1));
                self.coeffs.swap(to, from);
            }
        }
        // The spans on both sides of the knot become one.
        let before = self.place(r as isize - 1);
        let merged = larger_size(self.bounds[before].clone(), self.bounds[r].clone());
        self.bounds[before] = merged;
        self.head -= 1;
        self.gap += 1;
    }

    /// Back to the first knot, with the gap closed.
    pub(crate) fn rewind(&mut self) {
        let gone = self.head..self.head + self.gap;
        self.knots.drain(gone.clone());
        self.bounds.drain(gone.clone());
        self.tried.drain(gone.clone());
        self.coeffs.drain(gone);
        self.head = if self.ring.is_some() { 0 } else { self.degree + 1 };
        self.gap = 0;
    }

    /// What is left, and the largest bound.
    pub(crate) fn finish(mut self) -> Result<(Spline<T, C>, T)> {
        self.rewind();
        let bound = finite(self.bounds.into_iter().fold(T::zero(), larger_size))?;
        let space = match self.ring {
            None => SplineSpace::new(self.degree, self.knots)?,
            Some((end, _)) => {
                let shift = (self.degree + 1 - copies(&self.knots)) % self.knots.len();
                self.coeffs.rotate_right(shift);
                SplineSpace::joined(self.degree, &KnotVector::new(self.knots)?, end)?
            }
        };
        Ok((Spline::new(space, self.coeffs)?, bound))
    }
}

/// The number of copies of the first knot.
fn copies<T: Scalar>(knots: &[T]) -> usize {
    knots.iter().take_while(|t| **t == knots[0]).count()
}
