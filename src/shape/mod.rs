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
pub mod relief;
pub mod coupled;
pub mod curvature_handle;
