//! Laws of rounding on uneven knots: spans from 1e-6 to 1e6 beside each other, in any order, degrees up to 10.
//!
//! No system is solved, and no step extrapolates further than it must: products and elevations stay exact to a few
//! units in the last place of the largest coefficient, however the knots lie.

use crate::rounding::{error, exact, largest};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{Function, SplineSpace};

/// Products, relative to the largest exact coefficient.
const PRODUCT: f64 = 1e-13;
/// Elevations, relative to the largest exact coefficient.
const ELEVATION: f64 = 1e-14;

/// Numbers without order in `[0, 1)`, the same in every run.
struct Draw(u64);

impl Draw {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() * n as f64) as usize
    }
}

/// The ends of spans with these lengths.
fn breaks(widths: &[f64]) -> Vec<f64> {
    let sum = |at: &mut f64, width: &f64| {
        *at += width;
        Some(*at)
    };
    [0.0].into_iter().chain(widths.iter().scan(0.0, sum)).collect()
}

/// Lengths from 1e-6 to 1e6, a decade apart, shuffled.
fn shuffled(draw: &mut Draw) -> Vec<f64> {
    let mut widths: Vec<f64> = (-6..=6).map(|decade| 10_f64.powi(decade) * (1.0 + draw.next())).collect();
    (1..widths.len()).rev().for_each(|i| widths.swap(i, draw.below(i + 1)));
    widths
}

/// A spline on some of the breaks, most knots simple.
fn spline(degree: usize, breaks: &[f64], draw: &mut Draw) -> Function<f64> {
    let mut knots = vec![breaks[0]];
    for t in &breaks[1..breaks.len() - 1] {
        let copies = match draw.below(8) {
            0 => 0,
            1 => 2.min(degree),
            2 => degree,
            _ => 1,
        };
        knots.extend(vec![*t; copies]);
    }
    knots.push(breaks[breaks.len() - 1]);
    let space = SplineSpace::clamped(degree, knots).expect("ascending knots");
    let coeffs = (0..space.dim()).map(|_| 2.0 * draw.next() - 1.0).collect();
    Function::new(space, coeffs).expect("as many coefficients as the space has")
}

/// How far the product is off, relative to its largest coefficient.
fn product_error(f: &Function<f64>, g: &Function<f64>) -> symspline::Result<f64> {
    let (found, expected) = (f.times(g)?, exact(f)?.times(&exact(g)?)?);
    Ok(error(found.coeffs(), expected.coeffs(), &largest(expected.coeffs())))
}

/// How far the elevation is off, relative to its largest coefficient.
fn elevation_error(f: &Function<f64>, raise: usize) -> symspline::Result<f64> {
    let (found, expected) = (f.elevated(raise)?, exact(f)?.elevated(raise)?);
    Ok(error(found.coeffs(), expected.coeffs(), &largest(expected.coeffs())))
}

#[test]
fn products_on_uneven_knots_are_near() -> symspline::Result<()> {
    let mut draw = Draw(1);
    for (p, q) in [(3, 3), (3, 1), (6, 6), (6, 2), (10, 10), (10, 3)] {
        for _ in 0..if p == 10 { 3 } else { 8 } {
            let widths = shuffled(&mut draw);
            let breaks = breaks(&widths[..if p == 10 { 7 } else { 13 }]);
            let (f, g) = (spline(p, &breaks, &mut draw), spline(q, &breaks, &mut draw));
            let error = product_error(&f, &g)?;
            assert!(error <= PRODUCT, "degrees {p} and {q}: {error:e}");
        }
    }
    Ok(())
}

#[test]
fn elevations_on_uneven_knots_are_near() -> symspline::Result<()> {
    let mut draw = Draw(2);
    for degree in 1..=8 {
        for raise in 1..=9 - degree {
            let breaks = breaks(&shuffled(&mut draw));
            let error = elevation_error(&spline(degree, &breaks, &mut draw), raise)?;
            assert!(error <= ELEVATION, "degree {degree} raised by {raise}: {error:e}");
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(crate::strategies::cases(16))]

    #[test]
    fn products_are_near_however_the_knots_lie(
        exponents in vec(-6.0_f64..6.0, 1..7),
        (p, q) in (1_usize..=6, 0_usize..=6),
        seed in any::<u64>(),
    ) {
        let widths: Vec<f64> = exponents.iter().map(|e| 10_f64.powf(*e)).collect();
        let (breaks, mut draw) = (breaks(&widths), Draw(seed));
        let (f, g) = (spline(p, &breaks, &mut draw), spline(q, &breaks, &mut draw));
        let error = product_error(&f, &g)?;
        prop_assert!(error <= PRODUCT, "{error:e}");
    }

    #[test]
    fn elevations_are_near_however_the_knots_lie(
        exponents in vec(-6.0_f64..6.0, 1..9),
        (p, raise) in (1_usize..=8, 1_usize..=3),
        seed in any::<u64>(),
    ) {
        let widths: Vec<f64> = exponents.iter().map(|e| 10_f64.powf(*e)).collect();
        let error = elevation_error(&spline(p, &breaks(&widths), &mut Draw(seed)), raise)?;
        prop_assert!(error <= ELEVATION, "{error:e}");
    }
}
