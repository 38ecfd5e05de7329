//! The operators, one file each: the map on spaces, the method on splines, the sign where there is one.

pub(crate) mod signs;
pub mod convert;
pub mod elevate;
pub mod embed;
pub mod restrict;
pub mod arithmetic;
pub mod derivative;
pub mod recompose;
pub mod product;
pub mod integral;
pub mod inner;
pub mod join;
pub mod reverse;
pub mod reparam;
mod cuts;
pub mod compose;
pub(crate) mod patch;
pub mod sign;
pub mod enclose;
pub mod range;
pub mod hull;
pub mod dual;
pub mod power;
pub mod quasi;
