//! The derivatives of a quotient from those of numerator and denominator.

use crate::coeff::Coeff;
use crate::scalar::Scalar;
use crate::weighted::Weighted;

/// The partial derivatives `[k][l]` of `point / weight`, from those of both. A single column is the rule for curves
/// [NURBS, section 4.3].
pub(crate) fn quotients<T: Scalar, C: Coeff<T>>(lifted: &[Vec<Weighted<T, C>>]) -> Vec<Vec<C>> {
    let mut found: Vec<Vec<C>> = Vec::with_capacity(lifted.len());
    for (k, row) in lifted.iter().enumerate() {
        found.push(Vec::with_capacity(row.len()));
        for l in 0..row.len() {
            let next = quotient((k, l), |i, j| &lifted[i][j], |i, j| &found[i][j]);
            found[k].push(next);
        }
    }
    found
}

/// The partial derivative `(k, l)` of `point / weight` from those of both, `lifted`, and from the lower ones of the quotient, `found`.
///
/// By Leibniz `A^(k,l) = Σ C(k, i) C(l, j) w^(i,j) S^(k-i,l-j)`, solved for the term with `i = j = 0` [NURBS, section 4.5].
#[inline(always)]
pub(crate) fn quotient<'a, T: Scalar, C: Coeff<T>>(
    (k, l): (usize, usize),
    lifted: impl Fn(usize, usize) -> &'a Weighted<T, C>,
    found: impl Fn(usize, usize) -> &'a C,
) -> C {
    let mut rest = lifted(k, l).clone();
    let mut over_k = T::one();
    for i in 0..=k {
        let mut share = over_k.clone();
        for j in 0..=l {
            if (i, j) != (0, 0) {
                let weight = share.clone() * &lifted(i, j).weight;
                rest.point.add_scaled(&-weight, found(k - i, l - j));
            }
            share = share * T::int((l - j) as i64) / T::int(j as i64 + 1);
        }
        over_k = over_k * T::int((k - i) as i64) / T::int(i as i64 + 1);
    }
    rest.weight = lifted(0, 0).weight.clone();
    rest.project()
}
