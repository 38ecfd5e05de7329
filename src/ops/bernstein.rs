//! Binomial coefficients and the weights of Bernstein products.

use crate::scalar::Scalar;

/// `C(p, i) C(q, j) / C(p + q, i + j)` for all `i`, `j`.
pub(crate) fn bernstein_shares<T: Scalar>(p: usize, q: usize) -> Vec<Vec<T>> {
    let [rows_p, rows_q, rows] = [p, q, p + q].map(binomials::<T>);
    let share = |i: usize, j: usize| rows_p[i].clone() * &rows_q[j] / &rows[i + j];
    (0..=p).map(|i| (0..=q).map(|j| share(i, j)).collect()).collect()
}

/// `C(n, 0), ..., C(n, n)`.
fn binomials<T: Scalar>(n: usize) -> Vec<T> {
    let mut row = vec![T::one(); n + 1];
    for k in 1..n {
        row[k] = row[k - 1].clone() * T::int((n + 1 - k) as i64) / T::int(k as i64);
    }
    row
}
