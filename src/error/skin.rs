//! Why no skin was laid over sections.

use crate::error::Error;

/// Why no skin was laid over sections.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum SkinError {
    /// Not enough sections.
    #[error("{expected} sections are needed, {found} are given")]
    TooFewSections {
        /// How many it takes.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// A section cannot be brought into one space with those before it.
    #[error("section {index}: {reason}")]
    Section {
        /// Which section.
        index: usize,
        /// What is wrong with it.
        reason: Box<Error>,
    },
    /// A section has no parameter after that of the section before it.
    #[error("section {index} has the parameter {parameter}, which is not above {before}, the one before it")]
    NotAfter {
        /// Which section; the number of sections for the end of the period.
        index: usize,
        /// Its parameter.
        parameter: String,
        /// The parameter of the section before it.
        before: String,
    },
    /// A closed skin has no ends.
    #[error("a closed skin has no ends whose tangents could be given")]
    ClosedHasNoEnds,
    /// A skin is closed and the space across it is not.
    #[error("a closed skin needs a periodic space across")]
    SpaceNotClosed,
    /// A neighbour does not end where the skin begins, or does not begin where it ends.
    #[error(
        "the edge of the neighbour is {distance} away from the section, which is above the tolerance {tolerance}"
    )]
    EdgeElsewhere {
        /// A bound of the distance.
        distance: String,
        /// The tolerance given.
        tolerance: String,
    },
}
