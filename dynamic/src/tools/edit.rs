//! Control points moved.

use crate::error::{Error, Result};
use crate::number::{Field, Number, flat};
use crate::over::{Coords, Over};
use crate::shape;
use crate::tools::shape::{Named, Shape, all_points, coords, place, point};
use crate::value::Value;
use symspline::{Controlled, Direction, Drag, LegPoint, Q, confined};

/// What of two things over either field is over the field `T`.
pub trait Of<T> {
    /// Its type.
    type Inner;

    /// What is inside.
    ///
    /// # Errors
    /// [`Error::Fields`] if it is over the other field.
    fn of(&self) -> Result<&Self::Inner>;
}

impl<A, B> Of<f64> for Over<A, B> {
    type Inner = A;

    fn of(&self) -> Result<&A> {
        match self {
            Self::Float(inside) => Ok(inside),
            Self::Exact(_) => Err(Error::Fields { left: "float", right: "exact" }),
        }
    }
}

impl<A, B> Of<Q> for Over<A, B> {
    type Inner = B;

    fn of(&self) -> Result<&B> {
        match self {
            Self::Exact(inside) => Ok(inside),
            Self::Float(_) => Err(Error::Fields { left: "exact", right: "float" }),
        }
    }
}

/// A linear edit; see [`Drag`].
pub type AnyDrag = Over<Drag<f64>, Drag<Q>>;

impl From<Drag<f64>> for AnyDrag {
    fn from(drag: Drag<f64>) -> Self {
        Self::Float(drag)
    }
}

impl From<Drag<Q>> for AnyDrag {
    fn from(drag: Drag<Q>) -> Self {
        Self::Exact(drag)
    }
}

/// Which control points take a point along; see [`Drag`].
#[derive(Clone, Debug, PartialEq)]
pub enum Grip {
    /// One.
    One(Vec<usize>),
    /// Some, by shares of one vector.
    Shares(Vec<(Vec<usize>, Number)>),
    /// The one with the nearest node.
    Nearest,
    /// Those around, with shares along each direction if they are given.
    Neighbours(Option<Coords>),
}

fn gripped<T: Field, S: Shape<T>>(shape: &S, at: &Coords, grip: &Grip) -> Result<Drag<T>> {
    let at: S::Parameter = place(at)?;
    Ok(match grip {
        Grip::One(index) => Drag::by_one(shape, &at, Named::named(index)?)?,
        Grip::Shares(shares) => {
            let shares = shares.iter().map(|(index, share)| Ok((S::Index::named(index)?, T::of(share)?)));
            Drag::by_shares(shape, &at, &shares.collect::<Result<Vec<_>>>()?)?
        }
        Grip::Nearest => Drag::by_nearest(shape, &at)?,
        Grip::Neighbours(None) => Drag::by_neighbours(shape, &at, None)?,
        Grip::Neighbours(Some(gamma)) => Drag::by_neighbours(shape, &at, Some(&place(gamma)?))?,
    })
}

impl AnyDrag {
    /// The edit that moves the point at a place.
    ///
    /// # Errors
    /// [`Error::NoSuch`] for what has no control points, and those of [`Drag::by_shares`].
    pub fn of_point(shape: &Value, at: &Coords, grip: &Grip) -> Result<Self> {
        shape!(shape, "drag", T, s => { let _: Option<T>; Ok(gripped(s, at, grip)?.into()) })
    }

    /// The edited shape.
    ///
    /// # Errors
    /// [`Error::Fields`], [`Error::Torn`], and those of [`Drag::applied`].
    pub fn applied(&self, shape: &Value, by: &Coords) -> Result<Value> {
        fn applied<T: Field, S: Shape<T>>(drag: &Drag<T>, shape: &S, by: &Coords) -> Result<Value> {
            Ok(drag.applied(shape, &all_points(by)?)?.value())
        }
        shape!(shape, "drag", T, s => applied(Of::<T>::of(self)?, s, by))
    }
}

/// The shape with knots so that a place along a direction is the node of a control point confined to an interval; see [`confined`].
///
/// # Errors
/// [`Error::NoSuch`], and those of [`confined`].
pub fn confined_to(
    shape: &Value,
    direction: Direction,
    x: &Number,
    (start, end): (&Number, &Number),
) -> Result<(Value, usize)> {
    fn found<T: Field, S: Shape<T>>(
        shape: &S,
        direction: Direction,
        x: &T,
        (start, end): (T, T),
    ) -> Result<(Value, usize)> {
        let (finer, k) = confined(shape, direction, x, (&start, &end))?;
        Ok((finer.value(), k))
    }
    shape!(shape, "confining", T, s => found(s, direction, &T::of(x)?, (T::of(start)?, T::of(end)?)))
}

/// A point of a leg of the control polygon made a control point: the knot, the shape with it, the place of the control point; see
/// [`LegPoint`].
///
/// # Errors
/// [`Error::NoSuch`], and those of [`LegPoint::at`] and [`LegPoint::inserted`].
pub fn leg_point(
    shape: &Value,
    direction: Direction,
    index: &[usize],
    target: &Coords,
    tolerance: &Number,
) -> Result<(Number, Value, usize)> {
    fn found<T: Field, S: Shape<T>>(
        shape: &S,
        direction: Direction,
        index: &[usize],
        target: &Coords,
        tolerance: &T,
    ) -> Result<(Number, Value, usize)> {
        let leg = LegPoint::at(shape, direction, S::Index::named(index)?, &point(target)?, tolerance)?;
        let (finer, place) = leg.inserted(shape)?;
        Ok((leg.knot(shape)?.number(), finer.value(), place))
    }
    shape!(shape, "leg", T, s => found(s, direction, index, target, &T::of(tolerance)?))
}

/// The point of a shape at a place.
///
/// # Errors
/// [`Error::NoSuch`], [`Error::Dimensions`], and those of the library.
pub fn derivative_of(shape: &Value, at: &Coords, order: &[usize]) -> Result<Coords> {
    fn of<T: Field, S: Shape<T>>(s: &S, at: &Coords, order: &[usize]) -> Result<Coords> {
        let order = if order.is_empty() { S::VALUE } else { Named::named(order)? };
        Ok(coords::<T, _>(&s.derivative_of(&place(at)?, order)?))
    }
    shape!(shape, "point", T, s => of::<T, _>(s, at, order))
}

/// All control points of a shape.
///
/// # Errors
/// [`Error::NoSuch`], and those of the library.
pub fn control_points(shape: &Value) -> Result<Coords> {
    shape!(shape, "control points", T, s => Ok(flat::<T, _>(&s.control_points()?)))
}
