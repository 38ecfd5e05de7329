//! The points of a step of Catmull and Clark's subdivision with knot intervals [Sederberg, 1998].
//!
//! Each edge has a knot interval `d ≥ 0`. With `d^k` of an edge `PQ` about `P` the interval of the `k`-th edge
//! counter-clockwise from it at `P`, clockwise for `k < 0`, let its *reach* about `P` be `d^0 + d^2 + d^-2`: in a regular
//! mesh, the interval and twice the one straight on. A step takes
//!
//! ```text
//! F = Σ w_i P_i / Σ w_i,   w_i = reach of P_{i+1} P_i about P_{i+1}  ·  reach of P_{i-1} P_i about P_{i-1}
//! M = (r_Q P + r_P Q) / (r_P + r_Q),   r_P, r_Q the reaches of PQ about P and Q
//! E = (1 - a - b) M + a F_left + b F_right
//! V = (n - 3)/n P + 3/n Σ (m_i M_i + f_i F_i) / Σ (m_i + f_i)
//! ```
//! `a` is the sum of the intervals on the right of the edge, at both ends, over twice the sum of all four on its sides,
//! `b` the mirror image, both 0 if all four vanish. With `d_i` the intervals counter-clockwise around the vertex, `m_i =
//! (d_{i+1} + d_{i-1}) (d_{i+2} + d_{i-2}) / 2`, and `f_i = d_{i-1} d_{i+2}` for the face between edges `i` and `i + 1`.
//!
//! The halves of an edge get half its interval each. The new edge from the middle of `PQ` into a face gets the mean of
//! the halves of its neighbours, the edges before and after `PQ` in the face, which in a four-sided face of a regular
//! mesh are equal.
//!
//! **At the boundary** the curve refines, with `d` the intervals along it, whatever the inside:
//!
//! ```text
//! E_i = ((d_i + 2 d_{i+1}) P_i + (d_i + 2 d_{i-1}) P_{i+1}) / (2 (d_{i-1} + d_i + d_{i+1}))
//! V_i = (d_i E_{i-1} + (d_{i-1} + d_i) P_i + d_{i-1} E_i) / (2 (d_{i-1} + d_i))
//! ```
//! Edges inside that miss `d^2` or `d^-2` at a boundary vertex take `d^0` for it, as if the mesh went on mirrored. An
//! edge of the boundary takes the other edge of the boundary for both; at a vertex in one face alone it takes `d^0`, but
//! for the boundary curve of [`Boundary::Smooth`](crate::Boundary::Smooth), which runs around that corner.
//!
//! **Sums that vanish** belong to knots that are multiple. They are replaced by their limits as the intervals that vanish
//! tend to zero together, where that limit is one: `M` is the middle; `F` takes the reaches of each edge over their sum,
//! halves if that is 0, and the mean if no weight is left; `V` takes `m_i = d_{i+1} + d_{i-1} + d_{i+2} + d_{i-2}`, `f_i
//! = d_{i-1} + d_{i+2}`, and stays if these vanish too. So knot insertion comes out where the mesh is regular, however
//! often a knot is repeated by halving an empty interval.

use crate::coeff::Coeff;
use crate::mesh::control_mesh::ControlMesh;
use crate::mesh::topology::Topology;
use crate::scalar::{Scalar, larger};
use nalgebra::SVector;
use std::borrow::Cow;

/// The intervals after a step, in the order of [`Topology::quartered`].
pub(super) fn intervals<T: Scalar>(topology: &Topology, d: &[T]) -> Vec<T> {
    let (half, quarter) = (T::frac(1, 2), T::frac(1, 4));
    let halves = d.iter().flat_map(|x| std::iter::repeat_n(x.clone() * &half, 2));
    let of = |h: usize| &d[topology.edge_of(h)];
    let into = |h: usize| of(topology.next(h)).clone() * &quarter + of(topology.prev(h)).clone() * &quarter;
    halves.chain((0..topology.half_edge_count()).map(into)).collect()
}

/// The points after a step, in the same order. Vertices in one face alone stay if `corners`.
pub(super) fn points<T: Scalar, const N: usize>(
    mesh: &ControlMesh<T, N>,
    d: &[T],
    corners: bool,
) -> Vec<SVector<T, N>> {
    let d = &*scaled(d);
    Rules { mesh, d, reaches: reaches(mesh.topology(), d) }.points(corners)
}

/// The intervals in a scale in which sums and products of floats do not overflow: the largest is 1. The rules do not change.
pub(super) fn scaled<T: Scalar>(d: &[T]) -> Cow<'_, [T]> {
    let largest = d.iter().cloned().fold(T::zero(), larger);
    match !T::EXACT && largest > T::zero() {
        true => d.iter().map(|x| x.clone() / &largest).collect(),
        false => Cow::Borrowed(d),
    }
}

/// The reaches of all edges, about the origin of the side and about the other end.
pub(super) fn reaches<T: Scalar>(topology: &Topology, d: &[T]) -> Vec<[T; 2]> {
    let mut reaches = vec![[T::zero(), T::zero()]; topology.edge_count()];
    let mut ring = Vec::new();
    for v in 0..topology.vertex_count() {
        ring.clear();
        ring.extend(topology.edges_at(v));
        let n = ring.len();
        for (i, &e) in ring.iter().enumerate() {
            let on = match topology.is_boundary(v) {
                false => [ring[(i + 2) % n], ring[(i + n - 2) % n]],
                // The one other edge of the boundary, but at a corner.
                true if i == 0 || i + 1 == n => [if n == 2 { e } else { ring[n - 1 - i] }; 2],
                true => [ring.get(i + 2), ring.get(i.wrapping_sub(2))].map(|on| *on.unwrap_or(&e)),
            };
            let far = usize::from(topology.ends(e)[0] != v);
            reaches[e][far] = d[e].clone() + &d[on[0]] + &d[on[1]];
        }
    }
    reaches
}

/// The reach of the edge of half-edge `h` about its origin, or about the other end if `far`.
pub(super) fn reach<'a, T>(topology: &Topology, reaches: &'a [[T; 2]], h: usize, far: bool) -> &'a T {
    let e = topology.edge_of(h);
    &reaches[e][usize::from((topology.side(e) == h) == far)]
}

struct Rules<'a, T: Scalar, const N: usize> {
    mesh: &'a ControlMesh<T, N>,
    d: &'a [T],
    reaches: Vec<[T; 2]>,
}

impl<T: Scalar, const N: usize> Rules<'_, T, N> {
    fn points(&self, corners: bool) -> Vec<SVector<T, N>> {
        let topology = self.mesh.topology();
        let mut weights = Vec::new();
        let faces: Vec<_> = (0..topology.face_count()).map(|f| self.face(f, &mut weights)).collect();
        let between = |e: usize| self.between(e, &self.reaches[e]);
        let middles: Vec<_> = (0..topology.edge_count()).map(between).collect();
        let edges: Vec<_> =
            (0..topology.edge_count()).map(|e| self.edge(e, &middles, &faces, corners)).collect();
        let mut fine = Vec::with_capacity(topology.vertex_count() + edges.len() + faces.len());
        let mut ring = Vec::new();
        for v in 0..topology.vertex_count() {
            let point = match topology.is_boundary(v) {
                true => self.end(v, &edges, corners),
                false => {
                    ring.clear();
                    ring.extend(topology.leaving(v));
                    self.vertex(v, &ring, &middles, &faces)
                }
            };
            fine.push(point);
        }
        fine.extend(edges);
        fine.extend(faces);
        fine
    }

    fn of(&self, h: usize) -> &T {
        &self.d[self.mesh.topology().edge_of(h)]
    }

    fn face(&self, f: usize, weights: &mut Vec<T>) -> SVector<T, N> {
        let topology = self.mesh.topology();
        let reach = |h: usize, far: bool| reach(topology, &self.reaches, h, far);
        weights.clear();
        weights.extend(topology.sides(f).map(|h| reach(h, true).clone() * reach(topology.prev(h), false)));
        if weights.iter().all(T::is_zero) {
            let share = |h: usize, far: bool| {
                let whole = reach(h, true).clone() + reach(h, false);
                if whole.is_zero() { T::frac(1, 2) } else { reach(h, far).clone() / whole }
            };
            weights.clear();
            weights.extend(topology.sides(f).map(|h| share(h, true) * share(topology.prev(h), false)));
        }
        let sum = weights.iter().fold(T::zero(), |sum, w| sum + w);
        if sum.is_zero() {
            return self.mesh.centroid(f);
        }
        let mut point = SVector::zeros();
        let corners = topology.face(f).zip(&*weights);
        corners.for_each(|(v, w)| Coeff::add_scaled(&mut point, w, &self.mesh.points()[v]));
        Coeff::divide(&mut point, &sum);
        point
    }

    /// The point on an edge by its reaches.
    fn between(&self, e: usize, [near, far]: &[T; 2]) -> SVector<T, N> {
        let [p, q] = self.mesh.topology().ends(e).map(|v| &self.mesh.points()[v]);
        let sum = near.clone() + far;
        if sum.is_zero() {
            return (p + q) * T::frac(1, 2);
        }
        let mut point = Coeff::scaled(p, far);
        Coeff::add_scaled(&mut point, near, q);
        Coeff::divide(&mut point, &sum);
        point
    }

    fn edge(
        &self,
        e: usize,
        middles: &[SVector<T, N>],
        faces: &[SVector<T, N>],
        corners: bool,
    ) -> SVector<T, N> {
        let topology = self.mesh.topology();
        let h = topology.side(e);
        let Some(twin) = topology.twin(h) else {
            return if corners { middles[e].clone() } else { self.between(e, &self.along(h)) };
        };
        let beside = |h: usize| self.of(topology.next(h)).clone() + self.of(topology.prev(h));
        let (left, right) = (beside(h), beside(twin));
        let twice = (left.clone() + &right) * T::int(2);
        let mut point = middles[e].clone();
        if twice.is_zero() {
            return point;
        }
        Coeff::scale(&mut point, &T::frac(1, 2));
        let sides = [(right, h), (left, twin)];
        sides.into_iter().for_each(|(w, h)| {
            Coeff::add_scaled(&mut point, &(w / &twice), &faces[topology.face_of(h)]);
        });
        point
    }

    /// The reaches of half-edge `h` along a boundary that runs on around corners.
    fn along(&self, h: usize) -> [T; 2] {
        let topology = self.mesh.topology();
        let before = topology.rim(topology.origin(h))[1];
        let after = topology.rim(topology.target(h))[0];
        [before, after].map(|g| T::int(2) * self.of(g) + self.of(h))
    }

    fn end(&self, v: usize, edges: &[SVector<T, N>], corners: bool) -> SVector<T, N> {
        let (topology, old) = (self.mesh.topology(), &self.mesh.points()[v]);
        let [out, back] = topology.rim(v);
        let twice = (self.of(out).clone() + self.of(back)) * T::int(2);
        if twice.is_zero() || (corners && topology.prev(out) == back) {
            return old.clone();
        }
        let mut point = Coeff::scaled(old, &T::frac(1, 2));
        for (h, other) in [(out, back), (back, out)] {
            let weight = self.of(other).clone() / &twice;
            Coeff::add_scaled(&mut point, &weight, &edges[topology.edge_of(h)]);
        }
        point
    }

    fn vertex(
        &self,
        v: usize,
        ring: &[usize],
        middles: &[SVector<T, N>],
        faces: &[SVector<T, N>],
    ) -> SVector<T, N> {
        let (topology, n) = (self.mesh.topology(), ring.len());
        // Of edge `i + k` around the vertex, `k` from -2 on.
        let d = |i: usize, k: usize| self.of(ring[(i + 2 * n + k - 2) % n]);
        let half = T::frac(1, 2);
        let weights = |i: usize| {
            let m = (d(i, 3).clone() + d(i, 1)) * (d(i, 4).clone() + d(i, 0)) * &half;
            [m, d(i, 1).clone() * d(i, 4)]
        };
        let tending = |i: usize| {
            let f = d(i, 1).clone() + d(i, 4);
            [d(i, 3).clone() + d(i, 0) + &f, f]
        };
        let sum_up = |weights: &dyn Fn(usize) -> [T; 2]| {
            let (mut point, mut sum) = (SVector::zeros(), T::zero());
            for (i, &h) in ring.iter().enumerate() {
                let [m, f] = weights(i);
                Coeff::add_scaled(&mut point, &m, &middles[topology.edge_of(h)]);
                Coeff::add_scaled(&mut point, &f, &faces[topology.face_of(h)]);
                sum += m + f;
            }
            (point, sum)
        };
        let (mut point, mut sum) = sum_up(&weights);
        if sum.is_zero() {
            (point, sum) = sum_up(&tending);
        }
        let old = &self.mesh.points()[v];
        if sum.is_zero() {
            return old.clone();
        }
        let valence = T::int(n as i64);
        Coeff::divide(&mut point, &(sum * &valence / T::int(3)));
        Coeff::add_scaled(&mut point, &(T::int(n as i64 - 3) / valence), old);
        point
    }
}
