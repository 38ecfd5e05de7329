//! Polygons with corner cases: knot intervals that vanish, as many in a row as may be.

use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use symspline::{ControlPolygon, CubicPolygon, Curve, Q, Result, Scalar};

pub type Point = SVector<Q, 2>;

fn points(least: usize) -> impl Strategy<Value = Vec<Point>> {
    let point = (-20_i64..20, -20_i64..20, 1_i64..4).prop_map(|(x, y, q)| vector![Q::frac(x, q), Q::int(y)]);
    vec(point, least..least + 5)
}

/// Intervals, of which no `most + 1` in a row vanish, around or not.
fn intervals(count: usize, most: usize) -> impl Strategy<Value = Vec<Q>> {
    let interval = select(vec![(0, 1), (0, 1), (1, 1), (1, 1), (2, 1), (1, 3), (5, 2)]);
    vec(interval, count).prop_map(move |drawn| {
        let mut found: Vec<Q> = drawn.into_iter().map(|(p, q)| Q::frac(p, q)).collect();
        let zero = Q::int(0);
        for i in 0..2 * count {
            if (0..=most).all(|back| found[(i + count - back) % count] == zero) {
                found[i % count] = Q::int(1);
            }
        }
        found
    })
}

/// Puts in a knot interval where the domain of an open curve begins and ends.
fn opened(mut intervals: Vec<Q>, degree: usize) -> Vec<Q> {
    let last = intervals.len() - degree;
    for i in [degree - 1, last] {
        if intervals[i] == Q::int(0) {
            intervals[i] = Q::int(3);
        }
    }
    intervals
}

pub fn quadratics() -> impl Strategy<Value = ControlPolygon<Q, 2>> {
    let drawn = (points(3), any::<bool>()).prop_flat_map(|(points, closed)| {
        let count = points.len();
        (Just(points), Just(closed), intervals(count, 1))
    });
    drawn.prop_map(|(points, closed, intervals)| {
        let (polygon, intervals) = match closed {
            true => (ControlPolygon::closed(points), intervals),
            false => (ControlPolygon::open(points, symspline::Boundary::Open), opened(intervals, 2)),
        };
        polygon.and_then(|polygon| polygon.with_intervals(intervals)).expect("a polygon with a curve")
    })
}

pub fn cubics() -> impl Strategy<Value = CubicPolygon<Q, 2>> {
    let drawn = (points(4), any::<bool>()).prop_flat_map(|(points, closed)| {
        let count = points.len() + usize::from(!closed);
        (Just(points), Just(closed), intervals(count, 2))
    });
    drawn.prop_map(|(points, closed, intervals)| {
        let (polygon, intervals) = match closed {
            true => (CubicPolygon::closed(points), intervals),
            false => (CubicPolygon::open(points, symspline::Boundary::Open), opened(intervals, 3)),
        };
        polygon.and_then(|polygon| polygon.with_intervals(intervals)).expect("a polygon with a curve")
    })
}

/// The curve in the space of another, which must be finer.
pub fn within(curve: &Curve<Q, 2>, finer: &Curve<Q, 2>) -> Result<Curve<Q, 2>> {
    curve.embedded(finer.space())
}

/// The knots inside the domain, and how often each counts.
pub fn knots(curve: &Curve<Q, 2>) -> Vec<(Q, usize)> {
    let breaks = curve.space().breaks();
    match curve.space().is_periodic() {
        true => breaks,
        false => breaks[1..breaks.len() - 1].to_vec(),
    }
}
