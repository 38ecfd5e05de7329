//! Zeros of functions, and places on curves that are zeros.

use crate::Any;
use crate::error::Result;
use crate::number::{Field, Number};
use crate::over::Coords;
use crate::tools::shape::point;
use crate::value::Value;
use std::cmp::Ordering;
use symspline::{Crossings, Place, Q, Zero};

/// One text for curves over floats, polynomial and rational.
macro_rules! float_curve {
    ($value:expr, $operation:expr, $c:ident => $body:expr) => {
        match $value {
            $crate::Value::Spline($crate::Any::F2($c)) => $body,
            $crate::Value::Spline($crate::Any::F3($c)) => $body,
            $crate::Value::Rational($crate::Any::F2($c)) => $body,
            $crate::Value::Rational($crate::Any::F3($c)) => $body,
            other => Err(other.none_of($operation)),
        }
    };
}

/// One text for curves over both fields, polynomial and rational.
macro_rules! any_curve {
    ($value:expr, $operation:expr, $T:ident, $c:ident => $body:expr) => {
        match $value {
            $crate::Value::Spline(any) => $crate::each_curve!(any, $T, $c => $body, Err($value.none_of($operation))),
            $crate::Value::Rational(any) => $crate::each_curve!(any, $T, $c => $body, Err($value.none_of($operation))),
            other => Err(other.none_of($operation)),
        }
    };
}
pub(crate) use {any_curve, float_curve};

/// Where something is: between two parameters, which are equal where it is known; or all along.
#[derive(Clone, Debug, PartialEq)]
pub struct Spot {
    /// The lower bound, or the start.
    pub low: Number,
    /// The upper bound, or the end.
    pub high: Number,
    /// Whether it is the whole interval.
    pub along: bool,
}

pub(crate) fn spot<T: Field>(place: &Place<T>) -> Spot {
    let (low, high) = place.bounds();
    let along = matches!(place, Place::Along(..));
    Spot { low: low.clone().number(), high: high.clone().number(), along }
}

/// A zero; see [`Zero`].
#[derive(Clone, Debug, PartialEq)]
pub struct AnyZero {
    /// Where.
    pub spot: Spot,
    /// How often it counts.
    pub multiplicity: usize,
    /// The signs before and after: -1, 0, 1.
    pub signs: [Option<i8>; 2],
}

pub(crate) fn sign(ordering: Ordering) -> i8 {
    ordering as i8
}

fn all_zeros<T: Field>(zeros: Vec<Zero<T>>) -> Vec<AnyZero> {
    let one = |zero: Zero<T>| AnyZero {
        spot: spot(&zero.place),
        multiplicity: zero.multiplicity,
        signs: [zero.before.map(sign), zero.after.map(sign)],
    };
    zeros.into_iter().map(one).collect()
}

/// The zeros of a function, polynomial or rational.
///
/// # Errors
/// [`NoSuch`](crate::Error::NoSuch) for what is no function, and those of the library.
pub fn zeros(function: &Value) -> Result<Vec<AnyZero>> {
    match function {
        Value::Spline(Any::F1(f)) => Ok(all_zeros(f.zeros()?)),
        Value::Spline(Any::Q1(f)) => Ok(all_zeros(f.zeros()?)),
        Value::Rational(Any::F1(f)) => Ok(all_zeros(f.zeros()?)),
        Value::Rational(Any::Q1(f)) => Ok(all_zeros(f.zeros()?)),
        other => Err(other.none_of("zeros")),
    }
}

/// Where a curve crosses `normal · x = offset`; see [`Crossings::crossings`].
///
/// # Errors
/// [`NoSuch`](crate::Error::NoSuch), [`Dimensions`](crate::Error::Dimensions), and those of the library.
pub fn crossings(curve: &Value, normal: &Coords, offset: &Number) -> Result<Vec<AnyZero>> {
    any_curve!(curve, "crossings", T, c => Ok(all_zeros(c.crossings(&point::<T, _>(normal)?, &T::of(offset)?)?)))
}

/// Where a plane curve meets a line; see [`Crossings::meet_line`].
///
/// # Errors
/// As [`crossings`].
pub fn line_crossings(curve: &Value, origin: &Coords, direction: &Coords) -> Result<Vec<AnyZero>> {
    macro_rules! meet {
        ($T:ty, $c:expr) => {
            Ok(all_zeros($c.meet_line(&point::<$T, _>(origin)?, &point::<$T, _>(direction)?)?))
        };
    }
    match curve {
        Value::Spline(Any::F2(c)) => meet!(f64, c),
        Value::Spline(Any::Q2(c)) => meet!(Q, c),
        Value::Rational(Any::F2(c)) => meet!(f64, c),
        Value::Rational(Any::Q2(c)) => meet!(Q, c),
        other => Err(other.none_of("meetings with a line in the plane")),
    }
}

/// The feet of the perpendiculars from a point; see [`Crossings::feet`].
///
/// # Errors
/// As [`crossings`].
pub fn feet(curve: &Value, from: &Coords) -> Result<Vec<AnyZero>> {
    any_curve!(curve, "feet", T, c => Ok(all_zeros(c.feet(&point::<T, _>(from)?)?)))
}
