//! The energy (14) of a closed mesh by its definition, loop by loop.

use nalgebra::SVector;
use symspline::{DooSabin, EdgeLoops, Topology};

type Vector = SVector<f64, 3>;

/// A closed mesh, and what its edges and angles should be.
pub struct Oracle {
    mesh: Topology,
    loops: EdgeLoops,
    /// The unit of lengths.
    pub side: f64,
    constants: [f64; 3],
    /// The edges as they should be, loop by loop.
    wanted: Vec<Vec<Vector>>,
    /// The angles around vertices as they are.
    around: Vec<f64>,
}

fn angle(u: &Vector, v: &Vector) -> f64 {
    u.cross(v).norm().atan2(u.dot(v))
}

impl Oracle {
    pub fn of(surface: &DooSabin<f64, 3>, alpha: &[f64], constants: [f64; 3]) -> Self {
        let old = surface.mesh();
        let coarse = old.topology();
        let converted = surface.converted().expect("a surface");
        let mesh = converted.mesh().topology().clone();
        let loops = EdgeLoops::new(&mesh).expect("four edges at each vertex");
        let (low, high) = old
            .points()
            .iter()
            .fold((old.points()[0], old.points()[0]), |(low, high), p| (low.inf(p), high.sup(p)));
        let intervals = converted.intervals().expect("zeros and ones");
        let mut oracle =
            Self { mesh, loops, side: (high - low).max(), constants, wanted: vec![], around: vec![] };
        for i in 0..oracle.loops.count() {
            assert!(oracle.loops.is_closed(i));
            let (legs, edges) = (oracle.legs(i, converted.mesh().points()), oracle.loops.edges(i));
            let n = legs.len();
            let value = |k: usize| alpha[coarse.edge_of(edges[k % n])];
            let scaled = |k: usize| match intervals[edges[k]] {
                0.0 => legs[k] * value(k),
                _ => {
                    let (before, after) = ((k + n - 1) % n, (k + 1) % n);
                    legs[k]
                        + (legs[after] * (value(before) - 1.0) + legs[before] * (value(after) - 1.0)) / 4.0
                }
            };
            let scaled = (0..n).map(scaled).collect();
            oracle.wanted.push(scaled);
        }
        oracle.around = oracle.angles_around(converted.mesh().points());
        oracle
    }

    fn legs(&self, i: usize, points: &[Vector]) -> Vec<Vector> {
        let vertices = self.loops.vertices(i);
        let next = vertices.iter().cycle().skip(1);
        vertices.iter().zip(next).map(|(v, w)| (points[*w] - points[*v]) / self.side).collect()
    }

    fn angles_around(&self, points: &[Vector]) -> Vec<f64> {
        let mut angles = Vec::new();
        for v in 0..self.mesh.vertex_count() {
            let out: Vec<Vector> =
                self.mesh.leaving(v).map(|h| points[self.mesh.target(h)] - points[v]).collect();
            angles.extend((0..4).map(|k| angle(&out[k], &out[(k + 1) % 4])));
        }
        angles
    }

    pub fn energy(&self, points: &[Vector]) -> f64 {
        let mut sums = [0.0; 3];
        for (i, wanted) in self.wanted.iter().enumerate() {
            let legs = self.legs(i, points);
            for k in 0..legs.len() {
                let next = (k + 1) % legs.len();
                sums[0] += (wanted[k].norm() - legs[k].norm()).powi(2);
                sums[1] += (angle(&wanted[k], &wanted[next]) - angle(&legs[k], &legs[next])).powi(2);
            }
        }
        let around = self.angles_around(points);
        sums[2] = around.iter().zip(&self.around).map(|(a, b)| (a - b).powi(2)).sum();
        sums.iter().zip(self.constants).map(|(sum, k)| k * sum).sum()
    }
}
