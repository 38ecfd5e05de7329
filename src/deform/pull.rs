//! One force at one place, prepared.

use crate::coeff::Coeff;
use crate::deform::elastic::Elastic;
use crate::error::deform::DeformError;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::shape::drag::Drag;

/// A force at one place of a shape, ready to be changed: the displacements are `V_c f`, and the point there moves by `(B · V_c) f`
/// [Vassilev, (18), (20), (31) and (32)].
///
/// It is for the shape that it was made on and its like, with the same spaces and weights; that they have as many control points
/// is all that is checked.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Pull<T: Scalar, S: Controlled<T>> {
    at: S::Parameter,
    response: Drag<T>,
    give: T,
}

impl<T: Scalar> Elastic<T> {
    /// A force on `shape` at `at`, prepared.
    ///
    /// # Errors
    /// [`DeformError::NoHold`] if a force there does not move the point, for want of control points that may move; [`DeformError::OtherSpace`];
    /// [`Error::OutsideDomain`]; [`Error::NotFinite`] on overflow.
    pub fn pull<S: Controlled<T>>(&self, shape: &S, at: &S::Parameter) -> Result<Pull<T, S>> {
        self.check(shape)?;
        let response = self.response(&self.load_at(|direction| S::coordinate(at, direction))?)?;
        let influence = shape.influence(at, S::VALUE)?;
        let answer = |i: &usize| response.binary_search_by_key(i, |(j, _)| *j).ok().map(|k| &response[k].1);
        let met = influence.terms().iter().filter_map(|(i, b)| Some((b, answer(i)?)));
        let give = met.fold(T::zero(), |sum, (b, v)| sum + b.clone() * v);
        if !give.is_finite() {
            return Err(Error::NotFinite { what: "movement under a unit force", index: 0 });
        }
        if give.is_zero() {
            return Err(DeformError::NoHold { place: format!("{at:?}") }.into());
        }
        let (indices, matrix) = response.into_iter().unzip();
        Ok(Pull { at: at.clone(), response: Drag::new(shape.control_count(), indices, matrix, 1), give })
    }
}

impl<T: Scalar, S: Controlled<T>> Pull<T, S> {
    /// Where the force acts.
    pub fn at(&self) -> &S::Parameter {
        &self.at
    }

    /// How far the point there moves under a unit force: `B · V_c`. With [`Spread::Point`](crate::Spread::Point) it is positive, for polynomial shapes; hat
    /// functions reach farther than the point, and in odd windows what is loaded there may answer the other way.
    pub fn give(&self) -> &T {
        &self.give
    }

    /// How the control points answer a unit force: one column `V_c`.
    pub fn response(&self) -> &Drag<T> {
        &self.response
    }

    /// The force that moves the point by `change` [Vassilev, (20) and (32)].
    pub fn force_for(&self, change: &S::Point) -> S::Point {
        let mut force = change.clone();
        force.divide(&self.give);
        force
    }

    /// Adds `force` to the forces on `shape`. On an error the shape stays as it is.
    ///
    /// # Errors
    /// As [`Drag::apply`].
    pub fn push(&self, shape: &mut S, force: &S::Point) -> Result<()> {
        self.response.apply(shape, std::slice::from_ref(force))
    }

    /// Moves the point by `change` and returns the force that this took. On an error the shape stays as it is.
    ///
    /// # Errors
    /// As [`Drag::apply`].
    pub fn drag(&self, shape: &mut S, change: &S::Point) -> Result<S::Point> {
        let force = self.force_for(change);
        self.push(shape, &force)?;
        Ok(force)
    }

    /// Moves the point to `target` and returns the force that this took. On an error the shape stays as it is.
    ///
    /// # Errors
    /// As [`Drag::apply`].
    pub fn move_to(&self, shape: &mut S, target: &S::Point) -> Result<S::Point> {
        let change = target.minus(&shape.derivative_of(&self.at, S::VALUE)?);
        self.drag(shape, &change)
    }
}
