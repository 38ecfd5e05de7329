//! How a net of springs resists as it lies: the positive part of the second derivatives of its energy.
//!
//! A leg resists along itself by `2 k`, and across itself by `2 k (1 - l_opt / l)` if it is too long. A joint resists in its plane by `2 k ∇θ
//! ∇θᵀ`. By second derivatives it also resists if its sides leave the plane by angles `s`, `t`:
//!
//! ```text
//! k (θ - θ_opt) cot(θ/2) (s - t)²   if θ > θ_opt,        k (θ_opt - θ) tan(θ/2) (s + t)²   otherwise
//! ```
//! of which the former is as large as in the plane if the joint is straight and should be.

use super::dissect::Graph;
use super::net::{Leg, Net, Vector};
use super::sparse::SparseMatrix;
use crate::fine_tune::turn::across;
use crate::vector::cross3;

/// How stiff the ground is at every point: next to nothing, but a net without fixed points has nothing else.
const GROUND: f64 = 1e-6;

/// The angle up to which a joint counts as straight: it may be rounding alone that bends it.
const STRAIGHT: f64 = 1e-8;

/// The stiffness of a net.
#[derive(Clone, Debug)]
pub(super) struct Stiffness {
    matrix: SparseMatrix,
    room: Vec<[f64; 3]>,
}

impl Stiffness {
    /// Room for that of this net.
    pub(super) fn of(net: &Net) -> Self {
        let pairs = net.joints.iter().flat_map(|joint| {
            let [a, b, c] = joint.places;
            [[a, b], [b, c], [c, a]]
        });
        let legs = net.legs.iter().map(|leg| leg.ends);
        let free = |pair: &[usize; 2]| pair.iter().all(|place| *place < net.free);
        let graph = Graph::of(net.free, pairs.chain(legs).filter(free));
        Self { matrix: SparseMatrix::zero(&graph), room: vec![[0.0; 3]; net.free] }
    }

    /// Makes it that of the net as it lies, the diagonal raised by a share.
    pub(super) fn renew(&mut self, net: &Net, damping: f64) {
        self.matrix.reset(GROUND);
        for (leg, (unit, length)) in net.legs.iter().zip(&net.directions) {
            self.add_leg(leg, unit, *length);
        }
        for (k, joint) in net.joints.iter().enumerate() {
            let [(u, near), (v, far)] = joint.sides(&net.directions);
            if !(near > 0.0 && far > 0.0) {
                continue;
            }
            let normal = cross3(&u, &v);
            let sine = normal.norm();
            let normal = if sine > 0.0 { normal / sine } else { across(&u) };
            let angle = sine.atan2(u.dot(&v));
            // By how much the sides turn if the first end, or the other, moves.
            let turned = if k < net.straight { -1.0 / near } else { 1.0 / near };
            let mut add = |share: f64, s: Vector, t: Vector| {
                let size = (2.0 * joint.bend * share).sqrt();
                let (s, t) = (s * (size * turned), t * (size / far));
                self.matrix.add_square(joint.places, &[s, -s - t, t].map(Into::into));
            };
            add(1.0, -cross3(&normal, &u), cross3(&normal, &v));
            let excess = angle - joint.angle;
            let half = (0.5 * angle).tan();
            if angle <= STRAIGHT {
                add(if joint.angle <= STRAIGHT { 1.0 } else { 0.0 }, -normal, normal);
            } else if excess > 0.0 {
                add(0.5 * excess / half, -normal, normal);
            } else {
                add(-0.5 * excess * half, normal, normal);
            }
        }
        if damping > 0.0 {
            self.matrix.raise(1.0 + damping);
        }
        self.matrix.factor();
    }

    fn add_leg(&mut self, leg: &Leg, unit: &Vector, length: f64) {
        let mut add = |stiff: f64, way: &Vector| {
            let way = way * (2.0 * stiff).sqrt();
            self.matrix.add_square(leg.ends, &[-way, way].map(Into::into));
        };
        add(leg.stretch, unit);
        if length > leg.length {
            let (stiff, side) = (leg.stretch * (1.0 - leg.length / length), across(unit));
            add(stiff, &side);
            add(stiff, &cross3(unit, &side));
        }
    }

    /// Divides a gradient by it.
    pub(super) fn soften(&mut self, gradient: &mut [f64]) {
        self.matrix.solve(gradient, &mut self.room);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fine_tune::mesh::net::Constants;
    use crate::fine_tune::mesh::net::tests::{mesh, net, noise};

    /// The energies of a net at `x`, and after one step by the stiffness that it has at rest.
    fn stepped(net: &mut Net, rest: &[f64], mut x: Vec<f64>) -> [f64; 2] {
        let mut gradient = vec![0.0; x.len()];
        let before = net.energy(&x, &mut gradient);
        let mut stiffness = Stiffness::of(net);
        net.lay(rest);
        stiffness.renew(net, 0.0);
        stiffness.soften(&mut gradient);
        x.iter_mut().zip(&gradient).for_each(|(x, z)| *x -= z);
        [before, net.energy(&x, &mut gradient)]
    }

    /// One step by the stiffness takes nearly all energy out of a net at rest that was moved a little.
    #[test]
    fn one_step_by_the_stiffness_relaxes_small_moves() {
        let constants = Constants { stretch: 0.7, bend: 1.0, shape: 0.4, uniform: false };
        for seed in 0..8 {
            for few in [false, true] {
                let free = |v: usize| !few || v > 5;
                let mut net = net(mesh(seed % 2 == 0, 0.1, seed), |_| 1.0, free, true, &constants);
                let (rest, mut next) = (net.coordinates(), noise(seed));
                let x: Vec<f64> = rest.iter().map(|x| x + 1e-6 * next()).collect();
                let [before, after] = stepped(&mut net, &rest, x);
                assert!(after < 1e-4 * before, "seed {seed}: {before} to {after}");
            }
        }
    }

    #[test]
    fn plane_nets_resist_out_of_their_plane() {
        // Loops are straight and should be: heights count in the square of angles.
        let constants = Constants { stretch: 1.0, bend: 1.0, shape: 1e-9, uniform: false };
        let mut net = net(mesh(false, 0.0, 0), |_| 1.0, |v| v > 5, true, &constants);
        let (rest, mut next) = (net.coordinates(), noise(7));
        let x: Vec<f64> =
            rest.iter().enumerate().map(|(k, x)| x + if k % 3 == 2 { 1e-5 * next() } else { 0.0 }).collect();
        let [before, after] = stepped(&mut net, &rest, x);
        assert!(after < 1e-4 * before, "{before} to {after}");
    }
}
