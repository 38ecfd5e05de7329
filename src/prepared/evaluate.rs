//! What all evaluators do: values and derivatives at a parameter, at many, on several threads.

use crate::error::{Error, Result};

/// A spline prepared for many values: one parameter for curves, a pair `(u, v)` for surfaces.
///
/// Values are those of the spline: right limits, at the end of the domain left ones.
///
/// # Examples
/// ```
/// use symspline::{Evaluate, Result, circle};
/// use nalgebra::vector;
///
/// /// The length of the polygon through the values at `parameters`.
/// fn length<E: Evaluate<Value = nalgebra::SVector<f64, 2>>>(curve: &E, parameters: &[E::Parameter]) -> Result<f64> {
///     Ok(curve.eval(parameters)?.windows(2).map(|ends| (ends[1] - ends[0]).norm()).sum())
/// }
///
/// let circle = circle(&vector![0.0, 0.0], &1.0)?.evaluator()?;
/// let parameters: Vec<f64> = (0..=1000).map(|i| f64::from(i) / 1000.0).collect();
/// assert!((length(&circle, &parameters)? - std::f64::consts::TAU).abs() < 1e-4);
/// # Ok::<(), symspline::Error>(())
/// ```
pub trait Evaluate: Sync {
    /// A number, or a pair of them.
    type Parameter: Sync;

    /// A value.
    type Value: Send;

    /// The derivatives of the orders below `COUNT`: `[d]` for curves, `[k][l]` for surfaces, `k` times along `u` and `l` times along
    /// `v`.
    type Derivatives<const COUNT: usize>: Send;

    /// The value at `x`.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    fn at(&self, x: &Self::Parameter) -> Result<Self::Value>;

    /// Value and derivatives of the orders below `COUNT` at `x`.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Evaluate, Function};
    /// let cube = Function::monomial(3, 0.0, 2.0)?.evaluator()?;
    /// assert_eq!(cube.derivatives_at::<5>(&1.0)?, [1.0, 3.0, 6.0, 6.0, 0.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn derivatives_at<const COUNT: usize>(&self, x: &Self::Parameter) -> Result<Self::Derivatives<COUNT>>;

    /// Calls `take` with the value at each parameter in turn.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], after `take` has had the values before.
    fn for_each(&self, parameters: &[Self::Parameter], take: impl FnMut(Self::Value)) -> Result<()>;

    /// Calls `take` with the derivatives at each parameter in turn.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], after `take` has had those before.
    fn for_each_derivatives<const COUNT: usize>(
        &self,
        parameters: &[Self::Parameter],
        take: impl FnMut(Self::Derivatives<COUNT>),
    ) -> Result<()>;

    /// The values at many parameters in any order; sorted ones are fastest.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Evaluate, Function};
    /// let square = Function::monomial(2, 0.0, 4.0)?.evaluator()?;
    /// assert_eq!(square.eval(&[3.0, 1.0, 4.0])?, [9.0, 1.0, 16.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn eval(&self, parameters: &[Self::Parameter]) -> Result<Vec<Self::Value>> {
        let mut values = Vec::with_capacity(parameters.len());
        self.for_each(parameters, |value| values.push(value))?;
        Ok(values)
    }

    /// As [`eval`](Self::eval), into memory at hand. On an error `values` may be partly overwritten.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::CoefficientCount`] if the lengths differ.
    fn eval_into(&self, parameters: &[Self::Parameter], values: &mut [Self::Value]) -> Result<()> {
        check_places(parameters, values)?;
        let mut places = values.iter_mut();
        self.for_each(parameters, |value| *places.next().expect("one place a parameter") = value)
    }

    /// Values and derivatives of the orders below `COUNT` at many parameters, into memory at hand. On an error it may be partly
    /// overwritten.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::CoefficientCount`] if the lengths differ.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Evaluate, Function};
    /// let square = Function::monomial(2, 0.0, 4.0)?.evaluator()?;
    /// let mut found = [[0.0; 2]; 3];
    /// square.eval_derivatives_into(&[3.0, 1.0, 4.0], &mut found)?;
    /// assert_eq!(found, [[9.0, 6.0], [1.0, 2.0], [16.0, 8.0]]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn eval_derivatives_into<const COUNT: usize>(
        &self,
        parameters: &[Self::Parameter],
        derivatives: &mut [Self::Derivatives<COUNT>],
    ) -> Result<()> {
        check_places(parameters, derivatives)?;
        let mut places = derivatives.iter_mut();
        self.for_each_derivatives(parameters, |all| *places.next().expect("one place a parameter") = all)
    }

    /// As [`eval_into`](Self::eval_into), on all threads of the current pool of rayon. Needs the feature `rayon`.
    ///
    /// # Errors
    /// As [`eval_into`](Self::eval_into).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Evaluate, Function};
    /// let square = Function::monomial(2, 0.0, 1.0)?.evaluator()?;
    /// let parameters: Vec<f64> = (0..10_000).map(|i| f64::from(i) / 10_000.0).collect();
    /// let mut values = vec![0.0; parameters.len()];
    /// square.par_eval_into(&parameters, &mut values)?;
    /// assert_eq!(values, square.eval(&parameters)?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[cfg(feature = "rayon")]
    fn par_eval_into(&self, parameters: &[Self::Parameter], values: &mut [Self::Value]) -> Result<()> {
        use rayon::prelude::*;
        check_places(parameters, values)?;
        let portions = parameters.par_chunks(PORTION).zip(values.par_chunks_mut(PORTION));
        portions.try_for_each(|(parameters, values)| self.eval_into(parameters, values))
    }
}

/// How many parameters a thread takes at a time.
#[cfg(feature = "rayon")]
const PORTION: usize = 4096;

fn check_places<X, V>(parameters: &[X], values: &[V]) -> Result<()> {
    if parameters.len() == values.len() {
        Ok(())
    } else {
        Err(Error::CoefficientCount { expected: parameters.len(), found: values.len() })
    }
}
