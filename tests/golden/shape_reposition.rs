//! Points moved by control points, and knots that place nodes and control points.

use crate::check::{Answer, Golden, check, for_each, row};
use crate::data::{Case, Field};
use symspline::{Direction, Drag, Error, LegPoint, NurbsCurve, Q, Result, ShapeError};

/// The rational curve of a case.
fn nurbs<T: Field>(case: Case) -> Result<NurbsCurve<T, 2>> {
    NurbsCurve::new(case.space("p", "U")?, case.get("P").points(), case.get("w").numbers())
}

/// The target of a case less the point of the curve at `u_bar`, and that parameter.
fn pull<T: Field>(case: Case, curve: &NurbsCurve<T, 2>) -> Result<(T, nalgebra::SVector<T, 2>)> {
    let u: T = case.get("u_bar").number();
    let target = nalgebra::SVector::from_vec(case.get("target").numbers());
    let by = target - curve.at(&u)?;
    Ok((u, by))
}

struct OneControl;

impl Golden for OneControl {
    const CATEGORY: &'static str = "move_one_control";
    const CASES: usize = 4;
    const FACTOR: f64 = 32.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let curve = nurbs::<T>(case)?;
        let (u, by) = pull(case, &curve)?;
        let drag = Drag::by_nearest(&curve, &u)?;
        assert_eq!(drag, Drag::by_one(&curve, &u, case.get("k").integer())?, "{}", case.id());
        let moved = drag.applied(&curve, &[by])?;
        Ok(Answer::rows(moved.points()?.into_iter().map(row).collect()))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(case.get("P_out").rows())
    }
}

struct TwoControls;

impl Golden for TwoControls {
    const CATEGORY: &'static str = "move_two_controls";
    const CASES: usize = 8;
    const FACTOR: f64 = 64.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let curve = nurbs::<T>(case)?;
        let (u, by) = pull(case, &curve)?;
        let gamma: T = case.get("gamma").number();
        let drag = if case.get("gamma_is_default").flag() {
            Drag::by_neighbours(&curve, &u, None)?
        } else {
            Drag::by_neighbours(&curve, &u, Some(&gamma))?
        };
        if T::EXACT {
            let k = case.get("k").integer();
            let shares = [(k, T::one() - &gamma), (k + 1, gamma)];
            assert_eq!(drag, Drag::by_shares(&curve, &u, &shares)?, "{}", case.id());
        }
        let moved = drag.applied(&curve, &[by])?;
        Ok(Answer::rows(moved.points()?.into_iter().map(row).collect()))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(case.get("P_out").rows())
    }
}

struct LegPoints;

impl Golden for LegPoints {
    const CATEGORY: &'static str = "inverse_knot_insertion";
    const CASES: usize = 2;
    const FACTOR: f64 = 64.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let curve = nurbs::<T>(case)?;
        let target = nalgebra::SVector::from_vec(case.get("target").numbers());
        let leg = LegPoint::at(&curve, Direction::U, case.get("k").integer(), &target, &T::frac(1, 1 << 30))?;
        let (finer, index) = leg.inserted(&curve)?;
        // Over floats the knot is rounded, so it is compared as a number.
        let numbers = [finer.space().knots().to_vec(), finer.weights().cloned().collect()].concat();
        let rows = finer.points()?.into_iter().map(row).chain([numbers, vec![leg.knot(&curve)?]]);
        Ok(Answer { integers: vec![index], knots: Vec::new(), rows: rows.collect() })
    }

    fn expected(case: Case) -> Answer<Q> {
        let mut rows: Vec<Vec<Q>> = case.get("P_out").rows();
        rows.push([case.get("U_out").numbers(), case.get("w_out").numbers()].concat());
        rows.push(vec![case.get("u_hat").number()]);
        Answer { integers: vec![case.get("index_out").integer()], knots: Vec::new(), rows }
    }
}

#[test]
fn move_one_control() {
    check::<OneControl>();
}

#[test]
fn move_two_controls() {
    check::<TwoControls>();
}

#[test]
fn inverse_knot_insertion() {
    check::<LegPoints>();
}

/// Where the knot is there already the library refuses, and names it.
#[test]
fn node_placing() {
    for_each("node_placing", 5, |case| {
        let space = case.space::<Q>("p", "U")?;
        let (u, knot): (Q, Q) = (case.get("u_bar").number(), case.get("u_hat").number());
        let k = case.get("k").integer();
        assert_eq!(space.greville(), case.get("nodes").numbers::<Q>(), "{}", case.id());
        assert_eq!(space.node_before(&u)?, k, "{}", case.id());
        match space.node_placing_knot(&u) {
            Err(Error::Shape(ShapeError::KnotThere { knot: named })) => {
                assert!(space.knots().contains(&knot), "{}", case.id());
                assert_eq!(named, knot.to_string());
            }
            found => assert_eq!(found?, Some(knot.clone()), "{}", case.id()),
        }
        let finer = space.refined(&[knot])?;
        assert_eq!(finer.knots().to_vec(), case.get("U_out").numbers::<Q>(), "{}", case.id());
        assert_eq!(finer.greville(), case.get("nodes_out").numbers::<Q>(), "{}", case.id());
        assert_eq!(finer.node(case.get("node_index").integer())?, u, "{}", case.id());
        Ok(())
    });
}
