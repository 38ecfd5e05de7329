//! Laws of knot removal and simplification.

use crate::strategies::{ANY, Kind, RING, cases, curve, function, indices, insertable, probes};
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{Coeff, Error, Function, Keep, Q, Scalar, Spline, SplineSpace};

const SMALL: Kind = ANY.of_degree(0, 5);

fn zero() -> Q {
    Q::int(0)
}

/// The knots inside with their numbers of copies, of a ring all.
fn inside(space: &SplineSpace<Q>) -> Vec<(Q, usize)> {
    let breaks = space.breaks();
    let from = usize::from(!space.is_periodic());
    breaks[from..breaks.len() - 1].to_vec()
}

/// How many copies of `t` a function of the degree of `f` needs: `p - k + 1` if the derivative of order `k` is the first that
/// jumps.
fn needed<C: Coeff<Q>>(f: &Spline<Q, C>, t: &Q) -> symspline::Result<usize> {
    let (p, pieces) = (f.degree(), f.bezier_pieces()?);
    let right = pieces.iter().find(|piece| piece.domain().0 == t).expect("a piece after the knot");
    let before = |piece: &&Spline<Q, C>| piece.domain().1 == t;
    let left = pieces.iter().find(before).unwrap_or(&pieces[pieces.len() - 1]);
    let (left, right) = (left.derivatives_at(left.domain().1, p)?, right.derivatives_at(t, p)?);
    Ok((0..=p).find(|&k| left[k] != right[k]).map_or(0, |k| p + 1 - k))
}

fn check_bound<C: Coeff<Q>>(f: &Spline<Q, C>, g: &Spline<Q, C>, bound: &Q) -> Result<(), TestCaseError> {
    let squared = bound.clone() * bound;
    for x in probes(f.space()) {
        prop_assert!(f.at(&x)?.minus(&g.at(&x)?).squared_size() <= squared);
        prop_assert!(f.at_left(&x)?.minus(&g.at_left(&x)?).squared_size() <= squared);
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn the_smallest_space_is_found(c in curve::<2>(ANY), places in indices(5)) {
        let fine = c.inserted(&insertable(c.space(), &places))?;
        let thin = fine.without_spare_knots(&zero())?;
        prop_assert_eq!(thin.bound, zero());
        prop_assert!(thin.spline.same_function(&c)?);
        let kept = inside(thin.spline.space());
        for (t, m) in inside(fine.space()) {
            let left = kept.iter().find(|(s, _)| *s == t).map_or(0, |(_, m)| *m);
            let seam = usize::from(fine.space().is_periodic() && t == *fine.domain().0);
            prop_assert_eq!(left, needed(&fine, &t)?.max(seam), "{} copies of {}", m, t);
        }
    }

    #[test]
    fn removal_undoes_insertion(f in function(ANY), places in indices(5)) {
        let thin = f.without_spare_knots(&zero())?.spline;
        let fine = thin.inserted(&insertable(thin.space(), &places))?;
        prop_assert_eq!(fine.without_spare_knots(&zero())?.spline, thin);
    }

    #[test]
    fn one_knot_is_removed_as_often_as_it_can_be(
        f in function(ANY),
        places in indices(5),
        place in any::<Index>(),
        times in 0_usize..6,
    ) {
        let fine = f.inserted(&insertable(f.space(), &places))?;
        let knots = inside(fine.space());
        prop_assume!(!knots.is_empty());
        let (t, m) = place.get(&knots);
        let seam = usize::from(fine.space().is_periodic() && t == fine.domain().0);
        let removed = fine.removed(t, times, &zero())?;
        prop_assert_eq!(removed.bound, zero());
        prop_assert!(removed.spline.same_function(&fine)?);
        let left = inside(removed.spline.space()).into_iter().find(|(s, _)| s == t).map_or(0, |(_, m)| m);
        prop_assert_eq!(m - left, times.min(m - needed(&fine, t)?.max(seam)));
    }

    #[test]
    fn tolerances_are_respected(c in curve::<2>(SMALL), places in indices(4), twentieths in 0_i64..30) {
        let fine = c.inserted(&insertable(c.space(), &places))?;
        let tolerance = c.size_bound()? * Q::frac(twentieths, 20);
        let thin = fine.without_spare_knots(&tolerance)?;
        prop_assert!(thin.bound <= tolerance);
        // Roots are rounded up.
        let bound = thin.bound.clone() * (Q::int(1) + Q::frac(1, 1 << 50));
        prop_assert!(fine.distance_bound(&thin.spline)? <= bound);
        check_bound(&fine, &thin.spline, &thin.bound)?;
        prop_assert!(fine.space().contains(thin.spline.space()));
    }

    #[test]
    fn with_room_enough_every_knot_goes(f in function(SMALL)) {
        let thin = f.without_spare_knots(&(f.size_bound()? * Q::int(1_000_000_000_000)))?;
        let left = usize::from(f.space().is_periodic());
        prop_assert_eq!(inside(thin.spline.space()).len(), left);
        check_bound(&f, &thin.spline, &thin.bound)?;
    }

    #[test]
    fn a_knot_dropped_changes_its_interval_only(f in function(SMALL), place in any::<Index>(), left in any::<bool>()) {
        let places: Vec<usize> = (f.degree() + 1..f.space().knots().len() - f.degree() - 1)
            .filter(|&r| f.space().knots()[r] < *f.domain().1).collect();
        prop_assume!(!places.is_empty());
        let r = *place.get(&places);
        let dropped = f.without_knot(r, if left { Keep::Left } else { Keep::Right });
        if f.space().is_periodic() && f.space().dim() < f.degree() + 2 {
            let refused = matches!(dropped, Err(Error::TooFewKnots { .. }));
            prop_assert!(refused);
            return Ok(());
        }
        let dropped = dropped?;
        prop_assert_eq!(dropped.spline.space().dim(), f.space().dim() - 1);
        check_bound(&f, &dropped.spline, &dropped.bound)?;
        let (a, b) = &dropped.changed;
        let period = f.domain().1.clone() - f.domain().0;
        for x in probes(f.space()) {
            let turns = if f.space().is_periodic() { -1..=1 } else { 0..=0 };
            let near = |x: &Q| turns.clone().any(|n| {
                let x = x.clone() + Q::int(n) * &period;
                *a <= x && x <= *b
            });
            if !near(&x) {
                prop_assert_eq!(dropped.spline.at(&x)?, f.at(&x)?);
            }
        }
    }

    #[test]
    fn simplified_splines_are_the_same_and_stay(f in function(ANY.of_degree(0, 4)), places in indices(3), raise in 0_usize..3) {
        let raised = f.elevated(raise)?;
        let fine = raised.inserted(&insertable(raised.space(), &places))?;
        let simple = fine.simplified()?;
        prop_assert!(simple.same_function(&f)?);
        prop_assert!(simple.degree() <= f.degree());
        prop_assert_eq!(&simple.simplified()?, &simple);
        if f.space().is_clamped() {
            prop_assert_eq!(f.simplified()?, simple);
        }
    }

    #[test]
    fn constants_need_one_coefficient(f in function(ANY), value in -9_i64..9) {
        let constant = Function::constant(f.space().clone(), Q::int(value))?.simplified()?;
        prop_assert_eq!((constant.degree(), constant.coeffs()), (0, &[Q::int(value)][..]));
    }

    #[test]
    fn small_rings_lose_knots_too(f in function(RING.of_degree(0, 6)), twentieths in 0_i64..30) {
        let tolerance = f.size_bound()? * Q::frac(twentieths, 20);
        let thin = f.without_spare_knots(&tolerance)?;
        prop_assert!(thin.spline.space().is_periodic() && thin.bound <= tolerance);
        check_bound(&f, &thin.spline, &thin.bound)?;
    }

    #[test]
    fn what_is_no_knot_inside_is_refused(f in function(ANY), place in any::<Index>()) {
        let space = f.space();
        let x = place.get(&probes(space)).clone();
        let known = inside(space).iter().any(|(t, _)| *t == x);
        let removed = f.removed(&x, 1, &zero());
        if known {
            prop_assert!(removed.is_ok());
        } else {
            prop_assert_eq!(removed.unwrap_err(), Error::NotRemovable { knot: x.to_string() });
        }
        let length = space.knots().len();
        prop_assert_eq!(f.without_knot(length, Keep::Left).unwrap_err(), Error::IndexOutOfRange { index: length, length });
    }
}

#[test]
fn bad_tolerances_are_refused() -> symspline::Result<()> {
    let f = Function::new(SplineSpace::clamped(1, [0.0, 1.0, 2.0])?, vec![0.0, 1.0, 5.0])?;
    for tolerance in [-1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let errors = [
            f.removed(&1.0, 1, &tolerance).unwrap_err(),
            f.without_spare_knots(&tolerance).unwrap_err(),
            f.simplified_within(&tolerance).unwrap_err(),
        ];
        assert!(errors.iter().all(|error| matches!(error, Error::BadTolerance { .. })));
    }
    assert_eq!(f.removed(&1.0, usize::MAX, &10.0)?.spline.space().dim(), 2);
    Ok(())
}
