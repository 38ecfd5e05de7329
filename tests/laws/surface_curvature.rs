//! Laws of the curvature of surfaces: exact over `Q` where no root is needed, else over `f64` with bounds that scale
//! with the terms.

use crate::rational_strategies::nurbs_surface;
use crate::strategies::{ANY, Kind, cases, probe_pairs, surface};
use nalgebra::{SVector, vector};
use proptest::prelude::*;
use symspline::{
    Coeff, Curve, Error, Function, NurbsSurface, PrincipalCurvatures, Q, Result, Scalar, SplineSpace,
    Surface, TensorSpline, circle,
};

/// Surfaces with two derivatives, of low degrees: the exact curvature has eight times those.
const SIDE: Kind = ANY.smooth(2).of_degree(1, 3).few(1);

fn int(i: i64) -> Q {
    Q::int(i)
}

/// Biquadratic patches that go ahead in both directions, so that there is a normal.
fn patch() -> impl Strategy<Value = Surface<Q, 3>> {
    proptest::collection::vec((-2_i64..=2, -2_i64..=2, -9_i64..=9), 9).prop_map(|offsets| {
        let space = SplineSpace::bezier(2, int(-1), int(1)).expect("a space");
        let point = |(i, (x, y, z)): (usize, (i64, i64, i64))| {
            vector![Q::frac(12 * (i as i64 / 3) + x, 12), Q::frac(12 * (i as i64 % 3) + y, 12), Q::frac(z, 3)]
        };
        Surface::new(space.clone(), space, offsets.into_iter().enumerate().map(point).collect())
            .expect("a patch")
    })
}

/// The curvatures by the forms, as the books have them, and the size of the terms.
fn by_forms(s: &Surface<f64, 3>, u: f64, v: f64) -> Result<(f64, f64, f64)> {
    let (one, two) = (s.first_form_at(&u, &v)?, s.second_form_at(&u, &v)?);
    let area = one.uu * one.vv - one.uv * one.uv;
    let gaussian = (two.uu * two.vv - two.uv * two.uv) / area;
    let mean = (one.uu * two.vv - 2.0 * one.uv * two.uv + one.vv * two.uu) / (2.0 * area);
    let size = (one.uu * two.vv.abs() + 2.0 * (one.uv * two.uv).abs() + one.vv * two.uu.abs()) / area;
    Ok((gaussian, mean, size))
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn the_curvature_is_the_determinant_of_the_shape_operator(s in surface::<3>(SIDE, SIDE)) {
        for (u, v) in probe_pairs(&s) {
            let d = s.derivatives_at(&u, &v, 2)?;
            let normal = s.normal_at(&u, &v)?;
            if normal.vanishes() {
                let refused = matches!(s.gaussian_curvature_at(&u, &v), Err(Error::NoNormal { .. }));
                prop_assert!(refused);
                continue;
            }
            let one = s.first_form_at(&u, &v)?;
            let dot = |d: &SVector<Q, 3>| Q::dot(d.iter().zip(normal.iter()));
            let two = [dot(&d[2][0]), dot(&d[1][1]), dot(&d[0][2])];
            // The matrix I⁻¹ II, times |n|.
            let area = one.uu.clone() * &one.vv - one.uv.clone() * &one.uv;
            let entry = |a: &Q, b: &Q, c: &Q, d: &Q| (a.clone() * b - c.clone() * d) / &area;
            let shape = [
                [entry(&one.vv, &two[0], &one.uv, &two[1]), entry(&one.vv, &two[1], &one.uv, &two[2])],
                [entry(&one.uu, &two[1], &one.uv, &two[0]), entry(&one.uu, &two[2], &one.uv, &two[1])],
            ];
            let determinant = shape[0][0].clone() * &shape[1][1] - shape[0][1].clone() * &shape[1][0];
            let square = Q::dot(normal.iter().zip(normal.iter()));
            prop_assert_eq!(s.gaussian_curvature_at(&u, &v)?, determinant / square);
        }
    }

    #[test]
    fn the_rational_surface_has_the_curvatures_at_its_points(s in patch()) {
        let curvature = s.gaussian_curvature();
        prop_assume!(curvature != Err(Error::Pole) && curvature != Err(Error::Undecided));
        let curvature = curvature?;
        for (u, v) in probe_pairs(&s) {
            prop_assert_eq!(curvature.at(&u, &v)?, s.gaussian_curvature_at(&u, &v)?);
        }
    }

    #[test]
    fn a_rational_surface_with_equal_weights_is_no_other(s in surface::<3>(SIDE, SIDE)) {
        let rational = NurbsSurface::from_polynomial(&s)?;
        for (u, v) in probe_pairs(&s) {
            prop_assert_eq!(rational.gaussian_curvature_at(&u, &v), s.gaussian_curvature_at(&u, &v));
        }
    }

    #[test]
    fn the_curvature_depends_on_neither_side_nor_motion_nor_parameter(s in nurbs_surface::<3>(SIDE)) {
        let swapped = s.transposed()?;
        let turned = s.through(|lifted| lifted.along(symspline::Direction::U, |rows| Ok(rows.clone())))?;
        prop_assert_eq!(&turned, &s);
        let scaled = s.scaled(&Q::frac(-3, 2))?.translated(&vector![int(5), Q::frac(1, 7), int(-1)])?;
        for (u, v) in probe_pairs(s.lifted()).into_iter().take(6) {
            let Ok(curvature) = s.gaussian_curvature_at(&u, &v) else { continue };
            prop_assert_eq!(&swapped.gaussian_curvature_at(&v, &u)?, &curvature);
            prop_assert_eq!(scaled.gaussian_curvature_at(&u, &v)? * Q::frac(9, 4), curvature);
        }
    }

    #[test]
    fn principal_curvatures_are_those_of_the_forms(s in patch(), u in -1.0_f64..1.0, v in -1.0_f64..1.0) {
        let s = s.to_f64()?;
        let normal = s.normal_at(&u, &v)?;
        prop_assume!(normal.norm() > 0.1);
        let (gaussian, mean, size) = by_forms(&s, u, v)?;
        let accuracy = 1e-11 * (1.0 + size);
        let k = s.principal_curvatures_at(&u, &v)?;
        prop_assert!(k.greatest >= k.least);
        prop_assert!((s.mean_curvature_at(&u, &v)? - mean).abs() <= accuracy);
        prop_assert!((k.greatest + k.least - 2.0 * mean).abs() <= 2.0 * accuracy);
        prop_assert!((k.greatest * k.least - gaussian).abs() <= accuracy * (1.0 + size));
        prop_assert!((s.gaussian_curvature_at(&u, &v)? - gaussian).abs() <= accuracy * (1.0 + size));
        let Some([first, second]) = k.directions else { return Ok(()) };
        // A right-handed frame.
        let unit = normal.normalize();
        prop_assert!((first.space.cross(&second.space) - unit).norm() <= 1e-12);
        prop_assert!((first.space.norm() - 1.0).abs() <= 1e-14 && first.space.dot(&unit).abs() <= 1e-13);
        let [_, along_u, along_v] = s.tangents_at(&u, &v)?;
        let two = s.second_form_at(&u, &v)?;
        let section = |p: &SVector<f64, 2>| p[0] * p[0] * two.uu + 2.0 * p[0] * p[1] * two.uv + p[1] * p[1] * two.vv;
        for (direction, curvature) in [(&first, k.greatest), (&second, k.least)] {
            let p = &direction.parameters;
            prop_assert!((along_u * p[0] + along_v * p[1] - direction.space).norm() <= 1e-12);
            prop_assert!((section(p) - curvature).abs() <= accuracy);
        }
        // Euler: k(φ) = k_1 cos² φ + k_2 sin² φ.
        for i in 0..12 {
            let (sin, cos) = (f64::from(i) * 0.5).sin_cos();
            let p = first.parameters * cos + second.parameters * sin;
            let expected = k.greatest * cos * cos + k.least * sin * sin;
            prop_assert!((section(&p) - expected).abs() <= 10.0 * accuracy);
        }
    }

    #[test]
    fn curvature_has_the_inverse_unit(s in patch(), exponent in -400..400_i32) {
        let s = s.to_f64()?;
        let scale = f64::from(exponent).exp2();
        let scaled = s.scaled(&scale)?;
        let (Ok(k), Ok(scaled)) = (s.principal_curvatures_at(&0.1, &0.2), scaled.principal_curvatures_at(&0.1, &0.2))
        else {
            return Ok(())
        };
        let size = k.greatest.abs().max(k.least.abs());
        prop_assert!((scaled.greatest * scale - k.greatest).abs() <= 1e-13 * size);
        prop_assert!((scaled.least * scale - k.least).abs() <= 1e-13 * size);
    }
}

/// The surface of revolution about the z axis: `profile` has the radius and the height; anticlockwise along `u`.
fn revolved(profile: &symspline::NurbsCurve<f64, 2>) -> Result<NurbsSurface<f64, 3>> {
    let round = circle(&vector![0.0, 0.0], &1.0)?;
    let (points, weights): (Vec<_>, Vec<_>) = (round.points()?, round.weights().collect());
    let (outline, masses): (Vec<_>, Vec<_>) = (profile.points()?, profile.weights().collect());
    let pairs = || (0..points.len()).flat_map(|i| (0..outline.len()).map(move |j| (i, j)));
    let point = |(i, j): (usize, usize)| {
        let (c, d): (&SVector<f64, 2>, &SVector<f64, 2>) = (&points[i], &outline[j]);
        vector![c[0] * d[0], c[1] * d[0], d[1]]
    };
    let weight = |(i, j): (usize, usize)| weights[i] * masses[j];
    let spaces = (round.space().clone(), profile.space().clone());
    NurbsSurface::new(spaces.0, spaces.1, pairs().map(point).collect(), pairs().map(weight).collect())
}

fn near(k: &PrincipalCurvatures<f64>, greatest: f64, least: f64) {
    let size = greatest.abs() + least.abs();
    let off = (k.greatest - greatest).abs().max((k.least - least).abs());
    assert!(off <= 1e-13 * size, "{k:?} instead of {greatest} {least}");
}

/// Parameters all over a surface of revolution.
fn places(s: &NurbsSurface<f64, 3>) -> Vec<(f64, f64)> {
    let at = |(a, b): (&f64, &f64), t: f64| a + (b - a) * t;
    let shares = || (0..8).map(|i| 0.03 + 0.12 * f64::from(i));
    shares()
        .flat_map(|t| shares().map(move |r| (t, r)))
        .map(|(t, r)| (at(s.u().domain(), t), at(s.v().domain(), r)))
        .collect()
}

#[test]
fn the_torus_has_its_curvatures() -> Result<()> {
    let (wide, narrow) = (3.0, 1.25);
    let torus = revolved(&circle(&vector![wide, 0.0], &narrow)?)?;
    for (u, v) in places(&torus) {
        let point = torus.at(&u, &v)?;
        let radius = point.xy().norm();
        let across = (radius - wide) / radius / narrow;
        // The normal points outwards, as S_u × S_v of an anticlockwise tube does.
        let normal = torus.unit_normal_at(&u, &v)?;
        let centre = vector![point[0], point[1], 0.0] * (wide / radius);
        assert!((normal - (point - centre) / narrow).norm() < 1e-13);
        let k = torus.principal_curvatures_at(&u, &v)?;
        near(&k, -across, -1.0 / narrow);
        assert!((torus.gaussian_curvature_at(&u, &v)? - across / narrow).abs() < 1e-13);
        assert!((torus.mean_curvature_at(&u, &v)? + (across + 1.0 / narrow) / 2.0).abs() < 1e-13);
        // The least curvature is that of the tube, in the plane of the axis.
        let [_, tube] = k.directions.expect("a torus has no umbilics");
        assert!(tube.space.dot(&vector![-point[1], point[0], 0.0]).abs() < 1e-12);
    }
    Ok(())
}

#[test]
fn all_points_of_a_sphere_are_umbilics_and_the_poles_have_no_normal() -> Result<()> {
    let half = symspline::arc(&vector![0.0, 0.0], &vector![0.0, -2.0], &vector![2.0, 0.0])?;
    let sphere = revolved(&half)?;
    for (u, v) in places(&sphere) {
        let k = sphere.principal_curvatures_at(&u, &v)?;
        near(&k, -0.5, -0.5);
        assert_eq!(k.directions, None);
        assert!((sphere.gaussian_curvature_at(&u, &v)? - 0.25).abs() < 1e-13);
    }
    let pole = *sphere.v().domain().0;
    assert!(matches!(sphere.gaussian_curvature_at(&0.1, &pole), Err(Error::NoNormal { .. })));
    assert!(matches!(sphere.principal_curvatures_at(&0.1, &pole), Err(Error::NoNormal { .. })));
    assert!(matches!(sphere.mean_curvature_at(&0.1, &pole), Err(Error::NoNormal { .. })));
    Ok(())
}

#[test]
fn the_cylinder_is_straight_one_way() -> Result<()> {
    let segment = Curve::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![vector![4.0, 0.0], vector![4.0, 7.0]])?;
    let cylinder = revolved(&symspline::NurbsCurve::from_polynomial(&segment)?)?;
    for (u, v) in places(&cylinder) {
        let k = cylinder.principal_curvatures_at(&u, &v)?;
        near(&k, 0.0, -0.25);
        let [straight, _] = k.directions.expect("no umbilic");
        assert!((straight.space[2].abs() - 1.0).abs() < 1e-13);
        assert!(cylinder.gaussian_curvature_at(&u, &v)?.abs() < 1e-14);
    }
    Ok(())
}

#[test]
fn saddles_and_planes() -> Result<()> {
    // z = x² - y² over Q: K = -4 / (1 + 4x² + 4y²)².
    let power = |n: usize| Function::monomial(n, int(-1), int(1));
    let [one, x, square] = [power(0)?.elevated(2)?, power(1)?.elevated(1)?, power(2)?];
    let outer = |f: &Function<Q>, g: &Function<Q>| {
        let rows = f.coeffs().iter().map(|c| g.coeffs().iter().map(|d| c.clone() * d).collect()).collect();
        TensorSpline::from_rows(f.space().clone(), g.space().clone(), rows)
    };
    let axes =
        [outer(&x, &one)?, outer(&one, &x)?, outer(&square, &one)?.difference(&outer(&one, &square)?)?];
    let points = (0..9).map(|i| SVector::from_fn(|axis, _| axes[axis].coeffs()[i].clone())).collect();
    let saddle = Surface::new(x.space().clone(), x.space().clone(), points)?;
    let curvature = saddle.gaussian_curvature()?;
    for (u, v) in [(0, 0), (1, 2), (-3, 1), (4, 4), (-4, 3)].map(|(u, v)| (Q::frac(u, 4), Q::frac(v, 4))) {
        let bottom = int(1) + int(4) * (u.clone() * &u + v.clone() * &v);
        let expected = int(-4) / (bottom.clone() * bottom);
        assert_eq!(
            (saddle.gaussian_curvature_at(&u, &v)?, curvature.at(&u, &v)?),
            (expected.clone(), expected)
        );
    }
    let k = saddle.to_f64()?.principal_curvatures_at(&0.0, &0.0)?;
    near(&k, 2.0, -2.0);
    let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    let corners =
        vec![vector![0.0, 0.0, 0.0], vector![0.3, 1.0, 0.0], vector![1.0, 0.1, 0.0], vector![2.0, 2.0, 0.0]];
    let plane = Surface::new(line.clone(), line, corners)?;
    let k = plane.principal_curvatures_at(&0.4, &0.9)?;
    assert_eq!((k.greatest, k.least, k.directions), (0.0, 0.0, None));
    Ok(())
}

#[test]
fn near_umbilics_have_directions_while_rounding_does_not_choose_them() -> Result<()> {
    // z = (1 + more) x² + y²
    let (line, square) = ([-1.0, 0.0, 1.0], [1.0, -1.0, 1.0]);
    let space = SplineSpace::bezier(2, -1.0, 1.0)?;
    let bowl = |more: f64| {
        let pairs = (0..9).map(|k| (k / 3, k % 3));
        let points = pairs.map(|(i, j)| vector![line[i], line[j], (1.0 + more) * square[i] + square[j]]);
        Surface::new(space.clone(), space.clone(), points.collect())?.principal_curvatures_at(&0.0, &0.0)
    };
    let [along, across] = bowl(1e-9)?.directions.expect("the curvatures differ");
    assert!((along.space[0].abs() - 1.0).abs() < 1e-9 && (across.space[1].abs() - 1.0).abs() < 1e-9);
    assert_eq!((bowl(0.0)?.directions, bowl(1e-14)?.directions), (None, None));
    Ok(())
}
