//! SVG: the outlines of a drawing as plane curves, and plane curves as a drawing.
//!
//! Read are the paths and basic shapes of a document, with their transforms and those of the groups around them, through `use` as well.
//! Each subpath is one curve: of the highest degree among its pieces, one knot span `[k, k + 1]` for each, joined exactly. Circles, ellipses and
//! arcs are rational quadratics, not approximations; a subpath with one is a rational curve. A closed subpath ends where it starts. What
//! is never drawn by itself (`defs`, `clipPath`, ...), texts and pictures are passed over; how things are painted is not kept. Lengths
//! are numbers or `px`.
//!
//! Written are plane curves, each as a path: degree 1 as lines, 2 as quadratics, 3 as cubics, piece by piece. Rational curves and
//! higher degrees become cubics that are certainly within [`TOLERANCE`] of the size of the curve. Knots are not kept: read again, the pieces stand
//! over `[k, k + 1]`. Numbers are the shortest decimals that are read back bit by bit, so that a file that was read and
//! written gives the same curves again.
//!
//! The y axis of SVG points down. Coordinates are kept as they are, both ways: nothing is turned over silently.
//!
//! The name of a curve is the `id` of its element, or what `data-name` says, where names are written that are no identifiers.

mod arc;
mod path;
mod shape;
mod document;
mod read;
mod write;

pub use read::from_bytes;
pub use write::{TOLERANCE, to_bytes};

const FORMAT: &str = "SVG";
