//! Chaikin's rule inserts knots, and conversion raises the degree.

use crate::polygons::drawn::{Point, knots, quadratics, within};
use nalgebra::vector;
use proptest::prelude::*;
use symspline::{Boundary, ControlPolygon, Curve, Q, Result, Scalar};

fn point(x: i64, y: i64) -> Point {
    vector![Q::int(x), Q::int(y)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn steps_are_bisections(polygon in quadratics(), depth in 0_usize..4) {
        let (coarse, fine) = (polygon.curve()?, polygon.chaikin(depth)?);
        prop_assert_eq!(fine.points().len(), fine.intervals().len());
        let fine = fine.curve()?;
        prop_assert_eq!(&within(&coarse, &fine)?, &fine);
        let mut halved = coarse;
        for _ in 0..depth {
            halved = halved.embedded(&halved.space().bisected()?)?;
        }
        prop_assert_eq!(knots(&fine), knots(&halved));
        if fine.space().is_periodic() {
            prop_assert_eq!(fine, halved);
        }
    }

    #[test]
    fn steps_follow_each_other(polygon in quadratics()) {
        prop_assert_eq!(polygon.chaikin(1)?.chaikin(2)?, polygon.chaikin(3)?);
    }

    #[test]
    fn conversion_raises_the_degree(polygon in quadratics()) {
        let (raised, cubic) = (polygon.curve()?.elevated(1)?, polygon.converted()?.curve()?);
        prop_assert_eq!(&within(&raised, &cubic)?, &cubic);
        prop_assert_eq!(knots(&cubic), knots(&raised));
    }

    /// The segment of vertex `i` ends on leg `i`; the curve begins on leg 0.
    #[test]
    fn joints_are_at_the_knots(polygon in quadratics()) {
        let curve = polygon.curve()?;
        let joints = polygon.joints();
        prop_assert_eq!(joints.len(), polygon.points().len() - usize::from(!polygon.is_closed()));
        let mut x = Q::int(0);
        for (i, joint) in joints.iter().enumerate() {
            if i > 0 {
                x += &polygon.intervals()[i];
            }
            prop_assert_eq!(&curve.at(&x)?, joint, "{}", i);
        }
    }
}

#[test]
fn the_uniform_closed_curve_is_the_one_over_the_unit_interval() -> Result<()> {
    let points = vec![point(0, 0), point(7, 1), point(5, 9), point(-2, 4)];
    let unit = Curve::closed(2, points.clone())?;
    let polygon = ControlPolygon::closed(points)?;
    let curve = polygon.curve()?;
    assert_eq!(curve.coeffs(), unit.coeffs());
    assert_eq!(curve.at(&Q::frac(7, 3))?, unit.at(&Q::frac(7, 12))?);
    let fine = unit.embedded(&unit.space().bisected()?)?;
    assert_eq!(polygon.chaikin(1)?.points(), fine.coeffs());
    assert_eq!(polygon.converted()?.points(), unit.elevated(1)?.coeffs());
    Ok(())
}

#[test]
fn curves_of_open_polygons_begin_where_they_should() -> Result<()> {
    let points = vec![point(0, 0), point(4, 0), point(4, 8), point(0, 8)];
    for (boundary, start, count) in [
        (Boundary::Open, point(2, 0), 6),
        (Boundary::Smooth, point(0, 0), 6),
        (Boundary::Corners, point(0, 0), 6),
    ] {
        let polygon = ControlPolygon::open(points.clone(), boundary)?;
        assert_eq!(polygon.joints()[0], start, "{boundary:?}");
        assert_eq!(polygon.curve()?.space().is_clamped(), boundary != Boundary::Open);
        let fine = polygon.chaikin(1)?;
        assert_eq!((fine.points().len(), &fine.joints()[0]), (count, &start), "{boundary:?}");
    }
    let clamped = ControlPolygon::open(points.clone(), Boundary::Smooth)?;
    assert_eq!(clamped.chaikin(3)?.points()[0], points[0]);
    Ok(())
}

/// A vertex without interval is a corner of the curve.
#[test]
fn corners_stay() -> Result<()> {
    let points = vec![point(0, 0), point(4, 0), point(4, 8), point(0, 8)];
    let polygon = ControlPolygon::closed(points)?.with_intervals([0, 1, 0, 2].map(Q::int).to_vec())?;
    let fine = polygon.chaikin(2)?;
    assert_eq!(fine.points().len(), 2 + 2 * 4);
    assert!([point(0, 0), point(4, 8)].iter().all(|corner| fine.points().contains(corner)));
    assert_eq!(fine.intervals()[..3], [Q::int(0), Q::frac(1, 4), Q::frac(1, 4)]);
    let cubic = polygon.converted()?;
    assert_eq!(cubic.intervals(), [0, 1, 0, 0, 2, 0].map(Q::int));
    assert_eq!((&cubic.points()[0], &cubic.points()[3]), (&point(0, 0), &point(4, 8)));
    Ok(())
}
