//! Refining cubic polygons inserts knots.

use crate::polygons::drawn::{Point, cubics, knots, quadratics, within};
use nalgebra::vector;
use proptest::prelude::*;
use symspline::{Boundary, CubicPolygon, Q, Result, Scalar, SplineSpace};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn steps_are_bisections(polygon in cubics(), depth in 0_usize..3) {
        let (coarse, fine) = (polygon.curve()?, polygon.refined(depth)?.curve()?);
        prop_assert_eq!(&within(&coarse, &fine)?, &fine);
        let mut halved = coarse.space().clone();
        for _ in 0..depth {
            halved = halved.bisected()?;
        }
        let halved = coarse.embedded(&halved)?;
        prop_assert_eq!(knots(&fine), knots(&halved));
        if fine.space().is_periodic() {
            prop_assert_eq!(fine, halved);
        }
    }

    #[test]
    fn steps_commute_with_conversion(polygon in quadratics()) {
        let (one, other) = (polygon.converted()?.refined(1)?.curve()?, polygon.chaikin(1)?.converted()?.curve()?);
        prop_assert_eq!(within(&one, &other)?, other);
    }

    /// Vertex `i` is above the knot where leg `i` begins; the curve begins at vertex 1.
    #[test]
    fn limit_points_are_at_the_knots(polygon in cubics()) {
        let (curve, count) = (polygon.curve()?, polygon.points().len());
        let limits = polygon.limit_points();
        let first = usize::from(!polygon.is_closed());
        prop_assert_eq!(limits.len(), count - 2 * first);
        let mut x = Q::int(0);
        for i in 1..count + 1 - 2 * first {
            prop_assert_eq!(&curve.at(&x)?, &limits[(i - first) % count], "{}", i);
            x += &polygon.intervals()[(i + first) % polygon.intervals().len()];
        }
    }
}

fn point(x: i64, y: i64) -> Point {
    vector![Q::int(x), Q::int(y)]
}

#[test]
fn open_polygons_have_the_usual_spaces() -> Result<()> {
    let points = vec![point(0, 0), point(4, 0), point(4, 8), point(0, 8), point(1, 5)];
    let clamped = CubicPolygon::open(points.clone(), Boundary::Smooth)?;
    assert_eq!(clamped.curve()?.space(), &SplineSpace::clamped(3, [0, 1, 2].map(Q::int))?);
    assert_eq!(clamped.refined(2)?.points().last(), points.last());
    let open = CubicPolygon::open(points, Boundary::Open)?.curve()?;
    assert_eq!(open.space(), &SplineSpace::new(3, (-3..6).map(Q::int))?);
    Ok(())
}
