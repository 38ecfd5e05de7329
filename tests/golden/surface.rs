//! Fine-tuned surfaces: along one path and two, with boundaries held by similarities, or by the scale alone.

use crate::check::{Answer, Golden, check, derivative_size, largest, row, shortest_span};
use crate::data::{Case, Field};
use nalgebra::SVector;
use symspline::Direction::{U, V};
use symspline::{Edge, Edges, Fit, Path, Q, Result, Scale, SplineSpace, Surface, TensorSpline};

/// Knots of both directions and control points, row by row.
fn answer<T: Field, const N: usize>(surfaces: &[&Surface<T, N>]) -> Answer<T> {
    let both = |s: &&Surface<T, N>| [s.u().clone(), s.v().clone()];
    let spaces: Vec<SplineSpace<T>> = surfaces.iter().flat_map(both).collect();
    Answer {
        integers: spaces.iter().flat_map(|space| [space.degree(), space.dim()]).collect(),
        knots: spaces.iter().flat_map(|space| space.knots().to_vec()).collect(),
        rows: surfaces.iter().flat_map(|s| s.coeffs().iter().cloned().map(row)).collect(),
    }
}

/// The entries of the file that hold surfaces.
const SURFACES: [&str; 3] = ["T_uv", "T_vu", "T"];

/// Surface and scale function of a case.
fn given<T: Field, const N: usize>(case: Case) -> Result<(Surface<T, N>, TensorSpline<T>)> {
    let points = case.get("P").list().flat_map(|row| row.points::<T, N>()).collect();
    let s = Surface::new(case.space("p", "U")?, case.space("q", "V")?, points)?;
    let scales = case.get("alpha").list().flat_map(|row| row.numbers::<T>()).collect();
    let spaces = (case.space("alpha_p", "alpha_U")?, case.space("alpha_q", "alpha_V")?);
    Ok((s, TensorSpline::new(spaces.0, spaces.1, scales)?))
}

/// The surfaces that a case lists under these names.
fn listed(case: Case, names: &[&str]) -> Answer<Q> {
    let mut expected = Answer::rows(Vec::new());
    for surface in names.iter().map(|key| case.get(key)) {
        let net: Vec<Vec<Vec<Q>>> = surface.get("P").list().map(Case::rows).collect();
        expected.integers.extend([surface.get("p").integer(), net.len()]);
        expected.integers.extend([surface.get("q").integer(), net[0].len()]);
        expected.knots.extend(["U", "V"].map(|key| surface.get(key).numbers::<Q>()).concat());
        expected.rows.extend(net.concat());
    }
    expected
}

struct Scaled;

impl Golden for Scaled {
    const CATEGORY: &'static str = "surface_T";
    const CASES: usize = 4;
    const FACTOR: f64 = 8.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let (s, alpha) = given::<T, 3>(case)?;
        let tuned = |path: Path| s.fine_tuned(Scale::Signed(&alpha), path);
        let (uv, vu, mean) = (tuned(Path::UThenV)?, tuned(Path::VThenU)?, tuned(Path::Both)?);
        let mut answer = answer(&[&uv, &vu, &mean]);
        for sample in case.get("samples").list() {
            let tangents = mean.tangents_at(&sample.get("u").number(), &sample.get("v").number())?;
            answer.rows.extend(tangents.map(row));
        }
        Ok(answer)
    }

    fn expected(case: Case) -> Answer<Q> {
        let mut expected = listed(case, &SURFACES);
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

struct Held;

impl Golden for Held {
    const CATEGORY: &'static str = "surface_T_boundary";
    const CASES: usize = 2;
    const FACTOR: f64 = 16.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let (s, alpha) = given::<T, 2>(case)?;
        let held = |path: Path, edges: Edges| s.fine_tuned_holding(Scale::Signed(&alpha), path, edges);
        let uv = held(Path::UThenV, Edges::across(V, Fit::Position))?.surface;
        let vu = held(Path::VThenU, Edges::across(U, Fit::Position))?.surface;
        let mean = uv.sum(&vu)?.scaled(&T::frac(1, 2))?;
        let all = held(Path::Both, Edges::all(Fit::Position))?;
        if T::EXACT {
            // Where the scale is one at the border no edge has to be put back.
            assert_eq!(all.forced.is_zero(), case.get("border_is_one").flag());
            assert_eq!(all.surface == mean, case.get("border_is_one").flag());
        }
        Ok(answer(&[&uv, &vu, &mean]))
    }

    fn expected(case: Case) -> Answer<Q> {
        listed(case, &SURFACES)
    }
}

#[test]
#[expect(non_snake_case, reason = "the name of the category")]
fn surface_T_boundary() {
    check::<Held>();
}

struct Border;

impl Golden for Border {
    const CATEGORY: &'static str = "surface_alpha_border";
    const CASES: usize = 3;
    const FACTOR: f64 = 16.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let (s, alpha) = given::<T, 3>(case)?;
        let mean = s.fine_tuned(Scale::Signed(&alpha), Path::Both)?;
        if T::EXACT {
            let order = case.get("border_order").integer();
            for edge in Edge::ALL {
                let (direction, (a, b)) = (edge.direction(), s.space(edge.direction()).domain());
                let at = |f: &Surface<T, 3>| -> Result<Vec<SVector<T, 3>>> {
                    let mut found = Vec::new();
                    for k in 0..=order {
                        let across = f.along(direction, |rows| rows.nth_derivative(k))?;
                        found.extend(
                            across
                                .isocurve(direction, if edge.is_end() { b } else { a })?
                                .embedded(&mean.space(direction.other()).clone())?
                                .into_coeffs(),
                        );
                    }
                    Ok(found)
                };
                assert_eq!(at(&mean)?, at(&s)?, "{edge}");
            }
        }
        Ok(answer(&[&mean]))
    }

    fn expected(case: Case) -> Answer<Q> {
        listed(case, &["T"])
    }
}

#[test]
fn surface_alpha_border() {
    check::<Border>();
}
