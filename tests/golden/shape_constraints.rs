//! Constraints on curves and surfaces, and least movements for given rows.

use crate::check::{Answer, Golden, check, for_each, row};
use crate::data::{Case, Field};
use nalgebra::SVector;
use symspline::{
    Constrained, Constraints, Controlled, Curve, Error, Function, NurbsCurve, NurbsSurface, Q, Result,
    ShapeError, SparseRow, SplineSpace, Surface,
};

/// The rows of `B` and of `A` at some control points, zero where nothing moves.
fn matrices<T: Field, S: Controlled<T>>(held: &Constrained<T, S>, free: &[usize]) -> Vec<Vec<T>> {
    let b = held
        .rows()
        .map(|row| free.iter().map(|i| row.weight(*i).cloned().unwrap_or_else(T::zero)).collect::<Vec<T>>());
    let found: Vec<(usize, &[T])> =
        held.matrix().indices().iter().copied().zip(held.matrix().rows()).collect();
    assert!(found.iter().all(|(i, _)| free.contains(i)), "only free control points move");
    let zero = || vec![T::zero(); held.matrix().columns()];
    let a = free
        .iter()
        .map(|i| found.iter().find(|(index, _)| index == i).map_or_else(zero, |(_, row)| row.to_vec()));
    b.chain(a).collect()
}

/// The constraints of a case on a curve, and where the points go.
fn on_curve<T: Field, S, const N: usize>(case: Case, shape: &S) -> Result<Vec<Vec<T>>>
where
    S: Controlled<T, Parameter = T, Order = usize, Index = usize, Point = SVector<T, N>>,
{
    let free: Vec<usize> = case.get("free").list().map(Case::integer).collect();
    let mut wanted = Constraints::on(shape).freeing(&free)?;
    for constraint in case.get("constraints").list() {
        let [u, k] = &constraint.list().collect::<Vec<_>>()[..] else { panic!("place and order") };
        wanted = wanted.derivative(&u.number(), k.integer())?;
    }
    let held = wanted.prepare()?;
    let mut rows = matrices(&held, &free);
    if case.has("P_out") {
        let moved = held.dragged(shape, &case.get("dD").points())?;
        rows.extend(moved.control_points()?.into_iter().map(row));
    }
    Ok(rows)
}

/// The answer for the curve of a case: polynomial or rational, with points or without.
fn curve_rows<T: Field>(case: Case) -> Result<Vec<Vec<T>>> {
    let space: SplineSpace<T> = case.space("p", "U")?;
    let points: Vec<SVector<T, 2>> =
        if case.has("P") { case.get("P").points() } else { vec![SVector::zeros(); space.dim()] };
    if case.refused("w") {
        on_curve(case, &Curve::new(space, points)?)
    } else {
        on_curve(case, &NurbsCurve::new(space, points, case.get("w").numbers())?)
    }
}

/// `B`, `A` and what comes out, as the file gives them.
fn expected_rows(case: Case) -> Vec<Vec<Q>> {
    let mut rows: Vec<Vec<Q>> = case.get("B").rows();
    rows.extend(case.get("A").rows());
    rows
}

#[test]
fn constraint_curve() {
    for_each("constraint_curve", 10, |case| {
        if case.refused("A") {
            let refused = curve_rows::<Q>(case);
            assert!(
                matches!(refused, Err(Error::Shape(ShapeError::Overdetermined { .. }))),
                "{}: {refused:?}",
                case.id()
            );
            return Ok(());
        }
        let mut expected = expected_rows(case);
        if case.has("P_out") {
            expected.extend(case.get("P_out").rows());
        }
        assert_eq!(curve_rows::<Q>(case)?, expected, "{} (found on the left)", case.id());
        let size = crate::check::largest(expected.iter().flatten());
        for (k, (found, expected)) in curve_rows::<f64>(case)?.iter().zip(&expected).enumerate() {
            crate::check::check_row(&format!("{}, row {k}", case.id()), found, expected, size, 256.0);
        }
        Ok(())
    });
}

/// The answer for the surface of a case; the file counts control points the other way round.
fn on_surface<T: Field, S>(case: Case, shape: &S, [n, m]: [usize; 2]) -> Result<Vec<Vec<T>>>
where
    S: Controlled<
            T,
            Parameter = (T, T),
            Order = (usize, usize),
            Index = (usize, usize),
            Point = SVector<T, 3>,
        >,
{
    let fixed = case.get("fixed").list().map(|index| {
        let [i, j] = index.list().map(Case::integer).collect::<Vec<_>>()[..] else { panic!("two indices") };
        (i, j)
    });
    let mut wanted = Constraints::on(shape).holding(&fixed.collect::<Vec<_>>())?;
    for constraint in case.get("constraints").list() {
        let [u, v, k, l] = &constraint.list().collect::<Vec<_>>()[..] else { panic!("place and orders") };
        wanted = wanted.derivative(&(u.number(), v.number()), (k.integer(), l.integer()))?;
    }
    let held = wanted.prepare()?;
    let place = |s: usize| (s % n) * m + s / n;
    let free: Vec<usize> = case.get("CpInd").list().map(|s| place(s.integer())).collect();
    let mut rows = matrices(&held, &free);
    let moved = held.dragged(shape, &case.get("dD").points())?;
    rows.extend(moved.control_points()?.into_iter().map(row));
    Ok(rows)
}

struct OnSurface;

impl Golden for OnSurface {
    const CATEGORY: &'static str = "constraint_surface";
    const CASES: usize = 3;
    const FACTOR: f64 = 256.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let (u, v) = (case.space("p", "U")?, case.space("q", "V")?);
        let points = case.get("P").list().flat_map(Case::points::<T, 3>).collect();
        let dims = [u.dim(), v.dim()];
        let rows = if case.refused("w") {
            on_surface(case, &Surface::new(u, v, points)?, dims)?
        } else {
            on_surface(case, &NurbsSurface::new(u, v, points, case.get("w").rows().concat())?, dims)?
        };
        Ok(Answer::rows(rows))
    }

    fn expected(case: Case) -> Answer<Q> {
        let mut rows = expected_rows(case);
        rows.extend(case.get("P_out").list().flat_map(Case::rows::<Q>));
        Answer::rows(rows)
    }
}

#[test]
fn constraint_surface() {
    check::<OnSurface>();
}

struct Fowler;

impl Golden for Fowler {
    const CATEGORY: &'static str = "fowler";
    const CASES: usize = 6;
    const FACTOR: f64 = 64.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let f: Vec<Vec<T>> = case.get("F").rows();
        // Any space with as many coefficients.
        let space = SplineSpace::bezier(f[0].len() - 1, T::zero(), T::one())?;
        let zero = Curve::<T, 2>::constant(space.clone(), SVector::zeros())?;
        let mut wanted = Constraints::on(&zero);
        for row in &f {
            wanted = wanted.row(SparseRow::new(row.iter().cloned().enumerate()))?;
        }
        let moved = wanted.prepare()?.dragged(&zero, &case.get("b").points())?;
        // F d = b, by the functional itself.
        if T::EXACT {
            for (i, coefficients) in f.iter().enumerate() {
                let found =
                    Function::new(space.clone(), moved.coeffs().iter().map(|d| d[0].clone()).collect())?;
                let value = T::dot(coefficients.iter().zip(found.coeffs()));
                assert_eq!(value, case.get("b").points::<T, 2>()[i][0], "{}", case.id());
            }
        }
        Ok(Answer::rows(moved.into_coeffs().into_iter().map(row).collect()))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(case.get("d").rows())
    }
}

#[test]
fn fowler() {
    check::<Fowler>();
}
