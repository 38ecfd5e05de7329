//! A mesh with a point a vertex.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::exact::Q;
use crate::mesh::topology::Topology;
use crate::ops::convert::{image, rounded};
use crate::scalar::Scalar;
use nalgebra::SVector;
use std::sync::Arc;

/// A mesh with a point a vertex: what controls a subdivision surface.
///
/// Meshes that differ in their points alone share one [`Topology`].
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::ControlMesh;
/// let points = vec![vector![0.0, 0.0, 0.0], vector![1.0, 0.0, 0.0], vector![0.0, 1.0, 0.0], vector![0.0, 0.0, 1.0]];
/// let tetrahedron = ControlMesh::new(points, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])?;
/// assert!(tetrahedron.topology().is_closed());
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ControlMesh<T: Scalar, const N: usize> {
    topology: Arc<Topology>,
    points: Vec<SVector<T, N>>,
}

impl<T: Scalar, const N: usize> ControlMesh<T, N> {
    /// The mesh of faces given by their corners, counter-clockwise as seen from outside.
    ///
    /// # Errors
    /// Those of [`Topology::new`]; [`Error::NotFinite`].
    pub fn new<F: AsRef<[usize]>>(
        points: Vec<SVector<T, N>>,
        faces: impl IntoIterator<Item = F>,
    ) -> Result<Self> {
        let topology = Topology::new(points.len(), faces)?;
        Self::over(Arc::new(topology), points)
    }

    /// The mesh with a topology that there is already.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there is one point a vertex; [`Error::NotFinite`].
    pub fn over(topology: Arc<Topology>, points: Vec<SVector<T, N>>) -> Result<Self> {
        if points.len() != topology.vertex_count() {
            return Err(Error::CoefficientCount { expected: topology.vertex_count(), found: points.len() });
        }
        match points.iter().position(|point| !point.all_finite()) {
            Some(index) => Err(Error::NotFinite { what: "point", index }),
            None => Ok(Self { topology, points }),
        }
    }

    /// How its faces hang together.
    pub fn topology(&self) -> &Topology {
        &self.topology
    }

    /// The same, to be shared.
    pub fn shared_topology(&self) -> &Arc<Topology> {
        &self.topology
    }

    /// The points of the vertices.
    pub fn points(&self) -> &[SVector<T, N>] {
        &self.points
    }

    /// The mesh with other points.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there is one a vertex; [`Error::NotFinite`].
    pub fn with_points<U: Scalar, const M: usize>(
        &self,
        points: Vec<SVector<U, M>>,
    ) -> Result<ControlMesh<U, M>> {
        ControlMesh::over(self.topology.clone(), points)
    }

    /// The points of the corners of face `f`.
    pub(crate) fn corners(&self, f: usize) -> impl ExactSizeIterator<Item = &SVector<T, N>> {
        self.topology.face(f).map(|v| &self.points[v])
    }

    /// The mean of the corners of face `f`.
    ///
    /// # Panics
    /// If there is no face `f`.
    pub fn centroid(&self, f: usize) -> SVector<T, N> {
        let corners = self.corners(f);
        let sides = T::int(corners.len() as i64);
        let mut sum = SVector::zeros();
        corners.for_each(|corner| sum += corner);
        Coeff::divide(&mut sum, &sides);
        sum
    }

    /// The same mesh over another field.
    ///
    /// # Errors
    /// The first error of the conversion; [`Error::NotFinite`].
    pub fn map_scalars<U: Scalar>(
        &self,
        mut convert: impl FnMut(&T) -> Result<U>,
    ) -> Result<ControlMesh<U, N>> {
        let points = self.points.iter().map(|point| point.try_map(&mut convert)).collect::<Result<_>>()?;
        self.with_points(points)
    }
}

impl<const N: usize> ControlMesh<f64, N> {
    /// The same mesh over the rationals, without loss.
    ///
    /// # Errors
    /// None: the points of a mesh are finite.
    pub fn to_exact(&self) -> Result<ControlMesh<Q, N>> {
        self.map_scalars(image)
    }
}

impl<const N: usize> ControlMesh<Q, N> {
    /// The same mesh with coordinates correctly rounded.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for coordinates beyond floating point.
    ///
    /// # Examples
    /// ```
    /// use symspline::{ControlMesh, Q, Scalar};
    /// let points = [[0, 0], [1, 0], [0, 1]].map(|p| p.map(|x| Q::frac(x, 3)).into());
    /// let triangle = ControlMesh::<Q, 2>::new(points.to_vec(), [[0, 1, 2]])?;
    /// assert_eq!(triangle.to_f64()?.points()[1][0], 1.0 / 3.0);
    /// assert_ne!(triangle.to_f64()?.to_exact()?, triangle);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn to_f64(&self) -> Result<ControlMesh<f64, N>> {
        self.map_scalars(rounded)
    }
}
