//! Parameters of sections from the distances between them.
//!
//! Each row `i` of control points `Q_{i,k}`, one of each section, is a polygon across with legs `l_{i,k}`. The step from section
//! `k - 1` to section `k` is the mean over the rows of the share that the leg has in its polygon [NURBS, section 10.3]:
//!
//! ```text
//! v_k - v_{k-1} = mean_i  l_{i,k}^e / Σ_j l_{i,j}^e        e = 1: chord length,   e = 1/2: centripetal
//! ```
//! Rows without a length, where sections meet, do not count.

use crate::build::skin::Skin;
use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::scalar::Real;
use crate::vector::length;
use nalgebra::SVector;

impl<T: Real, const N: usize> Skin<T, SVector<T, N>> {
    /// The same with parameters from 0 to 1 that advance like the mean distance of the sections.
    ///
    /// # Errors
    /// [`Error::NoLength`] if all sections coincide; [`SkinError::NotAfter`](crate::SkinError::NotAfter) if two neighbours do;
    /// [`Error::NotFinite`] on overflow.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, Skin, SplineSpace};
    /// let line = Curve::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![vector![0.0, 0.0], vector![1.0, 0.0]])?;
    /// let sections = [line.clone(), line.translated(&vector![0.0, 1.0])?, line.translated(&vector![0.0, 4.0])?];
    /// assert_eq!(Skin::through(&sections)?.by_chord_length()?.parameters(), [0.0, 0.25, 1.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn by_chord_length(self) -> Result<Self> {
        self.by_legs(|leg| leg)
    }

    /// The same with parameters from 0 to 1 that advance like the square roots of the distances of control points.
    ///
    /// # Errors
    /// As [`by_chord_length`](Self::by_chord_length).
    pub fn centripetal(self) -> Result<Self> {
        self.by_legs(|leg| leg.sqrt())
    }

    fn by_legs(self, measure: impl Fn(T) -> T) -> Result<Self> {
        let (sections, steps) = (&self.sections, self.parameters.len() - 1);
        let mut shares = vec![T::zero(); steps];
        for i in 0..sections[0].coeffs().len() {
            let point = |k: usize| &sections[k % sections.len()].coeffs()[i];
            let legs: Vec<T> = (0..steps).map(|k| measure(length(&point(k + 1).minus(point(k))))).collect();
            let total = legs.iter().fold(T::zero(), |sum, leg| sum + leg);
            if !total.is_finite() {
                return Err(Error::NotFinite { what: "length", index: i });
            }
            if !total.is_zero() {
                shares.iter_mut().zip(legs).for_each(|(share, leg)| *share += leg / &total);
            }
        }
        let mut parameters = vec![T::zero()];
        for share in shares {
            parameters.push(parameters[parameters.len() - 1].clone() + share);
        }
        let whole = parameters[steps].clone();
        if whole.is_zero() {
            return Err(Error::NoLength);
        }
        parameters.iter_mut().for_each(|v| *v /= &whole);
        self.with_parameters(&parameters)
    }
}
