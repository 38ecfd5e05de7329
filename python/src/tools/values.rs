//! What goes in and comes out of tools: names of control points, lists, spaces.

use crate::space::Space;
use pyo3::prelude::*;

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

/// A space, or one for each direction.
#[derive(Debug, FromPyObject)]
pub enum Spaces {
    /// Of a curve.
    One(Space),
    /// Of a surface.
    Two(Space, Space),
}
