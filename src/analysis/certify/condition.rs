//! Scalar functions of a curve whose zeros say something about it, over whichever field the curve is.

use crate::analysis::lifted::{Lifted, wedge};
use crate::analysis::pieces::Pieces;
use crate::coeff::Coeff;
use crate::error::Result;
use crate::scalar::Scalar;
use crate::vector::dot;
use nalgebra::SVector;

/// A function of a curve, piece by piece a polynomial.
#[derive(Clone, Debug)]
pub struct Condition<T, const N: usize> {
    pub(crate) curve: Lifted<T, N>,
    pub(crate) what: What<T, N>,
}

/// Which function of the curve, up to a positive factor.
#[derive(Clone, Debug)]
pub(crate) enum What<T, const N: usize> {
    /// The squared speed.
    Speed,
    /// In the plane the curvature, in space its square.
    Bend,
    /// The derivative of that.
    Slope,
    /// How far the curve is above the line or plane across `normal`, with `normal · x = offset` on it.
    Above { normal: SVector<T, N>, offset: T },
    /// In the plane, how far the curve is left of the line through `origin`.
    Left { origin: SVector<T, N>, direction: SVector<T, N> },
    /// The derivative of the distance from a point.
    Foot { point: SVector<T, N> },
}

impl<T: Scalar, const N: usize> Condition<T, N> {
    /// The function.
    ///
    /// # Errors
    /// [`Error::TooLarge`](crate::Error::TooLarge), [`Error::DegreeTooHigh`](crate::Error::DegreeTooHigh).
    pub(crate) fn function(&self) -> Result<Pieces<T>> {
        let order = match &self.what {
            What::Above { .. } | What::Left { .. } => 0,
            What::Speed | What::Foot { .. } => 1,
            What::Bend => 2,
            What::Slope => 3,
        };
        let motion = self.curve.motion(order)?;
        match &self.what {
            What::Speed => motion.speed(),
            What::Bend if N < 3 => Ok(motion.bend()?.map(|across| across[2].clone())),
            What::Bend => {
                let bend = motion.bend()?;
                bend.times(&bend, dot)
            }
            What::Slope if N < 3 => Ok(motion.slope()?.map(|across| across[2].clone())),
            What::Slope => motion.bend()?.times(&motion.slope()?, dot),
            What::Above { normal, offset } => {
                let heights = motion.points().map(|point| dot(normal, point));
                Ok(match motion.weights() {
                    Some(weights) => heights.plus(-1, &weights.map(|weight| offset.clone() * weight)),
                    None => heights.map(|height| height.clone() - offset),
                })
            }
            What::Left { origin, direction } => {
                Ok(motion.away_from(origin).map(|away| wedge(direction, away)[2].clone()))
            }
            What::Foot { point } => motion.away_from(point).times(&motion.direction()?, dot),
        }
    }

    /// The same function of the same curve over another field.
    ///
    /// # Errors
    /// The first one of `convert`; [`Error::NotFinite`](crate::Error::NotFinite).
    pub(crate) fn over<U: Scalar>(
        &self,
        mut convert: impl FnMut(&T) -> Result<U>,
    ) -> Result<Condition<U, N>> {
        Ok(Condition { curve: self.curve.over(&mut convert)?, what: self.what.over(convert)? })
    }

    /// The same on the span `k` of the curve alone.
    ///
    /// # Errors
    /// As [`over`](Self::over).
    pub(crate) fn window<U: Scalar>(
        &self,
        k: usize,
        mut convert: impl FnMut(&T) -> Result<U>,
    ) -> Result<Condition<U, N>> {
        Ok(Condition { curve: self.curve.window(k, &mut convert)?, what: self.what.over(convert)? })
    }
}

impl<T: Scalar, const N: usize> What<T, N> {
    fn over<U: Scalar>(&self, mut convert: impl FnMut(&T) -> Result<U>) -> Result<What<U, N>> {
        let mut vector = |x: &SVector<T, N>| x.try_map(&mut convert);
        Ok(match self {
            Self::Speed => What::Speed,
            Self::Bend => What::Bend,
            Self::Slope => What::Slope,
            Self::Left { origin, direction } => {
                What::Left { origin: vector(origin)?, direction: vector(direction)? }
            }
            Self::Foot { point } => What::Foot { point: vector(point)? },
            Self::Above { normal, offset } => {
                What::Above { normal: vector(normal)?, offset: convert(offset)? }
            }
        })
    }
}
