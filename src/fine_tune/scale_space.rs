//! Spaces of scale functions: one for curves, a pair of them for surfaces.

use crate::constrain::norm::{CoeffSpace, SpacePair};
use crate::error::{Error, Result};
use crate::fine_tune::scale::ScaleFunction;
use crate::map::LinearMap;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Function;
use crate::tensor::spline::TensorSpline;

/// A space of scale functions.
pub trait ScaleSpace<T: Scalar>: CoeffSpace<T> + Clone {
    /// Its functions.
    type Function: ScaleFunction;

    /// The function with some coefficients.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`], [`Error::NotFinite`].
    fn function(&self, coeffs: Vec<T>) -> Result<Self::Function>;

    /// The coefficients of a function in this space.
    ///
    /// # Errors
    /// As [`Spline::embedded`](crate::Spline::embedded), if it is not in this space.
    fn coeffs_of(&self, function: &Self::Function) -> Result<Vec<T>>;

    /// The space with every span halved.
    ///
    /// # Errors
    /// [`Error::TooLarge`]; [`Error::SpanOutOfRange`] if in `f64` knots are too near.
    fn bisected(&self) -> Result<Self>;

    /// The map to the coefficients in a larger space.
    ///
    /// # Errors
    /// As [`SplineSpace::embedding`].
    fn embedding(&self, finer: &Self) -> Result<LinearMap<T>>;

    /// The map to values at many parameters.
    ///
    /// # Errors
    /// [`Error::TooLarge`]; [`Error::SpanOutOfRange`] if in `f64` knots are too near.
    fn sampling(&self) -> Result<LinearMap<T>>;
}

impl<T: Scalar> ScaleSpace<T> for SplineSpace<T> {
    type Function = Function<T>;

    fn function(&self, coeffs: Vec<T>) -> Result<Function<T>> {
        Function::new(self.clone(), coeffs)
    }

    fn coeffs_of(&self, function: &Function<T>) -> Result<Vec<T>> {
        let same = function.space() == self;
        Ok(if same { function.coeffs().to_vec() } else { function.embedded(self)?.into_coeffs() })
    }

    fn bisected(&self) -> Result<Self> {
        self.bisected()
    }

    fn embedding(&self, finer: &Self) -> Result<LinearMap<T>> {
        self.embedding(finer)
    }

    fn sampling(&self) -> Result<LinearMap<T>> {
        let places = self.bisected()?.bisected()?.greville();
        let (a, b) = self.domain();
        let knots = self.breaks().into_iter().map(|(t, _)| t);
        let inside: Vec<T> = places.into_iter().filter(|x| a <= x && x <= b).chain(knots).collect();
        self.evaluation(&inside)
    }
}

impl<T: Scalar> ScaleSpace<T> for SpacePair<T> {
    type Function = TensorSpline<T>;

    fn function(&self, coeffs: Vec<T>) -> Result<TensorSpline<T>> {
        TensorSpline::new(self.0.clone(), self.1.clone(), coeffs)
    }

    fn coeffs_of(&self, function: &TensorSpline<T>) -> Result<Vec<T>> {
        let same = (function.u(), function.v()) == (&self.0, &self.1);
        Ok(if same { function.coeffs().to_vec() } else { function.embedded(&self.0, &self.1)?.into_coeffs() })
    }

    fn bisected(&self) -> Result<Self> {
        Ok((self.0.bisected()?, self.1.bisected()?))
    }

    fn embedding(&self, finer: &Self) -> Result<LinearMap<T>> {
        self.0.embedding(&finer.0)?.tensor(&self.1.embedding(&finer.1)?)
    }

    fn sampling(&self) -> Result<LinearMap<T>> {
        self.0.sampling()?.tensor(&self.1.sampling()?)
    }
}

/// Refuses a list of the wrong length, values that are not finite, and unless `signed` functions not proved to be positive.
pub(crate) fn check_values<T: Scalar, S: ScaleSpace<T>>(
    scales: &S,
    values: &[T],
    signed: bool,
) -> Result<()> {
    if values.len() != scales.dim() {
        return Err(Error::CoefficientCount { expected: scales.dim(), found: values.len() });
    }
    if let Some(index) = values.iter().position(|value| !value.is_finite()) {
        return Err(Error::NotFinite { what: "coefficient", index });
    }
    if signed || values.iter().all(|value| *value > T::zero()) {
        return Ok(());
    }
    scales.function(values.to_vec())?.check_positive()
}
