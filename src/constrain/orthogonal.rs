//! Rows made orthogonal one after the other, in the inner product `r W^-1 s`.
//!
//! The method of Gram and Schmidt, without square roots: over an exact field it is exact. Elsewhere each row is taken
//! apart twice, which leaves it orthogonal up to rounding, and what is left of a dependent row is seen to be rounding.
//! There `r W^-1 s` and `s W^-1 r` differ by rounding, which counts where little of a row is left. So a row and its change
//! are each made orthogonal to the changes and rows before: a step then alters no condition that was met.

use crate::ops::bound::epsilon;
use crate::scalar::Scalar;

/// A row, orthogonal to those before it.
#[derive(Clone, Debug)]
pub(crate) struct Step<T> {
    /// `r`.
    pub row: Vec<T>,
    /// `W^-1 r`, the change of coefficients that `r` asks for.
    pub change: Vec<T>,
    /// `r W^-1 r`.
    pub square: T,
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
pub(crate) fn split<T: Scalar>(steps: &[Step<T>], row: &[T], change: &[T]) -> Split<T> {
    let (mut row, mut change) = (row.to_vec(), change.to_vec());
    let size = T::dot(row.iter().zip(&change));
    let mut shares = vec![T::zero(); steps.len()];
    for _ in 0..if T::EXACT { 1 } else { 2 } {
        for (share, step) in shares.iter_mut().zip(steps) {
            let part = T::dot(row.iter().zip(&step.change)) / &step.square;
            subtract(&mut row, &part, &step.row);
            let part_of_change =
                if T::EXACT { part.clone() } else { T::dot(change.iter().zip(&step.row)) / &step.square };
            subtract(&mut change, &part_of_change, &step.change);
            *share += part;
        }
    }
    let square = T::dot(row.iter().zip(&change));
    let noise = if T::EXACT { T::zero() } else { epsilon::<T>() * T::int(1 << 10) };
    let rest = (square > noise.clone() * noise * size).then_some(Step { row, change, square });
    Split { shares, rest }
}

fn subtract<T: Scalar>(from: &mut [T], weight: &T, row: &[T]) {
    if weight.is_zero() {
        return;
    }
    from.iter_mut().zip(row).for_each(|(x, y)| *x -= weight.clone() * y);
}
