//! Splines whose kind, field and dimension are known when the program runs.
//!
//! The library `symspline` tells them by types: `Curve<Q, 3>`, `NurbsSurface<f64, 2>`. A file, a command or a Python program tells
//! them by values. Here each kind is one type, [`Any`] of a [`Family`], with a variant for each field and dimension; [`each!`](each)
//! hands what is inside to one text. [`Value`] is any of them, or a number or a point, with the arithmetic of all.
//!
//! Over one field or the other: values of different fields do not mix ([`Error::Fields`]); [`Value::to_exact`] and
//! [`Value::to_float`] convert. Numbers and points alone are taken into the field of the spline they meet, without loss from floats to fractions.
//!
//! # Examples
//! ```
//! use symspline_dynamic::{AnySpace, AnySpline, Coords, Value};
//! use symspline::{Q, Scalar, SplineSpace};
//! let space = AnySpace::Exact(SplineSpace::bezier(2, Q::int(0), Q::int(1))?);
//! let parabola = AnySpline::new(space, 2, Coords::Exact([0, 0, 1, 2, 2, 0].map(Q::int).to_vec()))?;
//! let slope = Value::from(parabola.derivative()?);
//! assert_eq!(slope.sum(&slope)?.to_string(), "exact curve in 2 dimensions, degree 1, 2 coefficients on [0, 1]");
//! # Ok::<(), symspline_dynamic::Error>(())
//! ```

// From the ground up: a module uses only what stands above it.
pub mod error;
pub mod number;
pub mod over;
pub mod any;
pub mod family;
pub mod build;
pub mod data;
pub mod arithmetic;
pub mod operators;
pub mod homogeneous;
pub mod linear;
pub mod value;
pub mod values;
pub mod meeting;
pub mod tools;

pub use any::{Any, Family};
pub use data::Spaced;
pub use error::{Error, Result};
pub use family::{AnyRational, AnyRationalSurface, AnySpline, AnySurface};
pub use family::{RationalSurfaces, Rationals, Splines, Surfaces};
pub use meeting::Meeting;
pub use number::{Field, Number};
pub use over::{AnyMesh, AnySpace, Coords, Over};
pub use value::Value;
