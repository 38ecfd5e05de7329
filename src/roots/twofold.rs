//! Signs of polynomials at floats by arithmetic with pairs of floats, where that decides.
//!
//! A pair stands for its sum. Sums and products of floats are pairs without error. Those of pairs err by a few units of
//! `2^-106` of the sizes of their terms, so that 32 steps stay far below `2^-90`; after scaling no number but zero is
//! above `2^40`, and what underflow adds stays below `2^-900`.

use crate::bernstein::binomials;
use crate::roots::polynomial::Polynomial;
use std::cmp::Ordering;

/// The highest degree for which the bound of errors holds, and binomial coefficients are exact.
const HIGHEST: usize = 32;

/// A polynomial made ready for signs.
pub(super) struct Twofold {
    a: f64,
    b: f64,
    /// The power of two that makes the interval about as long as one.
    scale: f64,
    /// `C(n, k) c_k`, scaled.
    terms: Vec<Pair>,
}

impl Twofold {
    pub(super) fn new(polynomial: &Polynomial<f64>) -> Option<Self> {
        let ((a, b), c) = (polynomial.domain(), polynomial.coeffs());
        let largest = c.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
        let (scale, shrink) = (inverse_power_of_two(b - a)?, inverse_power_of_two(largest)?);
        let scaled = c.iter().zip(binomials::<f64>(c.len() - 1)).map(|(c, n)| Pair::product(c * shrink, n));
        (c.len() <= HIGHEST + 1).then(|| Self { a: *a, b: *b, scale, terms: scaled.collect() })
    }

    /// The sign at the mean of two neighbouring floats, or at one given twice.
    pub(super) fn sign(&self, x: f64, y: f64) -> Option<Ordering> {
        let half = (y - x) * 0.5;
        let from = |end: f64, sign: f64| {
            let Pair(high, low) = Pair::sum(sign * x, -sign * end);
            let Pair(high, low) = Pair::sum(high, low + sign * half);
            Pair(high * self.scale, low * self.scale)
        };
        let (u, v) = (from(self.a, 1.0), from(self.b, -1.0));
        let (mut sum, mut size, mut power) = (Pair(0.0, 0.0), 0.0, Pair(1.0, 0.0));
        for term in self.terms.iter().rev() {
            let term = term.times(&power);
            sum = sum.times(&u).plus(&term);
            size = size * u.0.abs() + term.0.abs();
            power = power.times(&v);
        }
        let error = size * 2.0_f64.powi(-90) + 2.0_f64.powi(-900);
        let decided = (x == y || half != 0.0) && sum.0.abs() > error && error.is_finite();
        decided.then_some(if sum.0 > 0.0 { Ordering::Greater } else { Ordering::Less })
    }
}

/// Two floats for their sum, the second below the rounding of the first.
struct Pair(f64, f64);

impl Pair {
    /// `x + y` without error.
    fn sum(x: f64, y: f64) -> Self {
        let sum = x + y;
        let part = sum - x;
        Self(sum, (x - (sum - part)) + (y - part))
    }

    /// `x y` without error.
    fn product(x: f64, y: f64) -> Self {
        let product = x * y;
        Self(product, x.mul_add(y, -product))
    }

    fn plus(&self, other: &Self) -> Self {
        let Self(high, low) = Self::sum(self.0, other.0);
        Self::sum(high, low + (self.1 + other.1))
    }

    fn times(&self, other: &Self) -> Self {
        let Self(high, low) = Self::product(self.0, other.0);
        Self::sum(high, low + (self.0 * other.1 + self.1 * other.0))
    }
}

/// A power of two `s` with `1 <= s x < 2`, unless `x` is subnormal or so large that there is none.
fn inverse_power_of_two(x: f64) -> Option<f64> {
    let exponent = (x.to_bits() >> 52) as i64 - 1023;
    let inverse = f64::from_bits(((1023 - exponent) << 52) as u64);
    (x.is_normal() && inverse.is_normal() && x > 0.0).then_some(inverse)
}
