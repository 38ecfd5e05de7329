//! Laws of degree elevation.

use crate::oracle::{self, Side};
use crate::strategies::{ANY, SMOOTH, cases, curve, function, indices, insertable, probes, space};
use proptest::prelude::*;
use symspline::{Function, Q, Scalar, SplineSpace};

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn elevation_changes_no_value(f in function(ANY), raise in 0_usize..4) {
        let raised = f.elevated(raise)?;
        prop_assert_eq!(raised.degree(), f.degree() + raise);
        for x in probes(f.space()) {
            prop_assert_eq!(raised.at(&x)?, oracle::value(&f, &x, Side::Right));
            prop_assert_eq!(raised.at_left(&x)?, oracle::value(&f, &x, Side::Left));
        }
    }

    #[test]
    fn the_kernel_of_elevation_gives_what_its_map_gives(c in curve::<2>(ANY), raise in 0_usize..4) {
        let raised = c.elevated(raise)?;
        let map = c.space().embedding(&c.space().elevated(raise)?)?;
        prop_assert_eq!(map.apply(c.coeffs())?, raised.coeffs());
    }

    #[test]
    fn elevated_coefficients_are_convex_combinations(space in space(ANY), raise in 0_usize..4) {
        for (_, weights) in space.embedding(&space.elevated(raise)?)?.rows() {
            prop_assert_eq!(weights.iter().sum::<Q>(), Q::int(1));
            prop_assert!(weights.iter().all(|w| !w.is_negative()));
        }
    }

    #[test]
    fn elevations_add_up(c in curve::<2>(ANY), r in 0_usize..3, s in 0_usize..3) {
        prop_assert_eq!(c.elevated(r)?.elevated(s)?, c.elevated(r + s)?);
    }

    #[test]
    fn an_elevated_coefficient_is_the_mean_over_the_arguments_left_out(
        f in function(ANY.of_degree(0, 5)),
        raise in 1_usize..4,
    ) {
        let raised = f.elevated(raise)?;
        let (n, t) = (raised.degree(), raised.space().knots());
        let (a, b) = f.domain();
        let one = Function::constant(SplineSpace::bezier(raise, a.clone(), b.clone())?, Q::int(1))?;
        for k in raised.space().spans() {
            for j in k - n..=k {
                let mean = oracle::product_coefficient(&f, &one, &t[j + 1..=j + n], (&t[k], &t[k + 1]));
                prop_assert_eq!(&raised.coeffs()[raised.space().slot(j)], &mean);
            }
        }
    }

    #[test]
    fn elevation_commutes_with_insertion(f in function(ANY), places in indices(3), raise in 0_usize..3) {
        let knots = insertable(f.space(), &places);
        let (one, other) = (f.inserted(&knots)?.elevated(raise)?, f.elevated(raise)?.inserted(&knots)?);
        prop_assert!(one.same_function(&other)?);
        prop_assert_eq!(other.embedded(one.space())?, one);
    }

    #[test]
    fn derivative_commutes_with_elevation(f in function(SMOOTH.of_degree(1, 10)), raise in 0_usize..4) {
        prop_assert_eq!(f.elevated(raise)?.derivative()?, f.derivative()?.elevated(raise)?);
    }

    #[test]
    fn elevation_commutes_with_clamping(f in function(ANY), raise in 0_usize..4) {
        prop_assert_eq!(f.elevated(raise)?.clamped_ends()?, f.clamped_ends()?.elevated(raise)?);
    }
}
