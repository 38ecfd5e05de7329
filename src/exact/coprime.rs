//! A quick proof that a polynomial has simple roots only: it has none that is double modulo some prime.
//!
//! The discriminant of a polynomial with whole coefficients, modulo a prime that does not divide the leading one, is that of
//! the polynomial modulo the prime. So if there the greatest common divisor with the derivative is constant, it is constant over the rationals too.

use super::Q;
use super::modular::Prime;
use crate::scalar::Scalar;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{ToPrimitive, Zero};

/// How many primes are tried.
const PRIMES: usize = 3;

/// Whether the polynomial with these coefficients of powers, the lowest first, is known to have simple roots only. If not, nothing
/// is known.
pub(crate) fn has_simple_roots(powers: &[Q]) -> bool {
    let Some(degree) = powers.iter().rposition(|c| !c.is_zero()).filter(|degree| *degree > 0) else {
        return false;
    };
    let Some(factor) = Q::primitive(powers.iter()) else { return false };
    let whole: Vec<BigInt> = powers[..=degree].iter().map(|c| (c.clone() * &factor).numer()).collect();
    let primes = std::iter::successors(Some(Prime::first()), |prime| Some(prime.next())).take(PRIMES);
    primes.into_iter().any(|prime| {
        let modulus = BigInt::from(prime.p);
        let rest = |c: &BigInt| c.mod_floor(&modulus).to_u64().expect("a remainder is below the prime");
        let f: Vec<u64> = whole.iter().map(rest).collect();
        f[degree] != 0 && is_coprime_to_its_derivative(f, prime)
    })
}

/// Euclid's algorithm for a polynomial, whose leading coefficient is not zero, and its derivative, modulo a prime above its degree.
fn is_coprime_to_its_derivative(f: Vec<u64>, prime: Prime) -> bool {
    let derivative = (1..).zip(&f[1..]).map(|(k, c)| prime.remainder(k * c)).collect();
    let (mut f, mut g): (Vec<u64>, Vec<u64>) = (f, derivative);
    while g.len() > 1 {
        let inverse = prime.power(g[g.len() - 1], prime.p - 2);
        while f.len() >= g.len() {
            // Takes away the multiple of g with the same leading term.
            let factor = prime.p - prime.remainder(f[f.len() - 1] * inverse);
            let shift = f.len() - g.len();
            for (c, d) in f[shift..].iter_mut().zip(&g) {
                *c = prime.remainder(*c + factor * d);
            }
            trim(&mut f);
        }
        std::mem::swap(&mut f, &mut g);
    }
    g.len() == 1
}

/// Leaves out the highest coefficients that are zero.
fn trim(f: &mut Vec<u64>) {
    while f.last() == Some(&0) {
        f.pop();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn product(roots: &[(i64, i64)]) -> Vec<Q> {
        roots.iter().fold(vec![Q::int(1)], |f, (p, q)| {
            let mut product = vec![Q::int(0); f.len() + 1];
            for (k, c) in f.iter().enumerate() {
                product[k] -= c.clone() * Q::frac(*p, *q);
                product[k + 1] += c;
            }
            product
        })
    }

    #[test]
    fn simple_roots_are_told_from_double_ones() {
        assert!(has_simple_roots(&product(&[(1, 2), (1, 3), (-5, 7), (2, 1)])));
        assert!(has_simple_roots(&product(&[(1, 1)])));
        assert!(!has_simple_roots(&product(&[(1, 2), (1, 3), (-5, 7), (1, 2)])));
        // Apart by less than any prime sees at once, and no further.
        assert!(has_simple_roots(&product(&[(1 << 40, (1 << 40) + 1), (1, 1)])));
        assert!(!has_simple_roots(&[Q::int(3)]));
        assert!(!has_simple_roots(&[Q::int(0), Q::int(0)]));
        // x² + 1, squared, has no real root, but double ones.
        assert!(!has_simple_roots(&[1, 0, 2, 0, 1].map(Q::int)));
    }
}
