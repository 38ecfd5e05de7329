//! Laws of rounding: over `f64` operators are as near to the exact result as their number of steps allows.
//!
//! Knots and coefficients are taken as the exact numbers they are, the operator is run over `Q`, and what `f64` gives is
//! compared with that. Bounds are in units of `f64::EPSILON` times the largest coefficient.

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{Function, Q, Scalar, SplineSpace};

/// The exact spline that `f` stands for.
pub fn exact(f: &Function<f64>) -> symspline::Result<Function<Q>> {
    f.to_exact()
}

/// The largest of some numbers in magnitude.
pub fn largest(values: &[Q]) -> Q {
    values.iter().map(Q::abs).max().expect("at least one value")
}

/// The largest error of `found`, in units of `scale`.
pub fn error(found: &[f64], expected: &[Q], scale: &Q) -> f64 {
    assert_eq!(found.len(), expected.len());
    let off = |(x, y): (&f64, &Q)| (Q::try_from(*x).expect("a finite number") - y).abs();
    let worst = found.iter().zip(expected).map(off).max().expect("at least one value");
    if *scale == Q::int(0) { worst.to_f64() } else { (worst / scale).to_f64() }
}

/// A space with spans whose lengths differ up to a thousandfold, knots of any multiplicity, clamped or periodic.
///
/// Knots are whole multiples of 1/1024, so that a period more or less is not rounded: knots of a ring are the same
/// numbers in both fields.
fn space() -> impl Strategy<Value = SplineSpace<f64>> {
    let dyadic = |n: i32| f64::from(n) / 1024.0;
    (0_usize..=7, vec((10_i32..10_000, 1_usize..=8), 1..=5), -10_000_i32..10_000, any::<bool>()).prop_map(
        move |(p, spans, start, ring)| {
            let start = dyadic(start);
            let mut knots = vec![start];
            for (length, copies) in &spans[..spans.len() - 1] {
                let next = knots[knots.len() - 1] + dyadic(*length);
                // Simple knots more often than others.
                let copies = if *copies > p + 1 { 1 } else { *copies };
                knots.extend(vec![next; copies]);
            }
            let end = knots[knots.len() - 1] + dyadic(spans[spans.len() - 1].0);
            let space = if ring {
                SplineSpace::periodic(p, knots, end - start)
            } else {
                SplineSpace::clamped(p, knots.into_iter().chain([end]))
            };
            space.expect("ascending knots")
        },
    )
}

/// Functions with coefficients up to 1 on such spaces.
pub fn function() -> impl Strategy<Value = Function<f64>> {
    (space(), vec(-1.0_f64..1.0, 48)).prop_map(|(space, coeffs)| {
        let coeffs = coeffs[..space.dim()].to_vec();
        Function::new(space, coeffs).expect("as many coefficients as the space has")
    })
}

const EPS: f64 = f64::EPSILON;

proptest! {
    #![proptest_config(crate::strategies::cases(64))]

    #[test]
    fn exact_and_back_is_nowhere(f in function()) {
        prop_assert_eq!(&f.to_exact()?.to_f64()?, &f);
        prop_assert_eq!(f.to_exact()?, f.map_scalars(|&x| Q::try_from(x))?);
    }

    #[test]
    fn values_are_near((f, places) in (function(), vec(0.0_f64..=1.0, 8))) {
        let (a, b) = f.domain();
        let parameters: Vec<f64> = places.iter().map(|s| (a + (b - a) * s).clamp(*a, *b)).collect();
        let exact = exact(&f)?;
        let values = parameters.iter().map(|&x| exact.at(&Q::try_from(x)?)).collect::<Result<Vec<Q>, _>>()?;
        let error = error(&f.eval(&parameters)?, &values, &largest(exact.coeffs()));
        prop_assert!(error <= 2.0 * (f.degree() + 1) as f64 * EPS, "{}", error / EPS);
    }

    #[test]
    fn insertion_is_near(f in function(), places in vec((any::<Index>(), 1_u8..16), 0..5)) {
        let breaks = f.space().breaks();
        let knot = |(place, sixteenths): &(Index, u8)| {
            let i = place.index(breaks.len() - 1);
            breaks[i].0 + (breaks[i + 1].0 - breaks[i].0) * f64::from(*sixteenths) / 16.0
        };
        let knots: Vec<f64> = places.iter().map(knot).collect();
        let Ok(refined) = f.inserted(&knots) else { return Ok(()) };
        let exact = exact(&f)?;
        let expected = exact.embedded(&refined.space().map_scalars(|&x| Q::try_from(x))?)?;
        let error = error(refined.coeffs(), expected.coeffs(), &largest(exact.coeffs()));
        prop_assert!(error <= 2.0 * (f.degree() + 1) as f64 * EPS, "{}", error / EPS);
    }

    #[test]
    fn elevation_is_near(f in function(), raise in 1_usize..4) {
        let exact = exact(&f)?;
        let (found, expected) = (f.elevated(raise)?, exact.elevated(raise)?);
        let error = error(found.coeffs(), expected.coeffs(), &largest(exact.coeffs()));
        prop_assert!(error <= 2.0 * (raise * (f.degree() + 2)) as f64 * EPS, "{}", error / EPS);
    }

    #[test]
    fn antiderivatives_are_near(f in function()) {
        prop_assume!(!f.space().is_periodic());
        let exact = exact(&f)?;
        let (a, b) = exact.domain();
        let scale = largest(exact.coeffs()) * (b.clone() - a);
        let error = error(f.antiderivative()?.coeffs(), exact.antiderivative()?.coeffs(), &scale);
        prop_assert!(error <= 4.0 * f.space().dim() as f64 * EPS, "{}", error / EPS);
    }

    #[test]
    fn integrals_are_near(f in function()) {
        let exact = exact(&f)?;
        let (a, b) = exact.domain();
        let scale = largest(exact.coeffs()) * (b.clone() - a);
        let error = error(&[f.integral()?], &[exact.integral()?], &scale);
        prop_assert!(error <= 4.0 * (f.space().dim() + f.degree() + 1) as f64 * EPS, "{}", error / EPS);
    }
}

proptest! {
    #![proptest_config(crate::strategies::cases(24))]

    #[test]
    fn gram_matrices_are_near(f in function()) {
        prop_assume!(!f.space().is_periodic() && f.degree() <= 5);
        let space = f.space().map_scalars(|&x| Q::try_from(x))?;
        let (found, expected) = (f.space().gram(f.space(), 0, 0)?, space.gram(&space, 0, 0)?);
        let (found, expected) = (found.to_matrix()?, expected.to_matrix()?);
        for i in 0..space.dim() {
            // An entry is no larger than its diagonal entries.
            for j in 0..space.dim() {
                let scale = expected[(i, i)].clone().max(expected[(j, j)].clone());
                let error = error(&[found[(i, j)]], &[expected[(i, j)].clone()], &scale);
                prop_assert!(error <= 16.0 * (f.degree() + 1) as f64 * EPS, "{}", error / EPS);
            }
        }
    }
}
