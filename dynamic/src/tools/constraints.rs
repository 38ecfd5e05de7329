//! Constraints on points, derivatives and linear functionals of shapes.

use crate::error::Result;
use crate::family::AnySpline;
use crate::number::{Field, Number};
use crate::over::Coords;
use crate::shape;
use crate::tools::edit::AnyDrag;
use crate::tools::shape::{Named, Shape, all_named, all_points, place};
use crate::value::Value;
use std::fmt::Debug;
use symspline::{Constrained, Constraints, Direction, Drag, Excess, Relief, SparseRow};

/// A constrained value.
#[derive(Clone, Debug, PartialEq)]
pub enum Asked {
    /// A derivative at a place: of order zero the point.
    Derivative(Coords, Vec<usize>),
    /// A linear functional of the control points.
    Row(Vec<(usize, Number)>),
    /// All control points of the isocurve of a surface where the parameter in a direction is a number.
    Isocurve(Direction, Number),
    /// So many points along a curve in the parameters of a surface.
    Along(AnySpline, usize),
}

/// Constraints on a shape; see [`Constraints`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Wishes {
    /// The constrained values.
    pub asked: Vec<Asked>,
    /// Control points that must not move.
    pub holding: Vec<Vec<usize>>,
    /// The only control points that may move, if given.
    pub freeing: Option<Vec<Vec<usize>>>,
    /// How much the movements of control points count.
    pub weights: Vec<(Vec<usize>, Number)>,
    /// Whether what cannot be met together is met as nearly as possible.
    pub nearly: bool,
}

impl Wishes {
    /// The same constraints of a shape.
    pub(crate) fn on<'a, T: Field, S: Shape<T>>(&self, shape: &'a S) -> Result<Constraints<'a, T, S>> {
        let mut found = Constraints::on(shape);
        for asked in &self.asked {
            found = match asked {
                Asked::Derivative(at, order) if order.is_empty() => found.point(&place(at)?)?,
                Asked::Derivative(at, order) => found.derivative(&place(at)?, Named::named(order)?)?,
                Asked::Row(row) => {
                    let terms = row.iter().map(|(i, x)| Ok((*i, T::of(x)?))).collect::<Result<Vec<_>>>()?;
                    found.row(SparseRow::new(terms))?
                }
                Asked::Isocurve(direction, x) => S::with_isocurve(found, *direction, &T::of(x)?)?,
                Asked::Along(path, count) => S::with_points_along(found, path, *count)?,
            };
        }
        found = found.holding(&all_named(&self.holding)?)?;
        if let Some(free) = &self.freeing {
            found = found.freeing(&all_named(free)?)?;
        }
        for (index, weight) in &self.weights {
            found = found.weighing(Named::named(index)?, T::of(weight)?)?;
        }
        Ok(if self.nearly { found.with_excess(Excess::LeastSquares) } else { found })
    }
}

/// Rows of numbers: places in the list of control points, and their weights.
pub type Rows = Vec<Vec<(usize, Number)>>;

pub(crate) fn rows<'a, T: Field>(rows: impl Iterator<Item = &'a SparseRow<T>>) -> Rows {
    rows.map(|row| row.terms().iter().map(|(i, x)| (*i, x.clone().number())).collect()).collect()
}

/// Constraints with their matrix; see [`Constrained`].
pub trait Prepared: Debug + Send + Sync {
    /// The rows of the constraints.
    fn rows(&self) -> Rows;

    /// The matrix.
    fn matrix(&self) -> AnyDrag;

    /// The shape with the constrained values changed.
    ///
    /// # Errors
    /// Those of [`Constrained::dragged`].
    fn dragged(&self, shape: &Value, changes: &Coords) -> Result<Value>;

    /// The shape with the constrained values given.
    ///
    /// # Errors
    /// Those of [`Constrained::meet`].
    fn met(&self, shape: &Value, targets: &Coords) -> Result<Value>;
}

impl<T: Field, S: Shape<T>> Prepared for Constrained<T, S>
where
    AnyDrag: From<Drag<T>>,
{
    fn rows(&self) -> Rows {
        rows(Self::rows(self))
    }

    fn matrix(&self) -> AnyDrag {
        Self::matrix(self).clone().into()
    }

    fn dragged(&self, shape: &Value, changes: &Coords) -> Result<Value> {
        Ok(Self::dragged(self, S::inside(shape)?, &all_points(changes)?)?.value())
    }

    fn met(&self, shape: &Value, targets: &Coords) -> Result<Value> {
        let mut shape = S::inside(shape)?.clone();
        self.meet(&mut shape, &all_points(targets)?)?;
        Ok(shape.value())
    }
}

/// Constraints on a shape, prepared.
///
/// # Errors
/// [`Error::NoSuch`](crate::Error::NoSuch), [`Error::Dimensions`](crate::Error::Dimensions), and those of [`Constraints::prepare`].
pub fn constrained(shape: &Value, wishes: &Wishes) -> Result<Box<dyn Prepared>> {
    shape!(shape, "constraints", T, s => Ok(Box::new(wishes.on::<T, _>(s)?.prepare()?) as Box<dyn Prepared>))
}

/// The shape with more freedom where constraints need it, and the constraints prepared on that; see [`Constraints::relieved`].
///
/// # Errors
/// As [`constrained`].
pub fn relieved(shape: &Value, wishes: &Wishes, relief: Relief) -> Result<(Value, Box<dyn Prepared>)> {
    fn found<T: Field, S: Shape<T>>(
        shape: &S,
        wishes: &Wishes,
        relief: Relief,
    ) -> Result<(Value, Box<dyn Prepared>)>
    where
        AnyDrag: From<Drag<T>>,
    {
        let (finer, held) = wishes.on(shape)?.relieved(relief)?;
        Ok((finer.value(), Box::new(held)))
    }
    shape!(shape, "constraints", T, s => found::<T, _>(s, wishes, relief))
}
