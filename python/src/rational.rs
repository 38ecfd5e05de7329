//! Rational functions and curves.

use crate::error::Result;
use crate::numbers::{Array, Num, point};
use crate::space::Space;
use pyo3::prelude::*;
use symspline_dynamic::AnyRational;

/// A rational spline of one parameter.
#[pyclass(frozen, eq, module = "symspline", from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct Rational(pub AnyRational);

#[pymethods]
impl Rational {
    #[new]
    fn new(space: Space, points: Array, weights: Array) -> Result<Self> {
        let dim = points.dim(1)?;
        let exact = space.0.is_exact() && points.numbers.is_exact() && weights.numbers.is_exact();
        Ok(Self(match exact {
            true => AnyRational::new(space.0, dim, points.numbers, weights.numbers)?,
            false => AnyRational::new(
                space.0.to_float()?,
                dim,
                points.numbers.to_float()?,
                weights.numbers.to_float()?,
            )?,
        }))
    }

    /// The control points.
    #[getter]
    fn points(&self) -> Result<Array> {
        let coords = self.0.coords()?;
        let dim = self.0.dim();
        let count = coords.len() / dim;
        Ok(Array::new(if dim > 1 { vec![count, dim] } else { vec![count] }, coords))
    }

    /// The weights.
    #[getter]
    fn weights(&self) -> Option<Array> {
        self.0.weights().map(|w| Array::new(vec![w.len()], w))
    }

    fn __call__<'py>(&self, py: Python<'py>, x: Num) -> PyResult<Bound<'py, PyAny>> {
        let value = self.0.at(&x.0).map_err(crate::error::Failure::from)?;
        let value =
            if x.0.is_exact() { value } else { value.to_float().map_err(crate::error::Failure::from)? };
        point(py, value)
    }
}
