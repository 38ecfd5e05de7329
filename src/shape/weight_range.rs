//! Ranges of weights: weights that vary widely make poor parametrizations.

use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::scalar::Scalar;

/// The weights that a tool may set, from `least` to `most`, both included [NURBS, section 11.3.1].
///
/// # Examples
/// ```
/// use symspline::{ShapeError, WeightRange};
/// let range = WeightRange::new(0.1, 10.0)?;
/// assert_eq!((range.least(), range.most()), (&0.1, &10.0));
/// let empty = ShapeError::EmptyRange { least: "0".into(), most: "1".into() };
/// assert_eq!(WeightRange::new(0.0, 1.0), Err(empty.into()));
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct WeightRange<T> {
    least: T,
    most: T,
}

impl<T: Scalar> WeightRange<T> {
    /// The range from `least` to `most`.
    ///
    /// # Errors
    /// [`ShapeError::EmptyRange`] unless `0 < least <= most` and both are numbers.
    pub fn new(least: T, most: T) -> Result<Self> {
        if T::zero() < least && least <= most && most.is_finite() {
            return Ok(Self { least, most });
        }
        Err(ShapeError::EmptyRange { least: least.to_string(), most: most.to_string() }.into())
    }

    /// The least weight.
    pub fn least(&self) -> &T {
        &self.least
    }

    /// The largest weight.
    pub fn most(&self) -> &T {
        &self.most
    }

    /// Refuses a weight outside.
    pub(crate) fn check(&self, index: usize, weight: &T) -> Result<()> {
        let inside = self.least <= *weight && *weight <= self.most;
        if inside { Ok(()) } else { Err(self.refusal(index, weight)) }
    }

    /// The error for a weight outside.
    pub(crate) fn refusal(&self, index: usize, weight: &T) -> Error {
        let [weight, least, most] = [weight, &self.least, &self.most].map(ToString::to_string);
        ShapeError::WeightOutOfRange { index, weight, least, most }.into()
    }

    /// The weight inside that is nearest: where a weight is known to be inside but for rounding.
    pub(crate) fn nearest(&self, weight: T) -> T {
        match weight {
            low if low < self.least => self.least.clone(),
            high if high > self.most => self.most.clone(),
            weight => weight,
        }
    }
}
