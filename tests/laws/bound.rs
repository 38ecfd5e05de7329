//! Laws of certified bounds.

use crate::strategies::{ANY, Kind, cases, curves, function, functions, indices, insertable, point, probes};
use proptest::prelude::*;
use symspline::{Coeff, Curve, Q, Scalar};

const SMALL: Kind = ANY.of_degree(0, 5);

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn no_value_is_larger_than_the_size_bound(f in function(ANY)) {
        let bound = f.size_bound()?;
        for x in probes(f.space()) {
            prop_assert!(f.at(&x)?.abs() <= bound && f.at_left(&x)?.abs() <= bound);
        }
    }

    #[test]
    fn no_two_values_are_further_apart_than_the_bound([f, g] in curves::<2>(SMALL, SMALL), halvings in 0_usize..4) {
        let (coarse, sharp) = (f.distance_bound(&g)?, f.distance_bound_halved(&g, halvings)?);
        for x in probes(f.difference(&g)?.space()) {
            // Left of its start a ring has its end.
            let left = if x == *f.domain().0 { f.domain().1 } else { &x };
            for (c, d) in [(f.at(&x)?, g.at(&x)?), (f.at_left(left)?, g.at_left(left)?)] {
                let squared = Coeff::<Q>::squared_size(&c.minus(&d));
                prop_assert!(squared <= coarse.clone() * &coarse);
                prop_assert!(squared <= sharp.clone() * &sharp);
            }
        }
    }

    #[test]
    fn halving_sharpens_the_bound([f, g] in functions(SMALL, SMALL)) {
        let bound = |halvings: usize| f.distance_bound_halved(&g, halvings);
        prop_assert!(bound(1)? <= bound(0)? && bound(3)? <= bound(1)?);
    }

    #[test]
    fn halving_closes_in_on_the_largest_value([f, g] in functions(ANY.of_degree(0, 3), ANY.of_degree(0, 2))) {
        // The excess of degree 3 is at most that of the control polygon, second differences, a quarter each time.
        let difference = f.difference(&g)?;
        let (largest, bound) = (difference.size_bound()?, f.distance_bound_halved(&g, 6)?);
        let fine = (0..5).try_fold(difference, |h, _| h.inserted(&h.space().bisected()?.breaks()[1..].iter().step_by(2)
            .map(|(t, _)| t.clone()).filter(|t| !h.space().knots().contains(t)).collect::<Vec<_>>()))?;
        let mut reached = Q::int(0);
        for x in probes(fine.space()) {
            reached = reached.max(fine.at(&x)?.abs()).max(fine.at_left(&x)?.abs());
        }
        prop_assert!(bound.clone() - &reached <= largest * Q::frac(1, 8), "{bound} for {reached}");
    }

    #[test]
    fn the_distance_is_zero_exactly_for_the_same_function(f in function(ANY), places in indices(3), raise in 0_usize..2) {
        let same = f.elevated(raise)?.inserted(&insertable(f.space(), &places))?;
        prop_assert_eq!(f.distance_bound(&same)?, Q::int(0));
        prop_assert_eq!(f.distance_bound_halved(&same, 2)?, Q::int(0));
        let other = f.translated(&Q::frac(1, 3))?;
        prop_assert_eq!(f.distance_bound(&other)?, Q::frac(1, 3));
    }

    #[test]
    fn translations_have_the_length_of_their_vector([f, _] in curves::<3>(SMALL, SMALL), by in point::<3>()) {
        let moved: Curve<Q, 3> = f.translated(&by)?;
        prop_assert_eq!(f.distance_bound(&moved)?, Coeff::<Q>::squared_size(&by).root_above());
    }
}

#[test]
fn tiny_and_huge_sizes_do_not_vanish_or_overflow() -> symspline::Result<()> {
    use nalgebra::vector;
    use symspline::SplineSpace;
    for scale in [1e-300, 1e-170, 1.0, 1e170, 1e300] {
        let space = SplineSpace::bezier(1, 0.0, 1.0)?;
        let f = Curve::new(space, vec![vector![3.0 * scale, 4.0 * scale], vector![0.0, 0.0]])?;
        let bound = f.size_bound()?;
        assert!(bound >= 5.0 * scale && bound <= 5.0 * scale * (1.0 + 1e-14), "{bound:e}");
        let none = f.scaled(&0.0)?;
        assert!(f.distance_bound(&none)? >= 5.0 * scale);
    }
    Ok(())
}
