//! Meshes.

use crate::error::{Failure, Result};
use crate::numbers::{Array, Point};
use pyo3::prelude::*;
use symspline_dynamic::tools::subdivision;
use symspline_dynamic::{AnyMesh, Field, both};

/// A mesh in space: points of shape `(n, 3)`, and faces, each a list of places of points, counter-clockwise as seen from outside.
#[pyclass(frozen, eq, module = "symspline", from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh(pub AnyMesh);

/// The index, if there is such a thing.
fn within(index: usize, length: usize) -> Result<usize> {
    if index < length { Ok(index) } else { Err(symspline::Error::IndexOutOfRange { index, length }.into()) }
}

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
            Ok(m.topology().edge_between(within(v, count)?, within(w, count)?))
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

    /// The boundaries, each a chain of vertices with the surface on its left.
    #[getter]
    fn boundaries(&self) -> Vec<Vec<usize>> {
        both!(&self.0, m => {
            let t = m.topology();
            t.boundaries().into_iter().map(|chain| chain.into_iter().map(|h| t.origin(h)).collect()).collect()
        })
    }

    /// The edges at a vertex, counter-clockwise: at the boundary from the first to the last.
    fn edges_at(&self, v: usize) -> Result<Vec<usize>> {
        both!(&self.0, m => Ok(m.topology().edges_at(within(v, m.topology().vertex_count())?).collect()))
    }

    /// The faces at a vertex, counter-clockwise: at the boundary from the first to the last.
    fn faces_at(&self, v: usize) -> Result<Vec<usize>> {
        both!(&self.0, m => {
            let t = m.topology();
            Ok(t.leaving(within(v, t.vertex_count())?).map(|h| t.face_of(h)).collect())
        })
    }

    /// The corners at a vertex, in the order of `faces_at`. Corners are counted face by face, in the order of `faces`: they are the
    /// vertices of a converted surface, and what `fixed_corners` names.
    fn corners_at(&self, v: usize) -> Result<Vec<usize>> {
        both!(&self.0, m => Ok(m.topology().leaving(within(v, m.topology().vertex_count())?).collect()))
    }

    /// The edges of a face, each from a vertex in `faces` to the next.
    fn edges_of(&self, f: usize) -> Result<Vec<usize>> {
        both!(&self.0, m => {
            let t = m.topology();
            Ok(t.sides(within(f, t.face_count())?).map(|h| t.edge_of(h)).collect())
        })
    }

    /// The faces beside an edge: two, or one at the boundary. The first is on its left.
    fn faces_beside(&self, e: usize) -> Result<Vec<usize>> {
        both!(&self.0, m => {
            let t = m.topology();
            let side = t.side(within(e, t.edge_count())?);
            Ok([Some(side), t.twin(side)].into_iter().flatten().map(|h| t.face_of(h)).collect())
        })
    }

    /// The mean of the corners of a face.
    fn centroid(&self, f: usize) -> Result<Point> {
        both!(&self.0, m => {
            let centroid = m.centroid(within(f, m.topology().face_count())?);
            Ok(Point(Field::coords(centroid.iter().cloned().collect())))
        })
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
