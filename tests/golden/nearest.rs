//! Scale functions nearest to wanted ones with which ends are held or closed curves stay closed.

use crate::check::{Answer, Golden, check, in_dimension, largest, row};
use crate::closed::{closed_quadratic, ring, unrolled};
use crate::data::{Case, Field};
use symspline::{Condition, FineTuner, Function, NearestScale, Norm, Q, Result};

/// What nearness is measured by.
fn norm(case: Case) -> Norm {
    match case.get("norm").text() {
        "coef" => Norm::Coefficients,
        "L2" => Norm::L2,
        norm => panic!("no norm {norm}"),
    }
}

/// Degree, knots `W` and control points `Q`; then moments, and the values of `α`, a row each.
struct Ends;

impl Golden for Ends {
    const CATEGORY: &'static str = "alpha_preserve_ends";
    const CASES: usize = 6;
    const FACTOR: f64 = 64.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        fn tuned<T: Field, const N: usize>(case: Case) -> Result<Answer<T>> {
            let (curve, wanted) = (case.curve::<T, N>("n")?, case.function::<T>("alpha0")?);
            let mut conditions = vec![Condition::End];
            conditions.extend(
                case.get("fixed")
                    .entries()
                    .map(|(index, value)| Condition::Coefficient { index, value: value.number() }),
            );
            let scales = wanted.space();
            let alpha = NearestScale::prepare(&curve, scales, &conditions, norm(case))?.to_signed(&wanted)?;
            let tuner = FineTuner::constrained(&curve, scales, &conditions, norm(case))?.signed();
            let mut answer = Answer::spline(&tuner.tuned(wanted.coeffs())?);
            let (a, b) = curve.domain();
            answer.rows.extend(curve.scale_moments(scales, a, b)?.into_iter().map(row));
            answer.rows.extend(alpha.into_coeffs().into_iter().map(|value| vec![value]));
            Ok(answer)
        }
        in_dimension!(tuned::<T>(case))
    }

    fn expected(case: Case) -> Answer<Q> {
        let mut answer = Answer::expected_spline(case, "degree", "W", "Q");
        answer.rows.extend(case.get("moments").rows());
        answer.rows.extend(case.get("alpha").numbers().into_iter().map(|value| vec![value]));
        answer
    }

    fn size(_: Case, expected: &Answer<Q>, _: usize) -> f64 {
        largest(expected.rows.iter().flatten())
    }
}

#[test]
fn alpha_preserve_ends() {
    check::<Ends>();
}

/// The control points of the closed curve, then the values of `α`.
struct Closed;

impl Golden for Closed {
    const CATEGORY: &'static str = "closed_alpha_preserve";
    const CASES: usize = 2;
    const FACTOR: f64 = 64.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let curve = closed_quadratic::<T>(case)?;
        let wanted = Function::new(ring(1, curve.space().dim())?, case.get("a0").numbers())?;
        let nearest = NearestScale::prepare(&curve, wanted.space(), &[Condition::End], norm(case))?;
        let tuner = FineTuner::constrained(&curve, wanted.space(), &[Condition::End], norm(case))?;
        let tuned = tuner.tuned(wanted.coeffs())?;
        assert!(tuned.space().is_periodic(), "{}", case.id());
        let mut rows = unrolled(&tuned, tuned.space().dim());
        rows.extend(nearest.to(&wanted)?.into_coeffs().into_iter().map(|value| vec![value]));
        Ok(Answer::rows(rows))
    }

    fn expected(case: Case) -> Answer<Q> {
        let mut rows = case.get("Q").rows();
        rows.extend(case.get("a").numbers().into_iter().map(|value| vec![value]));
        Answer::rows(rows)
    }

    fn size(_: Case, expected: &Answer<Q>, _: usize) -> f64 {
        largest(expected.rows.iter().flatten())
    }
}

#[test]
fn closed_alpha_preserve() {
    check::<Closed>();
}
