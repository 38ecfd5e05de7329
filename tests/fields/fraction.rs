//! Fractions of polynomials in one symbol, the field in which "let a knot be `1 + x`" is meant literally.

use crate::signs::signs;
use std::cmp::Ordering;
use std::fmt;
use symspline::{Error, Q, Result, Scalar};

/// A polynomial by its coefficients, lower powers first, the last one not zero.
type Polynomial = Vec<Q>;

/// `above / below` in lowest terms, the last coefficient of `below` being one.
///
/// The symbol `x` is a positive number below all fractions: of two the larger is the one that is larger for small `x > 0`.
#[derive(Clone, Debug, PartialEq)]
pub struct Fraction {
    above: Polynomial,
    below: Polynomial,
}

impl Fraction {
    /// The symbol `x`.
    pub fn symbol() -> Self {
        Self { above: vec![Q::int(0), Q::int(1)], below: vec![Q::int(1)] }
    }

    /// A constant.
    pub fn constant(value: Q) -> Self {
        Self::reduced(vec![value], vec![Q::int(1)])
    }

    /// The value for the number `x` in place of the symbol.
    pub fn at(&self, x: &Q) -> Result<Q> {
        match value(&self.below, x) {
            zero if zero == Q::int(0) => Err(Error::NotFinite { what: "fraction", index: 0 }),
            below => Ok(value(&self.above, x) / below),
        }
    }

    /// The derivative by the symbol.
    pub fn derivative(&self) -> Self {
        let slope = |c: &Polynomial| -> Polynomial {
            c.iter().enumerate().skip(1).map(|(r, c)| Q::int(r as i64) * c).collect()
        };
        let [a, b] = [product(&slope(&self.above), &self.below), product(&self.above, &slope(&self.below))];
        Self::reduced(sum(&a, &b, &Q::int(-1)), product(&self.below, &self.below))
    }

    fn reduced(mut above: Polynomial, mut below: Polynomial) -> Self {
        trim(&mut above);
        trim(&mut below);
        let common = common_divisor(above.clone(), below.clone());
        let [(mut above, _), (mut below, _)] = [divided(above, &common), divided(below, &common)];
        let last = below.last().expect("no division by zero").clone();
        above.iter_mut().chain(&mut below).for_each(|c| *c /= &last);
        Self { above, below }
    }

    fn plus(&self, other: &Self) -> Self {
        let (a, b) = (product(&self.above, &other.below), product(&other.above, &self.below));
        Self::reduced(sum(&a, &b, &Q::int(1)), product(&self.below, &other.below))
    }

    fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negative())
    }

    fn negative(&self) -> Self {
        Self { above: self.above.iter().map(|c| -c.clone()).collect(), below: self.below.clone() }
    }

    fn times(&self, other: &Self) -> Self {
        Self::reduced(product(&self.above, &other.above), product(&self.below, &other.below))
    }

    fn over(&self, other: &Self) -> Self {
        Self::reduced(product(&self.above, &other.below), product(&self.below, &other.above))
    }
}

signs!(Fraction);

impl Scalar for Fraction {
    const EXACT: bool = true;

    fn int(n: i64) -> Self {
        Self::constant(Q::int(n))
    }
}

impl PartialOrd for Fraction {
    /// By the sign of the difference for small positive `x`: that of the lowest coefficients.
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let Self { above, below } = self.minus(other);
        let lowest = |c: &Polynomial| c.iter().find(|c| **c != Q::int(0)).cloned().unwrap_or(Q::int(0));
        (lowest(&above) * lowest(&below)).partial_cmp(&Q::int(0))
    }
}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let terms = |c: &Polynomial| -> String {
            let terms: Vec<String> = c.iter().enumerate().map(|(r, c)| format!("{c} x^{r}")).collect();
            if terms.is_empty() { "0".into() } else { terms.join(" + ") }
        };
        write!(f, "({}) / ({})", terms(&self.above), terms(&self.below))
    }
}

fn trim(c: &mut Polynomial) {
    while c.last().is_some_and(|c| *c == Q::int(0)) {
        c.pop();
    }
}

fn value(c: &Polynomial, x: &Q) -> Q {
    c.iter().rev().fold(Q::int(0), |value, c| value * x + c)
}

/// `a + weight b`.
fn sum(a: &Polynomial, b: &Polynomial, weight: &Q) -> Polynomial {
    let term = |c: &Polynomial, r: usize| c.get(r).cloned().unwrap_or(Q::int(0));
    (0..a.len().max(b.len())).map(|r| term(a, r) + weight.clone() * term(b, r)).collect()
}

fn product(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let mut product = vec![Q::int(0); (a.len() + b.len()).saturating_sub(1)];
    for (i, c) in a.iter().enumerate() {
        b.iter().enumerate().for_each(|(j, d)| product[i + j] += c.clone() * d);
    }
    product
}

/// Quotient and remainder.
fn divided(mut a: Polynomial, b: &Polynomial) -> (Polynomial, Polynomial) {
    let mut quotient = vec![Q::int(0); (a.len() + 1).saturating_sub(b.len())];
    for r in (0..quotient.len()).rev() {
        let factor = a[r + b.len() - 1].clone() / &b[b.len() - 1];
        b.iter().enumerate().for_each(|(j, d)| a[r + j] -= factor.clone() * d);
        quotient[r] = factor;
    }
    trim(&mut a);
    (quotient, a)
}

/// The greatest common divisor, by Euclid.
fn common_divisor(a: Polynomial, b: Polynomial) -> Polynomial {
    if b.is_empty() {
        return a;
    }
    let rest = divided(a, &b).1;
    common_divisor(b, rest)
}

#[test]
fn the_symbol_is_smaller_than_every_fraction_but_positive() {
    let x = Fraction::symbol();
    assert!(Fraction::int(0) < x && x < Fraction::frac(1, 1_000_000_000));
    assert!(x.clone() * &x < x && Fraction::int(1) / &x > Fraction::int(1_000_000_000));
    assert!(-x.clone() < Fraction::int(0) && Fraction::int(0) - &x < x);
}

#[test]
fn roots_are_bounded_in_any_field() {
    let four = Fraction::int(4).root_above();
    assert!(four.clone() * &four >= Fraction::int(4) && four < Fraction::frac(201, 100));
    // So that equal splines have no distance.
    assert_eq!(Fraction::int(0).root_above(), Fraction::int(0));
}

#[test]
fn fractions_are_in_lowest_terms() {
    let x = Fraction::symbol();
    let one = Fraction::int(1);
    let quotient = (x.clone() * &x - &one) / (x.clone() + &one);
    assert_eq!(quotient, x.clone() - &one);
    assert_eq!(quotient.to_string(), "(-1 x^0 + 1 x^1) / (1 x^0)");
    assert_eq!(x.clone() - &x, Fraction::int(0));
    assert_eq!((one / &x).derivative().at(&Q::int(2)), Ok(Q::frac(-1, 4)));
    assert!((Fraction::int(1) / &x).at(&Q::int(0)).is_err());
}
