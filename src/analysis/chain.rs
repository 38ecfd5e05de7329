//! Where a sign changes along a curve: chains of signs.
//!
//! The signs of the slope of the curvature and its jumps at knots are one chain of rises and falls. Where a rise is
//! followed by a fall there is a maximum, whatever constant stretches lie between. Where the curve stands still or has
//! a corner the chain is cut. The signs of the curvature itself are a chain too, and its changes are the inflections.

use crate::analysis::certify::Course;
use crate::analysis::zeros::Place;
use crate::roots::RootValue;
use std::cmp::Ordering;

/// What is at a mark of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    /// The sign may change.
    Turn,
    /// There is a step with this sign.
    Step(Ordering),
    /// The chain is cut.
    Cut,
}

/// A mark with the sign after it; there is none beyond the end.
#[derive(Clone, Debug)]
pub(crate) struct Marked<T> {
    pub value: RootValue<T>,
    pub after: Option<Ordering>,
    pub mark: Mark,
}

/// The marks of a function from its courses between `ends`: at every end, with what `at_end` says is there, and at
/// every zero between, where `is_cut` says whether the chain is cut. On a ring the last end is the first.
pub(crate) fn marks<T: Clone>(
    ends: &[T],
    courses: &[Course<T>],
    closed: bool,
    at_end: impl Fn(usize) -> Mark,
    is_cut: impl Fn(usize, &RootValue<T>) -> bool,
) -> Vec<Marked<T>> {
    let mut marks = Vec::new();
    let at_knots = ends.iter().zip(courses.iter().map(Some).chain([None])).enumerate();
    for (i, (end, course)) in at_knots.take(courses.len() + usize::from(!closed)) {
        let value = RootValue::Exact(end.clone());
        let after = course.map(|course| course.signs[0]);
        marks.push(Marked { value, after, mark: at_end(i) });
        let Some(course) = course else { break };
        let mut sign = course.signs[0];
        marks.extend(course.inside.iter().map(|(value, multiplicity)| {
            sign = if multiplicity % 2 == 1 { sign.reverse() } else { sign };
            let mark = if is_cut(i, value) { Mark::Cut } else { Mark::Turn };
            Marked { value: value.clone(), after: Some(sign), mark }
        }));
    }
    marks
}

/// A change of sign: to which sign, and where.
pub(crate) struct Change<T> {
    pub to: Ordering,
    pub place: Place<T>,
}

/// The changes of sign in the chain with these marks; zero stretches between two signs belong to the place of the
/// change.
pub(crate) fn changes<T: Clone + PartialEq>(marks: &[Marked<T>], closed: bool) -> Vec<Change<T>> {
    let mut chain = Chain { last: None, found: Vec::new() };
    if closed {
        // Once round for what is before the seam.
        chain.walk(marks, closed);
        chain.found.clear();
    }
    chain.walk(marks, closed);
    chain.found
}

/// A chain as it is walked.
struct Chain<T> {
    /// The last sign but zero, and where it ended.
    last: Option<(Ordering, RootValue<T>)>,
    found: Vec<Change<T>>,
}

impl<T: Clone + PartialEq> Chain<T> {
    fn walk(&mut self, marks: &[Marked<T>], closed: bool) {
        for (i, marked) in marks.iter().enumerate() {
            match marked.mark {
                Mark::Turn => {}
                Mark::Step(sign) => self.step(sign, &marked.value, &marked.value),
                Mark::Cut => self.last = None,
            }
            let next = marks.get(i + 1).or(marks.first().filter(|_| closed));
            if let (Some(sign), Some(next)) = (marked.after, next) {
                self.step(sign, &marked.value, &next.value);
            }
        }
    }

    /// Goes on with a sign from `start` to `end`.
    fn step(&mut self, sign: Ordering, start: &RootValue<T>, end: &RootValue<T>) {
        if sign == Ordering::Equal {
            return;
        }
        if let Some((last, place)) = &self.last
            && *last != sign
        {
            self.found.push(Change { to: sign, place: between(place, start) });
        }
        self.last = Some((sign, end.clone()));
    }
}

/// From where one sign ended to where the next starts.
fn between<T: Clone + PartialEq>(end: &RootValue<T>, start: &RootValue<T>) -> Place<T> {
    if end == start {
        return Place::At(end.clone());
    }
    Place::Along(end.bounds().0.clone(), start.bounds().1.clone())
}
