//! Polynomials on the ellipses of [`gauss`](super::gauss): powers about the middle, and a bound for what they leave
//! out.
//!
//! In `z = 2t - 1` the polynomial with Bernstein coefficients `b` of degree `q` is
//!
//! ```text
//! Σ b_i C(q, i) (1 + z)^i (1 - z)^(q-i) / 2^q = Σ f_k z^k
//! ```
//!
//! Rounding moves `f_k` by a multiple of `C(q, k) max |b|`, so the whole by that of `(1 + r)^q max |b|` where `|z| <=
//! r`. In high degrees that would be too much. Then only the first terms are kept. What is left has small Bernstein
//! coefficients on a small piece, and on the ellipse it is at most the largest of them times `(|t| + |1 - t|)^q <=
//! r^q`.

use super::gauss::{PerEllipse, RADII, per_ellipse};
use crate::bernstein::binomials;
use crate::coeff::Coeff;

/// The highest degree of which all powers are used.
const POWERS: usize = 24;

/// In higher degrees, the largest binomial coefficient of a power that is used.
const LARGEST: f64 = 1e8;

/// The unit of rounding: half the distance of the next number from one.
pub(super) const UNIT: f64 = f64::EPSILON / 2.0;

/// Turns Bernstein coefficients of one degree into jets.
#[derive(Clone, Debug)]
pub(super) struct Centring {
    degree: usize,
    /// Row `k` has the weights of `f_k`.
    rows: Vec<Vec<f64>>,
    /// Row `k` has the Bernstein coefficients of `z^k`; none if all powers are kept.
    powers: Vec<Vec<f64>>,
    /// `Σ C(q, k) r^k` over the powers kept: how rounding grows.
    rounding: PerEllipse,
    /// `r^q`.
    growth: PerEllipse,
}

/// A polynomial near enough: `Σ terms_k z^k`, which on each ellipse is off by `rest` at most.
#[derive(Clone, Debug)]
pub(super) struct Jet<C> {
    terms: Vec<C>,
    rest: PerEllipse,
}

impl Centring {
    pub(super) fn new(degree: usize) -> Self {
        let q = degree;
        let choose = binomials::<f64>(q);
        let kept = if q <= POWERS { q } else { choose.iter().take_while(|c| **c <= LARGEST).count() - 1 };
        // The first coefficients of (1 + z)^i (1 - z)^(q-i), one list for each i.
        let product = |i: usize| {
            let mut product = vec![1.0; 1];
            product.resize(kept + 1, 0.0);
            for factor in 0..q {
                let sign = if factor < i { 1.0 } else { -1.0 };
                (1..=kept).rev().for_each(|k| product[k] += sign * product[k - 1]);
            }
            product
        };
        let products: Vec<Vec<f64>> = (0..=q).map(product).collect();
        let unit = (-(q as f64)).exp2();
        let row = |k: usize| products.iter().zip(&choose).map(|(product, c)| c * unit * product[k]).collect();
        let power = |k: usize| products.iter().map(|product| product[k] / choose[k]).collect();
        let terms = |r: f64| choose[..=kept].iter().rev().fold(0.0, |sum, c| sum * r + c);
        Self {
            degree: q,
            rows: (0..=kept).map(row).collect(),
            powers: if kept < q { (0..=kept).map(power).collect() } else { Vec::new() },
            rounding: RADII.map(terms),
            growth: RADII.map(|r| r.powi(q as i32)),
        }
    }

    /// The jet of the polynomial with Bernstein coefficients `b`.
    pub(super) fn jet<C: Coeff<f64>>(&self, b: &[C]) -> Jet<C> {
        let term = |row: &Vec<f64>| C::combine(row.iter().zip(b)).expect("there is a coefficient");
        let terms: Vec<C> = self.rows.iter().map(term).collect();
        let unit = (self.degree + 2) as f64 * UNIT * b.iter().map(size).fold(0.0, f64::max);
        if self.powers.is_empty() {
            return Jet { terms, rest: self.rounding.map(|rounding| unit * rounding) };
        }
        let left = |i: usize| {
            let known = self.powers.iter().zip(&terms).map(|(power, term)| (power[i], term));
            size(&known.fold(b[i].clone(), |left, (power, term)| left.plus_scaled(&-power, term)))
        };
        // Subtracting is rounded in proportion to the terms.
        let terms_size: f64 = terms.iter().map(size).sum::<f64>() * (self.powers.len() + 2) as f64 * UNIT;
        let left = (0..b.len()).map(left).fold(0.0, f64::max) + terms_size + 2.0 * unit;
        let rest = per_ellipse(|e| unit * self.rounding[e] + left * self.growth[e]);
        Jet { terms, rest }
    }
}

impl<C: Coeff<f64>> Jet<C> {
    /// The value in the middle, but for rounding.
    pub(super) fn middle(&self) -> &C {
        &self.terms[0]
    }

    /// How far off [`middle`](Self::middle) the polynomial is at most on each ellipse.
    pub(super) fn spread(&self) -> PerEllipse {
        let sizes: Vec<f64> = self.terms[1..].iter().map(size).collect();
        per_ellipse(|e| {
            let powers = sizes.iter().rev().fold(0.0, |sum, size| (sum + size) * RADII[e]);
            powers + self.rest[e]
        })
    }

    /// The product under a bilinear pairing with `|pair(a, b)| <= |a| |b|`.
    pub(super) fn times<B: Coeff<f64>, D: Coeff<f64>>(
        &self,
        other: &Jet<B>,
        pair: impl Fn(&C, &B) -> D,
    ) -> Jet<D> {
        let (a, b) = (&self.terms, &other.terms);
        let term = |k: usize| {
            let meeting = k.saturating_sub(b.len() - 1)..=k.min(a.len() - 1);
            let products = meeting.map(|i| pair(&a[i], &b[k - i]));
            products.reduce(|sum, product| sum.plus_scaled(&1.0, &product)).expect("some terms meet")
        };
        let terms: Vec<D> = (0..a.len() + b.len() - 1).map(term).collect();
        let rounding = (a.len().min(b.len()) + 4) as f64 * UNIT;
        let (left, right) = (self.spread(), other.spread());
        let rest = per_ellipse(|e| {
            let (x, y) = (size(self.middle()) + left[e], size(other.middle()) + right[e]);
            x * other.rest[e] + self.rest[e] * y + rounding * x * y
        });
        Jet { terms, rest }
    }

    /// The difference.
    pub(super) fn minus(&self, other: &Self) -> Self {
        let zero = self.terms[0].zero_like();
        let count = self.terms.len().max(other.terms.len());
        let term = |k: usize| self.terms.get(k).unwrap_or(&zero).minus(other.terms.get(k).unwrap_or(&zero));
        let (left, right) = (self.spread(), other.spread());
        let sizes = |e: usize| size(self.middle()) + left[e] + size(other.middle()) + right[e];
        let rest = per_ellipse(|e| self.rest[e] + other.rest[e] + 2.0 * UNIT * sizes(e));
        Self { terms: (0..count).map(term).collect(), rest }
    }
}

/// The Euclidean length.
pub(super) fn size<C: Coeff<f64>>(c: &C) -> f64 {
    c.squared_size().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn jets_are_the_polynomials_on_the_ellipses() {
        for q in [0, 1, 2, 5, 16, 24, 25, 40, 100] {
            let b: Vec<f64> = (0..=q).map(|i| 1.0 + 0.01 * (0.7 * i as f64).sin()).collect();
            let jet = Centring::new(q).jet(&b);
            for (e, r) in RADII.iter().enumerate() {
                // At the end of the long axis.
                let t = (1.0 + r) / 2.0;
                let weights = binomials::<f64>(q).into_iter().enumerate();
                let terms =
                    weights.map(|(i, c)| c * t.powi(i as i32) * (1.0 - t).powi((q - i) as i32) * b[i]);
                let value: f64 = terms.sum();
                let powers = jet.terms.iter().rev().fold(0.0, |sum, f| sum * r + f);
                assert!((value - powers).abs() <= 4.0 * jet.rest[e], "{q} {r}");
                assert!((value - jet.middle()).abs() <= 4.0 * jet.rest[e] + jet.spread()[e], "{q} {r}");
                let square = jet.times(&jet, |x, y| x * y);
                assert!(
                    (value * value - square.middle()).abs() <= 4.0 * square.rest[e] + square.spread()[e],
                    "{q} {r}"
                );
                let powers = square.terms.iter().rev().fold(0.0, |sum, f| sum * r + f);
                assert!((value * value - powers).abs() <= 4.0 * square.rest[e], "{q} {r}");
                assert!(jet.minus(&jet).rest[e] >= jet.rest[e]);
            }
        }
    }
}
