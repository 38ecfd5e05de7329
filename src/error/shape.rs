//! Why a shape tool refused.

/// Why a shape tool refused: what was picked cannot do what was asked.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ShapeError {
    /// A control point, or several with their shares, have no influence at the picked parameter.
    #[error("what was picked has no influence at parameter {parameter}")]
    NoInfluence {
        /// The parameter.
        parameter: String,
    },
    /// A knot would be inserted where there is one already.
    #[error("the knot {knot} is there already: inserting it would make the shape less smooth")]
    KnotThere {
        /// The knot.
        knot: String,
    },
    /// A value should be a knot and is none.
    #[error("{value} is no knot")]
    NoKnot {
        /// The value.
        value: String,
    },
    /// No node is at or before a parameter.
    #[error("parameter {parameter} is before the first node")]
    NoNodeBefore {
        /// The parameter.
        parameter: String,
    },
}
