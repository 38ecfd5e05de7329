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
mod part;
mod cubic_rules;
mod interval_rules;
pub mod catmull_clark;
mod corner_rule;
mod near;
mod limit;
mod limit_normals;
pub mod doo_sabin;
mod quadratic_limit;
mod polygon_space;
pub mod cubic_polygon;
pub mod control_polygon;
mod display;
