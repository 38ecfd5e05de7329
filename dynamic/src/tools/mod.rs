//! The library's tools over values: what takes more than a line to tell kinds, fields and dimensions apart, for the command line and
//! the Python package alike.

// From the ground up: a module uses only what stands above it.
pub mod shape;
pub mod tune;
pub mod condition;
pub mod tuner;
pub mod local;
pub mod edit;
pub mod nodes;
pub mod constraints;
pub mod coupled;
pub mod handle;
pub mod weights;
pub mod weight_pairs;
mod aside;
pub mod warp;
pub mod gravity;
pub mod flat;
pub mod bend;
pub mod area;
pub mod forces;
pub mod elastic;
pub mod stiffness;
pub mod relax;
pub mod full_energy;
pub mod sculpt;
pub mod subdivision;
pub mod places;
pub mod curvature;
pub mod measure;
pub mod meet;
