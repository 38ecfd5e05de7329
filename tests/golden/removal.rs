//! Lower degrees and fewer knots.

use crate::check::{Answer, Golden, check, for_each, in_dimension};
use crate::data::{Case, Field};
use symspline::{Error, Keep, Q, Result, Scalar};

struct Reduction;

/// Degree and knots of the reduced space, and the coefficients, unless the curve is not of that degree.
fn reduction<T: Field, const N: usize>(case: Case) -> Result<Answer<T>> {
    let (curve, by) = (case.curve::<T, N>("p")?, case.get("t").integer());
    let lowered = curve.degree_lowered(by)?;
    let mut answer = Answer::spline(&lowered.spline);
    if T::EXACT {
        match curve.degree_reduced_exactly(by) {
            Ok(reduced) => assert_eq!((reduced, T::zero()), (lowered.spline, lowered.bound), "{}", case.id()),
            Err(error) => {
                assert_eq!(error, Error::NotReducible { degree: curve.degree() - by }, "{}", case.id());
                answer.rows.clear();
            }
        }
    } else if lowered.bound > T::frac(1, 1_000_000_000) {
        answer.rows.clear();
    }
    Ok(answer)
}

impl Golden for Reduction {
    const CATEGORY: &'static str = "degree_reduction";
    const CASES: usize = 7;
    const FACTOR: f64 = 16.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        in_dimension!(reduction::<T>(case))
    }

    fn expected(case: Case) -> Answer<Q> {
        if !case.refused("P_out") {
            return Answer::expected_spline(case, "p_out", "U_out", "P_out");
        }
        let (degree, knots): (usize, Vec<Q>) = (case.get("p_out").integer(), case.get("U_out").numbers());
        Answer { integers: vec![degree, knots.len() - degree - 1], knots, rows: Vec::new() }
    }
}

struct Removal;

impl Golden for Removal {
    const CATEGORY: &'static str = "knot_removal";
    const CASES: usize = 3;
    const FACTOR: f64 = 16.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        fn removal<T: Field, const N: usize>(case: Case) -> Result<Answer<T>> {
            let (curve, knot) = (case.curve::<T, N>("p")?, case.get("u").number());
            let tolerance = if T::EXACT { T::zero() } else { T::frac(1, 1_000_000_000_000) };
            let removed = curve.removed(&knot, usize::MAX, &tolerance)?;
            let mut answer = Answer::spline(&removed.spline);
            answer.integers.push(curve.space().dim() - removed.spline.space().dim());
            Ok(answer)
        }
        in_dimension!(removal::<T>(case))
    }

    fn expected(case: Case) -> Answer<Q> {
        let mut answer = Answer::expected_spline(case, "p", "U_out", "P_out");
        answer.integers.push(case.get("max_removable").integer());
        answer
    }
}

struct Forced;

impl Golden for Forced {
    const CATEGORY: &'static str = "knot_removal_forced";
    const CASES: usize = 5;
    const FACTOR: f64 = 16.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        fn forced<T: Field, const N: usize>(case: Case) -> Result<Answer<T>> {
            let (curve, index) = (case.curve::<T, N>("p")?, case.get("r").integer());
            let keep = if case.get("variant").text() == "keep_right" { Keep::Right } else { Keep::Left };
            let dropped = curve.without_knot(index, keep)?;
            let mut answer = Answer::spline(&dropped.spline);
            let (a, b) = dropped.changed;
            answer.knots.extend([a, b]);
            Ok(answer)
        }
        in_dimension!(forced::<T>(case))
    }

    fn expected(case: Case) -> Answer<Q> {
        let mut answer = Answer::expected_spline(case, "p", "U_out", "P_out");
        answer.knots.extend(case.get("changed").numbers::<Q>());
        answer
    }
}

#[test]
fn degree_reduction() {
    check::<Reduction>();
}

#[test]
fn knot_removal() {
    check::<Removal>();
}

#[test]
fn knot_removal_forced() {
    check::<Forced>();
}

/// With one equation in the middle it does not matter which side is kept, and the change is that of one basis function.
#[test]
fn the_middle_equation_is_left_out() {
    for_each("knot_removal_forced", 5, |case| {
        fn sides<T: Field, const N: usize>(
            case: Case,
        ) -> Result<[symspline::Dropped<T, nalgebra::SVector<T, N>>; 2]> {
            let (curve, index) = (case.curve::<T, N>("p")?, case.get("r").integer());
            Ok([curve.without_knot(index, Keep::Left)?, curve.without_knot(index, Keep::Right)?])
        }
        let [left, right] = sides::<Q, 2>(case)?;
        assert_eq!(left == right, case.get("variant").text() == "only", "{}", case.id());
        let curve = case.curve::<Q, 2>("p")?;
        assert!(left.bound >= curve.distance_bound(&left.spline)? && left.bound > Q::int(0));
        Ok(())
    });
}
