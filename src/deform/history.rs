//! What was done to a shape, so that it can be undone.
//!
//! An edit that moved control points keeps the other state of these, and undoing it exchanges both: nothing is computed, so nothing
//! is rounded. An edit that inserted knots keeps the knots and the few control points that the finer shape does not have as they
//! were.

use crate::coeff::Coeff;
use crate::deform::restorable::Restorable;
use crate::error::Result;
use crate::knots::KnotVector;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::tensor::along::Direction;
use std::collections::VecDeque;

/// Edits that were done, and such as were undone.
#[derive(Clone, Debug)]
pub(crate) struct History<T: Scalar, S: Restorable<T>> {
    done: VecDeque<Edit<T, S>>,
    undone: Vec<Edit<T, S>>,
    limit: usize,
}

/// What it takes to go from a shape to the one before or after an edit.
#[derive(Clone, Debug)]
pub(crate) enum Edit<T: Scalar, S: Restorable<T>> {
    /// These control points were others.
    Points(Vec<(usize, S::Stored)>),
    /// Knots were inserted, along one direction after the other.
    Knots(Vec<Insertion<T, S>>),
    /// The shape was another.
    Shape(Box<S>),
}

/// Knots that were inserted along one direction.
#[derive(Clone, Debug)]
pub(crate) struct Insertion<T: Scalar, S: Restorable<T>> {
    direction: Direction,
    knots: Vec<T>,
    /// Lines of control points from this one on had the number of knots fewer before them.
    from: usize,
    /// The control points before, where the finer shape has others.
    lost: Vec<(usize, S::Stored)>,
}

impl<T: Scalar, S: Restorable<T>> History<T, S> {
    /// None yet, and not more than `limit` of them.
    pub(crate) fn new(limit: usize) -> Self {
        Self { done: VecDeque::new(), undone: Vec::new(), limit }
    }

    /// How many can be undone and done again.
    pub(crate) fn counts(&self) -> (usize, usize) {
        (self.done.len(), self.undone.len())
    }

    /// Forgets the oldest edits beyond `limit`.
    pub(crate) fn keep(&mut self, limit: usize) {
        self.limit = limit;
        self.done.drain(..self.done.len().saturating_sub(limit));
        self.undone.drain(..self.undone.len().saturating_sub(limit));
    }

    /// Adds an edit that was done; what was undone is forgotten.
    pub(crate) fn push(&mut self, edit: Edit<T, S>) {
        self.undone.clear();
        self.done.push_back(edit);
        self.keep(self.limit);
    }

    /// Goes back one edit, if there is one.
    pub(crate) fn undo(&mut self, shape: &mut S) -> bool {
        let Some(mut edit) = self.done.pop_back() else { return false };
        match &mut edit {
            Edit::Knots(insertions) => {
                let back = |fine: S, insertion: &Insertion<T, S>| insertion.undone(&fine);
                let coarse = insertions.iter().rev().try_fold(shape.clone(), back);
                *shape = coarse.expect("going back was tried when the knots went in");
            }
            other => other.exchange(shape),
        }
        self.undone.push(edit);
        true
    }

    /// Goes forward one edit, if there is one.
    pub(crate) fn redo(&mut self, shape: &mut S) -> bool {
        let Some(mut edit) = self.undone.pop() else { return false };
        match &mut edit {
            Edit::Knots(insertions) => {
                let insert = |coarse: S, insertion: &Insertion<T, S>| {
                    coarse.inserted_along(insertion.direction, &insertion.knots)
                };
                let fine = insertions.iter().try_fold(shape.clone(), insert);
                *shape = fine.expect("these knots were inserted into this shape before");
            }
            other => other.exchange(shape),
        }
        self.done.push_back(edit);
        true
    }
}

impl<T: Scalar, S: Restorable<T>> Edit<T, S> {
    /// The shape with knots inserted, and the edit that this is; none if there are no knots.
    ///
    /// # Errors
    /// Those of the insertion.
    pub(crate) fn inserting(shape: &S, knots: Vec<(Direction, Vec<T>)>) -> Result<Option<(S, Self)>> {
        let (mut finer, mut insertions) = (shape.clone(), Vec::new());
        for (direction, knots) in knots.into_iter().filter(|(_, knots)| !knots.is_empty()) {
            let next = finer.inserted_along(direction, &knots)?;
            insertions.push(Insertion::between(&finer, &next, direction, knots));
            finer = next;
        }
        if insertions.is_empty() {
            return Ok(None);
        }
        let edit = match insertions.into_iter().collect() {
            Some(insertions) => Self::Knots(insertions),
            None => Self::Shape(Box::new(shape.clone())),
        };
        Ok(Some((finer, edit)))
    }

    /// Puts the other state in the place of this one.
    fn exchange(&mut self, shape: &mut S) {
        match self {
            Self::Points(points) => {
                let now = points.iter().map(|(i, _)| (*i, shape.stored()[*i].clone())).collect();
                let other = std::mem::replace(points, now);
                shape.put(other).expect("these control points were there before");
            }
            Self::Shape(other) => std::mem::swap(&mut **other, shape),
            Self::Knots(_) => {}
        }
    }
}

impl<T: Scalar, S: Restorable<T>> Insertion<T, S> {
    /// What was inserted between two shapes, if it can be undone.
    fn between(coarse: &S, fine: &S, direction: Direction, knots: Vec<T>) -> Option<Self> {
        let space = coarse.space_along(direction);
        let from = space.locate(&knots[0]).ok()? + 1;
        let mut insertion = Self { direction, knots, from, lost: Vec::new() };
        let moved = coarse.stored().iter().enumerate();
        let kept = |i: usize, c| fine.stored().get(insertion.place(fine, i)).is_some_and(|d| is_same(c, d));
        let lost = moved.filter(|(i, c)| !kept(*i, *c));
        insertion.lost = lost.map(|(i, c)| (i, c.clone())).collect();
        let back = insertion.undone(fine)?;
        let same = |d: &Direction| back.space_along(*d) == coarse.space_along(*d);
        (back.stored() == coarse.stored() && S::DIRECTIONS.iter().all(same)).then_some(insertion)
    }

    /// Where the control point in place `flat` of the coarse shape is in the fine one, unless it is lost.
    fn place(&self, fine: &S, flat: usize) -> usize {
        let dim = fine.space_along(self.direction).dim();
        let inner =
            if S::DIRECTIONS.last() == Some(&self.direction) { 1 } else { fine.control_count() / dim };
        let coarse = dim - self.knots.len();
        let (line, rest) = (flat / inner, flat % inner);
        let (outer, line) = (line / coarse, line % coarse);
        let line = if line < self.from { line } else { line + self.knots.len() };
        (outer * dim + line) * inner + rest
    }

    /// The shape before, none if it cannot be made.
    fn undone(&self, fine: &S) -> Option<S> {
        let space = |direction: &Direction| {
            let space = fine.space_along(*direction);
            if *direction == self.direction { without(space, &self.knots) } else { Some(space.clone()) }
        };
        let spaces: Vec<SplineSpace<T>> = S::DIRECTIONS.iter().map(space).collect::<Option<_>>()?;
        let mut lost = self.lost.iter().peekable();
        let stored = |flat: usize| match lost.next_if(|(i, _)| *i == flat) {
            Some((_, stored)) => Some(stored.clone()),
            None => fine.stored().get(self.place(fine, flat)).cloned(),
        };
        let count = spaces.iter().map(SplineSpace::dim).product();
        S::rebuilt(&spaces, (0..count).map(stored).collect::<Option<_>>()?).ok()
    }
}

/// Whether two control points are the same, signs of zeros included.
fn is_same<T: Scalar, C: Coeff<T>>(c: &C, d: &C) -> bool {
    let is_negative_zero = |x: &T| !T::EXACT && x.is_zero() && T::one() / x < T::zero();
    c == d && c.components().zip(d.components()).all(|(x, y)| is_negative_zero(x) == is_negative_zero(y))
}

/// The space without one copy of each of `knots`, which are ascending.
fn without<T: Scalar>(space: &SplineSpace<T>, knots: &[T]) -> Option<SplineSpace<T>> {
    let own = if space.is_periodic() { space.round_knots() } else { space.knots() };
    let mut gone = knots.iter().peekable();
    let left = own.iter().filter(|t| gone.next_if(|knot| knot == t).is_none()).cloned();
    if !space.is_periodic() {
        return SplineSpace::new(space.degree(), left).ok();
    }
    let round = KnotVector::new(left).ok()?;
    SplineSpace::joined(space.degree(), &round, space.domain().1.clone()).ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;
    use crate::spline::Function;
    use crate::tensor::spline::TensorSpline;

    /// How many control points an insertion keeps.
    fn lost<S: Restorable<Q>>(shape: &S, direction: Direction, knots: &[i64]) -> usize {
        let knots = knots.iter().map(|k| Q::frac(*k, 2)).collect();
        match Edit::inserting(shape, vec![(direction, knots)]).unwrap() {
            Some((_, Edit::Knots(insertions))) => insertions.iter().map(|i| i.lost.len()).sum(),
            other => panic!("not kept as knots: {other:?}"),
        }
    }

    fn numbers(count: i64) -> Vec<Q> {
        (0..count).map(|i| Q::int(i * i % 17)).collect()
    }

    #[test]
    fn inserted_knots_are_kept_with_few_control_points() {
        let curve =
            Function::new(SplineSpace::uniform(3, 40, Q::int(0), Q::int(40)).unwrap(), numbers(43)).unwrap();
        assert!(lost(&curve, Direction::U, &[41, 43]) <= 4);
        assert!(lost(&curve, Direction::U, &[2, 2]) <= 4);
        let ring =
            Function::new(SplineSpace::uniform_periodic(3, 40, Q::int(0), Q::int(40)).unwrap(), numbers(40))
                .unwrap();
        for knots in [[41, 43], [1, 3], [77, 79]] {
            assert!(lost(&ring, Direction::U, &knots) <= 5, "{knots:?}");
        }
        let sheet = TensorSpline::new(ring.space().clone(), curve.space().clone(), numbers(40 * 43)).unwrap();
        assert!(lost(&sheet, Direction::U, &[41]) <= 4 * 43);
        assert!(lost(&sheet, Direction::V, &[41]) <= 4 * 40);
    }

    #[test]
    fn knots_at_the_seam_come_out_again() {
        let ring =
            Function::new(SplineSpace::uniform_periodic(2, 9, Q::int(0), Q::int(9)).unwrap(), numbers(9))
                .unwrap();
        for knots in [vec![0], vec![0, 17], vec![1, 17]] {
            let knots = knots.into_iter().map(|k| Q::frac(k, 2)).collect();
            let (mut shape, edit) = Edit::inserting(&ring, vec![(Direction::U, knots)]).unwrap().unwrap();
            let fine = shape.clone();
            let mut history = History::new(5);
            history.push(edit);
            assert!(history.undo(&mut shape) && shape == ring);
            assert!(history.redo(&mut shape) && shape == fine);
        }
    }
}
