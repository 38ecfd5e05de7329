//! Exact rational numbers.
//!
//! A [`Q`] is a fraction in lowest terms with a positive denominator. It lives in two machine words while numerator and
//! denominator stay below `2^63`, and in two big integers beyond. Each value has exactly one form, so equality and
//! hashing are those of the form.
//!
//! Arithmetic reduces by a few gcds of small numbers, and the lossless image of an `f64`, which has a power of two below,
//! by none at all: there a gcd is a count of trailing zeros.

mod gcd;
mod fraction;
mod arithmetic;
mod convert;
mod window;
mod dot;
mod divide;
mod polar;
mod modular;
pub(crate) mod coprime;
mod reconstruct;
mod lift;
mod solve;
mod root;

use crate::error::{Error, Result};
use crate::scalar::Scalar;
use fraction::Fraction;
use nalgebra::DMatrix;
use num_bigint::BigInt;
use num_traits::{One, ToPrimitive, Zero};
use std::borrow::Cow;
use std::cmp::Ordering;

/// An exact rational number of any size.
///
/// A value is always in lowest terms with a positive denominator. While both parts stay below `2^63` in magnitude, a
/// value takes no memory on the heap.
///
/// # Examples
/// ```
/// use symspline::{Q, Scalar};
/// let third = Q::frac(1, 3);
/// assert_eq!(&third + &third + &third, Q::int(1));
/// assert_eq!((third * Q::int(-2)).to_string(), "-2/3");
/// assert_eq!("0.125".parse::<Q>()?, Q::frac(1, 8));
/// assert_eq!(Q::try_from(0.1)?.to_f64(), 0.1);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Q(Repr);

/// `Small` if and only if numerator and denominator are at most `i64::MAX` in magnitude: then a sign or a reciprocal
/// never overflows. The denominator is positive and coprime to the numerator in both forms.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Repr {
    Small { num: i64, den: i64 },
    Big(Box<Fraction>),
}
use Repr::{Big, Small};

impl Q {
    /// The fraction `p / q` in lowest terms.
    ///
    /// # Errors
    /// [`Error::NotANumber`] if `q` is zero.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar};
    /// assert_eq!(Q::new(6, -4)?, Q::frac(-3, 2));
    /// assert!(Q::new(1, 0).is_err());
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn new(p: i64, q: i64) -> Result<Self> {
        if q == 0 {
            return Err(Error::NotANumber { text: format!("{p}/{q}"), reason: "the denominator is zero" });
        }
        let (p, q) = (i128::from(p) * i128::from(q.signum()), i128::from(q).abs());
        let g = num_integer::gcd(p, q);
        Ok(Self::coprime(p / g, q / g))
    }

    /// The numerator, which carries the sign.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar};
    /// assert_eq!(Q::frac(6, -4).numer(), (-3).into());
    /// ```
    pub fn numer(&self) -> BigInt {
        self.parts().0.into_owned()
    }

    /// The denominator, which is positive.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar};
    /// assert_eq!(Q::frac(6, -4).denom(), 2.into());
    /// ```
    pub fn denom(&self) -> BigInt {
        self.parts().1.into_owned()
    }

    /// Whether the denominator is one.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar};
    /// assert!(Q::frac(6, 3).is_integer() && !Q::frac(1, 3).is_integer());
    /// ```
    pub fn is_integer(&self) -> bool {
        match &self.0 {
            Small { den, .. } => *den == 1,
            Big(f) => f.den.is_one(),
        }
    }

    /// Whether the number is less than zero.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar};
    /// assert!(Q::frac(1, -3).is_negative() && !Q::int(0).is_negative());
    /// ```
    pub fn is_negative(&self) -> bool {
        match &self.0 {
            Small { num, .. } => *num < 0,
            Big(f) => f.num.sign() == num_bigint::Sign::Minus,
        }
    }

    /// The absolute value.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar};
    /// assert_eq!(Q::frac(-1, 3).abs(), Q::frac(1, 3));
    /// ```
    pub fn abs(&self) -> Self {
        if self.is_negative() { -self } else { self.clone() }
    }

    /// The reciprocal `1 / self`.
    ///
    /// # Panics
    /// If the number is zero.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar};
    /// assert_eq!(Q::frac(-2, 3).recip(), Q::frac(-3, 2));
    /// ```
    pub fn recip(&self) -> Self {
        Self::one() / self
    }

    /// The size in bits: of the magnitude of the numerator and of the denominator together.
    ///
    /// Reports of how exact numbers grow use it.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar};
    /// assert_eq!(Q::frac(-5, 8).bits(), 3 + 4);
    /// ```
    pub fn bits(&self) -> u64 {
        match &self.0 {
            Small { num, den } => u64::from(128 - num.unsigned_abs().leading_zeros() - den.leading_zeros()),
            Big(f) => f.num.bits() + f.den.bits(),
        }
    }

    /// The fraction of two coprime numbers, the second one positive.
    #[inline]
    fn coprime(num: i128, den: i128) -> Self {
        match (i64::try_from(num), i64::try_from(den)) {
            (Ok(num), Ok(den)) if num != i64::MIN => Self(Small { num, den }),
            _ => Self(Big(Box::new(Fraction { num: num.into(), den: den.into() }))),
        }
    }

    /// Numerator and denominator as big integers.
    fn parts(&self) -> (Cow<'_, BigInt>, Cow<'_, BigInt>) {
        match &self.0 {
            Small { num, den } => (Cow::Owned((*num).into()), Cow::Owned((*den).into())),
            Big(f) => (Cow::Borrowed(&f.num), Cow::Borrowed(&f.den)),
        }
    }
}

impl From<Fraction> for Q {
    /// Demotes what fits in words; the fraction is in lowest terms already.
    fn from(f: Fraction) -> Self {
        match (f.num.to_i64(), f.den.to_i64()) {
            (Some(num), Some(den)) if num != i64::MIN => Self(Small { num, den }),
            _ => Self(Big(Box::new(f))),
        }
    }
}

impl From<Q> for Fraction {
    fn from(q: Q) -> Self {
        match q.0 {
            Small { num, den } => Self { num: num.into(), den: den.into() },
            Big(f) => *f,
        }
    }
}

impl Scalar for Q {
    const EXACT: bool = true;

    #[inline]
    fn int(n: i64) -> Self {
        n.into()
    }

    fn frac(p: i64, q: i64) -> Self {
        Self::new(p, q).expect("the denominator of a fraction is not zero")
    }

    fn magnitude(&self) -> Self {
        self.abs()
    }

    fn root_above(&self) -> Self {
        root::root_above(self)
    }

    fn dot<'a>(pairs: impl Iterator<Item = (&'a Self, &'a Self)>) -> Self {
        dot::dot(pairs)
    }

    fn clear<'a>(values: impl Iterator<Item = &'a Self>) -> Option<Self> {
        divide::common_denominator(values)
    }

    fn primitive<'a>(values: impl Iterator<Item = &'a Self>) -> Option<Self> {
        divide::primitive(values)
    }

    fn divide(values: &mut [Self], divisor: &Self) {
        divide::divide(values, divisor);
    }

    fn solve(matrix: &DMatrix<Self>, right: &DMatrix<Self>) -> Option<Result<DMatrix<Self>>> {
        (matrix.nrows() >= solve::LEAST).then(|| solve::solve(matrix, right))
    }

    fn whole_blossom<'a>(
        t: &'a [Self],
        lo: usize,
        hi: usize,
        arg: &impl Fn(usize) -> &'a Self,
        weights: &mut [Self],
    ) -> Option<Self> {
        polar::blossom(t, lo, hi, arg, weights)
    }
}

impl Zero for Q {
    #[inline]
    fn zero() -> Self {
        Self(Small { num: 0, den: 1 })
    }

    #[inline]
    fn is_zero(&self) -> bool {
        matches!(self.0, Small { num: 0, .. })
    }
}

impl One for Q {
    #[inline]
    fn one() -> Self {
        Self(Small { num: 1, den: 1 })
    }
}

impl Default for Q {
    /// Zero.
    fn default() -> Self {
        Self::zero()
    }
}

impl PartialOrd for Q {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Q {
    fn cmp(&self, other: &Self) -> Ordering {
        match (&self.0, &other.0) {
            (&Small { num: a, den: b }, &Small { num: c, den: d }) => {
                (i128::from(a) * i128::from(d)).cmp(&(i128::from(c) * i128::from(b)))
            }
            _ => {
                let ((a, b), (c, d)) = (self.parts(), other.parts());
                a.sign().cmp(&c.sign()).then_with(|| (&*a * &*d).cmp(&(&*c * &*b)))
            }
        }
    }
}

#[cfg(test)]
mod tests;
