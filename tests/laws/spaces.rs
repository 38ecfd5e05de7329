//! Laws of spline spaces: knots, spans, dimensions, and spaces made from a space.

use crate::strategies::{ANY, OPEN, RING, cases, indices, insertable, probes, space};
use proptest::prelude::*;
use symspline::{Q, Scalar, SplineSpace};

proptest! {
    #![proptest_config(cases(128))]

    #[test]
    fn knots_spans_and_dimension_agree(space in space(ANY)) {
        let (p, t, breaks) = (space.degree(), space.knots(), space.breaks());
        let (a, b) = space.domain();
        let copies: usize = breaks[1..breaks.len() - 1].iter().map(|(_, m)| m).sum();
        if space.is_periodic() {
            prop_assert_eq!(space.dim(), breaks[0].1 + copies);
            prop_assert_eq!(t.len(), space.dim() + 2 * p + 1);
            prop_assert_eq!(breaks[0].1, breaks[breaks.len() - 1].1);
        } else {
            prop_assert_eq!(space.dim(), p + 1 + copies);
            prop_assert_eq!(t.len(), space.dim() + p + 1);
        }
        prop_assert_eq!((&breaks[0].0, &breaks[breaks.len() - 1].0), (a, b));
        prop_assert!(breaks.windows(2).all(|pair| pair[0].0 < pair[1].0));
        prop_assert!(breaks.iter().all(|(_, m)| (1..=p + 1).contains(m)));
        let spans: Vec<(&Q, &Q)> = space.spans().map(|k| (&t[k], &t[k + 1])).collect();
        let between: Vec<(&Q, &Q)> = breaks.windows(2).map(|pair| (&pair[0].0, &pair[1].0)).collect();
        prop_assert_eq!(spans, between);
        prop_assert_eq!(space.is_clamped(), !space.is_periodic() && t[0] == *a && t[t.len() - 1] == *b);
    }

    #[test]
    fn knots_of_a_ring_repeat_after_the_period(space in space(RING)) {
        let (t, m, p) = (space.knots(), space.dim(), space.degree());
        let (a, b) = space.domain();
        for i in 0..t.len() - m {
            prop_assert_eq!(&t[i + m], &(t[i].clone() + b - a));
        }
        prop_assert!(t[p] == *a && t[p + 1] > *a, "t_p is the last copy of the seam");
    }

    #[test]
    fn a_space_is_made_by_its_knots(space in space(ANY)) {
        let rebuilt = if space.is_periodic() {
            let breaks = space.breaks();
            let round = breaks[..breaks.len() - 1].iter().flat_map(|(t, m)| vec![t.clone(); *m]);
            let (a, b) = space.domain();
            SplineSpace::periodic(space.degree(), round, b.clone() - a)?
        } else {
            SplineSpace::new(space.degree(), space.knots().iter().cloned())?
        };
        prop_assert_eq!(&rebuilt, &space);
        prop_assert_eq!(space.map_scalars(|x| Ok(x.clone()))?, space);
    }

    #[test]
    fn elevation_raises_the_copies_of_every_knot(space in space(ANY), raise in 0_usize..4) {
        let raised = space.elevated(raise)?;
        prop_assert_eq!(raised.degree(), space.degree() + raise);
        prop_assert_eq!(raised.is_periodic(), space.is_periodic());
        let expected: Vec<(Q, usize)> = space.breaks().into_iter().map(|(t, m)| (t, m + raise)).collect();
        prop_assert_eq!(raised.breaks(), expected);
    }

    #[test]
    fn elevations_add_up(space in space(ANY), r in 0_usize..4, s in 0_usize..4) {
        prop_assert_eq!(space.elevated(r)?.elevated(s)?, space.elevated(r + s)?);
    }

    #[test]
    fn refinement_does_not_depend_on_the_order_of_knots(space in space(ANY), places in indices(6)) {
        let mut knots = insertable(&space, &places);
        let refined = space.refined(&knots)?;
        prop_assert_eq!(refined.dim(), space.dim() + knots.len());
        knots.reverse();
        prop_assert_eq!(&space.refined(&knots)?, &refined);
        let one_by_one = knots.iter().try_fold(space, |space, t| space.refined(std::slice::from_ref(t)))?;
        prop_assert_eq!(one_by_one, refined);
    }

    #[test]
    fn bisection_doubles_the_spans(space in space(ANY)) {
        let bisected = space.bisected()?;
        prop_assert_eq!(bisected.spans().count(), 2 * space.spans().count());
        prop_assert!(bisected.contains(&space));
    }

    #[test]
    fn the_ends_are_clamped_and_unclamped_within_the_same_splines(space in space(OPEN)) {
        let (clamped, unclamped) = (space.clamped_ends()?, space.unclamped_ends()?);
        prop_assert!(clamped.is_clamped());
        prop_assert!(space.degree() == 0 || !unclamped.is_clamped());
        for other in [&clamped, &unclamped] {
            prop_assert_eq!(other.dim(), space.dim());
            prop_assert!(other.contains(&space) && space.contains(other));
        }
        prop_assert_eq!(unclamped.clamped_ends()?, clamped);
    }

    #[test]
    fn outer_knots_are_what_is_asked_for(space in space(OPEN)) {
        let p = space.degree();
        let other = space.unclamped_ends()?;
        let t = other.knots();
        let moved = space.with_outer_knots(&t[..p], &t[t.len() - p..])?;
        prop_assert_eq!(moved, other);
    }

    #[test]
    fn pieces_have_every_knot_degree_plus_one_times(space in space(ANY), degree in 0_usize..6) {
        let pieces = space.pieces(degree)?;
        prop_assert_eq!(pieces.dim(), (degree + 1) * space.spans().count());
        prop_assert!(pieces.breaks().iter().all(|(_, m)| *m == degree + 1));
        prop_assert_eq!(pieces.contains(&space), degree >= space.degree());
    }

    #[test]
    fn equal_spans_are_equal(p in 0_usize..6, spans in 1_usize..9) {
        let space = SplineSpace::uniform(p, spans, Q::frac(-1, 3), Q::int(2))?;
        let length = Q::frac(7, 3) / Q::int(spans as i64);
        prop_assert!(space.breaks().windows(2).all(|pair| pair[1].0.clone() - &pair[0].0 == length));
        prop_assert_eq!(space.dim(), p + spans);
    }

    #[test]
    fn restriction_keeps_the_knots_between(
        space in space(ANY),
        places in (any::<prop::sample::Index>(), any::<prop::sample::Index>()),
    ) {
        let probes = probes(&space);
        let (a, b) = (places.0.get(&probes), places.1.get(&probes));
        prop_assume!(a < b);
        let part = space.restricted_space(a, b)?;
        prop_assert!(part.is_clamped() && part.domain() == (a, b));
        let inside = |(t, _): &(Q, usize)| a < t && t < b;
        let expected: Vec<_> = space.breaks().into_iter().filter(inside).collect();
        let found: Vec<_> = part.breaks().into_iter().filter(inside).collect();
        prop_assert_eq!(found, expected);
    }
}
