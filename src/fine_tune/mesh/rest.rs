//! The edges of a converted mesh as the control values ask for them.
//!
//! A value `a` an edge scales the steps along it. An edge of the converted mesh runs along an edge of the old one, a leg `J`, or around an
//! old vertex, a leg `V` between two of the others in its loop:
//!
//! ```text
//! J → a J,      V → V + ((a_prev - 1) s_next J_next + (a_next - 1) s_prev J_prev) / 2
//! ```
//! with all three in the direction of the loop, and `s` the share of the old vertex in the two knot intervals of the edge along which `J`
//! runs: 1/2 where intervals are equal, 1 beside a clamped boundary. That is the product with a linear scale on a segment with the speeds
//! `C'` at its ends, and of length `h`: `V = h (C'_prev + C'_next) / 6`, and `s J = h C' / 3`. Where the mesh is regular and intervals are
//! equal, `J = (2/3) d` and `V = (d_prev + d_next) / 6` with legs `d` of the old mesh, and this is the rule of closed curves, `(2/3) a d` and
//! `(a_prev d_next + a_next d_prev) / 6`. At the boundary an edge that fills a corner lies between the two boundary edges there.

use crate::error::tune::TuneError;
use crate::error::{Error, Result};
use crate::fine_tune::frame::NOTHING;
use crate::mesh::doo_sabin::DooSabin;
use crate::mesh::topology::Topology;
use nalgebra::SVector;

/// Refuses scales that are not one positive number an edge.
pub(super) fn check_scale(alpha: &[f64], edges: usize) -> Result<()> {
    if alpha.len() != edges {
        return Err(Error::CoefficientCount { expected: edges, found: alpha.len() });
    }
    match alpha.iter().position(|a| !(*a > 0.0 && a.is_finite())) {
        Some(edge) => Err(TuneError::EdgeScale { edge, value: alpha[edge].to_string() }.into()),
        None => Ok(()),
    }
}

/// The edges of the mesh, each from its first end to its second.
pub(super) fn legs(fine: &Topology, points: &[SVector<f64, 3>]) -> Vec<SVector<f64, 3>> {
    fine.edges().map(|[from, to]| points[to] - points[from]).collect()
}

/// The edges of `fine`, into which `surface` is converted with these points, as the values `alpha` on the edges of its mesh ask for them.
pub(super) fn scaled_legs(
    surface: &DooSabin<f64, 3>,
    fine: &Topology,
    points: &[SVector<f64, 3>],
    alpha: &[f64],
) -> Vec<SVector<f64, 3>> {
    // Vertex `h` of the fine mesh is the corner of half-edge `h` of the coarse one, edge `h` runs from it to corner `next(h)`.
    let coarse = surface.mesh().topology();
    let along = |h: usize| points[coarse.next(h)] - points[h];
    let value = |h: usize| alpha[coarse.edge_of(h)];
    let scaled = |(e, [from, to]): (usize, [usize; 2])| {
        if e < coarse.half_edge_count() {
            return along(e) * value(e);
        }
        let before = coarse.prev(from);
        let [[_, behind], [ahead, _]] = [before, to].map(|h| surface.shares(h));
        let moved =
            along(to) * (ahead * (value(before) - 1.0)) + along(before) * (behind * (value(to) - 1.0));
        points[to] - points[from] + moved * 0.5
    };
    fine.edges().enumerate().map(scaled).collect()
}

/// Refuses edges that are zero but for rounding: they have no direction.
pub(super) fn check_legs(legs: &[SVector<f64, 3>]) -> Result<()> {
    if let Some(index) = legs.iter().position(|leg| !leg.norm().is_finite()) {
        return Err(Error::NotFinite { what: "edge", index });
    }
    let largest = legs.iter().map(SVector::norm).fold(0.0, f64::max);
    match legs.iter().position(|leg| leg.norm() <= NOTHING * largest) {
        Some(edge) => Err(TuneError::ZeroEdge { edge }.into()),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fine_tune::legs;
    use crate::mesh::boundary::Boundary;
    use crate::mesh::control_mesh::ControlMesh;
    use crate::space::SplineSpace;
    use crate::spline::{Curve, Function};
    use nalgebra::vector;

    const M: usize = 5;
    const N: usize = 7;

    /// A torus without pattern: vertex `i + M j`, faces counter-clockwise from it.
    fn torus() -> ControlMesh<f64, 3> {
        let noise = |k: usize| (k * k * 7 + 3 * k) as f64 % 13.0 / 40.0;
        let point = |k: usize| {
            let (u, v) = ((k % M) as f64 * 1.2566, (k / M) as f64 * 0.8976);
            let radius = 3.0 + v.cos() + noise(k);
            vector![radius * u.cos(), radius * u.sin() + noise(k + 3), v.sin() + noise(k + 11)]
        };
        let face = |k: usize| {
            let at = |i: usize, j: usize| i % M + M * (j % N);
            let (i, j) = (k % M, k / M);
            [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]
        };
        ControlMesh::new((0..M * N).map(point).collect(), (0..M * N).map(face)).unwrap()
    }

    /// The legs of the product of the speed of a closed quadratic curve with a linear scale: vertex `i` has the segment of length `d[i]`,
    /// leg `i` the value `values[i]`.
    fn product(vertices: Vec<SVector<f64, 3>>, d: &[f64], values: &[f64]) -> Vec<SVector<f64, 3>> {
        let ends = d[1..].iter().scan(0.0, |end, d| {
            *end += d;
            Some(*end)
        });
        let knots: Vec<f64> = std::iter::once(0.0).chain(ends).collect();
        let space = |degree| SplineSpace::periodic(degree, knots.iter().copied(), d.iter().sum()).unwrap();
        let curve = Curve::new(space(2), vertices).unwrap();
        legs::legs(&legs::scaled_speed(&curve, &Function::new(space(1), values.to_vec()).unwrap()).unwrap())
    }

    /// The points on a leg that elevation of degree puts there, with segments of these lengths at its ends.
    fn elevated(ends: [SVector<f64, 3>; 2], [d, e]: [f64; 2]) -> [SVector<f64, 3>; 2] {
        let whole = 3.0 * (d + e);
        let on = |near: f64, far: f64| (ends[0] * near + ends[1] * far) / whole;
        [on(2.0 * d + 3.0 * e, d), on(e, 3.0 * d + 2.0 * e)]
    }

    #[test]
    fn on_regular_meshes_this_is_the_rule_of_closed_curves() {
        // Lengths of the segments in columns and rows, and one value for all edges from a column or row to the next.
        let uneven = ([1.0, 3.0, 0.5, 2.0, 1.5], [2.0, 1.0, 0.25, 1.0, 3.0, 1.5, 0.75]);
        let (columns, rows) = ([1.3, 0.8, 1.0, 1.7, 0.6], [0.9, 1.0, 1.4, 0.7, 1.1, 2.0, 0.5]);
        for (x, y) in [([1.0; M], [1.0; N]), uneven] {
            let mesh = torus();
            let coarse = mesh.topology();
            let across = |h: usize| h.is_multiple_of(2);
            let interval =
                |e: usize| coarse.ends(e).map(|v| if across(coarse.side(e)) { x[v % M] } else { y[v / M] });
            let intervals = (0..coarse.edge_count()).map(interval).collect();
            let old = if x[1] == 1.0 {
                DooSabin::new(mesh.clone(), Boundary::Smooth)
            } else {
                DooSabin::with_intervals(mesh.clone(), intervals, Boundary::Smooth).unwrap()
            };
            let surface = old.converted().unwrap();
            let (fine, points) = (surface.mesh().topology(), surface.mesh().points());
            let mut alpha = vec![0.0; coarse.edge_count()];
            for h in 0..coarse.half_edge_count() {
                let f = coarse.face_of(h);
                alpha[coarse.edge_of(h)] = if across(h) { columns[f % M] } else { rows[f / M] };
            }
            let scaled = scaled_legs(&old, fine, points, &alpha);
            let find = |from: usize, to: usize| {
                let e = fine.edge_between(from, to).unwrap();
                if fine.ends(e) == [from, to] { scaled[e] } else { -scaled[e] }
            };
            let corner = |i: usize, j: usize, side: usize| 4 * (i % M + M * (j % N)) + side;
            let p = |i: usize, j: usize| mesh.points()[i % M + M * (j % N)];
            // Where the curve starts in its ring is its own affair.
            let compare = |found: Vec<SVector<f64, 3>>, expected: Vec<SVector<f64, 3>>| {
                let n = found.len();
                let close = |s: &usize| (0..n).all(|k| (found[k] - expected[(k + s) % n]).norm() < 1e-13);
                assert!(expected.len() == n && (0..n).any(|s| close(&s)), "{found:?} {expected:?}");
            };
            for (j, far) in (0..N).flat_map(|j| [(j, 0), (j, 1)]) {
                let on = |i: usize| elevated([p(i, j), p(i, j + 1)], [y[j], y[(j + 1) % N]])[far];
                let [a, b] = [[0, 1], [3, 2]][far];
                let ring = |i: usize| {
                    [find(corner(i, j, a), corner(i, j, b)), find(corner(i, j, b), corner(i + 1, j, a))]
                };
                compare((0..M).flat_map(ring).collect(), product((0..M).map(on).collect(), &x, &columns));
            }
            for (i, far) in (0..M).flat_map(|i| [(i, 0), (i, 1)]) {
                let on = |j: usize| elevated([p(i, j), p(i + 1, j)], [x[i], x[(i + 1) % M]])[far];
                let [a, b] = [[0, 3], [1, 2]][far];
                let ring = |j: usize| {
                    [find(corner(i, j, a), corner(i, j, b)), find(corner(i, j, b), corner(i, j + 1, a))]
                };
                compare((0..N).flat_map(ring).collect(), product((0..N).map(on).collect(), &y, &rows));
            }
        }
    }

    #[test]
    fn ones_ask_for_what_is_there() {
        let mesh = torus();
        let old = DooSabin::new(mesh.clone(), Boundary::Smooth);
        let surface = old.converted().unwrap();
        let (fine, points) = (surface.mesh().topology(), surface.mesh().points());
        let ones = vec![1.0; mesh.topology().edge_count()];
        assert_eq!(scaled_legs(&old, fine, points, &ones), legs(fine, points));
    }

    #[test]
    fn the_boundary_of_a_filled_corner_lies_between_boundary_edges() {
        // An L of three squares, with vertex 4 at its inner corner: from 5 over 4 to 7.
        let points = [[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1], [0, 2], [1, 2]];
        let points = points.iter().map(|[x, y]| vector![f64::from(*x), f64::from(*y), 0.0]).collect();
        let mesh = ControlMesh::new(points, [[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6]]).unwrap();
        let coarse = mesh.topology();
        let old = DooSabin::new(mesh.clone(), Boundary::Smooth);
        let surface = old.converted().unwrap();
        let (fine, points) = (surface.mesh().topology(), surface.mesh().points());
        let mut alpha = vec![1.0; coarse.edge_count()];
        alpha[coarse.edge_between(5, 4).unwrap()] = 3.0;
        alpha[coarse.edge_between(4, 7).unwrap()] = 2.0;
        let fill = fine.edge_count() - 1;
        // Corners 6 and 7 are those of vertices 5 and 4 in the second square, 9 and 10 of 4 and 7 in the third.
        assert_eq!(fine.ends(fill), [7, 9]);
        let (before, after) = (points[7] - points[6], points[10] - points[9]);
        // The curve along the boundary is clamped in 5 and 7: `h C' / 3` is the whole leg.
        let expected = points[9] - points[7] + (after * 2.0 + before) / 2.0;
        let found = scaled_legs(&old, fine, points, &alpha)[fill];
        assert!((found - expected).norm() < 1e-15, "{found} {expected}");
    }
}
