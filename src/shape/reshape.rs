//! What all shape operators have in common [NURBS, section 11.4]: more knots in a region, control points moved that have
//! influence nowhere else, and knots removed there as far as a tolerance allows.

use crate::error::Result;
use crate::error::shape::ShapeError;
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::shape::region::Refinement;
use crate::shape::workable::Workable;
use crate::space::SplineSpace;
use crate::tensor::along::Direction;
use std::ops::Range;

/// Where a shape operator works, and what it does with knots there: an interval `[from, to]` of a curve (`P = T`), the
/// rectangle between the corners `from` and `to` of a surface (`P = (T, T)`).
///
/// # Examples
/// Three knots make room for two control points in the middle of a parabola, and go again where nothing moved.
/// ```
/// use nalgebra::vector;
/// use symspline::{Curve, Q, Refinement, Region, Scalar, SplineSpace};
/// let points = [[0, 0], [1, 2], [2, 0]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
/// let curve = Curve::new(SplineSpace::bezier(2, Q::int(0), Q::int(8))?, points.to_vec())?;
/// let region = Region::new(Q::int(2), Q::int(6)).refined(Refinement::Count(3));
/// let reshaped = region.reshaped(&curve, |finer, window| {
///     assert_eq!(finer.space().dim(), 8);
///     Ok(window.flat(finer).map(|i| (i, vector![Q::int(0), Q::int(1)])).collect())
/// })?;
/// assert_eq!((reshaped.inserted.len(), reshaped.moved), (5, 2));
/// assert_eq!(reshaped.shape.at(&Q::int(2))?, curve.at(&Q::int(2))?);
///
/// let idle = region.thinned(Q::int(0)).reshaped(&curve, |_, _| Ok(Vec::new()))?;
/// assert_eq!(idle.shape, curve);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Region<T, P = T> {
    from: P,
    to: P,
    /// Along `U` and along `V`.
    refinements: [Refinement<T>; 2],
    tolerance: Option<T>,
}

/// The control points that have influence in a region alone: a range of unrolled indices for each direction
/// [NURBS, (11.40)].
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Window {
    ranges: Vec<Range<usize>>,
}

/// A shape that was worked on, and what became of its knots.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Reshaped<S, T> {
    /// The new shape.
    pub shape: S,
    /// The knots that were inserted before control points moved.
    pub inserted: Vec<(Direction, T)>,
    /// The number of control points that moved.
    pub moved: usize,
    /// The knots that were removed afterwards.
    pub removed: Vec<(Direction, T)>,
    /// At least the distance between the shape before and after the removal, at most the tolerance.
    pub bound: T,
}

impl<T: Scalar, P: Clone> Region<T, P> {
    /// The region between `from` and `to`, without knots inside it that are not there already, and none removed.
    pub fn new(from: P, to: P) -> Self {
        Self { from, to, refinements: [Refinement::Count(0), Refinement::Count(0)], tolerance: None }
    }

    /// The same region, refined in all directions.
    pub fn refined(self, refinement: Refinement<T>) -> Self {
        Self { refinements: [refinement.clone(), refinement], ..self }
    }

    /// The same region, refined along one direction in this way.
    pub fn refined_along(mut self, direction: Direction, refinement: Refinement<T>) -> Self {
        self.refinements[direction as usize] = refinement;
        self
    }

    /// The same region; knots in it are removed up to `tolerance`, a distance between points.
    pub fn thinned(self, tolerance: T) -> Self {
        Self { tolerance: Some(tolerance), ..self }
    }

    /// The corners.
    pub fn corners(&self) -> (&P, &P) {
        (&self.from, &self.to)
    }

    /// The shape with the knots that the region asks for.
    ///
    /// # Errors
    /// Those of [`Refinement::of`].
    pub fn refine<S: Workable<T, Parameter = P>>(&self, shape: &S) -> Result<S> {
        let refined = |shape: S, direction: &Direction| {
            let (start, end) = self.sides::<S>(*direction);
            self.refinements[*direction as usize].of(&shape, *direction, start, end)
        };
        S::DIRECTIONS.iter().try_fold(shape.clone(), refined)
    }

    /// The control points of a shape that have influence in the region alone.
    ///
    /// # Errors
    /// Those of [`SplineSpace::local_coeffs`]: the sides of the region are knots after [`refine`](Self::refine).
    pub fn window<S: Workable<T, Parameter = P>>(&self, shape: &S) -> Result<Window> {
        let range = |direction: &Direction| {
            let (start, end) = self.sides::<S>(*direction);
            shape.space_along(*direction).local_coeffs(start, end)
        };
        Ok(Window { ranges: S::DIRECTIONS.iter().map(range).collect::<Result<_>>()? })
    }

    /// The shape refined, after `moves`, and thinned out. What moves are made of the refined shape and the control points
    /// that may move; over exact fields nothing outside the region changes if `moves` keeps to them.
    ///
    /// # Errors
    /// Those of [`Refinement::knots`], of `moves`, and of [`Workable::thinned`]; [`ShapeError::NoFreePoints`] if no control
    /// point may move.
    pub fn reshaped<S: Workable<T, Parameter = P>>(
        &self,
        shape: &S,
        moves: impl FnOnce(&S, &Window) -> Result<Vec<(usize, S::Point)>>,
    ) -> Result<Reshaped<S, T>> {
        let mut finer = self.refine(shape)?;
        let inserted = knots_gone(&finer, shape);
        let window = self.window(&finer)?;
        if window.is_empty() {
            return Err(ShapeError::NoFreePoints.into());
        }
        let moves = moves(&finer, &window)?;
        finer.move_points(&moves)?;
        let (moved, bound) = (moves.len(), T::zero());
        let Some(tolerance) = &self.tolerance else {
            return Ok(Reshaped { shape: finer, inserted, moved, removed: Vec::new(), bound });
        };
        let thin = finer.thinned(&self.from, &self.to, tolerance)?;
        let removed = knots_gone(&finer, &thin.spline);
        Ok(Reshaped { shape: thin.spline, inserted, moved, removed, bound: thin.bound })
    }

    /// Start and end along a direction.
    pub(crate) fn sides<S: Controlled<T, Parameter = P>>(&self, direction: Direction) -> (&T, &T) {
        (S::coordinate(&self.from, direction), S::coordinate(&self.to, direction))
    }
}

impl Window {
    /// The unrolled indices, a range for each direction.
    pub fn ranges(&self) -> &[Range<usize>] {
        &self.ranges
    }

    /// Whether there is no control point in it.
    pub fn is_empty(&self) -> bool {
        self.ranges.iter().any(Range::is_empty)
    }

    /// The number of control points.
    pub fn len(&self) -> usize {
        self.ranges.iter().map(Range::len).product()
    }

    /// The positions in the ranges, one for each direction, row by row.
    pub(crate) fn positions(&self) -> impl Iterator<Item = Vec<usize>> + '_ {
        let split = |k: usize| {
            let mut rest = k;
            let mut position: Vec<usize> = self
                .ranges
                .iter()
                .rev()
                .map(|range| {
                    let place = rest % range.len();
                    rest /= range.len();
                    place
                })
                .collect();
            position.reverse();
            position
        };
        (0..self.len()).map(split)
    }

    /// The places of the control points in the list of a shape, row by row.
    pub fn flat<T: Scalar, S: Controlled<T>>(&self, shape: &S) -> impl Iterator<Item = usize> {
        let indices = |position: Vec<usize>| {
            let unrolled: Vec<usize> =
                position.iter().zip(&self.ranges).map(|(i, range)| range.start + i).collect();
            flat(shape, &unrolled)
        };
        self.positions().map(indices).collect::<Vec<_>>().into_iter()
    }
}

/// The place of a control point with the given unrolled indices in the list of a shape.
pub(crate) fn flat<T: Scalar, S: Controlled<T>>(shape: &S, unrolled: &[usize]) -> usize {
    let step = |place: usize, (direction, i): (&Direction, &usize)| {
        let space = shape.space_along(*direction);
        place * space.dim() + space.slot(*i)
    };
    S::DIRECTIONS.iter().zip(unrolled).fold(0, step)
}

/// The knots of `fine` that `coarse` does not have.
fn knots_gone<T: Scalar, S: Controlled<T>>(fine: &S, coarse: &S) -> Vec<(Direction, T)> {
    let own = |space: &SplineSpace<T>| match space.is_periodic() {
        true => space.round_knots().to_vec(),
        false => space.knots().to_vec(),
    };
    let along = |direction: &Direction| {
        let coarse = own(coarse.space_along(*direction));
        let mut rest = coarse.into_iter().peekable();
        let mut gone = own(fine.space_along(*direction));
        gone.retain(|t| rest.next_if(|kept| kept == t).is_none());
        gone.into_iter().map(|t| (*direction, t)).collect::<Vec<_>>()
    };
    S::DIRECTIONS.iter().flat_map(along).collect()
}
