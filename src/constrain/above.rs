//! The nearest coefficients that meet conditions and keep above a floor.
//!
//! ```text
//! |c' - c|_W least,   R c' = t,   b_i c' >= floor for every row b_i
//! ```
//! A dual active set method [GI]: start at the least change for the equations; take the most violated row, and move along
//! what it asks for beyond the rows held so far, until it is met or the multiplier of a held row vanishes, which then goes.
//! Every step raises the distance, so the method ends; where a violated row asks for nothing beyond the others, and none
//! can go, no coefficients meet all. Only additions, multiplications and divisions: exact over an exact field.

use crate::constrain::change::LeastChange;
use crate::constrain::norm::{CoeffSpace, Norm};
use crate::constrain::orthogonal::{Change, Split, Step, split};
use crate::error::{Error, Result};
use crate::functional::{Functional, weigh};
use crate::limits::check_entries;
use crate::map::LinearMap;
use crate::scalar::{Scalar, larger};

/// What a search came to.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Above<T> {
    /// The nearest coefficients.
    Nearest(Vec<T>),
    /// No coefficients meet the conditions.
    None,
}

/// The rows that are held at the floor.
struct Held<T> {
    /// Their indices.
    rows: Vec<usize>,
    multipliers: Vec<T>,
    /// The shares of each in the steps before its own.
    shares: Vec<Vec<T>>,
    /// The steps of the equations, then those of the rows.
    steps: Vec<Step<T>>,
    equations: usize,
}

impl<T: Scalar> Held<T> {
    fn push(&mut self, row: usize, multiplier: T, shares: Vec<T>, step: Step<T>) {
        self.rows.push(row);
        self.multipliers.push(multiplier);
        self.shares.push(shares);
        self.steps.push(step);
    }

    /// How a row is made of the held ones, beside the equations and its rest.
    fn combination(&self, shares: &[T]) -> Vec<T> {
        let mut weights = shares[self.equations..].to_vec();
        for l in (0..weights.len()).rev() {
            let weight = weights[l].clone();
            for (k, share) in self.shares[l][self.equations..].iter().enumerate() {
                weights[k] -= weight.clone() * share;
            }
        }
        weights
    }

    /// Lets the row with index `k` among the held ones go.
    fn release(&mut self, k: usize, taken_apart: impl Fn(usize, &[Step<T>]) -> Split<T>) {
        let rows = self.rows.split_off(k);
        let multipliers = self.multipliers.split_off(k);
        self.shares.truncate(k);
        self.steps.truncate(self.equations + k);
        for (row, multiplier) in rows.into_iter().zip(multipliers).skip(1) {
            let Split { shares, rest } = taken_apart(row, &self.steps);
            // It did not depend on more rows than these.
            if let Some(step) = rest {
                self.push(row, multiplier, shares, step);
            }
        }
    }
}

/// The coefficients nearest to `wanted` that meet the conditions of `change` with the values `targets`, with every row of
/// `rows` at least `floor`.
///
/// # Errors
/// Those of [`LeastChange::edit`]; [`Error::TooLarge`]; [`Error::Undecided`] if in floating point it does not end.
pub(crate) fn nearest_above<T: Scalar, S: CoeffSpace<T> + Clone>(
    change: &LeastChange<T, S>,
    targets: &[T],
    wanted: &[T],
    (rows, floor): (&LinearMap<T>, &T),
    norm: Norm,
) -> Result<Above<T>> {
    let n = wanted.len();
    check_entries(rows.target_dim(), n)?;
    let dense: Vec<Vec<T>> =
        rows.rows().map(|(first, weights)| Functional::new(first, weights).to_dense(n)).collect();
    let changes = norm.changes(change.space(), &dense)?;
    let taken_apart =
        |i: usize, steps: &[Step<T>]| split(steps, &dense[i], Change::Given(changes[i].clone()));
    let size = wanted.iter().map(T::magnitude).fold(floor.magnitude(), larger);
    let noise = if T::EXACT { T::zero() } else { size * T::frac(1, 1 << 40) };

    let mut x = wanted.to_vec();
    change.edit(&mut x, targets)?;
    let slack = |i: usize, x: &[T]| {
        let (first, weights) = rows.row(i);
        weigh(first, weights, x) - floor
    };
    let steps = change.steps().to_vec();
    let mut held =
        Held { rows: Vec::new(), multipliers: Vec::new(), shares: Vec::new(), equations: steps.len(), steps };
    for _ in 0..20 * (dense.len() + 10) {
        let violated = (0..dense.len()).filter(|i| !held.rows.contains(i)).map(|i| (slack(i, &x), i));
        let worst = violated.reduce(|worst, other| if other.0 < worst.0 { other } else { worst });
        let Some((mut missing, p)) = worst.filter(|(slack, _)| *slack < -noise.clone()) else {
            return Ok(Above::Nearest(x));
        };
        let mut multiplier = T::zero();
        loop {
            let Split { shares, rest } = taken_apart(p, &held.steps);
            let weights = held.combination(&shares);
            // The held row whose multiplier vanishes first.
            let ratio = |k: usize| held.multipliers[k].clone() / &weights[k];
            let limits = (0..weights.len()).filter(|&k| weights[k] > T::zero()).map(|k| (ratio(k), k));
            let first = limits.reduce(|first, other| if other.0 < first.0 { other } else { first });
            let full = rest.as_ref().map(|step| -missing.clone() / &step.square);
            let (length, released) = match (first, full) {
                (None, None) => return Ok(Above::None),
                (Some((limit, k)), Some(full)) if limit < full => (limit, Some(k)),
                (_, Some(full)) => (full, None),
                (Some((limit, k)), None) => (limit, Some(k)),
            };
            if let Some(step) = &rest {
                x.iter_mut().zip(&step.change).for_each(|(x, z)| *x += length.clone() * z);
            }
            for (u, weight) in held.multipliers.iter_mut().zip(&weights) {
                *u -= length.clone() * weight;
            }
            multiplier += &length;
            match (released, rest) {
                (None, Some(step)) => {
                    held.push(p, multiplier, shares, step);
                    break;
                }
                (Some(k), _) => held.release(k, taken_apart),
                (None, None) => return Err(Error::Undecided),
            }
            missing = slack(p, &x);
        }
    }
    Err(Error::Undecided)
}
