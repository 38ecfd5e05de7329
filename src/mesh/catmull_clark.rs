//! Catmull and Clark's surfaces, with knot intervals or without.

use crate::error::mesh::MeshError;
use crate::error::{Error, Result};
use crate::mesh::boundary::Boundary;
use crate::mesh::control_mesh::ControlMesh;
use crate::scalar::Scalar;

/// A Catmull-Clark surface: a control mesh, the knot interval of each edge, and what becomes of the boundary.
#[derive(Clone, Debug, PartialEq)]
pub struct CatmullClark<T: Scalar, const N: usize> {
    mesh: ControlMesh<T, N>,
    /// One an edge; none if all are equal.
    intervals: Option<Vec<T>>,
    boundary: Boundary,
}

impl<T: Scalar, const N: usize> CatmullClark<T, N> {
    /// The surface of a mesh whose knot intervals are all equal.
    pub fn new(mesh: ControlMesh<T, N>, boundary: Boundary) -> Self {
        Self { mesh, intervals: None, boundary }
    }

    /// The surface of a mesh with a knot interval an edge.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there is one an edge; [`Error::NotFinite`]; [`MeshError::NegativeInterval`].
    pub fn with_intervals(mesh: ControlMesh<T, N>, intervals: Vec<T>, boundary: Boundary) -> Result<Self> {
        let expected = mesh.topology().edge_count();
        if intervals.len() != expected {
            return Err(Error::CoefficientCount { expected, found: intervals.len() });
        }
        check_intervals(&intervals)?;
        Ok(Self { mesh, intervals: Some(intervals), boundary })
    }

    /// The control mesh.
    pub fn mesh(&self) -> &ControlMesh<T, N> {
        &self.mesh
    }

    /// The knot interval of each edge; none if all are equal.
    pub fn intervals(&self) -> Option<&[T]> {
        self.intervals.as_deref()
    }

    /// What becomes of the boundary.
    pub fn boundary(&self) -> Boundary {
        self.boundary
    }
}

/// Refuses knot intervals that are negative or no numbers.
pub(super) fn check_intervals<'a, T: Scalar>(intervals: impl IntoIterator<Item = &'a T>) -> Result<()> {
    for (index, interval) in intervals.into_iter().enumerate() {
        if !interval.is_finite() {
            return Err(Error::NotFinite { what: "knot interval", index });
        }
        if *interval < T::zero() {
            return Err(MeshError::NegativeInterval { index, interval: interval.to_string() }.into());
        }
    }
    Ok(())
}
