//! A closed chain of springs: legs that resist stretching, joints that resist bending.
//!
//! ```text
//! E = Σ_i k_l (l_i^opt - l_i)² + k_a (θ_i^opt - θ_i)²          [Miura, (13)]
//! ```
//! with `l_i` the length of the leg from point `i` to point `i + 1`, the last one back to the first, and `θ_i` the
//! [angle](crate::fine_tune::joint) between legs `i - 1` and `i`, in radians, the first between the last leg and the first.
//!
//! Short legs make joints stiff: the second derivatives across them are `k_a / l²` against `k_l` along them. So gradients are
//! softened by the stiffness of the chain as it lies, which is a matrix that couples neighbours only.

use crate::error::{Error, Result};
use crate::fine_tune::joint::Jointed;
use crate::fine_tune::minimise::Energy;
use crate::fine_tune::ring::RingMatrix;
use crate::vector::unit;
use nalgebra::SVector;

/// How stiff the ground is at every point, over the squared number of points: enough to keep pivots positive where nothing
/// else resists.
const GROUND: f64 = 1e-3;

/// A closed chain: what its legs and joints would be at rest, which points are held, and its stiffness.
#[derive(Clone, Debug)]
pub(crate) struct Chain<const N: usize> {
    lengths: Vec<f64>,
    angles: Vec<f64>,
    stretch: Vec<f64>,
    bend: f64,
    held: Vec<bool>,
    stiffness: RingMatrix,
    room: Vec<f64>,
}

/// The leg from point `i` to the next one.
fn leg<const N: usize>(points: &[f64], i: usize) -> SVector<f64, N> {
    let next = if (i + 1) * N == points.len() { 0 } else { i + 1 };
    SVector::from_fn(|axis, _| points[next * N + axis] - points[i * N + axis])
}

/// Direction and length of a leg; of none the direction is zero.
pub(crate) fn direction<const N: usize>(leg: &SVector<f64, N>) -> (SVector<f64, N>, f64) {
    let length = leg.norm();
    if length > 0.0 { (leg / length, length) } else { (SVector::zeros(), 0.0) }
}

impl<const N: usize> Chain<N>
where
    SVector<f64, N>: Jointed,
{
    /// The chain that is at rest with these legs, closed or not, and has the points `held` nailed down. The constants are
    /// `stretch`, for each leg, or if legs are `uniform` for one of mean length, and `bend`.
    ///
    /// # Errors
    /// [`Error::ZeroLeg`].
    pub(crate) fn at_rest(
        legs: &[SVector<f64, N>],
        [stretch, bend]: [f64; 2],
        uniform: bool,
        held: &[usize],
    ) -> Result<Self> {
        let directed = |(index, leg)| unit(leg).ok_or(Error::ZeroLeg { index });
        let legs: Vec<_> = legs.iter().enumerate().map(directed).collect::<Result<_>>()?;
        let before = legs.iter().cycle().skip(legs.len().max(1) - 1);
        let angles = before.zip(&legs).map(|((u, _), (v, _))| u.turn_to(v).angle).collect();
        let mut nailed = vec![false; legs.len()];
        held.iter().for_each(|&i| nailed[i] = true);
        let lengths: Vec<f64> = legs.iter().map(|(_, length)| *length).collect();
        let mean = lengths.iter().map(|length| length / lengths.len() as f64).sum::<f64>();
        let stretched = |length: &f64| if uniform { stretch * (mean / length) } else { stretch };
        Ok(Self {
            stretch: lengths.iter().map(stretched).collect(),
            lengths,
            angles,
            bend,
            held: nailed,
            stiffness: RingMatrix::zero(legs.len(), N),
            room: vec![0.0; legs.len() * N],
        })
    }

    /// Its energy with these points, and the gradient.
    ///
    /// A leg without length has no direction; it is not pulled, nor are its joints bent.
    pub(crate) fn energy(&self, points: &[f64], gradient: &mut [f64]) -> f64 {
        gradient.fill(0.0);
        let count = self.lengths.len();
        let mut pull = |i: usize, force: &SVector<f64, N>| {
            let next = if i + 1 == count { 0 } else { i + 1 };
            for axis in 0..N {
                gradient[next * N + axis] += force[axis];
                gradient[i * N + axis] -= force[axis];
            }
        };
        let mut energy = 0.0;
        let mut before = count - 1;
        let (mut u, mut size) = direction(&leg::<N>(points, before));
        for (i, (wanted, angle)) in self.lengths.iter().zip(&self.angles).enumerate() {
            let (v, length) = direction(&leg::<N>(points, i));
            let (turn, missing) = (u.turn_to(&v), wanted - length);
            let excess = SVector::excess(*angle, turn.angle);
            energy += self.stretch[i] * missing * missing + self.bend * excess * excess;
            let torque = 2.0 * self.bend * excess;
            let [near, far] = turn.across;
            let along = v * (-2.0 * self.stretch[i] * missing);
            if size > 0.0 && length > 0.0 {
                pull(before, &(near * (torque / size)));
                pull(i, &(along - far * (torque / length)));
            } else {
                pull(i, &along);
            }
            (before, u, size) = (i, v, length);
        }
        for (g, _) in gradient.chunks_exact_mut(N).zip(&self.held).filter(|(_, held)| **held) {
            g.fill(0.0);
        }
        energy
    }

    /// The largest deviation of a length, relative to what it would be at rest, and the largest of an angle.
    pub(crate) fn deviation(&self, points: &[f64]) -> [f64; 2] {
        let mut u = direction(&leg::<N>(points, self.lengths.len() - 1)).0;
        let mut most = [0.0_f64; 2];
        for (i, (wanted, angle)) in self.lengths.iter().zip(&self.angles).enumerate() {
            let (v, length) = direction(&leg::<N>(points, i));
            let excess = SVector::excess(*angle, u.turn_to(&v).angle);
            most = [most[0].max((length / wanted - 1.0).abs()), most[1].max(excess.abs())];
            u = v;
        }
        most
    }
}

impl<const N: usize> Energy for Chain<N>
where
    SVector<f64, N>: Jointed,
{
    const RENEWAL: usize = 6;

    fn value(&mut self, points: &[f64], gradient: &mut [f64]) -> f64 {
        self.energy(points, gradient)
    }

    /// The second derivatives of the energy of springs at rest as they lie; in space joints resist being turned out of their
    /// plane too. Without points held the first is put on firmer ground: no force acts on the chain as a whole.
    fn renew(&mut self, points: &[f64]) {
        let count = self.lengths.len();
        let matrix = &mut self.stiffness;
        matrix.reset(GROUND / (count * count) as f64);
        if !self.held.contains(&true) {
            matrix.add_diagonal(0, 1.0);
        }
        for i in (0..count).filter(|&i| self.held[i]) {
            matrix.add_diagonal(i, 1.0);
        }
        let free = |i: usize, w: SVector<f64, N>| if self.held[i] { SVector::zeros() } else { w };
        let across = (2.0 * self.bend).sqrt();
        let mut before = count - 1;
        let (mut u, mut size) = direction(&leg::<N>(points, before));
        for i in 0..count {
            let next = if i + 1 == count { 0 } else { i + 1 };
            let (v, length) = direction(&leg::<N>(points, i));
            let along = (2.0 * self.stretch[i]).sqrt();
            matrix.add_square([i, next], [free(i, v * -along), free(next, v * along)]);
            if size > 0.0 && length > 0.0 {
                for [near, far] in u.hinges(&v, self.angles[i]) {
                    let (near, far) = (near * (across / size), far * (across / length));
                    let moved = [free(before, near), free(i, -near - far), free(next, far)];
                    matrix.add_square([before, i, next], moved);
                }
            }
            (before, u, size) = (i, v, length);
        }
        matrix.factor();
    }

    fn soften(&mut self, gradient: &mut [f64]) {
        self.stiffness.solve(gradient, &mut self.room);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers in `[-1, 1]` without a pattern.
    fn noise(seed: u64) -> impl FnMut() -> f64 {
        let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
        move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        }
    }

    fn gradient_is_the_change<const N: usize>()
    where
        SVector<f64, N>: Jointed,
    {
        for seed in 0..60 {
            let (mut next, count) = (noise(seed), 3 + seed as usize % 6);
            let legs: Vec<SVector<f64, N>> = (0..count).map(|_| SVector::from_fn(|_, _| next())).collect();
            let chain = Chain::at_rest(&legs, [0.7, 1.9], false, &[]).unwrap();
            let mut points: Vec<f64> = (0..count * N).map(|_| next()).collect();
            let (mut gradient, mut spare) = (vec![7.0; count * N], vec![0.0; count * N]);
            chain.energy(&points, &mut gradient);
            // Where legs are short or an angle is near half a turn the energy bends too much for differences.
            let sharp = (0..count).any(|i| {
                let (u, v) =
                    (direction(&leg::<N>(&points, (i + count - 1) % count)), direction(&leg(&points, i)));
                let turn = u.0.turn_to(&v.0).angle.abs();
                v.1 < 0.2
                    || turn < 0.1
                    || SVector::<f64, N>::excess(chain.angles[i], turn).abs() > 3.0
                    || turn > 3.0
            });
            if sharp {
                continue;
            }
            let h = 1e-5;
            for k in 0..points.len() {
                let here = points[k];
                let mut at = |x: f64| {
                    points[k] = x;
                    chain.energy(&points, &mut spare)
                };
                let slope = (at(here + h) - at(here - h)) / (2.0 * h);
                points[k] = here;
                assert!((slope - gradient[k]).abs() < 1e-6, "seed {seed}, {k}: {slope} and {}", gradient[k]);
            }
        }
    }

    #[test]
    fn gradients_agree_with_differences() {
        gradient_is_the_change::<2>();
        gradient_is_the_change::<3>();
    }

    #[test]
    fn a_chain_at_rest_has_no_energy_and_no_gradient() {
        let points = [0.0, 0.0, 4.0, 1.0, 1.0, 5.0, -2.0, 0.5];
        let legs: Vec<SVector<f64, 2>> = (0..4).map(|i| leg(&points, i)).collect();
        let chain = Chain::at_rest(&legs, [1.0, 2.0], false, &[]).unwrap();
        let mut gradient = [1.0; 8];
        assert!(chain.energy(&points, &mut gradient) < 1e-30);
        assert!(gradient.iter().all(|g| g.abs() < 1e-14));
        assert!(chain.deviation(&points).iter().all(|d| *d < 1e-15));
        // The same with one angle wrapped: 4 legs round once.
        assert!((chain.angles.iter().sum::<f64>() - std::f64::consts::TAU).abs() < 1e-14);
    }

    #[test]
    fn each_term_counts_as_the_formula_says() {
        // A square of side 1; at rest its legs have length 2 and it is straight.
        let points = [0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0];
        let legs = vec![SVector::from([2.0, 0.0]); 4];
        let chain = Chain::at_rest(&legs, [3.0, 5.0], false, &[]).unwrap();
        let quarter = std::f64::consts::FRAC_PI_2;
        let energy = chain.energy(&points, &mut [0.0; 8]);
        assert!((energy - 4.0 * (3.0 + 5.0 * quarter * quarter)).abs() < 1e-13);
        let [length, angle] = chain.deviation(&points);
        assert_eq!((length, angle), (0.5, quarter));
    }

    #[test]
    fn legs_without_length_are_refused_or_left_alone() {
        let legs = [SVector::from([1.0, 0.0]), SVector::zeros()];
        assert_eq!(Chain::at_rest(&legs, [1.0; 2], false, &[]).unwrap_err(), Error::ZeroLeg { index: 1 });
        let chain = Chain::at_rest(&[SVector::from([1.0, 0.0]); 3], [1.0; 2], false, &[]).unwrap();
        let mut gradient = [1.0; 6];
        assert!(chain.energy(&[0.5; 6], &mut gradient).is_finite());
        assert_eq!(gradient, [0.0; 6]);
        // The leg behind one without length is pulled, though there is no angle between them.
        let chain = Chain::at_rest(&[SVector::from([2.0, 0.0]); 3], [1.0; 2], false, &[]).unwrap();
        chain.energy(&[0.0, 0.0, 0.0, 0.0, 3.0, 0.0], &mut gradient);
        // Leg 1 is 1 too long, and so is leg 2, back from point 2 to point 0.
        assert_eq!([gradient[0], gradient[2], gradient[4]], [-2.0, -2.0, 4.0]);
    }

    #[test]
    fn legs_of_one_material_are_the_stiffer_the_shorter() {
        let legs = [1.0, 1.0, 4.0].map(|x| SVector::from([x, 0.0]));
        let chain = Chain::at_rest(&legs, [5.0, 1.0], true, &[]).unwrap();
        assert_eq!(chain.stretch, [10.0, 10.0, 2.5]);
        assert_eq!(Chain::at_rest(&legs, [5.0, 1.0], false, &[]).unwrap().stretch, [5.0; 3]);
    }

    /// One step by the stiffness takes nearly all energy out of a chain that was moved a little.
    fn stiffness_is_the_second_derivative<const N: usize>(held: &[usize])
    where
        SVector<f64, N>: Jointed,
    {
        for seed in 0..20 {
            let (mut next, count) = (noise(seed), 6);
            // A hexagon, more or less.
            let corner = |i: usize, axis: usize| match axis {
                0 => (i as f64 * 1.05).cos(),
                1 => (i as f64 * 1.05).sin(),
                _ => 0.0,
            };
            let rest: Vec<f64> = (0..count * N).map(|k| corner(k / N, k % N) + 0.1 * next()).collect();
            let legs: Vec<SVector<f64, N>> = (0..count).map(|i| leg(&rest, i)).collect();
            let mut chain = Chain::at_rest(&legs, [0.7, 1.9], seed % 2 == 0, held).unwrap();
            let mut points = rest.clone();
            for (k, x) in points.iter_mut().enumerate().filter(|(k, _)| !held.contains(&(k / N))) {
                *x += if k % N < 2 { 1e-5 * next() } else { 0.0 };
            }
            let mut gradient = vec![0.0; points.len()];
            let before = chain.energy(&points, &mut gradient);
            chain.renew(&rest);
            chain.soften(&mut gradient);
            points.iter_mut().zip(&gradient).for_each(|(x, z)| *x -= z);
            let after = chain.energy(&points, &mut gradient);
            assert!(after < 1e-4 * before, "seed {seed}: {before} to {after}");
            assert!(held.iter().all(|&i| points[i * N..(i + 1) * N] == rest[i * N..(i + 1) * N]));
        }
    }

    #[test]
    fn one_step_by_the_stiffness_relaxes_small_moves() {
        stiffness_is_the_second_derivative::<2>(&[]);
        stiffness_is_the_second_derivative::<2>(&[0, 3]);
        stiffness_is_the_second_derivative::<3>(&[]);
        stiffness_is_the_second_derivative::<3>(&[1, 2]);
    }
}
