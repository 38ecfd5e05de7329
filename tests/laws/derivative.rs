//! Laws of the derivative.

use crate::oracle::{self, Side};
use crate::strategies::{
    ANY, OPEN, SMOOTH, cases, curve, curve_and_function, curves, function, functions, number, probes, space,
};
use proptest::prelude::*;
use symspline::{Error, Q, Scalar};

/// Degrees small enough for products, and at least 1, where a derivative lowers the degree.
const FACTOR: crate::strategies::Kind = SMOOTH.of_degree(1, 4);

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn the_derivative_is_that_of_the_powers(f in function(SMOOTH)) {
        let derivative = f.derivative()?;
        for piece in oracle::powers(&f) {
            for x in [&piece.a, &((piece.a.clone() + &piece.b) / Q::int(2))] {
                let term = |(i, c): (usize, &Q)| match i {
                    0 => Q::int(0),
                    i => c.clone() * Q::int(i as i64) * oracle::raised(x, i - 1),
                };
                prop_assert_eq!(derivative.at(x)?, piece.coeffs.iter().enumerate().map(term).sum::<Q>());
            }
        }
    }

    #[test]
    fn the_derivative_is_a_map(c in curve::<3>(SMOOTH)) {
        let derivative = c.derivative()?;
        prop_assert_eq!(derivative.space(), &c.space().derivative_space()?);
        prop_assert_eq!(c.space().differentiation()?.apply(c.coeffs())?, derivative.coeffs());
        prop_assert_eq!(derivative.space().is_periodic(), c.space().is_periodic());
    }

    #[test]
    fn the_derivative_is_linear([f, g] in functions(SMOOTH, SMOOTH), s in number()) {
        let sum = f.plus_scaled(&s, &g)?.derivative()?;
        prop_assert!(sum.same_function(&f.derivative()?.plus_scaled(&s, &g.derivative()?)?)?);
    }

    #[test]
    fn leibniz([f, g] in functions(FACTOR, FACTOR)) {
        let (df, dg) = (f.derivative()?, g.derivative()?);
        prop_assert_eq!((&f * &g).derivative()?, &(&df * &g) + &(&f * &dg));
    }

    #[test]
    fn leibniz_of_any_degree([f, g] in functions(SMOOTH.of_degree(0, 3), SMOOTH.of_degree(0, 3))) {
        let (df, dg) = (f.derivative()?, g.derivative()?);
        prop_assert!((&f * &g).derivative()?.same_function(&(&(&df * &g) + &(&f * &dg)))?);
    }

    #[test]
    fn leibniz_of_a_curve_and_a_factor((c, f) in curve_and_function::<2>(FACTOR, FACTOR)) {
        let (dc, df) = (c.derivative()?, f.derivative()?);
        prop_assert_eq!((&f * &c).derivative()?, &(&df * &c) + &(&f * &dc));
    }

    #[test]
    fn leibniz_of_dot_products([c, d] in curves::<3>(FACTOR, FACTOR)) {
        let (dc, dd) = (c.derivative()?, d.derivative()?);
        prop_assert_eq!(c.dot(&d)?.derivative()?, &dc.dot(&d)? + &c.dot(&dd)?);
    }

    #[test]
    fn leibniz_of_cross_products_in_the_plane([c, d] in curves::<2>(FACTOR, FACTOR)) {
        let (dc, dd) = (c.derivative()?, d.derivative()?);
        prop_assert_eq!(c.cross(&d)?.derivative()?, &dc.cross(&d)? + &c.cross(&dd)?);
    }

    #[test]
    fn leibniz_of_cross_products_in_space([c, d] in curves::<3>(FACTOR, FACTOR)) {
        let (dc, dd) = (c.derivative()?, d.derivative()?);
        prop_assert_eq!(c.cross(&d)?.derivative()?, &dc.cross(&d)? + &c.cross(&dd)?);
    }

    #[test]
    fn derivative_undoes_antiderivative(f in function(OPEN)) {
        prop_assert_eq!(f.antiderivative()?.derivative()?, f);
    }

    #[test]
    fn antiderivative_undoes_derivative_but_for_the_start(f in function(SMOOTH)) {
        // In a ring the derivative has mean zero, so that this holds there too.
        let start = f.at(f.domain().0)?;
        prop_assert!(f.derivative()?.antiderivative()?.translated(&start)?.same_function(&f)?);
    }

    #[test]
    fn derivatives_follow_one_another(f in function(ANY.smooth(3))) {
        let chain = f.derivative()?.derivative()?.derivative()?;
        prop_assert_eq!(&f.nth_derivative(3)?, &chain);
        prop_assert_eq!(&f.nth_derivative(0)?, &f);
        for x in probes(f.space()) {
            prop_assert_eq!(f.derivative_at(&x, 3)?, chain.at(&x)?);
        }
    }

    #[test]
    fn derivatives_beyond_the_degree_vanish(f in function(OPEN.of_degree(0, 3).smooth(9))) {
        // So smooth that there is one span only.
        let last = f.nth_derivative(f.degree() + 2)?;
        prop_assert!(last.degree() == 0 && last.coeffs().iter().all(|c| *c == Q::int(0)));
    }

    #[test]
    fn jumps_have_no_derivative(space in space(ANY)) {
        let limit = space.degree() + 1;
        let breaks = space.breaks();
        let ring = space.is_periodic();
        let inside = if ring { &breaks[..breaks.len() - 1] } else { &breaks[1..breaks.len() - 1] };
        let expected = inside.iter().find(|(_, m)| *m == limit);
        let expected = expected.map(|(t, _)| Error::Discontinuous { knot: t.to_string() });
        prop_assert_eq!(&space.derivative_space().err(), &expected);
        prop_assert_eq!(space.differentiation().err(), expected);
    }

    #[test]
    fn the_derivative_has_both_limits(f in function(SMOOTH)) {
        let derivative = f.derivative()?;
        for piece in f.bezier_pieces()? {
            let (a, b) = piece.domain();
            let slope = piece.derivative()?;
            prop_assert_eq!(slope.at(a)?, derivative.at(a)?);
            prop_assert_eq!(slope.at(b)?, oracle::value(&derivative, b, Side::Left));
        }
    }
}
