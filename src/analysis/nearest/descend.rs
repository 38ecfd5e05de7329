//! A nearer point by descent, where proofs take long.
//!
//! In a long and narrow valley of the distance, as near the folds of a surface, nothing is known to be convex until
//! parts are tiny. The corners of parts come down slowly then. The method of Levenberg and Marquardt goes along the
//! valley: a point that is nearer lets more be passed over, whatever is proved of it.

use crate::analysis::nearest::jet;
use crate::analysis::nearest::search::{Part, Search, Spot};
use crate::analysis::nearest::split::count;
use nalgebra::SVector;

/// How many points are looked at at most.
const STEPS: usize = 64;

/// A step that is damped more is lost in rounding.
const STIFF: f64 = 1e16;

/// A point about the given one, with its first derivatives.
struct Local<const N: usize> {
    value: SVector<f64, N>,
    first: [SVector<f64, N>; 2],
}

impl<const N: usize> Search<'_, N> {
    /// Goes down from the best point so far, from the middle of a part, and from some points of its piece.
    pub(super) fn descend(&mut self, part: &Part) {
        self.patience = self.patience.saturating_mul(2);
        if self.sites.is_none() {
            self.descend_from(self.best.root, self.best.at);
            let root = part.root as usize;
            self.descend_from(root, part.sides.map(|(low, high)| low.midpoint(high)));
            for start in [[0.25, 0.25], [0.25, 0.75], [0.75, 0.25], [0.75, 0.75]] {
                self.descend_from(root, start);
            }
        }
    }

    /// Goes down within a piece.
    fn descend_from(&mut self, root: usize, mut at: [f64; 2]) {
        let pieces = &self.ground.pieces;
        let n = count(pieces.degrees);
        let own = root * n..(root + 1) * n;
        let weights = pieces.weights.get(own.clone()).unwrap_or(&[]);
        let weight = |k: usize| weights.get(k).copied().unwrap_or(1.0);
        let points: Vec<_> =
            pieces.points[own].iter().enumerate().map(|(k, c)| c - self.point * weight(k)).collect();
        let (mut room, mut weight_room) = (jet::Room::default(), jet::Room::default());
        let mut local = |at: [f64; 2]| {
            let lifted = room.jet(&points, pieces.degrees, at);
            if weights.is_empty() {
                return Local { value: lifted.value, first: lifted.first };
            }
            let weight = weight_room.jet(weights, pieces.degrees, at);
            let value = lifted.value / weight.value;
            Local { value, first: [0, 1].map(|i| (lifted.first[i] - value * weight.first[i]) / weight.value) }
        };
        let (mut here, mut damping) = (local(at), 1e-3);
        for _ in 0..STEPS {
            let next = here.step(at, damping);
            if next == at || damping > STIFF {
                break;
            }
            let there = local(next);
            if there.value.norm_squared() < here.value.norm_squared() {
                (here, at, damping) = (there, next, 0.1 * damping);
            } else {
                damping *= 8.0;
            }
        }
        let distance = here.value.norm();
        if distance < self.best.distance {
            self.best = Spot { root, at, distance };
            self.cut = distance - 0.5 * self.accuracy;
        }
    }
}

impl<const N: usize> Local<N> {
    /// The damped step from here, inside the square.
    fn step(&self, at: [f64; 2], damping: f64) -> [f64; 2] {
        let slopes = [0, 1].map(|i| self.value.dot(&self.first[i]));
        let free =
            [0, 1].map(|i| slopes[i] != 0.0 && if slopes[i] > 0.0 { at[i] > 0.0 } else { at[i] < 1.0 });
        let [uu, vv] = [0, 1].map(|i| self.first[i].norm_squared() * (1.0 + damping));
        let uv = self.first[0].dot(&self.first[1]);
        let (determinant, [g, h]) = (uu * vv - uv * uv, slopes);
        let step = if free == [true, true] && determinant > 0.0 {
            [(uv * h - vv * g) / determinant, (uv * g - uu * h) / determinant]
        } else {
            [-g / uu, -h / vv]
        };
        std::array::from_fn(|i| {
            let next = (at[i] + step[i]).clamp(0.0, 1.0);
            if free[i] && next.is_finite() { next } else { at[i] }
        })
    }
}
