//! Splines from data.

pub mod parameters;
mod collocate;
pub mod fit;
pub mod osculate;
pub mod skin;
pub mod conics;
pub mod closed;
