//! Going back from coefficients that were blended pairwise: what knot removal and degree reduction have in common.
//!
//! Inserting one knot, or raising the degree of a polynomial by one, makes coefficients `c_0 ... c_n` of `d_0 ... d_{n-1}`:
//!
//! ```text
//! c_i = α_i d_i + (1 - α_i) d_{i-1}        1 = α_0 > α_1 > ... > α_n = 0
//! ```
//! On the way back there is one equation too many. With equation `k` left out the others are solved from both sides,
//! those before `k` from the left, those after it from the right ([NURBS, section 5.4] does so for knots), and the error
//! of `d` is that of equation `k` alone: in the space of the `c` it is a multiple of the one basis function `N_k`.
//!
//! That multiple is `Λ(c) / λ_k`, where `Σ λ_i c_i = Λ(c)` is the one condition on the `c`, and
//! `λ_{i+1} / λ_i = -α_i / (1 - α_{i+1})`. So it is least where `α_k + α_{k+1}` falls to one or below, and there the
//! sweeps divide by `α_i > 1/2` and by `1 - α_i >= 1/2` only: the smallest error and the stable sweep are the same choice.

use crate::coeff::Coeff;
use crate::scalar::Scalar;

/// The parts `(α_i, 1 - α_i)` of one blend.
pub(crate) type Parts<T> = (T, T);

/// The equation with the smallest error when it is left out.
pub(crate) fn best_to_drop<T: Scalar>(blends: &[Parts<T>]) -> usize {
    let n = blends.len() - 1;
    (1..n).find(|&k| blends[k].0 <= blends[k + 1].1).unwrap_or(1)
}

/// Solves all equations but `k`: `d_0 ... d_{k-1}` come to stand before place `k` of `c`, the others after it.
#[inline]
pub(crate) fn unblend<T: Scalar, C: Coeff<T>>(blends: &[Parts<T>], k: usize, c: &mut [C]) {
    let solve = |mine: &T, theirs: &T, value: &mut C, known: &C| {
        let ratio = theirs.clone() / mine;
        value.scale(&(T::one() + &ratio));
        value.add_scaled(&-ratio, known);
    };
    for i in 1..k {
        let (before, after) = c.split_at_mut(i);
        solve(&blends[i].0, &blends[i].1, &mut after[0], &before[i - 1]);
    }
    for i in (k + 1..c.len() - 1).rev() {
        let (before, after) = c.split_at_mut(i + 1);
        solve(&blends[i].1, &blends[i].0, &mut before[i], &after[0]);
    }
}

/// As [`unblend`] without the equation with the smallest error, which is returned; two coefficients that should be one
/// become their mean.
pub(crate) fn unblend_best<T: Scalar, C: Coeff<T>>(blends: &[Parts<T>], c: &mut [C]) -> usize {
    let k = best_to_drop(blends);
    if let [first, second] = c {
        first.add_scaled(&T::one(), second);
        first.scale(&T::frac(1, 2));
    }
    unblend(blends, k, c);
    k
}

/// What equation `i` lacks, `c_i - α_i d_i - (1 - α_i) d_{i-1}`, with the `d` as [`unblend`] leaves them around `k`.
#[inline]
pub(crate) fn lack<T: Scalar, C: Coeff<T>>(blends: &[Parts<T>], k: usize, i: usize, c_i: &C, d: &[C]) -> C {
    let place = |j: usize| if j < k { &d[j] } else { &d[j + 1] };
    let (alpha, beta) = &blends[i];
    let mut lack = c_i.clone();
    if !alpha.is_zero() {
        lack.add_scaled(&-alpha.clone(), place(i));
    }
    if !beta.is_zero() {
        lack.add_scaled(&-beta.clone(), place(i - 1));
    }
    lack
}

/// One degree less for the polynomial with the Bernstein coefficients `c`; exact if there is one.
pub(crate) fn lower_degree<T: Scalar, C: Coeff<T>>(c: &mut Vec<C>) {
    let p = c.len() - 1;
    let blends: Vec<Parts<T>> =
        (0..=p).map(|i| (T::frac((p - i) as i64, p as i64), T::frac(i as i64, p as i64))).collect();
    let k = unblend_best(&blends, c);
    c.remove(k);
}
