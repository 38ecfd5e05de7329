//! Tensor-product splines: surfaces, and functions of two parameters.
//!
//! A surface is a spline in `u` whose coefficients are [rows](crate::Row), the coefficients in `v`. So every operator of
//! one variable acts along `u` as it stands, and along `v` on the transposed grid ([`along`]).

pub mod spline;
pub mod along;
pub mod arithmetic;
pub mod eval;
pub(crate) mod patches;
pub mod compose;
pub mod range;
pub mod approximate;
pub mod product;
pub mod integral;
pub mod form;
pub mod normal;
pub mod volume;
