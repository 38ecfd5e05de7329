//! Bernstein polynomials: binomial coefficients, and products of polynomials piece by piece.

use crate::coeff::{Coeff, cleared};
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
    pub(crate) fn multiply<A: Coeff<T>, B: Coeff<T>, C: Coeff<T>>(
        &self,
        left: &[A],
        right: &[B],
        pair: &impl Fn(&A, &B) -> C,
    ) -> Vec<C> {
        let (mut products, divisors) = self.multiply_cleared(left, right, pair);
        for (piece, divisor) in products.chunks_mut(self.p + self.q + 1).zip(&divisors) {
            piece.iter_mut().filter(|_| !divisor.is_one()).for_each(|c| c.divide(divisor));
        }
        products
    }

    /// The same with each piece multiplied by a number of its own, as it comes from factors without denominators; no numbers
    /// stand for ones.
    pub(crate) fn multiply_cleared<A: Coeff<T>, B: Coeff<T>, C: Coeff<T>>(
        &self,
        left: &[A],
        right: &[B],
        pair: &impl Fn(&A, &B) -> C,
    ) -> (Vec<C>, Vec<T>) {
        let count = left.len() / (self.p + 1);
        let mut products = Vec::with_capacity(count * (self.p + self.q + 1));
        let mut divisors = Vec::new();
        for (a, b) in left.chunks(self.p + 1).zip(right.chunks(self.q + 1)) {
            if T::EXACT {
                let ((a, d), (b, e)) = (cleared(a), cleared(b));
                self.combine_pieces(&a, &b, pair, &mut products);
                divisors.push(d * e);
            } else {
                self.add_pieces(a, b, pair, &mut products);
            }
        }
        (products, divisors)
    }

    /// One piece, each coefficient summed term by term.
    fn add_pieces<A, B, C: Coeff<T>>(
        &self,
        a: &[A],
        b: &[B],
        pair: &impl Fn(&A, &B) -> C,
        products: &mut Vec<C>,
    ) {
        for k in 0..=self.p + self.q {
            let mut meeting = self.meeting(k);
            let (i, j, share) = meeting.next().expect("some pair meets in every coefficient");
            let mut sum = pair(&a[i], &b[j]);
            sum.scale(share);
            meeting.for_each(|(i, j, share)| sum.add_scaled(share, &pair(&a[i], &b[j])));
            products.push(sum);
        }
    }

    /// One piece, each coefficient summed at once.
    fn combine_pieces<A, B, C: Coeff<T>>(
        &self,
        a: &[A],
        b: &[B],
        pair: &impl Fn(&A, &B) -> C,
        products: &mut Vec<C>,
    ) {
        for k in 0..=self.p + self.q {
            let terms: Vec<_> = self.meeting(k).map(|(i, j, share)| (share, pair(&a[i], &b[j]))).collect();
            let sum = C::combine(terms.iter().map(|(share, c)| (*share, c)));
            products.push(sum.expect("some pair meets in every coefficient"));
        }
    }
}
