//! Greatest common divisors, the dearest operation of exact arithmetic.
//!
//! [`gcd`] looks first for what makes it cheap: a power of two, a number of at most 128 bits, numbers of different
//! length. What remains goes by Lehmer's method: the leading words of two numbers foretell a run of quotients of
//! Euclid's algorithm, and the whole run is applied to the long numbers at once.

use num_bigint::{BigInt, BigUint};
use num_traits::{One, ToPrimitive};

/// The greatest common divisor of words, positive; not both are zero and neither is `i64::MIN`.
#[inline]
pub(super) fn word_gcd(a: i64, b: i64) -> i64 {
    let (a, b) = (a.unsigned_abs(), b.unsigned_abs());
    if a == 1 || b == 1 {
        return 1;
    }
    if a == 0 || b == 0 {
        return (a | b) as i64;
    }
    let twos = (a | b).trailing_zeros();
    (odd_gcd(a >> a.trailing_zeros(), b >> b.trailing_zeros()) << twos) as i64
}

/// The greatest common divisor of odd numbers.
#[inline]
fn odd_gcd(mut a: u64, mut b: u64) -> u64 {
    // No branch but the last: the processor cannot foresee which of the two is greater.
    while a != b {
        let gap = a.abs_diff(b);
        b = a.min(b);
        a = gap >> gap.trailing_zeros();
    }
    a
}

/// The greatest common divisor of double words, neither of them zero.
fn wide_gcd(mut a: u128, mut b: u128) -> u128 {
    let twos = (a | b).trailing_zeros();
    a >>= a.trailing_zeros();
    b >>= b.trailing_zeros();
    while a != b {
        if let (Ok(a), Ok(b)) = (u64::try_from(a), u64::try_from(b)) {
            return u128::from(odd_gcd(a, b)) << twos;
        }
        let gap = a.abs_diff(b);
        b = a.min(b);
        a = gap >> gap.trailing_zeros();
    }
    a << twos
}

/// The greatest common divisor, positive; not both numbers are zero.
pub(super) fn gcd(a: &BigInt, b: &BigInt) -> BigInt {
    if let Some(k) = power_of_two(a).or_else(|| power_of_two(b)) {
        // Zero has no trailing zeros to count, and every power of two divides it.
        let twos = |x: &BigInt| x.trailing_zeros().unwrap_or(k);
        return BigInt::one() << twos(a).min(twos(b));
    }
    let (a, b) = (a.magnitude(), b.magnitude());
    if a >= b { ordered_gcd(a, b).into() } else { ordered_gcd(b, a).into() }
}

/// The exponent `k` of `x = ±2^k`.
pub(super) fn power_of_two(x: &BigInt) -> Option<u64> {
    x.trailing_zeros().filter(|k| x.bits() == k + 1)
}

/// The greatest common divisor of `x >= y`.
fn ordered_gcd(x: &BigUint, y: &BigUint) -> BigUint {
    let Some(word) = y.to_u128() else { return long_gcd(x, y) };
    if word == 0 {
        return x.clone();
    }
    match (x % y).to_u128().expect("a remainder is less than its divisor") {
        0 => y.clone(),
        rest => wide_gcd(word, rest).into(),
    }
}

/// The same where `y` is longer than a double word.
fn long_gcd(x: &BigUint, y: &BigUint) -> BigUint {
    let (mut x, mut y) = (x.to_u64_digits(), y.to_u64_digits());
    while y.len() > 1 {
        let near = x.len() <= y.len() + 1;
        match if near { foretold(&x, &y) } else { None } {
            Some(run) => apply(run, &mut x, &mut y),
            None => {
                let rest = number(&x) % number(&y);
                (x, y) = (y, rest.to_u64_digits());
            }
        }
    }
    match y.first() {
        None => number(&x),
        Some(&word) => match remainder(&x, word) {
            0 => word.into(),
            rest => short_gcd(word, rest).into(),
        },
    }
}

/// The greatest common divisor of words that are not zero.
fn short_gcd(a: u64, b: u64) -> u64 {
    odd_gcd(a >> a.trailing_zeros(), b >> b.trailing_zeros()) << (a | b).trailing_zeros()
}

fn remainder(x: &[u64], word: u64) -> u64 {
    x.iter()
        .rev()
        .fold(0, |rest, digit| ((u128::from(rest) << 64 | u128::from(*digit)) % u128::from(word)) as u64)
}

pub(super) fn number(words: &[u64]) -> BigUint {
    BigUint::new(words.iter().flat_map(|&w| [w as u32, (w >> 32) as u32]).collect())
}

/// Some steps of Euclid's algorithm at once: the new numbers are `±(a x - b y)` and `±(d y - c x)`.
pub(super) struct Run {
    pub(super) factors: [[u64; 2]; 2],
    /// Whether the first of the new numbers has the sign `+`; the second one has the same.
    pub(super) even: bool,
}

/// Puts the remainders in the place of the numbers; there are no zeros at their ends.
pub(super) fn apply(run: Run, x: &mut Vec<u64>, y: &mut Vec<u64>) {
    let signed = |n: u64, plus: bool| if plus { i128::from(n) } else { -i128::from(n) };
    let [[a, b], [c, d]] = run.factors;
    let (a, b) = (signed(a, run.even), signed(b, !run.even));
    let (c, d) = (signed(c, !run.even), signed(d, run.even));
    y.resize(x.len(), 0);
    let mut carry = (0, 0);
    for (x, y) in x.iter_mut().zip(y.iter_mut()) {
        let (p, q) = (i128::from(*x), i128::from(*y));
        // The signs of a and b differ, and those of c and d: no sum leaves 128 bits.
        let (u, v) = (a * p + b * q + carry.0, c * p + d * q + carry.1);
        (*x, *y) = (u as u64, v as u64);
        carry = (u >> 64, v >> 64);
    }
    for n in [x, y] {
        n.truncate(n.iter().rposition(|word| *word != 0).map_or(0, |i| i + 1));
    }
}

/// The longest run of Euclidean steps that the 64 leading bits of `x >= y` determine, if any.
///
/// Collins' condition tells from the leading bits of the last remainders and the factors whether the next quotient is
/// that of the long numbers.
pub(super) fn foretold(x: &[u64], y: &[u64]) -> Option<Run> {
    let top = x.len() - 1;
    let excess = x[top].leading_zeros();
    let word = |n: &[u64], i: usize| n.get(i).map_or(0, |w| u128::from(*w));
    let leading = |n: &[u64]| ((word(n, top) << 64 | word(n, top - 1)) << excess >> 64) as u64;
    let (mut p, mut q) = (leading(x), leading(y));
    let (mut a, mut b, mut c, mut d) = (1, 0, 0, 1);
    let (mut even, mut last) = (true, None);
    // Here p and q stand for ±(a x - b y) and ±(d y - c x).
    while q >= d && p - q >= b + d {
        last = Some(Run { factors: [[a, b], [c, d]], even });
        let w = p / q;
        (p, q) = (q, p - w * q);
        (a, b, c, d) = (c, d, a + w * c, b + w * d);
        even = !even;
    }
    last.filter(|run| run.factors[0][1] != 0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::Sign;
    use num_integer::Integer;
    use proptest::prelude::*;

    fn number() -> impl Strategy<Value = BigInt> {
        let dense = prop::collection::vec(any::<u32>(), 0..40);
        let sparse = prop::collection::vec(prop::sample::select(vec![0, 1, u32::MAX]), 0..40);
        prop_oneof![dense, sparse].prop_map(|digits| BigUint::new(digits).into())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        #[test]
        fn gcd_is_the_greatest(a in number(), b in number(), shared in number(), minus: bool) {
            for (a, b) in [(a.clone(), b.clone()), (&a * &shared, &b * &shared), (&a * &shared, shared), (&a + &b, a)] {
                if a.sign() != Sign::NoSign || b.sign() != Sign::NoSign {
                    prop_assert_eq!(gcd(&if minus { -&a } else { a.clone() }, &b), a.gcd(&b));
                }
            }
        }

        #[test]
        fn word_gcd_is_the_greatest(a: i64, b: i64, j in 0..63u32, k in 0..63u32) {
            let (a, b) = ((a | 1) >> j, (b >> k).max(-i64::MAX));
            prop_assume!(a > i64::MIN && (a, b) != (0, 0));
            prop_assert_eq!(word_gcd(a, b), a.gcd(&b));
        }

        #[test]
        fn wide_gcd_is_the_greatest(a: u128, b: u128, j in 0..127u32, k in 0..127u32) {
            let (a, b) = ((a | 1 << 127) >> j, (b | 1 << 127) >> k);
            prop_assert_eq!(wide_gcd(a, b), a.gcd(&b));
        }
    }

    #[test]
    fn the_longest_run_of_small_quotients_ends() {
        let (mut a, mut b) = (BigInt::one(), BigInt::one());
        for _ in 0..2000 {
            (a, b) = (&a + &b, a);
        }
        assert_eq!(gcd(&a, &b), BigInt::one());
        assert_eq!(gcd(&(&a * &a), &(&a * &b)), a);
    }
}
