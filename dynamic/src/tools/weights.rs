//! Weights moved: pulls toward a control point.

use crate::error::{Error, Result};
use crate::number::{Field, Number};
use crate::over::Coords;
use crate::shape;
use crate::tools::shape::{Named, Shape, coords, place, point};
use crate::value::Value;
use std::fmt::Debug;
use std::marker::PhantomData;
use symspline::{Coeff, Q, Weighed, WeightPull, WeightRange};

/// A pull toward a control point by its weight; see [`WeightPull`].
pub trait Puller: Debug + Send + Sync {
    /// Weight and share as they were.
    fn weight_and_share(&self) -> (Number, Number);
    /// The point and the control point as they were.
    fn points(&self) -> (Coords, Coords);
    /// The least and the largest fraction of the way, if there are any.
    fn limits(&self) -> (Option<Number>, Option<Number>);
    /// The weight that goes a fraction of the way.
    ///
    /// # Errors
    /// Those of [`WeightPull::weight_for`].
    fn weight_for(&self, fraction: &Number) -> Result<Number>;
    /// The fraction that a weight goes.
    ///
    /// # Errors
    /// Those of [`WeightPull::fraction_for`].
    fn fraction_for(&self, weight: &Number) -> Result<Number>;
    /// The fraction at which the point is nearest to a target.
    ///
    /// # Errors
    /// [`Error::Dimensions`].
    fn fraction_near(&self, target: &Coords) -> Result<Number>;
    /// The point after a move by a fraction of the way.
    ///
    /// # Errors
    /// [`symspline::Error::NotFinite`].
    fn point_at(&self, fraction: &Number) -> Result<Coords>;
    /// The point when the weight becomes another.
    ///
    /// # Errors
    /// Those of [`WeightPull::point_at_weight`].
    fn point_at_weight(&self, weight: &Number) -> Result<Coords>;
    /// The distance from the point to the control point, over floats.
    ///
    /// # Errors
    /// [`Error::Fields`].
    fn distance(&self) -> Result<Number>;
    /// The fraction of the way that a distance is, over floats.
    ///
    /// # Errors
    /// [`Error::Fields`].
    fn fraction_of(&self, distance: &Number) -> Result<Number>;
    /// The weight that moves the point by a distance, over floats.
    ///
    /// # Errors
    /// [`Error::Fields`], and those of [`WeightPull::weight_for_distance`].
    fn weight_for_distance(&self, distance: &Number) -> Result<Number>;
    /// The shape with its point moved.
    ///
    /// # Errors
    /// Those of [`WeightPull::applied`].
    fn applied(&self, shape: &Value, fraction: &Number) -> Result<Value>;
}

/// Distances of pulls, where the field has square roots.
trait Measured: Field {
    /// See [`WeightPull::distance`].
    fn distance<C: Coeff<Self>>(pull: &WeightPull<Self, C>) -> Result<Self>;
    /// See [`WeightPull::fraction_of`].
    fn fraction_of<C: Coeff<Self>>(pull: &WeightPull<Self, C>, distance: &Self) -> Result<Self>;
    /// See [`WeightPull::weight_for_distance`].
    fn weight_for_distance<C: Coeff<Self>>(pull: &WeightPull<Self, C>, distance: &Self) -> Result<Self>;
}

impl Measured for f64 {
    fn distance<C: Coeff<Self>>(pull: &WeightPull<Self, C>) -> Result<Self> {
        Ok(pull.distance())
    }

    fn fraction_of<C: Coeff<Self>>(pull: &WeightPull<Self, C>, distance: &Self) -> Result<Self> {
        Ok(pull.fraction_of(distance))
    }

    fn weight_for_distance<C: Coeff<Self>>(pull: &WeightPull<Self, C>, distance: &Self) -> Result<Self> {
        Ok(pull.weight_for_distance(distance)?)
    }
}

pub(crate) fn no_roots<R>() -> Result<R> {
    Err(Error::Fields { left: f64::NAME, right: Q::NAME })
}

impl Measured for Q {
    fn distance<C: Coeff<Self>>(_: &WeightPull<Self, C>) -> Result<Self> {
        no_roots()
    }

    fn fraction_of<C: Coeff<Self>>(_: &WeightPull<Self, C>, _: &Self) -> Result<Self> {
        no_roots()
    }

    fn weight_for_distance<C: Coeff<Self>>(_: &WeightPull<Self, C>, _: &Self) -> Result<Self> {
        no_roots()
    }
}

/// A pull, and the shapes it is for.
#[derive(Debug)]
pub(crate) struct For<T, S, P> {
    pub(crate) pull: P,
    pub(crate) shapes: PhantomData<fn(&S, &T)>,
}

impl<T: Measured, S: Shape<T> + Weighed<T>> Puller for For<T, S, WeightPull<T, S::Point>> {
    fn weight_and_share(&self) -> (Number, Number) {
        (self.pull.weight().clone().number(), self.pull.share().number())
    }

    fn points(&self) -> (Coords, Coords) {
        (coords::<T, _>(self.pull.point()), coords::<T, _>(self.pull.control_point()))
    }

    fn limits(&self) -> (Option<Number>, Option<Number>) {
        (self.pull.push_limit().map(Field::number), self.pull.pull_limit().map(Field::number))
    }

    fn weight_for(&self, fraction: &Number) -> Result<Number> {
        Ok(self.pull.weight_for(&T::of(fraction)?)?.number())
    }

    fn fraction_for(&self, weight: &Number) -> Result<Number> {
        Ok(self.pull.fraction_for(&T::of(weight)?)?.number())
    }

    fn fraction_near(&self, target: &Coords) -> Result<Number> {
        Ok(self.pull.fraction_near(&point(target)?).number())
    }

    fn point_at(&self, fraction: &Number) -> Result<Coords> {
        Ok(coords::<T, _>(&self.pull.point_at(&T::of(fraction)?)))
    }

    fn point_at_weight(&self, weight: &Number) -> Result<Coords> {
        Ok(coords::<T, _>(&self.pull.point_at_weight(&T::of(weight)?)?))
    }

    fn distance(&self) -> Result<Number> {
        Ok(T::distance(&self.pull)?.number())
    }

    fn fraction_of(&self, distance: &Number) -> Result<Number> {
        Ok(T::fraction_of(&self.pull, &T::of(distance)?)?.number())
    }

    fn weight_for_distance(&self, distance: &Number) -> Result<Number> {
        Ok(T::weight_for_distance(&self.pull, &T::of(distance)?)?.number())
    }

    fn applied(&self, shape: &Value, fraction: &Number) -> Result<Value> {
        Ok(self.pull.applied(S::inside(shape)?, &T::of(fraction)?)?.value())
    }
}

pub(crate) fn range<T: Field>((least, most): &(Number, Number)) -> Result<WeightRange<T>> {
    Ok(WeightRange::new(T::of(least)?, T::of(most)?)?)
}

fn pulled<T: Measured, S: Shape<T> + Weighed<T>>(
    pull: WeightPull<T, S::Point>,
    within: Option<&(Number, Number)>,
) -> Result<Box<dyn Puller>> {
    let pull = match within {
        Some(ends) => pull.within(range(ends)?),
        None => pull,
    };
    Ok(Box::new(For::<T, S, _> { pull, shapes: PhantomData }))
}

/// The pull of a point of a rational shape toward a control point; `within` are the least and the largest weight.
///
/// # Errors
/// [`Error::NoSuch`] for polynomial shapes, and those of [`WeightPull::new`].
pub fn pull(
    shape: &Value,
    at: &Coords,
    index: &[usize],
    within: Option<&(Number, Number)>,
) -> Result<Box<dyn Puller>> {
    fn of<T: Measured, S: Shape<T> + Weighed<T>>(
        shape: &S,
        at: &Coords,
        index: &[usize],
        within: Option<&(Number, Number)>,
    ) -> Result<Box<dyn Puller>> {
        pulled::<T, S>(WeightPull::new(shape, &place(at)?, Named::named(index)?)?, within)
    }
    shape!(rational shape, "pull by weights", T, s => of::<T, _>(s, at, index, within))
}

/// The pull toward a control point whose weight is zero, which becomes `control`; see [`WeightPull::from_zero`].
///
/// # Errors
/// As [`pull`].
pub fn pull_from_zero(
    shape: &Value,
    at: &Coords,
    index: &[usize],
    control: &Coords,
    within: Option<&(Number, Number)>,
) -> Result<Box<dyn Puller>> {
    fn of<T: Measured, S: Shape<T> + Weighed<T>>(
        shape: &S,
        at: &Coords,
        index: &[usize],
        control: &Coords,
        within: Option<&(Number, Number)>,
    ) -> Result<Box<dyn Puller>> {
        let pull = WeightPull::from_zero(shape, &place(at)?, Named::named(index)?, point(control)?)?;
        pulled::<T, S>(pull, within)
    }
    shape!(rational shape, "pull by weights", T, s => of::<T, _>(s, at, index, control, within))
}

/// The derivatives of a point by a weight, of order zero first; see [`Weighed::weight_derivatives`].
///
/// # Errors
/// As [`pull`].
pub fn derivatives(shape: &Value, at: &Coords, index: &[usize], order: usize) -> Result<Vec<Coords>> {
    fn of<T: Field, S: Shape<T> + Weighed<T>>(
        shape: &S,
        at: &Coords,
        index: &[usize],
        order: usize,
    ) -> Result<Vec<Coords>> {
        let flat = shape.flat(Named::named(index)?)?;
        let all = shape.weight_derivatives(&place(at)?, flat, order)?;
        Ok(all.iter().map(|d| coords::<T, _>(d)).collect())
    }
    shape!(rational shape, "derivative by weights", T, s => of::<T, _>(s, at, index, order))
}

/// The shape with other weights of some control points, which stay.
///
/// # Errors
/// As [`pull`].
pub fn set(shape: &Value, weights: &[(Vec<usize>, Number)]) -> Result<Value> {
    fn of<T: Field, S: Shape<T> + Weighed<T>>(shape: &S, weights: &[(Vec<usize>, Number)]) -> Result<Value> {
        let new = weights.iter().map(|(index, w)| Ok((shape.flat(S::Index::named(index)?)?, T::of(w)?)));
        let new = new.collect::<Result<Vec<_>>>()?;
        let mut shape = shape.clone();
        shape.set_weights(&new)?;
        Ok(shape.value())
    }
    shape!(rational shape, "weights", T, s => of::<T, _>(s, weights))
}
