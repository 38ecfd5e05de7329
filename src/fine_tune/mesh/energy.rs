//! The energy of a net of springs, and its gradient.
//!
//! ```text
//! E = k_l Σ (l_opt - l)² + k_a Σ (θa_opt - θa)² + k_b Σ (θb_opt - θb)²          [Miura, (14)]
//! ```
//! with `l` the lengths of the edges, `θa` the angles by which [loops](super::loops) turn at their vertices, and `θb` those between neighbours
//! around a vertex. Angles have no sign:
//!
//! ```text
//! θ = atan2(|u × v|, u·v),    ∂θ/∂u = -(n × u) / |u|,    ∂θ/∂v = (n × v) / |v|,    n = u × v / |u × v|
//! ```
//! for unit vectors on the right of the slashes, which is accurate at 0 and π too. At these two the angle itself has a kink: a cone with
//! its tip down at 0, up at π. Where an angle of 0 is asked for, `θ²` is smooth. Else the energy of the joint falls from the kink to
//! all sides, so that no minimum lies there. The gradient on a kink is zero, the mean over all sides.

use super::net::{Net, Vector};
use crate::fine_tune::chain::direction;
use crate::fine_tune::joint::Jointed;

impl Net {
    /// The coordinates of the points that may move.
    pub(super) fn coordinates(&self) -> Vec<f64> {
        self.points[..self.free].iter().flatten().copied().collect()
    }

    /// Puts the points that may move there, and measures the legs.
    pub(super) fn lay(&mut self, x: &[f64]) {
        let values = x.chunks_exact(3).map(Vector::from_column_slice);
        self.points.iter_mut().zip(values).for_each(|(point, value)| *point = value);
        for (leg, to) in self.legs.iter().zip(&mut self.directions) {
            *to = direction(&(self.points[leg.ends[1]] - self.points[leg.ends[0]]));
        }
    }

    /// The energy with these points, and the gradient.
    ///
    /// A leg without length has no direction; it is not pulled, nor are its joints bent.
    pub(super) fn energy(&mut self, x: &[f64], gradient: &mut [f64]) -> f64 {
        self.lay(x);
        let mut energy = 0.0;
        for ((leg, (unit, length)), pull) in self.legs.iter().zip(&self.directions).zip(&mut self.pulls) {
            let missing = leg.length - length;
            energy += leg.stretch * missing * missing;
            *pull = unit * (-2.0 * leg.stretch * missing);
        }
        for joint in &self.joints {
            let [(u, near), (v, far)] = joint.sides(&self.directions);
            let turn = u.turn_to(&v);
            let excess = joint.angle - turn.angle;
            energy += joint.bend * excess * excess;
            if near > 0.0 && far > 0.0 {
                let torque = 2.0 * joint.bend * excess;
                self.pulls[joint.legs[0]] += turn.across[0] * (torque / near * joint.signs[0]);
                self.pulls[joint.legs[1]] -= turn.across[1] * (torque / far * joint.signs[1]);
            }
        }
        gradient.fill(0.0);
        for (leg, pull) in self.legs.iter().zip(&self.pulls) {
            for (end, sign) in leg.ends.into_iter().zip([-1.0, 1.0]) {
                if end < self.free {
                    (0..3).for_each(|a| gradient[3 * end + a] += sign * pull[a]);
                }
            }
        }
        energy
    }

    /// The three sums of the energy as the points lie, the largest deviation of a length, relative to what it should be, and
    /// the largest of an angle in a loop.
    pub(super) fn parts(&self) -> ([f64; 3], [f64; 2]) {
        let (mut sums, mut deviations) = ([0.0; 3], [0.0_f64; 2]);
        for (leg, (_, length)) in self.legs.iter().zip(&self.directions).filter(|(leg, _)| leg.stretch > 0.0)
        {
            let missing = leg.length - length;
            sums[0] += leg.stretch * missing * missing;
            deviations[0] = deviations[0].max(missing.abs() / leg.length);
        }
        for (k, joint) in self.joints.iter().enumerate() {
            let [(u, _), (v, _)] = joint.sides(&self.directions);
            let excess = joint.angle - u.turn_to(&v).angle;
            let kind = if k < self.straight { 1 } else { 2 };
            sums[kind] += joint.bend * excess * excess;
            if kind == 1 {
                deviations[1] = deviations[1].max(excess.abs());
            }
        }
        (sums, deviations)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fine_tune::mesh::net::Constants;
    use crate::fine_tune::mesh::net::tests::{EQUAL, mesh, net, noise};
    use std::f64::consts::FRAC_PI_2;

    /// Compares the gradient with differences of the fourth order at distances `h`.
    fn check_gradient(net: &mut Net, x: &mut [f64], h: f64) {
        let (mut gradient, mut spare) = (vec![7.0; x.len()], vec![0.0; x.len()]);
        net.energy(x, &mut gradient);
        let largest = gradient.iter().fold(0.0, |most: f64, g| most.max(g.abs()));
        for k in 0..x.len() {
            let here = x[k];
            let mut at = |t: f64| {
                x[k] = here + t;
                net.energy(x, &mut spare)
            };
            let slope = (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
            x[k] = here;
            assert!(
                (slope - gradient[k]).abs() < 1e-6 * largest,
                "{k}: {slope} and {} of {largest}",
                gradient[k]
            );
        }
    }

    #[test]
    fn gradients_agree_with_differences() {
        for seed in 0..12 {
            let mut next = noise(seed + 100);
            let alpha: Vec<f64> = (0..40).map(|_| 1.0 + 0.4 * next()).collect();
            for constants in [EQUAL, Constants { uniform: true, ..EQUAL }] {
                let mut net = net(mesh(seed % 2 == 0, 0.15, seed), |e| alpha[e], |_| true, true, &constants);
                let mut x = net.coordinates();
                x.iter_mut().for_each(|x| *x += 0.02 * next());
                check_gradient(&mut net, &mut x, 2e-5);
            }
        }
    }

    #[test]
    fn gradients_are_right_near_straight_angles_that_should_be_straight() {
        // A plane grid: all loops are straight, and where they are not their energy is smooth.
        for size in [0.0, 1e-12, 1e-8, 1e-4] {
            let mut net =
                net(mesh(false, 0.0, 0), |e| if e == 5 { 1.5 } else { 1.0 }, |_| true, true, &EQUAL);
            let (mut x, mut next) = (net.coordinates(), noise(3));
            x.iter_mut().for_each(|x| *x += size * next());
            check_gradient(&mut net, &mut x, 1e-3);
        }
    }

    #[test]
    fn gradients_are_right_near_straight_angles_that_should_not_be() {
        // The angles asked for are those of a crumpled sheet, the points are those of one nearly plane.
        for size in [1e-2, 1e-1] {
            let mut net = net(mesh(false, 0.3, 4), |_| 1.0, |_| true, true, &EQUAL);
            let flat = self::net(mesh(false, size, 5), |_| 1.0, |_| true, true, &EQUAL);
            // An angle of the size bends over displacements of that size.
            check_gradient(&mut net, &mut flat.coordinates(), 1e-3 * size);
        }
    }

    #[test]
    fn on_a_kink_the_gradient_is_zero() {
        let mut net = net(mesh(false, 0.0, 0), |_| 1.0, |_| true, true, &EQUAL);
        // At the corners of the boundary angles are right ones.
        net.joints.truncate(net.straight);
        net.joints.retain(|joint| joint.angle < 1e-9);
        net.joints.iter_mut().for_each(|joint| joint.angle = 0.3);
        net.legs.iter_mut().for_each(|leg| leg.stretch = 0.0);
        // Whole numbers, without rounding.
        let x: Vec<f64> = net.coordinates().iter().map(|x| (6.0 * x).round()).collect();
        let count = net.joints.len() as f64;
        let mut gradient = vec![1.0; x.len()];
        let energy = net.energy(&x, &mut gradient);
        assert!((energy - count * 0.09).abs() < 1e-12 && gradient.iter().all(|g| g.abs() < 1e-12));
    }

    #[test]
    fn each_term_counts_as_the_formula_says() {
        // A cube: corners at a sixth of its sides, so that edges are 2/3 and, across the edges of the cube, √2/6 long.
        let mut net = net(mesh(true, 0.0, 0), |_| 1.0, |_| true, true, &EQUAL);
        let mut angles: Vec<f64> = net.joints[..net.straight].iter().map(|joint| joint.angle).collect();
        angles.sort_unstable_by(f64::total_cmp);
        let x = net.coordinates();
        assert_eq!(net.energy(&x, &mut vec![0.0; x.len()]), 0.0);
        // All loops turn by an eighth of a turn at each vertex.
        assert!(angles.iter().all(|angle| (angle - 0.5 * FRAC_PI_2).abs() < 1e-12), "{angles:?}");
        net.legs.iter_mut().for_each(|leg| leg.length += 0.5);
        for (k, joint) in net.joints.iter_mut().enumerate() {
            joint.angle += if k < net.straight { 0.25 } else { 0.125 };
        }
        net.lay(&x);
        let (sums, [_, angle]) = net.parts();
        let expected = [48.0 * 0.7 * 0.25, 48.0 * 0.0625, 96.0 * 0.4 / 64.0];
        assert!(
            sums.iter().zip(expected).all(|(s, e)| (s - e).abs() < 1e-12) && (angle - 0.25).abs() < 1e-12
        );
        let energy = net.energy(&x, &mut vec![0.0; x.len()]);
        assert!((energy - expected.iter().sum::<f64>()).abs() < 1e-12);
    }

    #[test]
    fn legs_without_length_are_left_alone() {
        let mut net = net(mesh(true, 0.0, 0), |_| 1.0, |_| true, true, &EQUAL);
        let mut gradient = vec![1.0; 72];
        assert!(net.energy(&[0.5; 72], &mut gradient).is_finite());
        assert!(gradient.iter().all(|g| *g == 0.0));
    }
}
