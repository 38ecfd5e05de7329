//! Newton's method with a proof that there is one solution, and where.
//!
//! Let `m` be the point that Newton's method ends at, `Y` the inverse of the Jacobian there and `G = Y F`. On a box
//! with half-sides `ρ` about `m` let the entries of `G' - I`, scaled by the sides, have row sums of at most `e < 1`.
//! Then `x ↦ x - G(x)` takes the box into itself if `|G(m)| <= δ < (1 - e) ρ`, and shrinks distances: there is exactly
//! one solution in the box, and it is no farther from `m` than `δ / (1 - e)` (Krawczyk's test). Rounding counts: `δ` is
//! the value met and the noise of the system, and the half-sides are large enough to tell differences of coefficients
//! from noise.

use crate::analysis::meet::frame::{Coefficients, Kind, inverse};
use crate::analysis::meet::system::{Pair, Problem, System};

/// Steps of Newton's method at most.
const STEPS: usize = 24;

/// Half-sides of the box of the proof, as multiples of the error and of the sum of degrees and one.
const ROOM: f64 = 8.0;

/// A solution, proved.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Root {
    pub x: Pair,
    /// The solution is no farther from `x` than this, in each unknown.
    pub radius: Pair,
    /// It is the only one within this.
    pub reach: Pair,
}

/// The solution of the equations near `guess`, if Newton's method finds one that can be proved.
///
/// It may be a little outside of the square: the system counts as extended beyond.
pub(crate) fn certify<S: System>(problem: &Problem<S>, guess: Pair) -> Option<Root> {
    let x = newton(&problem.system, guess)?;
    let local = problem.system.at(x);
    let [a, b] = local.slopes;
    let rows = inverse(a, b)?;
    let error = |row: &Pair| {
        row[0].abs() * (local.value[0].abs() + problem.noise)
            + row[1].abs() * (local.value[1].abs() + problem.noise)
            + 2.0 * f64::EPSILON
    };
    let delta = [error(&rows[0]), error(&rows[1])];
    let degrees = problem.system.degrees();
    let room = ROOM * (degrees[0] + degrees[1] + 1) as f64;
    let reach = delta.map(|d| room * d);
    if reach.iter().any(|r| r.is_nan() || *r > 0.25) {
        return None;
    }
    let part =
        |axis: usize, system: &S| system.restricted(axis, x[axis] - reach[axis], x[axis] + reach[axis]);
    let near = part(1, &part(0, &problem.system));
    let mut coeffs = Vec::new();
    near.fill(&mut coeffs);
    let box_of = Coefficients { degrees, coeffs: &coeffs, noise: problem.noise };
    let frame = box_of.combined(Kind::Regular, rows);
    // Entry of G' - I with the unknowns in units of the half-sides; a difference of coefficients is off by the noise twice.
    let entry = |k: usize, axis: usize| {
        let [low, high] = frame.slope_range(k, axis).map(|slope| slope / (2.0 * reach[k]));
        let identity = f64::from(u8::from(k == axis));
        let rounded = degrees[axis] as f64 * frame.noise[k] / reach[k];
        (low - identity).abs().max((high - identity).abs()) + rounded
    };
    let e = (0..2).map(|k| entry(k, 0) + entry(k, 1)).fold(0.0, f64::max);
    (e < 0.5).then(|| Root { x, radius: delta.map(|d| d / (1.0 - e)), reach })
}

/// Where Newton's method comes to rest, if it stays near the square.
fn newton<S: System>(system: &S, guess: Pair) -> Option<Pair> {
    let mut x = guess;
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        let local = system.at(x);
        let [a, b] = local.slopes;
        let rows = inverse(a, b)?;
        let step = rows.map(|row| row[0] * local.value[0] + row[1] * local.value[1]);
        let size = step[0].abs().max(step[1].abs());
        if size.is_nan() || size > 1.0 {
            return None;
        }
        // At rest: steps are rounding and do not shrink any more.
        if size <= 1e-9 && size >= 0.5 * last {
            return Some(x);
        }
        last = size;
        x = [x[0] - step[0], x[1] - step[1]];
        if x.iter().any(|x| !(-0.25..=1.25).contains(x)) {
            return None;
        }
        if size <= 1e-16 {
            return Some(x);
        }
    }
    (last <= 1e-9).then_some(x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::meet::system::{Grid, rounding};

    /// `x - y² = 0`, `y - c x = 0`: two solutions, `(0, 0)` and `(1 / c², 1 / c)`.
    fn parabola(c: f64) -> Problem<Grid> {
        let y = [0.0, 0.5, 1.0];
        let coeff = |i: usize, j: usize| [i as f64 - f64::from(u8::from(j == 2)), y[j] - c * i as f64];
        let coeffs = (0..2).flat_map(|i| (0..3).map(move |j| coeff(i, j))).collect();
        let noise = rounding([1, 2], 1.0 + c);
        Problem { system: Grid { degrees: [1, 2], coeffs }, noise, speeds: [1.0; 2], weight: 1.0 }
    }

    #[test]
    fn simple_solutions_are_proved() {
        for (guess, expected) in [([0.1, 0.1], [0.0, 0.0]), ([0.3, 0.6], [0.25, 0.5])] {
            let root = certify(&parabola(2.0), guess).unwrap();
            assert!((0..2).all(|k| (root.x[k] - expected[k]).abs() <= root.radius[k]));
            assert!((0..2).all(|k| root.radius[k] < 1e-12 && root.reach[k] > 10.0 * root.radius[k]));
        }
    }

    #[test]
    fn a_double_solution_is_not_proved() {
        // The line y = (x + 1) / 2 touches x = y² at (1, 1).
        let mut touching = parabola(0.5);
        for (i, c) in touching.system.coeffs.iter_mut().enumerate() {
            c[1] = [0.0, 0.5, 1.0][i % 3] - 0.5 * (i / 3) as f64 - 0.5;
        }
        assert!(certify(&touching, [0.9, 0.9]).is_none());
        assert!(certify(&touching, [1.0, 1.0]).is_none());
    }

    #[test]
    fn nearly_double_solutions_are_proved_one_by_one() {
        // y = (x + 1 - h) / 2 meets x = y² at y = 1 ± √h: 1e-4 apart from 1.
        let mut near = parabola(0.5);
        for (i, c) in near.system.coeffs.iter_mut().enumerate() {
            c[1] = [0.0, 0.5, 1.0][i % 3] - 0.5 * (i / 3) as f64 - 0.5 * (1.0 - 1e-8);
        }
        let closer = |h: f64| {
            let mut closer = near.clone();
            closer.system.coeffs.iter_mut().for_each(|c| c[1] += 0.5 * (h - 1e-8));
            certify(&closer, [1.0 - 2.0 * h.sqrt(), 1.0 - h.sqrt()])
        };
        // Too near to each other to prove that it is one.
        assert!(closer(1e-10).is_some() && closer(1e-13).is_none());
        let root = certify(&near, [0.9998, 0.9999]).unwrap();
        assert!((root.x[1] - 0.9999).abs() <= root.radius[1]);
        assert!(root.reach[1] < 1e-4);
    }
}
