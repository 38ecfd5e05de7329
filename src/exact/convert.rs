//! Exact numbers from and to machine numbers, big fractions and text.

use super::Q;
use super::Repr::{Big, Small};
use super::fraction::Fraction;
use crate::error::{Error, Result};
use num_bigint::{BigInt, BigUint};
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};
use std::fmt;
use std::str::FromStr;

/// How much of a refused text an error repeats.
const ECHO: usize = 64;

impl Q {
    /// The nearest `f64`; of two equally near ones that with the even last bit.
    ///
    /// Numbers beyond the finite range go to the infinities, as IEEE 754 rounds them, and numbers too small for a
    /// subnormal to zero with their sign.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar};
    /// assert_eq!(Q::frac(1, 3).to_f64(), 1.0 / 3.0);
    /// assert_eq!(Q::int(9_007_199_254_740_993).to_f64(), 9_007_199_254_740_992.0);
    /// ```
    pub fn to_f64(&self) -> f64 {
        if let Small { num, den } = self.0
            && [num, den]
                .iter()
                .all(|&n| n == 0 || n.unsigned_abs() >> n.trailing_zeros() < 1 << f64::MANTISSA_DIGITS)
        {
            // Both are exact as f64 and the quotient is not subnormal: one division rounds once.
            return num as f64 / den as f64;
        }
        let (num, den) = self.parts();
        let size = nearest(num.magnitude(), den.magnitude());
        if self.is_negative() { -size } else { size }
    }
}

/// The nearest `f64` to `num / den`, both positive.
fn nearest(num: &BigUint, den: &BigUint) -> f64 {
    const MIN_EXPONENT: i64 = -1074;
    // The quotient in units of 2^unit: at least two bits more than any result keeps.
    let unit = (num.bits() as i64 - den.bits() as i64 - 56).max(MIN_EXPONENT - 2);
    let shift = unit.unsigned_abs();
    let (quotient, rest) = if unit < 0 { (num << shift).div_rem(den) } else { num.div_rem(&(den << shift)) };
    let quotient = quotient.to_u64().expect("a quotient of at most 57 bits");
    let bits = i64::from(u64::BITS - quotient.leading_zeros());
    let exponent = (unit + bits - i64::from(f64::MANTISSA_DIGITS)).max(MIN_EXPONENT);
    if exponent > i64::from(f64::MAX_EXP) {
        return f64::INFINITY;
    }
    let dropped = exponent - unit;
    let (mantissa, tail) = (quotient >> dropped, quotient & ((1 << dropped) - 1));
    let half = 1 << (dropped - 1);
    let up = tail > half || tail == half && (!rest.is_zero() || mantissa.is_odd());
    let mantissa = mantissa + u64::from(up);
    // The hidden bit adds itself to the exponent, and so does a carry, up to the pattern of infinity.
    let pattern = (((exponent - MIN_EXPONENT) as u64) << (f64::MANTISSA_DIGITS - 1)) + mantissa;
    f64::from_bits(pattern.min(f64::INFINITY.to_bits()))
}

impl TryFrom<f64> for Q {
    type Error = Error;

    /// The number that `x` stands for, without loss. Both zeros become zero.
    ///
    /// # Errors
    /// [`Error::NotFinite`] if `x` is NaN or infinite.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar};
    /// assert_eq!(Q::try_from(-0.75)?, Q::frac(-3, 4));
    /// assert_ne!(Q::try_from(0.1)?, Q::frac(1, 10));
    /// assert!(Q::try_from(f64::NAN).is_err());
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn try_from(x: f64) -> Result<Self> {
        if !x.is_finite() {
            return Err(Error::NotFinite { what: "value", index: 0 });
        }
        if x == 0.0 {
            return Ok(Self::zero());
        }
        let (digits, exponent, sign) = num_traits::float::FloatCore::integer_decode(x);
        let twos = digits.trailing_zeros();
        let num = (digits >> twos) as i64 * i64::from(sign);
        let exponent = i32::from(exponent) + twos as i32;
        let power = || BigInt::one() << exponent.unsigned_abs();
        Ok(match exponent {
            0.. => Self::from(power() * num),
            -62..0 => Self(Small { num, den: 1 << -exponent }),
            _ => Self(Big(Box::new(Fraction { num: num.into(), den: power() }))),
        })
    }
}

impl From<i64> for Q {
    #[inline]
    fn from(n: i64) -> Self {
        Self::coprime(n.into(), 1)
    }
}

impl From<i32> for Q {
    #[inline]
    fn from(n: i32) -> Self {
        i64::from(n).into()
    }
}

impl From<BigInt> for Q {
    fn from(n: BigInt) -> Self {
        Fraction { num: n, den: BigInt::one() }.into()
    }
}

impl From<BigRational> for Q {
    /// The same number, in lowest terms even if `r` is not.
    ///
    /// # Panics
    /// If the denominator is zero, which only `BigRational::new_raw` can make.
    fn from(r: BigRational) -> Self {
        let (num, den) = r.into_raw();
        assert!(!den.is_zero(), "a fraction with denominator zero");
        Fraction::reduced(num, den).into()
    }
}

impl From<Q> for BigRational {
    fn from(q: Q) -> Self {
        let f = Fraction::from(q);
        Self::new_raw(f.num, f.den)
    }
}

impl FromStr for Q {
    type Err = Error;

    /// Reads `p`, `p/q` or a decimal such as `0.25`, exactly, with at most one sign in front and no blanks.
    ///
    /// # Errors
    /// [`Error::NotANumber`] with the start of the text and the reason.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar};
    /// assert_eq!("-6/4".parse::<Q>()?, Q::frac(-3, 2));
    /// assert_eq!("+1.50".parse::<Q>()?, Q::frac(3, 2));
    /// assert!("1/0".parse::<Q>().is_err() && "1e5".parse::<Q>().is_err());
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn from_str(text: &str) -> Result<Self> {
        fraction(text).map_err(|reason| Error::NotANumber { text: text.chars().take(ECHO).collect(), reason })
    }
}

fn fraction(text: &str) -> std::result::Result<Q, &'static str> {
    if text.is_empty() {
        return Err("the text is empty");
    }
    let size = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (num, den) = if let Some((p, q)) = size.split_once('/') {
        (natural(p)?, natural(q)?)
    } else if let Some((whole, part)) = size.split_once('.') {
        let unit = num_traits::pow(BigInt::from(10), part.len());
        (natural(whole)? * &unit + natural(part)?, unit)
    } else {
        (natural(size)?, BigInt::one())
    };
    if den.is_zero() {
        return Err("the denominator is zero");
    }
    Ok(Fraction::reduced(if text.starts_with('-') { -num } else { num }, den).into())
}

fn natural(digits: &str) -> std::result::Result<BigInt, &'static str> {
    if digits.is_empty() {
        return Err("digits are missing");
    }
    // BigInt would accept more than digits: a sign, underscores.
    if !digits.bytes().all(|b| b.is_ascii_digit()) {
        return Err("a character is not a digit");
    }
    BigInt::parse_bytes(digits.as_bytes(), 10).ok_or("a character is not a digit")
}

impl fmt::Display for Q {
    /// Writes `p` or `p/q`; width, fill and sign are heeded, a precision is not.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (num, den) = self.parts();
        let (num, den) = (num.magnitude(), den.magnitude());
        let size = if den.is_one() { num.to_string() } else { format!("{num}/{den}") };
        f.pad_integral(!self.is_negative(), "", &size)
    }
}

impl fmt::Debug for Q {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{check, rational};
    use super::*;
    use num_traits::Signed;
    use proptest::prelude::*;

    /// What `x` stands for; the infinities as the powers of two that would follow the greatest `f64`.
    fn image(x: f64) -> BigRational {
        let infinity = || BigRational::from(BigInt::one() << 1024);
        BigRational::from_float(x).unwrap_or_else(|| if x > 0.0 { infinity() } else { -infinity() })
    }

    fn is_nearest(x: f64, r: &BigRational) -> bool {
        let distance = |y: f64| (r - image(y)).abs();
        let even = x.to_bits().is_multiple_of(2);
        let beats = |y: f64| distance(x) < distance(y) || distance(x) == distance(y) && even;
        // Beyond the range an infinity has no rival but the greatest f64.
        let far =
            x.is_infinite() && r.abs() >= image(f64::INFINITY) && x.is_sign_negative() == r.is_negative();
        far || beats(x.next_up())
            && beats(x.next_down())
            && (x != 0.0 || x.is_sign_negative() == r.is_negative())
    }

    fn finite() -> impl Strategy<Value = f64> {
        let subnormal = (0..1u64 << 53).prop_map(f64::from_bits);
        let edge = prop::sample::select(vec![0.0, 5e-324, f64::MIN_POSITIVE, 1.0, f64::MAX]);
        let normal = any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite());
        (prop_oneof![1 => subnormal, 1 => edge, 4 => normal], any::<bool>())
            .prop_map(|(x, s)| if s { -x } else { x })
    }

    /// Points halfway between two neighbours, and points just beside them.
    fn halfway() -> impl Strategy<Value = BigRational> {
        (finite(), -1..=1i64, 1080..2200usize, prop_oneof![Just(1i64), Just(3), any::<i64>()]).prop_map(
            |(x, side, depth, odd)| {
                let nudge = BigRational::new(side.into(), BigInt::from(odd | 1).abs() << depth);
                (image(x) + image(x.next_up())) / BigInt::from(2) + nudge
            },
        )
    }

    proptest! {
        #[test]
        fn every_f64_comes_back(x in finite()) {
            let q = Q::try_from(x).unwrap();
            check(&q, &image(x));
            prop_assert_eq!(q.to_f64().to_bits(), if x == 0.0 { 0 } else { x.to_bits() });
        }

        #[test]
        fn conversion_rounds_to_nearest_even(r in prop_oneof![rational(), halfway()]) {
            let x = Q::from(r.clone()).to_f64();
            prop_assert!(is_nearest(x, &r), "{x:e} for {r}");
        }

        #[test]
        fn quotients_of_words_round_once(p: i64, q in 1..=i64::MAX, j in 0..63u32, k in 0..63u32) {
            let (p, q) = (p >> j, (q >> k).max(1));
            prop_assert!(is_nearest(Q::new(p, q).unwrap().to_f64(), &BigRational::new(p.into(), q.into())));
        }

        #[test]
        fn extreme_quotients_round_once(r in rational(), k in -2400..2400i32) {
            let power = BigRational::from(BigInt::one() << k.unsigned_abs());
            let r = if k < 0 { r / power } else { r * power };
            prop_assert!(is_nearest(Q::from(r.clone()).to_f64(), &r));
        }

        #[test]
        fn text_comes_back(r in rational()) {
            let q = Q::from(r.clone());
            prop_assert_eq!(q.to_string(), r.to_string());
            prop_assert_eq!(format!("{:?}", q), r.to_string());
            prop_assert_eq!(&r.to_string().parse::<Q>().unwrap(), &q);
            prop_assert_eq!(BigRational::from(q), r);
        }

        #[test]
        fn decimals_are_exact(n: u64, places in 1..30usize, minus: bool) {
            let digits = format!("{n:030}");
            let (whole, part) = digits.split_at(digits.len() - places);
            let sign = if minus { -1 } else { 1 };
            let text = format!("{}{}.{part}", if minus { "-" } else { "+" }, if whole.is_empty() { "0" } else { whole });
            let value = BigRational::new(BigInt::from(n) * sign, BigInt::from(10).pow(places as u32));
            check(&text.parse().unwrap(), &value);
        }

        #[test]
        fn junk_never_panics(text in "[-+./0-9_ e]{0,9}|\\PC{0,9}") {
            if let Ok(q) = text.parse::<Q>() {
                prop_assert_eq!(q.to_string().parse::<Q>(), Ok(q));
            }
        }
    }

    #[test]
    fn junk_is_refused_with_a_reason() {
        let reason = |text: &str| match text.parse::<Q>() {
            Err(Error::NotANumber { reason, .. }) => reason,
            other => panic!("{text}: {other:?}"),
        };
        assert_eq!(reason(""), "the text is empty");
        for text in ["-", "+", "/", "1/", "/2", ".", ".5", "5."] {
            assert_eq!(reason(text), "digits are missing");
        }
        for text in ["1/0", "-0/00"] {
            assert_eq!(reason(text), "the denominator is zero");
        }
        for text in [
            "--1", "1/-2", " 1", "1 ", "1_0", "1e5", "0x1", "nan", "1/2/3", "1.5/2", "1.2.3", "1.-5", "٣",
            "−1",
        ] {
            assert_eq!(reason(text), "a character is not a digit");
        }
    }

    #[test]
    fn a_long_text_is_cut_in_the_error() {
        let Err(Error::NotANumber { text, .. }) = "ä".repeat(1000).parse::<Q>() else { panic!("refused") };
        assert_eq!(text, "ä".repeat(ECHO));
    }

    #[test]
    fn only_finite_numbers_are_numbers() {
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(Q::try_from(x), Err(Error::NotFinite { what: "value", index: 0 }));
        }
    }

    #[test]
    fn raw_fractions_are_reduced() {
        let raw = |p: i64, q: i64| Q::from(BigRational::new_raw(p.into(), q.into()));
        assert_eq!((raw(6, -4), raw(0, -7)), (Q::new(-3, 2).unwrap(), Q::zero()));
    }

    #[test]
    #[should_panic(expected = "denominator zero")]
    fn a_raw_fraction_over_zero_is_refused() {
        let _ = Q::from(BigRational::new_raw(1.into(), 0.into()));
    }

    #[test]
    fn width_and_sign_are_heeded() {
        let q = Q::new(-1, 2).unwrap();
        assert_eq!(format!("{q:>6}|{q:<6}|{:+}|{:.1}", -&q, q), "  -1/2|-1/2  |+1/2|-1/2");
    }
}
