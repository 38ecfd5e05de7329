//! How the corners of a face move inwards where knot intervals differ, or at a boundary: the rule of [`doo_sabin`](super::doo_sabin).
//!
//! With `d_ij` the interval of the edge between the corners `i` and `j` at `i`, and `s` as in [`face_rule`](super::face_rule),
//!
//! ```text
//! P̄_i = (1 - s) P_i + s V + s (1 - s) (c_{i+2} + c_{i-2}) / (2 Σ c) · (n (M - P_i) + 2 K_i)
//! c_k = d_{k-1,k} d_{k+1,k},   V = Σ c_k P_k / Σ c
//! ```
//! A four-sided face whose opposite intervals agree is a part of a biquadratic; there `V` is the point in which its four patches meet, and with
//! the joints `E` on the two legs at `P_i` the sum is `(1 - s)² P_i + s (1 - s) (E_i + E'_i) + s² V`: the curve rule in both directions.

use crate::error::Result;
use crate::mesh::boundary::Boundary;
use crate::mesh::control_mesh::ControlMesh;
use crate::mesh::face_rule::Waves;
use crate::scalar::{Scalar, larger};
use nalgebra::SVector;

/// The rule for a surface, with room for the intervals of a face.
pub(super) struct CornerRule<'a, T: Scalar, const N: usize> {
    mesh: &'a ControlMesh<T, N>,
    intervals: Option<&'a [[T; 2]]>,
    boundary: Boundary,
    /// Whether corners at an open boundary go all the way across it, to where the surface ends.
    clipped: bool,
    /// For each side of the face that came last, the intervals of its edge: where it begins, and where it ends.
    sides: Vec<[T; 2]>,
    /// The weights `c`.
    weights: Vec<T>,
}

impl<'a, T: Scalar, const N: usize> CornerRule<'a, T, N> {
    /// The rule for a mesh whose edges have the given intervals at the origins of their sides and at their other ends, or equal ones.
    pub(super) fn new(
        mesh: &'a ControlMesh<T, N>,
        intervals: Option<&'a [[T; 2]]>,
        boundary: Boundary,
    ) -> Self {
        Self { mesh, intervals, boundary, clipped: false, sides: Vec::new(), weights: Vec::new() }
    }

    /// The same, but that corners at an open boundary go all the way across it, to where the surface ends.
    pub(super) fn clipped(self) -> Self {
        Self { clipped: true, ..self }
    }

    /// Whether all intervals that count in face `f` are equal, so that there is no need for this rule.
    pub(super) fn is_even(&self, f: usize) -> bool {
        let topology = self.mesh.topology();
        let inside = || self.open() && !self.clipped || topology.sides(f).all(|h| topology.twin(h).is_some());
        self.intervals.is_none() && inside()
    }

    fn open(&self) -> bool {
        self.boundary == Boundary::Open
    }

    /// The knot interval of the edge of half-edge `h`, where `h` begins or at the other end.
    pub(super) fn interval(&self, h: usize, far: bool) -> T {
        let topology = self.mesh.topology();
        let e = topology.edge_of(h);
        let end = usize::from((topology.side(e) == h) == far);
        self.intervals.map_or_else(T::one, |intervals| intervals[e][end].clone())
    }

    /// The intervals that count in the face of half-edge `h`, of its edge, where it begins and at the other end.
    pub(super) fn side(&self, h: usize) -> [T; 2] {
        let topology = self.mesh.topology();
        let bounded = |h: usize| !self.open() && topology.twin(h).is_none();
        // Across the boundary, and along it where it has a corner: before and after the edge in question.
        let beside = [topology.prev(h), topology.next(h)];
        [false, true].map(|far| match bounded(beside[usize::from(far)]) {
            true => T::zero(),
            false => self.interval(h, far),
        })
    }

    /// Finds the weights `c` of the corners of face `f`: none if their sum vanishes.
    pub(super) fn weights(&mut self, f: usize) -> Option<&[T]> {
        let mut sides = std::mem::take(&mut self.sides);
        sides.clear();
        sides.extend(self.mesh.topology().sides(f).map(|h| self.side(h)));
        // Weights are products of intervals, whose scale does not matter: those of floats shall neither overflow nor vanish.
        let largest = sides.iter().flatten().cloned().fold(T::zero(), larger);
        if !T::EXACT && largest > T::zero() {
            sides.iter_mut().flatten().for_each(|d| *d = d.clone() / &largest);
        }
        // Edges without any interval get some that are equal, and as large as the others in the face.
        let whole = sides.iter().flatten().fold(T::zero(), |sum, d| sum + d);
        let some = if whole.is_zero() { T::one() } else { whole };
        for ends in sides.iter_mut().filter(|ends| ends.iter().all(|d| d.is_zero())) {
            *ends = [some.clone(), some.clone()];
        }
        self.sides = sides;
        let before = (self.sides.len() - 1..self.sides.len()).chain(0..self.sides.len());
        let weight = |(k, ahead): (usize, &[T; 2])| self.sides[k][0].clone() * &ahead[1];
        self.weights.clear();
        self.weights.extend(before.zip(&self.sides).map(weight));
        let sum = self.weights.iter().fold(T::zero(), |sum, c| sum + c);
        if sum.is_zero() {
            return None;
        }
        T::divide(&mut self.weights, &sum);
        Some(&self.weights)
    }

    /// Appends the new corners of face `f`, moved by the share `s`.
    pub(super) fn apply<const M: usize>(
        &mut self,
        share: T,
        f: usize,
        corners: &[SVector<T, M>],
        waves: &mut Waves<T, M>,
        moved: &mut Vec<SVector<T, M>>,
    ) -> Result<()> {
        let Some(weights) = self.weights(f) else {
            moved.extend_from_slice(corners);
            return Ok(());
        };
        let n = corners.len();
        let sum = waves.run(corners)?;
        let joint =
            corners.iter().zip(weights).fold(SVector::zeros(), |v, (corner, c)| v + corner * c.clone());
        let rest = T::one() - &share;
        let twist = share.clone() * &rest * T::frac(1, 2);
        for (i, corner) in corners.iter().enumerate() {
            let [ahead, behind] = if self.clipped { self.rim(f, i) } else { self.along(f, i) };
            moved.push(match (self.open(), ahead, behind) {
                (_, false, false) => {
                    let far = self.weights[(i + 2) % n].clone() + &self.weights[(i + n - 2) % n];
                    let bent = &sum - corner * T::int(n as i64) + &waves.first[i] * T::int(2);
                    corner * rest.clone() + &joint * share.clone() + bent * (far * &twist)
                }
                // The end of the surface is at the joints across the boundary.
                (true, true, true) => joint.clone(),
                (true, ..) => self.on_side(i, behind, corners) * rest.clone() + &joint * share.clone(),
                (false, true, true) => corner.clone(),
                (false, ..) => corner * rest.clone() + self.on_side(i, ahead, corners) * share.clone(),
            });
        }
        Ok(())
    }

    /// Whether the sides of face `f` after and before its corner `i` are at the boundary.
    fn rim(&self, f: usize, i: usize) -> [bool; 2] {
        let topology = self.mesh.topology();
        let h = topology.sides(f).start + i;
        [h, topology.prev(h)].map(|h| topology.twin(h).is_none())
    }

    /// Whether the boundary runs along the sides of face `f` after and before its corner `i`, and has to be kept.
    fn along(&self, f: usize, i: usize) -> [bool; 2] {
        self.rim(f, i).map(|bounded| bounded && !self.open())
    }

    /// The corners of face `f` that stay, and the first corners of boundary edges between corners that do not.
    pub(super) fn held(&self, f: usize) -> Vec<usize> {
        let n = self.mesh.topology().sides(f).len();
        let held = |i: &usize| {
            let [ahead, behind] = self.along(f, *i);
            ahead && (behind || !self.along(f, (i + 1) % n)[0])
        };
        (0..n).filter(held).collect()
    }

    /// The point that corner `i` of face `f`, which came last, is drawn to along a boundary that is kept: the joint on its boundary edge, or
    /// itself if it has two.
    pub(super) fn along_boundary<const M: usize>(
        &self,
        f: usize,
        i: usize,
        corners: &[SVector<T, M>],
    ) -> Option<SVector<T, M>> {
        match self.along(f, i) {
            [false, false] => None,
            [true, true] => Some(corners[i].clone()),
            [ahead, _] => Some(self.on_side(i, ahead, corners)),
        }
    }

    /// The joint on the side after corner `i` of the face that came last, or before it.
    fn on_side<const M: usize>(&self, i: usize, ahead: bool, corners: &[SVector<T, M>]) -> SVector<T, M> {
        let n = corners.len();
        let side = if ahead { i } else { (i + n - 1) % n };
        let [near, far] = &self.sides[side];
        let whole = near.clone() + far;
        &corners[side] * (far.clone() / &whole) + &corners[(side + 1) % n] * (near.clone() / &whole)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;
    use crate::mesh::face_rule::FaceRule;

    /// The formula of [Sederberg, 1998], term by term, for a face with six sides, where `cos(2π k / 6)` are halves.
    #[test]
    fn six_sides_are_those_of_the_formula() {
        let corner = |k: i64| SVector::from([Q::int(k * k % 7), Q::int(3 * k % 5)]);
        let corners: Vec<SVector<Q, 2>> = (0..6).map(corner).collect();
        let mesh = ControlMesh::new(corners.clone(), [[0, 1, 2, 3, 4, 5]]).unwrap();
        // At the beginning of side k, and at its end.
        let d: Vec<[Q; 2]> = (0..6).map(|k| [Q::int(k % 4 + 1), Q::int(k * k % 5 + 2)]).collect();
        let c = |k: usize| d[(k + 5) % 6][0].clone() * &d[k % 6][1];
        let sum = (0..6).fold(Q::int(0), |sum, k| sum + c(k));
        let v = (0..6).fold(SVector::zeros(), |v, k| v + &corners[k] * (c(k) / &sum));
        let cosines = [2, 1, -1, -2, -1, 1].map(|n| Q::frac(n, 2));

        let mut rule = CornerRule::new(&mesh, Some(&d), Boundary::Open);
        let mut moved = Vec::new();
        rule.apply(FaceRule::DooSabin.share(), 0, &corners, &mut Waves::default(), &mut moved).unwrap();
        for i in 0..6 {
            let term = |j: usize| &corners[j] * (Q::int(1) + Q::int(2) * &cosines[(6 + i - j) % 6]);
            let bent = (0..6).fold(&corners[i] * Q::int(-6), |bent, j| bent + term(j));
            let far = (c(i + 2) + c(i + 4)) / (Q::int(8) * &sum);
            assert_eq!(moved[i], (&v + &corners[i]) / Q::int(2) + bent * far, "corner {i}");
        }
    }
}
