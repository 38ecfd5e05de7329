//! Doo and Sabin's surfaces, with knot intervals or without: biquadratic B-spline surfaces where four faces meet around faces of
//! four sides.
//!
//! A step of subdivision moves the corners of each face inwards and makes them the new vertices. With equal intervals the new
//! corners of a face with the corners `P_0 .. P_{n-1}` are
//!
//! ```text
//! P̄_i = Σ_j a_ij P_j,   a_ii = (n + 5) / 4n,   a_ij = (3 + 2 cos(2π (i - j) / n)) / 4n
//! ```
//! Knot intervals are those of [Sederberg, 1998]: a vertex has one for each edge at it, so that an edge between the vertices `i` and `j`
//! has an interval `d_ij` at `i` and another, `d_ji`, at `j`. Then
//!
//! ```text
//! P̄_i = (V + P_i) / 2 + (c_{i+2} + c_{i-2}) / (8 Σ c) · (-n P_i + Σ_j (1 + 2 cos(2π (i - j) / n)) P_j)
//! c_k = d_{k-1,k} d_{k+1,k},   V = Σ c_k P_k / Σ c
//! ```
//! where an edge both of whose intervals vanish counts as one with equal intervals (the sum of those in the face, or 1), and where `P_i`
//! stays if all `c` vanish.
//! The new intervals are the halves of those at the same vertex in the same direction: straight through a new vertex, as two of its
//! four edges go, both are equal.
//!
//! At a boundary that is not [`Boundary::Open`] the two edges of a face beside a boundary edge count as if they had the interval zero at their
//! ends there, as at the end of a clamped spline; the corners at a boundary edge follow Chaikin's rule along the boundary, whatever the
//! face; a vertex in one face alone stays, also for [`Boundary::Smooth`], since a face has one new corner there. A boundary vertex in three
//! or more faces becomes a face, which keeps the boundary a spline, but leaves ever more such vertices along it. Faces with five or more
//! sides shrink ever more slowly at such a boundary, the more sides they have.

use crate::error::{Error, Result};
use crate::mesh::boundary::Boundary;
use crate::mesh::build::check_refined;
use crate::mesh::catmull_clark::{CatmullClark, check_intervals};
use crate::mesh::control_mesh::ControlMesh;
use crate::mesh::corner_rule::CornerRule;
use crate::mesh::face_rule::{FaceRule, Waves};
use crate::scalar::Scalar;
use nalgebra::SVector;

/// A Doo-Sabin surface: a control mesh, knot intervals, and what becomes of the boundary.
///
/// # Examples
/// Around a vertex where three faces meet there comes to be a triangle:
/// ```
/// use nalgebra::vector;
/// use symspline::{Boundary, ControlMesh, DooSabin, Q, Scalar};
/// let points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]].map(|p| p.map(Q::int).into());
/// let tetrahedron = ControlMesh::new(points.to_vec(), [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])?;
/// let fine = DooSabin::new(tetrahedron, Boundary::Smooth).refined(1)?;
/// assert_eq!(fine.mesh().points()[0], vector![2, 2, 0].map(|x| Q::frac(x, 3)));
/// assert_eq!(fine.mesh().topology().face_count(), 4 + 6 + 4);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct DooSabin<T: Scalar, const N: usize> {
    mesh: ControlMesh<T, N>,
    /// For each edge the one at the origin of its side, and the one at the other end; none if all are equal.
    intervals: Option<Vec<[T; 2]>>,
    boundary: Boundary,
}

impl<T: Scalar, const N: usize> DooSabin<T, N> {
    /// The surface of a mesh whose knot intervals are all equal.
    pub fn new(mesh: ControlMesh<T, N>, boundary: Boundary) -> Self {
        Self { mesh, intervals: None, boundary }
    }

    /// The surface of a mesh with two knot intervals an edge: at the origin of its [side](crate::Topology::side), and at the other end.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there are two an edge; [`Error::NotFinite`];
    /// [`MeshError::NegativeInterval`](crate::MeshError::NegativeInterval); both count single intervals.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Boundary, ControlMesh, DooSabin, Q, Scalar};
    /// let points = [[0, 0], [4, 0], [4, 4], [0, 4]].map(|p| p.map(Q::int).into());
    /// let square = ControlMesh::new(points.to_vec(), [[0, 1, 2, 3]])?;
    /// // One knot span of 1 and one of 3 in each direction.
    /// let [one, three] = [1, 3].map(Q::int);
    /// let [up, down] = [[one.clone(), three.clone()], [three, one]];
    /// let intervals = vec![up.clone(), up, down.clone(), down];
    /// let surface = DooSabin::with_intervals(square, intervals, Boundary::Open)?;
    /// assert_eq!(surface.limit_points()?, [vector![Q::int(1), Q::int(1)]]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn with_intervals(
        mesh: ControlMesh<T, N>,
        intervals: Vec<[T; 2]>,
        boundary: Boundary,
    ) -> Result<Self> {
        let expected = mesh.topology().edge_count();
        if intervals.len() != expected {
            return Err(Error::CoefficientCount { expected, found: intervals.len() });
        }
        check_intervals(intervals.iter().flatten())?;
        Ok(Self { mesh, intervals: Some(intervals), boundary })
    }

    /// The control mesh.
    pub fn mesh(&self) -> &ControlMesh<T, N> {
        &self.mesh
    }

    /// For each edge the knot intervals at the origin of its [side](crate::Topology::side) and at the other end; none if all are equal.
    pub fn intervals(&self) -> Option<&[[T; 2]]> {
        self.intervals.as_deref()
    }

    /// What becomes of the boundary.
    pub fn boundary(&self) -> Boundary {
        self.boundary
    }

    /// The same surface over the mesh that `depth` steps of subdivision give.
    ///
    /// A step takes time linear in the number of corners. A vertex inside with two edges leaves a face with two sides, which
    /// [`Topology::new`](crate::Topology::new) would refuse.
    ///
    /// # Errors
    /// [`MeshError::IrrationalWeights`](crate::MeshError::IrrationalWeights) over an exact field unless every face has 2, 3, 4 or 6 sides;
    /// [`Error::TooLarge`]; [`Error::NotFinite`] if numbers overflow.
    pub fn refined(&self, depth: usize) -> Result<Self> {
        check_refined(self.mesh.topology().half_edge_count(), depth)?;
        (0..depth).try_fold(self.clone(), |coarse, _| coarse.step())
    }

    fn step(&self) -> Result<Self> {
        let fine = self.mesh.topology().shrunk(self.filled())?;
        let points = self.moved(FaceRule::DooSabin)?;
        let half = T::frac(1, 2);
        let halved = |pair: [T; 2]| pair.map(|d| d * &half);
        let intervals = self.intervals().map(|_| self.spread().into_iter().map(halved).collect());
        Ok(Self { mesh: ControlMesh::over(fine.into(), points)?, intervals, boundary: self.boundary })
    }

    /// Whether vertices of the boundary in three or more faces become faces.
    fn filled(&self) -> bool {
        self.boundary != Boundary::Open
    }

    /// The corners of all faces, moved by a rule.
    fn moved(&self, rule: FaceRule) -> Result<Vec<SVector<T, N>>> {
        let topology = self.mesh.topology();
        let mut moved = Vec::with_capacity(topology.half_edge_count());
        let rule_of_corners = self.rule();
        // A step leaves behind what lies beyond an open boundary; knot intervals there would be needed for another kind of surface.
        let mut corners = match rule {
            FaceRule::DooSabin => rule_of_corners,
            FaceRule::Elevation => rule_of_corners.clipped(),
        };
        let (mut face, mut waves) = (Vec::new(), Waves::default());
        for f in 0..topology.face_count() {
            face.clear();
            face.extend(self.mesh.corners(f).cloned());
            if corners.is_even(f) {
                rule.apply(&face, &mut waves, &mut moved)?;
            } else {
                corners.apply(rule.share(), f, &face, &mut waves, &mut moved)?;
            }
        }
        Ok(moved)
    }

    pub(super) fn rule(&self) -> CornerRule<'_, T, N> {
        CornerRule::new(&self.mesh, self.intervals(), self.boundary)
    }

    /// The shares of the two knot intervals of the edge of half-edge `h` in their sum, as they count in its face once converted: at
    /// every boundary the surface is then clamped.
    pub(crate) fn shares(&self, h: usize) -> [T; 2] {
        // Halves, as sums of floats may overflow.
        let rule = CornerRule::new(&self.mesh, self.intervals(), Boundary::Corners);
        let [near, far] = rule.side(h).map(|d| d * T::frac(1, 2));
        let whole = near.clone() + &far;
        if whole.is_zero() { [T::frac(1, 2), T::frac(1, 2)] } else { [near / &whole, far / &whole] }
    }

    /// The knot intervals at the new vertices, in the directions of the new edges in their order (see `dual`), before any refinement.
    fn spread(&self) -> Vec<[T; 2]> {
        let topology = self.mesh.topology();
        let rule = self.rule();
        let along = |h: usize| [rule.interval(h, false), rule.interval(h, true)];
        let mut spread: Vec<[T; 2]> = (0..topology.half_edge_count()).map(along).collect();
        // Between the corners `h` and `g` of a vertex, which comes before: as the edges beyond them, at that vertex.
        let around = |h: usize, g: usize| [rule.interval(topology.prev(h), true), rule.interval(g, false)];
        for h in (0..topology.edge_count()).map(|e| topology.side(e)) {
            if let Some(t) = topology.twin(h) {
                spread.extend([around(h, topology.next(t)), around(t, topology.next(h))]);
            }
        }
        for v in (0..topology.vertex_count()).filter(|v| self.filled() && topology.is_boundary(*v)) {
            let mut corners = topology.leaving(v);
            let first = corners.next().expect("every vertex is in a face");
            spread.extend(corners.skip(1).last().map(|last| around(last, first)));
        }
        spread
    }

    /// The same surface, or nearly, as a Catmull-Clark surface over knot intervals 0 and 1: [Miura, (23), (24)].
    ///
    /// Each face shrinks as in a step of subdivision, but to
    ///
    /// ```text
    /// P̄_i = 4/9 P_i + Σ_j (5 + 4 cos(2π (i - j) / n)) / 9n · P_j
    /// ```
    /// or, where intervals are not equal, to `(2 P_i + V) / 3 + (c_{i+2} + c_{i-2}) / (9 Σ c) · (...)`, with the same sum as in a step.
    /// Edges that run along edges of this mesh, which are the edges `h` for its half-edges `h`, get the interval 0, those around its
    /// vertices that of the vertex in their direction: 1 if there are none, the mean if the two ends differ. Where all faces have
    /// four sides and all inner vertices four faces, this is elevation of degree from 2 to 3 in both directions, and the surface is the same,
    /// exactly. At a boundary that is open corners go all the way to the joints on the edges across it, where the surface ends: the converted mesh
    /// has the boundary [`Boundary::Corners`]. At other faces,
    /// and at vertices with another number of faces, the surfaces differ: at the limit of a vertex `P` in `n` faces with four sides, with `e`
    /// the mean of its neighbours and `f` that of the corners across the faces, by
    ///
    /// ```text
    /// (4 - n) (19 P - 14 e - 5 f) / 144 (n + 5)
    /// ```
    /// which is [Miura, (27)] for `n = 3`. In the middle of a face they agree.
    ///
    /// # Errors
    /// [`MeshError::IrrationalWeights`](crate::MeshError::IrrationalWeights) as in [`refined`](Self::refined);
    /// [`Error::TooLarge`], [`Error::NotFinite`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Boundary, ControlMesh, DooSabin};
    /// let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(|x| x as f64).into();
    /// let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]];
    /// let cube = DooSabin::new(ControlMesh::new((0..8).map(corner).collect(), faces)?, Boundary::Smooth);
    /// let converted = cube.converted()?;
    /// assert_eq!(converted.mesh().topology().edge_count(), 4 * 12);
    /// assert_eq!(converted.intervals().map(|d| d.iter().sum()), Some(24.0));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn converted(&self) -> Result<CatmullClark<T, N>> {
        let coarse = self.mesh.topology();
        let fine = coarse.shrunk(self.filled())?;
        let points = self.moved(FaceRule::Elevation)?;
        let along = coarse.half_edge_count();
        let half = T::frac(1, 2);
        let interval = |(e, [d, other]): (usize, [T; 2])| match e < along {
            true => T::zero(),
            false => d * &half + other * &half,
        };
        let intervals = self.spread().into_iter().enumerate().map(interval).collect();
        let boundary = if self.filled() { self.boundary } else { Boundary::Corners };
        CatmullClark::with_intervals(ControlMesh::over(fine.into(), points)?, intervals, boundary)
    }
}
