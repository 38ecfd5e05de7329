//! Fine tuning of surfaces: the derivative scaled along one path or two.

pub mod edges;
pub mod path;
pub mod held;
mod table;
mod ways;
pub mod condition;
pub mod tuner;
pub mod near;
pub mod gap;
pub mod local;
