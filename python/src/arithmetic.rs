//! Signs of arithmetic, and what all four classes have in common.

use crate::error::Result;
use crate::numbers::{Array, Num};
use crate::rational::Rational;
use crate::rational_surface::RationalSurface;
use crate::spline::Spline;
use crate::surface::Surface;
use crate::value::Thing;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use symspline_dynamic::{Any, Coords, Family, Field, Value, alike, together};

/// An operation of two values over the field in which they meet.
fn binary(
    py: Python<'_>,
    left: Value,
    right: Value,
    operation: fn(&Value, &Value) -> symspline_dynamic::Result<Value>,
) -> Result<Thing> {
    let (s, t) = (&left, &right);
    together!(s, t);
    py.detach(|| Ok(operation(&s, &t)?.into()))
}

/// The images of values under a matrix of shape `(rows, dim)`.
fn transformed<F: Family>(
    s: &Any<F>,
    matrix: Array,
    image: impl Fn(&Any<F>, &Coords) -> symspline_dynamic::Result<Any<F>>,
) -> Result<Any<F>> {
    let rows = match matrix.shape[..] {
        [rows, columns] if columns == s.dim() && rows > 0 => rows,
        _ => {
            return Err(crate::error::Failure::new(
                "Shape",
                format!("a matrix with {} columns is needed, it has shape {:?}", s.dim(), matrix.shape),
            ));
        }
    };
    if rows > 3 {
        return Err(symspline_dynamic::Error::Dimension { found: rows, least: 1 }.into());
    }
    let matrix = &matrix.numbers;
    together!(s, matrix);
    Ok(image(&s, &matrix)?)
}

macro_rules! arithmetic {
    ($class:ident) => {
        #[pymethods]
        impl $class {
            // Arrays leave the signs to this class.
            #[classattr]
            #[pyo3(name = "__array_ufunc__")]
            fn array_ufunc() -> Option<bool> {
                None
            }

            /// Whether numbers are fractions.
            #[getter]
            fn is_exact(&self) -> bool {
                self.0.is_exact()
            }

            /// How many coordinates the values have.
            #[getter]
            fn dimension(&self) -> usize {
                self.0.dim()
            }

            /// The same over fractions, without loss.
            fn to_exact(&self) -> Result<Self> {
                Ok(Self(self.0.to_exact()?))
            }

            /// The same rounded to floats.
            fn to_float(&self) -> Result<Self> {
                Ok(Self(self.0.to_float()?))
            }

            fn __add__(&self, py: Python<'_>, other: Thing) -> Result<Thing> {
                binary(py, self.0.clone().into(), other.0, Value::sum)
            }

            fn __radd__(&self, py: Python<'_>, other: Thing) -> Result<Thing> {
                binary(py, other.0, self.0.clone().into(), Value::sum)
            }

            fn __sub__(&self, py: Python<'_>, other: Thing) -> Result<Thing> {
                binary(py, self.0.clone().into(), other.0, Value::difference)
            }

            fn __rsub__(&self, py: Python<'_>, other: Thing) -> Result<Thing> {
                binary(py, other.0, self.0.clone().into(), Value::difference)
            }

            fn __mul__(&self, py: Python<'_>, other: Thing) -> Result<Thing> {
                binary(py, self.0.clone().into(), other.0, Value::product)
            }

            fn __rmul__(&self, py: Python<'_>, other: Thing) -> Result<Thing> {
                binary(py, other.0, self.0.clone().into(), Value::product)
            }

            fn __truediv__(&self, py: Python<'_>, other: Thing) -> Result<Thing> {
                binary(py, self.0.clone().into(), other.0, Value::quotient)
            }

            fn __rtruediv__(&self, py: Python<'_>, other: Thing) -> Result<Thing> {
                binary(py, other.0, self.0.clone().into(), Value::quotient)
            }

            fn __matmul__(&self, py: Python<'_>, other: Thing) -> Result<Thing> {
                binary(py, self.0.clone().into(), other.0, Value::dot)
            }

            fn __rmatmul__(&self, py: Python<'_>, other: Array) -> Result<Thing> {
                match other.shape.len() {
                    2 => Ok(self.transformed(py, other)?.0.into()),
                    _ => binary(py, Value::Point(other.point()?), self.0.clone().into(), Value::dot),
                }
            }

            fn __pow__(&self, py: Python<'_>, exponent: usize, modulo: Option<Bound<'_, PyAny>>) -> PyResult<Thing> {
                if modulo.is_some() {
                    return Err(PyTypeError::new_err("splines have no powers by a modulus"));
                }
                let value = Value::from(self.0.clone());
                Ok(py.detach(|| Result::Ok(value.power(exponent)?.into()))?)
            }

            fn __neg__(&self, py: Python<'_>) -> Result<Self> {
                py.detach(|| Ok(Self(self.0.scaled(&Num::int(-1).0)?)))
            }

            fn __pos__(slf: Py<Self>) -> Py<Self> {
                slf
            }

            /// The inner products of the values with those of another, or with a point: a function. Also `self @ other`.
            fn dot(&self, py: Python<'_>, other: Thing) -> Result<Thing> {
                self.__matmul__(py, other)
            }

            /// The cross products of the values with those of another: in the plane a function, in space vectors.
            fn cross(&self, py: Python<'_>, other: Thing) -> Result<Thing> {
                binary(py, self.0.clone().into(), other.0, Value::cross)
            }

            /// One coordinate, a function.
            fn coordinate(&self, axis: usize) -> Result<Self> {
                Ok(Self(self.0.coordinate(axis)?))
            }

            /// The image under a matrix of shape `(rows, dimension)`. Also `matrix @ self`.
            fn transformed(&self, py: Python<'_>, matrix: Array) -> Result<Self> {
                py.detach(|| Ok(Self(transformed(&self.0, matrix, |s, m| s.transformed(m))?)))
            }

            /// This plus a multiple of another.
            fn plus_scaled(&self, py: Python<'_>, factor: Num, other: &Self) -> Result<Self> {
                let (s, x, t) = (&self.0, &factor.0, &other.0);
                together!(s, x, t);
                py.detach(|| alike!(&*s, &*t, s, t => Ok(Self(s.plus_scaled(&Field::of(&x)?, t)?.into()))))
            }

            /// Whether both have the same values everywhere, whatever spaces they are in. `==` compares spaces and coefficients.
            fn same_function(&self, py: Python<'_>, other: &Self) -> Result<bool> {
                let (s, t) = (&self.0, &other.0);
                together!(s, t);
                py.detach(|| Ok(s.same_function(&t)?))
            }

            fn __repr__(&self) -> String {
                format!("<{}: {}>", stringify!($class), Value::from(self.0.clone()))
            }

            fn __copy__(slf: Py<Self>) -> Py<Self> {
                slf
            }

            fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
                slf
            }
        }
    };
}

arithmetic!(Spline);
arithmetic!(Surface);
arithmetic!(Rational);
arithmetic!(RationalSurface);
