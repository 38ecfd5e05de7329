//! What can go wrong when kinds, fields and dimensions meet.

/// The result of an operation that can fail.
pub type Result<T> = std::result::Result<T, Error>;

/// Why an operation refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The library refused.
    #[error(transparent)]
    Spline(#[from] symspline::Error),
    /// A value over fractions meets one over floats.
    #[error("{left} and {right} values do not mix: convert one of them")]
    Fields {
        /// The field of the one, "exact" or "float".
        left: &'static str,
        /// The field of the other.
        right: &'static str,
    },
    /// Points of different dimensions meet.
    #[error("{left} and {right} dimensions do not go together")]
    Dimensions {
        /// The dimension of the one.
        left: usize,
        /// The dimension of the other.
        right: usize,
    },
    /// A dimension for which there is no type.
    #[error("points have {found} coordinates: {least} to 3 are possible here")]
    Dimension {
        /// The dimension.
        found: usize,
        /// The least that would do.
        least: usize,
    },
    /// Coordinates that do not make whole points.
    #[error("{count} coordinates do not make points of {dim}")]
    Torn {
        /// How many coordinates.
        count: usize,
        /// How many a point has.
        dim: usize,
    },
    /// An operation that these kinds of values do not have.
    #[error("there is no {operation} of {left}{}{right}", if right.is_empty() { "" } else { " and " })]
    NoSuch {
        /// What was asked for, as a noun: "sum", "product".
        operation: &'static str,
        /// The kind of the one.
        left: String,
        /// The kind of the other; empty if there is one alone.
        right: String,
    },
    /// A quotient by the number zero.
    #[error("division by zero")]
    DivisionByZero,
    /// Text that is no number of the field.
    #[error("'{text}' is not a number")]
    NotANumber {
        /// The start of the text.
        text: String,
    },
}
