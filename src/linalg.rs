//! Elimination over a field, for the banded systems of spline fitting, periodic ones included.
//!
//! A row is a short run of entries plus a **border**: the last few columns, kept apart. A periodic collocation
//! matrix is banded but for its corners, and with the corners in the border it is banded altogether. Each column is
//! eliminated with row exchanges among the rows that start there, so the cost is linear in the number of unknowns.
//!
//! Over a field with whole numbers a row, its right-hand side included, is kept whole and without a common factor
//! ([`Scalar::primitive`]): elimination multiplies crosswise, and the only fractions are those of the solution.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::scalar::{Scalar, larger};
use std::collections::VecDeque;

/// A square banded system with a border, rows sorted by the column where their run starts.
#[derive(Debug)]
pub(crate) struct BandedSystem<T, C> {
    unknowns: usize,
    border: usize,
    rows: Vec<Row<T, C>>,
}

/// `Σ run[k] x[first + k] + Σ border[k] x[unknowns - border + k] = right`.
#[derive(Clone, Debug)]
struct Row<T, C> {
    index: usize,
    first: usize,
    run: Vec<T>,
    border: Vec<T>,
    right: C,
}

impl<T: Scalar, C: Coeff<T>> BandedSystem<T, C> {
    /// A system without rows; the last `border` unknowns are the border.
    pub(crate) fn new(unknowns: usize, border: usize) -> Self {
        Self { unknowns, border: border.min(unknowns), rows: Vec::with_capacity(unknowns) }
    }

    /// Adds the row `Σ weights[k] x[(first + k) mod unknowns] = right`.
    pub(crate) fn push(&mut self, first: usize, weights: &[T], right: C) {
        let inside = self.unknowns - self.border;
        let mut border = vec![T::zero(); self.border];
        // Room for what elimination fills in.
        let mut run = Vec::with_capacity(2 * weights.len());
        if first < inside && weights.len() <= inside - first {
            run.extend_from_slice(weights);
            self.rows.push(Row { index: self.rows.len(), first, run, border, right });
            return;
        }
        let mut entries: Vec<(usize, &T)> = Vec::with_capacity(weights.len());
        for (k, w) in weights.iter().enumerate() {
            match (first + k) % self.unknowns {
                column if column >= inside => border[column - inside] += w,
                column => entries.push((column, w)),
            }
        }
        let low = entries.iter().map(|e| e.0).min().unwrap_or(inside);
        let width = entries.iter().map(|e| e.0 + 1 - low).max().unwrap_or(0);
        run.resize(width, T::zero());
        entries.into_iter().for_each(|(column, w)| run[column - low] += w);
        self.rows.push(Row { index: self.rows.len(), first: low, run, border, right });
    }

    /// The solution.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there are as many rows as unknowns; [`Error::Singular`].
    pub(crate) fn solve(mut self) -> Result<Vec<C>> {
        if self.rows.len() != self.unknowns {
            return Err(Error::CoefficientCount { expected: self.unknowns, found: self.rows.len() });
        }
        let inside = self.unknowns - self.border;
        let noise = self.noise();
        self.rows.sort_by_key(|row| row.first);
        self.rows.iter_mut().for_each(Row::make_primitive);
        let mut waiting = VecDeque::from(std::mem::take(&mut self.rows));
        let mut active: Vec<Row<T, C>> = Vec::new();
        let mut done: Vec<Row<T, C>> = Vec::with_capacity(self.unknowns);
        for column in 0..inside {
            while waiting.front().is_some_and(|row| row.first <= column) {
                active.extend(waiting.pop_front());
            }
            let pivot = take_pivot(&mut active, &noise, |row| row.entry(column));
            let pivot = pivot.ok_or_else(|| singular(active.first().or(waiting.front()), column))?;
            active.iter_mut().for_each(|row| row.eliminate(&pivot, column));
            done.push(pivot);
        }
        active.extend(waiting);
        for k in 0..self.border {
            let pivot = take_pivot(&mut active, &noise, |row| Some(&row.border[k]));
            let pivot = pivot.ok_or_else(|| singular(active.first(), inside + k))?;
            active.iter_mut().for_each(|row| row.eliminate_border(&pivot, k));
            done.push(pivot);
        }
        self.substitute(done)
    }

    /// Below this size a pivot is rounding: of systems with a border, which may be singular without any zero.
    ///
    /// Collocation matrices without one are totally positive, and small pivots mean what they say.
    fn noise(&self) -> T {
        if T::EXACT || self.border == 0 {
            return T::zero();
        }
        let entries = self.rows.iter().flat_map(|row| row.run.iter().chain(&row.border)).map(T::magnitude);
        let largest = entries.fold(T::zero(), larger);
        largest * T::frac(self.unknowns as i64, 1 << 50)
    }

    /// Solves the triangular system of pivot rows from the last to the first.
    fn substitute(&self, pivots: Vec<Row<T, C>>) -> Result<Vec<C>> {
        let inside = self.unknowns - self.border;
        // Solutions in reverse order: unknown j is at place unknowns - 1 - j.
        let mut reversed: Vec<C> = Vec::with_capacity(self.unknowns);
        for (column, row) in pivots.into_iter().enumerate().rev() {
            let (entries, after, own) = match column.checked_sub(inside) {
                None => (&row.run[column + 1 - row.first..], column + 1, row.entry(column)),
                Some(k) => (&row.border[k + 1..], column + 1, Some(&row.border[k])),
            };
            let border = if column < inside { &row.border[..] } else { &[] };
            let pivot = own.expect("a pivot row has an entry in its column");
            // A pivot beyond the range would divide its row to zero.
            if !pivot.is_finite() {
                return Err(Error::Singular { row: row.index });
            }
            let known = (after..).zip(entries).chain((inside..).zip(border));
            let known = known.map(|(j, weight)| (weight, &reversed[self.unknowns - 1 - j]));
            let mut rest = row.right.clone();
            if T::EXACT {
                let sum = C::combine(known).map(|sum| rest.minus(&sum));
                rest = sum.unwrap_or(rest);
                rest.divide(pivot);
            } else {
                known.for_each(|(weight, c)| rest.add_scaled(&-weight.clone(), c));
                rest.scale(&(T::one() / pivot));
            }
            if !rest.all_finite() {
                return Err(Error::Singular { row: row.index });
            }
            reversed.push(rest);
        }
        reversed.reverse();
        Ok(reversed)
    }
}

impl<T: Scalar, C: Coeff<T>> Row<T, C> {
    fn entry(&self, column: usize) -> Option<&T> {
        column.checked_sub(self.first).and_then(|k| self.run.get(k))
    }

    /// Makes the entry in `column` zero by a multiple of `pivot`.
    fn eliminate(&mut self, pivot: &Self, column: usize) {
        let Some(entry) = self.entry(column).filter(|e| !e.is_zero()) else { return };
        let divisor = pivot.entry(column).expect("a pivot row has an entry in its column");
        if let Some((own, other)) = whole_factors(entry, divisor) {
            self.combine_whole(pivot, &own, &other);
            self.run[column - self.first] = T::zero();
            return self.make_primitive();
        }
        let factor = -(entry.clone() / divisor);
        let reach = (pivot.first + pivot.run.len()).max(self.first + self.run.len());
        self.run.resize(reach - self.first, T::zero());
        for j in column..pivot.first + pivot.run.len() {
            self.run[j - self.first] += factor.clone() * &pivot.run[j - pivot.first];
        }
        self.run[column - self.first] = T::zero();
        self.combine_rest(pivot, &factor);
    }

    /// Makes border entry `k` zero by a multiple of `pivot`.
    fn eliminate_border(&mut self, pivot: &Self, k: usize) {
        if self.border[k].is_zero() {
            return;
        }
        if let Some((own, other)) = whole_factors(&self.border[k], &pivot.border[k]) {
            self.combine_whole(pivot, &own, &other);
            self.border[k] = T::zero();
            return self.make_primitive();
        }
        let factor = -(self.border[k].clone() / &pivot.border[k]);
        self.combine_rest(pivot, &factor);
        self.border[k] = T::zero();
    }

    /// Becomes `own` times itself plus `other` times `pivot`.
    fn combine_whole(&mut self, pivot: &Self, own: &T, other: &T) {
        let reach = (pivot.first + pivot.run.len()).max(self.first + self.run.len());
        self.run.resize(reach - self.first, T::zero());
        self.run.iter_mut().filter(|x| !x.is_zero()).for_each(|x| *x *= own);
        for (j, y) in (pivot.first..).zip(&pivot.run).filter(|(_, y)| !y.is_zero()) {
            self.run[j - self.first] += other.clone() * y;
        }
        for (x, y) in self.border.iter_mut().zip(&pivot.border) {
            *x = T::dot([(own, &*x), (other, y)].into_iter());
        }
        let right = C::combine([(own, &self.right), (other, &pivot.right)].into_iter());
        self.right = right.expect("two terms");
    }

    /// Over a field with whole numbers, makes those of the row whole and without a common factor.
    fn make_primitive(&mut self) {
        let entries = self.run.iter().chain(&self.border).chain(self.right.components());
        let Some(factor) = T::primitive(entries).filter(|factor| !factor.is_one()) else { return };
        self.run.iter_mut().chain(&mut self.border).filter(|x| !x.is_zero()).for_each(|x| *x *= &factor);
        self.right.scale(&factor);
    }

    fn combine_rest(&mut self, pivot: &Self, factor: &T) {
        self.border.iter_mut().zip(&pivot.border).for_each(|(mine, theirs)| *mine += factor.clone() * theirs);
        self.right.add_scaled(factor, &pivot.right);
    }
}

/// Whole numbers `a` and `b` without a common factor for which `a entry + b pivot = 0`, if the field has such numbers.
fn whole_factors<T: Scalar>(entry: &T, pivot: &T) -> Option<(T, T)> {
    let factor = T::primitive([entry, pivot].into_iter())?;
    Some((pivot.clone() * &factor, -(entry.clone() * factor)))
}

/// Removes the row with the largest entry above `noise`; over an exact field the first that is not zero.
fn take_pivot<T: Scalar, C>(
    rows: &mut Vec<Row<T, C>>,
    noise: &T,
    entry: impl Fn(&Row<T, C>) -> Option<&T>,
) -> Option<Row<T, C>> {
    let sizes = rows.iter().enumerate().filter_map(|(i, row)| Some((i, entry(row)?.magnitude())));
    let mut nonzero = sizes.filter(|(_, size)| size > noise);
    let chosen = if T::EXACT {
        nonzero.next()
    } else {
        nonzero.reduce(|best, next| if next.1 > best.1 { next } else { best })
    };
    chosen.map(|(i, _)| rows.swap_remove(i))
}

fn singular<T, C>(row: Option<&Row<T, C>>, column: usize) -> Error {
    Error::Singular { row: row.map_or(column, |row| row.index) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dense::solve_dense;
    use crate::exact::Q;
    use nalgebra::{DMatrix, SVector};
    use proptest::collection::vec;
    use proptest::prelude::*;

    fn number() -> impl Strategy<Value = Q> {
        let few = (-3..=3i64, 1..=4i64).prop_map(|(p, q)| Q::frac(p, q));
        let image = (-9.0..9.0f64).prop_map(|x| Q::try_from(x).unwrap());
        prop_oneof![3 => few, 2 => image]
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn banded_systems_are_systems(
            n in 1..=7_usize, border in 0..=3_usize, firsts in vec(0..7_usize, 7), weights in vec(number(), 28), right in vec(number(), 14)
        ) {
            let mut system = BandedSystem::<Q, SVector<Q, 2>>::new(n, border);
            let mut matrix = DMatrix::from_element(n, n, Q::int(0));
            let sides = DMatrix::from_fn(n, 2, |i, j| right[2 * i + j].clone());
            for i in 0..n {
                let (first, run) = (if firsts[i] < 5 { i } else { firsts[i] }, &weights[4 * i..4 * i + 1 + firsts[i] % 4]);
                system.push(first, run, SVector::from([sides[(i, 0)].clone(), sides[(i, 1)].clone()]));
                run.iter().enumerate().for_each(|(k, w)| matrix[(i, (first + k) % n)] += w);
            }
            match (system.solve(), solve_dense(&matrix, &sides)) {
                (Ok(x), Ok(expected)) => prop_assert!((0..n).all(|i| x[i][0] == expected[(i, 0)] && x[i][1] == expected[(i, 1)])),
                (found, expected) => prop_assert!(found.is_err() && expected.is_err()),
            }
        }
    }

    #[test]
    fn solves_a_cyclic_system_with_row_exchanges() {
        // x_i + 2 x_{i+1} = i on a ring of five: the corner is in the border.
        let mut system = BandedSystem::<f64, f64>::new(5, 1);
        (0..5).for_each(|i| system.push(i, &[1.0, 2.0], i as f64));
        let x = system.solve().unwrap();
        for i in 0..5 {
            assert!((x[i] + 2.0 * x[(i + 1) % 5] - i as f64).abs() < 1e-14);
        }
    }

    #[test]
    fn singular_systems_are_refused() {
        let mut system = BandedSystem::<f64, f64>::new(2, 0);
        system.push(0, &[1.0, 1.0], 1.0);
        system.push(0, &[2.0, 2.0], 2.0);
        assert!(matches!(system.solve(), Err(Error::Singular { .. })));
    }
}
