//! Polynomials without their multiple roots.
//!
//! In powers of `(x - a) / (b - x)` the Bernstein coefficients, times binomials, are the ordinary coefficients of a
//! polynomial; its greatest common divisor with its derivative holds each root once less.

use crate::roots::Solvable;
use crate::roots::polynomial::Polynomial;

/// Polynomials with simple roots: the `j`-th has the roots of multiplicity greater than `j` of `polynomial`.
///
/// The ends of the interval are no roots of `polynomial`, and the field is exact.
pub(super) fn square_free_parts<T: Solvable>(polynomial: &Polynomial<T>) -> Vec<Polynomial<T>> {
    let mut rest = polynomial.powers();
    T::tidy(&mut rest);
    let mut parts = Vec::new();
    while rest.len() > 1 || parts.is_empty() {
        let common = common_divisor(rest.clone(), derivative(&rest));
        let mut part = quotient(rest, &common);
        T::tidy(&mut part);
        parts.push(polynomial.with_powers(part));
        rest = common;
    }
    parts
}

fn derivative<T: Solvable>(f: &[T]) -> Vec<T> {
    (1..).zip(&f[1..]).map(|(k, c)| T::int(k) * c).collect()
}

/// The greatest common divisor of coefficients from the lowest power up, the highest not zero.
fn common_divisor<T: Solvable>(mut f: Vec<T>, mut g: Vec<T>) -> Vec<T> {
    while !g.is_empty() {
        let mut rest = f;
        while rest.len() >= g.len() {
            let [high, low] = [&rest, &g].map(|h| h[h.len() - 1].clone());
            rest.iter_mut().for_each(|c| *c *= &low);
            let shift = rest.len() - g.len();
            rest[shift..].iter_mut().zip(&g).for_each(|(c, d)| *c -= high.clone() * d);
            trim(&mut rest);
        }
        T::tidy(&mut rest);
        (f, g) = (g, rest);
    }
    f
}

/// The quotient of a division without remainder.
fn quotient<T: Solvable>(mut f: Vec<T>, g: &[T]) -> Vec<T> {
    let (top, lead) = (g.len() - 1, &g[g.len() - 1]);
    let mut quotient = vec![T::zero(); f.len() - top];
    for (k, q) in quotient.iter_mut().enumerate().rev() {
        *q = f[k + top].clone() / lead;
        f[k..].iter_mut().zip(g).for_each(|(c, d)| *c -= q.clone() * d);
    }
    quotient
}

/// Leaves out the highest coefficients that are zero.
fn trim<T: Solvable>(f: &mut Vec<T>) {
    while f.last().is_some_and(T::is_zero) {
        f.pop();
    }
}
