//! What goes in and comes out of tools: shapes, places, names of control points, words.

use crate::error::{Failure, Result};
use crate::numbers::{Array, Num, point};
use crate::rational::Rational;
use crate::rational_surface::RationalSurface;
use crate::space::Space;
use crate::spline::Spline;
use crate::surface::Surface;
use crate::tools::mesh::Mesh;
use pyo3::prelude::*;
use symspline_dynamic::{AnySpace, AnySpline, AnySurface, Coords, Number, Over, Value};

/// Any value: a shape, a mesh, a number, a point.
#[derive(Clone, Debug)]
pub struct Thing(pub Value);

impl<'py> FromPyObject<'_, 'py> for Thing {
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
        if let Ok(m) = object.cast::<Mesh>() {
            return Ok(Self(m.get().0.clone().into()));
        }
        let array: Array = object.extract()?;
        match (array.shape.len(), array.numbers) {
            (0, Over::Float(all)) if all.len() == 1 => Ok(Self(Over::Float(all[0]).into())),
            (0, Over::Exact(all)) if all.len() == 1 => Ok(Self(Over::Exact(all[0].clone()).into())),
            (1, numbers) => Ok(Self(numbers.into())),
            _ => Err(Failure::new("Shape", "a shape, a mesh, a number or a point is needed").into()),
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
            Value::Point(p) => point(py, p)?,
            Value::Spline(s) => Spline(s).into_pyobject(py)?.into_any(),
            Value::Surface(s) => Surface(s).into_pyobject(py)?.into_any(),
            Value::Rational(s) => Rational(s).into_pyobject(py)?.into_any(),
            Value::RationalSurface(s) => RationalSurface(s).into_pyobject(py)?.into_any(),
            Value::Mesh(m) => Mesh(m).into_pyobject(py)?.into_any(),
            other => return Err(Failure::new("NoSuch", format!("no class for: {other}")).into()),
        })
    }
}

impl<V: Into<Value>> From<V> for Thing {
    fn from(value: V) -> Self {
        Self(value.into())
    }
}

/// Points on their way out, as many coordinates each: an array, of shape `(n,)` for one coordinate.
#[derive(Clone, Debug)]
pub struct Points {
    /// How many coordinates a point has.
    pub dim: usize,
    /// The coordinates, one after the other.
    pub coords: Coords,
}

impl Points {
    /// As an array.
    pub fn array(self) -> Array {
        let count = self.coords.len() / self.dim.max(1);
        Array::new(if self.dim > 1 { vec![count, self.dim] } else { vec![count] }, self.coords)
    }
}

impl<'py> IntoPyObject<'py> for Points {
    type Target = PyAny;
    type Output = Bound<'py, PyAny>;
    type Error = PyErr;

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.array().into_pyobject(py)
    }
}

/// A point or vector on its way in or out: a number, or numbers.
#[derive(Clone, Debug)]
pub struct Point(pub Coords);

impl<'py> FromPyObject<'_, 'py> for Point {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let array: Array = object.extract()?;
        match array.shape.len() {
            0 | 1 => Ok(Self(array.numbers)),
            n => {
                Err(Failure::new("Shape", format!("a number or a list of them is needed, not {n} axes"))
                    .into())
            }
        }
    }
}

impl<'py> IntoPyObject<'py> for Point {
    type Target = PyAny;
    type Output = Bound<'py, PyAny>;
    type Error = PyErr;

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        point(py, self.0)
    }
}

/// The name of a control point, or an order of derivatives: a number, or two.
#[derive(Clone, Debug)]
pub struct Name(pub Vec<usize>);

impl<'py> FromPyObject<'_, 'py> for Name {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        match object.extract::<usize>() {
            Ok(k) => Ok(Self(vec![k])),
            Err(_) => object.extract::<Vec<usize>>().map(Self),
        }
    }
}

/// Either one or several.
#[derive(Debug, FromPyObject)]
pub enum OneOrMore<T> {
    /// One.
    One(T),
    /// Several.
    More(Vec<T>),
}

impl<T> OneOrMore<T> {
    /// As a list.
    pub fn list(self) -> Vec<T> {
        match self {
            Self::One(one) => vec![one],
            Self::More(all) => all,
        }
    }
}

/// A number out.
pub fn num(x: Number) -> Thing {
    Thing(x.into())
}

/// Two numbers out.
pub fn pair((a, b): (Number, Number)) -> (Thing, Thing) {
    (num(a), num(b))
}

/// The number zero, for what is not given.
pub fn zero() -> Num {
    Num(Over::Exact(symspline::Scalar::int(0)))
}

/// What is exact, or can be rounded to floats.
pub trait Rounded: Clone {
    /// Whether it is exact.
    fn exact(&self) -> bool;

    /// The same over floats.
    ///
    /// # Errors
    /// Those of the library.
    fn rounded(&self) -> symspline_dynamic::Result<Self>;
}

macro_rules! rounded {
    ($($kind:ty),+) => {
        $(impl Rounded for $kind {
            fn exact(&self) -> bool {
                self.is_exact()
            }

            fn rounded(&self) -> symspline_dynamic::Result<Self> {
                self.to_float()
            }
        })+
    };
}

rounded!(Value, AnySpline, AnySurface, AnySpace, Coords, Number);

/// Over floats unless all numbers are exact.
pub fn over<A: Rounded>(a: A, exact: bool) -> Result<A> {
    Ok(if exact || !a.exact() { a } else { a.rounded()? })
}

/// Both over floats if either is, or if not all numbers are exact.
pub fn together<A: Rounded, B: Rounded>(a: A, b: B, exact: bool) -> Result<(A, B)> {
    let exact = exact && a.exact() && b.exact();
    Ok((over(a, exact)?, over(b, exact)?))
}

/// The one a word names, of those there are.
pub fn word<T: Copy>(what: &str, word: &str, all: &[(&str, T)]) -> Result<T> {
    match all.iter().find(|(name, _)| *name == word) {
        Some((_, one)) => Ok(*one),
        None => {
            let names: Vec<String> = all.iter().map(|(name, _)| format!("\"{name}\"")).collect();
            Err(Failure::new("Word", format!("{what} is one of {}, not \"{word}\"", names.join(", "))))
        }
    }
}

/// A space, or one for each direction.
#[derive(Debug, FromPyObject)]
pub enum Spaces {
    /// Of a curve.
    One(Space),
    /// Of a surface.
    Two(Space, Space),
}

/// A class of named results.
macro_rules! record {
    ($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident: $type:ty,)+ }) => {
        $(#[$doc])*
        #[pyclass(frozen, get_all, module = "symspline")]
        #[derive(Clone, Debug)]
        pub struct $name {
            $($(#[$field_doc])* pub $field: $type,)+
        }
    };
}
pub(crate) use record;
