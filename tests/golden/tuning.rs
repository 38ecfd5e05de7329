//! Fine tuning of curves: scaled derivatives, and ends put back.

use crate::check::{
    Answer, Golden, check, check_floats, derivative_size, for_each, in_dimension, largest, row, shortest_span,
};
use crate::data::{Case, Field};
use nalgebra::SVector;
use std::cell::Cell;
use symspline::{Curve, Error, Function, Hold, Q, Result, Scale, SplineSpace, Turnable};

/// Degree, knots `W` and control points `Q`; then three rows a sample: `D`, `D'`, `D''`.
struct FineTune;

impl Golden for FineTune {
    const CATEGORY: &'static str = "fine_tune";
    const CASES: usize = 10;
    const FACTOR: f64 = 8.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        fn tuned<T: Field, const N: usize>(case: Case) -> Result<Answer<T>> {
            let tuned = case.curve::<T, N>("n")?.fine_tuned(Scale::Signed(&case.function("alpha")?))?;
            let mut answer = Answer::spline(&tuned);
            for sample in case.get("samples").list() {
                answer.rows.extend(tuned.derivatives_at(&sample.get("t").number(), 2)?.into_iter().map(row));
            }
            Ok(answer)
        }
        in_dimension!(tuned::<T>(case))
    }

    fn expected(case: Case) -> Answer<Q> {
        let mut answer = Answer::expected_spline(case, "degree", "W", "Q");
        for sample in case.get("samples").list() {
            answer.rows.extend(["D", "D1", "D2"].map(|order| sample.get(order).numbers()));
        }
        answer
    }

    /// The control points of `D`; for its derivatives those of `C` times `α`, differentiated as often.
    fn size(_: Case, expected: &Answer<Q>, k: usize) -> f64 {
        let controls = expected.integers[1];
        let points = largest(expected.rows[..controls].iter().flatten());
        let h = shortest_span(&expected.knots);
        match k.checked_sub(controls) {
            None => points,
            Some(row) => derivative_size(points, expected.integers[0], h, row % 3),
        }
    }
}

/// What the file says the end condition holds.
fn hold(case: Case) -> Hold {
    match case.get("j").integer() {
        0 => Hold::Points,
        1 => Hold::Tangents,
        2 => Hold::Curvatures,
        j => panic!("no end condition {j}"),
    }
}

/// Curve and scale function of a case.
fn given<T: Field, const N: usize>(case: Case) -> Result<(Curve<T, N>, Function<T>)> {
    Ok((case.curve("n")?, case.function("alpha")?))
}

/// Free result and invariant curve, which need no square roots: both over the same knots.
fn free_and_invariant<T: Field, const N: usize>(case: Case) -> Result<[Answer<T>; 2]> {
    let (curve, alpha) = given::<T, N>(case)?;
    let free = curve.fine_tuned(Scale::Signed(&alpha))?;
    let invariant = curve.embedded(free.space())?;
    Ok([&free, &invariant].map(Answer::spline))
}

/// The result with its ends put back, or the refusal the file asks for.
fn held<T: Field, const N: usize>(case: Case) -> Result<Option<Answer<T>>>
where
    SVector<T, N>: Turnable<T>,
{
    let (curve, alpha) = given::<T, N>(case)?;
    let held = curve.fine_tuned_holding(Scale::Signed(&alpha), hold(case));
    if case.refused("Q") {
        assert_eq!(held.err(), Some(Error::NoChord), "{}", case.id());
        return Ok(None);
    }
    held.map(|held| Some(Answer::spline(&held.curve)))
}

#[test]
fn fine_tune() {
    check::<FineTune>();
}

/// What the file has under `key`: degree, knots `W` and control points.
fn expected(case: Case, key: &str) -> Answer<Q> {
    Answer::expected_spline(case, "degree", "W", key)
}

/// Over `Q` with `==`: all three curves in the plane, the first two in space, where the third has square roots.
#[test]
fn fine_tune_end_exact() {
    let refused = Cell::new(0);
    for_each("fine_tune_end", 14, |case| {
        let id = case.id();
        let [free, invariant] = in_dimension!(free_and_invariant::<Q>(case))?;
        assert_eq!(free, expected(case, "Q_free"), "{id} free (found on the left)");
        assert_eq!(invariant, expected(case, "I"), "{id} invariant (found on the left)");
        if case.dimension() == 2 {
            match held::<Q, 2>(case)? {
                Some(found) => assert_eq!(found, expected(case, "Q"), "{id} held (found on the left)"),
                None => refused.set(refused.get() + 1),
            }
        }
        Ok(())
    });
    assert_eq!(refused.get(), 1);
}

/// Over `f64` all of them, in plane and space; the bound scales with the largest coordinate of the controls.
#[test]
fn fine_tune_end_floats() {
    const FACTOR: f64 = 16.0;
    let (held_ones, refused) = (Cell::new(0), Cell::new(0));
    for_each("fine_tune_end", 14, |case| {
        let compare = |found: &Answer<f64>, key: &str| {
            let expected = expected(case, key);
            let size = largest(expected.rows.iter().flatten());
            check_floats(&format!("{} {key}", case.id()), found, &expected, FACTOR, |_| size);
        };
        let [free, invariant] = in_dimension!(free_and_invariant::<f64>(case))?;
        compare(&free, "Q_free");
        compare(&invariant, "I");
        let found = if case.dimension() == 2 { held::<f64, 2>(case)? } else { held::<f64, 3>(case)? };
        match found {
            Some(found) => {
                compare(&found, "Q");
                held_ones.set(held_ones.get() + 1);
            }
            None => refused.set(refused.get() + 1),
        }
        Ok(())
    });
    assert_eq!((held_ones.get(), refused.get()), (13, 1));
}

/// The portion as it was, and tuned, over both knot vectors; then each sample twice, of the portion and of the whole.
struct LocalFineTune;

impl Golden for LocalFineTune {
    const CATEGORY: &'static str = "local_fine_tune";
    const CASES: usize = 2;
    const FACTOR: f64 = 8.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let (curve, alpha) = given::<T, 2>(case)?;
        let (a, b) = (case.get("a").number::<T>(), case.get("b").number());
        assert_eq!(alpha.domain(), (&a, &b), "{}", case.id());
        let local = curve.fine_tuned_on(Scale::Signed(&alpha), hold(case))?;
        let mut answer = Answer::spline(&curve.restricted(&a, &b)?);
        let tuned = Answer::spline(&local.tuned().curve);
        answer.integers.extend(tuned.integers);
        answer.knots.extend(tuned.knots);
        answer.rows.extend(tuned.rows);
        let whole = local.joined()?;
        for sample in case.get("samples").list() {
            let t = sample.get("t").number();
            answer.rows.extend([row(local.tuned().curve.at(&t)?), row(whole.at(&t)?)]);
        }
        Ok(answer)
    }

    fn expected(case: Case) -> Answer<Q> {
        let mut answer = Answer::expected_spline(case, "n", "segment_U", "segment_P");
        let tuned = expected(case, "Q");
        answer.integers.extend(tuned.integers);
        answer.knots.extend(tuned.knots);
        answer.rows.extend(tuned.rows);
        for sample in case.get("samples").list() {
            answer.rows.extend([sample.get("point").numbers(), sample.get("point").numbers()]);
        }
        answer
    }
}

#[test]
fn local_fine_tune() {
    check::<LocalFineTune>();
}

/// A held curve needs a control point on either side of the matched ones.
#[test]
fn too_few_control_points_are_refused() {
    let segment = SplineSpace::bezier(1, Q::from(0), Q::from(1)).unwrap();
    let points = [[0, 0], [1, 2]].map(|point| SVector::from(point.map(Q::from))).to_vec();
    let line = Curve::new(segment, points).unwrap();
    let alpha =
        Function::constant(SplineSpace::bezier(0, Q::from(0), Q::from(1)).unwrap(), Q::from(2)).unwrap();
    let error = line.fine_tuned_holding(Scale::Signed(&alpha), Hold::Curvatures).unwrap_err();
    assert_eq!(error, Error::CoefficientCount { expected: 6, found: 2 });
}
