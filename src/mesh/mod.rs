//! Polygon meshes, and the surfaces and curves that come of subdividing them.
//!
//! A [`Topology`](topology::Topology) tells which faces meet in which edges and vertices; a
//! [`ControlMesh`](control_mesh::ControlMesh) has a point a vertex besides.

pub mod topology;
mod build;
pub mod control_mesh;
pub mod boundary;
mod face_rule;
mod dual;
mod primal;
pub mod catmull_clark;
mod corner_rule;
pub mod doo_sabin;
mod quadratic_limit;
