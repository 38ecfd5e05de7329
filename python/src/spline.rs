//! Functions and curves.

use crate::error::Result;
use crate::numbers::{Array, point};
use crate::space::Space;
use pyo3::prelude::*;
use symspline_dynamic::{AnySpline, Number};

/// A spline of one parameter: a function, or a curve in two or three dimensions.
///
/// `Spline(space, coeffs)` takes coefficients of shape `(space.dim,)` for a function or `(space.dim, d)` for a curve, `d` = 2 or 3.
#[pyclass(frozen, eq, module = "symspline", from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct Spline(pub AnySpline);

#[pymethods]
impl Spline {
    #[new]
    fn new(space: Space, coeffs: Array) -> Result<Self> {
        let dim = coeffs.dim(1)?;
        let exact = space.0.is_exact() && coeffs.numbers.is_exact();
        let (space, coords) = match exact {
            true => (space.0, coeffs.numbers),
            false => (space.0.to_float()?, coeffs.numbers.to_float()?),
        };
        Ok(Self(AnySpline::new(space, dim, coords)?))
    }

    /// The coefficients.
    #[getter]
    fn coeffs(&self) -> Result<Array> {
        let coords = self.0.coords()?;
        let dim = self.0.dim();
        let count = coords.len() / dim;
        Ok(Array::new(if dim > 1 { vec![count, dim] } else { vec![count] }, coords))
    }

    /// The space.
    #[getter]
    fn space(&self) -> Space {
        Space(self.0.space())
    }

    /// The derivative.
    fn derivative(&self, py: Python<'_>) -> Result<Self> {
        Ok(Self(py.detach(|| self.0.derivative())?))
    }

    /// What makes it again, for pickling.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, (Space, Array))> {
        Ok((slf.get_type().into_any(), (slf.get().space(), slf.get().coeffs()?)))
    }

    fn __call__<'py>(&self, py: Python<'py>, x: crate::numbers::Num) -> PyResult<Bound<'py, PyAny>> {
        let value = self.at(&x.0)?;
        point(py, value)
    }
}

impl Spline {
    /// The value at a parameter: a float if the parameter is one, the exact value rounded.
    fn at(&self, x: &Number) -> Result<symspline_dynamic::Coords> {
        let value = self.0.at(x)?;
        Ok(if x.is_exact() { value } else { value.to_float()? })
    }
}
