//! Laws of sums, differences and multiples.

use crate::oracle::{self, Side};
use crate::strategies::{
    ANY, cases, curves, function, functions, indices, insertable, number, point, probes, three_functions,
};
use proptest::prelude::*;
use symspline::{Q, Scalar};

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn sums_are_pointwise_on_both_sides([f, g] in functions(ANY, ANY), s in number()) {
        let (sum, difference, mixed) = (f.sum(&g)?, f.difference(&g)?, f.plus_scaled(&s, &g)?);
        let start = f.domain().0;
        for x in probes(sum.space()) {
            for side in [Side::Left, Side::Right] {
                // At the start a ring has a left limit of its own, an open spline has not.
                if x == *start && side == Side::Left && !sum.space().is_periodic() {
                    continue;
                }
                let [u, v] = [&f, &g].map(|h| oracle::value(h, &x, side));
                prop_assert_eq!(oracle::value(&sum, &x, side), u.clone() + &v);
                prop_assert_eq!(oracle::value(&difference, &x, side), u.clone() - &v);
                prop_assert_eq!(oracle::value(&mixed, &x, side), u + s.clone() * &v);
            }
        }
    }

    #[test]
    fn sums_commute_and_associate([f, g, h] in three_functions(ANY)) {
        prop_assert_eq!(&f + &g, &g + &f);
        let [one, other] = [&(&f + &g) + &h, &f + &(&g + &h)];
        prop_assert!(one.same_function(&other)?);
        // Knots outside the domain that differ may be the same after an elevation, and then they are kept.
        if f.degree() == g.degree() && g.degree() == h.degree() {
            prop_assert_eq!(one, other);
        }
    }

    #[test]
    fn sums_of_curves_are_those_of_their_coordinates([c, d] in curves::<2>(ANY, ANY)) {
        for axis in 0..2 {
            prop_assert_eq!((&c + &d).coordinate(axis)?, &c.coordinate(axis)? + &d.coordinate(axis)?);
        }
    }

    #[test]
    fn differences_undo_sums([f, g] in functions(ANY, ANY)) {
        prop_assert!((&(&f + &g) - &g).same_function(&f)?);
        prop_assert!((&f - &f).coeffs().iter().all(|c| *c == Q::int(0)));
        prop_assert_eq!(&f - &g, &f + &-&g);
    }

    #[test]
    fn multiples_distribute([f, g] in functions(ANY, ANY), r in number(), s in number()) {
        prop_assert_eq!(&(&f + &g) * r.clone(), &(&f * r.clone()) + &(&g * r.clone()));
        prop_assert_eq!(&f * (r.clone() + &s), &(&f * r.clone()) + &(&f * s.clone()));
        prop_assert_eq!(&(&f * r.clone()) * s.clone(), &f * (r * &s));
        prop_assert_eq!(&f * Q::int(-1), -&f);
        prop_assert_eq!(&f * Q::int(1), f);
    }

    #[test]
    fn translation_adds_a_constant([c, d] in curves::<2>(ANY, ANY), by in point::<2>()) {
        let moved = c.translated(&by)?;
        for x in probes(c.space()) {
            prop_assert_eq!(moved.at(&x)?, c.at(&x)? + &by);
        }
        prop_assert_eq!(&moved + &d, (&c + &d).translated(&by)?);
    }

    #[test]
    fn the_same_function_in_finer_spaces(f in function(ANY), places in indices(4), raise in 0_usize..3) {
        let finer = f.elevated(raise)?.inserted(&insertable(f.space(), &places))?;
        prop_assert!(f.same_function(&finer)? && finer.same_function(&f)?);
    }

    #[test]
    fn another_coefficient_is_another_function(
        f in function(ANY),
        at in any::<prop::sample::Index>(),
        by in number(),
    ) {
        let mut coeffs = f.coeffs().to_vec();
        let i = at.index(coeffs.len());
        coeffs[i] += &by;
        let other = symspline::Function::new(f.space().clone(), coeffs)?;
        prop_assert_eq!(f.same_function(&other)?, by == Q::int(0));
    }

    #[test]
    fn the_same_function_has_the_same_values([f, g] in functions(ANY.of_degree(0, 2), ANY.of_degree(0, 2))) {
        let union = f.space().union(g.space())?;
        // Three points in each span tell polynomials of degree 2 apart.
        let points = probes(&union.bisected()?);
        let agree = |x: &Q, side: Side| oracle::value(&f, x, side) == oracle::value(&g, x, side);
        let start = union.domain().0;
        let equal = points.iter().all(|x| agree(x, Side::Right) && (x == start || agree(x, Side::Left)));
        prop_assert_eq!(f.same_function(&g)?, equal);
    }
}
