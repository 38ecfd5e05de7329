//! The one nearest point of a piece on which `G` is convex, by Newton's method, and how much nearer a point could be
//! after all.
//!
//! With second derivatives of at least `m` in all directions, and slopes `g` at `t`, on the unit square
//!
//! ```text
//! G(y) >= G(t) + Σ (g_i τ_i + m τ_i² / 2),   τ = y - t
//! ```
//!
//! At `r = |A(t)| / w(t)` the value `G(t)` is 0, and the least of the sum says what is missing to 0 on the whole piece.

use crate::analysis::nearest::jet::{Jet, Room};
use nalgebra::SVector;

/// How many points are looked at at most.
const STEPS: usize = 24;

/// After a step as small as this the next one would be lost in rounding: the error is squared.
const SMALL: f64 = 1e-9;

/// A piece: points times weights, about the given point, and weights, none if all are one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Patch<'a, const N: usize> {
    pub(super) points: &'a [SVector<f64, N>],
    pub(super) weights: &'a [f64],
    pub(super) degrees: [usize; 2],
}

/// The nearest point of a piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    pub(super) at: [f64; 2],
    pub(super) distance: f64,
    /// No point of the piece is nearer than this.
    pub(super) lower: f64,
}

/// Room for the jets.
#[derive(Clone, Debug, Default)]
pub(super) struct Rooms<const N: usize> {
    points: Room<SVector<f64, N>>,
    weights: Room<f64>,
}

/// Squared distance, and the first and second derivatives of `G`, at a point.
#[derive(Clone, Copy, Debug)]
struct Local {
    at: [f64; 2],
    square: f64,
    slopes: [f64; 2],
    seconds: [f64; 3],
    /// What slopes may be off by.
    noise: [f64; 2],
}

impl<const N: usize> Patch<'_, N> {
    /// The nearest point, beginning at `start`. `bend` gives `m` for `r²`; `noise` is what coordinates may be off by.
    pub(super) fn polished(
        &self,
        start: [f64; 2],
        bend: impl Fn(f64) -> f64,
        noise: f64,
        rooms: &mut Rooms<N>,
    ) -> Option<Found> {
        let mut best = self.local(start, noise, rooms);
        let mut next = self.step(&best);
        for _ in 0..STEPS {
            let step = (0..2).map(|i| (next[i] - best.at[i]).abs()).fold(0.0, f64::max);
            if step == 0.0 {
                break;
            }
            let here = self.local(next, noise, rooms);
            let no_farther = here.square <= best.square + 2.0 * noise * (best.square.sqrt() + noise);
            if step <= SMALL {
                best = if no_farther { here } else { best };
                break;
            }
            if no_farther {
                (best, next) = (here, self.step(&here));
            } else {
                // Too far.
                next = std::array::from_fn(|i| 0.5 * (best.at[i] + next[i]));
            }
        }
        let bend = bend(best.square);
        if bend.is_nan() || bend <= 0.0 {
            return None;
        }
        let lightest = self.weights.iter().copied().fold(1.0, f64::min);
        let missing: f64 = (0..2).map(|axis| self.missing(&best, axis, bend)).sum();
        let lower = (best.square - missing / (lightest * lightest)).max(0.0).sqrt();
        Some(Found { at: best.at, distance: best.square.sqrt(), lower })
    }

    fn local(&self, at: [f64; 2], noise: f64, rooms: &mut Rooms<N>) -> Local {
        let Jet { value, first, second } = rooms.points.jet(self.points, self.degrees, at);
        let plain = value.norm_squared();
        let pair = [(0, 0), (0, 1), (1, 1)];
        let slopes = [0, 1].map(|i| 2.0 * value.dot(&first[i]));
        let seconds = [0, 1, 2].map(|k| {
            let (i, j) = pair[k];
            2.0 * (first[i].dot(&first[j]) + value.dot(&second[k]))
        });
        let noise = [0, 1].map(|i| 2.0 * noise * first[i].norm());
        if self.weights.is_empty() {
            return Local { at, square: plain, slopes, seconds, noise };
        }
        let weight = rooms.weights.jet(self.weights, self.degrees, at);
        let square = plain / (weight.value * weight.value);
        let twice = 2.0 * square;
        let slope = |i: usize| slopes[i] - twice * weight.value * weight.first[i];
        let second = |k: usize| {
            let (i, j) = pair[k];
            seconds[k] - twice * (weight.first[i] * weight.first[j] + weight.value * weight.second[k])
        };
        let noise = [0, 1].map(|i| noise[i] * (1.0 + square) + twice * f64::EPSILON * weight.first[i].abs());
        Local { at, square, slopes: [slope(0), slope(1)], seconds: [second(0), second(1), second(2)], noise }
    }

    /// Where Newton's method goes from here, inside the square.
    fn step(&self, local: &Local) -> [f64; 2] {
        let free = [0, 1].map(|i| {
            let outwards = (local.at[i] == 0.0 && local.slopes[i] >= 0.0)
                || (local.at[i] == 1.0 && local.slopes[i] <= 0.0);
            self.degrees[i] > 0 && !outwards
        });
        let ([g, h], [uu, uv, vv]) = (local.slopes, local.seconds);
        let determinant = uu * vv - uv * uv;
        // Where the second derivative is not positive, towards the far end: a step that is too long is taken back.
        let alone = |slope: f64, second: f64| if second > 0.0 { -slope / second } else { -slope.signum() };
        let step = match free {
            [true, true] if determinant > 0.0 && uu > 0.0 => {
                [(uv * h - vv * g) / determinant, (uv * g - uu * h) / determinant]
            }
            _ => [alone(g, uu), alone(h, vv)],
        };
        std::array::from_fn(|i| {
            let next = (local.at[i] + step[i]).clamp(0.0, 1.0);
            if free[i] && next.is_finite() { next } else { local.at[i] }
        })
    }

    /// How far below 0 the bound of `G` goes in one direction.
    fn missing(&self, local: &Local, axis: usize, bend: f64) -> f64 {
        if self.degrees[axis] == 0 {
            return 0.0;
        }
        let (low, high) = (-local.at[axis], 1.0 - local.at[axis]);
        let depth = |slope: f64| {
            let step = (-slope / bend).clamp(low, high);
            -(slope * step + 0.5 * bend * step * step)
        };
        let (slope, noise) = (local.slopes[axis], local.noise[axis]);
        depth(slope - noise).max(depth(slope + noise))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::vector;

    /// `g τ + m τ² / 2` is `-g² / 2m` at least, within the interval.
    #[test]
    fn slopes_that_are_left_are_counted() {
        let points = [vector![0.0], vector![1.0]];
        let patch = Patch { points: &points, weights: &[], degrees: [1, 0] };
        let local = |slope: f64, noise: f64| Local {
            at: [0.5, 0.0],
            square: 1.0,
            slopes: [slope, 9.0],
            seconds: [0.0; 3],
            noise: [noise, 9.0],
        };
        assert_eq!(patch.missing(&local(1.0, 0.0), 0, 4.0), 0.125);
        assert_eq!(patch.missing(&local(-1.0, 0.5), 0, 4.0), 0.28125);
        assert_eq!(patch.missing(&local(8.0, 0.0), 0, 4.0), 3.5);
        assert_eq!(patch.missing(&local(1.0, 0.0), 1, 4.0), 0.0);
    }
}
