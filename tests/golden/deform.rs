//! Deformable splines: stiffness and forcing matrices, forces, points moved by forces.

use crate::check::{Answer, Golden, check, largest, row};
use crate::data::{Case, Field};
use nalgebra::{DMatrix, SVector};
use symspline::{
    Breadth, Curve, Elastic, Forces, Function, LinearMap, Material, Q, Result, SplineSpace, Stiffness,
    Surface,
};

fn rows<T: Field>(matrix: &DMatrix<T>) -> Vec<Vec<T>> {
    matrix.row_iter().map(|row| row.iter().cloned().collect()).collect()
}

/// `K0`, `K1`, `K2` one below the other, then `C`.
fn matrices<T: Field>(space: &SplineSpace<T>) -> Result<Vec<Vec<T>>> {
    let mut found = Vec::new();
    for order in 0..3 {
        let weights = (0..=order).map(|k| if k == order { T::one() } else { T::zero() });
        found.extend(rows(&Material::of_orders(weights)?.matrix(space)?.to_matrix()?));
    }
    let hard = Material::of_orders([T::one()])?;
    let forcing: LinearMap<T> = Stiffness::new(space, &hard, &Breadth::Whole)?.forcing().transpose();
    found.extend(rows(&forcing.to_matrix()?));
    Ok(found)
}

/// The largest number of one row.
fn own_size(expected: &Answer<Q>, k: usize) -> f64 {
    largest(&expected.rows[k])
}

struct Matrices;

impl Golden for Matrices {
    const CATEGORY: &'static str = "vassilev_matrices";
    const CASES: usize = 4;
    const FACTOR: f64 = 16.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let space = case.space::<T>("p", "U")?;
        let knots = space.breaks().into_iter().map(|(knot, _)| knot).collect();
        Ok(Answer { integers: Vec::new(), knots, rows: matrices(&space)? })
    }

    fn expected(case: Case) -> Answer<Q> {
        let rows = ["K0", "K1", "K2", "C"].map(|key| case.get(key).rows()).concat();
        Answer { integers: Vec::new(), knots: case.get("breaks").numbers(), rows }
    }

    fn size(_: Case, expected: &Answer<Q>, k: usize) -> f64 {
        own_size(expected, k)
    }
}

#[test]
fn vassilev_matrices() {
    check::<Matrices>();
}

struct Segment;

impl Golden for Segment {
    const CATEGORY: &'static str = "vassilev_segment";
    const CASES: usize = 1;
    const FACTOR: f64 = 16.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let (p, h) = (case.get("p").integer(), case.get("h").number::<T>());
        let space = SplineSpace::new(p, (0..2 * p as i64 + 2).map(|i| T::int(i) * &h))?;
        Ok(Answer::rows(matrices(&space)?))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(["K0s", "K1s", "K2s", "Cs"].map(|key| case.get(key).rows()).concat())
    }
}

#[test]
fn vassilev_segment() {
    check::<Segment>();
}

/// The material under the keys `gamma`, `alpha` and `beta`.
fn material<T: Field>(case: Case) -> Result<Material<T>> {
    Material::of_orders(["gamma", "alpha", "beta"].map(|key| case.get(key).number::<T>()))
}

fn window<T>(case: Case, key: &str) -> Breadth<T> {
    Breadth::Listed(case.get(key).list().map(Case::integer).collect())
}

struct Moved;

impl Golden for Moved {
    const CATEGORY: &'static str = "vassilev_move";
    const CASES: usize = 3;
    const FACTOR: f64 = 256.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let mut curve = Curve::<T, 2>::new(case.space("p", "U")?, case.get("P").points())?;
        let stiffness = Stiffness::new(curve.space(), &material(case)?, &window(case, "window"))?;
        let at = case.get("u_f").number::<T>();
        let load = stiffness.hat_load(&at)?.to_dense(curve.space().dim());
        let elastic = Elastic::curve(stiffness);
        let pull = elastic.pull(&curve, &at)?;
        let response = pull.response().rows().map(|row| row[0].clone()).collect();
        let target = SVector::from_vec(case.get("target").numbers::<T>());
        let force = pull.move_to(&mut curve, &target)?;
        let mut rows = vec![load, response, row(force)];
        rows.extend(curve.into_coeffs().into_iter().map(row));
        Ok(Answer { integers: pull.response().indices().to_vec(), knots: Vec::new(), rows })
    }

    fn expected(case: Case) -> Answer<Q> {
        let mut rows: Vec<Vec<Q>> = ["C_f", "V_c", "force"].map(|key| case.get(key).numbers()).to_vec();
        rows.extend(case.get("P_out").rows());
        Answer { integers: case.get("window").list().map(Case::integer).collect(), knots: Vec::new(), rows }
    }

    fn size(_: Case, expected: &Answer<Q>, k: usize) -> f64 {
        if k < 3 { own_size(expected, k) } else { largest(expected.rows[3..].iter().flatten()) }
    }
}

#[test]
fn vassilev_move() {
    check::<Moved>();
}

struct Pushed;

impl Golden for Pushed {
    const CATEGORY: &'static str = "vassilev_forces";
    const CASES: usize = 1;
    const FACTOR: f64 = 64.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let space = case.space::<T>("p", "U")?;
        let curve = Curve::<T, 2>::constant(space, nalgebra::vector![T::zero(), T::zero()])?;
        let elastic = Elastic::of(&curve, &material(case)?, &[window(case, "window")])?;
        let mut forces = Forces::new(&elastic, &curve)?;
        let moved = forces.at_breaks(&case.get("dF").points())?.displacements()?;
        let (integers, points): (Vec<usize>, Vec<_>) = moved.into_iter().unzip();
        Ok(Answer { integers, knots: Vec::new(), rows: points.into_iter().map(row).collect() })
    }

    fn expected(case: Case) -> Answer<Q> {
        let integers = case.get("window").list().map(Case::integer).collect();
        Answer { integers, knots: Vec::new(), rows: case.get("dV").rows() }
    }
}

#[test]
fn vassilev_forces() {
    check::<Pushed>();
}

struct SurfaceMoved;

impl Golden for SurfaceMoved {
    const CATEGORY: &'static str = "vassilev_surface_move";
    const CASES: usize = 2;
    const FACTOR: f64 = 1024.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let points = case.get("P").list().flat_map(|row| row.points::<T, 3>()).collect();
        let mut surface = Surface::new(case.space("p", "U")?, case.space("q", "V")?, points)?;
        let along = |space: &SplineSpace<T>, coeff: &str, key: &str| {
            Stiffness::new(space, &material(case.get(coeff))?, &window(case, key))
        };
        let u = along(surface.u(), "coeff_u", "window_u")?;
        let v = along(surface.v(), "coeff_v", "window_v")?;
        let at = (case.get("u_f").number::<T>(), case.get("v_f").number::<T>());
        let answer = |along: &Stiffness<T>, x: &T| -> Result<Vec<T>> {
            let answer = Function::new(along.space().clone(), along.response(&along.hat_load(x)?)?)?;
            Ok(along.moving().iter().map(|i| answer.coeffs()[*i].clone()).collect())
        };
        let mut rows = vec![answer(&u, &at.0)?, answer(&v, &at.1)?];
        let pull = Elastic::surface(u, v).pull(&surface, &at)?;
        let target = SVector::from_vec(case.get("target").numbers::<T>());
        rows.push(row(pull.move_to(&mut surface, &target)?));
        rows.extend(surface.into_coeffs().into_iter().map(row));
        Ok(Answer::rows(rows))
    }

    fn expected(case: Case) -> Answer<Q> {
        let mut rows: Vec<Vec<Q>> = ["V_u", "V_v", "force"].map(|key| case.get(key).numbers()).to_vec();
        rows.extend(case.get("P_out").list().flat_map(Case::rows));
        Answer::rows(rows)
    }

    fn size(case: Case, expected: &Answer<Q>, k: usize) -> f64 {
        Moved::size(case, expected, k)
    }
}

#[test]
fn vassilev_surface_move() {
    check::<SurfaceMoved>();
}
