//! Numbers and arrays, in and out.

use crate::error::Failure;
use num_rational::BigRational;
use numpy::ndarray::ArrayD;
use numpy::{
    IntoPyArray as _, PyArrayDescrMethods as _, PyArrayDyn, PyReadonlyArrayDyn, PyUntypedArray,
    PyUntypedArrayMethods as _,
};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyFloat, PyInt, PySet, PyString};
use symspline::Q;
use symspline::limits::MAX_ENTRIES;
use symspline_dynamic::{Coords, Field, Number, Over};

/// A number from Python: whole numbers and fractions are exact, floats are floats.
#[derive(Clone, Debug, PartialEq)]
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

impl Num {
    /// A whole number.
    pub fn int(n: i64) -> Self {
        Self(Over::Exact(Q::from(n)))
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

/// One text for two things over one field, which `together!` has seen to.
macro_rules! both_alike {
    ($left:expr, $right:expr, $s:ident, $t:ident => $body:expr) => {
        both_alike!($left, $right, _Field, $s, $t => $body)
    };
    ($left:expr, $right:expr, $T:ident, $s:ident, $t:ident => $body:expr) => {
        match ($left, $right) {
            (symspline_dynamic::Over::Float($s), symspline_dynamic::Over::Float($t)) => {
                #[allow(dead_code, reason = "not every text names its field")]
                type $T = f64;
                $body
            }
            (symspline_dynamic::Over::Exact($s), symspline_dynamic::Over::Exact($t)) => {
                #[allow(dead_code, reason = "not every text names its field")]
                type $T = symspline::Q;
                $body
            }
            (s, t) => Err(symspline_dynamic::Error::Fields { left: s.field(), right: t.field() }.into()),
        }
    };
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
    /// The numbers in one row.
    pub fn row<T: Field>(numbers: Vec<T>) -> Self {
        Self { shape: vec![numbers.len()], numbers: T::coords(numbers) }
    }

    /// The numbers with this shape.
    pub fn new(shape: Vec<usize>, numbers: Coords) -> Self {
        Self { shape, numbers }
    }

    /// Points of `dim` coordinates along the axes of `shape`; numbers, if there is one coordinate.
    pub fn points(mut shape: Vec<usize>, dim: usize, numbers: Coords) -> Self {
        if dim > 1 {
            shape.push(dim);
        }
        Self { shape, numbers }
    }

    /// A list of points of `dim` coordinates: of shape `(n, dim)`, or `(n,)` for one coordinate.
    pub fn of_points(dim: usize, numbers: Coords) -> Self {
        Self::points(vec![numbers.len() / dim.max(1)], dim, numbers)
    }

    /// The numbers, if there is one axis.
    ///
    /// # Errors
    /// "Shape".
    pub fn list(self) -> Result<Coords, Failure> {
        match self.shape.len() {
            1 => Ok(self.numbers),
            n => Err(Failure::new("Shape", format!("an array of one axis is needed, it has {n}"))),
        }
    }

    /// The number of the array, or its numbers if it has one axis: a point.
    ///
    /// # Errors
    /// "Shape".
    pub fn point(self) -> Result<Coords, Failure> {
        if self.shape.is_empty() { Ok(self.numbers) } else { self.list() }
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
            let view = array.as_array();
            let numbers = view.as_slice().map_or_else(|| view.iter().copied().collect(), <[f64]>::to_vec);
            return Ok(Self { shape: array.shape().to_vec(), numbers: Over::Float(numbers) });
        }
        if object.cast::<PyInt>().is_ok() || object.cast::<PyFloat>().is_ok() {
            return object.extract::<Num>().map(|x| Self { shape: Vec::new(), numbers: one(x.0) });
        }
        if let Ok(array) = object.cast::<PyUntypedArray>() {
            return match array.dtype().kind() {
                // Floats of other sizes.
                b'f' => array.call_method1("astype", ("float64",))?.extract(),
                // What is in it tells whether it is exact: whole numbers, or objects.
                b'i' | b'u' | b'b' | b'O' => {
                    let (mut shape, mut all) = (Vec::new(), Vec::new());
                    gather(&array.call_method0("tolist")?, 0, &mut shape, &mut all)?;
                    // An axis of length zero hides those after it.
                    Ok(Self { shape: array.shape().to_vec(), numbers: unite(all) })
                }
                kind => Err(PyTypeError::new_err(format!(
                    "an array of kind '{}' holds no numbers: int, Fraction and float are",
                    char::from(kind)
                ))),
            };
        }
        let (mut shape, mut all) = (Vec::new(), Vec::new());
        gather(&object, 0, &mut shape, &mut all)?;
        Ok(Self { shape, numbers: unite(all) })
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
    let no_list = object.is_instance_of::<PyString>()
        || object.is_instance_of::<PyBytes>()
        || object.is_instance_of::<PyDict>()
        || object.is_instance_of::<PySet>();
    let nested = !no_list && object.len().is_ok();
    if !nested {
        if shape.len() != depth {
            return Err(Failure::new("Ragged", "lists of different depths do not make an array").into());
        }
        if all.len() == MAX_ENTRIES {
            let limit = MAX_ENTRIES;
            return Err(
                Failure::from(symspline::Error::TooLarge { count: limit.saturating_add(1), limit }).into()
            );
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
    // What is iterated over may lie about its length.
    let mut count = 0;
    for inner in object.try_iter()?.take(length.saturating_add(1)) {
        gather(&inner?, depth + 1, shape, all)?;
        count += 1;
    }
    if count != length {
        return Err(Failure::new(
            "Ragged",
            format!("a list of length {length} does not have as many entries"),
        )
        .into());
    }
    Ok(())
}

/// Over fractions if all are, else over floats.
pub fn unite(all: Vec<Number>) -> Coords {
    if all.iter().all(Over::is_exact) {
        let exact = |x: Number| match x {
            Over::Exact(x) => Some(x),
            Over::Float(_) => None,
        };
        return Over::Exact(all.into_iter().filter_map(exact).collect());
    }
    let float = |x: Number| match x {
        Over::Float(x) => x,
        Over::Exact(x) => x.to_f64(),
    };
    Over::Float(all.into_iter().map(float).collect())
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

/// A point or vector: a number if it has one coordinate, else an array of one axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Point(pub Coords);

impl<'py> FromPyObject<'_, 'py> for Point {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        Ok(Self(object.extract::<Array>()?.point()?))
    }
}

impl<'py> IntoPyObject<'py> for Point {
    type Target = PyAny;
    type Output = Bound<'py, PyAny>;
    type Error = PyErr;

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        match self.0 {
            Over::Float(all) if all.len() == 1 => Num(Over::Float(all[0])).into_pyobject(py),
            Over::Exact(all) if all.len() == 1 => fraction(py, &all[0]),
            coords => Array::new(vec![coords.len()], coords).into_pyobject(py),
        }
    }
}
