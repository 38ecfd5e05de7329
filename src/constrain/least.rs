//! The least movement that meets conditions, as a matrix.
//!
//! ```text
//! d = A b      A = W^-1 F^T (F W^-1 F^T)^-1      F d = b,  Σ w_i |d_i|² least
//! ```
//! [NURBS, (11.72) to (11.77); FB (1) to (5)]. For one, two and three conditions the inverse is written down [FB (6)]; for more,
//! and where that would lose half of the digits, the rows are made orthogonal: `F = L S`, so `A = W^-1 S^T (S W^-1 S^T)^-1 L^-1`.
//! Only coefficients that some row weighs are looked at: what it takes does not depend on how many there are.

use crate::constrain::orthogonal::{Change, Split, Step, split};
use crate::constrain::sparse::SparseRow;
use crate::dense::solve_dense;
use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::limits::check_entries;
use crate::scalar::{Scalar, larger};
use nalgebra::DMatrix;

/// What happens with conditions that cannot be met together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Excess {
    /// They are refused, and named.
    #[default]
    Refused,
    /// They are met as nearly as possible, `Σ |F d - b|²` least, and among those ways by the least movement.
    LeastSquares,
}

/// The matrix `A`, one row of as many entries as there are conditions for each index.
pub(crate) type Moves<T> = (Vec<usize>, Vec<T>);

/// The least movement that gives `rows` the values asked for, when coefficient `i` moves at the price `price(i)`.
///
/// # Errors
/// [`ShapeError::Overdetermined`], [`ShapeError::Dependent`] unless `excess` allows them; [`ShapeError::MovementWeight`];
/// [`Error::CoefficientCount`] without conditions, [`Error::NotFinite`], [`Error::TooLarge`].
pub(crate) fn least_moves<T: Scalar>(
    rows: &[SparseRow<T>],
    price: impl Fn(usize) -> T,
    excess: Excess,
) -> Result<Moves<T>> {
    if rows.is_empty() {
        return Err(Error::CoefficientCount { expected: 1, found: 0 });
    }
    let mut indices: Vec<usize> = rows.iter().flat_map(|row| row.terms().iter().map(|(i, _)| *i)).collect();
    indices.sort_unstable();
    indices.dedup();
    check_entries(rows.len(), indices.len())?;
    if let Some(index) = rows.iter().position(|row| !row.terms().iter().all(|(_, w)| w.is_finite())) {
        return Err(Error::NotFinite { what: "condition", index });
    }
    let mut inverse = Vec::with_capacity(indices.len());
    for index in &indices {
        let price = price(*index);
        if !(price > T::zero() && price.is_finite()) {
            let weight = price.to_string();
            return Err(ShapeError::MovementWeight { index: *index, weight }.into());
        }
        inverse.push(if price == T::one() { price } else { T::one() / price });
    }
    let dense = |row: &SparseRow<T>| {
        let (mut dense, mut at) = (vec![T::zero(); indices.len()], 0);
        for (index, weight) in row.terms() {
            at += indices[at..].iter().take_while(|i| *i < index).count();
            dense[at] = weight.clone();
        }
        dense
    };
    let dense: Vec<Vec<T>> = rows.iter().map(dense).collect();
    let matrix = match closed_form(&dense, &inverse) {
        Some(matrix) => matrix,
        None => by_orthogonal_rows(&dense, &inverse, excess)?,
    };
    match matrix.iter().all(T::is_finite) {
        true => Ok((indices, matrix)),
        false => Err(Error::NotFinite { what: "movement", index: 0 }),
    }
}

/// `A` for one to three conditions, by the cofactors of `F W^-1 F^T`; none for more, or if the determinant is zero or so
/// small that half of the digits would be lost.
fn closed_form<T: Scalar>(rows: &[Vec<T>], inverse: &[T]) -> Option<Vec<T>> {
    let m = rows.len();
    if !(1..=3).contains(&m) {
        return None;
    }
    let scaled: Vec<Vec<T>> =
        rows.iter().map(|row| row.iter().zip(inverse).map(|(r, w)| r.clone() * w).collect()).collect();
    let f = |i: usize, j: usize| T::dot(rows[i].iter().zip(&scaled[j]));
    let entry = |i: usize, j: usize| if i.max(j) < m { f(i.min(j), i.max(j)) } else { T::zero() };
    let inner: [[T; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
    let (cofactors, determinant) = adjugate(&inner, m);
    let squares = (0..m).fold(T::one(), |product, i| product * &inner[i][i]);
    let least = if T::EXACT { T::zero() } else { squares * T::frac(1, 1 << 12) };
    if !(determinant > least && determinant.is_finite()) {
        return None;
    }
    let entry =
        |n: usize, j: usize| (0..m).fold(T::zero(), |sum, i| sum + scaled[i][n].clone() * &cofactors[i][j]);
    let mut matrix: Vec<T> =
        (0..inverse.len()).flat_map(|n| (0..m).map(move |j| (n, j))).map(|(n, j)| entry(n, j)).collect();
    T::divide(&mut matrix, &determinant);
    Some(matrix)
}

/// Cofactors and determinant of the symmetric matrix of the first `m` rows and columns, `m` from one to three.
fn adjugate<T: Scalar>(f: &[[T; 3]; 3], m: usize) -> ([[T; 3]; 3], T) {
    let minor = |a: &T, b: &T, c: &T, d: &T| a.clone() * d - b.clone() * c;
    let zero = T::zero;
    match m {
        1 => (
            [[T::one(), zero(), zero()], [zero(), zero(), zero()], [zero(), zero(), zero()]],
            f[0][0].clone(),
        ),
        2 => {
            let off = -f[0][1].clone();
            let first = [f[1][1].clone(), off.clone(), zero()];
            let second = [off, f[0][0].clone(), zero()];
            ([first, second, [zero(), zero(), zero()]], minor(&f[0][0], &f[0][1], &f[0][1], &f[1][1]))
        }
        _ => {
            let a00 = minor(&f[1][1], &f[1][2], &f[1][2], &f[2][2]);
            let a01 = minor(&f[0][2], &f[0][1], &f[2][2], &f[1][2]);
            let a02 = minor(&f[0][1], &f[0][2], &f[1][1], &f[1][2]);
            let a11 = minor(&f[0][0], &f[0][2], &f[0][2], &f[2][2]);
            let a12 = minor(&f[0][2], &f[0][0], &f[1][2], &f[0][1]);
            let a22 = minor(&f[0][0], &f[0][1], &f[0][1], &f[1][1]);
            let determinant = f[0][2].clone() * &a02 + f[1][2].clone() * &a12 + f[2][2].clone() * &a22;
            let rows = [[a00, a01.clone(), a02.clone()], [a01, a11, a12.clone()], [a02, a12, a22]];
            (rows, determinant)
        }
    }
}

/// `A` by orthogonal rows.
fn by_orthogonal_rows<T: Scalar>(rows: &[Vec<T>], inverse: &[T], excess: Excess) -> Result<Vec<T>> {
    let (m, n) = (rows.len(), inverse.len());
    let mut steps: Vec<Step<T>> = Vec::new();
    // Row i is the sum of shares[i][k] times orthogonal row k.
    let mut shares: Vec<Vec<T>> = Vec::with_capacity(m);
    let mut sizes: Vec<T> = Vec::with_capacity(m);
    let largest = |rows: &[Vec<T>]| match T::EXACT {
        true => T::one(),
        false => rows.iter().flatten().map(T::magnitude).fold(T::zero(), larger),
    };
    // Least squares compare rows, which must stay in proportion.
    let common = largest(rows);
    for (i, row) in rows.iter().enumerate() {
        let own = if excess == Excess::LeastSquares { common.clone() } else { largest(&rows[i..=i]) };
        let size = if own.is_zero() { T::one() } else { own };
        let mut row = row.clone();
        T::divide(&mut row, &size);
        let Split { shares: mut own, rest } = split(&steps, &row, Change::Diagonal(inverse));
        match rest {
            Some(step) => {
                own.push(T::one());
                steps.push(step);
            }
            None if excess == Excess::Refused => {
                let on = dependencies(&own, &shares);
                return Err(refusal(i, on, m, n).into());
            }
            None => {}
        }
        shares.push(own);
        sizes.push(size);
    }
    let mut multiples =
        if steps.len() == m { inverted(&shares) } else { pseudo_inverted(&shares, steps.len())? };
    for (multiples, step) in multiples.iter_mut().zip(&steps) {
        T::divide(multiples, &step.square);
        multiples.iter_mut().zip(&sizes).for_each(|(x, size)| *x /= size);
    }
    let mut matrix = vec![T::zero(); n * m];
    for (multiples, step) in multiples.iter().zip(&steps) {
        for (entries, change) in matrix.chunks_exact_mut(m).zip(&step.change).filter(|(_, c)| !c.is_zero()) {
            entries.iter_mut().zip(multiples).for_each(|(x, y)| *x += change.clone() * y);
        }
    }
    Ok(matrix)
}

fn refusal(condition: usize, on: Vec<usize>, conditions: usize, free: usize) -> ShapeError {
    if conditions <= free || on.is_empty() {
        return ShapeError::Dependent { condition, on };
    }
    let clashing = on.into_iter().chain([condition]).collect();
    ShapeError::Overdetermined { conditions, free, clashing }
}

/// Which rows a row with these shares of orthogonal ones is a combination of; all rows before were independent.
pub(crate) fn dependencies<T: Scalar>(own: &[T], shares: &[Vec<T>]) -> Vec<usize> {
    let mut left = own.to_vec();
    let size = left.iter().map(T::magnitude).fold(T::zero(), larger);
    let noise = if T::EXACT { T::zero() } else { size * T::frac(1, 1 << 24) };
    let mut on = Vec::new();
    for i in (0..left.len()).rev() {
        let factor = left[i].clone();
        if factor.magnitude() > noise {
            on.push(i);
            left.iter_mut().zip(&shares[i]).for_each(|(x, share)| *x -= factor.clone() * share);
        }
    }
    on.reverse();
    on
}

/// The inverse of a lower triangular matrix with ones on its diagonal.
fn inverted<T: Scalar>(lower: &[Vec<T>]) -> Vec<Vec<T>> {
    let m = lower.len();
    let mut inverse: Vec<Vec<T>> = Vec::with_capacity(m);
    for (i, row) in lower.iter().enumerate() {
        let mut new = vec![T::zero(); m];
        new[i] = T::one();
        for (share, above) in row[..i].iter().zip(&inverse).filter(|(share, _)| !share.is_zero()) {
            new.iter_mut().zip(&above[..i]).for_each(|(x, y)| *x -= share.clone() * y);
        }
        inverse.push(new);
    }
    inverse
}

/// `(L^T L)^-1 L^T` for rows of up to `rank` shares.
fn pseudo_inverted<T: Scalar>(shares: &[Vec<T>], rank: usize) -> Result<Vec<Vec<T>>> {
    if rank == 0 {
        return Ok(Vec::new());
    }
    let lower =
        DMatrix::from_fn(shares.len(), rank, |i, k| shares[i].get(k).cloned().unwrap_or_else(T::zero));
    let transposed = lower.transpose();
    let entry = |i: usize, j: usize| T::dot(lower.column(i).iter().zip(lower.column(j).iter()));
    let normal = DMatrix::from_fn(rank, rank, entry);
    let solved = solve_dense(&normal, &transposed)?;
    Ok((0..rank).map(|k| solved.row(k).iter().cloned().collect()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;
    use proptest::collection::vec;
    use proptest::prelude::*;

    fn rows(m: usize) -> impl Strategy<Value = (Vec<Vec<Q>>, Vec<Q>)> {
        let number = (-9_i64..=9, 1_i64..=4).prop_map(|(n, d)| Q::frac(n, d));
        (vec(vec(number, 6), m), vec((1_i64..=5).prop_map(|d| Q::frac(1, d)), 6))
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn cofactors_and_orthogonal_rows_give_one_matrix((rows, inverse) in (1_usize..=3).prop_flat_map(rows)) {
            let by_rows = by_orthogonal_rows(&rows, &inverse, Excess::Refused);
            match closed_form(&rows, &inverse) {
                Some(matrix) => prop_assert_eq!(matrix, by_rows?),
                None => {
                    let dependent = matches!(by_rows, Err(Error::Shape(ShapeError::Dependent { .. })));
                    prop_assert!(dependent);
                }
            }
            let floats: Vec<Vec<f64>> = rows.iter().map(|row| row.iter().map(Q::to_f64).collect()).collect();
            let inverse: Vec<f64> = inverse.iter().map(Q::to_f64).collect();
            if let Some(matrix) = closed_form(&floats, &inverse) {
                let others = by_orthogonal_rows(&floats, &inverse, Excess::Refused)?;
                let size = others.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
                // The determinant may have lost twelve bits.
                let allowed = f64::EPSILON * 4096.0 * 32.0 * size;
                for (x, y) in matrix.iter().zip(&others) {
                    prop_assert!((x - y).abs() <= allowed, "{} {}", x, y);
                }
            }
        }

        #[test]
        fn an_adjugate_is_the_inverse_times_the_determinant((rows, _) in (1_usize..=3).prop_flat_map(rows)) {
            let m = rows.len();
            let f = |i: usize, j: usize| Q::dot(rows[i].iter().zip(&rows[j]));
            let entry = |i: usize, j: usize| if i.max(j) < m { f(i, j) } else { Q::int(0) };
            let inner: [[Q; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
            let (cofactors, determinant) = adjugate(&inner, m);
            for (i, row) in inner.iter().enumerate().take(m) {
                for j in 0..m {
                    let sum = Q::dot(row.iter().zip(cofactors.iter().map(|row| &row[j])));
                    prop_assert_eq!(sum, if i == j { determinant.clone() } else { Q::int(0) });
                }
            }
        }
    }
}
