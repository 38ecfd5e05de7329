//! Laws of reversal.

use crate::strategies::{ANY, SMOOTH, cases, curve, function, functions, indices, insertable, probes, space};
use proptest::prelude::*;
use symspline::Q;

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn reversing_twice_changes_nothing(c in curve::<2>(ANY)) {
        let reversed = c.reversed()?;
        prop_assert_eq!(c.space().reversal().apply(c.coeffs())?, reversed.coeffs());
        prop_assert_eq!(reversed.reversed()?, c);
    }

    #[test]
    fn a_reversed_spline_has_the_mirrored_values(f in function(ANY)) {
        let (reversed, (a, b)) = (f.reversed()?, f.domain());
        prop_assert_eq!(reversed.domain(), (a, b));
        for x in probes(f.space()) {
            let mirrored = a.clone() + b - &x;
            // What was on the right is on the left; at an open end there is one side only.
            if x > *a {
                prop_assert_eq!(f.at_left(&x)?, reversed.at(&mirrored)?);
            }
            if x < *b {
                prop_assert_eq!(f.at(&x)?, reversed.at_left(&mirrored)?);
            }
        }
    }

    #[test]
    fn a_reversed_space_has_the_mirrored_knots(space in space(ANY)) {
        let (reversed, (a, b)) = (space.reversed()?, space.domain());
        let mut expected: Vec<(Q, usize)> =
            space.breaks().into_iter().map(|(t, m)| (a.clone() + b - t, m)).collect();
        expected.reverse();
        prop_assert_eq!(reversed.breaks(), expected);
        prop_assert_eq!(reversed.is_periodic(), space.is_periodic());
        prop_assert_eq!(reversed.is_clamped(), space.is_clamped());
    }

    #[test]
    fn reversal_flips_the_derivative(f in function(SMOOTH)) {
        prop_assert_eq!(f.reversed()?.derivative()?, -&f.derivative()?.reversed()?);
    }

    #[test]
    fn reversal_keeps_the_integral(f in function(ANY)) {
        prop_assert_eq!(f.reversed()?.integral()?, f.integral()?);
    }

    #[test]
    fn reversal_commutes_with_sums_and_products(
        [f, g] in functions(ANY.of_degree(0, 4), ANY.of_degree(0, 4)),
    ) {
        let (back_f, back_g) = (f.reversed()?, g.reversed()?);
        prop_assert_eq!((&f + &g).reversed()?, &back_f + &back_g);
        prop_assert_eq!((&f * &g).reversed()?, &back_f * &back_g);
    }

    #[test]
    fn reversal_commutes_with_elevation_and_insertion(
        f in function(ANY),
        places in indices(3),
        raise in 0_usize..3,
    ) {
        prop_assert_eq!(f.elevated(raise)?.reversed()?, f.reversed()?.elevated(raise)?);
        let (a, b) = f.domain();
        // A knot inserted at the seam of a ring stays at the seam.
        let mirror = |t: &Q| if t == a { a.clone() } else { a.clone() + b - t };
        let knots = insertable(f.space(), &places);
        let mirrored: Vec<Q> = knots.iter().map(mirror).collect();
        prop_assert_eq!(f.inserted(&knots)?.reversed()?, f.reversed()?.inserted(&mirrored)?);
    }
}
