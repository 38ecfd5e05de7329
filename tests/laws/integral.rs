//! Laws of antiderivatives, integrals and moments.

use crate::oracle;
use crate::strategies::{ANY, OPEN, RING, SMOOTH, cases, curve, function, functions, number, probes};
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{Error, Function, Q, Scalar};

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn integrals_are_those_of_the_powers(f in function(ANY), places in (any::<Index>(), any::<Index>())) {
        let probes = probes(f.space());
        let (x, y) = (places.0.get(&probes), places.1.get(&probes));
        let (sign, low, high) = if x <= y { (1, x, y) } else { (-1, y, x) };
        let ordered = oracle::powers(&f).iter().map(|piece| piece.moment(0, low, high)).sum::<Q>();
        prop_assert_eq!(f.integral_between(x, y)?, Q::int(sign) * ordered);
    }

    #[test]
    fn moments_are_those_of_the_powers(f in function(ANY.of_degree(0, 5)), power in 0_usize..5) {
        let (a, b) = f.domain();
        let expected = oracle::powers(&f).iter().map(|piece| piece.moment(power, a, b)).sum::<Q>();
        prop_assert_eq!(&f.moment(power)?, &expected);
        prop_assert_eq!(f.space().moment(power)?.apply(f.coeffs()), expected);
    }

    #[test]
    fn integrals_add_up(f in function(ANY), places in (any::<Index>(), any::<Index>(), any::<Index>())) {
        let probes = probes(f.space());
        let [x, y, z] = [places.0, places.1, places.2].map(|place| place.get(&probes).clone());
        let way = f.integral_between(&x, &y)? + f.integral_between(&y, &z)?;
        prop_assert_eq!(way, f.integral_between(&x, &z)?);
        prop_assert_eq!(f.integral_between(&x, &x)?, Q::int(0));
        prop_assert_eq!(f.space().integral_between(&x, &z)?.apply(f.coeffs()), f.integral_between(&x, &z)?);
        let (a, b) = f.domain();
        prop_assert_eq!(f.integral()?, f.integral_between(a, b)?);
    }

    #[test]
    fn integrals_are_linear([f, g] in functions(ANY, ANY), s in number()) {
        prop_assert_eq!(f.plus_scaled(&s, &g)?.integral()?, f.integral()? + s * g.integral()?);
    }

    #[test]
    fn integrals_are_differences_of_the_antiderivative(f in function(OPEN)) {
        let primitive = f.antiderivative()?;
        let (a, _) = f.domain();
        prop_assert_eq!(primitive.at(a)?, Q::int(0));
        for x in probes(f.space()) {
            prop_assert_eq!(primitive.at(&x)?, f.integral_between(a, &x)?);
        }
    }

    #[test]
    fn the_antiderivative_is_a_map(c in curve::<2>(OPEN)) {
        let primitive = c.antiderivative()?;
        prop_assert_eq!(primitive.space(), &c.space().antiderivative_space()?);
        prop_assert_eq!(c.space().antidifferentiation()?.apply(c.coeffs())?, primitive.coeffs());
    }

    #[test]
    fn integration_by_parts([f, g] in functions(SMOOTH.of_degree(0, 4), SMOOTH.of_degree(0, 4))) {
        let (a, b) = f.domain();
        let whole = f.derivative()?.inner(&g)? + f.inner(&g.derivative()?)?;
        let ends = oracle::value(&f, b, oracle::Side::Left) * oracle::value(&g, b, oracle::Side::Left)
            - f.at(a)? * g.at(a)?;
        prop_assert_eq!(whole, ends);
    }

    #[test]
    fn a_ring_without_mean_has_an_antiderivative_of_its_own(f in function(RING)) {
        let (a, b) = f.domain();
        let mean = f.integral()? / (b.clone() - a);
        let level = f.translated(&-mean)?;
        let primitive = level.antiderivative()?;
        prop_assert!(primitive.space().is_periodic());
        prop_assert_eq!(primitive.at(a)?, Q::int(0));
        prop_assert_eq!(&primitive.derivative()?, &level);
        let opened = level.clamped_ends()?.antiderivative()?;
        prop_assert!(opened.same_function(&primitive)?);
    }

    #[test]
    fn a_ring_with_a_mean_has_none(f in function(RING)) {
        let integral = f.integral()?;
        let expected = (integral != Q::int(0)).then(|| Error::NonZeroMean { integral: integral.to_string() });
        prop_assert_eq!(f.antiderivative().err(), expected);
        prop_assert_eq!(f.space().antidifferentiation().err(), Some(Error::NotPeriodic));
    }

    #[test]
    fn opened_rings_have_the_integrals_of_the_ring(f in function(RING)) {
        prop_assert_eq!(f.clamped_ends()?.integral()?, f.integral()?);
        prop_assert_eq!(f.unclamped_ends()?.integral()?, f.integral()?);
        let (unclamped, clamped) = (f.unclamped_ends()?, f.clamped_ends()?);
        prop_assert!(unclamped.antiderivative()?.same_function(&clamped.antiderivative()?)?);
    }

    #[test]
    fn monomials_are_powers(power in 0_usize..7, a in number(), length in 1_i64..5, s in 0_i64..=4) {
        let b = a.clone() + Q::int(length);
        let x = a.clone() + Q::int(length) * Q::frac(s, 4);
        let f = Function::monomial(power, a, b)?;
        prop_assert_eq!(f.at(&x)?, oracle::raised(&x, power));
    }
}
