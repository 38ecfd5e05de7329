//! Fine tuning of surfaces: the derivative scaled along one path or two.

pub mod path;
pub mod edges;
pub mod held;
mod table;
pub mod condition;
pub mod tuner;
pub mod gap;
pub mod local;
