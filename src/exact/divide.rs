//! Several numbers over one divisor.
//!
//! What `x_i` and `d` have in common divides what their product and `d` have in common, so one long gcd serves all:
//!
//! ```text
//! g = gcd(x_1 x_2 ... x_n mod d, d),   gcd(x_i, d) = gcd(x_i, g)
//! ```

use super::Q;
use super::Repr::{Big, Small};
use super::dot::{Part, lcm};
use super::fraction::{Fraction, cancelled, divided};
use super::gcd::gcd;
use num_bigint::{BigInt, BigUint};
use num_traits::{One, Signed, Zero};

/// The least common multiple of the odd parts of denominators, if some number is big and has one that is not one.
pub(super) fn common_denominator<'a>(values: impl Iterator<Item = &'a Q>) -> Option<Q> {
    let mut multiple: Option<BigInt> = None;
    let mut big = false;
    for x in values {
        big |= matches!(x.0, Big(_));
        let Part { odd, .. } = Part::new(x);
        if let Some(odd) = odd {
            multiple = Some(lcm(multiple, &odd));
        }
    }
    multiple.filter(|_| big).map(Q::from)
}

/// The least common denominator over the greatest common numerator, if some number is not zero.
pub(super) fn primitive<'a>(values: impl Iterator<Item = &'a Q>) -> Option<Q> {
    let (mut above, mut below): (Option<BigInt>, Option<BigInt>) = (None, None);
    for x in values.filter(|x| !x.is_zero()) {
        let (num, den) = x.parts();
        above = Some(match above {
            None => num.abs(),
            Some(g) if g.is_one() => g,
            Some(g) => gcd(&g, &num),
        });
        if !den.is_one() {
            below = Some(lcm(below, &den));
        }
    }
    Some(Fraction { num: below.unwrap_or_else(BigInt::one), den: above? }.into())
}

/// Divides all of `values` by `divisor`.
pub(super) fn divide(values: &mut [Q], divisor: &Q) {
    match &divisor.0 {
        Small { num: 1, den: 1 } => {}
        Big(d) if d.den.is_one() && values.len() > 1 => divide_by_integer(values, &d.num),
        _ => values.iter_mut().for_each(|x| *x /= divisor),
    }
}

fn divide_by_integer(values: &mut [Q], divisor: &BigInt) {
    let twos = divisor.trailing_zeros().expect("a divisor is not zero");
    let divisor_odd = divisor.magnitude() >> twos;
    let mut product = BigUint::one();
    for x in values.iter().filter(|x| !x.is_zero()) {
        product *= Part::new(x).num.magnitude();
        if product.bits() > 4 * divisor_odd.bits() {
            product %= &divisor_odd;
        }
    }
    let divisor_odd = BigInt::from(divisor_odd);
    let common = gcd(&product.into(), &divisor_odd);
    for x in values.iter_mut().filter(|x| !x.is_zero()) {
        let Part { num, odd, twos: below } = Part::new(x);
        let g = if common.is_one() { BigInt::one() } else { gcd(&num, &common) };
        // A number with twos below has none above.
        let shared = num.trailing_zeros().map_or(0, |zeros| zeros.min(twos));
        let mut num = if shared > 0 { &*num >> shared } else { num.into_owned() };
        if divisor.is_negative() {
            num = -num;
        }
        let rest = divided(&divisor_odd, &g);
        let den = match odd {
            Some(odd) => (&*odd * &*rest) << (below + twos - shared),
            None => &*rest << (below + twos - shared),
        };
        *x = Fraction { num: cancelled(num, &g), den }.into();
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{check, rational};
    use super::*;
    use crate::scalar::Scalar;
    use num_rational::BigRational;
    use proptest::collection::vec;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]

        #[test]
        fn quotients_are_right(rs in vec(rational(), 0..5), s in rational(), shared in rational()) {
            prop_assume!(!s.is_zero());
            // Divisors that are integers, with and without factors in common with the numbers, and others.
            let whole = BigRational::from(s.numer() * shared.denom());
            for d in [&whole, &s] {
                let scaled: Vec<BigRational> = rs.iter().map(|r| r * shared.numer()).collect();
                for rs in [&rs, &scaled] {
                    let mut values: Vec<Q> = rs.iter().cloned().map(Q::from).collect();
                    divide(&mut values, &d.clone().into());
                    values.iter().zip(rs).for_each(|(x, r)| check(x, &(r / d)));
                }
            }
        }

        #[test]
        fn odd_denominators_are_cleared(rs in vec(rational(), 0..5)) {
            let values: Vec<Q> = rs.into_iter().map(Q::from).collect();
            let big = values.iter().any(|x| matches!(x.0, Big(_)));
            match Q::clear(values.iter()) {
                Some(d) => prop_assert!(big && values.iter().all(|x| Part::new(&(x * &d)).odd.is_none())),
                None => prop_assert!(!big || values.iter().all(|x| Part::new(x).odd.is_none())),
            }
        }
    }
}
