//! Laws of Moebius changes of the parameter.

use crate::rational_strategies::{nurbs, nurbs_surface};
use crate::strategies::{ANY, Kind, cases, probes};
use proptest::prelude::*;
use symspline::Direction::{U, V};
use symspline::{Coeff, Error, Function, Q, RationalFunction, Scalar};

const LOW: Kind = ANY.of_degree(0, 4);

/// A positive number.
fn ratio() -> impl Strategy<Value = Q> {
    prop_oneof![
        (1_i64..9, 1_i64..9).prop_map(|(p, q)| Q::frac(p, q)),
        Just(Q::frac(1, 1_000_003)),
        Just(Q::int(1_000_003)),
    ]
}

/// An interval.
fn interval() -> impl Strategy<Value = (Q, Q)> {
    (-5_i64..5, 1_i64..9, 1_i64..7).prop_map(|(a, p, q)| (Q::int(a), Q::int(a) + Q::frac(p, q)))
}

/// Where `s` in `[start, end]` goes in `[a, b]`.
fn image((start, end): (&Q, &Q), (a, b): (&Q, &Q), ratio: &Q, s: &Q) -> Q {
    let (left, right) = (end.clone() - s, (s.clone() - start) * ratio);
    (a.clone() * &left + b.clone() * &right) / (left + right)
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn values_move_with_the_parameter(f in nurbs::<2>(LOW), (start, end) in interval(), ratio in ratio()) {
        let moved = f.moebius(&start, &end, &ratio)?;
        prop_assert_eq!(moved.domain(), (&start, &end));
        prop_assert_eq!(moved.degree(), f.degree());
        prop_assert_eq!(moved.space().dim(), f.space().clamped_ends()?.dim());
        for s in probes(moved.space()) {
            let x = image((&start, &end), f.domain(), &ratio, &s);
            prop_assert_eq!(moved.at(&s)?, f.at(&x)?);
            if s != start {
                prop_assert_eq!(moved.at_left(&s)?, f.at_left(&x)?);
            }
        }
    }

    #[test]
    fn ratios_multiply(
        f in nurbs::<2>(LOW), (start, end) in interval(), first in ratio(), second in ratio(),
    ) {
        let (a, b) = f.domain();
        let once = f.moebius(&start, &end, &(first.clone() * &second))?;
        let twice = f.moebius(a, b, &first)?.moebius(&start, &end, &second)?;
        prop_assert_eq!(&once, &twice);
        let back = f.moebius(&start, &end, &first)?.moebius(a, b, &(Q::int(1) / &first))?;
        prop_assert_eq!(back, f.through(|lifted| lifted.clamped_ends())?);
    }

    #[test]
    fn with_ratio_one_it_is_affine(f in nurbs::<2>(LOW), (start, end) in interval()) {
        let affine = f.through(|lifted| lifted.clamped_ends()?.reparametrised(&start, &end))?;
        prop_assert_eq!(f.moebius(&start, &end, &Q::int(1))?, affine);
    }

    #[test]
    fn the_speed_at_the_ends_changes_by_the_ratio(
        f in nurbs::<2>(LOW), (start, end) in interval(), ratio in ratio(),
    ) {
        let (a, b) = f.domain();
        let moved = f.moebius(&start, &end, &ratio)?;
        let affine = (b.clone() - a) / (end.clone() - &start);
        let [first, last] = [(&start, a, affine.clone() * &ratio), (&end, b, affine / &ratio)].map(|(s, x, speed)| {
            let slope = |f: &symspline::NurbsCurve<Q, 2>, x| Ok::<_, Error>(f.derivatives_at(x, 1)?[1].clone());
            Ok::<_, Error>((slope(&moved, s)?, slope(&f, x)?.scaled(&speed)))
        });
        let (first, last) = (first?, last?);
        prop_assert_eq!(first.0, first.1);
        prop_assert_eq!(last.0, last.1);
    }

    #[test]
    fn arithmetic_commutes_with_it(f in nurbs::<2>(ANY.of_degree(0, 2)), (start, end) in interval(), ratio in ratio()) {
        let moved = f.moebius(&start, &end, &ratio)?;
        let squared = f.dot(&f)?.moebius(&start, &end, &ratio)?;
        prop_assert!(moved.dot(&moved)?.same_function(&squared)?);
    }
}

proptest! {
    #![proptest_config(cases(12))]

    #[test]
    fn surfaces_move_along_either_direction(
        f in nurbs_surface::<2>(ANY.of_degree(0, 2)), (start, end) in interval(), ratio in ratio(), other in ratio(),
    ) {
        let along_u = f.moebius(U, &start, &end, &ratio)?;
        prop_assert_eq!((along_u.u().domain(), along_u.v()), ((&start, &end), f.v()));
        let both = along_u.moebius(V, &start, &end, &other)?;
        prop_assert_eq!(&both, &f.moebius(V, &start, &end, &other)?.moebius(U, &start, &end, &ratio)?);
        for s in probes(both.u()) {
            let u = image((&start, &end), f.u().domain(), &ratio, &s);
            for v in probes(f.v()) {
                prop_assert_eq!(along_u.at(&s, &v)?, f.at(&u, &v)?);
            }
            for t in probes(both.v()) {
                let v = image((&start, &end), f.v().domain(), &other, &t);
                prop_assert_eq!(both.at(&s, &t)?, f.at(&u, &v)?);
            }
        }
    }
}

#[test]
fn bad_intervals_and_ratios_are_refused() {
    let f = RationalFunction::from_polynomial(&Function::monomial(1, 0.0, 1.0).unwrap()).unwrap();
    for (start, end) in [(1.0, 1.0), (2.0, 1.0), (f64::NAN, 1.0), (0.0, f64::NAN), (0.0, f64::INFINITY)] {
        assert!(matches!(f.moebius(&start, &end, &1.0), Err(Error::EmptyDomain { .. })), "{start} {end}");
    }
    for ratio in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(f.moebius(&0.0, &1.0, &ratio), Err(Error::Ratio { .. })), "{ratio}");
    }
}
