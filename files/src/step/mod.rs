//! STEP: the exchange structure of ISO 10303-21, with the B-splines of ISO 10303-42.
//!
//! What is read: the instances of B_SPLINE_CURVE and B_SPLINE_SURFACE, in the order of the file, wherever they are used, except for
//! curves in the parameters of a surface (those of a DEFINITIONAL_REPRESENTATION). They may be `_WITH_KNOTS`, `UNIFORM_`,
//! `QUASI_UNIFORM_` or `BEZIER_`, whose knots the standard defines, and rational. Faces are not trimmed, parts not placed, and lengths are the
//! numbers of the file, whatever its unit. A curve or surface that is called closed is periodic if its numbers are, to the last bit.
//!
//! What is written: a part (AP214) with curves in a GEOMETRIC_CURVE_SET and surfaces in a GEOMETRIC_SET, each with its name. A curve in the
//! plane lies in the plane `z = 0` of space, as the readers of CAD systems want it. Knots inside have at most `degree` copies: a curve with a
//! jump has no room. Fractions are rounded to the nearest floats. What is lost: that a curve was plane.

mod scan;
mod parameter;
mod text;
mod exchange;
mod read;
mod write;

pub use read::from_bytes;
pub use write::to_bytes;
