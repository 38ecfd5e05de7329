//! Sums of products over one denominator.
//!
//! The denominator is kept as `odd · 2^twos`, and the sum is reduced once, at the end. Terms are aligned by shifts for
//! the powers of two and by the least common multiple for the odd parts; on lossless images of `f64` the odd part is one
//! and no gcd is taken at all. Denominators of one spline have most factors in common, so that their multiple is little
//! longer than each.

use super::Q;
use super::Repr::{Big, Small};
use super::fraction::{Fraction, cancelled, divided};
use super::gcd::{gcd, power_of_two, word_gcd};
use super::window::Window;
use num_bigint::BigInt;
use num_traits::{One, Zero};
use std::borrow::Cow;

/// The exact sum of products, in words as long as it fits.
pub(super) fn dot<'a>(mut pairs: impl Iterator<Item = (&'a Q, &'a Q)>) -> Q {
    let mut sum = WordSum { num: 0, odd: 1, twos: 0 };
    while let Some((a, b)) = pairs.next() {
        if let Some(next) = sum.plus(a, b) {
            sum = next;
        } else {
            let (start, one) = (sum.reduced(), Q::one());
            let mut rest = vec![(&start, &one), (a, b)];
            pairs.for_each(|(a, b)| rest.push((a, b)));
            return big_dot(&rest);
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
fn big_dot(pairs: &[(&Q, &Q)]) -> Q {
    dyadic_dot(pairs).unwrap_or_else(|| fraction_dot(pairs))
}

/// The sum of products of numbers with powers of two for denominators, if all are and the sum has room on the stack.
fn dyadic_dot(pairs: &[(&Q, &Q)]) -> Option<Q> {
    let (mut bits, mut twos) = (0, 0);
    for (a, b) in pairs {
        let (above, below) = (bits_above(a) + bits_above(b), dyadic_exponent(a)? + dyadic_exponent(b)?);
        // Of the product as it is; the shift to the common denominator comes on top.
        (bits, twos) = (bits.max(above.saturating_sub(below)), twos.max(below));
    }
    let mut window = Window::with_room(bits + twos, pairs.len())?;
    for (a, b) in pairs {
        let k = twos - dyadic_exponent(a)? - dyadic_exponent(b)?;
        match (&a.0, &b.0) {
            (&Small { num: a, .. }, &Small { num: b, .. }) => window.add_words(a, b, k),
            (&Small { num: a, .. }, Big(b)) => window.add_word(&b.num, a, k),
            (Big(a), &Small { num: b, .. }) => window.add_word(&a.num, b, k),
            (Big(a), Big(b)) => window.add(&a.num, &b.num, k),
        }
    }
    Some(over_twos(window.value(), twos))
}

/// The fraction `num / 2^twos`.
fn over_twos(mut num: BigInt, twos: u64) -> Q {
    let Some(zeros) = num.trailing_zeros() else { return Q::zero() };
    let k = zeros.min(twos);
    if k > 0 {
        num >>= k;
    }
    Fraction { num, den: BigInt::one() << (twos - k) }.into()
}

/// The size of the numerator in bits.
fn bits_above(x: &Q) -> u64 {
    match &x.0 {
        Small { num, .. } => (64 - num.unsigned_abs().leading_zeros()).into(),
        Big(f) => f.num.bits(),
    }
}

/// The exponent of two in the denominator, if nothing else is there.
fn dyadic_exponent(x: &Q) -> Option<u64> {
    match &x.0 {
        Small { den, .. } => (den & (den - 1) == 0).then(|| den.trailing_zeros().into()),
        Big(f) => power_of_two(&f.den),
    }
}

/// The sum of any products: the factors on either side over the least common multiple of their denominators, and the sum
/// reduced by one multiple after the other.
fn fraction_dot(pairs: &[(&Q, &Q)]) -> Q {
    let terms: Vec<[Part<'_>; 2]> = pairs
        .iter()
        .filter(|(a, b)| !a.is_zero() && !b.is_zero())
        .map(|(a, b)| [Part::new(a), Part::new(b)])
        .collect();
    let multiples = [0, 1].map(|side| {
        let odds = terms.iter().filter_map(|term| term[side].odd.as_deref());
        odds.fold(None, |multiple, odd| Some(lcm(multiple, odd)))
    });
    let twos = terms.iter().map(|[a, b]| a.twos + b.twos).max().unwrap_or(0);
    let wholes = terms.iter().map(|[a, b]| {
        let [m, n] = multiples.each_ref().map(Option::as_ref);
        (a.times(m), b.times(n), twos - a.twos - b.twos)
    });
    let mut num = sum_of_products(&wholes.collect::<Vec<_>>());
    let Some(zeros) = num.trailing_zeros() else { return Q::zero() };
    let k = zeros.min(twos);
    if k > 0 {
        num >>= k;
    }
    let mut den = BigInt::one();
    for multiple in multiples.into_iter().flatten() {
        let g = gcd(&num, &multiple);
        num = cancelled(num, &g);
        den = if den.is_one() { cancelled(multiple, &g) } else { den * cancelled(multiple, &g) };
    }
    Fraction { num, den: den << (twos - k) }.into()
}

/// The fraction `num / (odd 2^twos)`, where no `odd` stands for one.
pub(super) struct Part<'a> {
    pub(super) num: Cow<'a, BigInt>,
    pub(super) odd: Option<Cow<'a, BigInt>>,
    pub(super) twos: u64,
}

impl<'a> Part<'a> {
    pub(super) fn new(x: &'a Q) -> Self {
        let (num, odd, twos) = match &x.0 {
            &Small { num, den } => {
                let twos = den.trailing_zeros();
                let odd = den >> twos;
                (Cow::Owned(num.into()), (odd != 1).then(|| Cow::Owned(odd.into())), twos.into())
            }
            Big(f) => {
                let twos = f.den.trailing_zeros().expect("a denominator is not zero");
                let odd = match twos {
                    _ if f.den.bits() == twos + 1 => None,
                    0 => Some(Cow::Borrowed(&f.den)),
                    _ => Some(Cow::Owned(&f.den >> twos)),
                };
                (Cow::Borrowed(&f.num), odd, twos)
            }
        };
        Self { num, odd, twos }
    }

    /// The numerator over `multiple` for the odd denominator.
    fn times(&self, multiple: Option<&BigInt>) -> Cow<'_, BigInt> {
        match (multiple, &self.odd) {
            (None, _) => Cow::Borrowed(&self.num),
            (Some(m), None) => Cow::Owned(&*self.num * m),
            (Some(m), Some(odd)) if **odd == *m => Cow::Borrowed(&self.num),
            (Some(m), Some(odd)) => Cow::Owned(&*self.num * (m / &**odd)),
        }
    }
}

/// The least common multiple of positive numbers.
pub(super) fn lcm(multiple: Option<BigInt>, odd: &BigInt) -> BigInt {
    match multiple {
        None => odd.clone(),
        Some(m) if m == *odd => m,
        Some(m) => {
            let g = gcd(&m, odd);
            if g == *odd { m } else { m * &*divided(odd, &g) }
        }
    }
}

/// The sum `Σ a b 2^k`.
fn sum_of_products(terms: &[(Cow<'_, BigInt>, Cow<'_, BigInt>, u64)]) -> BigInt {
    let bits = terms.iter().map(|(a, b, k)| a.bits() + b.bits() + k).max().unwrap_or(0);
    let Some(mut window) = Window::with_room(bits, terms.len()) else {
        return terms.iter().map(|(a, b, k)| (&**a * &**b) << k).sum();
    };
    terms.iter().for_each(|(a, b, k)| window.add(a, b, *k));
    window.value()
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
