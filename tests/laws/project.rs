//! Laws of the best approximation in a space.

use crate::strategies::{
    ANY, CLAMPED, Kind, cases, curve, curves, function, functions, number, probes, space,
};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{Contact, Error, Function, Q, Scalar, SplineSpace};

const SMALL: Kind = ANY.of_degree(0, 3);

/// `∫ |f - g|²`.
fn squared_distance(f: &Function<Q>, g: &Function<Q>) -> symspline::Result<Q> {
    let h = f.difference(g)?;
    h.inner(&h)
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn the_residual_is_orthogonal_to_the_target([c, d] in curves::<2>(SMALL, SMALL)) {
        let target = d.space();
        let near = c.projected(target, Contact::FREE)?.spline;
        prop_assert_eq!(near.space(), target);
        let left = target.gram(c.space(), 0, 0)?.apply(c.coeffs())?;
        prop_assert_eq!(left, target.gram(target, 0, 0)?.apply(near.coeffs())?);
    }

    #[test]
    fn splines_of_the_target_come_back(c in curve::<2>(SMALL)) {
        let near = c.elevated(1)?.projected(c.space(), Contact::FREE)?;
        prop_assert_eq!((near.spline, near.bound), (c, Q::int(0)));
    }

    #[test]
    fn a_finer_target_gives_the_embedding(f in function(SMALL)) {
        let target = f.space().elevated(1)?.bisected()?;
        let near = f.projected(&target, Contact::FREE)?;
        prop_assert_eq!((near.spline, near.bound), (f.embedded(&target)?, Q::int(0)));
    }

    #[test]
    fn nothing_in_the_target_is_nearer(
        [f, g] in functions(SMALL, CLAMPED.of_degree(0, 3)),
        change in vec(number(), 48),
        counts in (0_usize..3, 0_usize..3),
    ) {
        let target = g.space();
        let contact = Contact { start: counts.0, end: counts.1 };
        let Ok(near) = f.projected(target, contact) else { return Ok(()) };
        let inside = |i: usize| contact.start <= i && i + contact.end < target.dim();
        let moved = (0..target.dim()).map(|i| if inside(i) { change[i].clone() } else { Q::int(0) }).collect();
        let other = near.spline.sum(&Function::new(target.clone(), moved)?)?;
        prop_assert!(squared_distance(&f, &near.spline)? <= squared_distance(&f, &other)?);
    }

    #[test]
    fn what_is_kept_at_the_ends_is_kept_exactly(
        [c, d] in curves::<2>(SMALL, CLAMPED.of_degree(0, 5)),
        counts in (0_usize..4, 0_usize..4),
    ) {
        let (target, contact) = (d.space(), Contact { start: counts.0, end: counts.1 });
        let near = c.projected(target, contact);
        if counts.0.max(counts.1) > target.degree() + 1 {
            let refused = matches!(near, Err(Error::DegreeTooLow { .. }));
            prop_assert!(refused);
            return Ok(());
        }
        if counts.0 + counts.1 > target.dim() {
            let expected = Error::CoefficientCount { expected: counts.0 + counts.1, found: target.dim() };
            prop_assert_eq!(near.unwrap_err(), expected);
            return Ok(());
        }
        let near = near?.spline;
        let (a, b) = c.domain();
        for (x, count) in [(a, counts.0), (b, counts.1)] {
            if count > 0 {
                prop_assert_eq!(near.derivatives_at(x, count - 1)?, c.derivatives_at(x, count - 1)?);
            }
        }
    }

    #[test]
    fn the_bound_holds_everywhere([f, g] in functions(SMALL, SMALL)) {
        let near = f.projected(g.space(), Contact::FREE)?;
        for x in probes(&f.space().union(g.space())?) {
            prop_assert!((f.at(&x)? - near.spline.at(&x)?).abs() <= near.bound);
            let left = if x == *f.domain().0 { f.domain().1 } else { &x };
            prop_assert!((f.at_left(left)? - near.spline.at_left(left)?).abs() <= near.bound);
        }
    }

    #[test]
    fn only_clamped_ends_can_be_kept(f in function(SMALL), target in space(SMALL)) {
        prop_assume!(!target.is_clamped() && f.domain() == target.domain());
        prop_assert_eq!(f.projected(&target, Contact::both(1)).unwrap_err(), Error::NotClamped);
    }

    #[test]
    fn a_tolerance_is_met_with_few_knots(f in function(ANY.of_degree(1, 4).smooth(1)), tenths in 1_i64..20) {
        let (a, b) = f.domain();
        let start = SplineSpace::bezier(1, a.clone(), b.clone())?;
        let size = f.size_bound()?;
        let tolerance = size * Q::frac(tenths, 20);
        let near = f.approximated_within(&start, &tolerance, Contact::both(1))?;
        prop_assert!(near.bound <= tolerance);
        prop_assert!(f.distance_bound_halved(&near.spline, 4)? <= near.bound);
        prop_assert_eq!(near.spline.at(a)?, f.at(a)?);
        prop_assert_eq!(near.spline.at(b)?, f.at(b)?);
    }
}

#[test]
fn knots_go_where_the_error_is() -> symspline::Result<()> {
    // Flat on [1, 8], a bump on [0, 1].
    let space = SplineSpace::clamped(3, [0.0, 0.25, 0.5, 0.75, 1.0, 8.0])?;
    let mut coeffs = vec![0.0; space.dim()];
    coeffs[2] = 1.0;
    let f = Function::new(space, coeffs)?;
    let near = f.approximated_within(&SplineSpace::bezier(1, 0.0, 8.0)?, &1e-3, Contact::both(1))?;
    let knots = near.spline.space().breaks();
    let right = knots.iter().filter(|(t, _)| *t > 1.5 && *t < 8.0).count();
    assert!(right <= 5, "{knots:?}");
    assert!(knots.len() > 8 && knots.len() < 60, "{}", knots.len());
    Ok(())
}

#[test]
fn jumps_are_taken_over() -> symspline::Result<()> {
    let space = SplineSpace::clamped(2, [0, 1, 1, 1, 3].map(Q::int))?;
    let jump = Function::new(space, [0, 0, 0, 1, 1, 1].map(Q::int).to_vec())?;
    let lines = SplineSpace::bezier(1, Q::int(0), Q::int(3))?;
    let near = jump.approximated_within(&lines, &Q::int(0), Contact::FREE)?;
    assert_eq!((near.spline.space(), near.bound), (&lines.refined(&[Q::int(1), Q::int(1)])?, Q::int(0)));
    let ring = SplineSpace::periodic(1, [Q::int(0)], Q::int(3))?;
    let closed = jump.approximated_within(&ring, &Q::int(0), Contact::FREE)?;
    assert!(closed.spline.space().is_periodic() && closed.bound == Q::int(0));
    Ok(())
}

#[test]
fn tolerances_out_of_reach_are_refused() -> symspline::Result<()> {
    let f = Function::monomial(3, 0.0, 1.0)?;
    let lines = SplineSpace::bezier(1, 0.0, 1.0)?;
    let refused = |tolerance: f64| f.approximated_within(&lines, &tolerance, Contact::FREE).unwrap_err();
    for tolerance in [0.0, 1e-18, 1e-13] {
        assert!(matches!(refused(tolerance), Error::OutOfTolerance { .. }), "{tolerance}");
    }
    for tolerance in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(refused(tolerance), Error::BadTolerance { .. }), "{tolerance}");
    }
    Ok(())
}
