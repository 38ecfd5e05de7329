//! Warps: free control points, removable knots, warping functions, and a warped curve.

use crate::check::{Answer, Golden, check, for_each};
use crate::data::{Case, Field};
use nalgebra::SVector;
use symspline::{Bump, Curve, Keep, Q, Region, Result, Scalar, Warp};

struct LocalRange;

impl Golden for LocalRange {
    const CATEGORY: &'static str = "local_range";
    const CASES: usize = 5;
    const FACTOR: f64 = 0.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let (space, start, end) =
            (case.space::<T>("p", "U")?, case.get("u_s").number(), case.get("u_e").number());
        let free = space.local_coeffs(&start, &end)?;
        let mut integers = vec![free.start, free.end + space.degree()];
        integers.extend(free);
        let [left, right] = [Keep::Left, Keep::Right].map(|keep| space.removable_knots(&start, &end, keep));
        let (left, right) = (left?, right?);
        let either = left.start.max(right.start)..left.end.min(right.end);
        let has_ranges = case.has("removable") || case.has("removable_either");
        for range in [left, right, either].into_iter().filter(|_| has_ranges) {
            integers.extend(if range.is_empty() { [0, 0] } else { [range.start, range.end - 1] });
        }
        Ok(Answer { integers, knots: Vec::<T>::new(), rows: Vec::new() })
    }

    fn expected(case: Case) -> Answer<Q> {
        let indices = |key: &str| case.get(key).list().map(Case::integer).collect::<Vec<_>>();
        let mut integers = vec![case.get("s").integer(), case.get("e").integer()];
        integers.extend(indices("free"));
        let keys = if case.get("p").integer() % 2 == 1 {
            ["removable"; 3]
        } else {
            ["removable_keep_left", "removable_keep_right", "removable_either"]
        };
        // Where knots are not simple the file says nothing.
        for key in keys.into_iter().filter(|key| case.has(key)) {
            let range = if case.refused(key) { Vec::new() } else { indices(key) };
            integers.extend(if range.is_empty() { vec![0, 0] } else { range });
        }
        Answer { integers, knots: Vec::new(), rows: Vec::new() }
    }
}

struct OneBump;

impl Golden for OneBump {
    const CATEGORY: &'static str = "warp_f";
    const CASES: usize = 8;
    const FACTOR: f64 = 8.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        Ok(Answer::rows(vec![vec![Bump::new(case.get("w3").number::<T>())?.at(&case.get("t").number())]]))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(vec![vec![case.get("f").number()]])
    }
}

struct TwoBump;

impl Golden for TwoBump {
    const CATEGORY: &'static str = "warp_f2";
    const CASES: usize = 8;
    const FACTOR: f64 = 8.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let bump = Bump::new(case.get("w33").number::<T>())?;
        Ok(Answer::rows(vec![vec![bump.at_pair(&(case.get("s").number(), case.get("t").number()))]]))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(vec![vec![case.get("f").number()]])
    }
}

struct WarpedCurve;

/// The curve, the region, the profile and the vector of a case.
type Parts<T> = (Curve<T, 2>, Region<T>, Bump<T>, SVector<T, 2>);

fn parts<T: Field>(case: Case) -> Result<Parts<T>> {
    let region = Region::new(case.get("u_s").number::<T>(), case.get("u_e").number());
    let vector = SVector::from_vec(case.get("W").numbers::<T>()) * case.get("d").number::<T>();
    Ok((case.curve("p")?, region, Bump::new(case.get("w3").number())?, vector))
}

impl Golden for WarpedCurve {
    const CATEGORY: &'static str = "warp_curve";
    const CASES: usize = 1;
    const FACTOR: f64 = 16.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let (curve, region, bump, vector) = parts::<T>(case)?;
        let warp = Warp::along(region, |at| bump.at(&at.share), vector);
        let warped = warp.apply_with(&curve, |_, _| Ok(vec![case.get("t").numbers()]))?;
        assert_eq!((warped.moved, warped.inserted.len()), (case.get("t").list().len(), 0));
        Ok(Answer::spline(&warped.shape))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::expected_spline(case, "p", "U", "P_out")
    }
}

#[test]
fn local_range() {
    check::<LocalRange>();
}

#[test]
fn warp_f() {
    check::<OneBump>();
}

#[test]
fn warp_f2() {
    check::<TwoBump>();
}

#[test]
fn warp_curve() {
    check::<WarpedCurve>();
}

/// The lengths of the control polygon give the parameters of the file.
#[test]
fn lengths_of_chords() {
    for_each("warp_curve", 1, |case| {
        let (curve, region, bump, vector) = parts::<f64>(case)?;
        let by_chords = Warp::along(region, |at| bump.at(&at.share), vector).apply_by_chords(&curve)?;
        let expected = WarpedCurve::found::<f64>(case)?;
        for (found, expected) in Answer::spline(&by_chords.shape).rows.iter().zip(&expected.rows) {
            assert!(found.iter().zip(expected).all(|(x, y)| (x - y).abs() < 1e-13), "{}", case.id());
        }
        Ok(())
    });
}

/// The unit of the bump is the maximum of the basis function, which the file states.
#[test]
fn tops_of_bumps() {
    for_each("warp_f", 8, |case| {
        let [w, n, top] = ["w3", "N", "R_max"].map(|key| case.get(key).number::<Q>());
        let rational = n.clone() * &w / (Q::int(1) + (w - Q::int(1)) * n);
        assert_eq!(rational / top, case.get("f").number::<Q>(), "{}", case.id());
        Ok(())
    });
}
