//! The polar form on one span, the primitive under every operator.
//!
//! On a non-empty span `[t_k, t_{k+1}]` a spline `f` of degree `p` is a polynomial. Its polar form `F` is the one
//! symmetric function of `p` arguments that is affine in each and has `F(x, ..., x) = f(x)`. Coefficients are polar
//! values, `c_i = F(t_{i+1}, ..., t_{i+p})`, and so is everything else: a value takes all arguments at `x`, a
//! coefficient of a finer space takes the knots of that space, a derivative takes directions for arguments.
//!
//! If the arguments contain the run `t_{lo+1}, ..., t_{hi}` of knots (`lo <= k <= hi`), then `q = p - (hi - lo)` are
//! free, and the value is a combination of the `q + 1` coefficients `c_{hi-p}, ..., c_{lo}`. The weights follow by
//! one step an argument, each over an interval `[t_i, t_j]` that contains the span: no denominator can vanish, and
//! while the free arguments stay within `[t_lo, t_{hi+1}]` every step is a convex combination.

use crate::coeff::Coeff;
use crate::functional::weigh;
use crate::scalar::Scalar;

/// The weights of the polar value at the free arguments `arg(0), ..., arg(q - 1)` beside the run
/// `t_{lo+1}, ..., t_{hi}`, on the coefficients from `hi - p`; there are `q + 1 = weights.len()` of them.
///
/// With `lo = hi = k` and all arguments at `x` these are the basis functions of degree `q` at `x`.
#[inline(always)]
pub(crate) fn blossom<'a, T: Scalar>(
    t: &[T],
    lo: usize,
    hi: usize,
    arg: impl Fn(usize) -> &'a T,
    weights: &mut [T],
) {
    weights[0] = T::one();
    for r in 1..weights.len() {
        let x = arg(r - 1);
        let (below, above) = (&t[lo + 1 - r..lo + 1], &t[hi + 1..hi + 1 + r]);
        let mut saved = T::zero();
        for ((w, left), right) in weights.iter_mut().zip(below).zip(above) {
            let share = std::mem::replace(w, saved) / (right.clone() - left);
            *w += (right.clone() - x) * &share;
            saved = (x.clone() - left) * share;
        }
        weights[r] = saved;
    }
}

/// The polar value itself, where the weights of [`blossom`] are those of `coeffs` from `first`, indices wrapped.
///
/// `weights` is room for them; over an exact field they may be left as whole numbers, see [`Scalar::whole_blossom`].
#[inline(always)]
pub(crate) fn polar_value<'a, T: Scalar, C: Coeff<T>>(
    t: &'a [T],
    (lo, hi): (usize, usize),
    arg: impl Fn(usize) -> &'a T,
    weights: &mut [T],
    (first, coeffs): (usize, &[C]),
) -> C {
    let Some(denominator) = T::whole_blossom(t, lo, hi, &arg, weights) else {
        blossom(t, lo, hi, arg, weights);
        return weigh(first, weights, coeffs);
    };
    let mut value = weigh(first, weights, coeffs);
    value.divide(&denominator);
    value
}

/// Appends the weights of the polar value at `args` on the Bernstein coefficients over `[a, b]`; returns the index of
/// the first. Arguments at the ends cost nothing.
#[inline]
pub(crate) fn bernstein_blossom<T: Scalar>(a: &T, b: &T, args: &[T], weights: &mut Vec<T>) -> usize {
    let start = weights.len();
    weights.push(T::one());
    for x in args.iter().filter(|x| *x != a && *x != b) {
        let width = b.clone() - a;
        let (u, v) = ((x.clone() - a) / &width, (b.clone() - x) / &width);
        let mut saved = T::zero();
        for w in &mut weights[start..] {
            let share = std::mem::replace(w, saved);
            *w += v.clone() * &share;
            saved = share * &u;
        }
        weights.push(saved);
    }
    args.iter().filter(|x| *x == b).count()
}

/// One further argument that is a direction: `weights`, of a polar form with `r` arguments around the knot run
/// `t_{lo+1}, ..., t_{hi}`, become those of `r + 1` arguments, the last of them the unit direction.
pub(crate) fn differentiate<T: Scalar>(t: &[T], lo: usize, hi: usize, weights: &mut Vec<T>) {
    let r = weights.len();
    let (below, above) = (&t[lo + 1 - r..lo + 1], &t[hi + 1..hi + 1 + r]);
    let mut saved = T::zero();
    for ((w, left), right) in weights.iter_mut().zip(below).zip(above) {
        let share = std::mem::replace(w, saved) / (right.clone() - left);
        *w -= &share;
        saved = share;
    }
    weights.push(saved);
}

/// Takes from the sorted arguments the longest run of knots around span `k`: returns `(lo, hi)` of the run and
/// leaves the other arguments in `free`.
#[inline]
pub(crate) fn take_run<'a, T: Scalar>(
    t: &[T],
    k: usize,
    args: &[&'a T],
    free: &mut Vec<&'a T>,
) -> (usize, usize) {
    free.clear();
    let (mut lo, mut hi) = (k, k);
    let middle = args.iter().take_while(|x| ***x <= t[k]).count();
    for x in args[..middle].iter().rev() {
        if **x == t[lo] { lo -= 1 } else { free.push(x) }
    }
    for x in &args[middle..] {
        if **x == t[hi + 1] { hi += 1 } else { free.push(x) }
    }
    (lo, hi)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;
    use proptest::collection::vec;
    use proptest::prelude::*;

    fn number() -> impl Strategy<Value = Q> {
        let few = (-9..=9i64, 1..=6i64).prop_map(|(p, q)| Q::frac(p, q));
        let image = prop_oneof![-9.0..9.0f64, -1e-9..1e-9].prop_map(|x| Q::try_from(x).unwrap());
        let tiny = (-9..=9i64, 0..3u32)
            .prop_map(|(p, k)| Q::int(p) / Q::int(1 << 60) / Q::int(3_i64.pow(39 * (k / 2))));
        prop_oneof![3 => few, 3 => image, 1 => tiny]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]

        #[test]
        fn whole_weights_are_the_weights(
            q in 0..11_usize, mut knots in vec(number(), 22), args in vec(number(), 11), even in any::<bool>()
        ) {
            if even {
                knots = (0..22).map(Q::int).collect();
            }
            knots.sort();
            knots.dedup();
            prop_assume!(knots.len() >= 2 * q.max(1));
            let span = knots.len() / 2 - 1;
            let mut weights = vec![Q::int(0); q + 1];
            blossom(&knots, span, span, |r| &args[r], &mut weights);
            let mut whole = vec![Q::int(7); q + 1];
            match Q::whole_blossom(&knots, span, span, &|r| &args[r], &mut whole) {
                Some(d) => {
                    prop_assert!(whole.iter().all(Q::is_integer));
                    prop_assert_eq!(whole.into_iter().map(|n| n / &d).collect::<Vec<_>>(), weights);
                }
                None => prop_assert!(whole.iter().all(|n| *n == Q::int(7))),
            }
        }
    }
}
