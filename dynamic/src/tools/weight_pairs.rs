//! Weights moved: two at once.

use crate::error::Result;
use crate::number::{Field, Number};
use crate::over::Coords;
use crate::tools::shape::{Named, Shape, coords, place, point};
use crate::tools::weights::{For, no_roots, range};
use crate::value::Value;
use crate::{each, shape};
use std::fmt::Debug;
use std::marker::PhantomData;
use symspline::{Coeff, Controlled, Q, Weighed, WeightPairPull};

/// Moves by the weights of two control points; see [`WeightPairPull`].
pub trait PairPuller: Debug + Send + Sync {
    /// Weights and shares as they were.
    fn weights_and_shares(&self) -> [[Number; 2]; 2];
    /// The point, the base where both weights are zero, and the goal on the leg.
    fn points(&self) -> [Coords; 3];
    /// The least and the largest fraction of the way to the leg.
    fn limits(&self) -> (Number, Number);
    /// The weights that move the point by a fraction of the way to the leg.
    ///
    /// # Errors
    /// Those of [`WeightPairPull::weights_along`].
    fn weights_along(&self, fraction: &Number) -> Result<[Number; 2]>;
    /// The distance from the point to the leg, over floats.
    ///
    /// # Errors
    /// [`Error::Fields`](crate::Error::Fields).
    fn distance(&self) -> Result<Number>;
    /// The fraction of the way that a distance is, over floats.
    ///
    /// # Errors
    /// [`Error::Fields`](crate::Error::Fields).
    fn fraction_of(&self, distance: &Number) -> Result<Number>;
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

/// Distances of pulls, where the field has square roots.
trait Apart: Field {
    /// See [`WeightPairPull::distance`].
    fn distance<C: Coeff<Self>>(pull: &WeightPairPull<Self, C>) -> Result<Self>;
    /// See [`WeightPairPull::fraction_of`].
    fn fraction_of<C: Coeff<Self>>(pull: &WeightPairPull<Self, C>, distance: &Self) -> Result<Self>;
}

impl Apart for f64 {
    fn distance<C: Coeff<Self>>(pull: &WeightPairPull<Self, C>) -> Result<Self> {
        Ok(pull.distance())
    }

    fn fraction_of<C: Coeff<Self>>(pull: &WeightPairPull<Self, C>, distance: &Self) -> Result<Self> {
        Ok(pull.fraction_of(distance))
    }
}

impl Apart for Q {
    fn distance<C: Coeff<Self>>(_: &WeightPairPull<Self, C>) -> Result<Self> {
        no_roots()
    }

    fn fraction_of<C: Coeff<Self>>(_: &WeightPairPull<Self, C>, _: &Self) -> Result<Self> {
        no_roots()
    }
}

impl<T: Apart, S: Shape<T> + Weighed<T>> PairPuller for For<T, S, WeightPairPull<T, S::Point>> {
    fn weights_and_shares(&self) -> [[Number; 2]; 2] {
        [self.pull.weights(), self.pull.shares()].map(|pair| pair.clone().map(Field::number))
    }

    fn points(&self) -> [Coords; 3] {
        [self.pull.point(), self.pull.base(), &self.pull.goal()].map(|p| coords::<T, _>(p))
    }

    fn limits(&self) -> (Number, Number) {
        (self.pull.push_limit().number(), self.pull.pull_limit().number())
    }

    fn weights_along(&self, fraction: &Number) -> Result<[Number; 2]> {
        Ok(self.pull.weights_along(&T::of(fraction)?)?.map(Field::number))
    }

    fn distance(&self) -> Result<Number> {
        Ok(T::distance(&self.pull)?.number())
    }

    fn fraction_of(&self, distance: &Number) -> Result<Number> {
        Ok(T::fraction_of(&self.pull, &T::of(distance)?)?.number())
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

fn pulled<T: Apart, S: Shape<T> + Weighed<T>>(
    pull: WeightPairPull<T, S::Point>,
    within: Option<&(Number, Number)>,
) -> Result<Box<dyn PairPuller>> {
    let pull = match within {
        Some(ends) => pull.within(range(ends)?),
        None => pull,
    };
    Ok(Box::new(For::<T, S, _> { pull, shapes: PhantomData }))
}

/// The moves of a point of a rational shape by the weights of two control points.
///
/// # Errors
/// [`Error::NoSuch`](crate::Error::NoSuch) for polynomial shapes, and those of [`WeightPairPull::new`].
pub fn pull(
    shape: &Value,
    at: &Coords,
    picks: [&[usize]; 2],
    within: Option<&(Number, Number)>,
) -> Result<Box<dyn PairPuller>> {
    fn of<T: Apart, S: Shape<T> + Weighed<T>>(
        shape: &S,
        at: &Coords,
        [r, s]: [&[usize]; 2],
        within: Option<&(Number, Number)>,
    ) -> Result<Box<dyn PairPuller>> {
        pulled::<T, S>(WeightPairPull::new(shape, &place(at)?, [Named::named(r)?, Named::named(s)?])?, within)
    }
    shape!(rational shape, "pull by weights", T, s => of::<T, _>(s, at, picks, within))
}

/// The moves of a point of a rational curve by the weights at the ends of leg `k`; see [`WeightPairPull::on_leg`].
///
/// # Errors
/// [`Error::NoSuch`](crate::Error::NoSuch) for what is no rational curve, and those of [`WeightPairPull::on_leg`].
pub fn pull_on_leg(
    curve: &Value,
    x: &Number,
    k: usize,
    within: Option<&(Number, Number)>,
) -> Result<Box<dyn PairPuller>> {
    fn of<T: Apart, S>(
        curve: &S,
        x: &T,
        k: usize,
        within: Option<&(Number, Number)>,
    ) -> Result<Box<dyn PairPuller>>
    where
        S: Shape<T> + Weighed<T> + Controlled<T, Parameter = T, Index = usize>,
    {
        pulled::<T, S>(WeightPairPull::on_leg(curve, x, k)?, within)
    }
    match curve {
        Value::Rational(any) => each!(any, T, s => of(s, &T::of(x)?, k, within)),
        other => Err(other.none_of("leg, for a pull by weights,")),
    }
}
