//! Bernstein polynomials: binomial coefficients, and products of polynomials piece by piece.

use crate::coeff::Coeff;
use crate::scalar::Scalar;

/// `C(n, 0), ..., C(n, n)`.
pub(crate) fn binomials<T: Scalar>(n: usize) -> Vec<T> {
    let mut row = vec![T::one(); n + 1];
    for k in 1..n {
        row[k] = row[k - 1].clone() * T::int((n + 1 - k) as i64) / T::int(k as i64);
    }
    row
}

/// The weights of Bernstein products of degrees `p` and `q`: `C(p, i) C(q, j) / C(p + q, i + j)` for all `i`, `j`.
pub(crate) struct Shares<T> {
    p: usize,
    q: usize,
    shares: Vec<Vec<T>>,
}

impl<T: Scalar> Shares<T> {
    pub(crate) fn new(p: usize, q: usize) -> Self {
        let [rows_p, rows_q, rows] = [p, q, p + q].map(binomials::<T>);
        let share = |i: usize, j: usize| rows_p[i].clone() * &rows_q[j] / &rows[i + j];
        Self { p, q, shares: (0..=p).map(|i| (0..=q).map(|j| share(i, j)).collect()).collect() }
    }

    /// One row for each `i`.
    pub(crate) fn rows(&self) -> &[Vec<T>] {
        &self.shares
    }

    /// The pairs `(i, k - i)` that meet in coefficient `k`, with their weights.
    pub(crate) fn meeting(&self, k: usize) -> impl Iterator<Item = (usize, usize, &T)> {
        (k.saturating_sub(self.q)..=self.p.min(k)).map(move |i| (i, k - i, &self.shares[i][k - i]))
    }

    /// The Bernstein coefficients `Σ_{i+j=k} share(i, j) pair(a_i, b_j)` of the products of the pieces of `left`
    /// (`p + 1` coefficients each) and of `right` (`q + 1` each).
    pub(crate) fn multiply<A, B, C: Coeff<T>>(
        &self,
        left: &[A],
        right: &[B],
        pair: &impl Fn(&A, &B) -> C,
    ) -> Vec<C> {
        let degree = self.p + self.q;
        let mut products = Vec::with_capacity(left.len() / (self.p + 1) * (degree + 1));
        for (a, b) in left.chunks(self.p + 1).zip(right.chunks(self.q + 1)) {
            for k in 0..=degree {
                let mut meeting = self.meeting(k);
                let (i, j, share) = meeting.next().expect("some pair meets in every coefficient");
                let mut sum = pair(&a[i], &b[j]);
                sum.scale(share);
                meeting.for_each(|(i, j, share)| sum.add_scaled(share, &pair(&a[i], &b[j])));
                products.push(sum);
            }
        }
        products
    }
}
