//! Laws of evaluators: what they give is what the spline gives, over `Q` with `==`, over `f64` with the stated bound.

use crate::rational_strategies::{nurbs, nurbs_surface};
use crate::rounding;
use crate::strategies::{ANY, cases, curve, function, indices, probe_pairs, probes, surface};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{Error, Evaluate, Function, Q, Scalar, SplineSpace, TensorSpline};

/// The items in another order, some of them many times in a row.
fn jumbled<X: Clone>(items: &[X], order: &[prop::sample::Index]) -> Vec<X> {
    let runs = order.iter().enumerate().map(|(i, index)| (index.get(items).clone(), 1 + 20 * (i % 3)));
    items.iter().cloned().chain(runs.flat_map(|(x, count)| std::iter::repeat_n(x, count))).collect()
}

/// The places at which a batch refuses, and a single value.
fn refuses<E: Evaluate>(evaluator: &E, inside: E::Parameter, outside: E::Parameter) -> bool {
    let refused = |result: Error| matches!(result, Error::OutsideDomain { .. });
    let single = evaluator.at(&outside).err().is_some_and(refused);
    let derivatives = evaluator.derivatives_at::<2>(&outside).err().is_some_and(refused);
    single && derivatives && evaluator.eval(&[inside, outside]).err().is_some_and(refused)
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn functions(f in function(ANY), order in indices(6)) {
        let evaluator = f.evaluator()?;
        let parameters = jumbled(&probes(f.space()), &order);
        let expected: Vec<Q> = parameters.iter().map(|x| f.at(x)).collect::<Result<_, _>>()?;
        prop_assert_eq!(evaluator.eval(&parameters)?, expected);
        let mut all = vec![std::array::from_fn(|_| Q::int(0)); parameters.len()];
        evaluator.eval_derivatives_into::<4>(&parameters, &mut all)?;
        for (x, derivatives) in parameters.iter().zip(&all) {
            prop_assert_eq!(derivatives.to_vec(), f.derivatives_at(x, 3)?);
            prop_assert_eq!(&evaluator.derivatives_at::<4>(x)?, derivatives);
            prop_assert_eq!(&evaluator.at(x)?, &derivatives[0]);
        }
        let (a, b) = f.domain();
        prop_assert!(refuses(&evaluator, a.clone(), b.clone() + Q::frac(1, 1 << 40)));
        prop_assert!(refuses(&evaluator, b.clone(), a.clone() - Q::frac(1, 1 << 40)));
    }

    #[test]
    fn curves(c in curve::<3>(ANY)) {
        let evaluator = c.evaluator()?;
        for x in probes(c.space()) {
            prop_assert_eq!(evaluator.at(&x)?, c.at(&x)?);
            prop_assert_eq!(evaluator.derivatives_at::<3>(&x)?.to_vec(), c.derivatives_at(&x, 2)?);
        }
    }

    #[test]
    fn rational_curves(c in nurbs::<2>(ANY.of_degree(0, 5))) {
        let evaluator = c.evaluator()?;
        let parameters = probes(c.space());
        prop_assert_eq!(evaluator.eval(&parameters)?, c.eval(&parameters)?);
        for x in &parameters {
            prop_assert_eq!(evaluator.derivatives_at::<4>(x)?.to_vec(), c.derivatives_at(x, 3)?);
        }
    }
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn surfaces(s in surface::<3>(ANY.few(2), ANY.few(2).of_degree(0, 4)), order in indices(6)) {
        let evaluator = s.evaluator()?;
        let parameters = jumbled(&probe_pairs(&s), &order);
        prop_assert_eq!(evaluator.eval(&parameters)?, s.eval(&parameters)?);
        for x in parameters.iter().step_by(5) {
            let expected = s.derivatives_at(&x.0, &x.1, 2)?;
            let found = evaluator.derivatives_at::<3>(x)?;
            prop_assert!(found.iter().zip(&expected).all(|(f, e)| f[..] == e[..]));
            prop_assert_eq!(evaluator.at(x)?, expected[0][0].clone());
        }
        let ((a, b), (c, d)) = (s.u().domain(), s.v().domain());
        let far = (b.clone() + Q::int(1), c.clone());
        prop_assert!(refuses(&evaluator, (a.clone(), d.clone()), far));
        prop_assert!(refuses(&evaluator, (b.clone(), c.clone()), (a.clone(), d.clone() + Q::int(1))));
    }

    #[test]
    fn rational_surfaces(s in nurbs_surface::<3>(ANY.of_degree(0, 2).few(2))) {
        let evaluator = s.evaluator()?;
        for u in probes(s.u()) {
            let v = probes(s.v()).pop().expect("a parameter");
            let expected = s.derivatives_at(&u, &v, 2)?;
            let x = (u, v);
            let found = evaluator.derivatives_at::<3>(&x)?;
            prop_assert!(found.iter().zip(&expected).all(|(f, e)| f[..] == e[..]));
            prop_assert_eq!(&evaluator.at(&x)?, &expected[0][0]);
            prop_assert_eq!(&evaluator.eval(&[x])?[0], &expected[0][0]);
        }
    }

    #[test]
    fn rounding_is_within_the_stated_bound(f in rounding::function(), at in vec(0.0..=1.0, 40)) {
        let (evaluator, exact) = (f.evaluator()?, rounding::exact(&f)?);
        let (a, b): (&f64, &f64) = f.domain();
        let (p, scale) = (f.degree() as f64, f.coeffs().iter().fold(0.0_f64, |m, c| m.max(c.abs())));
        let shortest = f.space().breaks().windows(2).map(|ends| ends[1].0 - ends[0].0).fold(f64::MAX, f64::min);
        for share in at {
            let x = f64::min(a + (b - a) * share, *b);
            let found = evaluator.derivatives_at::<3>(&x)?;
            let expected = exact.derivatives_at(&Q::try_from(x)?, 2)?;
            for (d, (found, expected)) in found.iter().zip(expected).enumerate() {
                let bound = 4.0 * (p + 1.0) * p.exp2() * scale * (2.0 * p / shortest).powi(d as i32) * f64::EPSILON;
                prop_assert!((found - expected.to_f64()).abs() <= bound);
            }
            prop_assert_eq!(evaluator.at(&x)?, found[0]);
        }
    }

    /// A step function with values that tell the span: knots that share all but a few bits, or differ by powers of two.
    #[test]
    fn spans_are_found_on_any_knots(
        knots in vec((1_u64..64, -60_i32..60, any::<bool>()), 2..40),
        at in vec(0.0..1.0, 20),
    ) {
        let number = |(mantissa, exponent, close): (u64, i32, bool)| {
            if close { 1.0 + mantissa as f64 * f64::EPSILON } else { mantissa as f64 * 2_f64.powi(exponent) }
        };
        let mut knots: Vec<f64> = knots.into_iter().map(number).collect();
        knots.sort_by(f64::total_cmp);
        knots.dedup();
        prop_assume!(knots.len() > 1);
        let (a, b) = (knots[0], knots[knots.len() - 1]);
        let steps = (0..knots.len() - 1).map(|i| i as f64).collect();
        let f = Function::new(SplineSpace::clamped(0, knots.clone())?, steps)?;
        let evaluator = f.evaluator()?;
        let beside = knots.iter().flat_map(|t| [t.next_down(), *t, t.next_up()]);
        let parameters: Vec<f64> = beside.chain(at.iter().map(|share| a + (b - a) * share)).filter(|x| a <= *x && *x <= b).collect();
        for x in &parameters {
            prop_assert_eq!(evaluator.at(x)?, f.at(x)?);
        }
        prop_assert_eq!(evaluator.eval(&parameters)?, f.eval(&parameters)?);
    }
}

#[test]
fn nothing_is_said_of_what_is_not_a_number() {
    let square = Function::monomial(2, 0.0, 1.0).unwrap().evaluator().unwrap();
    for x in [f64::NAN, f64::INFINITY, -1e-300] {
        assert!(matches!(square.at(&x), Err(Error::OutsideDomain { .. })));
        assert!(matches!(square.eval(&[0.5, x]), Err(Error::OutsideDomain { .. })));
    }
    let mut places = [0.0; 2];
    let wrong = square.eval_into(&[0.5], &mut places);
    assert_eq!(wrong, Err(Error::CoefficientCount { expected: 1, found: 2 }));
    assert_eq!(places, [0.0; 2]);
}

#[test]
fn the_shortest_spans_are_evaluated() {
    // Its reciprocal is finite, twice that is not.
    let tiny = 0.75 * f64::MIN_POSITIVE;
    let space = SplineSpace::clamped(1, [0.0, tiny, 1.0]).unwrap();
    let evaluator = Function::new(space, vec![0.0, 1.0, 2.0]).unwrap().evaluator().unwrap();
    assert_eq!(evaluator.eval(&[0.0, tiny / 2.0, tiny, 1.0]).unwrap(), [0.0, 0.5, 1.0, 2.0]);
}

#[test]
fn coefficients_too_large_for_powers_are_refused() {
    let wild = vec![f64::MAX, -f64::MAX, f64::MAX];
    let space = SplineSpace::bezier(2, 0.0, 1.0).unwrap();
    let f = Function::new(space.clone(), wild.clone()).unwrap();
    assert!(matches!(f.evaluator(), Err(Error::NotFinite { index: 1, .. })));
    let s = TensorSpline::new(SplineSpace::bezier(0, 0.0, 1.0).unwrap(), space, wild).unwrap();
    assert!(matches!(s.evaluator(), Err(Error::NotFinite { index: 1, .. })));
}

#[test]
fn high_degrees_are_evaluated_too() {
    let f = Function::monomial(11, 0.0, 1.0).unwrap();
    let evaluator = f.evaluator().unwrap();
    assert_eq!(evaluator.derivatives_at::<3>(&0.75).unwrap().to_vec(), f.derivatives_at(&0.75, 2).unwrap());
    let line = SplineSpace::bezier(1, 0.0, 1.0).unwrap();
    let coeffs = f.coeffs().iter().flat_map(|c| [*c, 2.0 * c]).collect();
    let s = TensorSpline::new(f.space().clone(), line, coeffs).unwrap();
    let evaluator = s.evaluator().unwrap();
    assert_eq!(evaluator.at(&(0.5, 1.0)).unwrap(), s.at(&0.5, &1.0).unwrap());
    assert_eq!(
        evaluator.derivatives_at::<2>(&(0.5, 1.0)).unwrap()[0][1],
        s.derivative_at(&0.5, &1.0, 0, 1).unwrap()
    );
}
