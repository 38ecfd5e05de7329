//! Laws of spaces beside spaces: containment, unions, product spaces.

use crate::strategies::{ANY, OPEN, cases, indices, insertable, space, spaces, three_spaces};
use proptest::prelude::*;
use symspline::{Error, Q, SplineSpace};

/// How often a space has the knot `t` inside, in a ring also at the seam.
fn copies(space: &SplineSpace<Q>, t: &Q) -> usize {
    let (a, b) = space.domain();
    let inside = |s: &Q| (a < s || space.is_periodic()) && s < b;
    space.breaks().iter().find(|(s, _)| s == t && inside(s)).map_or(0, |(_, m)| *m)
}

/// The spaces that are smaller by one copy of one knot inside, ends clamped unless it is a ring.
fn coarser(space: &SplineSpace<Q>) -> Vec<SplineSpace<Q>> {
    let breaks = space.breaks();
    let last = breaks.len() - 1;
    let without = |skip: usize| {
        let kept = |(i, (t, m)): (usize, &(Q, usize))| vec![t.clone(); m - usize::from(i == skip)];
        if space.is_periodic() {
            let round: Vec<Q> = breaks[..last].iter().enumerate().flat_map(kept).collect();
            let (a, b) = space.domain();
            // The seam itself cannot go: the ring would begin elsewhere.
            (round.first() == Some(a))
                .then(|| SplineSpace::periodic(space.degree(), round, b.clone() - a).expect("fewer knots"))
        } else {
            let inner = breaks.iter().enumerate().take(last).skip(1).flat_map(kept);
            let ends = [&breaks[0].0, &breaks[last].0].map(|t| [t.clone()]);
            let [a, b] = ends;
            Some(
                SplineSpace::clamped(space.degree(), a.into_iter().chain(inner).chain(b))
                    .expect("fewer knots"),
            )
        }
    };
    let knots = if space.is_periodic() { 0..last } else { 1..last };
    knots.filter_map(without).collect()
}

proptest! {
    #![proptest_config(cases(128))]

    #[test]
    fn containment_is_reflexive_and_transitive(spaces in three_spaces(ANY)) {
        for a in &spaces {
            prop_assert!(a.contains(a));
            for b in &spaces {
                for c in &spaces {
                    prop_assert!(!(a.contains(b) && b.contains(c)) || a.contains(c));
                }
            }
        }
    }

    #[test]
    fn containment_compares_degrees_and_copies([f, g] in spaces(ANY, ANY)) {
        let raise = f.degree() as isize - g.degree() as isize;
        let enough = |(t, _): &(Q, usize)| {
            let needed = copies(&g, t);
            needed == 0 || copies(&f, t) as isize >= needed as isize + raise
        };
        let open = g.is_periodic() || !f.is_periodic();
        let mut breaks = g.breaks();
        // An open space has no condition at the seam of a ring.
        if !f.is_periodic() {
            breaks.remove(0);
        }
        prop_assert_eq!(f.contains(&g), raise >= 0 && open && breaks.iter().all(enough));
        prop_assert_eq!(f.contains(&g), g.embedding(&f).is_ok());
    }

    #[test]
    fn finer_spaces_contain_coarser_ones(space in space(ANY), places in indices(5), raise in 0_usize..4) {
        let refined = space.refined(&insertable(&space, &places))?;
        let raised = space.elevated(raise)?;
        let both = refined.elevated(raise)?;
        prop_assert!(refined.contains(&space) && raised.contains(&space));
        prop_assert!(both.contains(&refined) && both.contains(&raised));
        prop_assert_eq!(space.contains(&raised), raise == 0);
        prop_assert_eq!(space.contains(&refined), refined == space);
        prop_assert!(space.clamped_ends()?.contains(&space));
    }

    #[test]
    fn a_union_contains_both([f, g] in spaces(ANY, ANY)) {
        let union = f.union(&g)?;
        prop_assert!(union.contains(&f) && union.contains(&g));
        prop_assert_eq!(union.is_periodic(), f.is_periodic() && g.is_periodic());
    }

    #[test]
    fn unions_commute_and_are_idempotent([f, g] in spaces(ANY, ANY)) {
        let union = f.union(&g)?;
        prop_assert_eq!(&g.union(&f)?, &union);
        prop_assert_eq!(&f.union(&f)?, &f);
        prop_assert_eq!(&union.union(&union)?, &union);
        let again = union.union(&f)?;
        prop_assert!(again.contains(&union) && union.clamped_ends()?.contains(&again));
    }

    #[test]
    fn unions_associate([f, g, h] in three_spaces(ANY)) {
        prop_assert_eq!(f.union(&g)?.union(&h)?, f.union(&g.union(&h)?)?);
    }

    #[test]
    fn a_union_is_the_smallest([f, g] in spaces(ANY, ANY)) {
        let union = f.union(&g)?;
        prop_assert_eq!(union.degree(), f.degree().max(g.degree()));
        for smaller in coarser(&union) {
            prop_assert!(!(smaller.contains(&f) && smaller.contains(&g)), "{smaller:?} will do");
        }
    }

    #[test]
    fn product_spaces_commute_and_associate([f, g, h] in three_spaces(ANY.of_degree(0, 5))) {
        prop_assert_eq!(f.product_space(&g)?, g.product_space(&f)?);
        prop_assert_eq!(f.product_space(&g)?.product_space(&h)?, f.product_space(&g.product_space(&h)?)?);
    }

    #[test]
    fn a_knot_of_a_product_has_the_copies_its_smoothness_takes([f, g] in spaces(ANY, ANY)) {
        let (p, q, product) = (f.degree(), g.degree(), f.product_space(&g)?);
        prop_assert_eq!(product.degree(), p + q);
        prop_assert_eq!(product.is_periodic(), f.is_periodic() && g.is_periodic());
        prop_assert!(product.is_periodic() || product.is_clamped());
        let (a, _) = f.domain();
        for (t, _) in f.breaks().iter().chain(&g.breaks()).chain(&product.breaks()) {
            if t == a && !product.is_periodic() {
                continue;
            }
            let (m, n) = (copies(&f, t), copies(&g, t));
            let expected = if m > 0 { m + q } else { 0 }.max(if n > 0 { n + p } else { 0 });
            prop_assert_eq!(copies(&product, t), expected);
        }
    }

    #[test]
    fn a_product_with_polynomials_is_as_smooth_as_the_factor(f in space(OPEN), q in 0_usize..4) {
        let (a, b) = f.domain();
        let polynomials = SplineSpace::bezier(q, a.clone(), b.clone())?;
        prop_assert_eq!(f.product_space(&polynomials)?, f.clamped_ends()?.elevated(q)?);
    }

    #[test]
    fn other_domains_are_refused(f in space(ANY), g in space(ANY)) {
        prop_assume!(f.domain() != g.domain());
        prop_assert!(!f.contains(&g));
        let errors = [
            f.union(&g).err(),
            f.product_space(&g).err(),
            f.embedding(&g).err(),
            f.gram(&g, 0, 0).err(),
            f.multiplication(&g).err(),
        ];
        prop_assert!(errors.iter().all(|e| matches!(e, Some(Error::DomainMismatch { .. }))), "{errors:?}");
    }
}
