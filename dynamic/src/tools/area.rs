//! Areas of the parameter plane, and how they are cut into cells.

use crate::any::Any;
use crate::error::Result;
use crate::number::{Field, Number};
use crate::over::Coords;
use crate::tools::shape::{all_points, place};
use crate::value::Value;
use nalgebra::SVector;
use symspline::{Area, Cells, Polygons, Q};

/// An area of the parameter plane; see [`Area`].
#[derive(Clone, Debug, PartialEq)]
pub enum AnyArea {
    /// The rectangle between two opposite corners.
    Rectangle(Coords, Coords),
    /// Inside a closed polygon, corner by corner.
    Polygon(Coords),
    /// Inside a closed curve, over floats.
    Inside(Value),
    /// What lies in an odd number of areas.
    Odd(Vec<AnyArea>),
}

impl AnyArea {
    /// The same with its curves, if any, as another text has them.
    pub(crate) fn with(&self, change: &impl Fn(&Value) -> Result<Value>) -> Result<Self> {
        Ok(match self {
            Self::Inside(curve) => Self::Inside(change(curve)?),
            Self::Odd(all) => Self::Odd(all.iter().map(|one| one.with(change)).collect::<Result<_>>()?),
            straight => straight.clone(),
        })
    }

    pub(crate) fn of<T: Bounded>(&self) -> Result<Inside<T>> {
        let polygon = |corners: Vec<(T, T)>| Ok(Inside::Polygon(Polygons::new([corners])?));
        match self {
            Self::Rectangle(low, high) => {
                let ((a, c), (b, d)): ((T, T), (T, T)) = (place(low)?, place(high)?);
                let corners = [(&a, &c), (&b, &c), (&b, &d), (&a, &d)];
                polygon(corners.map(|(u, v)| (u.clone(), v.clone())).to_vec())
            }
            Self::Polygon(corners) => {
                let corners: Vec<SVector<T, 2>> = all_points(corners)?;
                polygon(corners.into_iter().map(|c| (c[0].clone(), c[1].clone())).collect())
            }
            Self::Inside(curve) => T::inside(curve).map(Inside::Curve),
            Self::Odd(all) => all.iter().map(Self::of).collect::<Result<_>>().map(Inside::Odd),
        }
    }
}

/// An area over a field.
pub(crate) enum Inside<T> {
    Polygon(Polygons<T>),
    Curve(Box<dyn Area<T>>),
    Odd(Vec<Inside<T>>),
}

impl<T: Field> Area<T> for Inside<T> {
    fn bounds(&self) -> symspline::Result<[(T, T); 2]> {
        match self {
            Self::Polygon(polygon) => polygon.bounds(),
            Self::Curve(curve) => curve.bounds(),
            Self::Odd(all) => all[..].bounds(),
        }
    }

    fn inside(&self, us: &[T], v: &T) -> symspline::Result<Vec<bool>> {
        match self {
            Self::Polygon(polygon) => polygon.inside(us, v),
            Self::Curve(curve) => curve.inside(us, v),
            Self::Odd(all) => all[..].inside(us, v),
        }
    }
}

/// A field whose curves may bound areas.
pub(crate) trait Bounded: Field {
    /// What is inside a closed curve.
    fn inside(curve: &Value) -> Result<Box<dyn Area<Self>>>;
}

impl Bounded for f64 {
    fn inside(curve: &Value) -> Result<Box<dyn Area<Self>>> {
        match curve {
            Value::Spline(Any::F2(curve)) => Ok(Box::new(curve.clone())),
            Value::Rational(Any::F2(curve)) => Ok(Box::new(curve.clone())),
            other => Err(other.none_of("area inside")),
        }
    }
}

impl Bounded for Q {
    fn inside(curve: &Value) -> Result<Box<dyn Area<Self>>> {
        Err(curve.none_of("area inside, but over floats,"))
    }
}

/// Into how many cells the box around an area is cut; see [`Cells`].
#[derive(Clone, Debug, PartialEq)]
pub enum AnyCells {
    /// So many along `u` and along `v`.
    Counts(usize, usize),
    /// As few as it takes that none is longer.
    Spacing(Number),
}

impl AnyCells {
    pub(crate) fn of<T: Field>(&self) -> Result<Cells<T>> {
        Ok(match self {
            Self::Counts(u, v) => Cells::Counts(*u, *v),
            Self::Spacing(length) => Cells::Spacing(T::of(length)?),
        })
    }
}
