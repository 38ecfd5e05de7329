//! The knots of a coefficient of a finer space, seen from the coarser one.
//!
//! They are a run `t_{lo+1}, ..., t_{hi}` of its knots, which cost nothing as polar arguments, and free arguments: new
//! knots, and new copies of knots. From one coefficient to the next a knot goes and another comes. So nothing is searched.

use crate::coeff::Coeff;
use crate::polar::polar_value;
use crate::scalar::Scalar;

/// A run of knots of a space of degree `ORDER - 1`, and up to `ORDER` free arguments in ascending order.
pub(crate) struct Run<'a, T, const ORDER: usize> {
    t: &'a [T],
    lo: usize,
    hi: usize,
    count: usize,
    free: [&'a T; ORDER],
}

impl<'a, T: Scalar, const ORDER: usize> Run<'a, T, ORDER> {
    /// The ascending `args` around span `k` of the knots `t`, at most `ORDER` of them.
    pub(crate) fn new(t: &'a [T], k: usize, args: &'a [T]) -> Self {
        let mut run = Self { t, lo: k, hi: k, count: 0, free: [&t[k]; ORDER] };
        let middle = args.iter().take_while(|x| **x <= t[k]).count();
        for x in args[..middle].iter().rev() {
            if run.lo > 0 && *x == t[run.lo] {
                run.lo -= 1;
            } else {
                run.free[run.count] = x;
                run.count += 1;
            }
        }
        run.free[..run.count].reverse();
        args[middle..].iter().for_each(|x| run.push(x));
        run
    }

    #[inline(always)]
    fn push(&mut self, next: &'a T) {
        if self.t.get(self.hi + 1) == Some(next) {
            self.hi += 1;
        } else {
            self.free[self.count] = next;
            self.count += 1;
        }
    }

    /// Drops the `first` of the arguments and takes the `next` one.
    #[inline(always)]
    pub(crate) fn advance(&mut self, first: &T, next: &'a T) {
        if self.is_free(0, first) {
            (1..ORDER).for_each(|i| self.free.swap(i - 1, i));
            self.count -= 1;
        } else {
            self.lo += 1;
        }
        self.push(next);
    }

    /// Whether free argument `i` is there and is a copy of `knot`.
    #[inline(always)]
    pub(crate) fn is_free(&self, i: usize, knot: &T) -> bool {
        i < self.count && self.free[i] == knot
    }

    /// The polar value at these `ORDER - 1` arguments of the spline with `coeffs`.
    #[inline(always)]
    pub(crate) fn polar<C: Coeff<T>>(&self, coeffs: &[C]) -> C {
        self.polar_between(self.lo, self.hi, self.count, coeffs)
    }

    /// The polar value without free argument `out`.
    #[inline(always)]
    pub(crate) fn polar_without_free<C: Coeff<T>>(&self, out: usize, coeffs: &[C]) -> C {
        self.polar_between(self.lo, self.hi, out, coeffs)
    }

    /// The polar value without the first knot of the run.
    #[inline(always)]
    pub(crate) fn polar_without_first<C: Coeff<T>>(&self, coeffs: &[C]) -> C {
        self.polar_between(self.lo + 1, self.hi, self.count, coeffs)
    }

    /// The polar value without the last knot of the run.
    #[inline(always)]
    pub(crate) fn polar_without_last<C: Coeff<T>>(&self, coeffs: &[C]) -> C {
        self.polar_between(self.lo, self.hi - 1, self.count, coeffs)
    }

    /// The polar value at the knots from `lo + 1` to `hi` and the free arguments without `out`.
    #[inline(always)]
    fn polar_between<C: Coeff<T>>(&self, lo: usize, hi: usize, out: usize, coeffs: &[C]) -> C {
        let mut weights: [T; ORDER] = std::array::from_fn(|_| T::zero());
        let arg = |r: usize| self.free[if r < out { r } else { r + 1 }];
        let value = |weights: &mut [T]| polar_value(self.t, (lo, hi), arg, weights, (hi + 1 - ORDER, coeffs));
        // Few arguments are free as a rule: let the compiler know how many.
        match ORDER + lo - hi {
            1 => value(&mut weights[..1]),
            2 => value(&mut weights[..2]),
            3 if ORDER > 3 => value(&mut weights[..3]),
            len => value(&mut weights[..len]),
        }
    }
}
