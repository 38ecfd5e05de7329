//! Laws of the polar form.

use crate::oracle;
use crate::strategies::{ANY, OPEN, cases, function, number, probes, space};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{Function, Q, Scalar, SplineSpace};

/// Arguments of all sorts: knots of the unrolled vector in some order, parameters between them, and numbers far off.
fn arguments(space: &SplineSpace<Q>, raw: &[(Index, Q, u8)]) -> Vec<Q> {
    let (knots, probes) = (space.knots(), probes(space));
    let argument = |(place, number, choice): &(Index, Q, u8)| match choice {
        0..=3 => place.get(knots).clone(),
        4..=6 => place.get(&probes).clone(),
        _ => number.clone(),
    };
    raw[..space.degree()].iter().map(argument).collect()
}

fn raw_arguments() -> impl Strategy<Value = Vec<(Index, Q, u8)>> {
    vec((any::<Index>(), number(), 0_u8..8), 10)
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn on_the_diagonal_the_polar_form_is_the_value(space in space(ANY)) {
        for x in probes(&space) {
            let k = space.locate(&x)?;
            let diagonal = space.polar(k, &vec![x.clone(); space.degree()])?;
            prop_assert_eq!(diagonal.to_dense(space.dim()), space.basis(&x)?.to_dense(space.dim()));
        }
    }

    #[test]
    fn the_polar_form_is_that_of_de_boors_algorithm(f in function(ANY), raw in raw_arguments()) {
        let args = arguments(f.space(), &raw);
        for k in f.space().spans() {
            prop_assert_eq!(f.space().polar(k, &args)?.apply(f.coeffs()), oracle::polar(&f, k, &args));
        }
    }

    #[test]
    fn the_polar_form_is_symmetric(space in space(ANY), raw in raw_arguments(), turn in any::<Index>()) {
        let mut args = arguments(&space, &raw);
        let before = args.clone();
        let (steps, half) = (turn.index(args.len().max(1)).min(args.len()), args.len() / 2);
        args.rotate_left(steps);
        args[half..].reverse();
        for k in space.spans() {
            prop_assert_eq!(space.polar(k, &args)?, space.polar(k, &before)?);
        }
    }

    #[test]
    fn the_polar_form_is_affine_in_each_argument(
        f in function(ANY.of_degree(1, 10)),
        raw in raw_arguments(),
        (u, v, s) in (number(), number(), number()),
    ) {
        let args = arguments(f.space(), &raw);
        let k = f.space().spans().last().unwrap();
        let with = |place: usize, x: Q| {
            let mut args = args.clone();
            args[place] = x;
            f.space().polar(k, &args).map(|row| row.apply(f.coeffs()))
        };
        for place in 0..args.len() {
            let mixed = with(place, (Q::int(1) - &s) * &u + s.clone() * &v)?;
            let expected = (Q::int(1) - &s) * with(place, u.clone())? + s.clone() * with(place, v.clone())?;
            prop_assert_eq!(mixed, expected);
        }
    }

    #[test]
    fn polar_weights_sum_to_one(space in space(ANY), raw in raw_arguments()) {
        let args = arguments(&space, &raw);
        for k in space.spans() {
            prop_assert_eq!(space.polar(k, &args)?.weights().iter().sum::<Q>(), Q::int(1));
        }
    }

    #[test]
    fn a_coefficient_is_the_polar_value_at_its_knots(space in space(ANY)) {
        let (p, t) = (space.degree(), space.knots());
        for k in space.spans() {
            for i in k - p..=k {
                let row = space.polar(k, &t[i + 1..=i + p])?;
                prop_assert_eq!(row.weights(), &[Q::int(1)][..]);
                prop_assert_eq!(space.slot(row.first()), space.slot(i));
            }
        }
    }

    #[test]
    fn greville_abscissae_are_the_coefficients_of_x(space in space(OPEN.of_degree(1, 10))) {
        let x = Function::new(space.clone(), space.greville())?;
        for at in probes(&space) {
            prop_assert_eq!(&x.at(&at)?, &at);
        }
    }

    #[test]
    fn greville_abscissae_of_a_ring_are_those_of_its_unrolled_space(space in space(ANY)) {
        let unrolled = space.unclamped_ends()?;
        if space.is_periodic() {
            prop_assert_eq!(space.greville(), &unrolled.greville()[..space.dim()]);
        }
    }
}
