//! Catmull and Clark's surfaces, with knot intervals or without.
//!
//! A step of subdivision cuts every face into one four-sided face a corner, with a new point a face and an edge, and
//! moves the vertices. Repeated, the meshes tend to a surface. Around vertices of valence 4 in four-sided faces it is the
//! bicubic B-spline surface of the mesh, and the step is knot insertion in the middle of all spans.

use crate::error::mesh::MeshError;
use crate::error::{Error, Result};
use crate::mesh::boundary::Boundary;
use crate::mesh::build::check_refined;
use crate::mesh::control_mesh::ControlMesh;
use crate::mesh::cubic_rules;
use crate::mesh::interval_rules;
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

    /// The same surface, controlled by the mesh after `depth` steps of subdivision; with `depth == 0` the surface as it
    /// is.
    ///
    /// Vertices of a step are the old ones, then a point an edge, then a point a face, but for those that an open
    /// boundary leaves behind; face `h` is the one at the corner of half-edge `h`. Over equal intervals
    ///
    /// ```text
    /// F = mean of the corners,   E = (P_v + P_w + F_left + F_right) / 4,   V = (F̄ + 2 R̄ + (n - 3) P) / n
    /// ```
    /// with `F̄` and `R̄` the means of the points of the faces and of the middles of the edges around a vertex of valence
    /// `n`. Knot intervals weigh these means as in [Sederberg, 1998]; halves of edges get half the
    /// interval, and an edge from the middle of another into a face gets a quarter of the sum of the intervals before and
    /// after that one in the face.
    ///
    /// At the boundary the cubic B-spline curve over it is refined, `(1, 1) / 2` and `(1, 6, 1) / 8` over equal
    /// intervals. If it is open ([`Boundary::Open`]), only faces around vertices inside stay, so that an `M` by `M` grid
    /// of points becomes one of `2M - 3` by `2M - 3`; a vertex in which faces that stay hang together alone is split in
    /// two.
    ///
    /// # Errors
    /// [`Error::TooLarge`], before any work is done, if there would be too many half-edges: `4^depth` times those of the
    /// mesh, even if an open boundary drops some; [`MeshError::NothingInside`] if nothing is left; [`Error::NotFinite`]
    /// on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Boundary, CatmullClark, ControlMesh, Q, Scalar};
    /// let points = (0..8_i64).map(|i| [i & 1, (i >> 1) & 1, i >> 2].map(|x| Q::int(2 * x - 1)).into()).collect();
    /// let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    /// let cube = CatmullClark::new(ControlMesh::new(points, faces)?, Boundary::Smooth);
    /// let fine = cube.refined(2)?;
    /// assert_eq!(fine.mesh().topology().face_count(), 96);
    /// assert_eq!(cube.refined(1)?.mesh().points()[7][0], Q::frac(5, 9));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn refined(&self, depth: usize) -> Result<Self> {
        check_refined(self.mesh.topology().half_edge_count(), depth)?;
        (0..depth).try_fold(self.clone(), |surface, _| Ok(surface.step()?.0))
    }

    /// One step, and the number of each vertex among all points after a step, if some were left behind.
    pub(super) fn step(&self) -> Result<(Self, Option<Vec<u32>>)> {
        let coarse = self.mesh.topology();
        let inside = |v: usize| !coarse.is_boundary(v);
        let open = self.boundary == Boundary::Open && !coarse.is_closed();
        if open && !(0..coarse.vertex_count()).any(inside) {
            return Err(MeshError::NothingInside { what: "vertex" }.into());
        }
        let (fine, corners) = (coarse.quartered()?, self.boundary == Boundary::Corners);
        let points = match &self.intervals {
            None => cubic_rules::points(&self.mesh, corners),
            // An open boundary goes on mirrored, as corners do.
            Some(d) => interval_rules::points(&self.mesh, d, corners || open),
        };
        let intervals = self.intervals.as_ref().map(|d| interval_rules::intervals(coarse, d));
        let whole =
            Self { mesh: ControlMesh::over(fine.into(), points)?, intervals, boundary: self.boundary };
        if !open {
            return Ok((whole, None));
        }
        // Face `h` is at the origin of half-edge `h`.
        let part = whole.part(|h| inside(coarse.origin(h)));
        let (inner, vertices) = part.expect("a vertex inside has faces");
        Ok((inner, Some(vertices)))
    }

    /// The surface of the faces that `keep` keeps, and the number that each of its vertices had.
    pub(super) fn part(&self, keep: impl Fn(usize) -> bool) -> Option<(Self, Vec<u32>)> {
        let part = self.mesh.topology().part(keep)?;
        let points = part.vertices.iter().map(|v| self.mesh.points()[*v as usize].clone()).collect();
        let mesh =
            ControlMesh::over(part.topology.into(), points).expect("a point a vertex, finite as before");
        let kept = |d: &Vec<T>| part.edges.iter().map(|e| d[*e as usize].clone()).collect();
        let intervals = self.intervals.as_ref().map(kept);
        Some((Self { mesh, intervals, boundary: self.boundary }, part.vertices))
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
