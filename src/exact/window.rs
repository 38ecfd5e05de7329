//! Sums of products of big integers on the stack.
//!
//! The words of a product go right to their place in the sum: nothing is allocated, and a shift costs next to nothing.

use num_bigint::{BigInt, BigUint, Sign};

/// The words of a sum.
const WORDS: usize = 32;

/// A sum of products, positive and negative ones apart.
pub(super) struct Window {
    signs: [[u64; WORDS]; 2],
    /// The words that are not zero lie below.
    len: usize,
}

impl Window {
    /// An empty sum with room for `count` products of `bits` bits, if it is that long.
    pub(super) fn with_room(bits: u64, count: usize) -> Option<Self> {
        let carries = u64::from(usize::BITS - count.leading_zeros());
        (bits + carries <= 64 * WORDS as u64).then_some(Self { signs: [[0; WORDS]; 2], len: 0 })
    }

    /// Adds `a b 2^k`.
    pub(super) fn add(&mut self, a: &BigInt, b: &BigInt, k: u64) {
        let minus = a.sign() != b.sign();
        let (place, shift) = ((k / 64) as usize, k % 64);
        let (mut words, mut len, mut low) = ([0; WORDS], 0, 0);
        for word in a.iter_u64_digits() {
            let wide = u128::from(word) << shift;
            (words[len], low) = (wide as u64 | low, (wide >> 64) as u64);
            len += 1;
        }
        if low != 0 {
            words[len] = low;
            len += 1;
        }
        for (i, factor) in b.iter_u64_digits().enumerate() {
            self.add_run(&words[..len], factor, place + i, minus);
        }
    }

    /// Adds `a b 2^k`.
    pub(super) fn add_word(&mut self, a: &BigInt, b: i64, k: u64) {
        let minus = (a.sign() == Sign::Minus) != (b < 0);
        let wide = u128::from(b.unsigned_abs()) << (k % 64);
        let place = (k / 64) as usize;
        for (i, factor) in a.iter_u64_digits().enumerate() {
            self.add_run(&[wide as u64, (wide >> 64) as u64], factor, place + i, minus);
        }
    }

    /// Adds `a b 2^k`.
    pub(super) fn add_words(&mut self, a: i64, b: i64, k: u64) {
        let minus = (a < 0) != (b < 0);
        let wide = u128::from(b.unsigned_abs()) << (k % 64);
        self.add_run(&[wide as u64, (wide >> 64) as u64], a.unsigned_abs(), (k / 64) as usize, minus);
    }

    /// Adds or subtracts `words factor 2^(64 place)`.
    #[inline]
    fn add_run(&mut self, words: &[u64], factor: u64, place: usize, minus: bool) {
        let sum = &mut self.signs[usize::from(minus)];
        let mut carry = 0;
        // Zeros that lead may reach beyond the window.
        for (s, word) in sum[place..].iter_mut().zip(words) {
            let wide = u128::from(*word) * u128::from(factor) + u128::from(*s) + u128::from(carry);
            (*s, carry) = (wide as u64, (wide >> 64) as u64);
        }
        let mut at = place + words.len();
        while carry != 0 {
            let over;
            (sum[at], over) = sum[at].overflowing_add(carry);
            carry = over.into();
            at += 1;
        }
        self.len = self.len.max(at.min(WORDS));
    }

    /// The sum.
    pub(super) fn value(&self) -> BigInt {
        let [plus, minus] = self.signs.each_ref().map(|words| &words[..self.len]);
        let (sign, large, small) = if plus.iter().rev().ge(minus.iter().rev()) {
            (Sign::Plus, plus, minus)
        } else {
            (Sign::Minus, minus, plus)
        };
        let mut digits = [0; 2 * WORDS];
        let mut borrow = false;
        for ((pair, x), y) in digits.chunks_mut(2).zip(large).zip(small) {
            let (rest, first) = x.overflowing_sub(*y);
            let (word, second) = rest.overflowing_sub(borrow.into());
            borrow = first || second;
            (pair[0], pair[1]) = (word as u32, (word >> 32) as u32);
        }
        BigInt::from_biguint(sign, BigUint::from_slice(&digits[..2 * self.len]))
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::integer;
    use super::*;
    use num_traits::ToPrimitive;
    use proptest::collection::vec;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]

        #[test]
        fn sums_are_right(terms in vec((integer(), integer(), 0..900u64), 0..6)) {
            let bits = terms.iter().map(|(a, b, k)| a.bits() + b.bits() + k).max().unwrap_or(0);
            let mut window = Window::with_room(bits, terms.len()).expect("words enough");
            for (a, b, k) in &terms {
                match (a.to_i64(), b.to_i64()) {
                    (Some(a), Some(b)) => window.add_words(a, b, *k),
                    (None, Some(b)) => window.add_word(a, b, *k),
                    _ => window.add(a, b, *k),
                }
            }
            prop_assert_eq!(window.value(), terms.iter().map(|(a, b, k)| (a * b) << k).sum());
        }
    }

    #[test]
    fn carries_run_to_the_end() {
        let bits = 64 * WORDS as u64;
        let all = (BigInt::from(1) << (bits - 3)) - 1;
        let one = BigInt::from(1);
        assert!(Window::with_room(bits - 1, 2).is_none());
        let mut window = Window::with_room(bits - 2, 3).expect("room for the carries");
        window.add(&all, &one, 0);
        window.add(&one, &one, 0);
        window.add(&-&one, &one, 64);
        window.add_word(&one, 1, bits - 4);
        window.add_words(1, -1, bits - 4);
        assert_eq!(window.value(), all + 1 - (BigInt::from(1) << 64));
    }
}
