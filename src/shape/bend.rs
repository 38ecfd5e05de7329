//! Bends of curves and surfaces about curves and surfaces, with their ends carried along [NURBS, section 11.4.3].
//!
//! A surface is bent row by row, each row of control points as a curve is: about a cylinder if the centre is an axis, about a
//! sphere or any surface if it is a point. Outside the interval each row moves as a rigid body:
//!
//! ```text
//! P'_i = P'_t + R (P_i - P_t)   for i > t,    R takes the direction of P_t - P_{t-1} to that of P'_t - P'_{t-1}
//! ```
//! and the same way before the interval. The rotation is the one by the least angle; with one mapped control point, or if one of
//! the two legs has no length, there is none.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::error::shape::ShapeError;
use crate::scalar::Scalar;
use crate::shape::bend_about::Bendable;
use crate::shape::bend_centre::BendCentre;
use crate::shape::bend_ratio::{CrossRatio, bent_point};
use crate::shape::controlled::Controlled;
use crate::shape::region::Refinement;
use crate::shape::rotation::Rotation;
use crate::space::SplineSpace;
use crate::tensor::along::Direction;
use nalgebra::SVector;
use std::ops::Range;

/// Bends curves and surfaces, polynomial and rational, about something [`Bendable`] towards a [`BendCentre`].
///
/// Of a rational shape the control points are bent, and weights stay.
///
/// # Examples
/// With cross ratio 1 control points come to lie on the circle. The lengths must be rational here.
/// ```
/// use nalgebra::vector;
/// use symspline::{Bend, Curve, Q, Round, Scalar, SplineSpace};
/// let q = |x: i64, y: i64| vector![Q::int(x), Q::int(y)];
/// let space = SplineSpace::clamped(1, (0..7).map(Q::int))?;
/// let line = Curve::new(space, [-18, -12, -6, 0, 6, 12, 18].map(|x| vector![Q::int(x), Q::frac(5, 2)]).to_vec())?;
/// let bend = Bend::new(q(0, 0), Round(Q::frac(5, 2)), Q::int(1)).on(Q::int(1), Q::int(5)).without_tails();
/// let bent = bend.apply(&line)?;
/// assert_eq!(bent.coeffs()[3], line.coeffs()[3]);
/// assert!(bent.coeffs()[2..5].iter().all(|c| c.dot(c) == Q::frac(25, 4)));
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Bend<T: Scalar, O, B> {
    centre: O,
    about: B,
    ratio: CrossRatio<T>,
    direction: Direction,
    interval: Option<(T, T)>,
    refinement: Option<Refinement<T>>,
    tails: bool,
}

impl<T: Scalar, O, B> Bend<T, O, B> {
    /// A bend of the whole shape, of a surface along `u`.
    pub fn new(centre: O, about: B, ratio: impl Into<CrossRatio<T>>) -> Self {
        let ratio = ratio.into();
        Self { centre, about, ratio, direction: Direction::U, interval: None, refinement: None, tails: true }
    }

    /// Bends a surface along this direction.
    pub fn along(self, direction: Direction) -> Self {
        Self { direction, ..self }
    }

    /// Bends between two knots, which the ends must be unless the shape is refined: the control points without influence elsewhere.
    pub fn on(self, start: T, end: T) -> Self {
        Self { interval: Some((start, end)), ..self }
    }

    /// Inserts knots in the interval first.
    pub fn refined(self, refinement: Refinement<T>) -> Self {
        Self { refinement: Some(refinement), ..self }
    }

    /// Leaves what is outside the interval where it is.
    pub fn without_tails(self) -> Self {
        Self { tails: false, ..self }
    }

    /// The bent shape.
    ///
    /// # Errors
    /// [`ShapeError::NoKnot`] or [`Error::OutsideDomain`](crate::Error::OutsideDomain) for the interval;
    /// [`ShapeError::NothingLocal`] if no control point is local to it; [`ShapeError::AtCentre`];
    /// [`ShapeError::NoBendPoint`]; [`ShapeError::BeyondInfinity`]; [`ShapeError::NoRoot`] if a length is not in the field;
    /// [`ShapeError::NoEnds`] for the interval of a periodic shape, unless [`without_tails`](Self::without_tails);
    /// [`ShapeError::OtherParameters`] if a curve is asked for its second parameter;
    /// [`Error::Weight`](crate::Error::Weight); [`Error::NotFinite`](crate::Error::NotFinite) on overflow; those of
    /// [`Refinement`].
    pub fn apply<S, const N: usize>(&self, shape: &S) -> Result<S>
    where
        S: Controlled<T, Point = SVector<T, N>>,
        O: BendCentre<T, N>,
        B: Bendable<T, N>,
    {
        if !S::DIRECTIONS.contains(&self.direction) {
            return Err(ShapeError::OtherParameters.into());
        }
        let mut bent = self.refine(shape)?;
        let mapped = self.mapped(bent.space_along(self.direction))?;
        let mut moves = Vec::new();
        for row in 0..bent.control_count() / bent.space_along(self.direction).dim() {
            moves.extend(self.bent_row(&bent, row, &mapped)?);
        }
        bent.move_points(&moves)?;
        Ok(bent)
    }

    /// The shape with knots inserted.
    fn refine<S: Controlled<T>>(&self, shape: &S) -> Result<S> {
        let Some(refinement) = &self.refinement else { return Ok(shape.clone()) };
        let (a, b) = shape.space_along(self.direction).domain();
        let (start, end) = self.interval.as_ref().map_or((a, b), |(start, end)| (start, end));
        refinement.of(shape, self.direction, start, end)
    }

    /// The coefficients that are bent, as unrolled indices.
    fn mapped(&self, space: &SplineSpace<T>) -> Result<Range<usize>> {
        let Some((start, end)) = &self.interval else { return Ok(0..space.dim()) };
        let local = space.local_coeffs(start, end)?;
        if local.is_empty() {
            let [start, end] = [start, end].map(T::to_string);
            return Err(ShapeError::NothingLocal { start, end }.into());
        }
        if self.tails && space.is_periodic() && local.len() < space.dim() {
            return Err(ShapeError::NoEnds.into());
        }
        Ok(local)
    }

    /// By what the control points of a row move.
    fn bent_row<S, const N: usize>(
        &self,
        shape: &S,
        row: usize,
        mapped: &Range<usize>,
    ) -> Result<Vec<(usize, SVector<T, N>)>>
    where
        S: Controlled<T, Point = SVector<T, N>>,
        O: BendCentre<T, N>,
        B: Bendable<T, N>,
    {
        let space = shape.space_along(self.direction);
        let rows = shape.control_count() / space.dim();
        let flat = |i: usize| match self.direction {
            Direction::U => space.slot(i) * rows + row,
            Direction::V => row * space.dim() + space.slot(i),
        };
        let point = |i: usize| shape.control_point(flat(i));
        let image = |i: usize| {
            let (point, lambda) = (point(i)?, self.ratio_at(shape, i, row)?);
            self.image(flat(i), &point, &lambda)
        };
        let before = mapped.clone().map(point).collect::<Result<Vec<_>>>()?;
        let after = mapped.clone().map(image).collect::<Result<Vec<_>>>()?;
        let mut moves: Vec<_> =
            mapped.clone().zip(before.iter().zip(&after)).map(|(i, (p, q))| (flat(i), q.minus(p))).collect();
        if self.tails && self.interval.is_some() && !space.is_periodic() {
            let last = before.len() - 1;
            let head = (0..mapped.start, 0, 1.min(last));
            let tail = (mapped.end..space.dim(), last, last.saturating_sub(1));
            for (indices, pivot, next) in [head, tail] {
                if indices.is_empty() {
                    continue;
                }
                let leg = |points: &[SVector<T, N>]| points[next].minus(&points[pivot]);
                let turn = Rotation::between(&leg(&before), &leg(&after))?;
                for i in indices {
                    let point = point(i)?;
                    moves.push((flat(i), turn.carried(&point, &before[pivot], &after[pivot]).minus(&point)));
                }
            }
        }
        moves.retain(|(_, by)| !by.vanishes());
        Ok(moves)
    }

    /// Where a control point comes to lie.
    fn image<const N: usize>(&self, index: usize, point: &SVector<T, N>, lambda: &T) -> Result<SVector<T, N>>
    where
        O: BendCentre<T, N>,
        B: Bendable<T, N>,
    {
        let centre = self.centre.centre_of(point)?;
        if *point == centre {
            return Err(ShapeError::AtCentre { index }.into());
        }
        let share = self.about.share(&centre, point)?.ok_or(ShapeError::NoBendPoint { index })?;
        bent_point(&centre, point, &share, lambda).ok_or_else(|| {
            let (ratio, share) = (lambda.to_string(), share.to_string());
            ShapeError::BeyondInfinity { index, ratio, share }.into()
        })
    }

    /// The cross ratio of a control point.
    fn ratio_at<S: Controlled<T>>(&self, shape: &S, i: usize, row: usize) -> Result<T> {
        let node = |direction: Direction, i: usize| shape.space_along(direction).node_inside(i);
        match &self.ratio {
            CrossRatio::Constant(ratio) => Ok(ratio.clone()),
            CrossRatio::Along(ratio) => ratio.at(&node(self.direction, i)),
            CrossRatio::Over(ratio) => match (S::DIRECTIONS.len(), self.direction) {
                (1, _) => Err(ShapeError::OtherParameters.into()),
                (_, Direction::U) => ratio.at(&node(Direction::U, i), &node(Direction::V, row)),
                (_, Direction::V) => ratio.at(&node(Direction::U, row), &node(Direction::V, i)),
            },
        }
    }
}
