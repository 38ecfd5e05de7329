//! Gauss-Legendre quadrature with a bound of its error.
//!
//! The rule of `n` nodes integrates polynomials of degree `2n - 1` over `[-1, 1]`. For a function analytic in the
//! ellipse `E_ρ` with foci `±1` and half axes that add up to `ρ > 1`, bounded there by `M`, its error is at most
//!
//! ```text
//! (64 / 15) M / ((1 - ρ⁻²) ρ²ⁿ)                      [Trefethen, Theorem 19.3]
//! ```
//!
//! `E_ρ` lies in the disc `|z| <= r = (ρ + 1/ρ) / 2`; and with `t = (1 + z) / 2` it has `|t| + |1 - t| <= r`.

use std::array::from_fn;
use std::sync::LazyLock;

/// How many nodes the rules have.
const NODES: [usize; 8] = [4, 6, 8, 10, 12, 16, 20, 24];

/// The ellipses that are tried, by `ρ`.
const ELLIPSES: [f64; 10] = [1.25, 1.5, 1.8, 2.2, 2.7, 3.4, 4.5, 6.5, 11.0, 24.0];

/// A number for each ellipse.
pub(super) type PerEllipse = [f64; ELLIPSES.len()];

/// The largest `|z|` on each ellipse.
pub(super) static RADII: LazyLock<PerEllipse> = LazyLock::new(|| ELLIPSES.map(|rho| (rho + 1.0 / rho) / 2.0));

/// The rules, fewest nodes first.
pub(super) static RULES: LazyLock<[Rule; NODES.len()]> = LazyLock::new(|| NODES.map(Rule::new));

/// A rule on `[0, 1]`.
#[derive(Debug)]
pub(crate) struct Rule {
    /// Nodes and weights; the weights add up to one.
    nodes: Vec<(f64, f64)>,
    /// The error of the rule on `[0, 1]` is at most this times the largest magnitude on the ellipse.
    factors: PerEllipse,
}

impl Rule {
    /// The rule of `count` nodes.
    pub(crate) fn new(count: usize) -> Self {
        let node = |i: usize| {
            // Newton's method for zero i of the Legendre polynomial.
            let guess = (std::f64::consts::PI * (i as f64 + 0.75) / (count as f64 + 0.5)).cos();
            let step = |z: f64, _| {
                let (value, slope) = legendre(count, z);
                z - value / slope
            };
            let z = (0..8).fold(guess, step);
            let slope = legendre(count, z).1;
            ((1.0 - z) / 2.0, 1.0 / ((1.0 - z * z) * slope * slope))
        };
        let factor = |rho: f64| 32.0 / 15.0 / ((1.0 - rho.powi(-2)) * rho.powi(2 * count as i32));
        Self { nodes: (0..count).map(node).collect(), factors: ELLIPSES.map(factor) }
    }

    /// Nodes and weights on `[0, 1]`; the weights add up to one.
    pub(crate) fn nodes(&self) -> &[(f64, f64)] {
        &self.nodes
    }

    /// How many nodes it has.
    pub(super) fn count(&self) -> usize {
        self.nodes.len()
    }

    /// The mean of `f` on `[a, b]`.
    #[inline]
    pub(super) fn mean(&self, a: f64, b: f64, f: impl Fn(f64) -> f64) -> f64 {
        self.nodes.iter().map(|(t, weight)| weight * f(a + (b - a) * t)).sum()
    }

    /// The error of the integral over `[0, 1]` of a function that is analytic in those of the ellipses where `most` is
    /// finite, and bounded by it there.
    pub(super) fn error(&self, most: &PerEllipse) -> f64 {
        self.factors.iter().zip(most).map(|(factor, most)| factor * most).fold(f64::INFINITY, f64::min)
    }
}

/// The Legendre polynomial of degree `n` and its slope at `z`, inside `(-1, 1)`.
fn legendre(n: usize, z: f64) -> (f64, f64) {
    let step = |(before, now): (f64, f64), k: usize| {
        let k = k as f64;
        (now, ((2.0 * k + 1.0) * z * now - k * before) / (k + 1.0))
    };
    let (before, value) = (1..n).fold((1.0, z), step);
    (value, n as f64 * (z * value - before) / (z * z - 1.0))
}

/// For each ellipse what `f` says of its number.
pub(super) fn per_ellipse(f: impl Fn(usize) -> f64) -> PerEllipse {
    from_fn(f)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_are_exact_for_polynomials_of_twice_their_degree() {
        for rule in RULES.iter() {
            for power in 0..2 * rule.count() as i32 {
                let mean = rule.mean(0.0, 1.0, |t| t.powi(power));
                assert!((mean * f64::from(power + 1) - 1.0).abs() < 1e-13, "{} {power}", rule.count());
            }
        }
    }

    #[test]
    fn the_bound_is_that_of_the_theorem() {
        // On half the interval length: 32 / 15 with ρ = 1.5 and n = 4, where 1 - ρ⁻² = 5 / 9.
        let one = per_ellipse(|e| if ELLIPSES[e] == 1.5 { 1.0 } else { f64::INFINITY });
        let expected = 32.0 / 15.0 * 9.0 / 5.0 * (2.0_f64 / 3.0).powi(8);
        assert!((RULES[0].error(&one) / expected - 1.0).abs() < 1e-14);
    }

    /// `1 / (c - z)` on `[-1, 1]` is `1 / (c - r)` at most on the ellipse, and its integral is a logarithm.
    #[test]
    fn the_error_is_below_its_bound() {
        for pole in [1.2, 1.5, 2.0, 4.0] {
            let exact = ((pole + 1.0) / (pole - 1.0_f64)).ln() / 2.0;
            for rule in RULES.iter() {
                let error = (rule.mean(0.0, 1.0, |t| 1.0 / (pole - (2.0 * t - 1.0))) - exact).abs();
                let most = RADII.map(|r| if r < pole { 1.0 / (pole - r) } else { f64::INFINITY });
                let bound = rule.error(&most);
                assert!(error <= bound + 1e-15, "{pole} {}: {error} {bound}", rule.count());
            }
        }
        let near = RADII.map(|r| if r < 2.0 { 1.0 / (2.0 - r) } else { f64::INFINITY });
        assert!(RULES[4].error(&near) < 1e-10);
    }
}
