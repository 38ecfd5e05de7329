//! Fine tuning of Doo-Sabin surfaces: control values on the edges of the mesh, and springs that keep the surface closed.

pub mod loops;
pub mod springs;
mod rest;
mod dissect;
mod sparse;
mod net;
mod energy;
mod stiffness;
mod newton;
pub mod tuned;
