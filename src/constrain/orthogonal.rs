//! Rows made orthogonal one after the other, in the inner product `r W^-1 s`.
//!
//! The method of Gram and Schmidt, without square roots: over an exact field it is exact. Elsewhere each row is taken
//! apart twice, which leaves it orthogonal up to rounding, and what is left of a dependent row is seen to be rounding.
//! There `r W^-1 s` and `s W^-1 r` differ by rounding, which counts where little of a row is left. So a row and its change
//! are each made orthogonal to the changes and rows before: a step then alters no condition that was met. With a diagonal
//! `W` the change of what is left is known, and only rows are taken apart.

use crate::ops::bound::epsilon;
use crate::scalar::Scalar;
use std::ops::Range;

/// A row, orthogonal to those before it.
#[derive(Clone, Debug)]
pub(crate) struct Step<T> {
    /// `r`.
    pub row: Vec<T>,
    /// `W^-1 r`, the change of coefficients that `r` asks for.
    pub change: Vec<T>,
    /// `r W^-1 r`.
    pub square: T,
    /// Row and change vanish outside.
    window: Range<usize>,
}

/// What a row asks for.
#[derive(Clone, Debug)]
pub(crate) enum Change<'a, T> {
    /// `W^-1 r`.
    Given(Vec<T>),
    /// The diagonal of `W^-1`.
    Diagonal(&'a [T]),
}

/// A row as a combination of orthogonal ones and a rest.
#[derive(Clone, Debug)]
pub(crate) struct Split<T> {
    /// How much of each orthogonal row there is.
    pub shares: Vec<T>,
    /// What is left, unless the row depends on the others.
    pub rest: Option<Step<T>>,
}

/// Takes a row and its change apart.
pub(crate) fn split<T: Scalar>(steps: &[Step<T>], row: &[T], change: Change<'_, T>) -> Split<T> {
    let (mut row, mut change) = (row.to_vec(), change);
    let mut window = nonzero(&row);
    if let Change::Given(given) = &change {
        window = hull(&window, &nonzero(given));
    }
    let applied = |row: &[T], change: &Change<'_, T>| match change {
        Change::Given(change) => change.clone(),
        Change::Diagonal(inverse) => row.iter().zip(*inverse).map(|(r, w)| r.clone() * w).collect(),
    };
    let size = dot(&row, &applied(&row, &change), &window);
    let mut shares = vec![T::zero(); steps.len()];
    for _ in 0..if T::EXACT { 1 } else { 2 } {
        for (share, step) in shares.iter_mut().zip(steps) {
            let common = window.start.max(step.window.start)..window.end.min(step.window.end);
            if common.is_empty() {
                continue;
            }
            let part = dot(&row, &step.change, &common) / &step.square;
            if part.is_zero() {
                continue;
            }
            subtract(&mut row, &part, &step.row, &step.window);
            if let Change::Given(change) = &mut change {
                let part =
                    if T::EXACT { part.clone() } else { dot(change, &step.row, &common) / &step.square };
                subtract(change, &part, &step.change, &step.window);
            }
            window = hull(&window, &step.window);
            *share += part;
        }
    }
    let change = applied(&row, &change);
    let square = dot(&row, &change, &window);
    let noise = if T::EXACT { T::zero() } else { epsilon::<T>() * T::int(1 << 10) };
    let rest = (square > noise.clone() * noise * size).then_some(Step { row, change, square, window });
    Split { shares, rest }
}

/// From the first to the last entry that is not zero.
fn nonzero<T: Scalar>(row: &[T]) -> Range<usize> {
    let first = row.iter().position(|x| !x.is_zero());
    let last = row.iter().rposition(|x| !x.is_zero());
    first.zip(last).map_or(0..0, |(first, last)| first..last + 1)
}

fn hull(a: &Range<usize>, b: &Range<usize>) -> Range<usize> {
    match (a.is_empty(), b.is_empty()) {
        (true, _) => b.clone(),
        (_, true) => a.clone(),
        _ => a.start.min(b.start)..a.end.max(b.end),
    }
}

fn dot<T: Scalar>(a: &[T], b: &[T], window: &Range<usize>) -> T {
    T::dot(a[window.clone()].iter().zip(&b[window.clone()]))
}

fn subtract<T: Scalar>(from: &mut [T], weight: &T, row: &[T], window: &Range<usize>) {
    let (from, row) = (&mut from[window.clone()], &row[window.clone()]);
    from.iter_mut().zip(row).for_each(|(x, y)| *x -= weight.clone() * y);
}
