//! Laws of approximations over `f64`: bounds hold for the exact numbers, and what was added goes again.

use crate::rounding::{error, exact, function, largest};
use crate::strategies::{cases, probes};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{Approximation, Contact, Continuity, Function, Q};

const EPS: f64 = f64::EPSILON;

/// Checks the bound against exact values.
fn check(f: &Function<f64>, near: &Approximation<Function<f64>, f64>) -> Result<(), TestCaseError> {
    let (f, g, bound) = (exact(f)?, exact(&near.spline)?, Q::try_from(near.bound)?);
    for x in probes(f.space()) {
        let left = if x == *f.domain().0 { f.domain().1 } else { &x };
        prop_assert!((f.at(&x)? - g.at(&x)?).abs() <= bound);
        prop_assert!((f.at_left(left)? - g.at_left(left)?).abs() <= bound);
    }
    Ok(())
}

/// Knots inside the spans of a function.
fn knots(f: &Function<f64>, places: &[(Index, u8)]) -> Vec<f64> {
    let breaks = f.space().breaks();
    let knot = |(place, sixteenths): &(Index, u8)| {
        let i = place.index(breaks.len() - 1);
        breaks[i].0 + (breaks[i + 1].0 - breaks[i].0) * f64::from(*sixteenths) / 16.0
    };
    places.iter().map(knot).collect()
}

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn elevation_is_undone_nearly(f in function(), raise in 1_usize..4) {
        let raised = f.elevated(raise)?;
        let near = raised.degree_lowered(raise)?;
        check(&raised, &near)?;
        prop_assert_eq!(near.spline.space(), f.space());
        // Each degree less doubles errors in the middle of a piece, and spans of uneven length amplify them.
        let (exact, p) = (exact(&f)?, f.degree() as i32);
        let error = error(near.spline.coeffs(), exact.coeffs(), &largest(exact.coeffs()));
        prop_assert!(error <= 16.0 * 4.0_f64.powi(p + raise as i32) * EPS, "{}", error / EPS);
    }

    #[test]
    fn insertion_is_undone_within_a_tolerance(f in function(), places in vec((any::<Index>(), 1_u8..16), 0..8)) {
        let Ok(fine) = f.inserted(&knots(&f, &places)) else { return Ok(()) };
        let tolerance = 1e-9;
        let thin = fine.without_spare_knots(&tolerance)?;
        check(&fine, &thin)?;
        prop_assert!(thin.bound <= tolerance);
        prop_assert!(thin.spline.space().dim() <= f.space().dim());
    }

    #[test]
    fn coarse_tolerances_are_certified(f in function(), hundredths in 1_u8..100) {
        let tolerance = f64::from(hundredths) / 100.0;
        for near in [f.without_spare_knots(&tolerance)?, f.simplified_within(&tolerance)?] {
            prop_assert!(near.bound <= tolerance);
            check(&f, &near)?;
        }
    }

    #[test]
    fn least_squares_are_certified(f in function()) {
        prop_assume!(f.degree() > 0);
        for continuity in [Continuity::Kept, Continuity::Breaks, Continuity::AtMost(0)] {
            check(&f, &f.degree_reduced(1, continuity, Contact::FREE)?)?;
        }
        // A single constant has no two ends to hold.
        if !f.space().is_periodic() && f.space().dim() > 2 {
            let near = f.degree_reduced(1, Continuity::AtMost(0), Contact::both(1))?;
            check(&f, &near)?;
            let ends = |f: &Function<f64>| [f.coeffs()[0], f.coeffs()[f.coeffs().len() - 1]];
            prop_assert_eq!(ends(&near.spline), ends(&f));
        }
    }

    #[test]
    fn elevated_and_refined_splines_are_simplified(f in function(), places in vec((any::<Index>(), 1_u8..16), 0..4)) {
        prop_assume!(f.degree() <= 5);
        let raised = f.elevated(1)?;
        let Ok(fine) = raised.inserted(&knots(&f, &places)) else { return Ok(()) };
        let simple = fine.simplified_within(&1e-8)?;
        check(&fine, &simple)?;
        prop_assert!(simple.spline.degree() <= f.degree());
        prop_assert!(simple.spline.space().dim() <= f.space().dim());
    }
}
