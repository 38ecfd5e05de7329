//! Rational functions of two parameters and surfaces.

use crate::error::Result;
use crate::numbers::{Array, Num, point};
use crate::space::Space;
use pyo3::prelude::*;
use symspline_dynamic::AnyRationalSurface;

/// A rational spline of two parameters.
#[pyclass(frozen, eq, module = "symspline", from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct RationalSurface(pub AnyRationalSurface);

#[pymethods]
impl RationalSurface {
    #[new]
    fn new(u: Space, v: Space, points: Array, weights: Array) -> Result<Self> {
        let dim = points.dim(2)?;
        let exact =
            u.0.is_exact() && v.0.is_exact() && points.numbers.is_exact() && weights.numbers.is_exact();
        Ok(Self(match exact {
            true => AnyRationalSurface::new(u.0, v.0, dim, points.numbers, weights.numbers)?,
            false => AnyRationalSurface::new(
                u.0.to_float()?,
                v.0.to_float()?,
                dim,
                points.numbers.to_float()?,
                weights.numbers.to_float()?,
            )?,
        }))
    }

    /// The control points.
    #[getter]
    fn points(&self) -> Result<Array> {
        let dims: Vec<usize> =
            self.0.spaces().iter().map(|s| symspline_dynamic::both!(s, s => s.dim())).collect();
        let dim = self.0.dim();
        let shape = if dim > 1 { [dims, vec![dim]].concat() } else { dims };
        Ok(Array::new(shape, self.0.coords()?))
    }

    fn __call__<'py>(&self, py: Python<'py>, u: Num, v: Num) -> PyResult<Bound<'py, PyAny>> {
        let value = self.0.at(&u.0, &v.0).map_err(crate::error::Failure::from)?;
        let value = if u.0.is_exact() && v.0.is_exact() {
            value
        } else {
            value.to_float().map_err(crate::error::Failure::from)?
        };
        point(py, value)
    }
}
