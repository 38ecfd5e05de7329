//! Meshes.

use crate::error::{Failure, Result};
use crate::numbers::Array;
use pyo3::prelude::*;
use symspline_dynamic::tools::subdivision;
use symspline_dynamic::{AnyMesh, Field, both};

/// A mesh in space: points of shape `(n, 3)`, and faces, each a list of places of points, counter-clockwise as seen from outside.
#[pyclass(frozen, eq, module = "symspline", from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh(pub AnyMesh);

#[pymethods]
impl Mesh {
    #[new]
    fn new(points: Array, faces: Vec<Vec<usize>>) -> Result<Self> {
        match points.shape[..] {
            [_, 3] => Ok(Self(subdivision::mesh(&points.numbers, &faces)?)),
            _ => Err(Failure::new("Shape", "the points of a mesh have shape (n, 3)")),
        }
    }

    /// The points, of shape `(n, 3)`.
    #[getter]
    fn points(&self) -> Array {
        both!(&self.0, m => {
            let coords = m.points().iter().flat_map(|p| p.iter().cloned()).collect();
            Array::new(vec![m.points().len(), 3], Field::coords(coords))
        })
    }

    /// The faces.
    #[getter]
    fn faces(&self) -> Vec<Vec<usize>> {
        both!(&self.0, m => m.topology().faces().collect())
    }

    /// The ends of the edges: values on edges are in this order.
    #[getter]
    fn edges(&self) -> Vec<(usize, usize)> {
        both!(&self.0, m => m.topology().edges().map(|[a, b]| (a, b)).collect())
    }

    /// The edge between two vertices, if there is one.
    fn edge_between(&self, v: usize, w: usize) -> Result<Option<usize>> {
        both!(&self.0, m => {
            let count = m.topology().vertex_count();
            match [v, w].into_iter().find(|i| *i >= count) {
                Some(index) => Err(symspline::Error::IndexOutOfRange { index, length: count }.into()),
                None => Ok(m.topology().edge_between(v, w)),
            }
        })
    }

    /// The number of vertices.
    #[getter]
    fn vertex_count(&self) -> usize {
        both!(&self.0, m => m.topology().vertex_count())
    }

    /// The number of edges.
    #[getter]
    fn edge_count(&self) -> usize {
        both!(&self.0, m => m.topology().edge_count())
    }

    /// The number of faces.
    #[getter]
    fn face_count(&self) -> usize {
        both!(&self.0, m => m.topology().face_count())
    }

    /// Vertices less edges plus faces.
    #[getter]
    fn euler_characteristic(&self) -> isize {
        both!(&self.0, m => m.topology().euler_characteristic())
    }

    /// Whether there is no boundary.
    #[getter]
    fn is_closed(&self) -> bool {
        both!(&self.0, m => m.topology().is_closed())
    }

    /// How many edges there are at each vertex.
    #[getter]
    fn valences(&self) -> Vec<usize> {
        both!(&self.0, m => (0..m.topology().vertex_count()).map(|v| m.topology().valence(v)).collect())
    }

    /// Whether coordinates are fractions.
    #[getter]
    fn is_exact(&self) -> bool {
        self.0.is_exact()
    }

    /// The mesh over fractions, without loss.
    fn to_exact(&self) -> Result<Self> {
        Ok(Self(self.0.to_exact()?))
    }

    /// The mesh rounded to floats.
    fn to_float(&self) -> Result<Self> {
        Ok(Self(self.0.to_float()?))
    }

    fn __repr__(&self) -> String {
        format!("<Mesh: {}>", symspline_dynamic::Value::from(self.0.clone()))
    }

    /// The constructor and its arguments: nothing is lost.
    #[allow(clippy::type_complexity, reason = "it is the tuple that pickle asks for")]
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, (Array, Vec<Vec<usize>>))> {
        let this = slf.get();
        Ok((slf.get_type().into_any(), (this.points(), this.faces())))
    }
}
