//! Laws of rational curves and functions: values, derivatives, basis functions, and operators on the lifted spline.

use crate::oracle::{self, Side};
use crate::rational_strategies::{nurbs, rational};
use crate::strategies::{ANY, Kind, SMOOTH, cases, indices, insertable, number, probes, space};
use nalgebra::vector;
use proptest::prelude::*;
use symspline::{Coeff, Error, Function, NurbsCurve, Q, RationalFunction, Scalar, SplineSpace, Weighted};

/// Degrees at which numbers stay short.
const LOW: Kind = ANY.of_degree(0, 4);

/// `C(n, k)`.
fn choose(n: usize, k: usize) -> Q {
    (0..k).fold(Q::int(1), |c, i| c * Q::int((n - i) as i64) / Q::int(i as i64 + 1))
}

/// The quotient of the values of numerator and denominator, by the recurrence.
fn value<const N: usize>(
    f: &NurbsCurve<Q, N>,
    x: &Q,
    side: Side,
) -> Result<nalgebra::SVector<Q, N>, TestCaseError> {
    let weight = oracle::value(&f.denominator()?, x, side);
    prop_assert!(weight > Q::int(0));
    Ok(oracle::value(&f.numerator()?, x, side).scaled(&(Q::int(1) / weight)))
}

/// Whether both have the same values at all probes of both.
fn agree<const N: usize>(f: &NurbsCurve<Q, N>, g: &NurbsCurve<Q, N>) -> Result<(), TestCaseError> {
    prop_assert_eq!(f.domain(), g.domain());
    for x in probes(f.space()).iter().chain(&probes(g.space())) {
        prop_assert_eq!(f.at(x)?, g.at(x)?);
        prop_assert_eq!(f.at_left(x)?, g.at_left(x)?);
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn a_value_is_the_quotient_of_values(f in nurbs::<2>(ANY.of_degree(0, 6))) {
        let parameters = probes(f.space());
        let values = parameters.iter().map(|x| value(&f, x, Side::Right)).collect::<Result<Vec<_>, _>>()?;
        prop_assert_eq!(&f.eval(&parameters)?, &values);
        for (x, expected) in parameters.iter().zip(values) {
            prop_assert_eq!(f.at(x)?, expected);
            prop_assert_eq!(f.at_left(x)?, value(&f, x, Side::Left)?);
        }
    }

    #[test]
    fn the_control_points_and_weights_are_those_given(
        (space, points, weights) in (space(ANY), any::<u64>()).prop_flat_map(|(space, _)| {
            let n = space.dim();
            (Just(space), prop::collection::vec(number(), n), prop::collection::vec(1_i64..99, n))
        }),
    ) {
        let weights: Vec<Q> = weights.into_iter().map(Q::int).collect();
        let f = RationalFunction::new(space.clone(), points.clone(), weights.clone())?;
        prop_assert_eq!(f.space(), &space);
        prop_assert_eq!((f.degree(), f.domain()), (space.degree(), space.domain()));
        prop_assert_eq!(&f.points()?, &points);
        prop_assert!(f.weights().eq(&weights));
        prop_assert!(f.denominator()?.coeffs() == weights);
        let weighted: Vec<Q> = points.iter().zip(&weights).map(|(c, w)| c.clone() * w).collect();
        prop_assert_eq!(f.numerator()?.into_coeffs(), weighted);
        let lifted = f.clone().into_lifted();
        prop_assert_eq!(&lifted, f.lifted());
        prop_assert_eq!(&RationalFunction::from_lifted(lifted)?, &f);
        prop_assert_eq!(RationalFunction::from_quotient(&f.numerator()?, &f.denominator()?)?, f);
    }

    #[test]
    fn with_equal_weights_it_is_the_polynomial_spline(f in crate::strategies::curve::<3>(ANY), w in 1_i64..9) {
        let lifted = RationalOf::from_polynomial(&f)?;
        let weighed = NurbsCurve::new(f.space().clone(), f.coeffs().to_vec(), vec![Q::int(w); f.space().dim()])?;
        prop_assert!(weighed.same_function(&lifted)?);
        for x in probes(f.space()) {
            prop_assert_eq!(weighed.at(&x)?, f.at(&x)?);
            prop_assert_eq!(weighed.derivatives_at(&x, 3)?, f.derivatives_at(&x, 3)?);
        }
    }

    #[test]
    fn derivatives_times_the_denominator_are_those_of_the_numerator(f in nurbs::<2>(LOW), order in 0_usize..5) {
        let (numerator, denominator) = (f.numerator()?, f.denominator()?);
        for x in probes(f.space()) {
            let found = f.derivatives_at(&x, order)?;
            prop_assert_eq!(found.len(), order + 1);
            let (a, w) = (numerator.derivatives_at(&x, order)?, denominator.derivatives_at(&x, order)?);
            for k in 0..=order {
                let mut product = a[k].zero_like();
                (0..=k).for_each(|i| product.add_scaled(&(choose(k, i) * &w[i]), &found[k - i]));
                prop_assert_eq!(&product, &a[k]);
            }
        }
    }

    #[test]
    fn basis_functions_are_a_partition_of_one_and_reproduce(f in nurbs::<2>(LOW)) {
        // Control points exist where all weights are positive.
        let Ok(points) = f.points() else { return Ok(()) };
        let order = 3;
        for x in probes(f.space()) {
            let basis = f.basis_derivatives(&x, order)?;
            let derivatives = f.derivatives_at(&x, order)?;
            for (k, functional) in basis.iter().enumerate() {
                let sum = functional.weights().iter().fold(Q::int(0), |sum, w| sum + w);
                prop_assert_eq!(sum, Q::int(i64::from(k == 0)));
                prop_assert_eq!(&functional.apply(&points), &derivatives[k]);
                prop_assert_eq!(functional.weights().len(), f.degree() + 1);
            }
            prop_assert!(basis[0].weights().iter().all(|w| *w >= Q::int(0)));
        }
    }

    #[test]
    fn insertion_elevation_and_clamping_change_no_value(
        f in nurbs::<2>(LOW), raise in 0_usize..3, places in indices(3),
    ) {
        let knots = insertable(f.space(), &places);
        agree(&f, &f.through(|lifted| lifted.inserted(&knots))?)?;
        agree(&f, &f.through(|lifted| lifted.elevated(raise))?)?;
        let clamped = f.through(|lifted| lifted.clamped_ends())?;
        for x in probes(f.space()) {
            prop_assert_eq!(clamped.at(&x)?, f.at(&x)?);
        }
        let pieces = f.space().pieces(f.degree() + raise)?;
        let cut = f.through(|lifted| lifted.embedded(&pieces))?;
        for x in probes(f.space()) {
            prop_assert_eq!(cut.at(&x)?, f.at(&x)?);
        }
        prop_assert!(clamped.same_function(&f)? && cut.same_function(&f)?);
    }

    #[test]
    fn parts_keep_their_values(f in nurbs::<2>(LOW), i in any::<prop::sample::Index>(), j in any::<prop::sample::Index>()) {
        let all = probes(f.space());
        let (i, j) = (i.index(all.len()), j.index(all.len()));
        prop_assume!(i != j);
        let (a, b) = (&all[i.min(j)], &all[i.max(j)]);
        let part = f.through(|lifted| lifted.restricted(a, b))?;
        prop_assert_eq!(part.domain(), (a, b));
        for x in all[i.min(j)..i.max(j)].iter().chain(&probes(part.space())) {
            if x != b {
                prop_assert_eq!(part.at(x)?, f.at(x)?);
            }
        }
        prop_assert_eq!(part.at_left(b)?, f.at_left(b)?);
    }

    #[test]
    fn backwards_the_values_come_backwards(f in nurbs::<2>(LOW)) {
        let (a, b) = f.domain();
        let reversed = f.through(|lifted| lifted.reversed())?;
        for x in probes(f.space()) {
            let mirror = a.clone() + b - &x;
            // The value at the end is the limit from inside.
            let side = if x == *b { Side::Right } else { Side::Left };
            prop_assert_eq!(&value(&reversed, &mirror, side)?, &f.at(&x)?);
        }
    }

    #[test]
    fn named_operators_are_those_of_the_lifted_spline(f in nurbs::<2>(LOW), places in indices(2)) {
        let knots = insertable(f.space(), &places);
        let (a, b) = f.domain();
        let x = a.clone() + (b.clone() - a) * Q::frac(2, 7);
        let lifted = f.lifted();
        prop_assert_eq!(f.inserted(&knots)?.into_lifted(), lifted.inserted(&knots)?);
        prop_assert_eq!(f.elevated(2)?.into_lifted(), lifted.elevated(2)?);
        prop_assert_eq!(f.clamped_ends()?.into_lifted(), lifted.clamped_ends()?);
        prop_assert_eq!(f.reversed()?.into_lifted(), lifted.reversed()?);
        prop_assert_eq!(f.restricted(a, &x)?.into_lifted(), lifted.restricted(a, &x)?);
        let (before, after) = f.split(&x)?;
        prop_assert_eq!((before.into_lifted(), after.into_lifted()), lifted.split(&x)?);
        let pieces = f.space().pieces(f.degree())?;
        prop_assert_eq!(f.embedded(&pieces)?.into_lifted(), lifted.embedded(&pieces)?);
        prop_assert_eq!(f.reparametrised(&x, b)?.into_lifted(), lifted.reparametrised(&x, b)?);
        prop_assert!(f.split(a).is_err() && f.inserted(&[b.clone() + Q::int(1)]).is_err());
    }

    #[test]
    fn a_common_factor_changes_nothing(f in nurbs::<2>(LOW), factor in number()) {
        prop_assume!(factor != Q::int(0));
        let scaled = NurbsCurve::from_lifted(f.lifted().scaled(&factor)?)?;
        prop_assert!(scaled.weights().zip(f.weights()).all(|(v, w)| *v == factor.abs() * w));
        agree(&f, &scaled)?;
        prop_assert!(f.same_function(&scaled)?);
    }

    #[test]
    fn exact_conversions_lose_nothing(f in rational(LOW)) {
        prop_assert_eq!(&f.map_scalars(|q| Ok(q.clone()))?, &f);
        if let Ok(rounded) = f.to_f64() {
            prop_assert_eq!(rounded.to_exact()?.to_f64()?, rounded);
        }
    }
}

/// The rational splines of points in space.
type RationalOf = NurbsCurve<Q, 3>;

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn the_derivative_is_a_rational_spline(f in nurbs::<2>(SMOOTH.of_degree(0, 4))) {
        let derivative = f.derivative()?;
        for x in probes(f.space()) {
            prop_assert_eq!(&derivative.at(&x)?, &f.derivatives_at(&x, 1)?[1]);
        }
    }

    #[test]
    fn the_second_derivative_too(f in nurbs::<2>(ANY.of_degree(1, 2).smooth(2))) {
        let second = f.derivative()?.derivative()?;
        for x in probes(f.space()) {
            prop_assert_eq!(&second.at(&x)?, &f.derivatives_at(&x, 2)?[2]);
        }
    }

    #[test]
    fn derivatives_of_any_order_are_of_so_many_times_the_degree(
        f in nurbs::<2>(ANY.of_degree(1, 4).smooth(3)),
        order in 0_usize..4,
    ) {
        let derived = f.nth_derivative(order)?;
        prop_assert_eq!(derived.space().degree(), (order + 1) * f.space().degree());
        for x in probes(f.space()) {
            prop_assert_eq!(&derived.at(&x)?, &f.derivatives_at(&x, order)?[order]);
        }
    }

    #[test]
    fn a_torn_spline_has_no_derivative(f in nurbs::<2>(ANY.of_degree(0, 3))) {
        let torn = f.space().derivative_space().is_err();
        prop_assert_eq!(matches!(f.derivative(), Err(Error::Discontinuous { .. })), torn);
    }
}

#[test]
fn weights_that_are_not_positive_are_refused() {
    let space = SplineSpace::bezier(2, Q::int(0), Q::int(1)).unwrap();
    let points = [1, 2, 3].map(Q::int).to_vec();
    for (bad, text) in [(Q::int(0), "0"), (Q::frac(-1, 3), "-1/3")] {
        let refused = RationalFunction::new(space.clone(), points.clone(), vec![Q::int(1), bad, Q::int(1)]);
        assert_eq!(refused.unwrap_err(), Error::Weight { index: 1, weight: text.into() });
    }
    let short = RationalFunction::new(space.clone(), points.clone(), vec![Q::int(1); 2]);
    assert_eq!(short.unwrap_err(), Error::CoefficientCount { expected: 3, found: 2 });
    let long = RationalFunction::new(space, points[..2].to_vec(), vec![Q::int(1); 2]);
    assert_eq!(long.unwrap_err(), Error::CoefficientCount { expected: 3, found: 2 });
}

#[test]
fn weights_that_are_no_numbers_are_refused() {
    let space = SplineSpace::bezier(1, 0.0, 1.0).unwrap();
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let refused = RationalFunction::new(space.clone(), vec![1.0, 2.0], vec![1.0, bad]);
        assert!(refused.is_err(), "{refused:?}");
        let lifted = Weighted { point: 1.0, weight: bad };
        assert!(Function::new(space.clone(), vec![1.0, bad]).is_err(), "{lifted:?}");
    }
    let refused = RationalFunction::new(space, vec![1.0, 2.0], vec![1.0, -0.0]);
    assert!(matches!(refused, Err(Error::Weight { index: 1, .. })));
}

#[test]
fn a_control_point_beyond_infinity_is_no_point() {
    // (1 - x)² - x (1 - x) + x² is positive, its middle coefficient is not.
    let space = SplineSpace::bezier(2, Q::int(0), Q::int(1)).unwrap();
    let bottom = Function::new(space.clone(), vec![Q::int(1), Q::frac(-1, 2), Q::int(1)]).unwrap();
    let top = Function::constant(space, Q::int(1)).unwrap();
    let f = RationalFunction::from_quotient(&top, &bottom).unwrap();
    assert_eq!(f.at(&Q::frac(1, 2)).unwrap(), Q::int(4));
    assert_eq!(f.points().unwrap_err(), Error::Weight { index: 1, weight: "-1/2".into() });
    let basis = f.basis_derivatives(&Q::frac(1, 2), 0).unwrap();
    assert_eq!(basis[0].weights(), [Q::int(1), Q::int(-1), Q::int(1)]);
}

#[test]
fn outside_the_domain_there_is_nothing() {
    let space = SplineSpace::bezier(1, Q::int(0), Q::int(1)).unwrap();
    let f = RationalFunction::new(space, vec![Q::int(0), Q::int(1)], vec![Q::int(1), Q::int(2)]).unwrap();
    let x = Q::int(2);
    assert!(matches!(f.at(&x), Err(Error::OutsideDomain { .. })));
    assert!(matches!(f.at_left(&x), Err(Error::OutsideDomain { .. })));
    assert!(matches!(f.eval(std::slice::from_ref(&x)), Err(Error::OutsideDomain { .. })));
    assert!(matches!(f.derivatives_at(&x, 1), Err(Error::OutsideDomain { .. })));
    assert!(matches!(f.basis_derivatives(&x, 1), Err(Error::OutsideDomain { .. })));
    let order = symspline::limits::MAX_DEGREE + 1;
    assert!(matches!(f.derivatives_at(&Q::int(0), order), Err(Error::DegreeTooHigh { .. })));
}

#[test]
fn the_coordinates_of_a_weighted_point() {
    let c = Weighted::new(&vector![Q::int(2), Q::int(3)], Q::int(5));
    assert_eq!(c.point, vector![Q::int(10), Q::int(15)]);
    assert_eq!(c.components().cloned().collect::<Vec<_>>(), [10, 15, 5].map(Q::int));
    assert_eq!(c.project(), vector![Q::int(2), Q::int(3)]);
    assert_eq!(c.zero_like().weight, Q::int(0));
}
