//! The commands, one a file.

// From the ground up: a module uses only what stands above it.
pub mod completions;
pub mod convert;
pub mod info;
pub mod eval;
pub mod calc;
pub mod subdivide;
pub mod profile;
pub mod alpha;
pub mod tune;
pub mod shapes;
pub mod shape;
pub mod sculpt;
