//! Solids: shaded pictures of surfaces in space, with a value such as the curvature as colour.
//!
//! ```text
//! surface -> Mesh -> Scene -> Image -> Panel of a Figure
//!               \--> glTF binary, for viewers
//! ```
//!
//! A [`Mesh`] has points, normals and a value a vertex; it comes from a spline surface, from a control mesh, or from faces of any origin. A
//! [`ColorScale`] says which colour a value has; shared by several pictures, it makes them comparable. A [`Scene`] is
//! looked at along a [`View`], with light from the upper left and lines hidden by what is in front of them.
//!
//! # Examples
//! ```
//! use nalgebra::vector;
//! use symspline::plot::{ColorScale, Figure, Mesh, Panel, Scene, View};
//! use symspline::{SplineSpace, Surface};
//!
//! // z = x y
//! let line = SplineSpace::bezier(1, -1.0, 1.0)?;
//! let corners = vec![vector![-1.0, -1.0, 1.0], vector![-1.0, 1.0, -1.0], vector![1.0, -1.0, -1.0], vector![1.0, 1.0, 1.0]];
//! let saddle = Surface::new(line.clone(), line, corners)?;
//! let mesh = Mesh::sampled(&saddle, 20, 20, Surface::gaussian_curvature_at)?;
//! let scale = ColorScale::about_zero(&[&mesh], 1.0)?;
//! assert_eq!(scale.limits(), (-1.0, 1.0));
//! let image = Scene::new().mesh(&mesh, &scale).image(&View::new(30.0, 25.0), 200, 150)?;
//! let panel = Panel::new().picture("z = x y", image).color_bar(&scale, "Gaussian curvature");
//! let svg = Figure::new(400.0).panel(panel).to_svg()?;
//! assert!(svg.contains("data:image/png"));
//! # Ok::<(), symspline::Error>(())
//! ```

#[cfg(feature = "plot")]
mod image;
mod normals;
mod mesh;
mod sample;
#[cfg(feature = "plot")]
mod lines;
mod color_map;
mod color_scale;
mod paint;
#[cfg(feature = "plot")]
mod view;
#[cfg(feature = "plot")]
mod raster;
#[cfg(feature = "plot")]
mod light;
#[cfg(feature = "plot")]
mod scene;
mod control;
mod glb;

pub use color_map::ColorMap;
pub use color_scale::ColorScale;
pub use control::edge_lines;
pub use glb::{glb, write_glb};
#[cfg(feature = "plot")]
pub use image::Image;
#[cfg(feature = "plot")]
pub use lines::{control_net, knot_lines};
pub use mesh::Mesh;
pub use paint::Paint;
pub use sample::Meshed;
#[cfg(feature = "plot")]
pub use scene::Scene;
#[cfg(feature = "plot")]
pub use view::View;

/// A point in space.
type Point3 = nalgebra::SVector<f64, 3>;
