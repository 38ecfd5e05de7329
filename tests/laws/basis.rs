//! Laws of basis functions and of evaluation.

use crate::oracle::{self, Side};
use crate::strategies::{ANY, SMOOTH, cases, curve, function, probes, space};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{Q, Scalar};

/// A row of unrolled weights on the coefficients they coincide with.
fn wrapped(row: &[Q], dim: usize) -> Vec<Q> {
    let mut dense = vec![Q::int(0); dim];
    row.iter().enumerate().for_each(|(i, w)| dense[i % dim] += w);
    dense
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn basis_functions_are_a_partition_of_unity(space in space(ANY)) {
        for x in probes(&space) {
            let basis = space.basis(&x)?;
            prop_assert_eq!(basis.weights().len(), space.degree() + 1);
            prop_assert_eq!(basis.weights().iter().sum::<Q>(), Q::int(1));
            prop_assert!(basis.weights().iter().all(|w| !w.is_negative()));
        }
    }

    #[test]
    fn basis_functions_satisfy_the_recurrence(space in space(ANY)) {
        for x in probes(&space) {
            let expected = wrapped(&oracle::basis(&space, &x, Side::Right), space.dim());
            prop_assert_eq!(space.basis(&x)?.to_dense(space.dim()), expected);
        }
    }

    #[test]
    fn the_evaluation_is_a_map(c in curve::<2>(ANY), places in vec(any::<Index>(), 0..6)) {
        let all = probes(c.space());
        let parameters: Vec<Q> = places.iter().map(|place| place.get(&all).clone()).chain(all.clone()).collect();
        let map = c.space().evaluation(&parameters)?;
        prop_assert_eq!((map.source_dim(), map.target_dim()), (c.space().dim(), parameters.len()));
        prop_assert!(map.rows().all(|(first, weights)| first < map.source_dim() && weights.len() == c.degree() + 1));
        prop_assert_eq!(map.apply(c.coeffs())?, c.eval(&parameters)?);
        prop_assert_eq!(map.transpose().transpose().apply(c.coeffs())?, c.eval(&parameters)?);
    }

    #[test]
    fn values_are_limits_from_the_right_and_from_the_left(f in function(ANY)) {
        for x in probes(f.space()) {
            prop_assert_eq!(f.at(&x)?, oracle::value(&f, &x, Side::Right));
            prop_assert_eq!(f.at_left(&x)?, oracle::value(&f, &x, Side::Left));
        }
    }

    #[test]
    fn coordinates_of_a_curve_are_its_values(c in curve::<3>(ANY)) {
        for x in probes(c.space()) {
            let point = c.at(&x)?;
            for axis in 0..3 {
                prop_assert_eq!(&c.coordinate(axis)?.at(&x)?, &point[axis]);
            }
        }
    }

    #[test]
    fn long_runs_in_a_span_are_the_single_values(f in function(ANY)) {
        let breaks = f.space().breaks();
        let within = |i: i64| {
            let part = Q::frac(i, 24);
            breaks.windows(2).map(|ends| ends[0].0.clone() + (ends[1].0.clone() - &ends[0].0) * &part).collect::<Vec<_>>()
        };
        let mut parameters: Vec<Q> = (0..=24).flat_map(within).collect();
        parameters.sort();
        let values = f.eval(&parameters)?;
        for (x, value) in parameters.iter().zip(values) {
            prop_assert_eq!(f.at(x)?, value);
        }
    }

    #[test]
    fn many_values_are_the_single_values(
        f in function(ANY),
        places in vec(any::<Index>(), 0..8),
    ) {
        let probes = probes(f.space());
        let parameters: Vec<Q> = places.iter().map(|place| place.get(&probes).clone()).collect();
        let single: Vec<Q> = parameters.iter().map(|x| f.at(x)).collect::<Result<_, _>>()?;
        let mut into = vec![Q::int(7); parameters.len()];
        f.eval_into(&parameters, &mut into)?;
        prop_assert_eq!(&f.eval(&parameters)?, &single);
        prop_assert_eq!(into, single);
    }

    #[test]
    fn a_span_holds_its_parameters(space in space(ANY)) {
        let t = space.knots();
        let (a, b) = space.domain();
        for x in probes(&space) {
            let (k, l) = (space.locate(&x)?, space.locate_left(&x)?);
            prop_assert!(t[k] <= x && (x < t[k + 1] || x == *b && t[k] < x));
            prop_assert!((t[l] < x || x == *a && x < t[l + 1]) && x <= t[l + 1]);
        }
    }

    #[test]
    fn a_hint_does_not_change_the_span(
        f in function(ANY),
        hints in vec(any::<usize>(), 1..4),
    ) {
        let (space, mut span) = (f.space(), hints[0]);
        for x in probes(space) {
            for hint in hints.iter().copied().chain(0..space.knots().len() + 2) {
                prop_assert_eq!(space.locate_near(&x, hint)?, space.locate(&x)?);
            }
            prop_assert_eq!(f.at_near(&x, &mut span)?, f.at(&x)?);
            prop_assert_eq!(span, space.locate(&x)?);
        }
    }

    #[test]
    fn derivative_functionals_sum_to_zero(space in space(ANY)) {
        let p = space.degree();
        for x in probes(&space) {
            let rows = space.basis_derivatives(&x, p + 2)?;
            prop_assert_eq!(&rows[0], &space.basis(&x)?);
            for row in &rows[1..] {
                prop_assert_eq!(row.weights().iter().sum::<Q>(), Q::int(0));
            }
            prop_assert!(rows[p + 1..].iter().all(|row| row.weights().iter().all(|w| *w == Q::int(0))));
        }
    }

    #[test]
    fn derivative_functionals_give_the_values_of_derivatives(f in function(SMOOTH)) {
        let mut derivative = f.clone();
        for order in 0..=f.degree() + 1 {
            for x in probes(f.space()) {
                let expected = derivative.at(&x)?;
                let row = &f.space().basis_derivatives(&x, order)?[order];
                prop_assert_eq!(&row.apply(f.coeffs()), &expected);
                prop_assert_eq!(&f.derivative_at(&x, order)?, &expected);
                prop_assert_eq!(&f.derivatives_at(&x, order)?[order], &expected);
            }
            // A derivative may jump, and then has none itself.
            let Ok(next) = derivative.derivative() else { break };
            derivative = next;
        }
    }

    #[test]
    fn derivatives_of_the_pieces_are_their_taylor_coefficients(f in function(ANY)) {
        for piece in oracle::powers(&f) {
            let values = f.derivatives_at(&piece.a, f.degree())?;
            for (order, value) in values.iter().enumerate() {
                let falling = |i: usize| (i - order + 1..=i).map(|j| Q::int(j as i64)).product::<Q>();
                let power = |i: usize| oracle::raised(&piece.a, i - order);
                let term = |i: usize| piece.coeffs[i].clone() * falling(i) * power(i);
                prop_assert_eq!(value, &(order..=f.degree()).map(term).sum::<Q>());
            }
        }
    }
}
