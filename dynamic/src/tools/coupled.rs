//! Constraints that tie coordinates together.

use crate::any::Any;
use crate::error::{Error, Result};
use crate::number::{Field, Number};
use crate::over::Coords;
use crate::shape;
use crate::tools::constraints::Wishes;
use crate::tools::shape::{Named, Shape, all_points, place, point};
use crate::value::Value;
use nalgebra::SVector;
use std::fmt::Debug;
use std::marker::PhantomData;
use symspline::{Controlled, Coupled, CoupledDrag, SparseRow};

/// A constraint that takes one number; see [`Coupled`].
#[derive(Clone, Debug, PartialEq)]
pub enum Tie {
    /// The component of a derivative along a vector: place, order, vector.
    Along(Coords, Vec<usize>, Coords),
    /// A linear functional of all coordinates: their places in the list, and weights.
    Components(Vec<(usize, Number)>),
    /// The area that a plane curve sweeps.
    Area,
}

/// Constraints that tie coordinates together, with their matrix; see [`CoupledDrag`].
pub trait Tied: Debug + Send + Sync {
    /// The shape with the constrained vectors and numbers changed.
    ///
    /// # Errors
    /// Those of [`CoupledDrag::dragged`].
    fn dragged(&self, shape: &Value, vectors: &Coords, numbers: &Coords) -> Result<Value>;
}

/// The matrix, and the shapes it is for.
#[derive(Debug)]
struct For<T, S, const N: usize> {
    drag: CoupledDrag<T, N>,
    shapes: PhantomData<fn(&S)>,
}

impl<T: Field, S, const N: usize> Tied for For<T, S, N>
where
    SVector<T, N>: crate::number::Flat<T>,
    S: Shape<T> + Controlled<T, Point = SVector<T, N>>,
{
    fn dragged(&self, shape: &Value, vectors: &Coords, numbers: &Coords) -> Result<Value> {
        let vectors: Vec<SVector<T, N>> = all_points(vectors)?;
        Ok(self.drag.dragged(S::inside(shape)?, &vectors, &T::all_of(numbers)?)?.value())
    }
}

/// Constraints on vectors, and further ones that each take one number, prepared.
///
/// # Errors
/// [`Error::NoSuch`] for functions, and for the area of what is no polynomial plane curve; [`Error::Dimensions`]; those of
/// [`Coupled::prepare`].
pub fn coupled(shape: &Value, wishes: &Wishes, ties: &[Tie]) -> Result<Box<dyn Tied>> {
    fn of<'a, T: Field, S, const N: usize>(
        shape: &'a S,
        wishes: &Wishes,
        ties: &[Tie],
        area: impl Fn(Coupled<'a, T, S, N>) -> Result<Coupled<'a, T, S, N>>,
    ) -> Result<Box<dyn Tied>>
    where
        SVector<T, N>: crate::number::Flat<T>,
        S: Shape<T> + Controlled<T, Point = SVector<T, N>>,
    {
        let mut found = wishes.on(shape)?.coupled();
        for tie in ties {
            found = match tie {
                Tie::Along(at, order, n) => {
                    let order = if order.is_empty() { S::VALUE } else { Named::named(order)? };
                    found.along(&place(at)?, order, &point(n)?)?
                }
                Tie::Components(row) => {
                    let terms = row.iter().map(|(i, x)| Ok((*i, T::of(x)?))).collect::<Result<Vec<_>>>()?;
                    found.components(SparseRow::new(terms))?
                }
                Tie::Area => area(found)?,
            };
        }
        Ok(Box::new(For::<T, S, N> { drag: found.prepare()?, shapes: PhantomData }))
    }
    let none = || -> Error { shape.none_of("area swept by") };
    match shape {
        Value::Spline(Any::F2(s)) => of(s, wishes, ties, |c| Ok(c.area()?)),
        Value::Spline(Any::Q2(s)) => of(s, wishes, ties, |c| Ok(c.area()?)),
        _ => shape!(in space shape, "coupled constraints", T, s => {
            let _: Option<T>;
            of(s, wishes, ties, |_| Err(none()))
        }),
    }
}
