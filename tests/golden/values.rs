//! Values, derivatives and integrals.

use crate::check::{Answer, Golden, check, derivative_size, in_dimension, largest, row, shortest_span};
use crate::data::{Case, Field};
use symspline::{Q, Result};

struct Basis;

impl Golden for Basis {
    const CATEGORY: &'static str = "basis";
    const CASES: usize = 22;
    const FACTOR: f64 = 4.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let (space, u) = (case.space::<T>("p", "U")?, case.get("u").number());
        let rows = space.basis_derivatives(&u, case.get("K").integer())?;
        assert_eq!(space.basis(&u)?, rows[0], "{}", case.id());
        let firsts = rows.iter().map(|row| row.first());
        Ok(Answer {
            integers: [space.locate(&u)?].into_iter().chain(firsts).collect(),
            knots: space.knots().to_vec(),
            rows: rows.iter().map(|row| row.weights().to_vec()).collect(),
        })
    }

    fn expected(case: Case) -> Answer<Q> {
        let (span, p, rows) = (case.get("span").integer(), case.get("p").integer(), case.get("ders").rows());
        let firsts = rows.iter().map(|_: &Vec<Q>| span - p);
        let integers = [span].into_iter().chain(firsts).collect();
        Answer { integers, knots: case.get("U").numbers(), rows }
    }

    /// Basis functions are at most one.
    fn size(case: Case, _: &Answer<Q>, k: usize) -> f64 {
        derivative_size(1.0, case.get("p").integer(), shortest_span(&case.get("U").numbers::<Q>()), k)
    }
}

struct CurveDerivatives;

impl Golden for CurveDerivatives {
    const CATEGORY: &'static str = "curve_ders";
    const CASES: usize = 3;
    const FACTOR: f64 = 4.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        fn derivatives<T: Field, const N: usize>(case: Case) -> Result<Answer<T>> {
            let (curve, u) = (case.curve::<T, N>("p")?, case.get("u").number());
            let all = curve.derivatives_at(&u, case.get("K").integer())?;
            for (k, one) in all.iter().enumerate() {
                assert_eq!(curve.derivative_at(&u, k)?, *one, "{} order {k}", case.id());
            }
            Ok(Answer::rows(all.into_iter().map(row).collect()))
        }
        in_dimension!(derivatives::<T>(case))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(case.get("ders").rows())
    }

    fn size(case: Case, _: &Answer<Q>, k: usize) -> f64 {
        let h = shortest_span(&case.get("U").numbers::<Q>());
        derivative_size(points_size(case), case.get("p").integer(), h, k)
    }
}

struct DefiniteIntegral;

impl Golden for DefiniteIntegral {
    const CATEGORY: &'static str = "definite_integral";
    const CASES: usize = 10;
    const FACTOR: f64 = 4.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        fn integral<T: Field, const N: usize>(case: Case) -> Result<Answer<T>> {
            let curve = case.curve::<T, N>("p")?;
            let value = curve.integral_between(&case.get("a").number(), &case.get("b").number())?;
            Ok(Answer::rows(vec![row(value)]))
        }
        in_dimension!(integral::<T>(case))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(vec![case.get("value").numbers()])
    }

    /// The integral of the largest coefficient over the domain, from whose parts the value is a difference.
    fn size(case: Case, _: &Answer<Q>, _: usize) -> f64 {
        let knots: Vec<Q> = case.get("U").numbers();
        points_size(case) * (knots[knots.len() - 1].clone() - &knots[0]).to_f64()
    }
}

struct Gram;

impl Golden for Gram {
    const CATEGORY: &'static str = "gram";
    const CASES: usize = 9;
    const FACTOR: f64 = 8.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let (left, right) = (case.space::<T>("p", "U")?, case.space("p2", "U2")?);
        let [k, k2] = ["k", "k2"].map(|key| case.get(key).integer());
        let map = left.gram_between(&right, k, k2, &case.get("a").number(), &case.get("b").number())?;
        let matrix = map.to_matrix()?;
        Ok(Answer::rows(matrix.row_iter().map(|row| row.iter().cloned().collect()).collect()))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(case.get("matrix").rows())
    }
}

/// The largest coordinate of the control points.
fn points_size(case: Case) -> f64 {
    largest(case.get("P").rows::<Q>().iter().flatten())
}

#[test]
fn basis() {
    check::<Basis>();
}

#[test]
fn curve_ders() {
    check::<CurveDerivatives>();
}

#[test]
fn definite_integral() {
    check::<DefiniteIntegral>();
}

#[test]
fn gram() {
    check::<Gram>();
}
