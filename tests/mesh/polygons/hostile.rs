//! What is refused, and how.

use nalgebra::{SVector, vector};
use symspline::{Boundary, ControlPolygon, CubicPolygon, Error, MeshError, Result};

fn square() -> Vec<SVector<f64, 2>> {
    vec![vector![0.0, 0.0], vector![1.0, 0.0], vector![1.0, 1.0], vector![0.0, 1.0]]
}

#[test]
fn too_few_points_are_refused() {
    let few = |expected, found| Some(Error::TooFewPoints { expected, found });
    assert_eq!(ControlPolygon::closed(square()[..2].to_vec()).err(), few(3, 2));
    assert_eq!(ControlPolygon::<f64, 2>::open(Vec::new(), Boundary::Smooth).err(), few(3, 0));
    assert_eq!(CubicPolygon::open(square()[..3].to_vec(), Boundary::Smooth).err(), few(4, 3));
    assert_eq!(CubicPolygon::<f64, 2>::closed(Vec::new()).err(), few(3, 0));
    let mut bad = square();
    bad[3][1] = f64::NAN;
    assert_eq!(ControlPolygon::closed(bad).err(), Some(Error::NotFinite { what: "point", index: 3 }));
}

#[test]
fn intervals_without_a_curve_are_refused() -> Result<()> {
    let (ring, open) = (ControlPolygon::closed(square())?, ControlPolygon::open(square(), Boundary::Smooth)?);
    let refused = |polygon: &ControlPolygon<f64, 2>, intervals: &[f64]| {
        polygon.clone().with_intervals(intervals.to_vec()).unwrap_err()
    };
    let torn = |index, count| Error::from(MeshError::Torn { index, count });
    assert_eq!(refused(&ring, &[1.0, 0.0, 0.0, 1.0]), torn(1, 2));
    assert_eq!(refused(&ring, &[0.0, 1.0, 1.0, 0.0]), torn(3, 2));
    assert_eq!(refused(&ring, &[0.0; 4]), torn(0, 2));
    assert_eq!(refused(&ring, &[1.0; 3]), Error::CoefficientCount { expected: 4, found: 3 });
    let negative = MeshError::NegativeInterval { index: 2, interval: "-1".into() };
    assert_eq!(refused(&ring, &[1.0, 1.0, -1.0, 1.0]), negative.into());
    let infinite = Error::NotFinite { what: "knot interval", index: 1 };
    assert_eq!(refused(&ring, &[1.0, f64::INFINITY, 1.0, 1.0]), infinite);
    assert_eq!(refused(&open, &[1.0, 0.0, 1.0, 1.0]), Error::UnusedCoefficient { index: 0 });
    assert_eq!(refused(&open, &[1.0, 1.0, 0.0, 1.0]), Error::UnusedCoefficient { index: 3 });

    let ring = CubicPolygon::closed(square())?;
    assert_eq!(ring.clone().with_intervals(vec![0.0, 1.0, 0.0, 0.0]).err(), Some(torn(2, 3)));
    assert!(ring.with_intervals(vec![0.0, 1.0, 1.0, 0.0]).is_ok());
    let open = CubicPolygon::open(square(), Boundary::Open)?;
    let unused = open.with_intervals(vec![1.0, 1.0, 0.0, 1.0, 1.0]).err();
    assert_eq!(unused, Some(Error::UnusedCoefficient { index: 0 }));
    Ok(())
}

#[test]
fn great_depths_are_refused_at_once() -> Result<()> {
    let (ring, cubic) = (ControlPolygon::closed(square())?, CubicPolygon::closed(square())?);
    for depth in [25, 40, 63, 64, usize::MAX] {
        assert!(matches!(ring.chaikin(depth), Err(Error::TooLarge { .. })), "{depth}");
        assert!(matches!(cubic.refined(depth), Err(Error::TooLarge { .. })), "{depth}");
    }
    Ok(())
}

/// Intervals at the ends of what floats hold give the same points as others, or a typed error.
#[test]
fn odd_floats_do_no_harm() -> Result<()> {
    let (ring, cubic) = (ControlPolygon::closed(square())?, CubicPolygon::closed(square())?);
    let close = |one: &[SVector<f64, 2>], other: &[SVector<f64, 2>]| {
        assert_eq!(one.len(), other.len());
        one.iter().zip(other).for_each(|(p, q)| assert!((p - q).norm() < 1e-14, "{p} {q}"));
    };
    for size in [f64::MAX, 1e308, 5e307, 1e307, 1e-308, 5e-324] {
        let beyond = Error::NotFinite { what: "sum of knot intervals", index: 0 };
        let (large, all) = (size > 2e307, vec![size; 4]);
        match (ring.clone().with_intervals(all.clone()), cubic.clone().with_intervals(all)) {
            (Ok(ring_of), Ok(cubic_of)) if !large => {
                close(&ring_of.joints(), &ring.joints());
                close(&cubic_of.limit_points(), &cubic.limit_points());
                if size > 1e-320 {
                    close(ring_of.chaikin(1)?.points(), ring.chaikin(1)?.points());
                    close(cubic_of.refined(1)?.points(), cubic.refined(1)?.points());
                    assert!(ring_of.curve().is_ok_and(|curve| curve.coeffs().len() == 4), "{size:e}");
                } else {
                    assert!(ring_of.chaikin(1).is_err() && cubic_of.refined(1).is_err());
                    assert!(ring_of.curve().is_err());
                }
            }
            (Err(one), Err(other)) if large => assert!(one == beyond && other == beyond, "{one} {other}"),
            (one, other) => panic!("{size:e}: {one:?} {other:?}"),
        }
    }
    let huge: Vec<_> = square().iter().map(|p| p * f64::MAX).collect();
    assert!(ControlPolygon::closed(huge)?.chaikin(3).is_ok());
    Ok(())
}
