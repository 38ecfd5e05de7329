//! Laws of total curvature and turning angles: against sums of angles between close tangents, and each other.

use crate::strategies::{ANY, Kind, cases, curve};
use nalgebra::{SVector, vector};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};
use symspline::{Analyse, Bounds, Curve, EventKind, Q, Scalar, SplineSpace, Turning, circle, ellipse};

const SMALL: Kind = ANY.of_degree(1, 4).few(2);

fn meet(one: Bounds, other: Bounds) -> bool {
    one.low <= other.high && other.low <= one.high
}

/// The sums of the angles between tangents at close parameters within spans, all positive and with signs.
fn sums(c: &Curve<Q, 2>) -> (f64, f64) {
    let breaks = c.space().breaks();
    let (mut total, mut signed) = (0.0, 0.0);
    for ends in breaks.windows(2) {
        let (a, b) = (&ends[0].0, &ends[1].0);
        let mut last: Option<SVector<f64, 2>> = None;
        for i in 1..200 {
            let d = c.derivative_at(&(a + (b - a) * Q::frac(i, 200)), 1).expect("inside");
            let size = d.iter().map(Q::abs).max().expect("two");
            if size == Q::int(0) {
                continue;
            }
            let d = d.map(|x| (x / &size).to_f64());
            if let Some(last) = last.replace(d) {
                let angle = (last[0] * d[1] - last[1] * d[0]).atan2(last.dot(&d));
                (total, signed) = (total + angle.abs(), signed + angle);
            }
        }
    }
    (total, signed)
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn total_curvature_is_above_every_polygon_of_tangents(c in curve::<2>(SMALL)) {
        let found = c.total_curvature(1e-3)?;
        prop_assert!(0.0 <= found.low && found.low <= found.high);
        prop_assert!(sums(&c).0 <= found.high + 1e-9);
    }

    #[test]
    fn total_curvature_does_not_depend_on_the_space(c in curve::<3>(SMALL)) {
        let found = c.total_curvature(1e-3)?;
        prop_assert!(meet(found, c.elevated(1)?.total_curvature(1e-3)?));
        prop_assert!(meet(found, c.reversed()?.total_curvature(1e-3)?));
        let (left, right) = c.split(&((c.domain().0 + c.domain().1) / Q::int(2)))?;
        let (left, right) = (left.total_curvature(1e-3)?, right.total_curvature(1e-3)?);
        let both = Bounds { low: left.low + right.low - 1e-12, high: left.high + right.high + 1e-12 };
        // A cut at a cusp loses its half turn.
        prop_assert!(both.low <= found.high && found.low <= both.high + PI);
    }

    #[test]
    fn turning_is_the_angle_between_the_ends(c in curve::<2>(SMALL.of_degree(2, 4))) {
        let Ok(turning) = c.turning_angle() else { return Ok(()) };
        let total = c.total_curvature(1e-6)?;
        prop_assert!(turning.high >= -total.high - 1e-9 && turning.low <= total.high + 1e-9);
        let profile = c.profile()?;
        let smooth = [EventKind::Corner, EventKind::Cusp, EventKind::Gap, EventKind::Stationary];
        if smooth.iter().all(|kind| profile.count(*kind) == 0) {
            // Up to whole turns.
            let (a, b) = c.domain();
            let ends = [c.derivative_at(a, 1)?, c.derivative_at(b, 1)?].map(|d| d.map(|x| x.to_f64()));
            let angle = (ends[0][0] * ends[1][1] - ends[0][1] * ends[1][0]).atan2(ends[0].dot(&ends[1]));
            let whole = angle + ((turning.middle() - angle) / TAU).round() * TAU;
            prop_assert!(turning.low - 1e-9 <= whole && whole <= turning.high + 1e-9);
        }
    }
}

#[test]
fn known_curves_turn_as_they_should() {
    let origin = vector![Q::int(0), Q::int(0)];
    let circle = circle(&origin, &Q::int(3)).expect("a circle");
    let ellipse =
        ellipse(&origin, &vector![Q::int(5), Q::int(0)], &vector![Q::int(0), Q::int(1)]).expect("an ellipse");
    for curve in [circle, ellipse] {
        for found in [curve.total_curvature(1e-12).expect("bounds"), curve.turning_angle().expect("bounds")] {
            assert!(found.low <= TAU && TAU <= found.high && found.high - found.low < 1e-11);
        }
    }
    // There and back: a cusp counts a half turn, a line nothing.
    let line = |points: [i64; 3]| {
        let points = points.map(|x| vector![Q::int(x), Q::int(0)]);
        Curve::new(SplineSpace::bezier(2, Q::int(0), Q::int(1)).expect("a domain"), points.to_vec())
            .expect("points")
    };
    let back = line([0, 2, 0]).total_curvature(1e-9).expect("bounds");
    assert!(back.low <= PI && PI <= back.high && back.high - back.low < 1e-9);
    assert!(line([0, 1, 3]).total_curvature(1e-9).expect("bounds").high < 1e-12);
    assert!(line([0, 2, 0]).turning_angle().is_err() && line([0, 0, 3]).turning_angle().is_ok());
    // An S of two quarters: nothing in all, a half turn without signs.
    let points = [[0, 0], [2, 0], [2, 2], [2, 4], [4, 4]].map(|c| c.map(Q::int).into()).to_vec();
    let space = SplineSpace::clamped(2, [0, 1, 1, 2].map(Q::int)).expect("knots ascend");
    let bend = Curve::<Q, 2>::new(space, points).expect("five points");
    let (angle, total) =
        (bend.turning_angle().expect("bounds"), bend.total_curvature(1e-12).expect("bounds"));
    assert!(angle.low <= 0.0 && 0.0 <= angle.high && angle.high < 1e-12);
    assert!(total.low <= PI && PI <= total.high && total.high - total.low < 1e-11);
}

#[test]
fn spans_of_all_lengths_and_double_points_do_not_spoil_the_bounds() {
    // From a span of a million to one of a millionth and back: the directions are small differences of large numbers.
    let knots = [0.0, 1e6, 1e6 + 1e-6, 1e6 + 1.0];
    let points = [[0.0, 0.0], [0.0, -1e9], [1e9, 0.0], [0.0, 0.0], [0.0, -1.0]].map(SVector::from);
    let sharp = Curve::new(SplineSpace::clamped(2, knots).expect("knots ascend"), points.to_vec());
    // It stands still at a knot, as every curve of degree 2 with a double point, and the knots are not round.
    let knots = [0.0, 0.14, 0.45, 0.71, 1.3];
    let points = [[0.2, 0.1], [0.2, 0.0], [0.2, 0.0], [0.0, 0.1], [0.0, 0.2], [0.1, 0.3]].map(SVector::from);
    let double = Curve::new(SplineSpace::clamped(2, knots).expect("knots ascend"), points.to_vec());
    for curve in [sharp.expect("five points"), double.expect("six points")] {
        let (total, turning) =
            (curve.total_curvature(1e-6).expect("bounds"), curve.turning_angle().expect("bounds"));
        assert!(total.high - total.low <= 1e-6 && turning.high - turning.low < 1e-9, "{total:?} {turning:?}");
        assert!(turning.high.abs() <= total.high + 1e-9);
    }
}
