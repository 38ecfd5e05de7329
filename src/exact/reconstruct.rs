//! Fractions from their remainders.
//!
//! If `n / d = x mod m` has `2 n d < m`, then `n / d` is the only such fraction, and Euclid's algorithm on `m` and `x` comes
//! across it half way: each remainder is `r = s x mod m` with a factor `s` that grows as the remainder shrinks.

use super::gcd::{apply, foretold};
use num_bigint::{BigInt, BigUint};
use num_traits::{One, Signed, Zero};

/// The fraction `n / d = x mod m` with `|n| <= 2^bits_above` and `0 < d <= 2^bits_below`, if there is one.
pub(super) fn fraction(
    x: &BigUint,
    m: &BigUint,
    bits_above: u64,
    bits_below: u64,
) -> Option<(BigInt, BigInt)> {
    let (mut r, mut rest) = (m.clone(), x.clone());
    let (mut s, mut factor) = (BigInt::zero(), BigInt::one());
    // A run takes less than two words off, so that none passes the middle.
    while rest.bits() > bits_above.max(64) + 128 {
        let (mut u, mut v) = (r.to_u64_digits(), rest.to_u64_digits());
        let run = if u.len() <= v.len() + 1 { foretold(&u, &v) } else { None };
        let Some(run) = run else {
            step(&mut r, &mut rest, &mut s, &mut factor);
            continue;
        };
        let [[a, b], [c, d]] = run.factors;
        (s, factor) = (&s * a - &factor * b, &factor * d - &s * c);
        if !run.even {
            (s, factor) = (-s, -factor);
        }
        apply(run, &mut u, &mut v);
        (r, rest) = (super::gcd::number(&u), super::gcd::number(&v));
    }
    while rest.bits() > bits_above {
        step(&mut r, &mut rest, &mut s, &mut factor);
    }
    let num = if factor.is_negative() { -BigInt::from(rest) } else { rest.into() };
    (factor.bits() <= bits_below && !factor.is_zero()).then(|| (num, factor.abs()))
}

/// One step of Euclid's algorithm with the factors.
fn step(r: &mut BigUint, rest: &mut BigUint, s: &mut BigInt, factor: &mut BigInt) {
    let quotient = &*r / &*rest;
    *r -= &quotient * &*rest;
    std::mem::swap(r, rest);
    *s -= BigInt::from(quotient) * &*factor;
    std::mem::swap(s, factor);
}

#[cfg(test)]
mod tests {
    use super::super::tests::integer;
    use super::*;
    use num_integer::Integer;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]

        #[test]
        fn fractions_come_back(n in integer(), d in integer(), long in any::<bool>()) {
            // A Mersenne prime for the modulus.
            let m = (BigInt::one() << if long { 2203 } else { 1279 }) - 1;
            prop_assume!(!d.is_zero());
            let g = n.gcd(&d);
            let (n, d) = (&n / &g * d.signum(), (&d / &g).abs());
            let inverse = d.modpow(&(&m - 2), &m);
            let x = (&n * inverse).mod_floor(&m);
            let found = fraction(x.magnitude(), m.magnitude(), 600, 600);
            prop_assert_eq!(found, Some((n, d)));
        }
    }

    #[test]
    fn other_remainders_are_none() {
        let m = (BigUint::one() << 521_u32) - 1_u32;
        let x = BigUint::from(3_u32).modpow(&BigUint::from(1000_u32), &m);
        assert_eq!(fraction(&x, &m, 200, 200), None);
    }
}
