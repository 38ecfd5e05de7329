//! Shape tools: control points and weights changed so that curves and surfaces do what was asked, after chapter 11 of The
//! NURBS Book, and Fowler and Bartels.
//!
//! The tools are written once, for whatever is [`Controlled`](controlled::Controlled): curves and surfaces, polynomial and
//! rational.

pub mod controlled;
pub mod drag;
pub mod region;
pub mod nodes;
pub mod grip;
pub mod legs;
pub mod confine;
pub mod constraints;
mod along;
pub mod relief;
pub mod coupled;
pub mod curvature_handle;
pub mod cross_ratio;
pub mod weight_range;
pub mod weigh;
pub mod weight_pull;
pub mod weight_pair_pull;
pub mod halfway;
pub mod workable;
pub mod reshape;
pub mod assignment;
pub mod bump;
pub mod polygon;
pub mod normals;
pub mod warp;
pub mod gravity;
mod root;
pub mod rotation;
pub mod onto;
pub mod flatten_region;
mod supports;
pub mod flatten;
pub mod bend_ratio;
pub mod bend_about;
pub mod bend_centre;
pub mod bend;
