//! Laws of the products of surfaces.

use super::{SIDE, SMALL, outer};
use crate::strategies::{
    Kind, OPEN, RING, cases, field, fields, functions, probe_pairs, surface, surface_and_field, surfaces,
};
use nalgebra::vector;
use proptest::prelude::*;
use symspline::{Direction, Q, Scalar};

/// Spaces for products of three coordinates.
const TINY: Kind = SIDE.few(1).of_degree(0, 2);
const OPEN_TINY: Kind = OPEN.few(1).of_degree(0, 2);
const HIGH: Kind = SIDE.few(1).of_degree(5, 10);

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn products_are_pointwise([f, g] in fields([SMALL; 2], [SMALL; 2])) {
        let product = f.times(&g)?;
        prop_assert_eq!(product.u(), &f.u().product_space(g.u())?);
        prop_assert_eq!(product.v(), &f.v().product_space(g.v())?);
        for (u, v) in probe_pairs(&product) {
            prop_assert_eq!(product.at(&u, &v)?, f.at(&u, &v)? * g.at(&u, &v)?);
        }
        prop_assert_eq!(&g * &f, product);
    }

    #[test]
    fn rings_times_rings_are_rings(
        [f, g] in fields([RING.few(1).of_degree(0, 3), OPEN_TINY], [RING.few(2).of_degree(0, 2), TINY]),
    ) {
        let product = &f * &g;
        prop_assert!(product.u().is_periodic() && !product.v().is_periodic());
        prop_assert_eq!(&f.transposed() * &g.transposed(), product.transposed());
        for (u, v) in probe_pairs(&product) {
            prop_assert_eq!(product.at(&u, &v)?, f.at(&u, &v)? * g.at(&u, &v)?);
        }
    }

    #[test]
    fn products_of_separate_functions_are_separate(
        [f, g] in functions(SIDE.of_degree(0, 5), SIDE.of_degree(0, 4)),
        [h, k] in functions(SMALL, SMALL),
    ) {
        prop_assert_eq!(&outer(&f, &h)? * &outer(&g, &k)?, outer(&(&f * &g), &(&h * &k))?);
    }

    #[test]
    fn products_of_transposed_are_transposed([f, g] in fields([SMALL, TINY], [TINY, SMALL])) {
        prop_assert_eq!(&f.transposed() * &g.transposed(), (&f * &g).transposed());
    }

    #[test]
    fn products_distribute([f, g] in fields([TINY; 2], [TINY; 2])) {
        let square = (&f + &g).times(&(&f + &g))?;
        let twice = f.times(&g)?.scaled(&Q::int(2))?;
        prop_assert!(square.same_function(&(&(&f * &f + twice) + &(&g * &g)))?);
    }

    #[test]
    fn one_is_neutral(f in field(SMALL, SMALL)) {
        let one = |space: &symspline::SplineSpace<Q>| {
            let (a, b) = space.domain();
            symspline::Function::monomial(0, a.clone(), b.clone())
        };
        prop_assert!(f.times(&outer(&one(f.u())?, &one(f.v())?)?)?.same_function(&f)?);
    }

    #[test]
    fn a_scaled_surface_is_scaled_in_each_coordinate(
        (s, f) in surface_and_field::<3>([TINY; 2], [SMALL; 2]),
    ) {
        let product = &f * &s;
        for axis in 0..3 {
            prop_assert_eq!(product.coordinate(axis)?, &f * &s.coordinate(axis)?);
        }
        prop_assert_eq!(s.times(&f)?, product);
    }

    #[test]
    fn dot_products_are_pointwise([s, t] in surfaces::<3>([TINY, SMALL], [SMALL, TINY])) {
        let product = s.dot(&t)?;
        for (u, v) in probe_pairs(&product) {
            prop_assert_eq!(product.at(&u, &v)?, s.at(&u, &v)?.dot(&t.at(&u, &v)?));
        }
        prop_assert_eq!(t.dot(&s)?, product);
    }

    #[test]
    fn cross_products_in_the_plane_are_determinants([s, t] in surfaces::<2>([TINY; 2], [TINY; 2])) {
        let [x, y, z, w] = [s.coordinate(0)?, s.coordinate(1)?, t.coordinate(0)?, t.coordinate(1)?];
        prop_assert_eq!(s.cross(&t)?, &(&x * &w) - &(&y * &z));
        prop_assert_eq!(s.cross(&t)?, -&t.cross(&s)?);
    }

    #[test]
    fn cross_products_in_space_are_pointwise([s, t] in surfaces::<3>([TINY; 2], [TINY; 2])) {
        let product = s.cross(&t)?;
        for (u, v) in probe_pairs(&product) {
            let [x, y] = [s.at(&u, &v)?, t.at(&u, &v)?];
            let minor = |i: usize, j: usize| x[i].clone() * &y[j] - x[j].clone() * &y[i];
            prop_assert_eq!(product.at(&u, &v)?, vector![minor(1, 2), minor(2, 0), minor(0, 1)]);
        }
        prop_assert_eq!(-&t.cross(&s)?, product);
    }

    #[test]
    fn any_pairing_multiplies(s in surface::<2>(TINY, TINY), t in surface::<3>(TINY, TINY)) {
        // On one domain, so that they can be paired.
        let t = t.along(Direction::U, |rows| rows.reparametrised(s.u().domain().0, s.u().domain().1))?;
        let t = t.along(Direction::V, |rows| rows.reparametrised(s.v().domain().0, s.v().domain().1))?;
        let pairs = s.product_by(&t, |c, d| vector![c[0].clone() * &d[2], c[1].clone() * &d[0]])?;
        for (u, v) in probe_pairs(&pairs) {
            let [x, y] = [s.at(&u, &v)?.as_slice().to_vec(), t.at(&u, &v)?.as_slice().to_vec()];
            prop_assert_eq!(pairs.at(&u, &v)?, vector![x[0].clone() * &y[2], x[1].clone() * &y[0]]);
        }
    }
}

proptest! {
    #![proptest_config(cases(6))]

    #[test]
    fn high_degrees_multiply_pointwise(
        [f, g] in fields([HIGH, SMALL.few(1)], [HIGH, SMALL.few(1)]),
    ) {
        let product = f.times(&g)?;
        for (u, v) in probe_pairs(&product) {
            prop_assert_eq!(product.at(&u, &v)?, f.at(&u, &v)? * g.at(&u, &v)?);
        }
    }
}
