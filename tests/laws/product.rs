//! Laws of products.

use crate::oracle::{self, Side};
use crate::strategies::{
    ANY, Kind, OPEN, RING, cases, curve_and_function, curves, function, functions, number, probes,
    three_functions,
};
use nalgebra::vector;
use proptest::prelude::*;
use symspline::{Function, Q, Scalar, SplineSpace};

/// Degrees small enough for the definition, which deals `p + q` arguments in all ways.
const SMALL: Kind = ANY.of_degree(0, 4);

/// The product and its definition agree on every span under every coefficient.
fn is_the_mean_of_polar_products(f: &Function<Q>, g: &Function<Q>) -> Result<(), TestCaseError> {
    let product = f.times(g)?;
    let (n, t) = (product.degree(), product.space().knots());
    for k in product.space().spans() {
        for j in k - n..=k {
            let mean = oracle::product_coefficient(f, g, &t[j + 1..=j + n], (&t[k], &t[k + 1]));
            prop_assert_eq!(&product.coeffs()[product.space().slot(j)], &mean);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn products_are_pointwise_on_both_sides([f, g] in functions(ANY, ANY)) {
        let product = f.times(&g)?;
        let (a, b) = f.domain();
        for x in probes(product.space()) {
            for side in [Side::Left, Side::Right] {
                // At the start the left limit is the far end's, but in open spaces.
                if (x == *a || x == *b) && side == Side::Left && !product.space().is_periodic() {
                    continue;
                }
                let expected = oracle::value(&f, &x, side) * oracle::value(&g, &x, side);
                prop_assert_eq!(oracle::value(&product, &x, side), expected);
            }
        }
        prop_assert_eq!(product.at(b)?, f.at(b)? * g.at(b)?);
    }

    #[test]
    fn a_coefficient_is_the_mean_of_products_of_polar_values([f, g] in functions(SMALL, SMALL)) {
        is_the_mean_of_polar_products(&f, &g)?;
    }

    #[test]
    fn a_coefficient_on_a_ring_is_the_mean_too(
        [f, g] in functions(RING.of_degree(0, 3), RING.of_degree(0, 3)),
    ) {
        is_the_mean_of_polar_products(&f, &g)?;
    }

    #[test]
    fn the_product_is_a_bilinear_map([f, g] in functions(SMALL, SMALL)) {
        let (product, map) = (f.times(&g)?, f.space().multiplication(g.space())?);
        prop_assert_eq!(map.source_dims(), (f.space().dim(), g.space().dim()));
        prop_assert_eq!(&map.apply(f.coeffs(), g.coeffs())?, &product.coeffs());
        prop_assert_eq!(&map.fix_left(f.coeffs())?.apply(g.coeffs())?, &product.coeffs());
        prop_assert_eq!(map.swapped().apply(g.coeffs(), f.coeffs())?, product.coeffs());
    }

    #[test]
    fn products_commute_and_associate([f, g, h] in three_functions(ANY.of_degree(0, 3))) {
        prop_assert_eq!(&f * &g, &g * &f);
        prop_assert_eq!(&(&f * &g) * &h, &f * &(&g * &h));
    }

    #[test]
    fn products_distribute([f, g, h] in three_functions(ANY.of_degree(0, 4)), s in number()) {
        prop_assert!((&f * &(&g + &h)).same_function(&(&(&f * &g) + &(&f * &h)))?);
        prop_assert_eq!(&f * &(&g * s.clone()), &(&f * &g) * s);
    }

    #[test]
    fn the_product_with_one_is_the_embedding(f in function(ANY), q in 0_usize..4, level in number()) {
        let (a, b) = f.domain();
        let one = Function::constant(SplineSpace::bezier(q, a.clone(), b.clone())?, level.clone())?;
        prop_assert_eq!(f.times(&one)?, &f.clamped_ends()?.elevated(q)? * level);
    }

    #[test]
    fn the_product_with_one_on_a_ring_stays_there(f in function(RING), q in 0_usize..3) {
        let (a, b) = f.domain();
        // One knot: the seam, as rough as may be or as smooth as may be.
        for seam in [1, q + 1] {
            let ring = SplineSpace::periodic(q, vec![a.clone(); seam], b.clone() - a)?;
            let product = f.times(&Function::constant(ring, Q::int(1))?)?;
            prop_assert!(product.space().is_periodic());
            prop_assert!(product.same_function(&f)?);
        }
    }

    #[test]
    fn a_ring_and_an_open_spline_give_an_open_one(
        [f, g] in functions(RING.of_degree(0, 5), OPEN.of_degree(0, 5)),
    ) {
        let product = f.times(&g)?;
        prop_assert!(product.space().is_clamped());
        prop_assert_eq!(&product, &f.clamped_ends()?.times(&g)?);
        prop_assert_eq!(product, &g * &f);
    }

    #[test]
    fn opening_a_product_of_rings_is_the_product_opened(
        [f, g] in functions(RING.of_degree(0, 5), RING.of_degree(0, 5)),
    ) {
        let product = f.times(&g)?;
        prop_assert!(product.space().is_periodic());
        prop_assert!(product.same_function(&f.clamped_ends()?.times(&g.clamped_ends()?)?)?);
    }

    #[test]
    fn powers_multiply(a in number(), length in 1_i64..9, m in 0_usize..5, n in 0_usize..5) {
        let b = a.clone() + Q::int(length);
        let power = |k: usize| Function::monomial(k, a.clone(), b.clone());
        prop_assert_eq!(power(m)?.times(&power(n)?)?, power(m + n)?);
    }

    #[test]
    fn a_scaled_curve_is_scaled_in_each_coordinate((c, f) in curve_and_function::<3>(SMALL, SMALL)) {
        let product = &f * &c;
        for axis in 0..3 {
            prop_assert_eq!(product.coordinate(axis)?, &f * &c.coordinate(axis)?);
        }
        prop_assert_eq!(c.times(&f)?, product);
    }

    #[test]
    fn dot_products_sum_over_the_coordinates([c, d] in curves::<3>(SMALL, SMALL)) {
        let term = |axis: usize| Ok::<_, symspline::Error>(&c.coordinate(axis)? * &d.coordinate(axis)?);
        prop_assert_eq!(c.dot(&d)?, &(&term(0)? + &term(1)?) + &term(2)?);
        prop_assert_eq!(c.dot(&d)?, d.dot(&c)?);
    }

    #[test]
    fn cross_products_in_the_plane_are_determinants([c, d] in curves::<2>(SMALL, SMALL)) {
        let [x, y, u, v] = [c.coordinate(0)?, c.coordinate(1)?, d.coordinate(0)?, d.coordinate(1)?];
        prop_assert_eq!(c.cross(&d)?, &(&x * &v) - &(&y * &u));
        prop_assert_eq!(c.cross(&d)?, -&d.cross(&c)?);
        prop_assert!(c.cross(&c)?.coeffs().iter().all(|s| *s == Q::int(0)));
    }

    #[test]
    fn cross_products_in_space_are_across_both(
        [c, d] in curves::<3>(ANY.of_degree(0, 2), ANY.of_degree(0, 2)),
    ) {
        let normal = c.cross(&d)?;
        for factor in [&c, &d] {
            prop_assert!(normal.dot(factor)?.coeffs().iter().all(|s| *s == Q::int(0)));
        }
        for x in probes(normal.space()) {
            let [u, v] = [c.at(&x)?, d.at(&x)?];
            let minor = |i: usize, j: usize| u[i].clone() * &v[j] - u[j].clone() * &v[i];
            prop_assert_eq!(normal.at(&x)?, vector![minor(1, 2), minor(2, 0), minor(0, 1)]);
        }
    }
}

proptest! {
    #![proptest_config(cases(6))]

    #[test]
    fn high_degrees_multiply_pointwise([f, g] in functions(ANY.of_degree(6, 10), ANY.of_degree(6, 10))) {
        let product = f.times(&g)?;
        for x in probes(product.space()) {
            prop_assert_eq!(product.at(&x)?, f.at(&x)? * g.at(&x)?);
        }
        prop_assert_eq!(g.times(&f)?, product);
    }
}
