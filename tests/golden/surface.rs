//! Surfaces: the scaled surfaces of [Miura], by way of products, derivatives, antiderivatives, isocurves and sums.

use crate::check::{Answer, Golden, check, derivative_size, largest, row, shortest_span};
use crate::data::{Case, Field};
use symspline::Direction::{self, U, V};
use symspline::{Q, Result, SplineSpace, Surface, TensorSpline};

/// `S(a, c) + ∫ α S_u du` along the lower edge, then `+ ∫ α S_v dv` upwards.
fn along_u_then_v<T: Field>(s: &Surface<T, 3>, alpha: &TensorSpline<T>) -> Result<Surface<T, 3>> {
    let scaled = |direction: Direction| s.derivative(direction)?.times(alpha);
    let ((a, _), (c, d)) = (s.u().domain(), s.v().domain());
    let edge = scaled(U)?.isocurve(V, c)?.antiderivative()?.translated(&s.at(a, c)?)?;
    // The edge as a surface that is constant along v.
    let rest = SplineSpace::bezier(0, c.clone(), d.clone())?;
    let edge = TensorSpline::new(edge.space().clone(), rest, edge.into_coeffs())?;
    scaled(V)?.antiderivative(V)?.sum(&edge)
}

/// Knots of both directions and control points, row by row.
fn answer<T: Field>(surfaces: &[&Surface<T, 3>]) -> Answer<T> {
    let both = |s: &&Surface<T, 3>| [s.u().clone(), s.v().clone()];
    let spaces: Vec<SplineSpace<T>> = surfaces.iter().flat_map(both).collect();
    Answer {
        integers: spaces.iter().flat_map(|space| [space.degree(), space.dim()]).collect(),
        knots: spaces.iter().flat_map(|space| space.knots().to_vec()).collect(),
        rows: surfaces.iter().flat_map(|s| s.coeffs().iter().cloned().map(row)).collect(),
    }
}

/// The entries of the file that hold surfaces.
const SURFACES: [&str; 3] = ["T_uv", "T_vu", "T"];

struct Scaled;

impl Golden for Scaled {
    const CATEGORY: &'static str = "surface_T";
    const CASES: usize = 4;
    const FACTOR: f64 = 8.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let points = case.get("P").list().flat_map(|row| row.points::<T, 3>()).collect();
        let s = Surface::new(case.space("p", "U")?, case.space("q", "V")?, points)?;
        let scales = case.get("alpha").list().flat_map(|row| row.numbers::<T>()).collect();
        let spaces = (case.space("alpha_p", "alpha_U")?, case.space("alpha_q", "alpha_V")?);
        let alpha = TensorSpline::new(spaces.0, spaces.1, scales)?;

        let uv = along_u_then_v(&s, &alpha)?;
        let vu = along_u_then_v(&s.transposed(), &alpha.transposed())?.transposed();
        let mean = uv.sum(&vu)?.scaled(&T::frac(1, 2))?;
        let mut answer = answer(&[&uv, &vu, &mean]);
        for sample in case.get("samples").list() {
            let tangents = mean.tangents_at(&sample.get("u").number(), &sample.get("v").number())?;
            answer.rows.extend(tangents.map(row));
        }
        Ok(answer)
    }

    fn expected(case: Case) -> Answer<Q> {
        let mut expected = Answer::rows(Vec::new());
        for surface in SURFACES.map(|key| case.get(key)) {
            let net: Vec<Vec<Vec<Q>>> = surface.get("P").list().map(Case::rows).collect();
            expected.integers.extend([surface.get("p").integer(), net.len()]);
            expected.integers.extend([surface.get("q").integer(), net[0].len()]);
            expected.knots.extend(["U", "V"].map(|key| surface.get(key).numbers::<Q>()).concat());
            expected.rows.extend(net.concat());
        }
        for sample in case.get("samples").list() {
            expected.rows.extend(["T", "Tu", "Tv"].map(|key| sample.get(key).numbers()));
        }
        expected
    }

    /// The control points; for tangents what they may be at most.
    fn size(case: Case, expected: &Answer<Q>, k: usize) -> f64 {
        let samples = expected.rows.len() - 3 * case.get("samples").list().len();
        let points = largest(expected.rows[..samples].iter().flatten());
        let direction = k.checked_sub(samples).map(|row| row % 3);
        let side = |degree: &str, knots: &str| {
            let h = shortest_span(&case.get("T").get(knots).numbers::<Q>());
            derivative_size(points, case.get("T").get(degree).integer(), h, 1)
        };
        match direction {
            Some(1) => side("p", "U"),
            Some(2) => side("q", "V"),
            _ => points,
        }
    }
}

#[test]
#[expect(non_snake_case, reason = "the name of the category")]
fn surface_T() {
    check::<Scaled>();
}
