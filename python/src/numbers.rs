//! Numbers and arrays, in and out.

use crate::error::Failure;
use num_rational::BigRational;
use numpy::ndarray::ArrayD;
use numpy::{IntoPyArray as _, PyArrayDyn, PyReadonlyArrayDyn, PyUntypedArrayMethods as _};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PyInt, PyString};
use symspline::Q;
use symspline_dynamic::{Coords, Number, Over};

/// A number from Python: whole numbers and fractions are exact, floats are floats.
#[derive(Debug)]
pub struct Num(pub Number);

impl<'py> FromPyObject<'_, 'py> for Num {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(x) = object.cast::<PyFloat>() {
            return Ok(Self(Over::Float(x.value())));
        }
        if let Ok(x) = object.extract::<i64>() {
            return Ok(Self(Over::Exact(Q::from(x))));
        }
        if let Ok(x) = object.extract::<BigRational>() {
            return Ok(Self(Over::Exact(Q::from(x))));
        }
        // Floats of numpy, and what else turns into a float.
        match object.extract::<f64>() {
            Ok(x) if !object.is_instance_of::<PyString>() => Ok(Self(Over::Float(x))),
            _ => Err(PyTypeError::new_err(format!(
                "{} is no number: int, Fraction and float are",
                object.get_type().name().map(|name| name.to_string()).unwrap_or_default()
            ))),
        }
    }
}

/// A number on its way to Python: a `Fraction` or a float.
impl<'py> IntoPyObject<'py> for Num {
    type Target = PyAny;
    type Output = Bound<'py, PyAny>;
    type Error = PyErr;

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        match self.0 {
            Over::Float(x) => Ok(x.into_pyobject(py)?.into_any()),
            Over::Exact(x) => fraction(py, &x),
        }
    }
}

fn fraction<'py>(py: Python<'py>, x: &Q) -> PyResult<Bound<'py, PyAny>> {
    BigRational::from(x.clone()).into_pyobject(py)
}

/// Numbers with a shape: an array, or lists in lists.
#[derive(Debug)]
pub struct Array {
    /// The shape, as numpy has it.
    pub shape: Vec<usize>,
    /// The numbers, the last index fastest.
    pub numbers: Coords,
}

impl Array {
    /// The numbers with this shape.
    pub fn new(shape: Vec<usize>, numbers: Coords) -> Self {
        Self { shape, numbers }
    }

    /// How many coordinates the points along the first `axes` axes have: one if there is no further axis.
    ///
    /// # Errors
    /// "Shape" unless there are `axes` axes, or one more.
    pub fn dim(&self, axes: usize) -> Result<usize, Failure> {
        match self.shape.len() {
            n if n == axes => Ok(1),
            n if n == axes + 1 => Ok(self.shape[axes]),
            n => Err(Failure::new(
                "Shape",
                format!("an array of {axes} or {} axes is needed, it has {n}", axes + 1),
            )),
        }
    }
}

impl<'py> FromPyObject<'_, 'py> for Array {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(array) = object.extract::<PyReadonlyArrayDyn<'py, f64>>() {
            let shape = array.shape().to_vec();
            return Ok(Self { shape, numbers: Over::Float(array.as_array().iter().copied().collect()) });
        }
        if object.cast::<PyInt>().is_ok() || object.cast::<PyFloat>().is_ok() {
            return object.extract::<Num>().map(|x| Self { shape: Vec::new(), numbers: one(x.0) });
        }
        let (mut shape, mut all) = (Vec::new(), Vec::new());
        gather(&object, 0, &mut shape, &mut all)?;
        Ok(Self { shape, numbers: unite(all)? })
    }
}

fn one(x: Number) -> Coords {
    match x {
        Over::Float(x) => Over::Float(vec![x]),
        Over::Exact(x) => Over::Exact(vec![x]),
    }
}

/// The most axes an array may have.
const AXES: usize = 4;

/// Walks through lists in lists, arrays and whatever else has a length, and notes the shape.
fn gather(
    object: &Bound<'_, PyAny>,
    depth: usize,
    shape: &mut Vec<usize>,
    all: &mut Vec<Number>,
) -> PyResult<()> {
    let nested = !object.is_instance_of::<PyString>() && object.len().is_ok();
    if !nested {
        if shape.len() != depth {
            return Err(Failure::new("Ragged", "lists of different depths do not make an array").into());
        }
        all.push(object.extract::<Num>()?.0);
        return Ok(());
    }
    let length = object.len()?;
    if depth == AXES {
        return Err(Failure::new("Shape", format!("more than {AXES} axes")).into());
    }
    match shape.get(depth) {
        // A list met first, before any number.
        None if all.is_empty() => shape.push(length),
        Some(first) if *first == length => {}
        _ => return Err(Failure::new("Ragged", "lists of different lengths do not make an array").into()),
    }
    object.try_iter()?.try_for_each(|inner| gather(&inner?, depth + 1, shape, all))
}

/// Over fractions if all are, else over floats.
fn unite(all: Vec<Number>) -> PyResult<Coords> {
    if all.iter().all(Over::is_exact) {
        let exact = |x: Number| match x {
            Over::Exact(x) => Some(x),
            Over::Float(_) => None,
        };
        return Ok(Over::Exact(all.into_iter().filter_map(exact).collect()));
    }
    let float = |x: Number| match x {
        Over::Float(x) => x,
        Over::Exact(x) => x.to_f64(),
    };
    Ok(Over::Float(all.into_iter().map(float).collect()))
}

/// Numbers on their way to Python: an array of floats without a copy, or an array of fractions as objects.
impl<'py> IntoPyObject<'py> for Array {
    type Target = PyAny;
    type Output = Bound<'py, PyAny>;
    type Error = PyErr;

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let torn = |_| PyErr::from(Failure::new("Shape", "the numbers do not fill the array"));
        match self.numbers {
            Over::Float(all) => {
                Ok(ArrayD::from_shape_vec(self.shape, all).map_err(torn)?.into_pyarray(py).into_any())
            }
            Over::Exact(all) => {
                let all = all.iter().map(|x| Ok(fraction(py, x)?.unbind())).collect::<PyResult<Vec<_>>>()?;
                let array: Bound<'py, PyArrayDyn<Py<PyAny>>> =
                    ArrayD::from_shape_vec(self.shape, all).map_err(torn)?.into_pyarray(py);
                Ok(array.into_any())
            }
        }
    }
}

/// A point on its way to Python: a number if it has one coordinate, else an array.
pub fn point<'py>(py: Python<'py>, coords: Coords) -> PyResult<Bound<'py, PyAny>> {
    match coords {
        Over::Float(all) if all.len() == 1 => Num(Over::Float(all[0])).into_pyobject(py),
        Over::Exact(all) if all.len() == 1 => fraction(py, &all[0]),
        coords => Array::new(vec![coords.len()], coords).into_pyobject(py),
    }
}
