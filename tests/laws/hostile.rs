//! What must be refused, with an error that says why, and without a panic.

use crate::strategies::{ANY, cases, function, probes};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use symspline::limits::MAX_DEGREE;
use symspline::{
    BilinearMap, BilinearRow, Contact, Continuity, Error, Function, Functional, Keep, KnotVector, LinearMap,
    Q, Scalar, SplineSpace,
};

/// Numbers that break things: not finite, tiny, huge, equal, next to each other.
fn garbage() -> impl Strategy<Value = f64> {
    let odd = [0.0, -0.0, 1.0, 1.0 + f64::EPSILON, f64::MIN_POSITIVE, 5e-324, 1e300, f64::MAX, f64::MIN];
    prop_oneof![
        8 => (-3_i32..=3).prop_map(f64::from),
        3 => select(odd.to_vec()),
        1 => select(vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY]),
        1 => any::<f64>(),
    ]
}

/// Lists of such numbers, mostly in order.
fn garbage_list() -> impl Strategy<Value = Vec<f64>> {
    (vec(garbage(), 0..14), 0_u8..8).prop_map(|(mut list, order)| {
        if order > 0 {
            list.sort_by(f64::total_cmp);
        }
        list
    })
}

/// Runs every operator on a spline that was let in. Errors are fine, panics are not.
fn exercise(space: SplineSpace<f64>) {
    let coeffs = (0..space.dim()).map(|i| i as f64 - 1.5).collect();
    let f = Function::new(space, coeffs).expect("finite coefficients");
    let (a, b) = (*f.domain().0, *f.domain().1);
    let middle = a / 2.0 + b / 2.0;
    for x in [a, b, middle, f64::NAN, f64::INFINITY] {
        let _ = (f.at(&x), f.at_left(&x), f.derivatives_at(&x, 3), f.integral_between(&a, &x), f.split(&x));
        let _ = (f.inserted(&[x]), f.restricted(&a, &x), f.space().gram_between(f.space(), 0, 0, &a, &x));
        let _ = (f.reparametrised(&a, &x), f.scaled(&x), f.translated(&x), f.space().polar(0, &[x]));
    }
    let _ = (f.derivative(), f.antiderivative(), f.integral(), f.moment(2), f.elevated(2), f.times(&f));
    let _ = (f.clamped_ends(), f.unclamped_ends(), f.bezier_pieces(), f.reversed(), f.sum(&f), f.join(&f));
    let _ = (
        f.space().bisected(),
        f.space().greville(),
        f.space().gram(f.space(), 0, 1),
        f.space().recomposition(),
    );
    let _ = (f.degree_lowered(1), f.simplified(), f.distance_bound_halved(&f, 2));
    for tolerance in [0.0, 0.1, 1e300, f64::NAN] {
        let _ = (
            f.without_spare_knots(&tolerance),
            f.removed(&middle, 2, &tolerance),
            f.simplified_within(&tolerance),
        );
        let _ = f.degree_reduced_within(1, &tolerance, Contact::FREE);
    }
    let _ = f.degree_reduced(1, Continuity::Breaks, Contact::both(2));
    (0..f.space().knots().len()).for_each(|r| drop(f.without_knot(r, Keep::Right)));
    let greville = f.space().greville();
    let _ = Function::interpolating(f.space(), &greville, f.coeffs());
    let _ = Function::least_squares(f.space(), &greville, f.coeffs(), symspline::Ends::Free);
}

proptest! {
    #![proptest_config(cases(512))]

    #[test]
    fn no_list_of_knots_makes_a_panic(degree in 0_usize..5, list in garbage_list(), period in garbage()) {
        let spaces = [
            SplineSpace::new(degree, list.clone()),
            SplineSpace::clamped(degree, list.clone()),
            SplineSpace::periodic(degree, list, period),
        ];
        spaces.into_iter().flatten().for_each(exercise);
    }

    #[test]
    fn spaces_that_are_let_in_are_valid(degree in 0_usize..5, list in garbage_list()) {
        if let Ok(space) = SplineSpace::new(degree, list.clone()) {
            let t = space.knots();
            prop_assert_eq!(&t[..], &list[..]);
            prop_assert!(t.iter().all(|t| t.is_finite()) && t.windows(2).all(|pair| pair[0] <= pair[1]));
            prop_assert!(t[degree] < t[degree + 1] && t[space.dim() - 1] < t[space.dim()]);
            prop_assert!((0..space.dim()).all(|i| t[i] < t[i + degree + 1]));
        }
    }

    #[test]
    fn knot_vectors_are_in_order_or_refused(list in garbage_list()) {
        let expected = match list.iter().position(|t| !t.is_finite()) {
            Some(index) => Some(Error::NotFinite { what: "knot", index }),
            None => list.windows(2).position(|w| w[1] < w[0]).map(|i| Error::KnotsDecrease { index: i + 1 }),
        };
        prop_assert_eq!(KnotVector::new(list).err(), expected);
    }
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn wrong_counts_are_refused(f in function(ANY), found in 0_usize..60) {
        prop_assume!(found != f.space().dim());
        let expected = Error::CoefficientCount { expected: f.space().dim(), found };
        let given = Function::new(f.space().clone(), vec![Q::int(0); found]);
        prop_assert_eq!(given.unwrap_err(), expected);
        let (_, b) = f.domain();
        let k = f.space().locate(b)?;
        let polar = f.space().polar(k, &vec![Q::int(0); f.degree() + 1]);
        let expected = Error::CoefficientCount { expected: f.degree(), found: f.degree() + 1 };
        prop_assert_eq!(polar.unwrap_err(), expected);
        let into = f.eval_into(&probes(f.space()), &mut []);
        prop_assert!(matches!(into, Err(Error::CoefficientCount { .. })), "{into:?}");
    }

    #[test]
    fn parameters_outside_are_refused(f in function(ANY)) {
        let ((a, b), step) = (f.domain(), Q::frac(1, 1_000_000_000_000));
        for x in [a.clone() - &step, b.clone() + &step] {
            let error = f.at(&x).unwrap_err();
            let all = [
                f.at_left(&x).err(),
                f.derivative_at(&x, 1).err(),
                f.eval(std::slice::from_ref(&x)).err(),
                f.integral_between(a, &x).err(),
                f.integral_between(&x, b).err(),
                f.split(&x).err(),
                f.restricted(a, &x).err(),
                f.inserted(std::slice::from_ref(&x)).err(),
                f.space().basis(&x).err(),
            ];
            prop_assert!(matches!(error, Error::OutsideDomain { .. }), "{error:?}");
            prop_assert!(all.iter().all(|other| other.as_ref() == Some(&error)), "{all:?}");
        }
        prop_assert!(f.at(a).is_ok() && f.at(b).is_ok());
    }

    #[test]
    fn one_ulp_outside_is_outside(start in -1e3_f64..1e3, length in 1e-3_f64..1e3, p in 0_usize..5) {
        let space = SplineSpace::bezier(p, start, start + length)?;
        let (a, b) = space.domain();
        for x in [a.next_down(), b.next_up(), f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let located = space.locate(&x);
            prop_assert!(matches!(located, Err(Error::OutsideDomain { .. })), "{located:?}");
            prop_assert_eq!(located.err(), space.locate_left(&x).err());
        }
    }

    #[test]
    fn spans_without_length_have_no_polar_form(f in function(ANY)) {
        let (space, t) = (f.space(), f.space().knots());
        let spans: Vec<usize> = space.spans().collect();
        for k in (0..t.len() + 2).chain([usize::MAX]) {
            let polar = space.polar(k, &vec![Q::int(1); space.degree()]);
            let expected = (!spans.contains(&k)).then_some(Error::EmptySpan { span: k });
            prop_assert_eq!(polar.err(), expected);
        }
    }

    #[test]
    fn too_many_copies_are_refused(p in 0_usize..6, extra in 2_usize..4, at in 0_i64..=2) {
        // One copy more than a jump, inside or at an end.
        let ends = |t: i64| vec![Q::int(t); p + 1];
        let mut knots: Vec<Q> = ends(0).into_iter().chain(ends(2)).collect();
        knots.extend(vec![Q::int(at); if at == 1 { p + extra } else { extra - 1 }]);
        knots.sort();
        let refused = SplineSpace::new(p, knots);
        let expected = matches!(refused, Err(Error::Multiplicity { .. }));
        prop_assert!(expected, "{refused:?}");
        let ring = SplineSpace::periodic(p, vec![Q::int(0); p + extra], Q::int(1));
        let expected = Error::Multiplicity { knot: "0".into(), multiplicity: p + extra, limit: p + 1 };
        prop_assert_eq!(ring.unwrap_err(), expected);
    }
}

/// Whether an operation was refused as too much.
fn too_much<V>(result: Result<V, Error>) -> bool {
    matches!(result, Err(Error::TooLarge { .. } | Error::DegreeTooHigh { .. }))
}

#[test]
fn sizes_are_refused_before_anything_is_allocated() -> symspline::Result<()> {
    for degree in [MAX_DEGREE + 1, usize::MAX / 2, usize::MAX] {
        assert!(too_much(SplineSpace::new(degree, [0.0, 1.0])));
        assert!(too_much(SplineSpace::clamped(degree, [0.0, 1.0])));
        assert!(too_much(SplineSpace::periodic(degree, [0.0], 1.0)));
        assert!(too_much(SplineSpace::uniform(degree, 3, 0.0, 1.0)));
        assert!(too_much(Function::monomial(degree, 0.0, 1.0)));
        let space = SplineSpace::uniform(3, 4, 0.0, 1.0)?;
        assert!(too_much(space.elevated(degree)) && too_much(space.pieces(degree)));
        assert!(too_much(space.basis_derivatives(&0.5, degree)) && too_much(space.gram(&space, degree, 0)));
        let f = Function::constant(space, 1.0)?;
        assert!(too_much(f.moment(degree)) && too_much(f.elevated(degree)));
        assert_eq!(f.nth_derivative(degree), f.nth_derivative(4));
        assert!(too_much(f.derivative_at(&0.5, degree)) && too_much(f.derivatives_at(&0.5, degree)));
    }
    for spans in [usize::MAX, usize::MAX - 3, 1 << 40] {
        assert!(too_much(SplineSpace::uniform(3, spans, 0.0, 1.0)));
    }
    Ok(())
}

#[test]
fn the_highest_degree_is_let_in_and_no_higher() -> symspline::Result<()> {
    let space = SplineSpace::bezier(MAX_DEGREE, 0.0, 1.0)?;
    assert!(too_much(space.antiderivative_space()) && too_much(space.elevated(1)));
    assert!(too_much(space.product_space(&SplineSpace::bezier(1, 0.0, 1.0)?)));
    assert!((space.basis(&0.5)?.weights().iter().sum::<f64>() - 1.0).abs() < 1e-12);
    Ok(())
}

#[test]
fn empty_input_is_refused() {
    let none: [f64; 0] = [];
    assert!(matches!(SplineSpace::new(0, none), Err(Error::TooFewKnots { .. })));
    assert!(matches!(SplineSpace::clamped(2, none), Err(Error::TooFewKnots { .. })));
    assert!(matches!(SplineSpace::periodic(2, none, 1.0), Err(Error::TooFewKnots { .. })));
    assert!(matches!(SplineSpace::uniform(2, 0, 0.0, 1.0), Err(Error::TooFewKnots { .. })));
    assert!(matches!(
        LinearMap::from_rows(0, [Functional::new(0, [1.0])]),
        Err(Error::IndexOutOfRange { .. })
    ));
    assert!(LinearMap::<f64>::identity(0).apply::<f64>(&[]).is_ok());
    let space = SplineSpace::bezier(1, 0.0, 1.0).unwrap();
    assert!(matches!(Function::interpolating(&space, &[], &[]), Err(Error::TooFewPoints { .. })));
}

#[test]
fn numbers_that_are_none_are_refused() -> symspline::Result<()> {
    let space = SplineSpace::bezier(1, 0.0, 1.0)?;
    let f = Function::new(space.clone(), vec![1.0, 2.0])?;
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(
            Function::new(space.clone(), vec![0.0, bad]).unwrap_err(),
            Error::NotFinite { what: "coefficient", index: 1 }
        );
        assert_eq!(space.polar(1, &[bad]).unwrap_err(), Error::NotFinite { what: "argument", index: 0 });
        assert_eq!(f.inserted(&[0.5, bad]).unwrap_err(), Error::NotFinite { what: "knot", index: 1 });
        assert_eq!(
            Function::interpolating(&space, &[0.0, 1.0], &[bad, 0.0]).unwrap_err(),
            Error::NotFinite { what: "point", index: 0 }
        );
        assert!(matches!(f.scaled(&bad), Err(Error::NotFinite { .. })));
        assert!(matches!(f.translated(&bad), Err(Error::NotFinite { .. })));
        assert!(Function::interpolating(&space, &[0.0, bad], &[1.0, 0.0]).is_err());
        assert!(f.reparametrised(&0.0, &bad).is_err() && f.reparametrised(&bad, &1.0).is_err());
        assert!(SplineSpace::periodic(2, [0.0, 1.0], bad).is_err());
    }
    // Overflow is found, not handed on.
    let huge = Function::new(space, vec![f64::MAX, -f64::MAX])?;
    for overflow in [huge.times(&huge), huge.scaled(&2.0), huge.sum(&huge), huge.derivative()] {
        assert!(matches!(overflow, Err(Error::NotFinite { .. })), "{overflow:?}");
    }
    Ok(())
}

#[test]
fn ragged_rows_are_no_bilinear_map() {
    let row = |weights: [Vec<f64>; 2]| BilinearRow { first: (0, 0), weights: weights.to_vec() };
    let ragged = BilinearMap::from_rows(2, 2, [row([vec![1.0, 2.0], vec![3.0]])]);
    assert_eq!(ragged, Err(Error::CoefficientCount { expected: 2, found: 1 }));
    assert!(BilinearMap::from_rows(2, 2, [row([vec![1.0, 2.0], vec![3.0, 4.0]])]).is_ok());
}

#[test]
fn rings_whose_knots_fall_together_a_period_on_are_refused() {
    let ring = SplineSpace::periodic(2, [0.0, 1e-20, 0.5], 1.0);
    assert!(matches!(ring, Err(Error::SpanOutOfRange { .. })));
    assert!(SplineSpace::periodic(2, [0.0, 1e-10, 0.5], 1.0).is_ok());
}

#[test]
fn spans_without_a_finite_inverse_are_refused() {
    for knots in [[0.0, 5e-324], [-1.7e308, 1.7e308]] {
        assert_eq!(
            SplineSpace::clamped(3, knots),
            Err(Error::SpanOutOfRange { index: if knots[0] == 0.0 { 3 } else { 0 } })
        );
    }
}

#[test]
fn abscissae_do_not_overflow() {
    assert_eq!(SplineSpace::bezier(1, 1e308, 1.5e308).unwrap().greville(), [1e308, 1.5e308]);
    assert!(SplineSpace::bezier(3, 1e308, 1.5e308).unwrap().greville().iter().all(|x| x.is_finite()));
}
