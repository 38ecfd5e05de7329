//! DXF: drawings as pairs of a group code and a value, a line each.
//!
//! What is read: the entities SPLINE, LINE, ARC, CIRCLE, ELLIPSE and LWPOLYLINE of the drawing and of its blocks, where they stand; INSERTs
//! of blocks are not followed. All others are passed over. A curve has the name that this library wrote, or that of its block, or of its
//! layer unless that is `0`. Lengths are the numbers of the file, whatever its unit.
//!
//! - A SPLINE is its control points, knots and weights. Fit points are passed over if it has control points; one with fit points
//!   alone is refused, for the file does not tell the curve. It is plane if its flags say so, its normal is the z axis and all z are 0;
//!   it is periodic if its flags say so and its numbers do, to the last bit.
//! - Arcs of circles and ellipses are rational splines of degree 2, a LINE or LWPOLYLINE without bulges one of degree 1, with one
//!   unit of the parameter an edge. They are plane at elevation 0 with the z axis for a normal.
//!
//! Values are written as SPLINE entities of a drawing of 2007 (AC1021), in UTF-8, their names as extended data of the application
//! `SYMSPLINE`. Fractions are rounded to the nearest floats; all else comes back bit by bit. Surfaces, functions and meshes have no room.
//! Refused are binary files, names with line breaks or of more than 255 bytes, and curves of degree 0.
//!
//! The crate `dxf` writes numbers with fewer digits than they have and tells no line of what is wrong; so the pairs are read here.

mod groups;
mod shapes;
mod entity;
mod read;
mod write;

pub use read::from_bytes;
pub use write::to_bytes;

/// The application whose extended data holds names.
const APPLICATION: &str = "SYMSPLINE";

/// Flags of a SPLINE.
mod flags {
    pub(super) const CLOSED: i64 = 1;
    pub(super) const PERIODIC: i64 = 2;
    pub(super) const RATIONAL: i64 = 4;
    pub(super) const PLANAR: i64 = 8;
}
