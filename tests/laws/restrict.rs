//! Laws of restriction and splitting.

use crate::oracle::{self, Side};
use crate::strategies::{ANY, SMOOTH, cases, function, functions, probes};
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{Error, Q, Spline};

/// Two places of a spline in order, if they differ.
fn interval(f: &Spline<Q, Q>, places: &(Index, Index)) -> Option<(Q, Q)> {
    let probes = probes(f.space());
    let (x, y) = (places.0.get(&probes).clone(), places.1.get(&probes).clone());
    match x.cmp(&y) {
        std::cmp::Ordering::Less => Some((x, y)),
        std::cmp::Ordering::Equal => None,
        std::cmp::Ordering::Greater => Some((y, x)),
    }
}

fn places() -> impl Strategy<Value = (Index, Index)> {
    (any::<Index>(), any::<Index>())
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn a_part_has_the_values_of_the_whole(f in function(ANY), places in places()) {
        let Some((a, b)) = interval(&f, &places) else { return Ok(()) };
        let part = f.restricted(&a, &b)?;
        prop_assert_eq!(part.domain(), (&a, &b));
        prop_assert!(part.space().is_clamped());
        prop_assert_eq!(f.space().restriction(&a, &b)?.apply(f.coeffs())?, part.coeffs());
        for x in probes(part.space()) {
            if x < b {
                prop_assert_eq!(part.at(&x)?, oracle::value(&f, &x, Side::Right));
            }
            if x > a {
                prop_assert_eq!(part.at_left(&x)?, oracle::value(&f, &x, Side::Left));
            }
        }
    }

    #[test]
    fn a_part_of_a_part_is_a_part(f in function(ANY), one in places(), two in places()) {
        let Some((a, b)) = interval(&f, &one) else { return Ok(()) };
        let part = f.restricted(&a, &b)?;
        let Some((c, d)) = interval(&part, &two) else { return Ok(()) };
        prop_assert_eq!(part.restricted(&c, &d)?, f.restricted(&c, &d)?);
    }

    #[test]
    fn the_whole_domain_is_the_clamped_spline(f in function(ANY)) {
        let (a, b) = f.domain();
        prop_assert_eq!(f.restricted(a, b)?, f.clamped_ends()?);
    }

    #[test]
    fn restriction_commutes_with_the_derivative(f in function(SMOOTH), places in places()) {
        let Some((a, b)) = interval(&f, &places) else { return Ok(()) };
        let derivative = f.derivative()?.restricted(&a, &b)?;
        prop_assert!(f.restricted(&a, &b)?.derivative()?.same_function(&derivative)?);
    }

    #[test]
    fn restriction_commutes_with_sums_and_products(
        [f, g] in functions(ANY.of_degree(0, 4), ANY.of_degree(0, 4)),
        places in places(),
    ) {
        let Some((a, b)) = interval(&f, &places) else { return Ok(()) };
        let (part_f, part_g) = (f.restricted(&a, &b)?, g.restricted(&a, &b)?);
        prop_assert_eq!((&f + &g).restricted(&a, &b)?, &part_f + &part_g);
        prop_assert_eq!((&f * &g).restricted(&a, &b)?, &part_f * &part_g);
    }

    #[test]
    fn a_part_has_the_integral_between(f in function(ANY), places in places()) {
        let Some((a, b)) = interval(&f, &places) else { return Ok(()) };
        prop_assert_eq!(f.restricted(&a, &b)?.integral()?, f.integral_between(&a, &b)?);
    }

    #[test]
    fn splitting_gives_both_parts(f in function(ANY), place in any::<Index>()) {
        let (a, b) = f.domain();
        let probes = probes(f.space());
        let x = place.get(&probes);
        if x == a || x == b {
            prop_assert!(matches!(f.split(x), Err(Error::EmptyDomain { .. })), "no empty parts");
        } else {
            prop_assert_eq!(f.split(x)?, (f.restricted(a, x)?, f.restricted(x, b)?));
        }
    }
}
