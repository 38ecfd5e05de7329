//! Fractions of big integers, reduced before they grow.
//!
//! The formulas are those of [`arithmetic`](super::arithmetic). Where a factor is a power of two, a shift replaces the
//! product or the quotient.

use super::gcd::{gcd, power_of_two};
use num_bigint::BigInt;
use num_traits::{One, Signed};
use std::borrow::Cow;

/// A fraction in lowest terms with a positive denominator.
#[derive(Clone, PartialEq, Eq, Hash)]
pub(super) struct Fraction {
    pub(super) num: BigInt,
    pub(super) den: BigInt,
}

impl Fraction {
    /// The fraction `p / q` for any two numbers, `q` not zero.
    pub(super) fn reduced(p: BigInt, q: BigInt) -> Self {
        let g = gcd(&p, &q);
        Self { num: cancelled(p, &g), den: cancelled(q, &g) }.upright()
    }

    /// The sum `a/b + c/d`, or the difference, of fractions in lowest terms.
    pub(super) fn sum(a: &BigInt, b: &BigInt, c: &BigInt, d: &BigInt, minus: bool) -> Self {
        let g = gcd(b, d);
        let (b_rest, d_rest) = (divided(b, &g), divided(d, &g));
        let (x, y) = (times(a, &d_rest), times(c, &b_rest));
        let t = if minus { x.as_ref() - y.as_ref() } else { x.as_ref() + y.as_ref() };
        let h = gcd(&t, &g);
        Self { num: cancelled(t, &h), den: times(&b_rest, &divided(d, &h)).into_owned() }
    }

    /// The product `a/b · c/d` of fractions in lowest terms; `d` may be negative, which serves the quotient.
    pub(super) fn product(a: &BigInt, b: &BigInt, c: &BigInt, d: &BigInt) -> Self {
        let (g, h) = (gcd(a, d), gcd(c, b));
        let num = times(&divided(a, &g), &divided(c, &h)).into_owned();
        Self { num, den: times(&divided(b, &h), &divided(d, &g)).into_owned() }.upright()
    }

    fn upright(self) -> Self {
        if self.den.is_negative() { Self { num: -self.num, den: -self.den } } else { self }
    }
}

/// The exact quotient by a divisor `g > 0` of `x`.
pub(super) fn divided<'a>(x: &'a BigInt, g: &BigInt) -> Cow<'a, BigInt> {
    match power_of_two(g) {
        Some(0) => Cow::Borrowed(x),
        Some(k) => Cow::Owned(x >> k),
        None => Cow::Owned(x / g),
    }
}

/// The same of a number that nobody else needs.
pub(super) fn cancelled(x: BigInt, g: &BigInt) -> BigInt {
    if g.is_one() { x } else { divided(&x, g).into_owned() }
}

/// The product, where `y` is often one or another power of two.
fn times<'a>(x: &'a BigInt, y: &BigInt) -> Cow<'a, BigInt> {
    match power_of_two(y) {
        Some(0) if y.is_positive() => Cow::Borrowed(x),
        Some(k) if y.is_positive() => Cow::Owned(x << k),
        _ => Cow::Owned(x * y),
    }
}
