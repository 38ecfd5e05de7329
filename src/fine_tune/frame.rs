//! Points in units of their own size, so that springs of given constants do the same to a shape and to its enlargements.

use crate::error::{Error, Result};
use nalgebra::SVector;

/// Vectors shorter than the longest by this factor are zero but for rounding.
pub(crate) const NOTHING: f64 = 256.0 * f64::EPSILON;

/// The points in units of the longest side of a bounding box, from one of them.
#[derive(Clone, Debug)]
pub(crate) struct Frame<const N: usize> {
    origin: SVector<f64, N>,
    side: f64,
}

impl<const N: usize> Frame<N> {
    /// The frame of these points.
    ///
    /// # Errors
    /// [`Error::NoLength`] if they coincide; [`Error::NotFinite`] if the box is too large.
    ///
    /// # Panics
    /// If there are none.
    pub(crate) fn of(points: &[SVector<f64, N>]) -> Result<Self> {
        let (low, high) =
            points.iter().fold((points[0], points[0]), |(low, high), p| (low.inf(p), high.sup(p)));
        match (high - low).max() {
            0.0 => Err(Error::NoLength),
            side if side.is_finite() => Ok(Self { origin: points[0], side }),
            _ => Err(Error::NotFinite { what: "side of the bounding box", index: 0 }),
        }
    }

    pub(crate) fn inward(&self, point: &SVector<f64, N>) -> SVector<f64, N> {
        (point - self.origin) / self.side
    }

    pub(crate) fn outward(&self, point: &SVector<f64, N>) -> SVector<f64, N> {
        self.origin + point * self.side
    }
}
