//! The sizes beyond which nothing is allocated.

use crate::error::{Error, Result};

/// The highest degree a space may have.
pub const MAX_DEGREE: usize = 512;

/// The largest number of coefficients a space may have.
pub const MAX_DIM: usize = 1 << 26;

/// The largest number of entries of a dense matrix or map.
pub const MAX_ENTRIES: usize = 1 << 28;

/// The largest number of coefficients that an approximation to a tolerance may grow to.
pub const MAX_ADAPTED: usize = 1 << 16;

/// The largest number of places at which a function is sampled at once.
pub const MAX_SAMPLES: usize = 1 << 22;

/// How many coefficients branch and bound may make in halving patches.
pub(crate) const MAX_HALVED: usize = 1 << 24;

/// Refuses degrees beyond [`MAX_DEGREE`].
pub(crate) fn check_degree(degree: usize) -> Result<()> {
    match degree {
        0..=MAX_DEGREE => Ok(()),
        _ => Err(Error::DegreeTooHigh { degree, limit: MAX_DEGREE }),
    }
}

/// Refuses numbers of coefficients beyond [`MAX_DIM`].
pub(crate) fn check_dim(dim: usize) -> Result<()> {
    match dim {
        0..=MAX_DIM => Ok(()),
        _ => Err(Error::TooLarge { count: dim, limit: MAX_DIM }),
    }
}

/// Refuses numbers of samples beyond [`MAX_SAMPLES`].
pub(crate) fn check_samples(count: usize) -> Result<()> {
    match count {
        0..=MAX_SAMPLES => Ok(()),
        _ => Err(Error::TooLarge { count, limit: MAX_SAMPLES }),
    }
}

/// Refuses dense matrices beyond [`MAX_ENTRIES`].
pub(crate) fn check_entries(rows: usize, columns: usize) -> Result<()> {
    match rows.saturating_mul(columns) {
        0..=MAX_ENTRIES => Ok(()),
        count => Err(Error::TooLarge { count, limit: MAX_ENTRIES }),
    }
}
