//! Laws of affine changes of the parameter.

use crate::strategies::{ANY, SMOOTH, cases, curve, function, functions, number, probes};
use proptest::prelude::*;
use symspline::{Error, Q, Scalar};

/// A domain: its start and its length.
fn domain() -> impl Strategy<Value = (Q, Q)> {
    (number(), 1_i64..=12, 1_i64..=7).prop_map(|(start, n, d)| (start.clone(), start + Q::frac(n, d)))
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn there_and_back_is_nowhere(c in curve::<2>(ANY), (start, end) in domain()) {
        let (a, b) = c.domain();
        let moved = c.reparametrised(&start, &end)?;
        prop_assert_eq!(moved.domain(), (&start, &end));
        prop_assert_eq!(moved.reparametrised(a, b)?, c);
    }

    #[test]
    fn values_move_with_their_parameters(f in function(ANY), (start, end) in domain()) {
        let (moved, (a, b)) = (f.reparametrised(&start, &end)?, f.domain());
        for x in probes(f.space()) {
            let there = start.clone() + (x.clone() - a) / (b.clone() - a) * (end.clone() - &start);
            prop_assert_eq!(moved.at(&there)?, f.at(&x)?);
            prop_assert_eq!(moved.at_left(&there)?, f.at_left(&x)?);
        }
    }

    #[test]
    fn derivatives_scale_with_the_lengths(f in function(SMOOTH), (start, end) in domain()) {
        let (a, b) = f.domain();
        let ratio = (b.clone() - a) / (end.clone() - &start);
        let derivative = f.derivative()?.reparametrised(&start, &end)?;
        prop_assert_eq!(f.reparametrised(&start, &end)?.derivative()?, &derivative * ratio);
    }

    #[test]
    fn integrals_scale_with_the_lengths(f in function(ANY), (start, end) in domain()) {
        let (a, b) = f.domain();
        let ratio = (end.clone() - &start) / (b.clone() - a);
        prop_assert_eq!(f.reparametrised(&start, &end)?.integral()?, f.integral()? * ratio);
    }

    #[test]
    fn reparametrisation_commutes_with_sums_and_products(
        [f, g] in functions(ANY.of_degree(0, 4), ANY.of_degree(0, 4)),
        (start, end) in domain(),
    ) {
        let [there_f, there_g] = [f.reparametrised(&start, &end)?, g.reparametrised(&start, &end)?];
        prop_assert_eq!((&f + &g).reparametrised(&start, &end)?, &there_f + &there_g);
        prop_assert_eq!((&f * &g).reparametrised(&start, &end)?, &there_f * &there_g);
    }

    #[test]
    fn empty_domains_are_refused(f in function(ANY), (start, end) in domain()) {
        for (a, b) in [(&end, &start), (&start, &start)] {
            let refused = f.reparametrised(a, b);
            prop_assert!(matches!(refused, Err(Error::EmptyDomain { .. })), "{refused:?}");
        }
    }
}
