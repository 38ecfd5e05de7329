//! One file a crate: how it is built from the data, and which of its calls stand for what.

pub mod bounds;
#[cfg(feature = "bsplines")]
pub mod bsplines;
#[cfg(feature = "curvo")]
pub mod curvo;
#[cfg(feature = "monstertruck")]
pub mod monstertruck;
pub mod prepared;
pub mod symspline;
#[cfg(feature = "truck")]
pub mod truck;
