//! Laws of local fine tuning with the degree kept: within a certified bound, and the rest exactly as it was.

use crate::local::{
    CURVE, HOLDS, check_copies, check_pieces, curve_and_portion, in_space, inside, local, rise, wave,
};
use crate::strategies::{ANY, Kind, cases, probes};
use nalgebra::vector;
use proptest::prelude::*;
use proptest::sample::select;
use symspline::{Coeff, Curve, Error, Function, Hold, Q, Scalar, SplineSpace};

/// Small numbers, since projections are exact.
const SMALL: Kind = ANY.of_degree(1, 3).smooth(1).few(1);

proptest! {
    #![proptest_config(cases(16))]

    #[test]
    fn the_reduced_whole_has_the_old_degree((c, alpha) in curve_and_portion(SMALL, 1..=1), (j, hold) in select(&HOLDS[..])) {
        let Some(local) = local(&c, &alpha, hold)? else { return Ok(()) };
            let n = c.degree();
            if j > n {
                prop_assert!(local.reduced(&Q::int(1)).is_err());
                return Ok(());
            }
            // A round or two of refinement.
            let far = local.tuned().curve.distance_bound(&c.restricted(alpha.domain().0, alpha.domain().1)?)?;
            let tolerance = far * Q::frac(1, 6);
            let reduced = match local.reduced(&tolerance) {
                Ok(reduced) => reduced,
                Err(error) => {
                    prop_assert_eq!(tolerance, Q::int(0));
                    let missed = matches!(error, Error::OutOfTolerance { .. });
                    prop_assert!(missed, "{}", error);
                    return Ok(());
                }
            };
            let (near, bound) = (&reduced.spline, &reduced.bound);
            prop_assert!(near.degree() == n && *bound <= tolerance);
            let (a, b) = alpha.domain();
            let portion = near.restricted(a, b)?;
            check_pieces(near, &c, &portion)?;
            check_copies(near, &c, portion.space(), j)?;
            let whole = local.joined()?;
            for x in probes(near.space()) {
                let gap = near.at(&x)? - whole.at(&x)?;
                prop_assert!(gap.squared_size() <= bound.clone() * bound);
            }
            for x in [a, b] {
                prop_assert_eq!(portion.derivatives_at(x, j)?, c.restricted(a, b)?.derivatives_at(x, j)?);
            }
    }

    #[test]
    fn what_is_of_the_old_degree_is_reduced_exactly((c, alpha) in curve_and_portion(CURVE, 0..=2)) {
        let one = Function::constant(alpha.space().clone(), Q::int(1))?;
        for (j, hold) in HOLDS {
            let Some(local) = local(&c, &one, hold)?.filter(|_| j <= c.degree()) else { continue };
            let reduced = local.reduced(&Q::int(0))?;
            prop_assert!(reduced.spline.same_function(&c)? && reduced.bound == Q::int(0));
        }
    }
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn in_space_the_degree_is_kept_within_the_bound((c, alpha) in in_space()) {
        for (j, hold) in HOLDS {
            let local = match c.fine_tuned_on(&alpha, hold) {
                Err(Error::NoChord | Error::CoefficientCount { .. }) => continue,
                local => local?,
            };
            let (whole, (&a, &b)) = (local.joined()?, alpha.domain());
            let tolerance = 0.02 * whole.size_bound()?;
            let reduced = local.reduced(&tolerance)?;
            let near = &reduced.spline;
            prop_assert!(near.degree() == c.degree() && reduced.bound <= tolerance);
            let same = c.embedded(near.space())?;
            let within = inside(near, a, b);
            prop_assert!((0..near.coeffs().len()).all(|i| within(i) || near.coeffs()[i] == same.coeffs()[i]));
            for k in 0..=80 {
                let x = f64::from(k) * 0.05;
                prop_assert!((near.at(&x)? - whole.at(&x)?).norm() <= reduced.bound);
            }
            let breaks = near.space().breaks();
            for x in [a, b].iter().filter(|x| 0.0 < **x && **x < 4.0) {
                let copies = breaks.iter().find(|(t, _)| t == x).map_or(0, |(_, m)| *m);
                prop_assert!(copies <= (c.degree() - j).max(1));
            }
        }
    }
}

#[test]
fn reductions_that_fail_say_why() -> symspline::Result<()> {
    let local =
        wave(1, &[0, 1, 2, 3])?.fine_tuned_on(&rise(Q::frac(1, 2), Q::frac(5, 2))?, Hold::Curvatures)?;
    assert_eq!(local.reduced(&Q::int(1)).unwrap_err(), Error::DegreeTooLow { degree: 1, needed: 2 });
    let bad = local.reduced(&Q::int(-1)).unwrap_err();
    assert_eq!(bad, Error::BadTolerance { tolerance: "-1".into() });
    let tangents = wave(2, &[0, 1, 2])?.fine_tuned_on(&rise(Q::int(0), Q::int(2))?, Hold::Tangents)?;
    assert!(matches!(tangents.reduced(&Q::int(0)), Err(Error::OutOfTolerance { .. })));
    let floats = Curve::new(
        SplineSpace::bezier(2, 0.0, 1.0)?,
        vec![vector![0.0, 0.0], vector![1.0, 2.0], vector![2.0, 0.0]],
    )?;
    let alpha = Function::new(SplineSpace::bezier(1, 0.25, 1.0)?, vec![1.0, 2.0])?;
    for tolerance in [f64::NAN, -1.0, f64::INFINITY] {
        let refused = floats.fine_tuned_within(&alpha, Hold::Points, &tolerance);
        assert!(matches!(refused, Err(Error::BadTolerance { .. })));
    }
    for tolerance in [0.0, 1e-17, 5e-324] {
        let refused = floats.fine_tuned_within(&alpha, Hold::Points, &tolerance);
        assert!(matches!(refused, Err(Error::OutOfTolerance { .. })), "{refused:?}");
    }
    Ok(())
}
