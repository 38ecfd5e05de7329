//! Weights moved: pulls toward one control point or two.

use crate::error::Result;
use crate::number::{Field, Number};
use crate::over::Coords;
use crate::shape;
use crate::tools::shape::{Named, Shape, coords, place, point};
use crate::value::Value;
use std::fmt::Debug;
use std::marker::PhantomData;
use symspline::{Weighed, WeightPairPull, WeightPull, WeightRange};

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
    /// [`Error::Dimensions`](crate::Error::Dimensions).
    fn fraction_near(&self, target: &Coords) -> Result<Number>;
    /// The shape with its point moved.
    ///
    /// # Errors
    /// Those of [`WeightPull::applied`].
    fn applied(&self, shape: &Value, fraction: &Number) -> Result<Value>;
}

/// A pull, and the shapes it is for.
#[derive(Debug)]
struct For<T, S, P> {
    pull: P,
    shapes: PhantomData<fn(&S, &T)>,
}

impl<T: Field, S: Shape<T> + Weighed<T>> Puller for For<T, S, WeightPull<T, S::Point>> {
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

    fn applied(&self, shape: &Value, fraction: &Number) -> Result<Value> {
        Ok(self.pull.applied(S::inside(shape)?, &T::of(fraction)?)?.value())
    }
}

fn range<T: Field>((least, most): &(Number, Number)) -> Result<WeightRange<T>> {
    Ok(WeightRange::new(T::of(least)?, T::of(most)?)?)
}

/// The pull of a point of a rational shape toward a control point; `within` are the least and the largest weight.
///
/// # Errors
/// [`Error::NoSuch`](crate::Error::NoSuch) for polynomial shapes, and those of [`WeightPull::new`].
pub fn pull(
    shape: &Value,
    at: &Coords,
    index: &[usize],
    within: Option<&(Number, Number)>,
) -> Result<Box<dyn Puller>> {
    fn of<T: Field, S: Shape<T> + Weighed<T>>(
        shape: &S,
        at: &Coords,
        index: &[usize],
        within: Option<&(Number, Number)>,
    ) -> Result<Box<dyn Puller>> {
        let pull = WeightPull::new(shape, &place(at)?, Named::named(index)?)?;
        let pull = match within {
            Some(ends) => pull.within(range(ends)?),
            None => pull,
        };
        Ok(Box::new(For::<T, S, _> { pull, shapes: PhantomData }))
    }
    shape!(rational shape, "pull by weights", T, s => of::<T, _>(s, at, index, within))
}

/// Moves by the weights of two control points; see [`WeightPairPull`].
pub trait PairPuller: Debug + Send + Sync {
    /// Weights and shares as they were.
    fn weights_and_shares(&self) -> [[Number; 2]; 2];
    /// The point, the base where both weights are zero, and the goal on the leg.
    fn points(&self) -> [Coords; 3];
    /// The barycentric coordinates of a target.
    ///
    /// # Errors
    /// Those of [`WeightPairPull::coordinates`].
    fn coordinates(&self, target: &Coords, tolerance: &Number) -> Result<[Number; 2]>;
    /// The weights that move the point to a target.
    ///
    /// # Errors
    /// Those of [`WeightPairPull::weights_for`].
    fn weights_for(&self, target: &Coords, tolerance: &Number) -> Result<[Number; 2]>;
    /// The shape with its point at a target.
    ///
    /// # Errors
    /// Those of [`WeightPairPull::apply_to`].
    fn moved_to(&self, shape: &Value, target: &Coords, tolerance: &Number) -> Result<Value>;
    /// The shape with its point moved by a fraction of the way to the leg.
    ///
    /// # Errors
    /// Those of [`WeightPairPull::apply_along`].
    fn moved_along(&self, shape: &Value, fraction: &Number) -> Result<Value>;
}

impl<T: Field, S: Shape<T> + Weighed<T>> PairPuller for For<T, S, WeightPairPull<T, S::Point>> {
    fn weights_and_shares(&self) -> [[Number; 2]; 2] {
        [self.pull.weights(), self.pull.shares()].map(|pair| pair.clone().map(Field::number))
    }

    fn points(&self) -> [Coords; 3] {
        [self.pull.point(), self.pull.base(), &self.pull.goal()].map(|p| coords::<T, _>(p))
    }

    fn coordinates(&self, target: &Coords, tolerance: &Number) -> Result<[Number; 2]> {
        Ok(self.pull.coordinates(&point(target)?, &T::of(tolerance)?)?.map(Field::number))
    }

    fn weights_for(&self, target: &Coords, tolerance: &Number) -> Result<[Number; 2]> {
        Ok(self.pull.weights_for(&point(target)?, &T::of(tolerance)?)?.map(Field::number))
    }

    fn moved_to(&self, shape: &Value, target: &Coords, tolerance: &Number) -> Result<Value> {
        let mut shape = S::inside(shape)?.clone();
        self.pull.apply_to(&mut shape, &point(target)?, &T::of(tolerance)?)?;
        Ok(shape.value())
    }

    fn moved_along(&self, shape: &Value, fraction: &Number) -> Result<Value> {
        let mut shape = S::inside(shape)?.clone();
        self.pull.apply_along(&mut shape, &T::of(fraction)?)?;
        Ok(shape.value())
    }
}

/// The moves of a point of a rational shape by the weights of two control points.
///
/// # Errors
/// As [`pull`].
pub fn pair_pull(
    shape: &Value,
    at: &Coords,
    picks: [&[usize]; 2],
    within: Option<&(Number, Number)>,
) -> Result<Box<dyn PairPuller>> {
    fn of<T: Field, S: Shape<T> + Weighed<T>>(
        shape: &S,
        at: &Coords,
        [r, s]: [&[usize]; 2],
        within: Option<&(Number, Number)>,
    ) -> Result<Box<dyn PairPuller>> {
        let pull = WeightPairPull::new(shape, &place(at)?, [Named::named(r)?, Named::named(s)?])?;
        let pull = match within {
            Some(ends) => pull.within(range(ends)?),
            None => pull,
        };
        Ok(Box::new(For::<T, S, _> { pull, shapes: PhantomData }))
    }
    shape!(rational shape, "pull by weights", T, s => of::<T, _>(s, at, picks, within))
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
