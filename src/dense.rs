//! Dense linear systems.
//!
//! Over `f64` by elimination with the largest pivot of each column, over [`Q`](crate::exact::Q) exactly and in a small
//! multiple of that time, over any other field by elimination.

use crate::error::{Error, Result};
use crate::limits::check_entries;
use crate::scalar::Scalar;
use nalgebra::DMatrix;

/// The solution `x` of `matrix x = right`, for each column of `right`.
///
/// `matrix` is `n` by `n`, `right` and the solution are `n` by any number of columns. Over an exact field the solution is the
/// exact one. Over `f64` it is that of elimination with partial pivoting; a matrix that is singular but for rounding is not
/// always found out.
///
/// # Errors
/// [`Error::CoefficientCount`] if `matrix` is not square or `right` has not as many rows; [`Error::NotFinite`];
/// [`Error::Singular`] with the first column that depends on those before it, in `f64` as far as elimination tells;
/// [`Error::TooLarge`] for more than [`MAX_ENTRIES`](crate::limits::MAX_ENTRIES) entries.
///
/// # Examples
/// ```
/// use nalgebra::dmatrix;
/// use symspline::{Error, Q, Scalar, solve_dense};
/// // The Hilbert matrix, of which floating point soon knows nothing.
/// let hilbert = nalgebra::DMatrix::from_fn(12, 12, |i, j| Q::frac(1, (i + j + 1) as i64));
/// let sums = nalgebra::DMatrix::from_fn(12, 1, |i, _| hilbert.row(i).iter().sum());
/// assert!(solve_dense(&hilbert, &sums)?.iter().all(|x| *x == Q::int(1)));
///
/// assert_eq!(solve_dense(&dmatrix![0.0, 2.0; 1.0, 0.0], &dmatrix![6.0; 5.0])?, dmatrix![5.0; 3.0]);
/// let ones = dmatrix![Q::int(1), Q::int(1); Q::int(1), Q::int(1)];
/// assert_eq!(solve_dense(&ones, &ones), Err(Error::Singular { row: 1 }));
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn solve_dense<T: Scalar>(matrix: &DMatrix<T>, right: &DMatrix<T>) -> Result<DMatrix<T>> {
    let n = matrix.nrows();
    for found in [matrix.ncols(), right.nrows()] {
        if found != n {
            return Err(Error::CoefficientCount { expected: n, found });
        }
    }
    check_entries(n, n.saturating_add(right.ncols()))?;
    for (what, values) in [("entry", matrix), ("right-hand side", right)] {
        if let Some(index) = values.iter().position(|x| !x.is_finite()) {
            return Err(Error::NotFinite { what, index });
        }
    }
    T::solve(matrix, right).unwrap_or_else(|| eliminated(matrix, right))
}

/// The solution by elimination.
pub(crate) fn eliminated<T: Scalar>(matrix: &DMatrix<T>, right: &DMatrix<T>) -> Result<DMatrix<T>> {
    let (n, count) = (matrix.nrows(), right.ncols());
    // Each row with its right-hand sides.
    let row = |i: usize| -> Vec<T> { matrix.row(i).iter().chain(right.row(i).iter()).cloned().collect() };
    let mut rows: Vec<Vec<T>> = (0..n).map(row).collect();
    for k in 0..n {
        let pivot = pivot(&rows, k).ok_or(Error::Singular { row: k })?;
        rows.swap(k, pivot);
        let (above, below) = rows.split_at_mut(k + 1);
        let pivot = &above[k][k..];
        for row in below {
            if row[k].is_zero() {
                continue;
            }
            let factor = row[k].clone() / &pivot[0];
            let entries = row[k + 1..].iter_mut().zip(&pivot[1..]);
            entries.for_each(|(x, y)| *x -= factor.clone() * y);
        }
    }
    let mut solution = DMatrix::from_element(n, count, T::zero());
    for k in (0..n).rev() {
        // A pivot beyond the range would divide its row to zero.
        if !rows[k][k].is_finite() {
            return Err(Error::Singular { row: k });
        }
        for c in 0..count {
            let known = T::dot(rows[k][k + 1..n].iter().zip(solution.column(c).iter().skip(k + 1)));
            solution[(k, c)] = (rows[k][n + c].clone() - known) / &rows[k][k];
            if !solution[(k, c)].is_finite() {
                return Err(Error::Singular { row: k });
            }
        }
    }
    Ok(solution)
}

/// The row with the largest entry in column `k`, over an exact field the first one that is not zero.
fn pivot<T: Scalar>(rows: &[Vec<T>], k: usize) -> Option<usize> {
    let mut nonzero = (k..rows.len()).filter(|i| !rows[*i][k].is_zero());
    if T::EXACT {
        return nonzero.next();
    }
    let size = |i: usize| rows[i][k].magnitude();
    nonzero.reduce(|best, i| if size(i) > size(best) { i } else { best })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;
    use nalgebra::dmatrix;

    #[test]
    fn the_smallest_systems_are_solved() {
        let empty = DMatrix::<Q>::zeros(0, 0);
        assert_eq!(solve_dense(&empty, &DMatrix::zeros(0, 3)).unwrap().shape(), (0, 3));
        let two = dmatrix![Q::int(2)];
        assert_eq!(
            solve_dense(&two, &dmatrix![Q::int(3), Q::int(1)]),
            Ok(dmatrix![Q::frac(3, 2), Q::frac(1, 2)])
        );
        assert_eq!(solve_dense(&two, &DMatrix::zeros(1, 0)).unwrap().shape(), (1, 0));
        assert_eq!(solve_dense(&dmatrix![0.0], &dmatrix![1.0]), Err(Error::Singular { row: 0 }));
    }

    #[test]
    fn shapes_and_numbers_are_checked() {
        let square = dmatrix![1.0, 2.0; 3.0, 4.0];
        let count = |found| Err(Error::CoefficientCount { expected: 2, found });
        assert_eq!(solve_dense(&dmatrix![1.0; 2.0], &square), count(1));
        assert_eq!(solve_dense(&square, &dmatrix![1.0]), count(1));
        let what = |matrix: &DMatrix<f64>, right: &DMatrix<f64>| solve_dense(matrix, right).unwrap_err();
        let bad = dmatrix![1.0, f64::NAN; 0.0, 1.0];
        assert_eq!(what(&bad, &square), Error::NotFinite { what: "entry", index: 2 });
        assert_eq!(what(&square, &bad), Error::NotFinite { what: "right-hand side", index: 2 });
    }

    #[test]
    fn a_pivot_that_overflows_is_no_pivot() {
        let matrix = dmatrix![-1e308, 1e308; 1e308, 1e308];
        assert_eq!(solve_dense(&matrix, &dmatrix![1.0; 2.0]), Err(Error::Singular { row: 1 }));
    }

    #[test]
    fn the_largest_pivot_is_taken_in_floating_point() {
        // Elimination by the tiny pivot would lose the one.
        let matrix = dmatrix![1e-20, 1.0; 1.0, 1.0];
        assert_eq!(solve_dense(&matrix, &dmatrix![1.0; 2.0]), Ok(dmatrix![1.0; 1.0]));
    }
}
