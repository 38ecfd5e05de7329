//! Arithmetic of splines of one kind over either field.

use crate::error::{Error, Result};
use crate::family::{AnyRational, AnyRationalSurface, AnySpline, AnySurface};
use crate::number::{Field, Flat, Number};
use crate::over::Coords;
use crate::{Any, alike, each, each_curve, with_function};
use symspline::{Interval, Rational, Rectangle};

macro_rules! arithmetic {
    ($any:ty) => {
        impl $any {
            /// The sum.
            ///
            /// # Errors
            /// [`Error::Fields`], [`Error::Dimensions`], and those of the library: the domains may differ.
            pub fn sum(&self, other: &Self) -> Result<Self> {
                alike!(self, other, s, t => Ok(s.sum(t)?.into()))
            }

            /// The difference.
            ///
            /// # Errors
            /// As [`sum`](Self::sum).
            pub fn difference(&self, other: &Self) -> Result<Self> {
                alike!(self, other, s, t => Ok(s.difference(t)?.into()))
            }

            /// The multiple.
            ///
            /// # Errors
            /// Those of the library.
            pub fn scaled(&self, factor: &Number) -> Result<Self> {
                each!(self, T, s => Ok(s.scaled(&T::of(factor)?)?.into()))
            }

            /// The product with a function.
            ///
            /// # Errors
            /// [`Error::Fields`], [`Error::Dimensions`], and those of the library: the domains may differ.
            pub fn times(&self, factor: &Self) -> Result<Self> {
                with_function!(self, factor, s, f => Ok(s.times(f)?.into()))
            }

            /// The same moved by a vector.
            ///
            /// # Errors
            /// [`Error::Dimensions`], and those of the library.
            pub fn translated(&self, by: &Coords) -> Result<Self> {
                each!(self, T, s => Ok(s.translated(&Flat::from_coords(&T::all_of(by)?)?)?.into()))
            }

            /// The inner products of the values, a function.
            ///
            /// # Errors
            /// As [`sum`](Self::sum).
            pub fn dot(&self, other: &Self) -> Result<Self> {
                match (self, other) {
                    (Any::F1(s), Any::F1(t)) => Ok(s.times(t)?.into()),
                    (Any::Q1(s), Any::Q1(t)) => Ok(s.times(t)?.into()),
                    (Any::F2(s), Any::F2(t)) => Ok(s.dot(t)?.into()),
                    (Any::F3(s), Any::F3(t)) => Ok(s.dot(t)?.into()),
                    (Any::Q2(s), Any::Q2(t)) => Ok(s.dot(t)?.into()),
                    (Any::Q3(s), Any::Q3(t)) => Ok(s.dot(t)?.into()),
                    (s, t) => Err(s.unlike(t)),
                }
            }

            /// The cross products of the values: in the plane a function, in space vectors.
            ///
            /// # Errors
            /// As [`sum`](Self::sum); [`Error::Dimension`] for functions.
            pub fn cross(&self, other: &Self) -> Result<Self> {
                match (self, other) {
                    (Any::F2(s), Any::F2(t)) => Ok(s.cross(t)?.into()),
                    (Any::F3(s), Any::F3(t)) => Ok(s.cross(t)?.into()),
                    (Any::Q2(s), Any::Q2(t)) => Ok(s.cross(t)?.into()),
                    (Any::Q3(s), Any::Q3(t)) => Ok(s.cross(t)?.into()),
                    (Any::F1(_), Any::F1(_)) | (Any::Q1(_), Any::Q1(_)) => {
                        Err(Error::Dimension { found: 1, least: 2 })
                    }
                    (s, t) => Err(s.unlike(t)),
                }
            }

            /// One coordinate, a function.
            ///
            /// # Errors
            /// [`symspline::Error::IndexOutOfRange`].
            pub fn coordinate(&self, axis: usize) -> Result<Self> {
                each_curve!(self, T, s => { let _: Option<T>; Ok(s.coordinate(axis)?.into()) }, match axis {
                    0 => Ok(self.clone()),
                    _ => Err(symspline::Error::IndexOutOfRange { index: axis, length: 1 }.into()),
                })
            }

            /// Whether both have the same values everywhere, whatever spaces they are in.
            ///
            /// # Errors
            /// As [`sum`](Self::sum).
            pub fn same_function(&self, other: &Self) -> Result<bool> {
                alike!(self, other, s, t => Ok(s.same_function(t)?))
            }
        }
    };
}

arithmetic!(AnySpline);
arithmetic!(AnySurface);
arithmetic!(AnyRational);
arithmetic!(AnyRationalSurface);

macro_rules! lift {
    ($rational:ty, $polynomial:ty, $domain:ty) => {
        impl $rational {
            /// A polynomial spline as a rational one, all weights one.
            ///
            /// # Errors
            /// Those of the library.
            pub fn from_polynomial(spline: &$polynomial) -> Result<Self> {
                each!(spline, s => Ok(Rational::<$domain, _, _>::from_polynomial(s)?.into()))
            }

            /// The quotient of a polynomial spline and a polynomial function.
            ///
            /// # Errors
            /// [`Error::Fields`]; [`symspline::Error::Pole`] where the function vanishes.
            pub fn quotient(numerator: &$polynomial, denominator: &$polynomial) -> Result<Self> {
                with_function!(numerator, denominator, s, f => Ok(Rational::<$domain, _, _>::from_quotient(s, f)?.into()))
            }

            /// The quotient by a rational function.
            ///
            /// # Errors
            /// As [`quotient`](Self::quotient).
            pub fn divided(&self, divisor: &Self) -> Result<Self> {
                with_function!(self, divisor, s, f => Ok(s.divided(f)?.into()))
            }
        }
    };
}

lift!(AnyRational, AnySpline, Interval);
lift!(AnyRationalSurface, AnySurface, Rectangle);
