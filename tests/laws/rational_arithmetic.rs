//! Laws of the arithmetic of rational functions and curves: a field, but for zeros of divisors.

use crate::rational_strategies::{
    dividend_and_divisor, nurbs, rational, rationals, three_rationals, two_nurbs,
};
use crate::strategies::{ANY, Kind, SMOOTH, cases, number, point, probes};
use nalgebra::vector;
use proptest::prelude::*;
use symspline::{Coeff, Error, Function, NurbsCurve, Q, RationalFunction, Scalar};

/// Degrees at which products stay short.
const LOW: Kind = ANY.of_degree(0, 3);

/// The constant one on the domain of `f`.
fn one(f: &RationalFunction<Q>) -> symspline::Result<RationalFunction<Q>> {
    let (a, b) = f.domain();
    RationalFunction::from_polynomial(&Function::monomial(0, a.clone(), b.clone())?)
}

/// The probes of both.
fn places(f: &RationalFunction<Q>, g: &RationalFunction<Q>) -> Vec<Q> {
    probes(f.space()).into_iter().chain(probes(g.space())).collect()
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn sums_are_pointwise([f, g] in rationals(LOW), s in number()) {
        let (sum, difference, combination) = (f.sum(&g)?, f.difference(&g)?, f.plus_scaled(&s, &g)?);
        for x in places(&f, &g) {
            let (y, z) = (f.at(&x)?, g.at(&x)?);
            prop_assert_eq!(sum.at(&x)?, y.clone() + &z);
            prop_assert_eq!(difference.at(&x)?, y.clone() - &z);
            prop_assert_eq!(combination.at(&x)?, y + s.clone() * z);
        }
        prop_assert_eq!(&f + &g, sum);
        prop_assert_eq!(&f - &g, difference);
    }

    #[test]
    fn sums_over_one_denominator_keep_it(f in rational(LOW), s in number()) {
        let double = f.plus_scaled(&s, &f)?;
        prop_assert_eq!(double.denominator()?, f.denominator()?);
        prop_assert_eq!(double, f.scaled(&(s + Q::int(1)))?);
        prop_assert_eq!(f.difference(&f)?, f.scaled(&Q::int(0))?);
        prop_assert_eq!(-&f, &f * Q::int(-1));
    }

    #[test]
    fn products_are_pointwise([f, g] in rationals(LOW)) {
        let product = f.times(&g)?;
        for x in places(&f, &g) {
            prop_assert_eq!(product.at(&x)?, f.at(&x)? * g.at(&x)?);
        }
    }

    #[test]
    fn quotients_are_pointwise([f, g] in dividend_and_divisor(LOW)) {
        let quotient = f.divided(&g)?;
        for x in places(&f, &g) {
            prop_assert_eq!(quotient.at(&x)?, f.at(&x)? / g.at(&x)?);
        }
    }

    #[test]
    fn multiples_and_translations_are_pointwise(f in nurbs::<3>(LOW), s in number(), by in point::<3>()) {
        let (scaled, moved) = (f.scaled(&s)?, f.translated(&by)?);
        prop_assert_eq!(&moved.denominator()?, &f.denominator()?);
        for x in probes(f.space()) {
            let y = f.at(&x)?;
            prop_assert_eq!(scaled.at(&x)?, y.scaled(&s));
            prop_assert_eq!(moved.at(&x)?, y + &by);
        }
        if let Ok(points) = f.points() {
            prop_assert_eq!(moved.points()?, points.iter().map(|c| c + &by).collect::<Vec<_>>());
        }
    }

    #[test]
    fn dot_and_cross_are_pointwise_in_space([f, g] in two_nurbs::<3>(LOW)) {
        let (dot, cross) = (f.dot(&g)?, f.cross(&g)?);
        for x in probes(f.space()).iter().chain(&probes(g.space())) {
            let (c, d) = (f.at(x)?, g.at(x)?);
            prop_assert_eq!(dot.at(x)?, Q::dot(c.iter().zip(d.iter())));
            let minor = |i: usize, j: usize| c[i].clone() * &d[j] - c[j].clone() * &d[i];
            prop_assert_eq!(cross.at(x)?, vector![minor(1, 2), minor(2, 0), minor(0, 1)]);
        }
    }

    #[test]
    fn cross_is_the_determinant_in_the_plane([f, g] in two_nurbs::<2>(LOW)) {
        let cross = f.cross(&g)?;
        for x in probes(f.space()).iter().chain(&probes(g.space())) {
            let (c, d) = (f.at(x)?, g.at(x)?);
            prop_assert_eq!(cross.at(x)?, c[0].clone() * &d[1] - c[1].clone() * &d[0]);
        }
        prop_assert!(f.cross(&f)?.same_function(&f.dot(&f)?.scaled(&Q::int(0))?)?);
    }

    #[test]
    fn a_product_with_a_curve_is_one_in_each_coordinate([f, g] in two_nurbs::<3>(LOW)) {
        let factor = g.coordinate(2)?;
        let product = f.times(&factor)?;
        for axis in 0..3 {
            prop_assert_eq!(product.coordinate(axis)?, f.coordinate(axis)?.times(&factor)?);
            prop_assert_eq!(f.coordinate(axis)?.weights().count(), f.weights().count());
        }
        prop_assert_eq!(f.coordinate(3).unwrap_err(), Error::IndexOutOfRange { index: 3, length: 3 });
    }
}

proptest! {
    #![proptest_config(cases(20))]

    #[test]
    fn the_product_with_the_divisor_is_the_dividend([f, g] in dividend_and_divisor(ANY.of_degree(0, 2))) {
        prop_assert!(f.divided(&g)?.times(&g)?.same_function(&f)?);
        prop_assert!(f.times(&g)?.divided(&g)?.same_function(&f)?);
        prop_assert!(g.divided(&g)?.same_function(&one(&g)?)?);
        prop_assert!(one(&g)?.divided(&one(&g)?.divided(&g)?)?.same_function(&g)?);
    }

    #[test]
    fn sums_and_products_commute([f, g] in rationals(LOW)) {
        prop_assert!(f.sum(&g)?.same_function(&g.sum(&f)?)?);
        prop_assert!(f.times(&g)?.same_function(&g.times(&f)?)?);
    }

    #[test]
    fn products_distribute_and_associate([f, g, h] in three_rationals(ANY.of_degree(0, 2))) {
        let sum = f.times(&g)?.sum(&f.times(&h)?)?;
        prop_assert!(f.times(&g.sum(&h)?)?.same_function(&sum)?);
        prop_assert!(f.times(&g)?.times(&h)?.same_function(&f.times(&g.times(&h)?)?)?);
        prop_assert!(f.sum(&g)?.sum(&h)?.same_function(&f.sum(&g.sum(&h)?)?)?);
        prop_assert!(f.sum(&g)?.difference(&g)?.same_function(&f)?);
    }

    #[test]
    fn other_functions_are_told_apart([f, g] in rationals(LOW)) {
        let differ = |x: &Q| Ok::<_, Error>(f.at(x)? != g.at(x)?);
        let apart = places(&f, &g).iter().map(differ).collect::<Result<Vec<_>, _>>()?;
        prop_assert!(!(apart.contains(&true) && f.same_function(&g)?));
        prop_assert!(!f.same_function(&f.sum(&one(&f)?)?)?);
    }

    #[test]
    fn derivatives_of_products_follow_leibniz(
        f in rational(SMOOTH.of_degree(0, 2)), s in number(),
    ) {
        // f and a relative of it on the same knots.
        let g = f.plus_scaled(&s, &one(&f)?)?.divided(&one(&f)?.sum(&f.times(&f)?)?)?;
        let product = f.times(&g)?;
        for x in probes(f.space()) {
            let (y, z, p) = (f.derivatives_at(&x, 2)?, g.derivatives_at(&x, 2)?, product.derivatives_at(&x, 2)?);
            prop_assert_eq!(&p[1], &(y[0].clone() * &z[1] + y[1].clone() * &z[0]));
            let mixed = Q::int(2) * &y[1] * &z[1];
            prop_assert_eq!(&p[2], &(y[0].clone() * &z[2] + mixed + y[2].clone() * &z[0]));
        }
    }
}

proptest! {
    #![proptest_config(cases(8))]

    #[test]
    fn the_derivative_of_a_product_follows_leibniz_as_a_function(f in rational(SMOOTH.of_degree(1, 1)), s in number()) {
        let g = f.translated(&s)?;
        let both = f.derivative()?.times(&g)?.sum(&f.times(&g.derivative()?)?)?;
        prop_assert!(f.times(&g)?.derivative()?.same_function(&both)?);
    }
}

#[test]
fn domains_must_agree() {
    let line = |b: i64| RationalFunction::from_polynomial(&Function::monomial(1, Q::int(0), Q::int(b))?);
    let (f, g) = (line(1).unwrap(), line(2).unwrap());
    assert!(matches!(f.sum(&g), Err(Error::DomainMismatch { .. })));
    assert!(matches!(f.times(&g), Err(Error::DomainMismatch { .. })));
    assert!(matches!(f.same_function(&g), Err(Error::DomainMismatch { .. })));
    let (top, bottom) = (f.numerator().unwrap(), g.denominator().unwrap());
    assert!(matches!(RationalFunction::from_quotient(&top, &bottom), Err(Error::DomainMismatch { .. })));
}

#[test]
fn dividing_by_zero_is_refused() {
    let f = RationalFunction::from_polynomial(&Function::monomial(1, Q::int(1), Q::int(2)).unwrap()).unwrap();
    let zero = f.difference(&f).unwrap();
    assert_eq!(f.divided(&zero).unwrap_err(), Error::Pole);
    let point: NurbsCurve<Q, 2> = f.product_by(&f, |a, b| vector![a.clone() * b, b.clone()]).unwrap();
    assert_eq!(point.divided(&zero).unwrap_err(), Error::Pole);
}
