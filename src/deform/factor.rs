//! A sum of squares of short rows, factored.
//!
//! ```text
//! Σ w a aᵀ = Rᵀ D R        R unit upper triangular, banded
//! ```
//! Rows are rotated in one by one, without square roots [Gentleman], so the matrix on the left is never formed. Over an exact
//! field that is elimination. Over floats it keeps twice the digits: a chain of `n` links that resists bending has a stiffness
//! matrix of condition `n⁴`, its rows have `n²`.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::limits::check_entries;
use crate::ops::bound::epsilon;
use crate::scalar::Scalar;

/// A sum of squares that grows.
#[derive(Debug)]
pub(crate) struct Squares<T> {
    factor: Factor<T>,
    /// The diagonal of the sum.
    diagonal: Vec<T>,
    /// Zero but while a row is rotated in.
    row: Vec<T>,
}

/// The factors of a sum of squares.
#[derive(Clone, Debug)]
pub(crate) struct Factor<T> {
    /// How many entries a row of `R` has, the one on the diagonal included.
    width: usize,
    /// Row by row without the diagonal, `width - 1` entries each.
    upper: Vec<T>,
    pivots: Vec<T>,
}

impl<T: Scalar> Squares<T> {
    /// Nothing, in `count` unknowns; no row will reach farther than `width`.
    ///
    /// # Errors
    /// [`Error::TooLarge`](crate::Error::TooLarge).
    pub(crate) fn new(count: usize, width: usize) -> Result<Self> {
        let width = width.clamp(1, count.max(1));
        check_entries(count, width)?;
        let zeros = |length: usize| vec![T::zero(); length];
        let factor = Factor { width, upper: zeros(count * (width - 1)), pivots: zeros(count) };
        Ok(Self { factor, diagonal: zeros(count), row: zeros(count) })
    }

    /// Adds the square `weight (Σ a x)²`; indices may stand several times.
    ///
    /// Rows that come about in the order of their first unknown meet no pivot far behind their own: then the time for each does
    /// not depend on the number of unknowns.
    pub(crate) fn push(&mut self, terms: impl Iterator<Item = (usize, T)>, weight: &T) {
        let (mut first, mut reach) = (self.row.len(), 0);
        for (i, x) in terms {
            // In a small ring terms cancel: what is left counts beside them.
            self.diagonal[i] += x.clone() * &x * weight;
            self.row[i] += x;
            (first, reach) = (first.min(i), reach.max(i + 1));
        }
        self.factor.rotate_in(&mut self.row, first, reach, weight.clone());
    }

    /// The factors, and the unknowns without a pivot: as many as the dimension of the null space.
    pub(crate) fn factored(self) -> (Factor<T>, Vec<usize>) {
        let (count, width) = (self.row.len(), self.factor.width);
        let noise = noise::<T>(count + width * width);
        let least = noise.clone() * noise;
        let holds = |k: &usize| self.factor.pivots[*k] > least.clone() * &self.diagonal[*k];
        let loose = (0..count).filter(|k| !holds(k)).collect();
        (self.factor, loose)
    }
}

impl<T: Scalar> Factor<T> {
    /// The factors of a symmetric matrix without negative eigenvalues; row `k` of the band has its entries from the diagonal
    /// on, `width` of them.
    ///
    /// If there is a null space, the unknowns without a pivot are returned: as many as its dimension.
    pub(crate) fn of_band(width: usize, mut band: Vec<T>) -> std::result::Result<Self, Vec<usize>> {
        let count = band.len() / width;
        let noise = noise::<T>(count);
        let least: Vec<T> = band.iter().step_by(width).map(|x| noise.clone() * x).collect();
        let (mut pivots, mut loose) = (Vec::with_capacity(count), Vec::new());
        for (k, least) in least.iter().enumerate() {
            let (own, below) = band[k * width..].split_at_mut(width);
            let pivot = own[0].clone();
            pivots.push(pivot.clone());
            let holds = pivot > *least;
            if !holds {
                loose.push(k);
                continue;
            }
            for (i, row) in below.chunks_exact_mut(width).take(width - 1).enumerate() {
                if own[i + 1].is_zero() {
                    continue;
                }
                let factor = own[i + 1].clone() / &pivot;
                row.iter_mut().zip(&own[i + 1..]).for_each(|(x, y)| *x -= factor.clone() * y);
            }
            own[1..].iter_mut().for_each(|x| *x /= &pivot);
        }
        if !loose.is_empty() {
            return Err(loose);
        }
        let mut index = 0..;
        band.retain(|_| index.next().is_some_and(|i: usize| !i.is_multiple_of(width)));
        Ok(Self { width, upper: band, pivots })
    }

    /// Adds the square of a row, which has entries from `first` to `reach` and is zero afterwards.
    fn rotate_in(&mut self, row: &mut [T], first: usize, mut reach: usize, mut weight: T) {
        let count = self.pivots.len();
        let mut k = first;
        while k < reach {
            let x = std::mem::replace(&mut row[k], T::zero());
            if x.is_zero() {
                k += 1;
                continue;
            }
            let end = (k + self.width).min(count);
            let own = &mut self.upper[k * (self.width - 1)..][..end - k - 1];
            if self.pivots[k].is_zero() {
                self.pivots[k] = x.clone() * &x * &weight;
                for (entry, y) in own.iter_mut().zip(&mut row[k + 1..reach]) {
                    *entry = std::mem::replace(y, T::zero()) / &x;
                }
                return;
            }
            let scaled = weight.clone() * &x;
            let pivot = self.pivots[k].clone() + scaled.clone() * &x;
            let (kept, new) = (self.pivots[k].clone() / &pivot, scaled / &pivot);
            weight *= &kept;
            self.pivots[k] = pivot;
            for (entry, y) in own.iter_mut().zip(&mut row[k + 1..end]) {
                let before = y.clone();
                *y -= x.clone() * &*entry;
                *entry = kept.clone() * &*entry + new.clone() * before;
            }
            reach = end.max(reach);
            k += 1;
        }
    }

    /// Row `k` of `R` after the diagonal.
    fn row(&self, k: usize) -> &[T] {
        let length = (self.width - 1).min(self.pivots.len() - k - 1);
        &self.upper[k * (self.width - 1)..][..length]
    }

    /// A basis of the null space, a vector for each of the unknowns without a pivot: `R x = 0` in the other rows.
    pub(crate) fn null_space(&self, loose: &[usize]) -> Vec<Vec<T>> {
        let count = self.pivots.len();
        let mut free = vec![false; count];
        loose.iter().for_each(|k| free[*k] = true);
        let vector = |own: &usize| {
            let mut x = vec![T::zero(); count];
            x[*own] = T::one();
            for k in (0..*own).rev().filter(|k| !free[*k]) {
                x[k] = -T::dot(self.row(k).iter().zip(&x[k + 1..]));
            }
            x
        };
        loose.iter().map(vector).collect()
    }

    /// Solves with `columns` right-hand sides at once, unknown `k` of column `j` at `k * columns + j`.
    pub(crate) fn solve<C: Coeff<T>>(&self, values: &mut [C], columns: usize) {
        let count = self.pivots.len();
        for k in 0..count {
            let (done, rest) = values.split_at_mut((k + 1) * columns);
            let own = &mut done[k * columns..];
            if own.iter().all(faded) {
                own.iter_mut().for_each(|x| *x = x.zero_like());
                continue;
            }
            for (entry, other) in self.row(k).iter().zip(rest.chunks_exact_mut(columns)) {
                let factor = -entry.clone();
                other.iter_mut().zip(&*own).for_each(|(y, x)| y.add_scaled(&factor, x));
            }
        }
        for k in (0..count).rev() {
            let (own, known) = values.split_at_mut((k + 1) * columns);
            let own = &mut own[k * columns..];
            own.iter_mut().for_each(|x| x.divide(&self.pivots[k]));
            for (entry, other) in self.row(k).iter().zip(known.chunks_exact(columns)) {
                let factor = -entry.clone();
                own.iter_mut().zip(other).for_each(|(x, y)| x.add_scaled(&factor, y));
            }
            if own.iter().all(faded) {
                own.iter_mut().for_each(|x| *x = x.zero_like());
            }
        }
    }
}

/// Up to this share of the diagonal a pivot of `count` is rounding.
fn noise<T: Scalar>(count: usize) -> T {
    if T::EXACT { T::zero() } else { epsilon::<T>() * T::int(16 * count as i64) }
}

/// Whether it is zero, or has lost its digits to the end of the range, where a response that dies away would stay and take long.
fn faded<T: Scalar, C: Coeff<T>>(x: &C) -> bool {
    x.components().all(|x| x.is_zero() || (!T::EXACT && (x.clone() * epsilon::<T>()).is_zero()))
}
