//! Laws of rounding for rational splines: with positive weights of any size, values over `f64` are as near to the exact ones
//! as the control points and the degree allow.

use crate::rounding::{error, largest};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{NurbsCurve, NurbsSurface, Q, RationalFunction, Scalar, SplineSpace};

const EPS: f64 = f64::EPSILON;

/// A clamped space on `[0, 1]` with knots at sixteenths.
fn space() -> impl Strategy<Value = SplineSpace<f64>> {
    (0_usize..=5, vec(1_u8..16, 0..4)).prop_map(|(p, mut inner)| {
        inner.sort_unstable();
        inner.dedup();
        let inner = inner.into_iter().map(|i| f64::from(i) / 16.0);
        SplineSpace::clamped(p, [0.0].into_iter().chain(inner).chain([1.0])).expect("ascending knots")
    })
}

/// A weight from `1e-100` to `1e100`.
fn weight() -> impl Strategy<Value = f64> {
    prop_oneof![3 => 0.1..10.0_f64, 1 => (-100.0..100.0_f64).prop_map(|e| 10_f64.powf(e))]
}

fn function() -> impl Strategy<Value = RationalFunction<f64>> {
    (space(), vec(-1.0..1.0_f64, 12), vec(weight(), 12)).prop_map(|(space, points, weights)| {
        let n = space.dim();
        RationalFunction::new(space, points[..n].to_vec(), weights[..n].to_vec()).expect("positive weights")
    })
}

proptest! {
    #![proptest_config(crate::strategies::cases(64))]

    #[test]
    fn values_are_near(f in function(), parameters in vec(0.0_f64..=1.0, 8)) {
        let exact = f.to_exact()?;
        let values = parameters.iter().map(|&x| exact.at(&Q::try_from(x)?)).collect::<Result<Vec<Q>, _>>()?;
        let error = error(&f.eval(&parameters)?, &values, &largest(&exact.points()?));
        prop_assert!(error <= (4 * f.degree() + 6) as f64 * EPS, "{}", error / EPS);
    }

    #[test]
    fn first_derivatives_are_near(f in function(), x in 0.0_f64..=1.0) {
        // With weights in proportion below 10, the spans of 1/16: each of the terms is at most p * 16 * 100 large.
        let (low, high) = f.weights().fold((f64::MAX, 0.0_f64), |(a, b), &w| (a.min(w), b.max(w)));
        prop_assume!(high <= 10.0 * low);
        let exact = f.to_exact()?;
        let found = f.derivatives_at(&x, 1)?;
        let expected = exact.derivatives_at(&Q::try_from(x)?, 1)?;
        let scale = largest(&exact.points()?) * Q::int(16 * 2 * 100 * (f.degree() as i64).max(1));
        let error = error(&found[1..], &expected[1..], &scale);
        prop_assert!(error <= (f.degree() + 2) as f64 * EPS, "{}", error / EPS);
    }

    #[test]
    fn insertion_moves_values_little(f in function(), x in 0.0_f64..=1.0, knot in 1_i32..63) {
        let refined = f.through(|lifted| lifted.inserted(&[f64::from(knot) / 64.0]));
        let Ok(refined) = refined else { return Ok(()) };
        let scale = largest(&f.to_exact()?.points()?);
        let error = error(&[refined.at(&x)?], &[Q::try_from(f.at(&x)?)?], &scale);
        prop_assert!(error <= (12 * (f.degree() + 2)) as f64 * EPS, "{}", error / EPS);
    }

    #[test]
    fn surface_values_are_near(
        (u, v) in (space(), space()), points in vec(-1.0..1.0_f64, 144), weights in vec(weight(), 144),
        x in 0.0_f64..=1.0, y in 0.0_f64..=1.0,
    ) {
        let n = u.dim() * v.dim();
        let points = points[..n].iter().map(|&c| nalgebra::vector![c]).collect();
        let f = NurbsSurface::<f64, 1>::new(u, v, points, weights[..n].to_vec())?;
        let exact = f.to_exact()?;
        let scale = largest(&exact.points()?.iter().map(|c| c[0].clone()).collect::<Vec<_>>());
        let value = exact.at(&Q::try_from(x)?, &Q::try_from(y)?)?[0].clone();
        let error = error(&[f.at(&x, &y)?[0]], &[value], &scale);
        prop_assert!(error <= (4 * (f.u().degree() + f.v().degree()) + 10) as f64 * EPS, "{}", error / EPS);
    }
}

/// At the end of its span the heavy weight has faded to some hundred times the others: what is left of the span must be
/// as exact as what has been covered, in batches too.
#[test]
fn where_a_heavy_weight_fades_values_are_near() {
    let space = SplineSpace::bezier(2, 0.0, 1.0).unwrap();
    let f = RationalFunction::new(space, vec![0.0, 0.0, -0.07], vec![0.1, 4.4e11, 0.1]).unwrap();
    let parameters: Vec<f64> = (0..40).map(|i| 1.0 - 1e-5 - 1e-7 * f64::from(i)).collect();
    let exact = f.to_exact().unwrap();
    let expected =
        parameters.iter().map(|&x| exact.at(&Q::try_from(x).unwrap()).unwrap()).collect::<Vec<_>>();
    for (found, expected) in f.eval(&parameters).unwrap().iter().zip(&expected) {
        let expected = expected.to_f64();
        assert!((found - expected).abs() <= 16.0 * EPS * expected.abs(), "{found:e}, {expected:e}");
    }
}

#[test]
fn weights_of_extreme_size_go_through() {
    let space = SplineSpace::bezier(2, 0.0, 1.0).unwrap();
    let points = [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| nalgebra::vector![x, y]).to_vec();
    for scale in [1e-200, 1e-100, 1.0, 1e100, 1e200] {
        let weights = [1.0, 1.0, 2.0].map(|w| w * scale).to_vec();
        let quarter = NurbsCurve::new(space.clone(), points.clone(), weights).unwrap();
        let value = quarter.at(&0.5).unwrap();
        assert!((value[0] - 0.6).abs() <= EPS && (value[1] - 0.8).abs() <= EPS, "{scale:e}: {value}");
        let slope = &quarter.derivatives_at(&0.5, 1).unwrap()[1];
        assert!(
            (slope[0] + 1.28).abs() <= 4.0 * EPS && (slope[1] - 0.96).abs() <= 4.0 * EPS,
            "{scale:e}: {slope}"
        );
    }
}
