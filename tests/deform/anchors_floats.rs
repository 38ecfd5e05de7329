//! Constraints over floats: met but for rounding, however long the chain, or refused.

use nalgebra::vector;
use symspline::{
    Anchored, Breadth, Constraints, DeformError, Elastic, Error, Function, Material, NurbsCurve, Result,
    ShapeError, Spline, SplineSpace, Weighted,
};

/// A wave on a ring or a chain of 3000 control points, and so many places from its start on.
fn long(ring: bool, count: usize, reach: f64) -> Result<(Function<f64>, Vec<f64>)> {
    let space = if ring {
        SplineSpace::uniform_periodic(3, 3000, 0.0, 1.0)?
    } else {
        SplineSpace::uniform(3, 2997, 0.0, 1.0)?
    };
    let wave = (0..3000).map(|i| f64::from(i * 7919 % 1000) / 1000.0).collect();
    let place = |i: usize| 0.01 + reach * (i as f64 + 0.2 * (i % 2) as f64) / count as f64;
    Ok((Function::new(space, wave)?, (0..count).map(place).collect()))
}

fn anchored(f: &Function<f64>, weights: [f64; 3], places: &[f64]) -> Result<Anchored<f64, Function<f64>>> {
    let breadth = if f.space().is_periodic() { Breadth::Whole } else { Breadth::BetweenEnds(1) };
    let elastic = Elastic::of(f, &Material::of_orders(weights)?, &[breadth])?;
    elastic.anchored(&places.iter().try_fold(Constraints::on(f), Constraints::point)?)
}

fn most(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(0.0, |most, x| most.max(x.abs()))
}

#[test]
fn long_chains_meet_their_constraints() -> Result<()> {
    for (ring, count, reach) in [(true, 40, 0.05), (true, 200, 0.3), (false, 200, 0.3)] {
        let (mut f, places) = long(ring, count, reach)?;
        let held = anchored(&f, [1.0, 1.0, 1.0], &places)?;
        let targets: Vec<f64> = (0..count).map(|i| (i * 37 % 11) as f64 / 11.0).collect();
        held.meet(&mut f, &targets)?;
        let size = most(f.coeffs().iter().copied());
        let off = most(places.iter().zip(&targets).map(|(x, target)| f.at(x).expect("inside") - target));
        assert!(off <= 1e-13 * size, "{ring} {count}: {off:e} of {size:e}");
    }
    Ok(())
}

/// What is relaxed stays where it is, up to the root of what the condition of the stiffness would allow.
#[test]
fn long_chains_come_to_rest_at_once() -> Result<()> {
    for (weights, reach) in [([0.0, 0.0, 1.0], 0.003), ([0.0, 1.0, 1.0], 0.3)] {
        let (mut f, places) = long(false, 5, reach)?;
        let held = anchored(&f, weights, &places)?;
        held.relax(&mut f)?;
        let rest = f.clone();
        held.relax(&mut f)?;
        let size = most(rest.coeffs().iter().copied());
        let moved = most(f.coeffs().iter().zip(rest.coeffs()).map(|(x, y)| x - y));
        assert!(moved <= 1e-6 * size, "{weights:?}: {moved:e} of {size:e}");
    }
    Ok(())
}

#[test]
fn what_rounding_does_not_tell_apart_is_refused() -> Result<()> {
    let (mut f, places) = long(true, 200, 0.1)?;
    let before = f.clone();
    let held = anchored(&f, [1.0, 1.0, 1.0], &places)?;
    let targets: Vec<f64> = (0..200).map(|i| f64::from(i * 37 % 11)).collect();
    let refused = held.meet(&mut f, &targets).unwrap_err();
    assert!(matches!(refused, Error::Deform(DeformError::Unmet { .. })), "{refused}");
    assert_eq!(f, before);
    Ok(())
}

/// A control point at infinity that no constraint weighs is no obstacle.
#[test]
fn control_points_at_infinity_may_be_held() -> Result<()> {
    let weighted = |x: f64| Weighted { point: vector![x, 0.0], weight: if x == 0.0 { 0.0 } else { 1.0 } };
    let space = SplineSpace::new(2, (0..10).map(f64::from))?;
    let mut curve =
        NurbsCurve::from_lifted(Spline::new(space, (0..7).map(|x| weighted(f64::from(x))).collect())?)?;
    let elastic = Elastic::of(&curve, &Material::new(1.0, 1.0)?, &[Breadth::Range(3..5)])?;
    let held = elastic.anchored(&Constraints::on(&curve).point(&5.5)?)?;
    let target = curve.at(&5.5)? + vector![0.0, 1.0];
    held.drag(&mut curve, &[vector![0.0, 1.0]])?;
    assert!((curve.at(&5.5)? - target).norm() < 1e-12);
    Ok(())
}

/// The forces are those of all passes: they alone make the movement.
#[test]
fn forces_make_the_movement() -> Result<()> {
    let mut f = Function::constant(SplineSpace::uniform(3, 97, 0.0, 1.0)?, 0.0)?;
    let places: Vec<f64> = (1..10).map(|i| f64::from(i) / 10.1).collect();
    let held = anchored(&f, [0.0, 1.0, 0.01], &places)?;
    let elastic = Elastic::of(&f, &Material::new(1.0, 0.01)?, &[Breadth::BetweenEnds(1)])?;
    let forces = held.meet(&mut f, &[1.0, 3.0, -2.0, 5.0, 0.0, 0.0, 1.0, 4.0, -7.0])?;
    let mut load = vec![0.0; 100];
    for (row, force) in held.rows().zip(&forces) {
        row.terms().iter().for_each(|(i, w)| load[*i] += w * force);
    }
    let moved = elastic.solved(&load)?;
    assert!(most(moved.iter().zip(f.coeffs()).map(|(x, y)| x - y)) < 1e-10);
    Ok(())
}

/// On a long chain that bends hardly anything holds points of one span apart, and still four of them are independent and five are
/// not.
#[test]
fn points_of_one_span_are_counted_on_long_chains() -> Result<()> {
    for spans in [20, 2000, 20_000] {
        let space = SplineSpace::uniform(3, spans, 0.0, 1.0)?;
        let mut f = Function::constant(space, 1.0)?;
        let places: Vec<f64> = (0..5).map(|i| 0.5 + (0.1 + 0.2 * f64::from(i)) / spans as f64).collect();
        let held = anchored(&f, [0.0, 0.0, 1.0], &places[..4])?;
        if held.meet(&mut f, &[1.0, 1.25, 1.5, 1.0]).is_ok() {
            assert!((f.at(&places[2])? - 1.5).abs() < 1e-6, "{spans}");
        }
        let five = anchored(&f, [0.0, 0.0, 1.0], &places).map(|_| ()).unwrap_err();
        let named = matches!(
            five,
            Error::Shape(ShapeError::Dependent { condition: 4, .. } | ShapeError::Overdetermined { .. })
        );
        assert!(named, "{spans}: {five}");
    }
    Ok(())
}
