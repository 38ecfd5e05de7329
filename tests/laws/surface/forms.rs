//! Laws of normals and fundamental forms.

use super::SIDE;
use crate::strategies::{Kind, SMOOTH, cases, probe_pairs, surface, surfaces};
use nalgebra::{SVector, vector};
use proptest::prelude::*;
use symspline::Direction::{U, V};
use symspline::{Error, Q, Result, Scalar, SplineSpace, Surface, TensorSpline};

/// Surfaces whose normals are splines.
const SHAPE: Kind = SMOOTH.few(1).of_degree(0, 3);

fn dot<const N: usize>(x: &SVector<Q, N>, y: &SVector<Q, N>) -> Q {
    x.iter().zip(y.iter()).map(|(x, y)| x.clone() * y).sum()
}

fn cross(x: &SVector<Q, 3>, y: &SVector<Q, 3>) -> SVector<Q, 3> {
    let minor = |i: usize, j: usize| x[i].clone() * &y[j] - x[j].clone() * &y[i];
    vector![minor(1, 2), minor(2, 0), minor(0, 1)]
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn the_first_form_is_that_of_the_tangents(s in surface::<2>(SHAPE, SHAPE)) {
        let form = s.first_form()?;
        for (u, v) in probe_pairs(&s) {
            let (x, y) = (s.derivative_at(&u, &v, 1, 0)?, s.derivative_at(&u, &v, 0, 1)?);
            let at = s.first_form_at(&u, &v)?;
            prop_assert_eq!([&at.uu, &at.uv, &at.vv], [&dot(&x, &x), &dot(&x, &y), &dot(&y, &y)]);
            let found = [form.uu.at(&u, &v)?, form.uv.at(&u, &v)?, form.vv.at(&u, &v)?];
            prop_assert_eq!(found, [at.uu, at.uv, at.vv]);
        }
    }

    #[test]
    fn the_normal_is_across_both_tangents(s in surface::<3>(SHAPE, SHAPE)) {
        let (normal, along_u, along_v) = (s.normal()?, s.derivative(U)?, s.derivative(V)?);
        for tangent in [&along_u, &along_v] {
            prop_assert!(normal.dot(tangent)?.coeffs().iter().all(|c| *c == Q::int(0)));
        }
        for (u, v) in probe_pairs(&s) {
            let expected = cross(&along_u.at(&u, &v)?, &along_v.at(&u, &v)?);
            prop_assert_eq!(&s.normal_at(&u, &v)?, &expected);
            prop_assert_eq!(&normal.at(&u, &v)?, &expected);
        }
    }

    #[test]
    fn the_squared_normal_is_the_determinant_of_the_first_form(s in surface::<3>(SHAPE, SHAPE)) {
        for (u, v) in probe_pairs(&s) {
            let (form, normal) = (s.first_form_at(&u, &v)?, s.normal_at(&u, &v)?);
            prop_assert_eq!(dot(&normal, &normal), form.uu * form.vv - form.uv.clone() * form.uv);
        }
    }

    #[test]
    fn transposing_and_reversing_turn_the_normal_round(s in surface::<3>(SHAPE, SHAPE)) {
        let normal = s.normal()?;
        prop_assert_eq!(s.transposed().normal()?, -&normal.transposed());
        for direction in [U, V] {
            prop_assert_eq!(s.reversed(direction)?.normal()?, -&normal.reversed(direction)?);
        }
    }

    #[test]
    fn the_scaled_second_form_is_pointwise(
        s in surface::<3>(SMOOTH.smooth(2).few(1).of_degree(0, 3), SMOOTH.smooth(2).few(1).of_degree(0, 3)),
    ) {
        let form = s.scaled_second_form()?;
        for (u, v) in probe_pairs(&s) {
            let (all, normal) = (s.derivatives_at(&u, &v, 2)?, s.normal_at(&u, &v)?);
            let found = [form.uu.at(&u, &v)?, form.uv.at(&u, &v)?, form.vv.at(&u, &v)?];
            let expected = [(2, 0), (1, 1), (0, 2)].map(|(k, l)| dot(&all[k][l], &normal));
            prop_assert_eq!(found, expected);
        }
    }

    #[test]
    fn the_first_form_does_not_move([s, _] in surfaces::<2>([SHAPE; 2], [SIDE.few(0); 2])) {
        let moved = s.translated(&vector![Q::int(3), Q::frac(-1, 7)])?;
        prop_assert_eq!(moved.first_form()?, s.first_form()?);
    }

    #[test]
    fn unit_normals_and_second_forms_agree_with_the_exact_ones(
        s in surface::<3>(SHAPE.of_degree(1, 3), SHAPE.of_degree(1, 3)),
    ) {
        // The floats stand for exact numbers: compare with those. Bounds are relative to what is multiplied.
        let Ok(floats) = s.to_f64() else { return Ok(()) };
        let exact = floats.to_exact()?;
        let inside = |space: &SplineSpace<Q>, x: f64| {
            Q::try_from(x).ok().filter(|x| space.locate(x).is_ok())
        };
        for (u, v) in probe_pairs(&exact) {
            let (x, y) = (u.to_f64(), v.to_f64());
            let (Some(u), Some(v)) = (inside(exact.u(), x), inside(exact.v(), y)) else { continue };
            let (all, normal) = (exact.derivatives_at(&u, &v, 2)?, exact.normal_at(&u, &v)?);
            let size = |c: &SVector<Q, 3>| dot(c, c).to_f64().sqrt();
            let net = exact.coeffs().iter().map(&size).fold(0.0, f64::max);
            let shortest = [exact.u(), exact.v()].map(|space| {
                let t = space.knots();
                space.spans().map(|k| (t[k + 1].clone() - &t[k]).to_f64()).fold(f64::INFINITY, f64::min)
            });
            // How large tangents may be at most, and how much of that the normal has kept.
            let steep = shortest.map(|h| 6.0 * net / h);
            let kept = size(&normal) / (steep[0] * steep[1]);
            if kept < 1e-6 || kept.is_nan() {
                continue;
            }
            let unit = floats.unit_normal_at(&x, &y)?;
            let expected = normal.map(|c| c.to_f64()) / size(&normal);
            prop_assert!((unit - expected).norm() <= 64.0 * f64::EPSILON / kept, "{unit} {expected}");
            let form = floats.second_form_at(&x, &y)?;
            let [g, h] = shortest;
            for (found, k, l, h) in [(form.uu, 2, 0, g * g), (form.uv, 1, 1, g * h), (form.vv, 0, 2, h * h)] {
                let expected = dot(&all[k][l], &normal).to_f64() / size(&normal);
                let allowed = 256.0 * f64::EPSILON * (36.0 * net / h) / kept;
                prop_assert!((found - expected).abs() <= allowed, "{found} {expected}");
            }
        }
    }
}

/// The corners of a bilinear patch.
fn patch(corners: [[f64; 3]; 4]) -> Result<Surface<f64, 3>> {
    let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    TensorSpline::new(line.clone(), line, corners.map(|[x, y, z]| vector![x, y, z]).to_vec())
}

#[test]
fn where_tangents_are_parallel_there_is_no_normal() -> Result<()> {
    let point = patch([[1.0, 2.0, 3.0]; 4])?;
    let segment = patch([[0.0; 3], [1.0, 1.0, 0.0], [1.0, 1.0, 0.0], [2.0, 2.0, 0.0]])?;
    let triangle = patch([[0.0; 3], [0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]])?;
    for (s, v) in [(&point, 0.5), (&segment, 0.5), (&triangle, 0.25)] {
        let expected = Error::NoNormal { u: "0".into(), v: v.to_string() };
        assert_eq!(s.unit_normal_at(&0.0, &v).unwrap_err(), expected);
        assert_eq!(s.second_form_at(&0.0, &v).unwrap_err(), expected);
        assert_eq!(s.normal_at(&0.0, &v)?, vector![0.0, 0.0, 0.0]);
    }
    assert_eq!(triangle.unit_normal_at(&0.5, &0.5)?, vector![0.0, 0.0, 1.0]);
    Ok(())
}

/// Lengths are taken without overflow or underflow on the way.
#[test]
fn large_and_small_surfaces_have_unit_normals() -> Result<()> {
    for size in [1e-300, 1e-150, 1e150, 1e300] {
        let s = patch([[0.0; 3], [0.0, size, 0.0], [size, 0.0, 0.0], [size, size, 0.0]])?;
        assert_eq!(s.unit_normal_at(&0.5, &0.5)?, vector![0.0, 0.0, 1.0]);
    }
    Ok(())
}

/// A paraboloid at its vertex: both principal curvatures are known.
#[test]
fn a_paraboloid_has_known_forms() -> Result<()> {
    let parabola = SplineSpace::bezier(2, -1.0, 1.0)?;
    let square = [1.0, -1.0, 1.0];
    let point =
        |i: usize, j: usize| vector![i as f64 - 1.0, j as f64 - 1.0, 3.0 * square[i] + 5.0 * square[j]];
    let coeffs = (0..9).map(|k| point(k / 3, k % 3)).collect();
    let s = Surface::new(parabola.clone(), parabola, coeffs)?;
    let (first, second) = (s.first_form_at(&0.0, &0.0)?, s.second_form_at(&0.0, &0.0)?);
    assert_eq!([first.uu, first.uv, first.vv], [1.0, 0.0, 1.0]);
    assert_eq!([second.uu, second.uv, second.vv], [6.0, 0.0, 10.0]);
    Ok(())
}
