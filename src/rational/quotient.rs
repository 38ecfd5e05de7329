//! The derivatives of a quotient from those of numerator and denominator.

use crate::bernstein::binomials;
use crate::coeff::Coeff;
use crate::scalar::Scalar;
use crate::weighted::Weighted;

/// The partial derivatives `[k][l]` of `point / weight`, from those of both.
///
/// By Leibniz `A^(k,l) = Σ C(k, i) C(l, j) w^(i,j) S^(k-i,l-j)`, solved for the term with `i = j = 0` [NURBS, section 4.5]. A
/// single column is the rule for curves [NURBS, section 4.3].
pub(crate) fn quotients<T: Scalar, C: Coeff<T>>(lifted: &[Vec<Weighted<T, C>>]) -> Vec<Vec<C>> {
    let inverse = T::one() / &lifted[0][0].weight;
    let mut quotients: Vec<Vec<C>> = Vec::with_capacity(lifted.len());
    for (k, row) in lifted.iter().enumerate() {
        let over_k = binomials::<T>(k);
        quotients.push(Vec::with_capacity(row.len()));
        for (l, derivative) in row.iter().enumerate() {
            let over_l = binomials::<T>(l);
            let mut rest = derivative.point.clone();
            for (i, j) in (0..=k).flat_map(|i| (0..=l).map(move |j| (i, j))).skip(1) {
                let share = over_k[i].clone() * &over_l[j] * &lifted[i][j].weight;
                rest.add_scaled(&-share, &quotients[k - i][l - j]);
            }
            rest.scale(&inverse);
            quotients[k].push(rest);
        }
    }
    quotients
}
