//! Laws of degree reduction.

use crate::strategies::{ANY, CLAMPED, Kind, cases, curve, function, indices, insertable, probes, space};
use proptest::prelude::*;
use symspline::{Contact, Continuity, Error, Q, Scalar, SplineSpace};

const SMALL: Kind = ANY.of_degree(1, 4);

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn spaces_come_back_from_elevation(space in space(ANY), raise in 0_usize..4) {
        let back = space.elevated(raise)?.reduced(raise)?;
        prop_assert_eq!(back.domain(), space.domain());
        prop_assert_eq!(back.degree(), space.degree());
        prop_assert_eq!(back.is_periodic(), space.is_periodic());
        // Unclamped, up to outer knots.
        prop_assert!(back.contains(&space) && space.contains(&back));
        if space.is_clamped() || space.is_periodic() {
            prop_assert_eq!(back, space);
        }
    }

    #[test]
    fn splines_come_back_from_elevation(c in curve::<2>(ANY), raise in 0_usize..4) {
        let back = c.elevated(raise)?.degree_reduced_exactly(raise)?;
        prop_assert_eq!(&back.embedded(c.space())?, &c);
        if c.space().is_clamped() || c.space().is_periodic() {
            prop_assert_eq!(back, c);
        }
    }

    #[test]
    fn knots_inserted_after_elevation_do_not_matter(
        f in function(ANY.of_degree(0, 4)),
        places in indices(4),
        raise in 1_usize..3,
    ) {
        let raised = f.elevated(raise)?;
        let fine = raised.inserted(&insertable(raised.space(), &places))?;
        let back = fine.degree_reduced_exactly(raise)?;
        prop_assert_eq!(back.degree(), f.degree());
        prop_assert!(back.same_function(&f)?);
        prop_assert_eq!(fine.degree_lowered(raise)?.bound, Q::int(0));
    }

    #[test]
    fn only_splines_of_the_degree_are_reduced(f in function(SMALL)) {
        let reduced = f.degree_reduced_exactly(1);
        let pieces = f.bezier_pieces()?;
        let p = f.degree();
        let flat = pieces.iter().all(|piece| piece.nth_derivative(p).is_ok_and(|d| d.coeffs()[0] == Q::int(0)));
        prop_assert_eq!(reduced.is_ok(), flat);
        match reduced {
            Ok(g) => prop_assert!(g.same_function(&f)?),
            Err(error) => prop_assert_eq!(error, Error::NotReducible { degree: p - 1 }),
        }
    }

    #[test]
    fn the_local_bound_holds(f in function(SMALL), by in 1_usize..3) {
        prop_assume!(by <= f.degree());
        let near = f.degree_lowered(by)?;
        prop_assert_eq!(near.spline.space(), &f.space().reduced(by)?);
        for x in probes(f.space()) {
            prop_assert!((f.at(&x)? - near.spline.at(&x)?).abs() <= near.bound);
            prop_assert!((f.at_left(&x)? - near.spline.at_left(&x)?).abs() <= near.bound);
        }
    }

    #[test]
    fn multiplicities_are_those_of_the_continuity(space in space(ANY.of_degree(1, 6)), by in 0_usize..4, smooth in 0_usize..4) {
        prop_assume!(by <= space.degree());
        let q = space.degree() - by;
        for continuity in [Continuity::Kept, Continuity::Breaks, Continuity::AtMost(smooth)] {
            let reduced = space.reduced_with(by, continuity)?;
            prop_assert_eq!((reduced.degree(), reduced.domain()), (q, space.domain()));
            let (old, new) = (space.breaks(), reduced.breaks());
            for (t, m) in &old[1..old.len() - 1] {
                let found = new.iter().find(|(s, _)| s == t).map_or(0, |(_, n)| *n);
                let expected = match continuity {
                    Continuity::Kept => m.saturating_sub(by),
                    Continuity::Breaks => m.saturating_sub(by).max(1),
                    Continuity::AtMost(r) => m.saturating_sub(by).max(1).max(q.saturating_sub(r)),
                };
                prop_assert_eq!(found, expected);
            }
            prop_assert!(reduced.is_clamped() || !space.is_clamped());
        }
    }

    #[test]
    fn the_best_of_lower_degree_is_orthogonal_and_bounded(f in function(SMALL.of_degree(1, 3)), smooth in 0_usize..3) {
        for continuity in [Continuity::Kept, Continuity::Breaks, Continuity::AtMost(smooth)] {
            let near = f.degree_reduced(1, continuity, Contact::FREE)?;
            let target = near.spline.space();
            let left = target.gram(f.space(), 0, 0)?.apply(f.coeffs())?;
            prop_assert_eq!(left, target.gram(target, 0, 0)?.apply(near.spline.coeffs())?);
            for x in probes(f.space()) {
                prop_assert!((f.at(&x)? - near.spline.at(&x)?).abs() <= near.bound);
            }
        }
    }

    #[test]
    fn tolerances_are_respected_and_ends_held(c in curve::<2>(CLAMPED.of_degree(2, 4).smooth(1)), twentieths in 2_i64..20) {
        let tolerance = c.size_bound()? * Q::frac(twentieths, 20);
        let near = c.degree_reduced_within(1, &tolerance, Contact::both(1))?;
        prop_assert!(near.bound <= tolerance);
        prop_assert_eq!(near.spline.degree(), c.degree() - 1);
        prop_assert!(c.distance_bound_halved(&near.spline, 3)? <= near.bound);
        let (a, b) = c.domain();
        for x in [a, b] {
            prop_assert_eq!(near.spline.at(x)?, c.at(x)?);
        }
    }

    #[test]
    fn what_needs_no_knots_gets_none(f in function(CLAMPED.of_degree(1, 4)), places in indices(3)) {
        let raised = f.elevated(1)?;
        let fine = raised.inserted(&insertable(raised.space(), &places))?;
        let near = fine.degree_reduced_within(1, &Q::int(0), Contact::both(1))?;
        prop_assert_eq!(near.bound, Q::int(0));
        prop_assert_eq!(near.spline.space(), &fine.space().reduced(1)?);
    }

    #[test]
    fn no_degree_below_zero(f in function(ANY), more in 1_usize..5) {
        let (p, by) = (f.degree(), f.degree() + more);
        let expected = Error::DegreeTooLow { degree: p, needed: by };
        prop_assert_eq!(&f.space().reduced(by).unwrap_err(), &expected);
        prop_assert_eq!(&f.degree_reduced_exactly(by).unwrap_err(), &expected);
        prop_assert_eq!(f.degree_lowered(usize::MAX).unwrap_err(), Error::DegreeTooLow { degree: p, needed: usize::MAX });
        prop_assert_eq!(&f.degree_reduced(by, Continuity::Kept, Contact::FREE).unwrap_err(), &expected);
        prop_assert_eq!(&f.degree_reduced_within(by, &Q::int(1), Contact::FREE).unwrap_err(), &expected);
    }
}

#[test]
fn high_degrees_come_back() -> symspline::Result<()> {
    let space = SplineSpace::clamped(10, [0, 1, 3].map(Q::int))?;
    let coeffs = (0..space.dim() as i64).map(|i| Q::frac(i * i % 7 - 3, i + 1)).collect();
    let f = symspline::Function::new(space, coeffs)?;
    assert_eq!(f.elevated(3)?.degree_reduced_exactly(3)?, f);
    Ok(())
}
