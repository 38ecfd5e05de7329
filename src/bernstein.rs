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
        if T::EXACT {
            return self.multiply_whole(left, right, pair);
        }
        let products = match self.q {
            1 => self.multiply_of_order::<2, A, B, C>(left, right, pair),
            2 => self.multiply_of_order::<3, A, B, C>(left, right, pair),
            3 => self.multiply_of_order::<4, A, B, C>(left, right, pair),
            4 => self.multiply_of_order::<5, A, B, C>(left, right, pair),
            5 => self.multiply_of_order::<6, A, B, C>(left, right, pair),
            _ => self.multiply_by_sums(left, right, pair),
        };
        (products, Vec::new())
    }

    /// [`multiply_cleared`](Self::multiply_cleared) over an exact field: each coefficient is summed at once.
    fn multiply_whole<A: Coeff<T>, B: Coeff<T>, C: Coeff<T>>(
        &self,
        left: &[A],
        right: &[B],
        pair: &impl Fn(&A, &B) -> C,
    ) -> (Vec<C>, Vec<T>) {
        let (mut products, mut divisors) = (Vec::new(), Vec::new());
        for (a, b) in left.chunks(self.p + 1).zip(right.chunks(self.q + 1)) {
            let ((a, d), (b, e)) = (cleared(a), cleared(b));
            for k in 0..=self.p + self.q {
                let terms: Vec<_> =
                    self.meeting(k).map(|(i, j, share)| (share, pair(&a[i], &b[j]))).collect();
                let sum = C::combine(terms.iter().map(|(share, c)| (*share, c)));
                products.push(sum.expect("some pair meets in every coefficient"));
            }
            divisors.push(d * e);
        }
        (products, divisors)
    }

    /// [`multiply`](Self::multiply) as the formula has it, one sum a coefficient.
    fn multiply_by_sums<A, B, C: Coeff<T>>(
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

    /// [`multiply`](Self::multiply) for `ORDER = q + 1` known to the compiler: `i` runs from `0` to `p`, and the sums that
    /// `a_i` takes part in, those of `i ..= i + q`, are kept at hand.
    fn multiply_of_order<const ORDER: usize, A, B, C: Coeff<T>>(
        &self,
        left: &[A],
        right: &[B],
        pair: &impl Fn(&A, &B) -> C,
    ) -> Vec<C> {
        let shares: Vec<&[T; ORDER]> =
            self.shares.iter().map(|row| row.first_chunk().expect("a row has `q + 1` shares")).collect();
        let mut products = Vec::with_capacity(left.len() / (self.p + 1) * (self.p + ORDER));
        for (a, b) in left.chunks_exact(self.p + 1).zip(right.as_chunks::<ORDER>().0) {
            let product = |i: usize, j: usize| {
                let mut product = pair(&a[i], &b[j]);
                product.scale(&shares[i][j]);
                product
            };
            let mut sums: [C; ORDER] = std::array::from_fn(|j| product(0, j));
            for i in 1..=self.p {
                let done = std::mem::replace(&mut sums[0], product(i, ORDER - 1));
                for j in 0..ORDER - 1 {
                    sums.swap(j, j + 1);
                    sums[j].add_scaled(&shares[i][j], &pair(&a[i], &b[j]));
                }
                products.push(done);
            }
            products.extend(sums);
        }
        products
    }
}
