//! What tools ask of shapes: [`Shape`], and [`shape!`](crate::shape) for one text for all.

use crate::any::Any;
use crate::error::{Error, Result};
use crate::family::AnySpline;
use crate::number::{Field, Flat, points};
use crate::over::Coords;
use crate::value::Value;
use nalgebra::SVector;
use symspline::{
    Coeff, Constraints, Controlled, Direction, Interval, Q, Rational, Rectangle, Restorable, Scalar, Spline,
    TensorSpline, Workable,
};

/// A place on a shape, from numbers: one of a curve, two of a surface.
pub trait At<T>: Sized {
    /// The place.
    ///
    /// # Errors
    /// [`Error::Dimensions`] for another number of numbers.
    fn at(numbers: &[T]) -> Result<Self>;

    /// The numbers.
    fn numbers(&self) -> Vec<T>;
}

impl<T: Field> At<T> for T {
    fn at(numbers: &[T]) -> Result<Self> {
        match numbers {
            [x] => Ok(x.clone()),
            _ => Err(Error::Dimensions { left: 1, right: numbers.len() }),
        }
    }

    fn numbers(&self) -> Vec<T> {
        vec![self.clone()]
    }
}

impl<T: Field> At<T> for (T, T) {
    fn at(numbers: &[T]) -> Result<Self> {
        match numbers {
            [u, v] => Ok((u.clone(), v.clone())),
            _ => Err(Error::Dimensions { left: 2, right: numbers.len() }),
        }
    }

    fn numbers(&self) -> Vec<T> {
        vec![self.0.clone(), self.1.clone()]
    }
}

/// The name of a control point, or an order of derivatives: one number of a curve, two of a surface.
pub trait Named: Sized + Send + Sync + 'static {
    /// What these numbers name.
    ///
    /// # Errors
    /// [`Error::Dimensions`] for another number of numbers.
    fn named(numbers: &[usize]) -> Result<Self>;
}

impl Named for usize {
    fn named(numbers: &[usize]) -> Result<Self> {
        match *numbers {
            [k] => Ok(k),
            _ => Err(Error::Dimensions { left: 1, right: numbers.len() }),
        }
    }
}

impl Named for (usize, usize) {
    fn named(numbers: &[usize]) -> Result<Self> {
        match *numbers {
            [k, l] => Ok((k, l)),
            _ => Err(Error::Dimensions { left: 2, right: numbers.len() }),
        }
    }
}

/// A shape inside a [`Value`]: a function, curve or surface, polynomial or rational.
pub trait Shape<T: Field>:
    Controlled<T, Point: Flat<T> + Send + Sync, Parameter: At<T> + Send + Sync, Index: Named, Order: Named>
    + Workable<T>
    + Restorable<T, Stored: Send + Sync>
    + Send
    + Sync
    + 'static
{
    /// What is inside a value, if it is of this type.
    ///
    /// # Errors
    /// [`Error::NoSuch`].
    fn inside(value: &Value) -> Result<&Self>;

    /// As a value.
    fn value(self) -> Value;

    /// Adds the constraints on a whole isocurve of a surface; see [`Constraints::isocurve`].
    ///
    /// # Errors
    /// [`Error::NoSuch`] for what is no surface, and those of [`Constraints::isocurve`].
    fn with_isocurve<'a>(
        constraints: Constraints<'a, T, Self>,
        direction: Direction,
        x: &T,
    ) -> Result<Constraints<'a, T, Self>> {
        let _ = (constraints, direction, x);
        Err(no_plane("isocurve"))
    }

    /// Adds constraints on points along a curve in the parameters of a surface; see [`Constraints::along`].
    ///
    /// # Errors
    /// [`Error::NoSuch`] for what is no surface, or no curve in the plane, and those of [`Constraints::along`].
    fn with_points_along<'a>(
        constraints: Constraints<'a, T, Self>,
        path: &AnySpline,
        count: usize,
    ) -> Result<Constraints<'a, T, Self>> {
        let _ = (constraints, path, count);
        Err(no_plane("curve in the parameters"))
    }
}

fn no_plane(operation: &'static str) -> Error {
    Error::NoSuch { operation, left: String::from("a shape of one parameter"), right: String::new() }
}

macro_rules! shapes {
    (@plane Spline $T:ty) => {};
    (@plane Rational $T:ty) => {};
    (@plane $surface:ident $T:ty) => {
        fn with_isocurve<'a>(
            constraints: Constraints<'a, $T, Self>,
            direction: Direction,
            x: &$T,
        ) -> Result<Constraints<'a, $T, Self>> {
            Ok(constraints.isocurve(direction, x)?)
        }

        fn with_points_along<'a>(
            constraints: Constraints<'a, $T, Self>,
            path: &AnySpline,
            count: usize,
        ) -> Result<Constraints<'a, $T, Self>> {
            let path = Value::from(if <$T as Scalar>::EXACT { path.to_exact()? } else { path.to_float()? });
            Ok(constraints.along(Spline::<$T, P<$T, 2>>::inside(&path)?, count)?)
        }
    };
    ($kind:ident: $($variant:ident $T:ty, $of:ty;)+) => {
        $(impl Shape<$T> for $of {
            fn inside(value: &Value) -> Result<&Self> {
                match value {
                    Value::$kind(Any::$variant(inside)) => Ok(inside),
                    other => Err(Error::NoSuch {
                        operation: "use of a prepared tool for another kind of shape,",
                        left: format!("{} {} of {} dimensions", other.field(), other.kind(), other.dim()),
                        right: String::new(),
                    }),
                }
            }

            fn value(self) -> Value {
                Value::$kind(Any::$variant(self))
            }

            shapes!(@plane $kind $T);
        })+
    };
}

type P<T, const N: usize> = SVector<T, N>;

shapes! { Spline: F1 f64, Spline<f64, f64>; F2 f64, Spline<f64, P<f64, 2>>; F3 f64, Spline<f64, P<f64, 3>>;
Q1 Q, Spline<Q, Q>; Q2 Q, Spline<Q, P<Q, 2>>; Q3 Q, Spline<Q, P<Q, 3>>; }
shapes! { Surface: F1 f64, TensorSpline<f64, f64>; F2 f64, TensorSpline<f64, P<f64, 2>>; F3 f64, TensorSpline<f64, P<f64, 3>>;
Q1 Q, TensorSpline<Q, Q>; Q2 Q, TensorSpline<Q, P<Q, 2>>; Q3 Q, TensorSpline<Q, P<Q, 3>>; }
shapes! { Rational: F1 f64, Rational<Interval, f64, f64>; F2 f64, Rational<Interval, f64, P<f64, 2>>;
F3 f64, Rational<Interval, f64, P<f64, 3>>; Q1 Q, Rational<Interval, Q, Q>;
Q2 Q, Rational<Interval, Q, P<Q, 2>>; Q3 Q, Rational<Interval, Q, P<Q, 3>>; }
shapes! { RationalSurface: F1 f64, Rational<Rectangle, f64, f64>; F2 f64, Rational<Rectangle, f64, P<f64, 2>>;
F3 f64, Rational<Rectangle, f64, P<f64, 3>>; Q1 Q, Rational<Rectangle, Q, Q>;
Q2 Q, Rational<Rectangle, Q, P<Q, 2>>; Q3 Q, Rational<Rectangle, Q, P<Q, 3>>; }

/// One text for the shapes in a [`Value`](crate::Value): `shape!(value, "pull", T, s => ...)` has `s` what is inside and `T` its
/// field. With `in space` in front it is for curves and surfaces in two and three dimensions alone, not for functions.
#[macro_export]
macro_rules! shape {
    (in space $value:expr, $operation:expr, $T:ident, $s:ident => $body:expr) => {
        match $value {
            $crate::Value::Spline(any) => $crate::each_curve!(any, $T, $s => $body, Err($value.none_of($operation).into())),
            $crate::Value::Surface(any) => $crate::each_curve!(any, $T, $s => $body, Err($value.none_of($operation).into())),
            $crate::Value::Rational(any) => $crate::each_curve!(any, $T, $s => $body, Err($value.none_of($operation).into())),
            $crate::Value::RationalSurface(any) => $crate::each_curve!(any, $T, $s => $body, Err($value.none_of($operation).into())),
            _ => Err($value.none_of($operation).into()),
        }
    };
    (rational $value:expr, $operation:expr, $T:ident, $s:ident => $body:expr) => {
        match $value {
            $crate::Value::Rational(any) => $crate::each!(any, $T, $s => $body),
            $crate::Value::RationalSurface(any) => $crate::each!(any, $T, $s => $body),
            _ => Err($value.none_of($operation).into()),
        }
    };
    (curve $value:expr, $operation:expr, $T:ident, $s:ident => $body:expr) => {
        match $value {
            $crate::Value::Spline(any) => $crate::each!(any, $T, $s => $body),
            $crate::Value::Rational(any) => $crate::each!(any, $T, $s => $body),
            _ => Err($value.none_of($operation).into()),
        }
    };
    ($value:expr, $operation:expr, $T:ident, $s:ident => $body:expr) => {
        match $value {
            $crate::Value::Spline(any) => $crate::each!(any, $T, $s => $body),
            $crate::Value::Surface(any) => $crate::each!(any, $T, $s => $body),
            $crate::Value::Rational(any) => $crate::each!(any, $T, $s => $body),
            $crate::Value::RationalSurface(any) => $crate::each!(any, $T, $s => $body),
            _ => Err($value.none_of($operation).into()),
        }
    };
}

impl Value {
    /// That there is no such operation of this value.
    #[doc(hidden)]
    pub fn none_of(&self, operation: &'static str) -> Error {
        let left = format!("{} {}", self.field(), self.kind());
        Error::NoSuch { operation, left, right: String::new() }
    }
}

/// A place from numbers of either field.
///
/// # Errors
/// [`Error::Dimensions`].
pub fn place<T: Field, P: At<T>>(numbers: &Coords) -> Result<P> {
    P::at(&T::all_of(numbers)?)
}

/// A point from numbers of either field.
///
/// # Errors
/// [`Error::Dimensions`].
pub fn point<T: Field, C: Flat<T>>(numbers: &Coords) -> Result<C> {
    C::from_coords(&T::all_of(numbers)?)
}

/// Points from numbers of either field.
///
/// # Errors
/// [`Error::Torn`].
pub fn all_points<T: Field, C: Flat<T>>(numbers: &Coords) -> Result<Vec<C>> {
    points(&T::all_of(numbers)?)
}

/// The coordinates of a point.
pub fn coords<T: Field, C: Coeff<T>>(point: &C) -> Coords {
    T::coords(point.components().cloned().collect())
}

/// Names of several control points.
///
/// # Errors
/// [`Error::Dimensions`].
pub fn all_named<N: Named>(names: &[Vec<usize>]) -> Result<Vec<N>> {
    names.iter().map(|name| N::named(name)).collect()
}
