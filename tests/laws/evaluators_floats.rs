//! Laws of evaluators over `f64`: batches in any order, ends of the range of numbers, stated bounds.

use crate::rounding;
use proptest::collection::vec;
use proptest::prelude::*;
use std::fmt::Debug;
use symspline::{
    Coeff, Error, Evaluate, Function, NurbsCurve, Q, Result, Row, Scalar, Spline, SplineSpace, Surface,
    TensorSpline,
};

/// Parameters in order, reversed, back and forth between the ends, and shuffled.
fn orders(a: f64, b: f64) -> Vec<Vec<f64>> {
    let at = |i: usize| f64::min(a + (b - a) * (i as f64 / 200.0), b);
    let index: [fn(usize) -> usize; 4] =
        [|i| i, |i| 200 - i, |i| if i % 2 == 0 { i } else { 200 - i }, |i| i * 89 % 201];
    index.map(|index| (0..=200).map(|i| at(index(i))).collect()).to_vec()
}

fn wavy(space: SplineSpace<f64>) -> Result<Function<f64>> {
    let coeffs = (0..space.dim()).map(|i| (0.7 * i as f64).cos()).collect();
    Function::new(space, coeffs)
}

fn wavy_surface(u: SplineSpace<f64>, v: SplineSpace<f64>) -> Result<TensorSpline<f64>> {
    let coeffs = (0..u.dim() * v.dim()).map(|i| (0.7 * i as f64).cos()).collect();
    TensorSpline::new(u, v, coeffs)
}

/// All ways to get values and derivatives give the same numbers.
fn agrees<E: Evaluate>(evaluator: &E, parameters: &[E::Parameter]) -> Result<()>
where
    E::Value: Clone + PartialEq + Debug,
    E::Derivatives<3>: Clone + PartialEq + Debug,
{
    let singles = parameters.iter().map(|x| evaluator.at(x)).collect::<Result<Vec<_>>>()?;
    assert_eq!(evaluator.eval(parameters)?, singles);
    let mut values = vec![singles[0].clone(); singles.len()];
    evaluator.par_eval_into(parameters, &mut values)?;
    assert_eq!(values, singles);
    let singles = parameters.iter().map(|x| evaluator.derivatives_at(x)).collect::<Result<Vec<_>>>()?;
    let mut all = vec![singles[0].clone(); singles.len()];
    evaluator.eval_derivatives_into(parameters, &mut all)?;
    assert_eq!(all, singles);
    Ok(())
}

#[test]
fn batches_give_single_values_in_any_order() -> Result<()> {
    for p in 0..=9 {
        for spans in [1, 2, 5, 300] {
            let f = wavy(SplineSpace::uniform(p, spans, -1.0, 3.0)?)?;
            let evaluator = f.evaluator()?;
            let accuracy = 8.0 * (p + 1) as f64 * (p as f64).exp2() * f64::EPSILON;
            for parameters in orders(-1.0, 3.0) {
                agrees(&evaluator, &parameters)?;
                let close = |(x, y): (f64, f64)| (x - y).abs() <= accuracy;
                assert!(evaluator.eval(&parameters)?.into_iter().zip(f.eval(&parameters)?).all(close));
            }
        }
    }
    Ok(())
}

#[test]
fn threads_share_a_batch() -> Result<()> {
    let evaluator = wavy(SplineSpace::uniform(3, 300, 0.0, 1.0)?)?.evaluator()?;
    let parameters: Vec<f64> = (0..20_001).map(|i| f64::from(i * 89 % 20_001) / 20_000.0).collect();
    agrees(&evaluator, &parameters)?;
    let wrong = [&parameters[..], &[1.5]].concat();
    let refused = evaluator.par_eval_into(&wrong, &mut vec![0.0; wrong.len()]);
    assert!(matches!(refused, Err(Error::OutsideDomain { .. })));
    Ok(())
}

#[test]
fn batches_of_surfaces_give_single_values() -> Result<()> {
    for (p, q) in [(0, 0), (1, 1), (2, 2), (3, 3), (1, 4), (6, 5)] {
        let s = wavy_surface(SplineSpace::uniform(p, 7, -1.0, 3.0)?, SplineSpace::uniform(q, 2, -1.0, 3.0)?)?;
        let [along, _, back, shuffled]: [Vec<f64>; 4] = orders(-1.0, 3.0).try_into().expect("four orders");
        for (us, vs) in [(&along, &back), (&shuffled, &along), (&back, &shuffled)] {
            let parameters: Vec<(f64, f64)> = us.iter().copied().zip(vs.iter().copied()).collect();
            agrees(&s.evaluator()?, &parameters)?;
        }
    }
    Ok(())
}

/// How many values and derivatives a batch gives before it refuses.
fn taken<E: Evaluate>(evaluator: &E, parameters: &[E::Parameter]) -> (usize, usize) {
    let (mut values, mut derivatives) = (0, 0);
    let refusals = [
        evaluator.for_each(parameters, |_| values += 1),
        evaluator.for_each_derivatives::<2>(parameters, |_| derivatives += 1),
    ];
    assert!(refusals.iter().all(|refusal| matches!(refusal, Err(Error::OutsideDomain { .. }))));
    (values, derivatives)
}

#[test]
fn a_batch_gives_what_comes_before_the_first_refusal() -> Result<()> {
    for (p, spans) in [(1, 1), (3, 90), (5, 90), (9, 90)] {
        let space = SplineSpace::uniform(p, spans, -1.0, 3.0)?;
        let evaluator = wavy(space.clone())?.evaluator()?;
        let surface = wavy_surface(space, SplineSpace::uniform(1, 2, -1.0, 3.0)?)?.evaluator()?;
        for order in orders(-1.0, 3.0) {
            for (bad, wrong) in (0..70).zip([f64::NAN, 3.5, f64::NEG_INFINITY].into_iter().cycle()) {
                let mut parameters = order[..70].to_vec();
                parameters[bad] = wrong;
                assert_eq!(taken(&evaluator, &parameters), (bad, bad));
                let pairs: Vec<(f64, f64)> = parameters.iter().map(|x| (0.0, *x)).collect();
                assert_eq!(taken(&surface, &pairs), (bad, bad));
            }
        }
    }
    Ok(())
}

#[test]
fn any_number_of_derivatives() -> Result<()> {
    for p in [0, 3, 5, 9] {
        let space = SplineSpace::uniform(p, 4, 0.0, 1.0)?;
        let (f, s) = (wavy(space.clone())?, wavy_surface(space.clone(), space)?);
        let (evaluator, surface) = (f.evaluator()?, s.evaluator()?);
        assert_eq!(evaluator.derivatives_at::<0>(&0.3)?, []);
        assert_eq!(evaluator.derivatives_at::<1>(&0.3)?, [evaluator.at(&0.3)?]);
        assert_eq!(evaluator.derivatives_at::<12>(&0.3)?[p + 1..], vec![0.0; 11 - p]);
        let x = (0.3, 0.6);
        assert!(surface.derivatives_at::<0>(&x)?.is_empty());
        assert_eq!(surface.derivatives_at::<1>(&x)?, [[surface.at(&x)?]]);
        assert_eq!(surface.derivatives_at::<12>(&x)?[p + 1], [0.0; 12]);
        let mut places = [[0.0; 0]; 2];
        evaluator.eval_derivatives_into(&[0.1, 0.7], &mut places)?;
        let wrong = evaluator.eval_derivatives_into(&[0.1], &mut places);
        assert_eq!(wrong, Err(Error::CoefficientCount { expected: 1, found: 2 }));
    }
    Ok(())
}

/// Powers of the length of a span leave the range of numbers where derivatives do not.
#[test]
fn derivatives_on_the_shortest_and_longest_spans() -> Result<()> {
    for (length, size, slope) in [(1e-200, 1e-300, 2e100), (1e200, 1e250, 2e-150)] {
        let space = SplineSpace::bezier(2, 0.0, length)?;
        let bend = Function::new(space.clone(), vec![0.0, 0.0, size])?;
        let [value, first, second, third] = bend.evaluator()?.derivatives_at::<4>(&0.0)?;
        assert_eq!([value, first, third], [0.0; 3]);
        assert!((second / slope - 1.0).abs() < 1e-14);
        let mut batch = [[0.0; 4]];
        bend.evaluator()?.eval_derivatives_into(&[0.0], &mut batch)?;
        assert_eq!(batch[0], [value, first, second, third]);
        let constant = TensorSpline::constant(space.clone(), space, 1.0)?.evaluator()?;
        let all = constant.derivatives_at::<4>(&(length, length / 2.0))?;
        assert!(all.iter().flatten().skip(1).all(|d| *d == 0.0));
    }
    Ok(())
}

#[test]
fn values_near_the_largest_number_are_finite_or_refused() -> Result<()> {
    let mut accepted = 0;
    for signs in 0..32_u32 {
        for size in [0.5, 0.2, 0.1, 0.05, 0.02] {
            let sign = |i: u32| if signs >> i & 1 == 0 { 1.0 } else { -1.0 };
            let coeffs: Vec<f64> = (0..5).map(|i| sign(i) * size * f64::MAX).collect();
            let space = SplineSpace::bezier(4, 0.0, 1.0)?;
            let surface =
                TensorSpline::new(space.clone(), SplineSpace::bezier(0, 0.0, 1.0)?, coeffs.clone())?;
            for x in [0.0, 0.1, 0.4, 0.9, 1.0] {
                if let Ok(evaluator) = Function::new(space.clone(), coeffs.clone())?.evaluator() {
                    accepted += 1;
                    assert!(evaluator.at(&x)?.is_finite());
                }
                assert!(surface.evaluator().map_or(Ok(0.0), |s| s.at(&(x, x)))?.is_finite());
            }
        }
    }
    assert!(accepted > 100);
    Ok(())
}

/// Step functions whose values tell the span: thousands of knots in one bucket, the shortest and the longest domain.
#[test]
fn spans_are_found_among_thousands_and_at_the_ends_of_the_range() -> Result<()> {
    let cluster = std::iter::successors(Some(1.0_f64), |t| Some(t.next_up())).take(3000);
    let tiny = 0.75 * f64::MIN_POSITIVE;
    let all = [
        [-1e300, 0.0].into_iter().chain(cluster).chain([2.0, 1e300]).collect(),
        (0..40_000).map(f64::from).collect(),
        (0..4).map(|i| f64::from(i) * tiny).collect(),
        vec![-f64::MAX / 2.0, -1.0, 0.0, 1e-300, 1.0, f64::MAX / 2.0],
        vec![f64::MAX / 1.5, f64::MAX / 1.25, f64::MAX],
    ];
    for knots in all {
        let knots: Vec<f64> = knots;
        let steps = (0..knots.len() - 1).map(|i| i as f64).collect();
        let f = Function::new(SplineSpace::clamped(0, knots.clone())?, steps)?;
        let beside = knots.iter().flat_map(|t| [t.next_down(), *t, t.next_up()]);
        let inside = |x: &f64| knots[0] <= *x && *x <= knots[knots.len() - 1];
        let parameters: Vec<f64> = beside.filter(inside).collect();
        let evaluator = f.evaluator()?;
        for x in &parameters {
            assert_eq!(evaluator.at(x)?, f.at(x)?);
        }
        assert_eq!(evaluator.eval(&parameters)?, f.eval(&parameters)?);
    }
    Ok(())
}

#[test]
fn rows_and_arrays_are_evaluated_entry_by_entry() -> Result<()> {
    fn check<C: Coeff<f64>>(make: impl Fn(f64) -> C, derivative: impl Fn([f64; 3]) -> [C; 3]) -> Result<()> {
        let f = wavy(SplineSpace::uniform(4, 3, 0.0, 1.0)?)?;
        let rows =
            Spline::new(f.space().clone(), f.coeffs().iter().map(|c| make(*c)).collect())?.evaluator()?;
        for x in [0.0, 0.4, 1.0] {
            assert_eq!(rows.at(&x)?, make(f.evaluator()?.at(&x)?));
            let expected = derivative(f.evaluator()?.derivatives_at::<3>(&x)?);
            assert_eq!(rows.derivatives_at::<3>(&x)?, expected);
        }
        Ok(())
    }
    let row = |c: f64| Row(vec![c, 2.0 * c, -c]);
    let array = |c: f64| [c, 2.0 * c, -c];
    check(row, |all| all.map(row))?;
    check(array, |all| all.map(array))?;
    let size = Coeff::<f64>::squared_size;
    assert_eq!(size(&[1.0, -3.0, 2.0]), 9.0);
    assert!(Coeff::<f64>::components(&array(2.0)).eq(&[2.0, 4.0, -2.0]));
    assert_eq!(Coeff::try_map(&array(2.0), |x: &f64| Q::try_from(*x))?, [2, 4, -2].map(Q::int));
    assert!(!Coeff::<f64>::same_shape(&[row(1.0), row(1.0)], &[row(1.0), Row(vec![1.0])]));
    Ok(())
}

proptest! {
    #![proptest_config(crate::strategies::cases(24))]

    #[test]
    fn surfaces_are_within_the_stated_bound(
        (f, g) in (rounding::function(), rounding::function()),
        signs in vec(prop_oneof![Just(-1.0), Just(1.0), -1.0..1.0], 97),
        at in vec((0.0..=1.0, 0.0..=1.0), 4),
    ) {
        let (u, v) = (f.space().clone(), g.space().clone());
        prop_assume!(u.degree() + v.degree() <= 10);
        let growth = (u.degree() + v.degree() + 2) as f64 * ((u.degree() + v.degree()) as f64).exp2();
        let coeffs = (0..u.dim() * v.dim()).map(|i| signs[i * i % 97]).collect();
        let s = TensorSpline::new(u, v, coeffs)?;
        let (evaluator, exact) = (s.evaluator()?, s.to_exact()?);
        let ((a, b), (c, d)) = (s.u().domain(), s.v().domain());
        for (along, across) in at {
            let x = (f64::min(a + (b - a) * along, *b), f64::min(c + (d - c) * across, *d));
            let expected = exact.at(&Q::try_from(x.0)?, &Q::try_from(x.1)?)?.to_f64();
            prop_assert!((evaluator.at(&x)? - expected).abs() <= 4.0 * growth * f64::EPSILON);
        }
    }

    /// The denominator is `r` times smaller than the largest weight; beyond a thousand no powers are used.
    #[test]
    fn weights_cost_what_is_said(
        points in vec((-1.0..1.0_f64, 0..20_i32), 4..8),
        at in vec(0.0..=1.0, 6),
    ) {
        let p = points.len() - 1;
        let weights: Vec<f64> = points.iter().map(|(_, e)| 2_f64.powi(-e)).collect();
        let largest = weights.iter().copied().fold(0.0, f64::max);
        let points = points.iter().map(|(c, _)| nalgebra::vector![*c]).collect();
        let c = NurbsCurve::<f64, 1>::new(SplineSpace::bezier(p, 0.0, 1.0)?, points, weights)?;
        let (evaluator, exact) = (c.evaluator()?, c.to_exact()?);
        for x in at.into_iter().chain([0.0, 1.0]) {
            let x_exact = Q::try_from(x)?;
            let r = f64::min(largest / exact.lifted().at(&x_exact)?.weight.to_f64(), 1000.0);
            let bound = 4.0 * (p + 1) as f64 * (p as f64).exp2() * f64::EPSILON * 2.1 * r;
            prop_assert!((evaluator.at(&x)?[0] - exact.at(&x_exact)?[0].to_f64()).abs() <= bound);
        }
    }
}

#[test]
fn surfaces_of_points_are_evaluated_at_many_spans() -> Result<()> {
    let space = SplineSpace::uniform(3, 40, 0.0, 1.0)?;
    let wave = |i: usize| nalgebra::vector![(0.1 * i as f64).sin(), i as f64 % 7.0, 1.0];
    let s = Surface::<f64, 3>::new(space.clone(), space, (0..43 * 43).map(wave).collect())?;
    let evaluator = s.evaluator()?;
    for i in 0..500 {
        let x = (f64::from(i * 37 % 500) / 499.0, f64::from(i) / 499.0);
        assert!((evaluator.at(&x)? - s.at(&x.0, &x.1)?).amax() < 1e-11);
        let expected = s.derivatives_at(&x.0, &x.1, 1)?;
        let found = evaluator.derivatives_at::<2>(&x)?;
        let close = |(k, l): (usize, usize)| (found[k][l] - expected[k][l]).amax() < 1e-7;
        assert!([(0, 1), (1, 0), (1, 1)].into_iter().all(close));
    }
    Ok(())
}
