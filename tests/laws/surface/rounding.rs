//! Laws of rounding for surfaces: what `f64` gives is compared with the exact result for the same numbers.
//!
//! Bounds are in units of `f64::EPSILON` times the largest coefficient, for a derivative times `2 p / h` with the shortest
//! leg `h`, the sum of `p` spans.

use crate::rounding::{error, largest};
use crate::strategies::cases;
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::Direction::{U, V};
use symspline::{Q, Result, Scalar, SplineSpace, TensorSpline};

const EPS: f64 = f64::EPSILON;

/// A space over spans whose lengths are multiples of 1/1024 and differ up to a thousandfold.
fn space((p, spans, ring): (usize, Vec<(i32, usize)>, bool), end: Option<f64>) -> SplineSpace<f64> {
    let mut knots = vec![0.0];
    for (length, copies) in &spans {
        let next = knots[knots.len() - 1] + f64::from(*length) / 1024.0;
        knots.extend(vec![next; if *copies > p.max(1) { 1 } else { *copies }]);
    }
    let end = end.unwrap_or(knots[knots.len() - 1] + 1.0);
    let space = if ring {
        SplineSpace::periodic(p, knots, end)
    } else {
        SplineSpace::clamped(p, knots.into_iter().chain([end]))
    };
    space.expect("ascending knots")
}

fn recipe(most: usize) -> impl Strategy<Value = (usize, Vec<(i32, usize)>, bool)> {
    (0..=most, vec((10_i32..10_000, 1_usize..=8), 0..3), any::<bool>())
}

/// A surface with coefficients in `[-1, 1]`.
fn grid(u: SplineSpace<f64>, v: SplineSpace<f64>, pool: &[f64]) -> TensorSpline<f64> {
    let deal = |k: usize| pool[(k * 7 + k * k / 5) % pool.len()];
    let coeffs = (0..u.dim() * v.dim()).map(deal).collect();
    TensorSpline::new(u, v, coeffs).expect("as many coefficients as the spaces have")
}

fn field(most: usize) -> impl Strategy<Value = TensorSpline<f64>> {
    (recipe(most), recipe(most), vec(-1.0_f64..1.0, 29))
        .prop_map(|(u, v, pool)| grid(space(u, None), space(v, None), &pool))
}

/// Two surfaces on one domain: knots lie below 64.
fn fields(most: usize) -> impl Strategy<Value = [TensorSpline<f64>; 2]> {
    let side = move || recipe(most).prop_map(|recipe| space(recipe, Some(64.0)));
    let one = move || (side(), side(), vec(-1.0_f64..1.0, 29)).prop_map(|(u, v, pool)| grid(u, v, &pool));
    (one(), one()).prop_map(|(f, g)| [f, g])
}

/// Points of the domain, by their shares of its sides.
fn points(s: &TensorSpline<f64>, shares: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let place = |space: &SplineSpace<f64>, share: f64| {
        let (a, b) = space.domain();
        (a + (b - a) * share).clamp(*a, *b)
    };
    shares.iter().map(|(x, y)| (place(s.u(), *x), place(s.v(), *y))).collect()
}

/// By how much a derivative may exceed the coefficients it is made of.
fn steepness(space: &SplineSpace<Q>) -> Q {
    let (p, t) = (space.degree(), space.knots());
    let legs = (1..t.len() - p - 1).map(|i| t[i + p].clone() - &t[i]).filter(|leg| *leg > Q::int(0));
    legs.min().map_or(Q::int(1), |leg| Q::int(2 * p as i64) / leg)
}

/// The exact answers at points.
fn exactly(points: &[(f64, f64)], answer: impl Fn(&Q, &Q) -> Result<Q>) -> Result<Vec<Q>> {
    points.iter().map(|(u, v)| answer(&Q::try_from(*u)?, &Q::try_from(*v)?)).collect()
}

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn values_are_near(s in field(7), shares in vec((0.0_f64..=1.0, 0.0_f64..=1.0), 1..6)) {
        let (points, exact) = (points(&s, &shares), s.to_exact()?);
        let (us, vs): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
        let grid = us.iter().flat_map(|u| vs.iter().map(|v| (*u, *v))).collect::<Vec<_>>();
        let singles = grid.iter().map(|(u, v)| s.at(u, v)).collect::<Result<Vec<_>>>()?;
        let expected = exactly(&grid, |u, v| exact.at(u, v))?;
        let limit = 2.0 * (s.u().degree() + s.v().degree() + 2) as f64 * EPS;
        for found in [&singles, &s.eval(&grid)?, &s.eval_grid(&us, &vs)?] {
            let error = error(found, &expected, &largest(exact.coeffs()));
            prop_assert!(error <= limit, "{}", error / EPS);
        }
    }

    #[test]
    fn tangents_are_near(s in field(7), shares in vec((0.0_f64..=1.0, 0.0_f64..=1.0), 1..6)) {
        let (points, exact) = (points(&s, &shares), s.to_exact()?);
        let found = points.iter().map(|(u, v)| s.tangents_at(u, v)).collect::<Result<Vec<_>>>()?;
        let limit = 2.0 * (s.u().degree() + s.v().degree() + 2) as f64 * EPS;
        let sides = [(0, Q::int(1), 0, 0), (1, steepness(exact.u()), 1, 0), (2, steepness(exact.v()), 0, 1)];
        for (i, steepness, k, l) in sides {
            let expected = exactly(&points, |u, v| exact.derivative_at(u, v, k, l))?;
            let found: Vec<f64> = found.iter().map(|tangents| tangents[i]).collect();
            let error = error(&found, &expected, &(largest(exact.coeffs()) * steepness));
            prop_assert!(error <= limit, "{i}: {}", error / EPS);
        }
    }

    #[test]
    fn elevation_is_near_in_both_directions(s in field(5), raise in 1_usize..3) {
        let exact = s.to_exact()?;
        for direction in [U, V] {
            let (found, expected) = (s.elevated(direction, raise)?, exact.elevated(direction, raise)?);
            let error = error(found.coeffs(), expected.coeffs(), &largest(exact.coeffs()));
            let limit = 2.0 * (raise * (s.space(direction).degree() + 2)) as f64 * EPS;
            prop_assert!(error <= limit, "{}", error / EPS);
        }
    }
}

proptest! {
    #![proptest_config(cases(16))]

    #[test]
    fn products_are_near([f, g] in fields(4)) {
        let (found, expected) = (f.times(&g)?, f.to_exact()?.times(&g.to_exact()?)?);
        let error = error(found.coeffs(), expected.coeffs(), &largest(expected.coeffs()));
        prop_assert!(error <= 1e-13, "{error:e}");
    }

    #[test]
    fn integrals_are_near(s in field(5)) {
        let exact = s.to_exact()?;
        let length = |space: &SplineSpace<Q>| space.domain().1.clone() - space.domain().0;
        let scale = largest(exact.coeffs()) * length(exact.u()) * length(exact.v());
        let error = error(&[s.integral()?], &[exact.integral()?], &scale);
        let size = s.u().dim() + s.u().degree() + s.v().dim() + s.v().degree();
        prop_assert!(error <= 4.0 * size as f64 * EPS, "{}", error / EPS);
    }
}
