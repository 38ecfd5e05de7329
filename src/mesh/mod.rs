//! Polygon meshes, and the surfaces and curves that come of subdividing them.
//!
//! - A [`Topology`](topology::Topology) tells which faces meet in which edges and vertices; a
//!   [`ControlMesh`](control_mesh::ControlMesh) has a point a vertex besides.
//! - [`DooSabin`](doo_sabin::DooSabin) and [`CatmullClark`](catmull_clark::CatmullClark) are surfaces: a control mesh, knot intervals or
//!   equal ones, and what becomes of the [boundary](boundary::Boundary). Both are refined to any depth, and have limit points and normals. A Doo-Sabin
//!   surface can be [converted](doo_sabin::DooSabin::converted) to one of Catmull and Clark's.
//! - [`ControlPolygon`](control_polygon::ControlPolygon) and [`CubicPolygon`](cubic_polygon::CubicPolygon) are the same for curves.
//!
//! Fine tuning of meshes is in [`fine_tune`](crate::fine_tune), OBJ files in [`io::obj`](crate::io::obj).

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
