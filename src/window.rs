//! Values and derivatives on one span, from the coefficients under it.

use crate::coeff::Coeff;
use crate::functional::weigh;
use crate::polar::blossom;
use crate::scalar::Scalar;

/// The degrees below this one are known to the compiler, and their weights stand on the stack.
pub(crate) const SMALL: usize = 6;

/// The weights at `x` of the basis functions of degree `p < SMALL` on span `k`, in the first `p + 1` places.
#[inline]
pub(crate) fn small_weights<T: Scalar>(t: &[T], k: usize, p: usize, x: &T) -> [T; SMALL] {
    let mut weights: [T; SMALL] = std::array::from_fn(|_| T::zero());
    match p {
        0 => weights[0] = T::one(),
        1 => blossom(t, k, k, |_| x, &mut weights[..2]),
        2 => blossom(t, k, k, |_| x, &mut weights[..3]),
        3 => blossom(t, k, k, |_| x, &mut weights[..4]),
        4 => blossom(t, k, k, |_| x, &mut weights[..5]),
        _ => blossom(t, k, k, |_| x, &mut weights[..6]),
    }
    weights
}

/// Value and derivatives of orders `0 ..= order` at `x` of the polynomial of span `k` with the `p + 1` coefficients
/// `window`; beyond the degree they are zero.
///
/// The coefficients are differentiated first: where they agree there is nothing to round.
pub(crate) fn derivatives<T: Scalar, C: Coeff<T>>(
    t: &[T],
    k: usize,
    mut window: Vec<C>,
    x: &T,
    order: usize,
) -> Vec<C> {
    let p = window.len() - 1;
    let mut weights = vec![T::zero(); p + 1];
    let mut derivatives = Vec::with_capacity(order + 1);
    for q in (p.saturating_sub(order)..=p).rev() {
        blossom(t, k, k, |_| x, &mut weights[..=q]);
        derivatives.push(weigh(0, &weights[..=q], &window[..=q]));
        // From degree q to q - 1: coefficient j belongs to the knot interval [t_i, t_{i+q}].
        for (j, i) in (0..q).zip(k + 1 - q..) {
            window[j] = window[j + 1].minus(&window[j]);
            window[j].scale(&(T::int(q as i64) / (t[i + q].clone() - &t[i])));
        }
    }
    derivatives.resize(order + 1, window[0].zero_like());
    derivatives
}
