//! The signs `+ - * /` between exact numbers.
//!
//! The arithmetic divides by common factors *before* it multiplies, which keeps every intermediate number small:
//!
//! ```text
//! a/b · c/d = (a/g · c/h) / (b/h · d/g)         g = gcd(a, d), h = gcd(c, b)
//! a/b + c/d = (t/h) / (b/g · d/h)               g = gcd(b, d), t = a · d/g + c · b/g, h = gcd(t, g)
//! ```
//!
//! Both right-hand sides are in lowest terms when the operands are. Words are multiplied in 128 bits and cannot overflow.

use super::Q;
use super::Repr::{Big, Small};
use super::fraction::Fraction;
use super::gcd::word_gcd;
use num_traits::{One, Zero};
use std::iter::{Product, Sum};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// The four forms of an operator, by value and by reference, and the two of its assignment.
macro_rules! operators {
    ($($Op:ident $op:ident $OpAssign:ident $op_assign:ident $map:ident $doc:literal)*) => {$(
        impl $Op<&Q> for &Q {
            type Output = Q;
            #[doc = $doc]
            #[inline]
            fn $op(self, other: &Q) -> Q {
                $map(self, other)
            }
        }
        impl $Op<Q> for &Q {
            type Output = Q;
            #[doc = $doc]
            #[inline]
            fn $op(self, other: Q) -> Q {
                $map(self, &other)
            }
        }
        impl $Op<&Q> for Q {
            type Output = Q;
            #[doc = $doc]
            #[inline]
            fn $op(self, other: &Q) -> Q {
                $map(&self, other)
            }
        }
        impl $Op<Q> for Q {
            type Output = Q;
            #[doc = $doc]
            #[inline]
            fn $op(self, other: Q) -> Q {
                $map(&self, &other)
            }
        }
        impl $OpAssign<&Q> for Q {
            #[doc = $doc]
            #[inline]
            fn $op_assign(&mut self, other: &Q) {
                *self = $map(self, other);
            }
        }
        impl $OpAssign<Q> for Q {
            #[doc = $doc]
            #[inline]
            fn $op_assign(&mut self, other: Q) {
                *self = $map(self, &other);
            }
        }
    )*};
}

operators! {
    Add add AddAssign add_assign sum "The exact sum."
    Sub sub SubAssign sub_assign difference "The exact difference."
    Mul mul MulAssign mul_assign product "The exact product."
    Div div DivAssign div_assign quotient "The exact quotient.\n\n# Panics\nIf the divisor is zero."
}

impl Neg for Q {
    type Output = Self;

    fn neg(self) -> Self {
        match self.0 {
            Small { num, den } => Self(Small { num: -num, den }),
            Big(mut f) => {
                f.num = -std::mem::take(&mut f.num);
                Self(Big(f))
            }
        }
    }
}

impl Neg for &Q {
    type Output = Q;

    fn neg(self) -> Q {
        -self.clone()
    }
}

impl Sum for Q {
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        terms.fold(Self::zero(), Add::add)
    }
}

impl<'a> Sum<&'a Self> for Q {
    fn sum<I: Iterator<Item = &'a Self>>(terms: I) -> Self {
        terms.fold(Self::zero(), Add::add)
    }
}

impl Product for Q {
    fn product<I: Iterator<Item = Self>>(factors: I) -> Self {
        factors.fold(Self::one(), Mul::mul)
    }
}

impl<'a> Product<&'a Self> for Q {
    fn product<I: Iterator<Item = &'a Self>>(factors: I) -> Self {
        factors.fold(Self::one(), Mul::mul)
    }
}

#[inline]
fn sum(x: &Q, y: &Q) -> Q {
    match (&x.0, &y.0) {
        (&Small { num: a, den: b }, &Small { num: c, den: d }) => small_sum(a, b, c, d),
        _ => big_sum(x, y, false),
    }
}

#[inline]
fn difference(x: &Q, y: &Q) -> Q {
    match (&x.0, &y.0) {
        (&Small { num: a, den: b }, &Small { num: c, den: d }) => small_sum(a, b, -c, d),
        _ => big_sum(x, y, true),
    }
}

#[inline]
fn product(x: &Q, y: &Q) -> Q {
    match (&x.0, &y.0) {
        (&Small { num: a, den: b }, &Small { num: c, den: d }) => small_product(a, b, c, d),
        _ => {
            let ((a, b), (c, d)) = (x.parts(), y.parts());
            Fraction::product(&a, &b, &c, &d).into()
        }
    }
}

#[inline]
fn quotient(x: &Q, y: &Q) -> Q {
    assert!(!y.is_zero(), "division of a rational number by zero");
    match (&x.0, &y.0) {
        (&Small { num: a, den: b }, &Small { num: c, den: d }) => {
            small_product(a, b, d * c.signum(), c.abs())
        }
        _ => {
            let ((a, b), (c, d)) = (x.parts(), y.parts());
            Fraction::product(&a, &b, &d, &c).into()
        }
    }
}

#[inline]
fn small_sum(a: i64, b: i64, c: i64, d: i64) -> Q {
    let [wide_a, wide_b, wide_c, wide_d] = [a, b, c, d].map(i128::from);
    if b == d {
        let t = wide_a + wide_c;
        // The sum may take 65 bits, its remainder fits in a word again.
        let g = if b == 1 { 1 } else { word_gcd((t % wide_b) as i64, b) };
        return if g == 1 { Q::coprime(t, wide_b) } else { Q::coprime(t / i128::from(g), (b / g).into()) };
    }
    let g = word_gcd(b, d);
    if g == 1 {
        return Q::coprime(wide_a * wide_d + wide_c * wide_b, wide_b * wide_d);
    }
    let t = wide_a * i128::from(d / g) + wide_c * i128::from(b / g);
    let h = word_gcd((t % i128::from(g)) as i64, g);
    Q::coprime(t / i128::from(h), i128::from(b / g) * i128::from(d / h))
}

#[inline]
fn small_product(a: i64, b: i64, c: i64, d: i64) -> Q {
    let (g, h) = (word_gcd(a, d), word_gcd(c, b));
    Q::coprime(i128::from(a / g) * i128::from(c / h), i128::from(b / h) * i128::from(d / g))
}

fn big_sum(x: &Q, y: &Q, minus: bool) -> Q {
    let ((a, b), (c, d)) = (x.parts(), y.parts());
    Fraction::sum(&a, &b, &c, &d, minus).into()
}
