//! Laws of scale functions under conditions: met exactly, nearest, positive.

use crate::strategies::{ANY, CLAMPED, Kind, RING, cases, curve_and_function, number, point, probes};
use proptest::prelude::*;
use symspline::{
    Condition, Curve, Error, FineTuner, Function, NearestScale, Norm, Q, Scalar, Scale, TuneError,
};

const CURVE: Kind = ANY.of_degree(1, 3).smooth(1).few(2);
const SCALE: Kind = ANY.of_degree(0, 2).few(2);
const NORMS: [Norm; 2] = [Norm::Coefficients, Norm::L2];

/// Conditions that the curve itself meets.
fn own(c: &Curve<Q, 2>, choice: usize, x: &Q) -> Vec<Condition<Q, 2>> {
    let at = |x: &Q| c.at(x).expect("inside");
    let (a, parameter) = (c.domain().0.clone(), x.clone());
    match choice {
        0 => vec![Condition::End],
        1 => vec![Condition::Point { parameter, point: at(x) }],
        2 => vec![Condition::Chord { from: parameter, to: a.clone(), chord: at(&a) - at(x) }],
        3 => vec![Condition::End, Condition::Derivatives { parameter, count: 2 }],
        4 => vec![Condition::Coefficient { index: 0, value: Q::int(1) }, Condition::End],
        _ => vec![Condition::Scale { parameter, value: Q::int(1) }],
    }
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn what_the_curve_meets_is_kept_exactly(
        (c, alpha) in curve_and_function::<2>(CURVE, SCALE), choice in 0_usize..6, place in any::<prop::sample::Index>(),
    ) {
        let probes = probes(c.space());
        let x = place.get(&probes);
        let conditions = own(&c, choice, x);
        let jumps = alpha.space().breaks().iter().any(|(_, copies)| *copies > alpha.degree());
        let (a, b) = (c.domain().0.clone(), c.domain().1.clone());
        for norm in NORMS {
            let nearest = NearestScale::prepare(&c, alpha.space(), &conditions, norm)?;
            let found = nearest.to_signed(&alpha)?;
            let tuned = c.fine_tuned(Scale::Signed(&found))?;
            let tuner = FineTuner::constrained(&c, alpha.space(), &conditions, norm)?.signed();
            prop_assert!(tuner.tuned(alpha.coeffs())?.clamped_ends()?.same_function(&tuned)?);
            prop_assert_eq!(tuner.tuned(found.coeffs())?, tuner.tuned(alpha.coeffs())?);
            match choice {
                0 | 4 => prop_assert_eq!(tuned.at(&b)?, c.at_left(&b)?),
                1 => prop_assert_eq!(tuned.at(x)?, c.at(x)?),
                2 => prop_assert_eq!(tuned.at(x)? - tuned.at(&a)?, c.at(x)? - c.at(&a)?),
                3 if !jumps => {
                    let [new, old] = [&tuned, &c].map(|f| f.derivative().and_then(|d| d.at(x)));
                    prop_assert_eq!(new?, old?);
                }
                _ => {}
            }
            // One is a scale that does all this, and stays.
            let one = Function::constant(alpha.space().clone(), Q::int(1))?;
            prop_assert_eq!(nearest.to(&one)?, one);
        }
    }

    #[test]
    fn rings_stay_closed((c, alpha) in curve_and_function::<2>(RING.of_degree(1, 3).smooth(1).few(2), RING.of_degree(0, 2).few(2))) {
        let tuner = FineTuner::constrained(&c, alpha.space(), &[Condition::End], Norm::L2)?.signed();
        let tuned = tuner.tuned(alpha.coeffs())?;
        prop_assert!(tuned.space().is_periodic());
        let found = NearestScale::prepare(&c, alpha.space(), &[Condition::End], Norm::L2)?.to_signed(&alpha)?;
        prop_assert!(tuned.derivative()?.same_function(&c.derivative()?.times(&found)?)?);
        prop_assert_eq!(tuned.at(c.domain().0)?, c.at(c.domain().0)?);
    }

    #[test]
    fn points_elsewhere_are_reached_or_refused(
        (c, alpha) in curve_and_function::<2>(CURVE, SCALE), place in any::<prop::sample::Index>(), to in point::<2>(),
    ) {
        let probes = probes(c.space());
        let parameter = place.get(&probes).clone();
        let condition = Condition::Point { parameter: parameter.clone(), point: to.clone() };
        match NearestScale::prepare(&c, alpha.space(), &[condition], Norm::L2)?.to_signed(&alpha) {
            Ok(found) => prop_assert_eq!(c.fine_tuned(Scale::Signed(&found))?.at(&parameter)?, to),
            Err(error) => prop_assert_eq!(error, Error::Clash { condition: 0 }),
        }
    }

    #[test]
    fn the_nearest_above_a_floor_is_that_of_some_set_of_values_at_it(
        (c, alpha) in curve_and_function::<2>(CLAMPED.of_degree(1, 3).smooth(1).few(1), CLAMPED.of_degree(0, 2).few(2)),
        choice in 0_usize..4, lift in number(), norm in 0_usize..2,
    ) {
        let (space, n, norm) = (alpha.space(), alpha.space().dim(), NORMS[norm]);
        prop_assume!(n <= 7);
        let alpha = alpha.translated(&lift)?;
        let b = c.domain().1.clone();
        let conditions = match choice {
            0 => vec![Condition::End],
            1 => vec![Condition::Point { parameter: b, point: c.at(c.domain().0)? * Q::frac(1, 3) }],
            2 => vec![Condition::Scale { parameter: b, value: Q::frac(1, 2) }],
            _ => vec![Condition::End, Condition::Scale { parameter: b, value: Q::int(2) }],
        };
        let floor = Q::frac(1, 10);
        let nearest = NearestScale::prepare(&c, space, &conditions, norm)?.above(floor.clone())?;
        let found = nearest.to(&alpha);
        let Ok(free) = nearest.to_signed(&alpha) else {
            let clashes = matches!(found, Err(Error::Clash { .. }));
            prop_assert!(clashes);
            return Ok(());
        };
        if free.positive_bound().is_ok() {
            prop_assert_eq!(found?, free);
            return Ok(());
        }
        // Every set of values held at the floor.
        let distance = |f: &Function<Q>| -> symspline::Result<Q> {
            let change = f.difference(&alpha)?;
            Ok(match norm {
                Norm::Coefficients => Q::dot(change.coeffs().iter().zip(change.coeffs())),
                Norm::L2 => change.inner(&change)?,
            })
        };
        let mut best: Option<(Q, Function<Q>)> = None;
        for set in 0_u32..1 << n {
            let mut conditions = conditions.clone();
            let held = (0..n).filter(|i| set >> i & 1 == 1);
            conditions.extend(held.map(|index| Condition::Coefficient { index, value: floor.clone() }));
            let Ok(f) = NearestScale::prepare(&c, space, &conditions, norm)?.to_signed(&alpha) else { continue };
            if f.coeffs().iter().all(|value| *value >= floor) {
                let distance = distance(&f)?;
                if best.as_ref().is_none_or(|(least, _)| distance < *least) {
                    best = Some((distance, f));
                }
            }
        }
        match (found, best) {
            (Ok(found), Some((_, best))) => prop_assert_eq!(found, best),
            // Values above the floor with a control value below it: found in a finer space only.
            (Ok(found), None) => prop_assert!(found.positive_bound()? > Q::int(0)),
            (Err(Error::Tune(TuneError::NoPositiveScale { .. })), None) => {}
            (found, best) => prop_assert!(false, "{found:?} {best:?}"),
        }
    }
}

proptest! {
    #![proptest_config(cases(10))]

    #[test]
    fn areas_are_kept_exactly(
        (c, alpha) in curve_and_function::<2>(CURVE, SCALE), closed in any::<bool>(), norm in 0_usize..2,
    ) {
        prop_assume!(alpha.space().dim() <= 6);
        let mut conditions = vec![Condition::Area];
        if closed {
            conditions.insert(0, Condition::End);
        }
        let nearest = NearestScale::prepare(&c, alpha.space(), &conditions, NORMS[norm])?;
        let area = |d: &Curve<Q, 2>| -> symspline::Result<Q> {
            let moved = d.translated(&-d.at(d.domain().0)?)?;
            Ok(moved.cross(&moved.derivative()?)?.integral()? / Q::int(2))
        };
        match nearest.to_signed(&alpha) {
            Ok(found) => {
                let tuned = c.fine_tuned(Scale::Signed(&found))?;
                prop_assert_eq!(area(&tuned)?, area(&c)?);
                if closed {
                    let b = c.domain().1;
                    prop_assert_eq!(tuned.at(b)?, c.at_left(b)?);
                }
                if let Ok(found) = nearest.to(&alpha) {
                    prop_assert!(found.positive_bound().is_ok());
                    prop_assert_eq!(area(&c.fine_tuned(&found)?)?, area(&c)?);
                }
            }
            // The gradient of the area may vanish, or ask for no more than the other conditions do.
            Err(error) => {
                let area = conditions.len() - 1;
                prop_assert!(error == Error::Clash { condition: area } || error == Error::Undecided, "{error}");
            }
        }
        let one = Function::constant(alpha.space().clone(), Q::int(1))?;
        prop_assert_eq!(nearest.to(&one)?, one);
    }
}

#[test]
fn where_none_is_positive_that_is_said() {
    // A parabola cannot come back to its start while its tangent keeps to the right.
    let q = |x: i64, y: i64| nalgebra::vector![Q::int(x), Q::int(y)];
    let space = symspline::SplineSpace::bezier(2, Q::int(0), Q::int(1)).unwrap();
    let parabola = Curve::new(space, vec![q(0, 0), q(1, 2), q(2, 0)]).unwrap();
    let scales = symspline::SplineSpace::uniform(2, 4, Q::int(0), Q::int(1)).unwrap();
    let conditions = [Condition::Point { parameter: Q::int(1), point: q(0, 0) }];
    let nearest = NearestScale::prepare(&parabola, &scales, &conditions, Norm::L2).unwrap();
    let one = Function::constant(scales, Q::int(1)).unwrap();
    assert!(nearest.to_signed(&one).is_ok());
    assert_eq!(nearest.to(&one), Err(TuneError::NoPositiveScale { proved: true }.into()));
}

/// A wave with its scale functions, and a wanted one.
fn wave<T: Scalar>() -> symspline::Result<(Curve<T, 2>, Function<T>)> {
    let space = symspline::SplineSpace::uniform(3, 4, T::int(0), T::int(1))?;
    let points = [(0, 0), (1, 2), (2, -1), (4, 3), (5, 0), (7, 1), (8, 0)];
    let curve = Curve::new(space, points.map(|(x, y)| nalgebra::vector![T::int(x), T::int(y)]).to_vec())?;
    let scales = symspline::SplineSpace::uniform(2, 5, T::int(0), T::int(1))?;
    let wanted = Function::new(scales, [2, 2, 5, 1, 2, 3, 2].map(|a| T::frac(a, 2)).to_vec())?;
    Ok((curve, wanted))
}

#[test]
fn floats_meet_conditions_up_to_rounding() -> symspline::Result<()> {
    let (c, wanted) = wave::<f64>()?;
    let conditions = [Condition::End, Condition::Derivatives { parameter: 1.0, count: 2 }, Condition::Area];
    for norm in NORMS {
        let alpha = NearestScale::prepare(&c, wanted.space(), &conditions, norm)?.to(&wanted)?;
        let tuned = c.fine_tuned(&alpha)?;
        assert!((tuned.at(&1.0)? - c.at(&1.0)?).norm() < 1e-13);
        for order in [1, 2] {
            let size = c.derivative_at(&1.0, order)?.norm();
            assert!(
                (tuned.derivative_at(&1.0, order)? - c.derivative_at(&1.0, order)?).norm() < 1e-12 * size
            );
        }
        let area = |d: &Curve<f64, 2>| d.cross(&d.derivative()?)?.integral();
        assert!((area(&tuned)? - area(&c)?).abs() < 1e-9);
        // And where values would be negative.
        let strong = wanted.dragged(&0.4, 40.0, Norm::Coefficients)?;
        let nearest = NearestScale::prepare(&c, wanted.space(), &[Condition::End], norm)?;
        assert!(nearest.to_signed(&strong)?.coefficient_range().0 < 0.0);
        let alpha = nearest.to(&strong)?;
        assert!((alpha.coefficient_range().0 - 0.01).abs() < 1e-9);
        assert!((c.fine_tuned(&alpha)?.at(&1.0)? - c.at(&1.0)?).norm() < 1e-12);
    }
    Ok(())
}

#[test]
fn exact_and_floating_programs_agree() -> symspline::Result<()> {
    let (c, wanted) = wave::<f64>()?;
    let (exact, exact_wanted) = (c.to_exact()?, wanted.to_exact()?);
    for norm in NORMS {
        let nearest = NearestScale::prepare(&c, wanted.space(), &[Condition::End], norm)?;
        let exactly = NearestScale::prepare(&exact, exact_wanted.space(), &[Condition::End], norm)?;
        for at in [0.1, 0.3, 0.4, 0.75, 0.9] {
            let strong = wanted.dragged(&at, 30.0, Norm::Coefficients)?;
            let found = nearest.to(&strong)?;
            let expected = exactly.to(&strong.to_exact()?)?.to_f64()?;
            for (x, y) in found.coeffs().iter().zip(expected.coeffs()) {
                assert!((x - y).abs() < 1e-10, "{at}: {found:?} {expected:?}");
            }
        }
    }
    Ok(())
}

#[test]
fn what_cannot_be_is_refused() -> symspline::Result<()> {
    let (c, wanted) = wave::<Q>()?;
    let prepare =
        |conditions: &[Condition<Q, 2>]| NearestScale::prepare(&c, wanted.space(), conditions, Norm::L2);
    let outside = Condition::Scale { parameter: Q::int(2), value: Q::int(1) };
    assert!(matches!(prepare(&[outside]).unwrap_err(), Error::OutsideDomain { .. }));
    let none = Condition::Coefficient { index: 7, value: Q::int(1) };
    assert_eq!(prepare(&[none]).unwrap_err(), Error::IndexOutOfRange { index: 7, length: 7 });
    let elsewhere = Condition::Scale { parameter: Q::int(0), value: Q::int(2) };
    assert_eq!(prepare(&[elsewhere, Condition::Area])?.to(&wanted), Err(TuneError::AreaElsewhere.into()));
    let below = prepare(&[])?.above(Q::int(0)).unwrap_err();
    assert!(matches!(below, Error::NotPositive { .. }));
    let end = Condition::Point { parameter: Q::int(1), point: nalgebra::vector![Q::int(0), Q::int(9)] };
    assert_eq!(prepare(&[Condition::End, end])?.to(&wanted), Err(Error::Clash { condition: 1 }));
    let space = symspline::segment(&nalgebra::vector![0.0, 0.0, 0.0], &nalgebra::vector![1.0, 1.0, 1.0])?;
    let area = NearestScale::prepare(&space, space.space(), &[Condition::Area], Norm::L2).unwrap_err();
    assert_eq!(area, Error::NotPlane { dimension: 3 });
    let other = symspline::SplineSpace::bezier(2, Q::int(0), Q::int(2))?;
    let apart = NearestScale::prepare(&c, &other, &[Condition::End], Norm::L2).unwrap_err();
    assert!(matches!(apart, Error::DomainMismatch { .. }));
    Ok(())
}

#[test]
fn the_size_of_coordinates_does_not_matter() -> symspline::Result<()> {
    let (c, wanted) = wave::<f64>()?;
    for conditions in [vec![Condition::End], vec![Condition::End, Condition::Area]] {
        for norm in NORMS {
            let nearest = |c: &Curve<f64, 2>| -> symspline::Result<Function<f64>> {
                let found = NearestScale::prepare(c, wanted.space(), &conditions, norm)?;
                assert_eq!(found.rank(), 2);
                found.to(&wanted)
            };
            let expected = nearest(&c)?;
            for size in [1e-300, 1e-200, 1e-160, 1e-100, 1e100, 1e155, 1e200, 1e300] {
                let found =
                    nearest(&Curve::new(c.space().clone(), c.coeffs().iter().map(|p| p * size).collect())?)?;
                assert!(found.distance_bound(&expected)? < 1e-9, "{size} {found:?} {expected:?}");
            }
        }
    }
    Ok(())
}

#[test]
fn ends_of_nearly_plane_curves_are_kept() -> symspline::Result<()> {
    let (c, wanted) = wave::<f64>()?;
    for lift in [1e-3, 1e-6, 1e-9, 1e-12, 1e-15] {
        let points =
            c.coeffs().iter().map(|p| nalgebra::vector![p[0], p[1], 0.5 * p[0] + lift * p[1] * p[1]]);
        let c = Curve::new(c.space().clone(), points.collect())?;
        for norm in NORMS {
            let alpha =
                NearestScale::prepare(&c, wanted.space(), &[Condition::End], norm)?.to_signed(&wanted)?;
            let tuned = c.fine_tuned(Scale::Signed(&alpha))?;
            assert!((tuned.at(&1.0)? - c.at(&1.0)?).norm() < 1e-13, "{lift} {norm:?}");
        }
    }
    Ok(())
}

#[test]
fn areas_are_kept_where_full_steps_go_back_and_forth() -> symspline::Result<()> {
    let points = [[0, 7], [3, 1], [0, 1], [4, 6]].map(|p| nalgebra::vector![p[0] as f64, p[1] as f64]);
    let c = Curve::new(symspline::SplineSpace::uniform(2, 2, 0.0, 1.0)?, points.to_vec())?;
    let wanted =
        Function::new(symspline::SplineSpace::uniform(1, 3, 0.0, 1.0)?, vec![1.75, 1.5, 1.75, 1.75])?;
    let alpha =
        NearestScale::prepare(&c, wanted.space(), &[Condition::Area], Norm::Coefficients)?.to(&wanted)?;
    let area = |d: &Curve<f64, 2>| {
        let moved = d.translated(&-d.at(&0.0)?)?;
        moved.cross(&moved.derivative()?)?.integral()
    };
    assert!((area(&c.fine_tuned(&alpha)?)? - area(&c)?).abs() < 1e-9);
    Ok(())
}

#[test]
fn hostile_numbers_are_refused() -> symspline::Result<()> {
    let (c, wanted) = wave::<f64>()?;
    let strong = wanted.dragged(&0.4, 40.0, Norm::Coefficients)?;
    let nearest = NearestScale::prepare(&c, wanted.space(), &[Condition::End], Norm::L2)?;
    // A floor that rounding hides.
    assert_eq!(nearest.above(1e-300)?.to(&strong), Err(Error::Undecided));
    let tuner = FineTuner::free(&c, wanted.space())?.signed();
    let mut values = wanted.coeffs().to_vec();
    let before = vec![nalgebra::vector![7.0, 7.0]; tuner.space().dim()];
    for bad in [f64::NAN, f64::INFINITY] {
        values[3] = bad;
        let mut points = before.clone();
        let refused = Err(Error::NotFinite { what: "coefficient", index: 3 });
        assert_eq!(tuner.tune_into(&values, &mut points), refused);
        assert_eq!(points, before);
    }
    // Too many values for a dense program.
    let scales = symspline::SplineSpace::uniform(2, 17_000, 0.0, 1.0)?;
    let mut values = vec![1.0; scales.dim()];
    values[8_000..8_003].fill(-3.0);
    let nearest = NearestScale::prepare(&c, &scales, &[Condition::End], Norm::Coefficients)?;
    let refused = nearest.to(&Function::new(scales, values)?);
    assert!(matches!(refused, Err(Error::TooLarge { .. })), "{refused:?}");
    Ok(())
}
