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
    binomials: Vec<T>,
    half: T,
    differences: Vec<C>,
    means: Vec<C>,
}

impl<T: Scalar, C: Coeff<T>> Centring<T, C> {
    pub(crate) fn new(degree: usize) -> Self {
        Self { binomials: binomials(degree), half: T::frac(1, 2), differences: Vec::new(), means: Vec::new() }
    }

    /// Replaces the coefficients at `first`, `first + stride`, ... of `coeffs`.
    pub(crate) fn centre(&mut self, coeffs: &mut [C], first: usize, stride: usize) {
        let (p, half) = (self.binomials.len() - 1, &self.half);
        let place = |k: usize| first + k * stride;
        let (differences, means) = (&mut self.differences, &mut self.means);
        differences.clear();
        differences.extend((0..=p).map(|k| coeffs[place(k)].clone()));
        for (k, binomial) in self.binomials.iter().enumerate() {
            means.clone_from(differences);
            for count in (1..differences.len()).rev() {
                for i in 0..count {
                    means[i] = means[i].scaled(half).plus_scaled(half, &means[i + 1]);
                }
            }
            coeffs[place(k)] = means[0].scaled(binomial);
            for i in 1..differences.len() {
                differences[i - 1] = differences[i].minus(&differences[i - 1]);
            }
            differences.pop();
        }
    }
}

/// Refuses coefficients that have left the range of the field.
pub(crate) fn check_finite<T: Scalar, C: Coeff<T>>(coeffs: &[C]) -> Result<()> {
    match coeffs.iter().position(|c| !c.all_finite()) {
        Some(index) => Err(Error::NotFinite { what: "coefficient of a power", index }),
        None => Ok(()),
    }
}

/// What `f` makes of `coeffs`, their number known to the compiler for low degrees.
#[inline(always)]
pub(crate) fn unrolled<C, R>(coeffs: &[C], f: impl Fn(&[C]) -> R) -> R {
    match coeffs.len() {
        2 => f(&coeffs[..2]),
        3 => f(&coeffs[..3]),
        4 => f(&coeffs[..4]),
        5 => f(&coeffs[..5]),
        6 => f(&coeffs[..6]),
        _ => f(coeffs),
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
    let mut factor = T::one();
    for (d, sum) in sums.iter_mut().enumerate().skip(1) {
        factor = factor * slope * T::int(d as i64);
        sum.scale(&factor);
    }
    sums
}

/// The first `COUNT` Taylor coefficients at `s`: Horner's rule, where each takes the one before for its next coefficient.
#[inline(always)]
fn taylor<const COUNT: usize, T: Scalar, C: Coeff<T>, B: Borrow<C>>(
    coeffs: impl DoubleEndedIterator<Item = B>,
    s: &T,
) -> [C; COUNT] {
    let one = T::one();
    let mut descending = coeffs.rev();
    let last = descending.next().expect("a polynomial has a coefficient");
    let last: &C = last.borrow();
    let mut sums: [C; COUNT] = std::array::from_fn(|d| if d == 0 { last.clone() } else { last.zero_like() });
    for c in descending {
        for d in (1..COUNT).rev() {
            let (low, high) = sums.split_at_mut(d);
            high[0].scale(s);
            high[0].add_scaled(&one, &low[d - 1]);
        }
        if let Some(value) = sums.first_mut() {
            value.scale(s);
            value.add_scaled(&one, c.borrow());
        }
    }
    sums
}
