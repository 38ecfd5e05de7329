//! Laws of frames and torsion.

use crate::rational_strategies::nurbs;
use crate::strategies::{ANY, Kind, cases, curve, probes};
use nalgebra::{SVector, vector};
use proptest::prelude::*;
use symspline::{Analyse, Curve, Error, Frame, Function, NurbsCurve, Q, Result, Scalar, SplineSpace};

/// Curves with three derivatives.
const SMOOTH: Kind = ANY.smooth(3).of_degree(3, 5);

/// Cubic curves that go ahead along the first axis and turn everywhere.
fn ahead() -> impl Strategy<Value = Curve<f64, 3>> {
    proptest::collection::vec((-0.3_f64..0.3, -0.3_f64..0.3), 6).prop_map(|offsets| {
        let space = SplineSpace::uniform(5, 1, 0.0, 1.0).expect("a space");
        // (t, t², t³), disturbed.
        let [linear, square, cube] = [1, 2, 3].map(|n| {
            Function::monomial(n, 0.0, 1.0).and_then(|f| f.elevated(5 - n)).expect("a power").into_coeffs()
        });
        let point =
            |(i, (y, z)): (usize, &(f64, f64))| vector![linear[i], square[i] + 0.2 * y, cube[i] + 0.2 * z];
        Curve::new(space, offsets.iter().enumerate().map(point).collect()).expect("a curve")
    })
}

fn is_orthonormal(frame: &Frame<f64, 3>) -> bool {
    let axes = nalgebra::Matrix3::from_columns(frame.axes());
    (axes.transpose() * axes - nalgebra::Matrix3::identity()).amax() <= 1e-14 && axes.determinant() > 0.0
}

/// The angle about the tangent from the normal of one frame to that of the other.
fn twist(from: &Frame<f64, 3>, to: &Frame<f64, 3>) -> f64 {
    to.normal().dot(from.binormal()).atan2(to.normal().dot(from.normal()))
}

/// The integral of the torsion over the length from `a` to `b`, by Simpson's rule.
fn turned(c: &Curve<f64, 3>, a: f64, b: f64) -> Result<f64> {
    let count = 2000;
    let term = |i: usize| {
        let x = (a + (b - a) * i as f64 / count as f64).min(b);
        let weight = if i == 0 || i == count { 1.0 } else { 2.0 + 2.0 * (i % 2) as f64 };
        Ok(weight * c.torsion_at(&x)? * c.derivative_at(&x, 1)?.norm())
    };
    Ok((0..=count).map(term).sum::<Result<f64>>()? * (b - a) / (3.0 * count as f64))
}

/// The helix `(cos t, sin t, slope t)` as a curve of degree 11 on `[0, 1]`, good to `1e-13`.
fn helix(slope: f64) -> Result<Curve<f64, 3>> {
    let mut coefficients = vec![SVector::<f64, 3>::zeros(); 12];
    for n in 0..12 {
        let size = 1.0 / (1..=n).map(|k| k as f64).product::<f64>();
        let sign = if n / 2 % 2 == 0 { size } else { -size };
        coefficients[n][n % 2] = sign;
    }
    coefficients[1][2] = slope;
    let zero = Curve::constant(SplineSpace::bezier(11, 0.0, 1.0)?, SVector::zeros())?;
    let mut sum = zero;
    for (n, coefficient) in coefficients.iter().enumerate() {
        let power = Function::monomial(n, 0.0, 1.0)?.elevated(11 - n)?;
        let points = power.coeffs().iter().map(|c| coefficient * *c).collect();
        sum = sum.sum(&Curve::new(power.space().clone(), points)?)?;
    }
    Ok(sum)
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn torsion_is_its_formula_and_belongs_to_the_curve(c in curve::<3>(SMOOTH)) {
        let (mirrored, rational) = (c.scaled(&Q::int(-2))?, NurbsCurve::from_polynomial(&c)?);
        let (start, end) = (Q::int(3), Q::int(4));
        let other = c.reparametrised(&start, &end)?;
        let (a, b) = c.domain();
        for x in probes(c.space()) {
            let d = c.derivatives_at(&x, 3)?;
            let normal = |i: usize, j: usize| d[1][i].clone() * &d[2][j] - d[1][j].clone() * &d[2][i];
            let across = [normal(1, 2), normal(2, 0), normal(0, 1)];
            let square = Q::dot(across.iter().zip(&across));
            let torsion = c.torsion_at(&x);
            if square == Q::int(0) {
                let refused = matches!(torsion, Err(Error::Straight { .. } | Error::Stationary { .. }));
                prop_assert!(refused);
                continue;
            }
            let torsion = torsion?;
            prop_assert_eq!(&torsion, &(Q::dot(across.iter().zip(d[3].iter())) / square));
            prop_assert_eq!(&rational.torsion_at(&x)?, &torsion);
            prop_assert_eq!(mirrored.torsion_at(&x)? * Q::int(-2), torsion.clone());
            let at = start.clone() + (x.clone() - a) / (b.clone() - a);
            prop_assert_eq!(other.torsion_at(&at)?, torsion);
        }
    }

    #[test]
    fn a_moebius_change_of_parameter_keeps_the_torsion(c in nurbs::<3>(ANY.smooth(3).of_degree(3, 3).few(0)), share in 1..9_i64) {
        prop_assume!(c.space().breaks().len() == 2);
        let (a, b) = c.domain();
        let ratio = Q::int(3);
        let other = c.moebius(a, b, &ratio)?;
        let at = |c: &NurbsCurve<Q, 3>, t: Q| c.torsion_at(&(a.clone() + (b.clone() - a) * t));
        // One of these two is the parameter of the same point.
        let t = Q::frac(share, 9);
        let images = [Q::int(3), Q::frac(1, 3)].map(|r| t.clone() * &r / (Q::int(1) + t.clone() * (r - Q::int(1))));
        let place = |c: &NurbsCurve<Q, 3>, t: &Q| c.at(&(a.clone() + (b.clone() - a) * t));
        let point = place(&c, &t)?;
        let same = images.into_iter().find(|image| place(&other, image) == Ok(point.clone()));
        let Some(same) = same else { return Ok(()) };
        let (one, two) = (at(&c, t), at(&other, same));
        prop_assert_eq!(one.ok(), two.ok());
    }

    #[test]
    fn frenet_frames_turn_by_curvature_and_torsion(c in ahead(), x in 0.05_f64..0.95) {
        let frame = c.frame_at(&x)?;
        prop_assert!(is_orthonormal(&frame));
        prop_assert_eq!(frame.point, c.at(&x)?);
        let d = c.derivatives_at(&x, 2)?;
        prop_assert!((frame.tangent() * d[1].norm() - d[1]).norm() <= 1e-14 * d[1].norm());
        prop_assert!(frame.normal().dot(&d[2]) > 0.0 && frame.binormal().dot(&d[2]).abs() <= 1e-12 * d[2].norm());
        // T' = κ N, B' = -τ N
        let (curvature, torsion) = (c.curvature_at(&x)?, c.torsion_at(&x)?);
        prop_assume!(curvature > 0.3 && torsion.abs() < 30.0);
        let h = 1e-4;
        let slope = |axis: usize| -> Result<SVector<f64, 3>> {
            let [ahead, behind] = [x + h, x - h].map(|x| c.frame_at(&x));
            Ok((ahead?.axes()[axis] - behind?.axes()[axis]) / (2.0 * h) / d[1].norm())
        };
        let size = 1.0 + (curvature + torsion.abs()).powi(3) * 20.0;
        prop_assert!((slope(0)? - frame.normal() * curvature).norm() <= 1e-5 * size);
        prop_assert!((slope(2)? + frame.normal() * torsion).norm() <= 1e-4 * size);
    }

    #[test]
    fn rotation_minimising_frames_are_of_the_fourth_order(c in ahead()) {
        let torsions = (0..=100).map(|i| c.torsion_at(&(f64::from(i) / 100.0))).collect::<Result<Vec<_>>>();
        let Ok(torsions) = torsions else { return Ok(()) };
        prop_assume!(torsions.iter().all(|t| t.abs() < 10.0));
        let start = c.frame_at(&0.0)?;
        let error = |count: u32| -> Result<f64> {
            let parameters: Vec<f64> = (0..=count).map(|i| f64::from(i) / f64::from(count)).collect();
            let frames = c.rotation_minimising_frames(&parameters, Some(start.normal()))?;
            assert!(frames.iter().all(is_orthonormal));
            // The Frenet frame turns by the torsion, this one does not.
            let angle = twist(&frames[count as usize], &c.frame_at(&1.0)?) - turned(&c, 0.0, 1.0)?;
            Ok(angle.sin().abs())
        };
        let errors = [8, 16, 32].map(error);
        let [rough, middle, fine] = [errors[0].clone()?, errors[1].clone()?, errors[2].clone()?];
        prop_assert!(fine <= 1e-2);
        // The error may change its sign, and be small by chance.
        prop_assert!(middle <= rough / 8.0 + 1e-6 && fine <= rough.max(middle) / 8.0 + 1e-6, "{rough} {middle} {fine}");
    }

    #[test]
    fn the_start_turns_all_frames_alike(c in ahead(), angle in 0.0..6.0_f64) {
        let parameters: Vec<f64> = (0..=10).map(|i| f64::from(i) / 10.0).collect();
        let frames = c.rotation_minimising_frames(&parameters, None)?;
        let (sin, cos) = angle.sin_cos();
        let start = frames[0].normal() * cos + frames[0].binormal() * sin + frames[0].tangent() * 3.0;
        let turned = c.rotation_minimising_frames(&parameters, Some(&start))?;
        let rational = NurbsCurve::from_polynomial(&c)?.rotation_minimising_frames(&parameters, Some(&start))?;
        for ((one, two), three) in frames.iter().zip(&turned).zip(&rational) {
            let off = (twist(one, two) - angle).sin().abs();
            prop_assert!(is_orthonormal(two) && off <= 1e-12);
            prop_assert!((two.normal() - three.normal()).norm() <= 1e-12);
        }
    }
}

#[test]
fn the_helix_has_its_torsion() -> Result<()> {
    for slope in [0.0, 0.3, -2.0] {
        let c = helix(slope)?;
        let length = (1.0 + slope * slope).sqrt();
        for x in [0.0, 0.2, 0.5, 0.7] {
            assert!((c.torsion_at(&x)? - slope / length.powi(2)).abs() < 1e-7);
            assert!((c.curvature_at(&x)? - length.powi(-2)).abs() < 1e-8);
            let frame = c.frame_at(&x)?;
            assert!((frame.normal() + vector![x.cos(), x.sin(), 0.0]).norm() < 1e-8);
        }
        assert!((c.length(&1e-12)? - length).abs() < 1e-8);
    }
    Ok(())
}

#[test]
fn on_a_helix_the_error_goes_down_with_the_fourth_power() -> Result<()> {
    let c = helix(0.7)?;
    // About `0.7 / √1.49`, but the polynomial is not quite a helix.
    let angle = turned(&c, 0.0, 1.0)?;
    assert!((angle - 0.7 / 1.49_f64.sqrt()).abs() < 1e-6);
    let start = c.frame_at(&0.0)?;
    let error = |count: u32| -> Result<f64> {
        let parameters: Vec<f64> = (0..=count).map(|i| f64::from(i) / f64::from(count)).collect();
        let frames = c.rotation_minimising_frames(&parameters, Some(start.normal()))?;
        Ok(twist(&frames[count as usize], &c.frame_at(&1.0)?) - angle)
    };
    let errors = [4, 8, 16].map(error);
    let [rough, middle, fine] = [errors[0].clone()?, errors[1].clone()?, errors[2].clone()?];
    assert!(
        (14.0..18.0).contains(&(rough / middle)) && (14.0..18.0).contains(&(middle / fine)),
        "{rough} {middle} {fine}"
    );
    Ok(())
}

#[test]
fn plane_frames_turn_left() -> Result<()> {
    let points = vec![vector![0.0, 0.0], vector![1.0, 1.0], vector![3.0, 0.0]];
    let c = Curve::new(SplineSpace::bezier(2, 0.0, 1.0)?, points)?;
    for rational in [NurbsCurve::from_polynomial(&c)?] {
        for x in [0.0, 0.25, 1.0] {
            let (frame, d) = (c.frame_at(&x)?, c.derivative_at(&x, 1)?);
            assert!((frame.tangent() - d.normalize()).norm() < 1e-15);
            assert_eq!(*frame.normal(), vector![-frame.tangent()[1], frame.tangent()[0]]);
            assert!((rational.frame_at(&x)?.normal() - frame.normal()).norm() < 1e-14);
        }
    }
    Ok(())
}

#[test]
fn frames_of_plane_curves_are_exact() -> Result<()> {
    let points = [[0.0, 0.0], [3.0, 5.0], [4.0, -6.0], [9.0, 1.0]].map(|[x, y]| vector![x, 0.6 * y, 0.8 * y]);
    let c = Curve::new(SplineSpace::bezier(3, 0.0, 1.0)?, points.to_vec())?;
    let normal = vector![0.0, -0.8, 0.6];
    let frames = c.rotation_minimising_frames(&[0.0, 0.3, 0.31, 0.9, 1.0], Some(&normal))?;
    assert!(frames.iter().all(|frame| (frame.normal() - normal).norm() < 1e-14));
    Ok(())
}

#[test]
fn what_has_no_frame_is_refused() -> Result<()> {
    let space = SplineSpace::bezier(3, 0.0, 1.0)?;
    let line = Curve::new(space.clone(), [0.0, 1.0, 2.0, 3.0].map(|x| vector![x, 2.0 * x, -x]).to_vec())?;
    assert_eq!(line.frame_at(&0.0).unwrap_err(), Error::Straight { parameter: "0".into() });
    assert_eq!(line.torsion_at(&0.0).unwrap_err(), Error::Straight { parameter: "0".into() });
    let still = Curve::constant(space.clone(), vector![1.0, 2.0, 3.0])?;
    let stationary = Error::Stationary { parameter: "1".into() };
    assert_eq!(still.frame_at(&1.0).unwrap_err(), stationary);
    assert_eq!(still.torsion_at(&1.0).unwrap_err(), stationary);
    assert_eq!(still.rotation_minimising_frames(&[1.0], None).unwrap_err(), stationary);
    let flat = Curve::constant(space, vector![1.0, 2.0])?;
    assert_eq!(flat.frame_at(&1.0).unwrap_err(), stationary);
    for start in [vector![0.0, 0.0, 0.0], vector![f64::NAN, 0.0, 0.0], vector![f64::INFINITY, 0.0, 1.0]] {
        assert_eq!(line.rotation_minimising_frames(&[0.0], Some(&start)), Err(Error::AlongTangent));
    }
    let back = line.rotation_minimising_frames(&[0.5, 0.2], None);
    assert_eq!(back, Err(Error::ParametersDecrease { index: 1 }));
    assert!(line.rotation_minimising_frames(&[0.5, f64::NAN], None).is_err());
    assert_eq!(line.rotation_minimising_frames(&[], None)?, []);
    Ok(())
}

#[test]
fn torsion_has_the_inverse_unit() -> Result<()> {
    let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 3.0, 3.0]];
    for size in [1e-300, 1e-150, 1.0, 1e150, 1e300] {
        let points = points.map(|c| vector![c[0], c[1], c[2]] * (size / 3.0)).to_vec();
        let c = Curve::new(SplineSpace::bezier(3, 0.0, 1.0)?, points)?;
        assert!((c.torsion_at(&0.0)? * size - 3.0).abs() < 1e-13, "{size}");
        assert!(is_orthonormal(&c.frame_at(&0.5)?));
        assert!(c.rotation_minimising_frames(&[0.0, 0.5, 1.0], None)?.iter().all(is_orthonormal));
    }
    Ok(())
}

#[test]
fn frames_take_every_size_and_equal_parameters() -> Result<()> {
    let points = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 2.0, 1.0]].map(SVector::from);
    let c = Curve::new(SplineSpace::bezier(2, 0.0, 1.0)?, points.to_vec())?;
    // The start has a part along the tangent, which rounding leaves in unless it is brought to size one first.
    for size in [1e-320, 1.0, 1e308] {
        let frames = c.rotation_minimising_frames(&[0.0, 0.0], Some(&vector![size, size, size]))?;
        assert!(frames.iter().all(|frame| (frame.normal() - vector![0.0, 0.0, 1.0]).norm() < 1e-14));
    }
    let tiny = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 3.0, 3.0]]
        .map(|c| SVector::from(c) * 1e-310);
    let tiny = Curve::new(SplineSpace::bezier(3, 0.0, 1.0)?, tiny.to_vec())?;
    assert_eq!(tiny.torsion_at(&0.0), Err(Error::NotFinite { what: "torsion", index: 0 }));
    Ok(())
}
