//! Wavefront OBJ: free-form curves and surfaces, and meshes.
//!
//! ```text
//! v x y z [w]            a control point, with its weight          vp u v [w]           one of a plane curve
//! cstype [rat] bspline   or bezier                                 deg p [q]
//! curv a b i j ...       a curve in space over [a, b]              curv2 i j ...        a plane curve
//! surf a b c d i j ...   a surface over [a, b] x [c, d], the index of u runs first
//! parm u t t ...         knots, n + p + 2 of them for n + 1 points     parm v t t ...
//! end
//! ```
//! Indices count from 1, or with a minus sign from the last one back; lines that end in `\` go on. The weight stands beside the
//! coordinates and is not multiplied into them; without `rat` it means nothing. A range that is a part of the domain restricts the curve. The knots of
//! `bezier` are the breaks, between which pieces of degree `p` follow each other.
//!
//! Faces make a mesh by the rules of [`symspline::io::obj`], all of a file one mesh: that module reads them. Names are those of `o`,
//! else of `g`. Trimmed surfaces, special points, and curve types other than these are refused, never dropped.
//!
//! Written are `bspline` curves and surfaces and one mesh. Numbers are floats, shortest ones that are read back bit by bit; exact ones are
//! rounded to nearest. There is no periodic spline: it is written open, with its knots unrolled.

mod lines;
mod knots;
mod draft;
mod read;
mod write;

pub use read::from_bytes;
pub use write::to_bytes;

const FORMAT: &str = "OBJ";
