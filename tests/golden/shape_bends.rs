//! Flattening and bending: projected points, bent points, ends carried along.

use crate::check::{Answer, Golden, check, row};
use crate::data::{Case, Field};
use nalgebra::SVector;
use symspline::{
    Axis, Bend, BendCentre, Bendable, Curve, Flatten, Onto, Q, Result, Rotation, Round, SplineSpace,
    bent_point,
};

/// The one point under a key.
fn point<T: Field, const N: usize>(case: Case, key: &str) -> SVector<T, N> {
    SVector::from_vec(case.get(key).numbers())
}

/// A curve with these control points, each of which is one of its points.
fn polygon<T: Field, const N: usize>(points: Vec<SVector<T, N>>) -> Result<Curve<T, N>> {
    Curve::new(SplineSpace::clamped(1, (0..points.len()).map(|i| T::int(i as i64)))?, points)
}

/// The control points of the polygon after flattening.
fn flattened<T: Field, const N: usize>(case: Case, onto: Onto<T, N>) -> Result<Answer<T>> {
    let flat = Flatten::new(onto).apply(&polygon(case.get("P").points())?)?;
    assert!(!T::EXACT || flat.flat.len() == 1, "{}", case.id());
    Ok(Answer::rows(flat.shape.into_coeffs().into_iter().map(row).collect()))
}

struct FlattenLine;

impl Golden for FlattenLine {
    const CATEGORY: &'static str = "flatten_line";
    const CASES: usize = 4;
    const FACTOR: f64 = 8.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        flattened(case, Onto::line_along(point(case, "Q"), point(case, "dir"), point(case, "W"))?)
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(case.get("P_out").rows())
    }
}

struct FlattenPlane;

impl Golden for FlattenPlane {
    const CATEGORY: &'static str = "flatten_plane";
    const CASES: usize = 2;
    const FACTOR: f64 = 8.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        flattened(case, Onto::plane_along(point(case, "Q"), point(case, "N"), point(case, "W"))?)
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(case.get("P_out").rows())
    }
}

struct BendPoint;

impl Golden for BendPoint {
    const CATEGORY: &'static str = "bend_point";
    const CASES: usize = 12;
    const FACTOR: f64 = 8.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let [s, lambda] = ["s", "lam"].map(|key| case.get(key).number());
        let bent = bent_point::<T, SVector<T, 2>>(&point(case, "O"), &point(case, "P"), &s, &lambda);
        Ok(Answer::rows(bent.into_iter().map(row).collect()))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(if case.refused("P_out") { Vec::new() } else { vec![case.get("P_out").numbers()] })
    }
}

struct BendCircle;

impl Golden for BendCircle {
    const CATEGORY: &'static str = "bend_circle";
    const CASES: usize = 3;
    const FACTOR: f64 = 16.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let (centre, start): (SVector<T, 2>, SVector<T, 2>) = (point(case, "O"), point(case, "P"));
        let round = Round(case.get("r").number::<T>());
        let share = round.share(&centre, &start)?.expect("a circle about the centre");
        let lambda: T = case.get("lam").number();
        let meeting = bent_point(&centre, &start, &share, &T::one()).expect("ratio one has no pole");
        let bent = Bend::new(centre, round, lambda).apply(&polygon(vec![start; 2])?)?;
        Ok(Answer::rows(vec![vec![share], row(meeting), row(bent.coeffs()[0].clone())]))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(vec![vec![case.get("s").number()], case.get("R").numbers(), case.get("P_out").numbers()])
    }
}

/// The points of the unbent tail.
fn rest<T: Field, const N: usize>(case: Case) -> Result<Answer<T>> {
    let [before, pivot, after, place] =
        ["P_t1", "P_t", "Phat_t1", "Phat_t"].map(|key| point::<T, N>(case, key));
    let leg = |a: &SVector<T, N>, b: &SVector<T, N>| SVector::from_fn(|i, _| b[i].clone() - &a[i]);
    let turn = Rotation::between(&leg(&before, &pivot), &leg(&after, &place))?;
    let carried = |p: SVector<T, N>| row(turn.carried(&p, &pivot, &place));
    Ok(Answer::rows(case.get("rest").points().into_iter().map(carried).collect()))
}

struct BendRest;

impl Golden for BendRest {
    const CATEGORY: &'static str = "bend_rest";
    const CASES: usize = 2;
    const FACTOR: f64 = 16.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        rest::<T, 2>(case)
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(case.get("rest_out").rows())
    }
}

struct BendRest3;

impl Golden for BendRest3 {
    const CATEGORY: &'static str = "bend_rest3";
    const CASES: usize = 1;
    const FACTOR: f64 = 16.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        rest::<T, 3>(case)
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(case.get("rest_out").rows())
    }
}

struct BendCylinder;

impl Golden for BendCylinder {
    const CATEGORY: &'static str = "bend_cylinder";
    const CASES: usize = 3;
    const FACTOR: f64 = 32.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let axis = Axis::<T, 3>::new(point(case, "Q"), point(case, "V"))?;
        let (start, round) = (point::<T, 3>(case, "P"), Round(case.get("r").number::<T>()));
        let centre = axis.centre_of(&start)?;
        let share = round.share(&centre, &start)?.expect("a cylinder about the axis");
        let meeting = bent_point(&centre, &start, &share, &T::one()).expect("ratio one has no pole");
        let bent = Bend::new(axis, round, case.get("lam").number::<T>()).apply(&polygon(vec![start; 2])?)?;
        Ok(Answer::rows(vec![row(centre), vec![share], row(meeting), row(bent.coeffs()[1].clone())]))
    }

    fn expected(case: Case) -> Answer<Q> {
        let numbers = |key: &str| case.get(key).numbers();
        Answer::rows(vec![numbers("O"), vec![case.get("s").number()], numbers("R"), numbers("P_out")])
    }
}

#[test]
fn flatten_line() {
    check::<FlattenLine>();
}

#[test]
fn flatten_plane() {
    check::<FlattenPlane>();
}

#[test]
fn bend_point() {
    check::<BendPoint>();
}

#[test]
fn bend_circle() {
    check::<BendCircle>();
}

#[test]
fn bend_rest() {
    check::<BendRest>();
}

#[test]
fn bend_rest3() {
    check::<BendRest3>();
}

#[test]
fn bend_cylinder() {
    check::<BendCylinder>();
}
