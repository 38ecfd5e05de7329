//! Whatever an operator gives: one of the classes, a number or a point.

use crate::error::Failure;
use crate::numbers::{Array, Num, point};
use crate::rational::Rational;
use crate::rational_surface::RationalSurface;
use crate::spline::Spline;
use crate::surface::Surface;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use symspline_dynamic::{Coords, Over, Value};

/// A value on its way from Python or to it.
#[derive(Debug)]
pub struct Operand(pub Value);

impl<'py> FromPyObject<'_, 'py> for Operand {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(s) = object.cast::<Spline>() {
            return Ok(Self(s.get().0.clone().into()));
        }
        if let Ok(s) = object.cast::<Surface>() {
            return Ok(Self(s.get().0.clone().into()));
        }
        if let Ok(s) = object.cast::<Rational>() {
            return Ok(Self(s.get().0.clone().into()));
        }
        if let Ok(s) = object.cast::<RationalSurface>() {
            return Ok(Self(s.get().0.clone().into()));
        }
        let array = object.extract::<Array>()?;
        match array.shape.len() {
            0 => Ok(Self(number(array.numbers)?.into())),
            1 => Ok(Self(array.numbers.into())),
            _ => Err(PyTypeError::new_err("an array of more than one axis is no point")),
        }
    }
}

fn number(coords: Coords) -> Result<symspline_dynamic::Number, Failure> {
    let none = || Failure::new("Shape", "an array without a number");
    Ok(match coords {
        Over::Float(x) => Over::Float(*x.first().ok_or_else(none)?),
        Over::Exact(x) => Over::Exact(x.into_iter().next().ok_or_else(none)?),
    })
}

impl<'py> IntoPyObject<'py> for Operand {
    type Target = PyAny;
    type Output = Bound<'py, PyAny>;
    type Error = PyErr;

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        Ok(match self.0 {
            Value::Number(x) => Num(x).into_pyobject(py)?,
            Value::Point(p) => point(py, p)?,
            Value::Spline(s) => Spline(s).into_pyobject(py)?.into_any(),
            Value::Surface(s) => Surface(s).into_pyobject(py)?.into_any(),
            Value::Rational(s) => Rational(s).into_pyobject(py)?.into_any(),
            Value::RationalSurface(s) => RationalSurface(s).into_pyobject(py)?.into_any(),
            other => return Err(PyTypeError::new_err(format!("{other} has no class here"))),
        })
    }
}
