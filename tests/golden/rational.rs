//! Rational curves and surfaces: derivatives, basis functions, knot insertion.

use crate::check::{Answer, Golden, check, derivative_size, in_dimension, largest, row, shortest_span};
use crate::data::{Case, Field};
use symspline::{NurbsCurve, NurbsSurface, Q, RationalFunction, Result};

/// The rational curve of a case.
fn nurbs<T: Field, const N: usize>(case: Case) -> Result<NurbsCurve<T, N>> {
    NurbsCurve::new(case.space("p", "U")?, case.get("P").points(), case.get("w").numbers())
}

/// How large the derivative of order `k` may be at most: as of a spline, and once more for each order the proportion of the
/// weights.
fn size(size: f64, degree: usize, knots: &[Q], weights: &[Q], k: usize) -> f64 {
    let lowest = weights.iter().map(Q::to_f64).fold(f64::INFINITY, f64::min);
    let spread = largest(weights) / lowest;
    (0..k).fold(derivative_size(size, degree, shortest_span(knots), k), |size, _| size * spread)
}

struct Derivatives;

impl Golden for Derivatives {
    const CATEGORY: &'static str = "nurbs_ders";
    const CASES: usize = 6;
    const FACTOR: f64 = 8.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        fn derivatives<T: Field, const N: usize>(case: Case) -> Result<Answer<T>> {
            let (curve, u) = (nurbs::<T, N>(case)?, case.get("u").number());
            let all = curve.derivatives_at(&u, case.get("K").integer())?;
            assert_eq!(all.len(), case.get("K").integer() + 1, "{}", case.id());
            if T::EXACT {
                assert_eq!(curve.at(&u)?, all[0], "{}", case.id());
            }
            Ok(Answer::rows(all.into_iter().map(row).collect()))
        }
        in_dimension!(derivatives::<T>(case))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(case.get("ders").rows())
    }

    fn size(case: Case, _: &Answer<Q>, k: usize) -> f64 {
        let points = largest(case.get("P").rows::<Q>().iter().flatten());
        size(points, case.get("p").integer(), &case.get("U").numbers(), &case.get("w").numbers(), k)
    }
}

struct Basis;

impl Golden for Basis {
    const CATEGORY: &'static str = "nurbs_basis_ders";
    const CASES: usize = 5;
    const FACTOR: f64 = 8.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let (space, weights) = (case.space::<T>("p", "U")?, case.get("w").numbers::<T>());
        let one = RationalFunction::new(space, vec![T::one(); weights.len()], weights)?;
        let rows = one.basis_derivatives(&case.get("u").number(), case.get("K").integer())?;
        Ok(Answer {
            integers: rows.iter().map(|row| row.first() + one.degree()).collect(),
            knots: Vec::new(),
            rows: rows.iter().map(|row| row.weights().to_vec()).collect(),
        })
    }

    fn expected(case: Case) -> Answer<Q> {
        let rows: Vec<Vec<Q>> = case.get("ders").rows();
        Answer { integers: vec![case.get("span").integer(); rows.len()], knots: Vec::new(), rows }
    }

    /// Basis functions are at most one.
    fn size(case: Case, _: &Answer<Q>, k: usize) -> f64 {
        size(1.0, case.get("p").integer(), &case.get("U").numbers(), &case.get("w").numbers(), k)
    }
}

struct SurfaceDerivatives;

impl Golden for SurfaceDerivatives {
    const CATEGORY: &'static str = "nurbs_surface_ders";
    const CASES: usize = 2;
    const FACTOR: f64 = 8.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let points = case.get("P").list().flat_map(Case::points::<T, 3>).collect();
        let weights = case.get("w").rows().concat();
        let surface = NurbsSurface::new(case.space("p", "U")?, case.space("q", "V")?, points, weights)?;
        let (u, v) = (case.get("u").number(), case.get("v").number());
        let all = surface.derivatives_at(&u, &v, case.get("K").integer())?;
        Ok(Answer::rows(all.into_iter().flatten().map(row).collect()))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(case.get("ders").list().flat_map(Case::rows).collect())
    }

    /// Row `k` of the answer is the derivative of order `k / (K + 1)` in `u` and `k % (K + 1)` in `v`.
    fn size(case: Case, _: &Answer<Q>, k: usize) -> f64 {
        let points =
            largest(case.get("P").list().flat_map(Case::rows::<Q>).collect::<Vec<_>>().iter().flatten());
        let (across, weights) = (case.get("K").integer() + 1, case.get("w").rows().concat());
        let [(p, us), (q, vs)] =
            [("p", "U"), ("q", "V")].map(|(p, u)| (case.get(p).integer(), case.get(u).numbers::<Q>()));
        size(size(points, p, &us, &weights, k / across), q, &vs, &weights, k % across)
    }
}

struct Insertion;

impl Golden for Insertion {
    const CATEGORY: &'static str = "knot_insertion_rational";
    const CASES: usize = 1;
    const FACTOR: f64 = 4.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        fn insertion<T: Field, const N: usize>(case: Case) -> Result<Answer<T>> {
            let knots = case.get("insert").numbers::<T>();
            let refined = nurbs::<T, N>(case)?.through(|lifted| lifted.inserted(&knots))?;
            let weights = refined.weights().cloned().collect();
            let rows = refined.points()?.into_iter().map(row).chain([weights]).collect();
            Ok(Answer { integers: vec![refined.degree()], knots: refined.space().knots().to_vec(), rows })
        }
        in_dimension!(insertion::<T>(case))
    }

    fn expected(case: Case) -> Answer<Q> {
        let mut rows: Vec<Vec<Q>> = case.get("P_out").rows();
        rows.push(case.get("w_out").numbers());
        Answer { integers: vec![case.get("p").integer()], knots: case.get("U_out").numbers(), rows }
    }
}

#[test]
fn nurbs_ders() {
    check::<Derivatives>();
}

#[test]
fn nurbs_basis_ders() {
    check::<Basis>();
}

#[test]
fn nurbs_surface_ders() {
    check::<SurfaceDerivatives>();
}

#[test]
fn knot_insertion_rational() {
    check::<Insertion>();
}
