//! The points of a Catmull-Clark surface at the vertices of its control mesh.
//!
//! A vertex `V` of valence `n` in four-sided faces, with the neighbours `e_i` along edges and `f_i` across faces, tends
//! to
//!
//! ```text
//! (n² V + 4 Σ e_i + Σ f_i) / (n (n + 5))
//! ```
//! if all knot intervals around are equal. Where the surface is a bicubic B-spline surface over other intervals, the
//! point is a mean by rows and columns with the weights of a cubic at its knot: with the intervals `a', a` before and `b,
//! b'` after it
//!
//! ```text
//! b² / ((a + b)(a' + a + b)),   the rest to 1,   a² / ((a + b)(a + b + b'))
//! ```
//! of the neighbour before, the vertex, the neighbour after, and the vertex alone if `a = b = 0`. On the boundary these
//! are the weights along it, `(1, 4, 1) / 6` if all intervals are equal.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::error::mesh::MeshError;
use crate::mesh::boundary::Boundary;
use crate::mesh::catmull_clark::CatmullClark;
use crate::mesh::control_mesh::ControlMesh;
use crate::mesh::near::{Line, Near, settle};
use crate::scalar::Scalar;
use crate::vector::extent;
use nalgebra::SVector;

/// How many steps floats may take to tend to their limit.
const STEPS: usize = 64;

impl<T: Scalar, const N: usize> CatmullClark<T, N> {
    /// The points of the surface at the vertices; none at the boundary of a mesh whose boundary is open, where the
    /// surface does not reach.
    ///
    /// A vertex in faces with other than four sides, or among irregular knot intervals, is refined with its surroundings
    /// until the weights are known. That fails where intervals around a vertex of a valence other than 4 differ, and
    /// where those of opposite edges of a face do: exact numbers give an error then; floats are refined until the faces
    /// around the vertex are smaller than `2^-40` of the mesh, and an error comes only if they do not shrink.
    ///
    /// # Errors
    /// [`MeshError::Unsettled`]; those of [`CatmullClark::refined`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Boundary, CatmullClark, ControlMesh, Q, Scalar};
    /// let points = (0..8_i64).map(|i| [i & 1, (i >> 1) & 1, i >> 2].map(|x| Q::int(2 * x - 1)).into()).collect();
    /// let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    /// let cube = CatmullClark::new(ControlMesh::new(points, faces)?, Boundary::Smooth);
    /// // (9 V + 4 Σ e + Σ f) / 24, where the neighbours add up to V, and the vertices across faces to -V.
    /// assert_eq!(cube.limit_points()?[7].as_ref().map(|p| p[0].clone()), Some(Q::frac(12, 24)));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn limit_points(&self) -> Result<Vec<Option<SVector<T, N>>>> {
        let open = self.boundary() == Boundary::Open;
        let small = extent(self.mesh().points()) * T::frac(1, 1 << 40);
        settle(self, STEPS, |near, v, last| {
            if near.topology().is_boundary(v) {
                return Some((!open).then(|| at_rim(near, v, self.boundary() == Boundary::Corners)));
            }
            let whole = near.ring(v);
            let point = whole.as_ref().and_then(|ring| inside(near, v, ring));
            // Floats that tend to their limit.
            let close = || {
                let ring = whole.as_ref().filter(|_| last && !T::EXACT)?;
                let far = |w: usize| near.point(w) - near.point(v);
                let away = ring.iter().flat_map(|h| [far(near.topology().target(*h)), far(near.across(*h))]);
                let away: Vec<_> = away.collect();
                (extent(&away) <= small).then(|| near.point(v).clone())
            };
            point.or_else(close).map(Some)
        })
    }

    /// The control mesh with its vertices moved to the surface, as a picture of it; of a mesh whose boundary is open the
    /// faces that have a point at each corner.
    ///
    /// # Errors
    /// Those of [`CatmullClark::limit_points`]; [`MeshError::NothingInside`] if no face
    /// is left.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Boundary, CatmullClark, ControlMesh, Q, Scalar};
    /// let points = (0..16).map(|i| [Q::int(i / 4), Q::int(i % 4)].into()).collect();
    /// let faces = (0..9).map(|f| 4 * (f / 3) + f % 3).map(|v| [v, v + 4, v + 5, v + 1]);
    /// let grid = ControlMesh::new(points, faces)?;
    /// let square = CatmullClark::new(grid, Boundary::Open).limit_mesh()?;
    /// assert_eq!(square.points()[0].as_slice(), [Q::int(1), Q::int(1)]);
    /// assert_eq!(square.topology().face_count(), 1);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn limit_mesh(&self) -> Result<ControlMesh<T, N>> {
        let limits = self.limit_points()?;
        let topology = self.mesh().topology();
        if limits.iter().all(Option::is_some) {
            return self.mesh().with_points(limits.into_iter().flatten().collect());
        }
        let on = |f: usize| topology.face(f).all(|v| limits[v].is_some());
        let part = topology.part(on).ok_or(MeshError::NothingInside { what: "face" })?;
        let points = part.vertices.iter().filter_map(|v| limits[*v as usize].clone()).collect();
        ControlMesh::over(part.topology.into(), points)
    }
}

/// The limit of a vertex inside, in faces with four sides, if it is settled.
fn inside<T: Scalar, const N: usize>(
    near: &Near<'_, T, N>,
    v: usize,
    ring: &[usize],
) -> Option<SVector<T, N>> {
    if let Some([u, w]) = near.lines(ring) {
        return Some(product(near, v, ring, &weights(&u), &weights(&w)));
    }
    if near.is_still(ring) {
        return Some(near.point(v).clone());
    }
    if !near.is_uniform(ring) {
        return None;
    }
    let n = ring.len() as i64;
    let mut sum = near.point(v) * T::int(n * n);
    for &h in ring {
        sum.add_scaled(&T::int(4), near.point(near.topology().target(h)));
        sum += near.point(near.across(h));
    }
    Coeff::divide(&mut sum, &T::int(n * (n + 5)));
    Some(sum)
}

/// The limit of a vertex at the boundary.
fn at_rim<T: Scalar, const N: usize>(near: &Near<'_, T, N>, v: usize, corners: bool) -> SVector<T, N> {
    let topology = near.topology();
    let [out, back] = topology.rim(v);
    if corners && topology.prev(out) == back {
        return near.point(v).clone();
    }
    let ends = [topology.origin(back), v, topology.target(out)];
    let terms = ends.into_iter().zip(weights(&near.rim_line(v, corners)));
    terms.fold(SVector::zeros(), |sum, (v, w)| sum + near.point(v) * w)
}

/// The weights of a cubic at a knot.
pub(super) fn weights<T: Scalar>([before, a, b, after]: &Line<T>) -> [T; 3] {
    let whole = a.clone() + b;
    if whole.is_zero() {
        return [T::zero(), T::one(), T::zero()];
    }
    let first = b.clone() / &whole * b / (whole.clone() + before);
    let last = a.clone() / &whole * a / (whole + after);
    let own = T::one() - &first - &last;
    [first, own, last]
}

/// The sum over the three rows and columns around a vertex of valence 4: of weights along `ring[2]`, `ring[0]` times
/// those along `ring[3]`, `ring[1]`.
pub(super) fn product<T: Scalar, const N: usize>(
    near: &Near<'_, T, N>,
    v: usize,
    ring: &[usize],
    u: &[T; 3],
    w: &[T; 3],
) -> SVector<T, N> {
    let edge = |i: usize| near.topology().target(ring[i]);
    let face = |i: usize| near.across(ring[i]);
    let rows = [[face(2), edge(3), face(3)], [edge(2), v, edge(0)], [face(1), edge(1), face(0)]];
    let mut sum = SVector::zeros();
    for (row, w) in rows.iter().zip(w) {
        row.iter().zip(u).for_each(|(v, u)| Coeff::add_scaled(&mut sum, &(u.clone() * w), near.point(*v)));
    }
    sum
}
