//! Which roots are rational.
//!
//! In powers of `u = (x - a) / (b - a)`, with integer coefficients, the denominator of a rational root divides the leading
//! coefficient `L`. So once an isolating interval is shorter than `1 / L`, it holds at most one candidate. On the way there
//! the simplest fraction in the interval is tried, which finds most rational roots early; the interval shrinks by
//! secants that double the digits gained as long as they are right.

use crate::exact::Q;
use crate::exact::coprime::has_simple_roots;
use crate::roots::polynomial::Polynomial;
use crate::roots::{RootValue, Solvable};
use crate::scalar::Scalar;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Zero};

impl Solvable for Q {
    fn root(polynomial: &Polynomial<Self>, start: Self, end: Self) -> RootValue<Self> {
        let exact = polynomial.linear_root().or_else(|| rational_root(polynomial, &start, &end));
        exact.map_or(RootValue::Enclosed(start, end), RootValue::Exact)
    }

    fn has_simple_roots(powers: &[Self]) -> bool {
        has_simple_roots(powers)
    }

    fn tidy(numbers: &mut [Self]) {
        let denominator = numbers.iter().fold(BigInt::one(), |lcm, q| lcm.lcm(&q.denom()));
        let denominator = Self::from(denominator);
        numbers.iter_mut().for_each(|q| *q *= &denominator);
        let divisor = numbers.iter().fold(BigInt::zero(), |gcd, q| gcd.gcd(&q.numer()));
        if !divisor.is_zero() && !divisor.is_one() {
            let divisor = Self::from(divisor);
            numbers.iter_mut().for_each(|q| *q /= &divisor);
        }
    }
}

/// The root between `start` and `end`, if it is rational.
fn rational_root(polynomial: &Polynomial<Q>, start: &Q, end: &Q) -> Option<Q> {
    let (a, b) = polynomial.domain();
    let width = b.clone() - a;
    let search = Search::new(polynomial, (start.clone() - a) / &width, (end.clone() - a) / &width);
    search.run().map(|u| a.clone() + u * width)
}

/// The search for a rational root `u` in an interval that shrinks.
struct Search {
    /// Coprime integer coefficients of the powers of `u`, the lowest first.
    powers: Vec<Q>,
    low: Q,
    high: Q,
    /// The values at the ends, of different sign.
    below: Q,
    above: Q,
    /// How many bits the next step is hoped to gain.
    bits: u32,
}

impl Search {
    fn new(polynomial: &Polynomial<Q>, low: Q, high: Q) -> Self {
        // The coefficient of u^j is the j-th difference at the start, times C(n, j): here times n! / (n - j)! / j!.
        let mut differences = polynomial.coeffs().to_vec();
        let n = differences.len() - 1;
        let (mut powers, mut binomial) = (Vec::with_capacity(n + 1), Q::one());
        for j in 0..=n {
            powers.push(differences[0].clone() * &binomial);
            binomial = binomial * Q::int((n - j) as i64) / Q::int(j as i64 + 1);
            (0..n - j).for_each(|i| differences[i] = differences[i + 1].clone() - &differences[i]);
        }
        while powers.last().is_some_and(Q::is_zero) {
            powers.pop();
        }
        Q::tidy(&mut powers);
        let mut search = Self { powers, low, high, below: Q::zero(), above: Q::zero(), bits: 1 };
        (search.below, search.above) = (search.value(&search.low), search.value(&search.high));
        search
    }

    fn value(&self, u: &Q) -> Q {
        self.powers.iter().rev().fold(Q::zero(), |sum, c| sum * u + c)
    }

    fn run(mut self) -> Option<Q> {
        let lead = self.powers[self.powers.len() - 1].abs();
        loop {
            if (self.high.clone() - &self.low) * &lead < Q::one() {
                let candidate = Q::from(floor(&(self.low.clone() * &lead)) + 1) / lead;
                return (candidate < self.high && self.value(&candidate).is_zero()).then_some(candidate);
            }
            let simple = simplest(&self.low, &self.high);
            if simple.denom() <= lead.numer() && self.value(&simple).is_zero() {
                return Some(simple);
            }
            if let Some(root) = self.step() {
                return Some(root);
            }
        }
    }

    /// Cuts the interval in `2^bits` and guesses by a secant which of the parts holds the root. If the guess is wrong
    /// the next is less bold; with halves it is never wrong. Returns the root if it comes upon it.
    fn step(&mut self) -> Option<Q> {
        let parts = BigInt::one() << self.bits;
        let width = (self.high.clone() - &self.low) / Q::from(parts.clone());
        let secant = self.below.clone() / (self.below.clone() - &self.above);
        let guess = floor(&(secant * Q::from(parts.clone()) + Q::frac(1, 2)));
        let near = self.low.clone() + width.clone() * Q::from(guess.clamp(BigInt::one(), parts - 1));
        let Some(is_low) = self.probe(&near) else { return Some(near) };
        // The other end of the part, if the guess is right.
        let far = if is_low { near + width } else { near - width };
        let mut right = true;
        if self.low < far && far < self.high {
            match self.probe(&far) {
                Some(also) => right = also != is_low,
                None => return Some(far),
            }
        }
        self.bits = if right { self.bits * 2 } else { (self.bits / 2).max(1) };
        None
    }

    /// Shortens the interval to one side of `u`; whether `u` is below the root, or nothing if it is the root.
    fn probe(&mut self, u: &Q) -> Option<bool> {
        let value = self.value(u);
        let is_low = value.is_negative() == self.below.is_negative();
        match is_low {
            _ if value.is_zero() => return None,
            true => (self.low, self.below) = (u.clone(), value),
            false => (self.high, self.above) = (u.clone(), value),
        }
        Some(is_low)
    }
}

fn floor(q: &Q) -> BigInt {
    q.numer().div_floor(&q.denom())
}

/// The fraction with the least denominator in `[low, high]`.
fn simplest(low: &Q, high: &Q) -> Q {
    // Both ends as continued fractions, as long as they agree; convergents h / k.
    let (mut low, mut high) = (low.clone(), high.clone());
    let (mut before, mut last) = ((Q::zero(), Q::one()), (Q::one(), Q::zero()));
    loop {
        let whole = Q::from(floor(&low));
        let next = if low == whole { whole.clone() } else { whole.clone() + Q::one() };
        let ends = next <= high;
        let digit = if ends { next } else { whole.clone() };
        let convergent = (digit.clone() * &last.0 + &before.0, digit * &last.1 + &before.1);
        if ends {
            return convergent.0 / convergent.1;
        }
        (before, last) = (last, convergent);
        (low, high) = ((high - &whole).recip(), (low - whole).recip());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_simplest_fraction_is_found() {
        let q = |n, d| Q::frac(n, d);
        assert_eq!(simplest(&q(3, 10), &q(4, 10)), q(1, 3));
        assert_eq!(simplest(&q(-1, 2), &q(1, 7)), q(0, 1));
        assert_eq!(simplest(&q(314_159, 100_000), &q(314_160, 100_000)), q(355, 113));
        assert_eq!(simplest(&q(2, 7), &q(2, 7)), q(2, 7));
        assert_eq!(simplest(&q(-22, 7), &q(-25, 8)), q(-22, 7));
    }
}
