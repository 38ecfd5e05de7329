//! Splines from data.

pub mod parameters;
pub mod fit;
pub mod conics;
pub mod closed;
