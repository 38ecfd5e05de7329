//! Laws of integrals and moments over the domain.

use super::{BOTH, SIDE, across, outer};
use crate::oracle;
use crate::strategies::{OPEN, cases, field, probes};
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::Direction::{U, V};
use symspline::{Function, Q, Scalar, SplineSpace};

/// `∫ x^power N_i` between `a` and `b` for all basis functions, from their powers.
fn masses(space: &SplineSpace<Q>, power: usize, (a, b): (&Q, &Q)) -> Vec<Q> {
    let mass = |i: usize| {
        let pieces = oracle::powers(&oracle::unit(space, i));
        pieces.iter().fold(Q::int(0), |sum, piece| sum + piece.moment(power, a, b))
    };
    (0..space.dim()).map(mass).collect()
}

/// A monomial on the domain of `space`.
fn monomial(space: &SplineSpace<Q>, power: usize) -> symspline::Result<Function<Q>> {
    let (a, b) = space.domain();
    Function::monomial(power, a.clone(), b.clone())
}

/// Two parameters of a space.
fn two(space: &SplineSpace<Q>, places: &[Index; 2]) -> [Q; 2] {
    let all = probes(space);
    [places[0].get(&all).clone(), places[1].get(&all).clone()]
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn integrals_and_moments_are_those_of_the_powers(
        s in field(SIDE.of_degree(0, 4), SIDE.of_degree(0, 4)),
        (k, l) in (0_usize..4, 0_usize..4),
    ) {
        for (k, l) in [(0, 0), (k, l)] {
            let (along_u, along_v) = (masses(s.u(), k, s.u().domain()), masses(s.v(), l, s.v().domain()));
            let mut sum = Q::int(0);
            for (row, m) in s.rows().zip(&along_u) {
                row.iter().zip(&along_v).for_each(|(c, n)| sum += c.clone() * m * n);
            }
            prop_assert_eq!(s.moment(k, l)?, sum.clone());
            if (k, l) == (0, 0) {
                prop_assert_eq!(s.integral()?, sum);
            }
        }
    }

    #[test]
    fn moments_are_integrals_of_products(s in field(SIDE, SIDE), (k, l) in (0_usize..3, 0_usize..3)) {
        let weight = outer(&monomial(s.u(), k)?, &monomial(s.v(), l)?)?;
        prop_assert_eq!(s.moment(k, l)?, (&weight * &s).integral()?);
        prop_assert_eq!(s.moment(k, l)?, s.transposed().moment(l, k)?);
    }
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn fubini(s in field(SIDE, SIDE)) {
        let whole = s.integral()?;
        for direction in BOTH {
            let inner = s.contracted(direction, |rows| rows.integral())?;
            prop_assert_eq!(inner.space(), s.space(across(direction)));
            prop_assert_eq!(&inner.integral()?, &whole);
        }
    }

    #[test]
    fn the_integral_is_a_difference_at_the_corners(
        s in field(OPEN.few(2), OPEN.few(2)),
        (us, vs) in (any::<[Index; 2]>(), any::<[Index; 2]>()),
    ) {
        let both = s.antiderivative(U)?.antiderivative(V)?;
        prop_assert_eq!(&both, &s.antiderivative(V)?.antiderivative(U)?);
        let ([a, b], [c, d]) = (two(s.u(), &us), two(s.v(), &vs));
        let corners = both.at(&b, &d)? - both.at(&a, &d)? - both.at(&b, &c)? + both.at(&a, &c)?;
        prop_assert_eq!(s.integral_between((&a, &c), (&b, &d))?, corners);
    }

    #[test]
    fn integrals_add_up(
        s in field(SIDE, SIDE),
        (us, vs, x) in (any::<[Index; 2]>(), any::<[Index; 2]>(), any::<Index>()),
    ) {
        let ([a, b], [c, d]) = (two(s.u(), &us), two(s.v(), &vs));
        let (m, n) = (x.get(&probes(s.u())).clone(), x.get(&probes(s.v())).clone());
        let over = |a: &Q, b: &Q, c: &Q, d: &Q| s.integral_between((a, c), (b, d));
        let whole = over(&a, &b, &c, &d)?;
        prop_assert_eq!(&(over(&a, &m, &c, &d)? + over(&m, &b, &c, &d)?), &whole);
        prop_assert_eq!(&(over(&a, &b, &c, &n)? + over(&a, &b, &n, &d)?), &whole);
        prop_assert_eq!(over(&b, &a, &c, &d)?, -whole.clone());
        prop_assert_eq!(over(&b, &a, &d, &c)?, whole);
        prop_assert_eq!(over(&a, &a, &c, &d)?, Q::int(0));
        let ((a, b), (c, d)) = (s.u().domain(), s.v().domain());
        prop_assert_eq!(over(a, b, c, d)?, s.integral()?);
    }

    #[test]
    fn an_integral_over_a_part_is_that_of_the_part(
        s in field(SIDE, SIDE),
        (us, vs) in (any::<[Index; 2]>(), any::<[Index; 2]>()),
    ) {
        let ([a, b], [c, d]) = (two(s.u(), &us), two(s.v(), &vs));
        prop_assume!(a < b && c < d);
        let part = s.restricted(U, &a, &b)?.restricted(V, &c, &d)?;
        prop_assert_eq!(s.integral_between((&a, &c), (&b, &d))?, part.integral()?);
    }
}
