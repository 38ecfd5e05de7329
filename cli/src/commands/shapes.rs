//! Shapes with control points, polynomial and rational, curves and surfaces: what arguments mean for each.

use crate::failure::{Failure, Result};
use crate::numbers::{Index, List, One, Place};
use nalgebra::{SVector, vector};
use symspline::shape::flatten_region::Part;
use symspline::{Bump, Onto, Rational, Rectangle, Spline, TensorSpline, Workable};
use symspline_dynamic::operators::coefficient;
use symspline_dynamic::{Field, Value};

/// A shape whose control points are vectors, and what arguments mean for it.
pub trait Argued<T: Field, const N: usize>: Workable<T, Point = SVector<T, N>> {
    /// The place `u`, or `u:v`.
    fn parameter(place: &Place) -> Result<Self::Parameter>;

    /// The control point `i`, or `i:j`.
    fn index(index: &Index) -> Result<Self::Index>;

    /// The derivative `k`, or `k:l`.
    fn order(order: &Index) -> Result<Self::Order>;

    /// The height of a bump at shares of the way.
    fn height(bump: &Bump<T>, share: &Self::Parameter) -> T;

    /// The part of the domain between two places.
    fn part(from: Self::Parameter, to: Self::Parameter) -> Part<T>;

    /// The line or plane through a point.
    fn onto(point: &List, direction: Option<&List>, normal: Option<&List>) -> Result<Onto<T, N>>;

    /// A vector.
    fn vector(list: &List) -> Result<SVector<T, N>> {
        Ok(coefficient::<T, SVector<T, N>>(&list.coords())?)
    }
}

/// The numbers of an argument, if there are as many as the shape has parameters.
fn counted<X, const D: usize>(parts: &[X], what: &str, form: &str) -> Result<[X; D]>
where
    X: Clone,
{
    let refused = |_| Failure::Usage(format!("{what} is {form} here"));
    <[X; D]>::try_from(parts.to_vec()).map_err(refused)
}

/// Vectors onto whose lines and planes points are projected.
pub trait Projected<T: Field, const N: usize> {
    /// The line or plane through a point.
    fn onto(point: &List, direction: Option<&List>, normal: Option<&List>) -> Result<Onto<T, N>>;
}

fn no_direction<X>() -> Result<X> {
    Err(Failure::Usage("--direction or --normal is needed".to_owned()))
}

impl<T: Field> Projected<T, 2> for SVector<T, 2> {
    fn onto(point: &List, direction: Option<&List>, normal: Option<&List>) -> Result<Onto<T, 2>> {
        let read = |list: &List| coefficient::<T, Self>(&list.coords());
        let direction = match (direction, normal) {
            (Some(direction), _) => read(direction)?,
            (_, Some(normal)) => {
                let normal = read(normal)?;
                vector![normal[1].clone(), -normal[0].clone()]
            }
            _ => return no_direction(),
        };
        Ok(Onto::<T, 2>::line(read(point)?, direction)?)
    }
}

impl<T: Field> Projected<T, 3> for SVector<T, 3> {
    fn onto(point: &List, direction: Option<&List>, normal: Option<&List>) -> Result<Onto<T, 3>> {
        let read = |list: &List| coefficient::<T, Self>(&list.coords());
        Ok(match (direction, normal) {
            (Some(direction), _) => Onto::<T, 3>::space_line(read(point)?, read(direction)?)?,
            (_, Some(normal)) => Onto::<T, 3>::plane(read(point)?, read(normal)?)?,
            _ => return no_direction(),
        })
    }
}

macro_rules! argued {
    (curve: $shape:ty) => {
        impl<T: Field, const N: usize> Argued<T, N> for $shape
        where
            SVector<T, N>: Projected<T, N>,
        {
            fn parameter(place: &Place) -> Result<T> {
                let [x] = counted(&place.0, "a place", "'u'")?;
                Ok(One(x).of()?)
            }

            fn index(index: &Index) -> Result<usize> {
                let [i] = counted(&index.0, "a control point", "'i'")?;
                Ok(i)
            }

            fn order(order: &Index) -> Result<usize> {
                let [k] = counted(&order.0, "an order", "'k'")?;
                Ok(k)
            }

            fn height(bump: &Bump<T>, share: &T) -> T {
                bump.at(share)
            }

            fn part(from: T, to: T) -> Part<T> {
                (from, to).into()
            }

            fn onto(point: &List, direction: Option<&List>, normal: Option<&List>) -> Result<Onto<T, N>> {
                <SVector<T, N> as Projected<T, N>>::onto(point, direction, normal)
            }
        }
    };
    (surface: $shape:ty) => {
        impl<T: Field, const N: usize> Argued<T, N> for $shape
        where
            SVector<T, N>: Projected<T, N>,
        {
            fn parameter(place: &Place) -> Result<(T, T)> {
                let [u, v] = counted(&place.0, "a place", "'u:v'")?;
                Ok((One(u).of()?, One(v).of()?))
            }

            fn index(index: &Index) -> Result<(usize, usize)> {
                let [i, j] = counted(&index.0, "a control point", "'i:j'")?;
                Ok((i, j))
            }

            fn order(order: &Index) -> Result<(usize, usize)> {
                let [k, l] = counted(&order.0, "an order", "'k:l'")?;
                Ok((k, l))
            }

            fn height(bump: &Bump<T>, share: &(T, T)) -> T {
                bump.at_pair(share)
            }

            fn part(from: (T, T), to: (T, T)) -> Part<T> {
                [(from.0, to.0), (from.1, to.1)].into()
            }

            fn onto(point: &List, direction: Option<&List>, normal: Option<&List>) -> Result<Onto<T, N>> {
                <SVector<T, N> as Projected<T, N>>::onto(point, direction, normal)
            }
        }
    };
}

argued!(curve: Spline<T, SVector<T, N>>);
argued!(curve: Rational<symspline::Interval, T, SVector<T, N>>);
argued!(surface: TensorSpline<T, SVector<T, N>>);
argued!(surface: Rational<Rectangle, T, SVector<T, N>>);

/// One text for each field and dimension with points; for numbers the other text.
macro_rules! each_points {
    ($any:expr, $s:ident => $body:expr, $other:expr) => {
        match $any {
            symspline_dynamic::Any::F2($s) => $body,
            symspline_dynamic::Any::F3($s) => $body,
            symspline_dynamic::Any::Q2($s) => $body,
            symspline_dynamic::Any::Q3($s) => $body,
            symspline_dynamic::Any::F1(_) | symspline_dynamic::Any::Q1(_) => $other,
        }
    };
}
pub(crate) use each_points;

/// Something that makes a shape of a shape.
pub trait Tool {
    /// The shape that it makes.
    fn applied<T: Field, const N: usize, S: Argued<T, N>>(&self, shape: &S) -> Result<S>;
}

/// What a tool makes of a curve or surface.
pub fn apply(tool: &impl Tool, value: &Value) -> Result<Value> {
    let refused = || Err(not_a_shape(value));
    match value {
        Value::Spline(any) => each_points!(any, s => Ok(Value::Spline(tool.applied(s)?.into())), refused()),
        Value::Surface(any) => each_points!(any, s => Ok(Value::Surface(tool.applied(s)?.into())), refused()),
        Value::Rational(any) => {
            each_points!(any, s => Ok(Value::Rational(tool.applied(s)?.into())), refused())
        }
        Value::RationalSurface(any) => {
            each_points!(any, s => Ok(Value::RationalSurface(tool.applied(s)?.into())), refused())
        }
        _ => refused(),
    }
}

/// That a curve or surface is needed.
pub fn not_a_shape(value: &Value) -> Failure {
    Failure::refused(format!("a curve or surface is expected, not a {}", value.kind()))
}
