//! IGES 5.3: records of 80 columns, with a directory of the entities and the parameters of each.
//!
//! What is read: entities 126 (curves) and 128 (surfaces), lines (110) and arcs (100), in the order of the directory, with the matrices (124) that
//! their entries refer to, wherever they are used, except for curves in the parameters of a surface (use flag 05). Surfaces are not
//! trimmed, subfigures not placed, and lengths are the numbers of the file, whatever its unit. If the parameters of the ends are not those
//! of the knots, the part between is taken. Names are properties 406, form 15.
//!
//! A curve is plane if it is called so with the z axis for a normal, all z are 0, and no matrix moves it. A spline is periodic if it
//! is called closed or periodic and its numbers are, to the last bit. It is polynomial if it is called so (PROP3); then its weights must be equal.
//!
//! What is written: the same entities, in records of 80 columns, with names as properties. Fractions are rounded to the nearest floats;
//! all else comes back bit by bit. Surfaces in the plane, functions and meshes have no room, nor have names with letters beyond ASCII.
//!
//! Compressed and binary files are refused.

mod records;
mod parameters;
mod read;
mod splines;
mod write;

pub use read::from_bytes;
pub use write::to_bytes;

/// The entities that are known.
mod kinds {
    pub(super) const ARC: i64 = 100;
    pub(super) const LINE: i64 = 110;
    pub(super) const MATRIX: i64 = 124;
    pub(super) const CURVE: i64 = 126;
    pub(super) const SURFACE: i64 = 128;
    pub(super) const PROPERTY: i64 = 406;
    /// The form of a property that is a name.
    pub(super) const NAME: i64 = 15;
}
