//! Polynomials on spans in powers of a local parameter.
//!
//! On a span `[a, b]` the local parameter is `s = (x - a) / (b - a) - 1/2`. From the Bernstein coefficients `c` of degree `p` those
//! of the powers are
//!
//! ```text
//! d_k = C(p, k) A^(p-k) D^k c        A: means of neighbours        D: differences of neighbours
//! ```
//!
//! About the middle the terms of the sum `Σ d_k s^k` are at most `2^p` times the `c` altogether; about an end it would be `3^p`.

use crate::bernstein::binomials;
use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::functional::weigh;
use crate::scalar::Scalar;
use std::borrow::Borrow;

/// The highest degree for which powers are used: what rounding grows by is at most `2^8`.
pub(crate) const POWERS: usize = 8;

/// The coefficients that a piece has at least: low degrees are padded with zeros, so that single values need no branch.
pub(crate) const LEAST: usize = 4;

/// Start of a span, and the reciprocal of its length.
///
/// The start is a knot, and exact: a middle would be rounded, and shift the parameter.
#[derive(Clone, Debug)]
pub(crate) struct Local<T> {
    start: T,
    slope: T,
}

impl<T: Scalar> Local<T> {
    /// For every span between `breaks`, which are knots: a space has reciprocals for its spans.
    pub(crate) fn of_spans(breaks: &[T]) -> Vec<Self> {
        let slope = |ends: &[T]| T::one() / (ends[1].clone() - &ends[0]);
        breaks.windows(2).map(|ends| Self { start: ends[0].clone(), slope: slope(ends) }).collect()
    }

    /// The local parameter of `x`.
    #[inline(always)]
    pub(crate) fn parameter(&self, x: &T) -> T {
        (x.clone() - &self.start) * &self.slope - T::frac(1, 2)
    }

    /// `ds / dx`.
    #[inline(always)]
    pub(crate) fn slope(&self) -> &T {
        &self.slope
    }
}

/// Turns Bernstein coefficients into those of powers; keeps its scratch.
pub(crate) struct Centring<T, C> {
    /// The weights `C(p, k) C(p - k, i) / 2^(p-k)` of differences `i` of order `k`.
    means: Vec<Vec<T>>,
    differences: Vec<C>,
}

impl<T: Scalar, C: Coeff<T>> Centring<T, C> {
    pub(crate) fn new(degree: usize) -> Self {
        let mean = |(k, factor): (usize, T)| {
            let share = factor / T::int(1 << (degree - k));
            binomials::<T>(degree - k).into_iter().map(|count| count * &share).collect()
        };
        let means = binomials(degree).into_iter().enumerate().map(mean).collect();
        Self { means, differences: Vec::with_capacity(degree + 1) }
    }

    /// Replaces the coefficients at `first`, `first + stride`, ... of `coeffs`.
    pub(crate) fn centre(&mut self, coeffs: &mut [C], first: usize, stride: usize) {
        let (order, differences) = (self.means.len(), &mut self.differences);
        differences.clear();
        differences.extend(coeffs[first..].iter().step_by(stride).take(order).cloned());
        for (k, mean) in self.means.iter().enumerate() {
            coeffs[first + k * stride] = weigh(0, mean, differences);
            for i in 1..differences.len() {
                differences[i - 1] = differences[i].minus(&differences[i - 1]);
            }
            differences.pop();
        }
    }
}

/// Refuses coefficients that have left the range of the field, or come so near to its end that a value might.
///
/// With `|s| <= 1/2` the partial sums of Horner's rule are at most twice the largest coefficient, in two directions four times.
pub(crate) fn check_finite<T: Scalar, C: Coeff<T>>(coeffs: &[C]) -> Result<()> {
    let room = T::int(4);
    let fits = |x: &T| (x.clone() * &room).is_finite();
    match coeffs.iter().position(|c| !c.components().all(fits)) {
        Some(index) => Err(Error::NotFinite { what: "coefficient of a power", index }),
        None => Ok(()),
    }
}

/// The value at the local parameter `s`: by Horner's rule, over an exact field by powers, which takes one reduction.
#[inline(always)]
pub(crate) fn value<T: Scalar, C: Coeff<T>>(coeffs: &[C], s: &T) -> C {
    if T::EXACT {
        let next = |power: &T| Some(power.clone() * s);
        let powers: Vec<T> = std::iter::successors(Some(T::one()), next).take(coeffs.len()).collect();
        return weigh(0, &powers, coeffs);
    }
    let [value] = taylor(coeffs.iter(), s);
    value
}

/// Value and derivatives of the orders below `COUNT` with respect to `x`, at the local parameter `s` with slope `ds / dx`.
#[inline(always)]
pub(crate) fn derivatives<const COUNT: usize, T: Scalar, C: Coeff<T>, B: Borrow<C>>(
    coeffs: impl DoubleEndedIterator<Item = B>,
    s: &T,
    slope: &T,
) -> [C; COUNT] {
    let mut sums: [C; COUNT] = taylor(coeffs, s);
    differentiate(&mut sums, slope);
    sums
}

/// [`value`] of at least [`LEAST`] coefficients, without a branch for the lowest.
#[inline(always)]
pub(crate) fn single_value<T: Scalar, C: Coeff<T>>(coeffs: &[C], s: &T) -> C {
    if T::EXACT {
        return value(coeffs, s);
    }
    let [value] = single_taylor(coeffs, s);
    value
}

/// [`derivatives`] of at least [`LEAST`] coefficients, without a branch for the lowest.
#[inline(always)]
pub(crate) fn single_derivatives<const COUNT: usize, T: Scalar, C: Coeff<T>>(
    coeffs: &[C],
    s: &T,
    slope: &T,
) -> [C; COUNT] {
    let mut sums: [C; COUNT] = single_taylor(coeffs, s);
    differentiate(&mut sums, slope);
    sums
}

/// Makes derivatives with respect to `x` of Taylor coefficients in `s`.
///
/// One slope at a time: a power of slopes may leave the range of the field where the derivative does not.
#[inline(always)]
#[allow(
    clippy::needless_range_loop,
    reason = "an iterator would leave the array in memory, and it is on its way to a caller"
)]
fn differentiate<const COUNT: usize, T: Scalar, C: Coeff<T>>(taylor: &mut [C; COUNT], slope: &T) {
    let mut factorial = T::one();
    for d in 1..COUNT {
        if d > 1 {
            factorial *= T::int(d as i64);
            taylor[d].scale(&factorial);
        }
        (0..d).for_each(|_| taylor[d].scale(slope));
    }
}

/// The first `COUNT` Taylor coefficients at `s`.
#[inline(always)]
pub(crate) fn taylor<const COUNT: usize, T: Scalar, C: Coeff<T>, B: Borrow<C>>(
    coeffs: impl DoubleEndedIterator<Item = B>,
    s: &T,
) -> [C; COUNT] {
    let mut descending = coeffs.rev();
    let last = descending.next().expect("a polynomial has a coefficient");
    let last: &C = last.borrow();
    let mut sums = std::array::from_fn(|d| if d == 0 { last.clone() } else { last.zero_like() });
    descending.for_each(|c| horner(&mut sums, s, c.borrow()));
    sums
}

/// The same of at least [`LEAST`] coefficients, the lowest of them without a loop.
#[inline(always)]
fn single_taylor<const COUNT: usize, T: Scalar, C: Coeff<T>>(coeffs: &[C], s: &T) -> [C; COUNT] {
    let (low, high) = coeffs.split_first_chunk::<LEAST>().expect("short pieces are padded");
    let [low @ .., top] = low;
    let mut sums =
        std::array::from_fn(|d| if d == 0 && high.is_empty() { top.clone() } else { top.zero_like() });
    if !high.is_empty() {
        high.iter().rev().chain([top]).for_each(|c| horner(&mut sums, s, c));
    }
    low.iter().rev().for_each(|c| horner(&mut sums, s, c));
    sums
}

/// One step of Horner's rule for Taylor coefficients: the value takes `c` for its next coefficient, each derivative the Taylor
/// coefficient before it.
#[inline(always)]
fn horner<const COUNT: usize, T: Scalar, C: Coeff<T>>(sums: &mut [C; COUNT], s: &T, c: &C) {
    for d in (1..COUNT).rev() {
        sums[d] = sums[d - 1].plus_scaled(s, &sums[d]);
    }
    if let Some(value) = sums.first_mut() {
        *value = c.plus_scaled(s, value);
    }
}
