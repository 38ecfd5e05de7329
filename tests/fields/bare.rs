//! Exact numbers without the hooks: what the hooks of [`Q`] return is what they would return by default.

use crate::signs::{signs, wrapped};
use nalgebra::{DMatrix, SVector};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{Coeff, Curve, Function, Q, Result, Scalar, Spline, SplineSpace, solve_dense};

type Outcome = std::result::Result<(), TestCaseError>;

/// A [`Q`] that takes every default of [`Scalar`].
#[derive(Clone, Debug, PartialEq, PartialOrd)]
pub struct Bare(Q);

wrapped!(Bare);

impl Scalar for Bare {
    const EXACT: bool = true;

    fn int(n: i64) -> Self {
        Self(Q::int(n))
    }
}

fn bare(q: &Q) -> Result<Bare> {
    Ok(Bare(q.clone()))
}

fn same<C: Coeff<Q>>(found: &C, expected: &C::Over<Bare>) -> Outcome {
    prop_assert_eq!(&found.try_map(bare).expect("every number has a copy"), expected);
    Ok(())
}

fn same_spline<C: Coeff<Q>>(
    found: Result<Spline<Q, C>>,
    expected: Result<Spline<Bare, C::Over<Bare>>>,
) -> Outcome {
    match (found, expected) {
        (Ok(found), Ok(expected)) => {
            prop_assert_eq!(found.map_scalars(bare), Ok(expected));
        }
        (found, expected) => prop_assert_eq!(found.err(), expected.err()),
    }
    Ok(())
}

/// Small fractions, lossless images of `f64`, and numbers far beyond words.
fn number() -> impl Strategy<Value = Q> {
    let few = (-9..=9i64, 1..=6i64).prop_map(|(p, q)| Q::frac(p, q));
    let image = (-9.0..9.0f64).prop_map(|x| Q::try_from(x).expect("a finite number"));
    let third =
        (-9.0..9.0f64, 1..40i64).prop_map(|(x, q)| Q::try_from(x).expect("a finite number") / Q::int(q));
    let huge = (any::<i64>(), 1..=i64::MAX).prop_map(|(p, q)| Q::int(p) * Q::int(p) / Q::int(q));
    prop_oneof![4 => few, 4 => image, 2 => third, 1 => huge]
}

/// Positive steps between knots, of one kind each time.
fn steps() -> impl Strategy<Value = Vec<Q>> {
    let few = vec((1..=9i64, 1..=4i64).prop_map(|(p, q)| Q::frac(p, q)), 3);
    let image = vec((1e-6..4.0f64).prop_map(|x| Q::try_from(x).expect("a finite number")), 3);
    let any = vec(number().prop_map(|x| x.abs() + Q::frac(1, 7)), 3);
    prop_oneof![Just(vec![Q::int(1); 3]), few, image, any]
}

/// A curve of degree up to nine over up to three spans, and a parameter in its domain.
fn curve() -> impl Strategy<Value = (Curve<Q, 2>, Q)> {
    let copies = vec(1..=10_usize, 2);
    (0..=9_usize, 1..=3_usize, steps(), copies, vec(number(), 80), number(), any::<bool>()).prop_map(
        |(p, spans, steps, copies, values, start, periodic)| {
            let mut breaks = vec![start];
            steps[..spans].iter().for_each(|step| breaks.push(breaks[breaks.len() - 1].clone() + step));
            let inner =
                (1..spans).flat_map(|i| std::iter::repeat_n(breaks[i].clone(), copies[i - 1].min(p + 1)));
            let (first, last) = (breaks[0].clone(), breaks[spans].clone());
            let space = if periodic {
                SplineSpace::periodic(p, std::iter::once(first.clone()).chain(inner), &last - &first)
            } else {
                let all = std::iter::repeat_n(first.clone(), p + 1).chain(inner);
                SplineSpace::new(p, all.chain(std::iter::repeat_n(last.clone(), p + 1)))
            };
            let space = space
                .unwrap_or_else(|_| SplineSpace::bezier(p, first.clone(), last.clone()).expect("a span"));
            let point =
                |i: usize| SVector::from([2 * i, 2 * i + 1].map(|i| values[i % values.len()].clone()));
            let share = Q::frac((values[0].is_negative() as i64) + 2, 5);
            let x = &first + (&last - &first) * share;
            (Curve::new(space.clone(), (0..space.dim()).map(point).collect()).expect("as many points"), x)
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn values_are_those_of_the_generic_text((f, x) in curve()) {
        let (g, y) = (f.map_scalars(bare).expect("a copy"), Bare(x.clone()));
        same(&f.at(&x).expect("inside"), &g.at(&y).expect("inside"))?;
        for (found, expected) in f.derivatives_at(&x, 2).expect("inside").iter().zip(&g.derivatives_at(&y, 2).expect("inside")) {
            same(found, expected)?;
        }
        let xs = vec![f.domain().0.clone(), x.clone(), x, f.domain().1.clone()];
        let ys: Vec<Bare> = xs.iter().cloned().map(Bare).collect();
        for (found, expected) in f.eval(&xs).expect("inside").iter().zip(&g.eval(&ys).expect("inside")) {
            same(found, expected)?;
        }
    }

    #[test]
    fn operators_are_those_of_the_generic_text((f, x) in curve()) {
        let (g, y) = (f.map_scalars(bare).expect("a copy"), Bare(x.clone()));
        same_spline(f.elevated(1), g.elevated(1))?;
        same_spline(f.inserted(&[x]), g.inserted(&[y]))?;
        same_spline(f.clamped_ends(), g.clamped_ends())?;
        same_spline(f.dot(&f), g.dot(&g))?;
        let (u, v): (Function<Q>, Function<Bare>) = (f.coordinate(0).expect("two"), g.coordinate(0).expect("two"));
        same_spline(f.times(&u), g.times(&v))?;
    }

    #[test]
    fn solutions_are_those_of_elimination(n in 0..=6_usize, entries in vec(number(), 36), right in vec(number(), 12)) {
        let matrix = DMatrix::from_fn(n, n, |i, j| entries[6 * i + j].clone());
        let right = DMatrix::from_fn(n, 2, |i, j| right[2 * i + j].clone());
        let expected = solve_dense(&matrix.map(Bare), &right.map(Bare));
        prop_assert_eq!(solve_dense(&matrix, &right).map(|x| x.map(Bare)), expected);
    }
}
