//! Room made for constraints that a shape is too stiff for.

use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::shape::constraints::{Constrained, Constraints};
use crate::shape::controlled::Controlled;
use crate::space::SplineSpace;
use std::cmp::Ordering;

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
    /// Knots come, one at a time, into the longest stretch without one between the places of constraints that clash, or
    /// between a single place and the farther end of its span; for surfaces in both directions.
    ///
    /// # Errors
    /// [`ShapeError::NotCarried`] with rows, held control points or weights, which mean nothing on another shape; those of
    /// [`prepare`](Self::prepare) if knots do not help, as with one constraint asked for twice, or a derivative beyond the
    /// degree.
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
        let mut shape = self.shape.clone();
        // A control point a constraint is enough, unless one is asked for twice.
        for _ in 0..=4 * self.wanted.len() {
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
            let places = clashing.iter().filter_map(|i| self.wanted[*i].derivative.as_ref());
            let places: Vec<&S::Parameter> = places.map(|(at, _)| at).collect();
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

/// The shape with a knot in each direction between some places.
fn with_room<T: Scalar, S: Controlled<T>>(shape: &S, places: &[&S::Parameter]) -> Result<S> {
    S::DIRECTIONS.iter().try_fold(shape.clone(), |shape, direction| {
        let along = places.iter().map(|at| S::coordinate(at, *direction).clone());
        let knot = room(shape.space_along(*direction), along.collect())?;
        shape.inserted_along(*direction, &[knot])
    })
}

/// The middle of the longest stretch without a knot between the first and the last of some places, or around a single one.
fn room<T: Scalar>(space: &SplineSpace<T>, mut places: Vec<T>) -> Result<T> {
    let order = |x: &T, y: &T| x.partial_cmp(y).unwrap_or(Ordering::Equal);
    places.sort_by(order);
    places.dedup();
    if let [x] = &places[..] {
        let k = space.locate(x)?;
        let (start, end) = (&space.knots()[k], &space.knots()[k + 1]);
        let farther = if x.clone() - start < end.clone() - x { end } else { start };
        places.push(farther.clone());
        places.sort_by(order);
    }
    let mut ends = places.clone();
    if let [first, .., last] = &places[..] {
        ends.extend(space.breaks().into_iter().map(|(t, _)| t).filter(|t| first < t && t < last));
    }
    ends.sort_by(order);
    ends.dedup();
    let length = |gap: &[T]| gap[1].clone() - &gap[0];
    let longest = ends.windows(2).reduce(|best, gap| if length(best) < length(gap) { gap } else { best });
    let gap = longest.ok_or(Error::TooFewPoints { expected: 2, found: ends.len() })?;
    let middle = gap[0].clone() + length(gap) / T::int(2);
    match gap[0] < middle && middle < gap[1] {
        true => Ok(middle),
        false => Err(Error::SpanOutOfRange { index: space.locate(&gap[0])? }),
    }
}
