//! Room made for constraints that a shape is too stiff for.

use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::shape::constraints::{Constrained, Constraints, Wanted};
use crate::shape::controlled::Controlled;
use crate::space::SplineSpace;
use std::cmp::Ordering;
use std::collections::BTreeSet;

/// How a shape gets more control points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Relief {
    /// Knots between the places of constraints that clash. Derivatives beyond the degree stay out of reach.
    Knots,
    /// One degree more at a time.
    Degree,
}

impl<T: Scalar, S: Controlled<T>> Constraints<'_, T, S> {
    /// The shape, with as many more control points as it takes to meet these constraints, and the constraints prepared for
    /// it. The shape is the same, only finer or of higher degree [NURBS, section 11.5.1].
    ///
    /// Knots come, one at a time, into the middle of the span that holds most of the places of constraints that clash and of
    /// those that share control points with them; for surfaces in both directions.
    ///
    /// # Errors
    /// [`ShapeError::NotCarried`] with rows, held control points or weights, which mean nothing on another shape;
    /// [`ShapeError::Dependent`] for one constraint asked for twice; those of [`prepare`](Self::prepare) if neither helps, as at
    /// both ends of a ring, nor knots a derivative beyond the degree; those of the insertion or elevation.
    ///
    /// # Examples
    /// Five points on one cubic span:
    /// ```
    /// use symspline::{Constraints, Function, Q, Relief, Scalar, SplineSpace};
    /// let zero = Function::constant(SplineSpace::bezier(3, Q::int(0), Q::int(1))?, Q::int(0))?;
    /// let mut wanted = Constraints::on(&zero);
    /// for i in 0..5 {
    ///     wanted = wanted.point(&Q::frac(i, 4))?;
    /// }
    /// assert!(wanted.prepare().is_err());
    /// let (finer, held) = wanted.relieved(Relief::Knots)?;
    /// assert_eq!(finer.space().dim(), 5);
    /// let wave = held.dragged(&finer, &[0, 1, 0, -1, 0].map(Q::int))?;
    /// assert_eq!(wave.at(&Q::frac(3, 4))?, Q::int(-1));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn relieved(&self, relief: Relief) -> Result<(S, Constrained<T, S>)> {
        let rows = self.wanted.iter().any(|wanted| wanted.derivative.is_none());
        if rows || !self.held.is_empty() || self.free.is_some() || !self.weights.is_empty() {
            return Err(ShapeError::NotCarried.into());
        }
        if let Some((first, second)) = self.twice() {
            return Err(ShapeError::Dependent { condition: second, on: vec![first] }.into());
        }
        let mut shape = self.shape.clone();
        let steps = match relief {
            // Most of the time a control point a constraint is enough.
            Relief::Knots => 4 * self.wanted.len(),
            // Polynomials of this degree take on any derivatives up to these orders.
            Relief::Degree => self.wanted.iter().map(|wanted| wanted.order() + 1).sum(),
        };
        for _ in 0..=steps {
            let mut wanted = Constraints::on(&shape);
            for (at, order) in self.wanted.iter().filter_map(|wanted| wanted.derivative.as_ref()) {
                wanted = wanted.derivative(at, *order)?;
            }
            let clashing = match wanted.prepare() {
                Ok(held) => return Ok((shape, held)),
                Err(Error::Shape(ShapeError::Overdetermined { clashing, .. })) => clashing,
                Err(Error::Shape(ShapeError::Dependent { condition, mut on })) => {
                    on.push(condition);
                    on
                }
                Err(other) => return Err(other),
            };
            let places = wanted.beside(&clashing);
            shape = match relief {
                Relief::Knots => with_room(&shape, &places)?,
                Relief::Degree => {
                    S::DIRECTIONS.iter().try_fold(shape, |shape, d| shape.elevated_along(*d, 1))?
                }
            };
        }
        self.prepare().and(Err(Error::Undecided))
    }
}

impl<T: Scalar, S: Controlled<T>> Wanted<T, S> {
    /// The order of the derivative in all directions together.
    fn order(&self) -> usize {
        let along = |order: S::Order| S::DIRECTIONS.iter().map(move |d| S::order_along(order, *d)).sum();
        self.derivative.as_ref().map_or(0, |(_, order)| along(*order))
    }

    fn is_same(&self, other: &Self) -> bool {
        let (Some((x, k)), Some((y, l))) = (&self.derivative, &other.derivative) else { return false };
        S::DIRECTIONS.iter().all(|d| {
            S::coordinate(x, *d) == S::coordinate(y, *d) && S::order_along(*k, *d) == S::order_along(*l, *d)
        })
    }
}

impl<T: Scalar, S: Controlled<T>> Constraints<'_, T, S> {
    /// Two constraints that are one.
    fn twice(&self) -> Option<(usize, usize)> {
        let before = |j: usize| (0..j).find(|i| self.wanted[*i].is_same(&self.wanted[j]));
        (0..self.wanted.len()).find_map(|j| before(j).map(|i| (i, j)))
    }

    /// The places of some constraints, and of all that have control points in common with them.
    fn beside(&self, clashing: &[usize]) -> Vec<S::Parameter> {
        let rows = clashing.iter().map(|i| &self.wanted[*i].row);
        let shared: BTreeSet<usize> = rows.flat_map(|row| row.terms().iter().map(|(i, _)| *i)).collect();
        let beside = |(i, wanted): &(usize, &Wanted<T, S>)| {
            clashing.contains(i) || wanted.row.terms().iter().any(|(i, _)| shared.contains(i))
        };
        let near = self.wanted.iter().enumerate().filter(beside);
        near.filter_map(|(_, wanted)| wanted.derivative.as_ref().map(|(at, _)| at.clone())).collect()
    }
}

/// The shape with a knot in each direction between some places.
fn with_room<T: Scalar, S: Controlled<T>>(shape: &S, places: &[S::Parameter]) -> Result<S> {
    S::DIRECTIONS.iter().try_fold(shape.clone(), |shape, direction| {
        let along = places.iter().map(|at| S::coordinate(at, *direction).clone());
        let knot = room(shape.space_along(*direction), along.collect())?;
        shape.inserted_along(*direction, &[knot])
    })
}

/// The middle of the span that holds most of some places, of several the longest; or, where all of them are in one half, a
/// value between them.
fn room<T: Scalar>(space: &SplineSpace<T>, mut places: Vec<T>) -> Result<T> {
    places.sort_by(|x, y| x.partial_cmp(y).unwrap_or(Ordering::Equal));
    places.dedup();
    let held = |k: usize| {
        let (start, end) = (&space.knots()[k], &space.knots()[k + 1]);
        let inside = places.partition_point(|x| x < start)..places.partition_point(|x| x <= end);
        (inside.len(), end.clone() - start, k, inside)
    };
    let spans = places.iter().flat_map(|x| [space.locate(x), space.locate_left(x)]);
    let spans = spans.collect::<Result<BTreeSet<usize>>>()?;
    let fuller = |best: (usize, T, usize, _), other: (usize, T, usize, _)| {
        if (best.0, &best.1) < (other.0, &other.1) { other } else { best }
    };
    let fullest = spans.into_iter().map(held).reduce(fuller);
    let (_, length, k, inside) = fullest.ok_or(Error::TooFewPoints { expected: 1, found: 0 })?;
    let (start, end) = (&space.knots()[k], &space.knots()[k + 1]);
    let middle = start.clone() + length / T::int(2);
    let inside = &places[inside];
    let knot = match inside {
        [first, .., last] if *last <= middle || middle <= *first => {
            first.clone() + (last.clone() - first) / T::int(2)
        }
        _ => middle,
    };
    match *start < knot && knot < *end {
        true => Ok(knot),
        false => Err(Error::SpanOutOfRange { index: k }),
    }
}
