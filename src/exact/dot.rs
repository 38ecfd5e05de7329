//! Sums of products over one denominator.
//!
//! The denominator is kept as `odd · 2^twos`, and the sum is reduced once, at the end. Terms are aligned by shifts for
//! the powers of two and by the least common multiple for the odd parts; on lossless images of `f64` the odd part is one
//! and no gcd is taken at all.

use super::Q;
use super::Repr::{Big, Small};
use super::fraction::{Fraction, cancelled, divided};
use super::gcd::{gcd, power_of_two, word_gcd};
use num_bigint::BigInt;
use num_traits::{One, Zero};

/// The exact sum of products, in words as long as it fits.
pub(super) fn dot<'a>(mut pairs: impl Iterator<Item = (&'a Q, &'a Q)>) -> Q {
    let mut sum = WordSum { num: 0, odd: 1, twos: 0 };
    while let Some((a, b)) = pairs.next() {
        if let Some(next) = sum.plus(a, b) {
            sum = next;
        } else {
            let start = BigSum::from(sum.reduced()).plus(a, b);
            return pairs.fold(start, |sum, (a, b)| sum.plus(a, b)).reduced();
        }
    }
    sum.reduced()
}

/// The number `num / (odd · 2^twos)`, not reduced.
#[derive(Clone, Copy)]
struct WordSum {
    num: i128,
    odd: i64,
    twos: u32,
}

impl WordSum {
    /// The sum with one more product, unless it leaves the words.
    #[inline]
    fn plus(self, a: &Q, b: &Q) -> Option<Self> {
        let (&Small { num: a, den: p }, &Small { num: b, den: q }) = (&a.0, &b.0) else { return None };
        let term = i128::from(a) * i128::from(b);
        if term == 0 {
            return Some(self);
        }
        if p == 1 && q == 1 && self.odd == 1 && self.twos == 0 {
            return Some(Self { num: self.num.checked_add(term)?, ..self });
        }
        let (j, k) = (p.trailing_zeros(), q.trailing_zeros());
        let odd = (p >> j).checked_mul(q >> k)?;
        let twos = self.twos.max(j + k);
        let (num, term) = (shifted(self.num, twos - self.twos)?, shifted(term, twos - (j + k))?);
        if odd == self.odd {
            return Some(Self { num: num.checked_add(term)?, odd, twos });
        }
        let g = if self.odd % odd == 0 { odd } else { word_gcd(self.odd, odd) };
        let (ours, theirs) = (odd / g, self.odd / g);
        let num = multiple(num, ours)?.checked_add(multiple(term, theirs)?)?;
        Some(Self { num, odd: self.odd.checked_mul(ours)?, twos })
    }

    fn reduced(self) -> Q {
        let k = self.num.trailing_zeros().min(self.twos);
        let (num, twos) = (self.num >> k, self.twos - k);
        // Divisions of 128 bits are slow.
        let g = if self.odd == 1 { 1 } else { word_gcd((num % i128::from(self.odd)) as i64, self.odd) };
        let (num, odd) = if g == 1 { (num, self.odd) } else { (num / i128::from(g), self.odd / g) };
        // A sum of zero keeps no denominator: k is all of `twos`, g all of `odd`.
        match shifted(odd.into(), twos) {
            Some(den) => Q::coprime(num, den),
            None => Fraction { num: num.into(), den: BigInt::from(odd) << twos }.into(),
        }
    }
}

/// `x · 2^k` if that is below `2^127` in magnitude.
#[inline]
fn shifted(x: i128, k: u32) -> Option<i128> {
    (k < x.unsigned_abs().leading_zeros()).then(|| x << k)
}

/// `x · n` if that is certainly below `2^127` in magnitude; a checked product of 128 bits would call a function.
#[inline]
fn multiple(x: i128, n: i64) -> Option<i128> {
    (x.unsigned_abs().leading_zeros() + n.leading_zeros() > 64).then(|| x * i128::from(n))
}

/// The same in big integers.
///
/// The odd denominators of terms have few factors in common as a rule. A short common factor is cancelled at once, which
/// takes a short gcd; only a long one leaves the sum in need of a long gcd at the end.
struct BigSum {
    num: BigInt,
    odd: BigInt,
    twos: u64,
    reducible: bool,
}

impl From<Q> for BigSum {
    fn from(q: Q) -> Self {
        let Fraction { num, den } = q.into();
        let twos = den.trailing_zeros().expect("a denominator is not zero");
        Self { num, odd: den >> twos, twos, reducible: false }
    }
}

impl BigSum {
    fn plus(self, a: &Q, b: &Q) -> Self {
        if let (Some(j), Some(k)) = (dyadic_exponent(a), dyadic_exponent(b)) {
            let term = match (&a.0, &b.0) {
                (&Small { num: a, .. }, &Small { num: b, .. }) => (i128::from(a) * i128::from(b)).into(),
                _ => &*a.parts().0 * &*b.parts().0,
            };
            return self.plus_term(term, None, j + k);
        }
        let term = Self::from(a * b);
        self.plus_term(term.num, Some(term.odd).filter(|odd| !odd.is_one()), term.twos)
    }

    fn plus_term(mut self, mut term: BigInt, odd: Option<BigInt>, twos: u64) -> Self {
        if twos > self.twos {
            self.num <<= twos - self.twos;
            self.twos = twos;
        } else if twos < self.twos {
            term <<= self.twos - twos;
        }
        let odd = match odd {
            None if self.odd.is_one() => return Self { num: self.num + term, ..self },
            None => return Self { num: self.num + term * &self.odd, ..self },
            Some(odd) => odd,
        };
        if odd == self.odd {
            return Self { num: self.num + term, reducible: true, ..self };
        }
        let g = gcd(&self.odd, &odd);
        let (ours, theirs) = (divided(&odd, &g), divided(&self.odd, &g));
        let (num, odd) = (self.num * &*ours + term * &*theirs, &self.odd * &*ours);
        if g.bits() > 128 {
            return Self { num, odd, reducible: true, ..self };
        }
        let h = gcd(&num, &g);
        Self { num: cancelled(num, &h), odd: cancelled(odd, &h), ..self }
    }

    fn reduced(mut self) -> Q {
        let Some(zeros) = self.num.trailing_zeros() else { return Q::zero() };
        let k = zeros.min(self.twos);
        self.num >>= k;
        let g = if self.reducible { gcd(&self.num, &self.odd) } else { BigInt::one() };
        Fraction { num: cancelled(self.num, &g), den: cancelled(self.odd, &g) << (self.twos - k) }.into()
    }
}

/// The exponent of two in the denominator, if nothing else is there.
fn dyadic_exponent(x: &Q) -> Option<u64> {
    match &x.0 {
        Small { den, .. } => (den & (den - 1) == 0).then(|| den.trailing_zeros().into()),
        Big(f) => power_of_two(&f.den),
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{check, integer, rational};
    use super::*;
    use num_rational::BigRational;
    use proptest::collection::vec;
    use proptest::prelude::*;

    fn check_dot(pairs: &[(BigRational, BigRational)]) {
        let exact: Vec<_> = pairs.iter().map(|(r, s)| (Q::from(r.clone()), Q::from(s.clone()))).collect();
        check(&dot(exact.iter().map(|(x, y)| (x, y))), &pairs.iter().map(|(r, s)| r * s).sum());
    }

    /// Denominators with long and short factors in common, and dyadic ones.
    fn related() -> impl Strategy<Value = BigRational> {
        let prime = |k: u32| (BigInt::one() << k) - 1;
        let (p, q) = (prime(89), prime(61));
        let pool = vec![
            1.into(),
            6.into(),
            BigInt::one() << 70,
            &p * 3,
            &q * 3,
            &p * &q,
            &p * &q * 10,
            &p * &p,
            p,
            q,
        ];
        (integer(), prop::sample::select(pool)).prop_map(|(num, den)| BigRational::new(num, den))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        #[test]
        fn dot_is_the_sum_of_products(pairs in vec((rational(), rational()), 0..9)) {
            check_dot(&pairs);
        }

        #[test]
        fn dot_shares_denominators(pairs in vec((related(), related()), 0..9)) {
            check_dot(&pairs);
        }

        #[test]
        fn dot_survives_cancellation(mut pairs in vec((related(), rational()), 1..5)) {
            // All terms but the first cancel.
            pairs.extend(pairs.clone().into_iter().skip(1).map(|(r, s)| (-r, s)));
            check_dot(&pairs);
        }

        #[test]
        fn dot_of_words(pairs in vec((any::<(i64, i64)>(), any::<(i64, i64)>(), 0..63u32), 0..9)) {
            let fraction = |(p, q): (i64, i64), k: u32| BigRational::new((p >> k).into(), ((q >> k) | 1).into());
            check_dot(&pairs.into_iter().map(|(x, y, k)| (fraction(x, k), fraction(y, k))).collect::<Vec<_>>());
        }
    }
}
