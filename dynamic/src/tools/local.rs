//! Portions of curves fine-tuned.

use crate::error::Result;
use crate::family::AnySpline;
use crate::number::{Field, Number};
use crate::scaled;
use crate::tools::tune::HeldCurve;
use nalgebra::SVector;
use std::fmt::Debug;
use symspline::{Curve, Hold, LocallyTuned, Norm, Scale};

/// A curve with a portion fine-tuned; see [`LocallyTuned`].
pub trait Local: Debug + Send + Sync {
    /// The pieces before and after the portion.
    fn rest(&self) -> [Option<AnySpline>; 2];

    /// The portion, with its ends held.
    fn tuned(&self) -> HeldCurve;

    /// The order of the derivatives that agree at its ends.
    fn order(&self) -> usize;

    /// Start and end of the portion.
    fn portion(&self) -> (Number, Number);

    /// All as one spline.
    ///
    /// # Errors
    /// Those of [`LocallyTuned::joined`].
    fn joined(&self) -> Result<AnySpline>;

    /// One spline of the degree of the curve, and a bound of its distance.
    ///
    /// # Errors
    /// Those of [`LocallyTuned::reduced`].
    fn reduced(&self, tolerance: &Number) -> Result<(AnySpline, Number)>;

    /// The nearest one in the space of the curve, and a bound of its distance.
    ///
    /// # Errors
    /// Those of [`LocallyTuned::in_original_space`].
    fn in_original_space(&self) -> Result<(AnySpline, Number)>;
}

impl<T: Field, const N: usize> Local for LocallyTuned<T, N>
where
    AnySpline: From<Curve<T, N>>,
    SVector<T, N>: Send + Sync,
{
    fn rest(&self) -> [Option<AnySpline>; 2] {
        [self.before(), self.after()].map(|piece| piece.cloned().map(AnySpline::from))
    }

    fn tuned(&self) -> HeldCurve {
        Self::tuned(self).clone().into()
    }

    fn order(&self) -> usize {
        Self::order(self)
    }

    fn portion(&self) -> (Number, Number) {
        let (a, b) = Self::portion(self);
        (a.clone().number(), b.clone().number())
    }

    fn joined(&self) -> Result<AnySpline> {
        Ok(Self::joined(self)?.into())
    }

    fn reduced(&self, tolerance: &Number) -> Result<(AnySpline, Number)> {
        let found = Self::reduced(self, &T::of(tolerance)?)?;
        Ok((found.spline.into(), found.bound.number()))
    }

    fn in_original_space(&self) -> Result<(AnySpline, Number)> {
        let found = Self::in_original_space(self)?;
        Ok((found.spline.into(), found.bound.number()))
    }
}

impl AnySpline {
    /// The curve with the portion over the domain of `alpha` tuned; see [`Curve::fine_tuned_on`].
    ///
    /// # Errors
    /// As [`fine_tuned_holding`](Self::fine_tuned_holding).
    pub fn fine_tuned_on(&self, alpha: &Self, signed: bool, hold: Hold) -> Result<Box<dyn Local>> {
        scaled!(held self, alpha, T, c, a => {
            let _: Option<T>;
            let scale = if signed { Scale::Signed(a) } else { Scale::Positive(a) };
            Ok(Box::new(c.fine_tuned_on(scale, hold)?) as Box<dyn Local>)
        })
    }

    /// The same by the nearest scale function with which the portion fits; see [`Curve::fine_tuned_on_by_nearest`].
    ///
    /// # Errors
    /// As [`fine_tuned`](Self::fine_tuned).
    pub fn fine_tuned_on_by_nearest(
        &self,
        wanted: &Self,
        order: usize,
        norm: Norm,
    ) -> Result<Box<dyn Local>> {
        scaled!(self, wanted, T, c, a => {
            let _: Option<T>;
            Ok(Box::new(c.fine_tuned_on_by_nearest(a, order, norm)?) as Box<dyn Local>)
        })
    }
}
