//! Room made for constraints that a shape is too stiff for.

use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::shape::constraints::{Constrained, Constraints, Wanted};
use crate::shape::controlled::Controlled;
use crate::tensor::along::Direction;
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
    /// Knots come, one at a time, into the longest gap between places in the span of a constraint that clashes, or between
    /// the place and the farther end of the span; for surfaces in both directions.
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
    pub fn relieved(&self, relief: Relief) -> Result<(S, Constrained<T>)> {
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
                Err(Error::Shape(ShapeError::Overdetermined { clashing, .. })) => clashing.last().copied(),
                Err(Error::Shape(ShapeError::Dependent { condition, .. })) => Some(condition),
                Err(other) => return Err(other),
            };
            let clashing = &self.wanted[clashing.unwrap_or(0)];
            shape = match relief {
                Relief::Knots => self.with_room(&shape, clashing)?,
                Relief::Degree => {
                    S::DIRECTIONS.iter().try_fold(shape, |shape, d| shape.elevated_along(*d, 1))?
                }
            };
        }
        self.prepare().and(Err(Error::Undecided))
    }

    /// The shape with a knot in each direction near a constraint.
    fn with_room(&self, shape: &S, clashing: &Wanted<T, S>) -> Result<S> {
        let Some((at, _)) = &clashing.derivative else { return Ok(shape.clone()) };
        S::DIRECTIONS.iter().try_fold(shape.clone(), |shape, direction| {
            let knot = self.room(&shape, at, *direction)?;
            shape.inserted_along(*direction, &[knot])
        })
    }

    /// The middle of the longest gap between the places of constraints in the span of one of them.
    fn room(&self, shape: &S, at: &S::Parameter, direction: Direction) -> Result<T> {
        let space = shape.space_along(direction);
        let k = space.locate(S::coordinate(at, direction))?;
        let (start, end) = (&space.knots()[k], &space.knots()[k + 1]);
        let places = self.wanted.iter().filter_map(|wanted| wanted.derivative.as_ref());
        let mut places: Vec<T> = places.map(|(at, _)| S::coordinate(at, direction).clone()).collect();
        places.retain(|x| start <= x && x <= end);
        places.sort_by(|x, y| x.partial_cmp(y).unwrap_or(Ordering::Equal));
        places.dedup();
        if let [x] = &places[..] {
            let farther = if x.clone() - start < end.clone() - x { end } else { start };
            places.push(farther.clone());
            places.sort_by(|x, y| x.partial_cmp(y).unwrap_or(Ordering::Equal));
        }
        let length = |gap: &[T]| gap[1].clone() - &gap[0];
        let longest =
            places.windows(2).reduce(|best, gap| if length(best) < length(gap) { gap } else { best });
        let (from, to) = longest.map_or((start, end), |gap| (&gap[0], &gap[1]));
        let middle = from.clone() + (to.clone() - from) / T::int(2);
        match start < &middle && &middle < end {
            true => Ok(middle),
            false => Err(Error::SpanOutOfRange { index: k }),
        }
    }
}
