//! The points of a step of Catmull and Clark's subdivision over equal knot intervals.
//!
//! ```text
//! F = mean of the corners of a face                                          a point a face
//! E = (P_v + P_w + F_left + F_right) / 4                                     a point an edge vw
//! V = (F̄ + 2 R̄ + (n - 3) P) / n                                              a point a vertex of valence n
//! ```
//! with `F̄` the mean of the `n` face points around the vertex, `R̄` that of the middles of the `n` edges. At the
//! boundary the cubic B-spline curve refines: `E = (P_v + P_w) / 2`, and `V = (P_left + 6 P + P_right) / 8` from the
//! neighbours along the boundary.

use crate::coeff::Coeff;
use crate::mesh::control_mesh::ControlMesh;
use crate::mesh::topology::Topology;
use crate::scalar::Scalar;
use nalgebra::SVector;

/// The points after a step, in the order of [`Topology::quartered`]. Vertices in one face alone stay if `corners`.
///
/// Sums run over faces: nothing is allocated an element, and no fan is walked but at the boundary.
pub(super) fn points<T: Scalar, const N: usize>(
    mesh: &ControlMesh<T, N>,
    corners: bool,
) -> Vec<SVector<T, N>> {
    let (topology, old) = (mesh.topology(), mesh.points());
    let centres: Vec<_> = (0..topology.face_count()).map(|f| mesh.centroid(f)).collect();
    // Of each vertex: how many faces there are around it, and the sum of their points and of the neighbours before them.
    let mut around = vec![(0_i64, SVector::<T, N>::zeros()); old.len()];
    for (f, centre) in centres.iter().enumerate() {
        let sides = topology.sides(f);
        let mut from = topology.origin(sides.end - 1);
        for h in sides {
            let to = topology.origin(h);
            let (count, sum) = &mut around[to];
            *count += 1;
            *sum += centre;
            *sum += &old[from];
            from = to;
        }
    }
    let mut fine = Vec::with_capacity(old.len() + topology.edge_count() + centres.len());
    let (half, quarter, eighth) = (T::frac(1, 2), T::frac(1, 4), T::frac(1, 8));
    for (v, (n, mut sum)) in around.into_iter().enumerate() {
        if topology.is_boundary(v) {
            let [out, back] = topology.rim(v);
            let mut point = old[v].clone();
            if !(corners && n == 1) {
                point.scale(&T::int(6));
                point += &old[topology.target(out)];
                point += &old[topology.origin(back)];
                point.scale(&eighth);
            }
            fine.push(point);
        } else {
            // The neighbours come with half their weight in R̄, the vertex itself with the other half.
            sum.add_scaled(&T::int(n * (n - 2)), &old[v]);
            Coeff::divide(&mut sum, &T::int(n * n));
            fine.push(sum);
        }
    }
    for e in 0..topology.edge_count() {
        let h = topology.side(e);
        let mut point = &old[topology.origin(h)] + &old[topology.target(h)];
        match topology.twin(h) {
            Some(twin) => {
                point += &centres[topology.face_of(h)];
                point += &centres[topology.face_of(twin)];
                point.scale(&quarter);
            }
            None => point.scale(&half),
        }
        fine.push(point);
    }
    fine.extend(centres);
    fine
}

impl Topology {
    /// The half-edges of the boundary that leave vertex `v` and that come to it.
    pub(super) fn rim(&self, v: usize) -> [usize; 2] {
        let out = self.leaving[v] as usize;
        let last = self.leaving(v).last().unwrap_or(out);
        [out, self.prev(last)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;
    use nalgebra::vector;

    /// Worked out by hand.
    #[test]
    fn corner_of_a_cube() {
        let points = (0..8_i64).map(|i| vector![i & 1, (i >> 1) & 1, i >> 2].map(|x| Q::int(2 * x - 1)));
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let cube = ControlMesh::new(points.collect(), faces).unwrap();
        let fine = super::points(&cube, false);
        // F̄ = (1, 1, 1) / 3, R̄ = (2, 2, 2) / 3.
        assert_eq!(fine[7], vector![Q::frac(5, 9), Q::frac(5, 9), Q::frac(5, 9)]);
        let e = cube.topology().edge_between(5, 7).unwrap();
        assert_eq!(fine[8 + e], vector![Q::frac(3, 4), Q::int(0), Q::frac(3, 4)]);
        assert_eq!(fine[8 + 12 + 1], vector![Q::int(0), Q::int(0), Q::int(1)]);
    }

    #[test]
    fn corners_of_a_square() {
        let points = [[0, 0], [8, 0], [8, 8], [0, 8]].map(|p| SVector::from(p.map(Q::int)));
        let square = ControlMesh::new(points.to_vec(), [[0, 1, 2, 3]]).unwrap();
        assert_eq!(super::points(&square, false)[0], vector![Q::int(1), Q::int(1)]);
        assert_eq!(super::points(&square, true)[0], vector![Q::int(0), Q::int(0)]);
        assert_eq!(super::points(&square, true)[4], vector![Q::int(4), Q::int(0)]);
    }
}
