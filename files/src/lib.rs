//! Splines, surfaces and meshes in files.
//!
//! [`read`] and [`write()`] tell the [`Format`] from the name of a file; [`from_bytes`] and [`to_bytes`] are told it. What a file holds is a
//! list of [`Entry`]: a name, if the format has one, and a [`Value`](symspline_dynamic::Value) over floats or, in JSON, over
//! fractions. Errors name the file and the place in it.
//!
//! A file is refused, never repaired: one that is cut off, holds NaN, refers in a circle or tells of more than it holds gives a
//! [`FileError`]; nothing is allocated by a number that a file merely claims.

// From the ground up: a module uses only what stands above it.
pub mod error;
pub mod entry;
pub mod format;
mod projected;
pub mod json;
mod nurbs;
pub mod geomdl;
pub mod obj;
mod outline;
pub mod svg;
pub mod font;
pub mod shaded;
pub mod dxf;
pub mod step;
pub mod iges;
pub mod run;

pub use entry::Entry;
pub use error::{FileError, Place, Problem, Result};
pub use format::Format;
pub use run::{MAX_BYTES, from_bytes, read, to_bytes, write};
