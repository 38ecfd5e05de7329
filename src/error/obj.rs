//! Why an OBJ file was not read.

/// Why an OBJ file was not read. Lines are counted from 1, as editors do; of continued ones the first.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum ObjError {
    /// A line that begins with no word of the format, or with one for free-form curves and surfaces.
    #[error("line {line}: '{word}' begins nothing that belongs to a polygon mesh")]
    Statement {
        /// The line.
        line: usize,
        /// The word, or how it begins.
        word: String,
    },
    /// A vertex or a face that cannot be read.
    #[error("line {line}: {reason}")]
    Syntax {
        /// The line.
        line: usize,
        /// What is wrong with it.
        reason: String,
    },
    /// A vertex with another number of numbers than it may have.
    #[error(
        "line {line}: {found} numbers are given for a vertex: it has three, and a weight of 1 or a colour of three besides"
    )]
    Coordinates {
        /// The line.
        line: usize,
        /// How many there are.
        found: usize,
    },
    /// A coordinate is infinite, too large for a float, or not a number.
    #[error("line {line}: coordinate {axis} of the vertex is not a finite number")]
    NotFinite {
        /// The line.
        line: usize,
        /// Which coordinate, from 0.
        axis: usize,
    },
    /// A vertex of a rational surface.
    #[error("line {line}: the vertex has the weight {weight}; those of polygon meshes have 1 or none")]
    Weighted {
        /// The line.
        line: usize,
        /// The weight.
        weight: String,
    },
    /// A face with fewer than three corners.
    #[error("line {line}: the face has {found} corners, fewer than three")]
    FewCorners {
        /// The line.
        line: usize,
        /// How many there are.
        found: usize,
    },
    /// A corner of a face that is no vertex of the file.
    #[error(
        "line {line}: the face comes to vertex {index} of {count}: they are counted from 1, or back from -1"
    )]
    NoSuchVertex {
        /// The line.
        line: usize,
        /// The index as given.
        index: i64,
        /// How many vertices there are: in the file, or, for one counted back, before the line.
        count: usize,
    },
    /// A line without end.
    #[error("line {line} is longer than {limit} bytes")]
    LongLine {
        /// The line.
        line: usize,
        /// The largest length.
        limit: usize,
    },
    /// The last line says that another one follows.
    #[error("line {line} is continued, but the file ends")]
    Unfinished {
        /// The line.
        line: usize,
    },
}
