//! Coefficients that meet linear conditions and are as near as possible to given ones.

pub mod norm;
mod orthogonal;
pub(crate) mod independent;
pub mod change;
pub(crate) mod above;
pub mod sparse;
pub mod least;
