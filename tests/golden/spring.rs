//! Closed curves relaxed by springs, [Miura, (13)]: floats, found by descent in another program.
//!
//! Leg `i` of the file goes from control `i` to the next, as coefficients of the periodic space stand (see `closed`).

use crate::check::for_each;
use crate::data::Case;
use nalgebra::{Point2, SVector};
use symspline::{Curve, Function, Result, Springs};

/// The bounds the file states: of energies, of lengths at the minimum, and of numbers that are only rounded.
const ENERGY: f64 = 1e-8;
const LENGTH: f64 = 1e-5;
const ROUNDED: f64 = 1e-14;

fn check(case: Case, key: &str, found: &[f64], bound: f64) {
    let expected: Vec<f64> = case.get(key).list().map(Case::float).collect();
    assert_eq!(found.len(), expected.len(), "{} {key}", case.id());
    for (i, (x, y)) in found.iter().zip(&expected).enumerate() {
        assert!((x - y).abs() <= bound, "{} {key}[{i}]: {x} instead of {y}", case.id());
    }
}

fn lengths(legs: &[SVector<f64, 2>], unit: f64) -> Vec<f64> {
    legs.iter().map(|leg| leg.norm() * unit).collect()
}

/// The first `count` legs of the open result over double knots, which are those of the ring.
fn wanted(curve: &Curve<f64, 2>, alpha: &Function<f64>) -> Result<Vec<SVector<f64, 2>>> {
    let ring = curve.space().elevated(1)?;
    let opened = curve.fine_tuned(alpha)?.embedded(&ring.unclamped_ends()?)?;
    Ok(opened.coeffs().windows(2).map(|pair| pair[1] - pair[0]).take(ring.dim()).collect())
}

fn relaxation(case: Case) -> Result<()> {
    let id = case.id();
    let curve = Curve::closed(2, case.get("polygon").points::<f64, 2>())?;
    let alpha = Function::closed(1, case.get("a").numbers())?;
    let prescale = case.get("prescale").float();
    let legs = wanted(&curve, &alpha)?;
    check(case, "l_opt", &lengths(&legs, prescale), ROUNDED);
    let angle = |i: usize| {
        let (u, v) = (legs[(i + legs.len() - 1) % legs.len()], legs[i]);
        u.perp(&v).atan2(u.dot(&v))
    };
    let angles: Vec<f64> = (0..legs.len()).map(angle).collect();
    check(case, "theta_opt", &angles, ROUNDED);

    let springs = Springs {
        stretch: case.get("k_l").float(),
        bend: case.get("k_a").float(),
        tolerance: 1e-11,
        ..Springs::default()
    };
    let relaxed = curve.fine_tuned_closed(&alpha, &springs)?;
    assert!(relaxed.converged, "{id}");
    for (key, found) in [("E_initial", relaxed.energy_before), ("E_min", relaxed.energy)] {
        let expected = case.get(key).float();
        assert!((found - expected).abs() <= ENERGY, "{id} {key}: {found} instead of {expected}");
    }
    let points = relaxed.curve.coeffs();
    let next = points.iter().cycle().skip(1);
    let found: Vec<_> = points.iter().zip(next).map(|(p, q)| q - p).collect();
    check(case, "l_min", &lengths(&found, prescale), LENGTH);
    assert_eq!(Point2::from(points[0]), Point2::from(curve.elevated(1)?.coeffs()[0]), "{id}");
    Ok(())
}

#[test]
fn closed_spring() {
    for_each("closed_spring", 2, relaxation);
}
