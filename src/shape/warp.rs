//! Warps: control points moved by `f(t) d W(t)`, where `t` is the parameter assigned to them.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::error::shape::ShapeError;
use crate::scalar::{Real, Scalar};
use crate::shape::assignment::{Assigned, by_chords, by_nodes};
use crate::shape::reshape::{Region, Reshaped, Window};
use crate::shape::workable::Workable;
use crate::tensor::along::Direction;
use nalgebra::SVector;

/// A warp of a curve or surface in a region: `P_i + f(t_i) d W(t_i)` [NURBS, (11.42), (11.48), (11.49)].
///
/// The way from parameters to vectors is a function, so that any shape of warp is possible: a [`Bump`](crate::Bump) or
/// another function times a constant vector or the [`unit normal`](crate::UnitNormal::unit_normal), a die punch over
/// [`Polygons`](crate::Polygons), or the pull of a [`gravity field`](crate::Gravity).
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Bump, Curve, Q, Refinement, Region, Scalar, SplineSpace, Warp};
/// let points = (0..4).map(|x| vector![Q::int(x), Q::int(0)]).collect();
/// let line = Curve::new(SplineSpace::bezier(3, Q::int(0), Q::int(3))?, points)?;
/// let bump = Bump::new(Q::int(1))?;
/// let region = Region::new(Q::int(1), Q::int(2)).refined(Refinement::Count(7));
/// let warp = Warp::along(region, |at| bump.at(&at.share), vector![Q::int(0), Q::int(1)]);
/// let warped = warp.apply(&line)?.shape;
/// assert_eq!(warped.at(&Q::int(1))?, line.at(&Q::int(1))?);
/// assert!(warped.at(&Q::frac(3, 2))?[1] > Q::frac(4, 5));
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Warp<T, P, F> {
    region: Region<T, P>,
    displacement: F,
}

impl<T: Scalar, P: Clone, F> Warp<T, P, F> {
    /// The warp that moves each control point by `displacement`, a function of the parameters assigned to it; `None` leaves
    /// it where it is.
    pub fn new<C>(region: Region<T, P>, displacement: F) -> Self
    where
        F: Fn(&Assigned<P>) -> Result<Option<C>>,
    {
        Self { region, displacement }
    }

    /// The warped shape, with parameters from the nodes of the control points [NURBS, (11.4)].
    ///
    /// # Errors
    /// As [`apply_with`](Self::apply_with).
    pub fn apply<S>(&self, shape: &S) -> Result<Reshaped<S, T>>
    where
        S: Workable<T, Parameter = P>,
        F: Fn(&Assigned<P>) -> Result<Option<S::Point>>,
    {
        self.apply_with(shape, |finer, window| Ok(by_nodes(finer, &self.region, window)))
    }

    /// The warped shape, with parameters from the accumulated lengths of the control polygon, from the control point before
    /// the first that may move to the one after the last. At an end of an open curve, where there is none, the length
    /// begins or ends at the first or last itself. On surfaces lengths are averaged over the lines of the net
    /// [NURBS, A9.3].
    ///
    /// # Errors
    /// As [`apply_with`](Self::apply_with); [`Error::NoLength`](crate::Error::NoLength) if all these control points coincide.
    pub fn apply_by_chords<S, const N: usize>(&self, shape: &S) -> Result<Reshaped<S, T>>
    where
        T: Real,
        S: Workable<T, Parameter = P, Point = SVector<T, N>>,
        F: Fn(&Assigned<P>) -> Result<Option<S::Point>>,
    {
        self.apply_with(shape, by_chords)
    }

    /// The warped shape, with parameters of the caller's own: for each direction the shares, from 0 to 1, of the control
    /// points of a window of the refined shape.
    ///
    /// # Errors
    /// Those of [`Region::reshaped`], of `shares` and of the displacement; [`ShapeError::Shares`] unless there is a share
    /// for each control point.
    pub fn apply_with<S>(
        &self,
        shape: &S,
        shares: impl FnOnce(&S, &Window) -> Result<Vec<Vec<T>>>,
    ) -> Result<Reshaped<S, T>>
    where
        S: Workable<T, Parameter = P>,
        F: Fn(&Assigned<P>) -> Result<Option<S::Point>>,
    {
        self.region.reshaped(shape, |finer, window| {
            let shares = shares(finer, window)?;
            let counts = |shares: &[Vec<T>]| shares.iter().map(Vec::len).collect::<Vec<_>>();
            if !counts(&shares).into_iter().eq(window.ranges().iter().map(ExactSizeIterator::len)) {
                return Err(ShapeError::Shares.into());
            }
            let one = |(place, position): (usize, Vec<usize>)| {
                let share = |direction: Direction| {
                    let axis = direction as usize;
                    shares[axis][position[axis]].clone()
                };
                let parameter = |direction: Direction| self.parameter::<S>(direction, share(direction));
                let assigned = Assigned { share: S::place(share), parameter: S::place(parameter) };
                Ok((self.displacement)(&assigned)?.map(|by| (place, by)))
            };
            let moves = window.flat(finer).zip(window.positions()).map(one);
            moves.filter_map(Result::transpose).collect()
        })
    }

    /// `from + share (to - from)`, not beyond the ends by rounding.
    fn parameter<S: Workable<T, Parameter = P>>(&self, direction: Direction, share: T) -> T {
        let (start, end) = self.region.sides::<S>(direction);
        let x = start.clone() + (end.clone() - start) * share;
        let x = if x < *start { start.clone() } else { x };
        if x > *end { end.clone() } else { x }
    }
}

impl<T: Scalar, P: Clone> Warp<T, P, ()> {
    /// The warp by `profile` times a constant vector `d W`.
    pub fn along<C: Coeff<T>>(
        region: Region<T, P>,
        profile: impl Fn(&Assigned<P>) -> T,
        vector: C,
    ) -> Warp<T, P, impl Fn(&Assigned<P>) -> Result<Option<C>>> {
        let displacement = move |at: &Assigned<P>| {
            let f = profile(at);
            Ok((!f.is_zero()).then(|| vector.scaled(&f)))
        };
        Warp { region, displacement }
    }
}
