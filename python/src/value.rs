//! Anything that goes in or comes out: a shape, a mesh, a number or a point.

use crate::error::Failure;
use crate::mesh::Mesh;
use crate::numbers::{Array, Num, Point};
use crate::rational::Rational;
use crate::rational_surface::RationalSurface;
use crate::spline::Spline;
use crate::surface::Surface;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use symspline_dynamic::{Over, Value};

/// A value on its way from Python or to it.
#[derive(Clone, Debug, PartialEq)]
pub struct Thing(pub Value);

impl<V: Into<Value>> From<V> for Thing {
    fn from(value: V) -> Self {
        Self(value.into())
    }
}

/// One text for the classes that values have.
macro_rules! classes {
    ($($kind:ident),+) => {
        impl<'py> FromPyObject<'_, 'py> for Thing {
            type Error = PyErr;

            fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
                $(if let Ok(inner) = object.cast::<$kind>() {
                    return Ok(inner.get().0.clone().into());
                })+
                let Array { shape, numbers } = object.extract()?;
                match (shape.len(), numbers) {
                    (0, Over::Float(all)) if all.len() == 1 => Ok(Over::Float(all[0]).into()),
                    (0, Over::Exact(all)) if all.len() == 1 => Ok(Over::Exact(all[0].clone()).into()),
                    (1, numbers) => Ok(numbers.into()),
                    (axes, _) => {
                        let message = format!("an array of {axes} axes is no number, no point and no shape");
                        Err(Failure::new("Shape", message).into())
                    }
                }
            }
        }

        impl<'py> IntoPyObject<'py> for Thing {
            type Target = PyAny;
            type Output = Bound<'py, PyAny>;
            type Error = PyErr;

            fn into_pyobject(self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
                Ok(match self.0 {
                    Value::Number(x) => Num(x).into_pyobject(py)?,
                    Value::Point(p) => Point(p).into_pyobject(py)?,
                    $(Value::$kind(inner) => $kind(inner).into_pyobject(py)?.into_any(),)+
                    other => return Err(PyTypeError::new_err(format!("{other} has no class here"))),
                })
            }
        }
    };
}

classes!(Spline, Surface, Rational, RationalSurface, Mesh);
