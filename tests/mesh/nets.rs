//! Grids as control meshes, and as control nets of tensor-product surfaces.

use nalgebra::SVector;
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{ControlMesh, Q, Result, Scalar, Topology};

/// A grid of vertices `(i, j)`, numbered `i n + j`, with a four-sided face between any four.
#[derive(Clone, Debug)]
pub struct Net {
    pub points: Vec<SVector<Q, 2>>,
    pub size: [usize; 2],
}

impl Net {
    /// The faces, counter-clockwise.
    pub fn faces(&self) -> Vec<[usize; 4]> {
        let [m, n] = self.size;
        let at = |i: usize, j: usize| i * n + j;
        let corner = |k: usize| {
            let (i, j) = (k / (n - 1), k % (n - 1));
            [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]
        };
        (0..(m - 1) * (n - 1)).map(corner).collect()
    }

    pub fn mesh(&self) -> Result<ControlMesh<Q, 2>> {
        ControlMesh::new(self.points.clone(), self.faces())
    }

    /// The knot intervals of a Doo-Sabin surface: `du` and `dv` are those of the columns and rows of vertices.
    pub fn at_vertices(&self, topology: &Topology, du: &[Q], dv: &[Q]) -> Vec<[Q; 2]> {
        let n = self.size[1];
        let interval = |ends: [usize; 2]| match ends[0] / n == ends[1] / n {
            true => ends.map(|v| dv[v % n].clone()),
            false => ends.map(|v| du[v / n].clone()),
        };
        topology.edges().map(interval).collect()
    }
}

/// Nets of `low` to `high` points in each direction.
pub fn net(low: usize, high: usize) -> impl Strategy<Value = Net> {
    [low..=high, low..=high].prop_flat_map(|size| {
        let point = [-9_i64..10, -9_i64..10].prop_map(|p| SVector::from(p.map(Q::int)));
        vec(point, size[0] * size[1]).prop_map(move |points| Net { points, size })
    })
}

/// Knot intervals: some vanish, but no two in a row, nor those next to the ends, which would end the domain.
pub fn intervals(count: usize) -> impl Strategy<Value = Vec<Q>> {
    let interval = prop_oneof![1 => Just(0), 4 => 1_i64..6];
    vec(interval, count).prop_map(|mut intervals| {
        for k in 1..intervals.len() {
            let inner = k == 1 || k + 2 == intervals.len();
            if intervals[k] == 0 && (inner || intervals[k - 1] == 0) {
                intervals[k] = 1;
            }
        }
        intervals.into_iter().map(Q::int).collect()
    })
}

/// Running sums, from 0.
pub fn sums(intervals: &[Q]) -> Vec<Q> {
    let next = |sum: &mut Q, d: &Q| {
        *sum += d;
        Some(sum.clone())
    };
    std::iter::once(Q::int(0)).chain(intervals.iter().scan(Q::int(0), next)).collect()
}

/// The points in the order of their coordinates: vertices of a subdivided grid have another order than coefficients.
pub fn sorted<const N: usize>(points: &[SVector<Q, N>]) -> Vec<Vec<Q>> {
    let mut rows: Vec<Vec<Q>> = points.iter().map(|p| p.iter().cloned().collect()).collect();
    rows.sort_by(|a, b| a.partial_cmp(b).expect("rationals"));
    rows
}
