//! Laws of relaxation, exact: what a step costs, and where it leads.

use crate::strategies::{ANY, Kind, cases, function, number};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use symspline::{
    Breadth, Curve, DeformError, Error, Forces, Function, Material, NurbsCurve, Q, Relaxation, Result,
    Scalar, SplineSpace, Stiffness,
};

const SHAPE: Kind = ANY.of_degree(0, 4).few(2);

fn material() -> impl Strategy<Value = Material<Q>> {
    let weight = select(vec![Q::int(0), Q::int(0), Q::int(1), Q::int(2), Q::frac(1, 3)]);
    vec(weight, 0..4).prop_map(|weights| Material::of_orders(weights).expect("weights from zero on"))
}

fn breadth(f: &Function<Q>, places: &[Index], whole: bool) -> Breadth<Q> {
    let listed = || places.iter().map(|i| i.index(f.space().dim())).collect();
    if whole { Breadth::Whole } else { Breadth::Listed(listed()) }
}

fn work(force: &[Q], way: &[Q]) -> Q {
    Q::dot(force.iter().zip(way))
}

/// `∫ |f|²`.
fn mass(f: &Function<Q>) -> Result<Q> {
    Material::of_orders([Q::int(1)])?.energy(f)
}

fn steps() -> impl Strategy<Value = Q> {
    select(vec![Q::frac(1, 1000), Q::frac(1, 3), Q::int(1), Q::int(1_000_000)])
}

proptest! {
    #![proptest_config(cases(16))]

    /// A step lowers the energy by what its way costs, and holds what is to be held.
    #[test]
    fn each_step_lowers_the_energy(
        f in function(SHAPE), material in material(), tau in steps(), load in vec(number(), 48), places in vec(any::<Index>(), 4),
        whole in any::<bool>(),
    ) {
        let load = &load[..f.coeffs().len()];
        let breadth = breadth(&f, &places, whole);
        let relaxation = Relaxation::new(f.space(), &material, &breadth, tau.clone())?;
        let mut after = f.clone();
        relaxation.step_under(&mut after, load)?;
        let way = after.difference(&f)?;
        let energy = |f: &Function<Q>| Ok::<Q, Error>(material.energy(f)? - Q::int(2) * work(load, f.coeffs()));
        let lost = material.energy(&way)? + Q::int(2) / &tau * mass(&way)?;
        prop_assert_eq!(energy(&f)? - energy(&after)?, lost);
        let moving = breadth.coeffs(f.space())?;
        for i in (0..f.coeffs().len()).filter(|i| !moving.contains(i)) {
            prop_assert_eq!(&after.coeffs()[i], &f.coeffs()[i]);
        }
        // The implicit equation itself.
        let [medium, force] = [Material::of_orders([Q::int(1)])?.matrix(f.space())?, material.matrix(f.space())?];
        let (slowed, pulled) = (medium.apply(way.coeffs())?, force.apply(after.coeffs())?);
        for i in moving {
            prop_assert_eq!(&slowed[i], &(tau.clone() * (load[i].clone() - &pulled[i])));
        }
    }

    /// The least energy is where nothing moves, and a step leaves at most `∫ |f - g|² / (4 τ)` to it.
    #[test]
    fn steps_lead_to_the_least_energy(
        f in function(SHAPE), material in material(), tau in steps(), load in vec(number(), 48), places in vec(any::<Index>(), 4),
        whole in any::<bool>(),
    ) {
        let load = &load[..f.coeffs().len()];
        let breadth = breadth(&f, &places, whole);
        let Ok(stiffness) = Stiffness::new(f.space(), &material, &breadth) else { return Ok(()) };
        let off: Vec<Q> = material.matrix(f.space())?.apply(f.coeffs())?;
        let rest: Vec<Q> = load.iter().zip(&off).map(|(x, y)| x.clone() - y).collect();
        let least = f.sum(&Function::new(f.space().clone(), stiffness.solved(&rest)?)?)?;
        let relaxation = Relaxation::new(f.space(), &material, &breadth, tau.clone())?;
        let mut still = least.clone();
        relaxation.step_under(&mut still, load)?;
        prop_assert_eq!(&still, &least);
        let mut after = f.clone();
        relaxation.step_under(&mut after, load)?;
        let left = material.energy(&after.difference(&least)?)?;
        prop_assert!(Q::int(4) * tau * left <= mass(&f.difference(&least)?)?);
    }
}

/// Rational curves move by their control points.
#[test]
fn forces_and_rational_curves() -> Result<()> {
    let space = SplineSpace::uniform(2, 3, Q::int(0), Q::int(1))?;
    let points: Vec<_> =
        [0, 5, -3, 4, 1].iter().zip(0..).map(|(y, x)| nalgebra::vector![Q::int(x), Q::int(*y)]).collect();
    let mut curve = Curve::new(space.clone(), points.clone())?;
    let mut rational = NurbsCurve::new(space.clone(), points, [1, 2, 3, 1, 1].map(Q::int).to_vec())?;
    let material = Material::new(Q::int(1), Q::int(1))?;
    let relaxation = Relaxation::new(&space, &material, &Breadth::BetweenEnds(1), Q::frac(1, 10))?;
    let mut forces = Forces::new(relaxation.body(), &curve)?;
    let load = forces.at(&Q::frac(1, 2), nalgebra::vector![Q::int(0), Q::int(9)])?.load()?;
    relaxation.step_under(&mut curve, &load)?;
    relaxation.step_under(&mut rational, &load)?;
    assert_eq!(symspline::Controlled::control_points(&rational)?, curve.coeffs());
    Ok(())
}

#[test]
fn floats_come_to_rest() -> Result<()> {
    let space = SplineSpace::uniform(3, 20, 0.0, 1.0)?;
    let mut curve = Function::new(space.clone(), (0..23).map(|i| f64::from(i * 7 % 11)).collect())?;
    let material = Material::new(1.0, 0.01)?;
    let relaxation = Relaxation::new(&space, &material, &Breadth::BetweenEnds(1), 0.01)?;
    let mut energy = material.energy(&curve)?;
    for _ in 0..500 {
        relaxation.step(&mut curve)?;
        let now = material.energy(&curve)?;
        assert!(now <= energy * (1.0 + 1e-12));
        energy = now;
    }
    let (start, end) = (curve.coeffs()[0], curve.coeffs()[22]);
    let straight = |x: f64| start + (end - start) * x;
    assert!((curve.at(&0.3)? - straight(0.3)).abs() < 1e-9);
    Ok(())
}

#[test]
fn hostile_steps_are_refused() -> Result<()> {
    let space = SplineSpace::uniform(3, 4, 0.0, 1.0)?;
    let material = Material::new(1.0, 1.0)?;
    for step in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = Relaxation::new(&space, &material, &Breadth::Whole, step);
        assert!(matches!(refused, Err(Error::Deform(DeformError::Step { .. }))));
    }
    for step in [1e-300, 1e300, 1e308] {
        for breadth in [Breadth::Whole, Breadth::BetweenEnds(2)] {
            let mut curve = Function::new(space.clone(), (0..7).map(|i| f64::from(i * i)).collect())?;
            let before = curve.clone();
            let done = Relaxation::new(&space, &material, &breadth, step).and_then(|r| r.step(&mut curve));
            assert!(done.is_ok() || curve == before);
        }
    }
    let relaxation = Relaxation::new(&space, &material, &Breadth::Whole, 1.0)?;
    let mut other = Function::constant(SplineSpace::uniform(3, 5, 0.0, 1.0)?, 0.0)?;
    assert!(matches!(relaxation.step(&mut other), Err(Error::Deform(DeformError::OtherSpace { .. }))));
    let mut huge = Function::new(space, vec![1e308, -1e308, 1e308, -1e308, 1e308, -1e308, 1e308])?;
    assert!(matches!(relaxation.step(&mut huge), Err(Error::NotFinite { .. })));
    assert!(matches!(relaxation.step_under(&mut huge, &[1.0]), Err(Error::CoefficientCount { .. })));
    Ok(())
}
