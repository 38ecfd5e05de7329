//! Figures of curves and functions, as SVG and PNG.
//!
//! A [`Figure`] is a column of [`Panel`]s; a panel has two axes and series in data coordinates: Bézier paths,
//! polylines, markers, combs, knots, texts. Ranges, ticks, margins and legends take care of themselves, and
//! panels below each other may share their x axis ([`Panel::x_from_above`]). Curves stay curves: an SVG
//! holds the cubics it was given, with coordinates in fractions of a pixel.
//!
//! Splines become paths by [`curve_path`] and [`graph_path`]. Surfaces in space become shaded pictures, with curvature as
//! colour, by what [`solid`] holds; a panel shows [pictures](Panel::picture) instead of axes.
//!
//! # Examples
//! ```
//! use symspline::plot::{BezPath, Color, Figure, Marker, Panel, Style};
//!
//! let polygon = [(0.0, 0.0), (0.0, 4.0), (4.0, 4.0), (4.0, 0.0)];
//! let mut curve = BezPath::new();
//! curve.move_to(polygon[0]);
//! curve.curve_to(polygon[1], polygon[2], polygon[3]);
//!
//! let plane = Panel::new()
//!     .equal_axes()
//!     .marked_polyline(polygon, Marker::Circle, Style::line(Color::GRAY).width(1.0))
//!     .label("control polygon")
//!     .path(curve, Style::line(Color::BLUE).width(2.0))
//!     .label("cubic");
//! let svg = Figure::new(640.0).title("A Bézier curve").panel(plane).to_svg()?;
//! assert!(svg.starts_with("<svg") && svg.contains("C"));
//! # Ok::<(), symspline::error::Error>(())
//! ```

#[cfg(feature = "plot")]
mod trace;
mod style;
#[cfg(feature = "plot")]
mod svg;
#[cfg(feature = "plot")]
mod text;
#[cfg(feature = "plot")]
mod axis;
pub mod solid;
#[cfg(feature = "plot")]
mod gallery;
#[cfg(feature = "plot")]
mod series;
#[cfg(feature = "plot")]
mod panel;
#[cfg(feature = "plot")]
mod scale;
#[cfg(feature = "plot")]
mod header;
#[cfg(feature = "plot")]
mod layout;
#[cfg(feature = "plot")]
mod draw;
#[cfg(feature = "plot")]
mod png;
#[cfg(feature = "plot")]
mod profile;
#[cfg(feature = "plot")]
mod figure;

#[cfg(feature = "plot")]
pub use figure::Figure;
#[cfg(feature = "plot")]
pub use kurbo::{BezPath, Point};
#[cfg(feature = "plot")]
pub use panel::Panel;
pub use solid::{ColorMap, ColorScale, Mesh, Meshed, Paint, edge_lines, glb, write_glb};
#[cfg(feature = "plot")]
pub use solid::{Image, Scene, View, control_net, knot_lines};
pub use style::{Color, Dash, Marker, Style};
#[cfg(feature = "plot")]
pub use trace::{curve_path, graph_path};
