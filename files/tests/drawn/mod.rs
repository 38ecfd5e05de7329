//! Values of every kind, drawn at random, and how they are compared: bit by bit.

use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{ControlMesh, Q, Scalar, SplineSpace};
use symspline_dynamic::{
    AnyMesh, AnyRational, AnyRationalSurface, AnySpace, AnySpline, AnySurface, Coords, Number, Over, Value,
};
use symspline_files::Entry;

/// What tells values apart to the last bit, the sign of zero included.
pub fn bits(entries: &[Entry]) -> String {
    format!("{entries:?}")
}

fn float() -> impl Strategy<Value = f64> {
    const EDGES: [f64; 8] = [0.0, -0.0, 5e-324, -2.5e-310, f64::MIN_POSITIVE, 1e308, f64::MAX, 0.1];
    prop_oneof![4 => -10.0..10.0, 1 => proptest::sample::select(&EDGES[..]), 1 => prop::num::f64::NORMAL]
}

fn fraction() -> impl Strategy<Value = Q> {
    let big =
        ("-?[1-9][0-9]{20,60}", "[1-9][0-9]{20,60}").prop_map(|(p, q)| format!("{p}/{q}").parse().unwrap());
    prop_oneof![3 => (-9_i64..9, 1_i64..9).prop_map(|(p, q)| Q::frac(p, q)), 1 => big]
}

/// Whole steps between knots: none makes a knot twofold.
fn steps(degree: usize) -> impl Strategy<Value = Vec<i64>> {
    vec(0_i64..3, 2 * degree + 1..2 * degree + 6)
}

/// Spaces over either field: open with any ends, clamped, periodic; those the library refuses are drawn anew.
fn space(exact: bool) -> impl Strategy<Value = AnySpace> {
    let parts = (0_usize..4).prop_flat_map(|degree| (Just(degree), steps(degree), 0..3, -5_i64..5));
    parts.prop_filter_map("no space", move |(degree, steps, kind, start)| {
        let sums = steps.iter().scan(start, |at, step| {
            *at += step;
            Some(*at)
        });
        let knots: Vec<i64> = std::iter::once(start).chain(sums).collect();
        let end = knots[knots.len() - 1] + 1;
        if exact {
            made(degree, knots.into_iter().map(|t| Q::frac(t, 3)).collect(), Q::frac(end, 3), kind)
                .map(Over::Exact)
        } else {
            made(degree, knots.into_iter().map(|t| t as f64 * 0.1).collect(), end as f64 * 0.1, kind)
                .map(Over::Float)
        }
    })
}

fn made<T: Scalar>(degree: usize, knots: Vec<T>, end: T, kind: i32) -> Option<SplineSpace<T>> {
    match kind {
        0 => SplineSpace::new(degree, knots).ok(),
        1 => SplineSpace::clamped(degree, knots).ok(),
        _ => SplineSpace::periodic_up_to(degree, knots, end).ok(),
    }
}

fn dim(space: &AnySpace) -> usize {
    match space {
        Over::Float(s) => s.dim(),
        Over::Exact(s) => s.dim(),
    }
}

fn coords(exact: bool, count: usize) -> BoxedStrategy<Coords> {
    match exact {
        true => vec(fraction(), count).prop_map(Over::Exact).boxed(),
        false => vec(float(), count).prop_map(Over::Float).boxed(),
    }
}

fn weights(exact: bool, count: usize) -> BoxedStrategy<Coords> {
    match exact {
        true => {
            vec((1_i64..9, 1_i64..9).prop_map(|(p, q)| Q::frac(p, q)), count).prop_map(Over::Exact).boxed()
        }
        false => vec(prop_oneof![3 => 0.1..10.0, 1 => Just(1.0), 1 => Just(1e-5)], count)
            .prop_map(Over::Float)
            .boxed(),
    }
}

/// Weighted points put one by one, as no points with weights may give them.
fn weighted(points: Coords, weights: Coords, dim: usize) -> Coords {
    fn mixed<T: Clone>(points: &[T], weights: &[T], dim: usize) -> Vec<T> {
        points
            .chunks(dim)
            .zip(weights)
            .flat_map(|(point, weight)| point.iter().chain([weight]).cloned())
            .collect()
    }
    match (points, weights) {
        (Over::Float(p), Over::Float(w)) => Over::Float(mixed(&p, &w, dim)),
        (Over::Exact(p), Over::Exact(w)) => Over::Exact(mixed(&p, &w, dim)),
        _ => unreachable!("both are of one field"),
    }
}

fn curve() -> impl Strategy<Value = Value> {
    (any::<bool>(), 1_usize..4).prop_flat_map(|(exact, n)| {
        let parts = space(exact).prop_flat_map(move |s| {
            let count = dim(&s);
            (Just(s), coords(exact, count * n), weights(exact, count), 0..3)
        });
        parts.prop_filter_map("refused", move |(s, c, w, kind)| match kind {
            0 => Some(AnySpline::new(s, n, c).ok()?.into()),
            1 => Some(AnyRational::new(s, n, c, w).ok()?.into()),
            _ => Some(AnyRational::from_homogeneous(s, n, weighted(c, w, n)).ok()?.into()),
        })
    })
}

fn surface() -> impl Strategy<Value = Value> {
    (any::<bool>(), 1_usize..4).prop_flat_map(|(exact, n)| {
        let parts = (space(exact), space(exact)).prop_flat_map(move |(u, v)| {
            let count = dim(&u) * dim(&v);
            (Just(u), Just(v), coords(exact, count * n), weights(exact, count), 0..3)
        });
        parts.prop_filter_map("refused", move |(u, v, c, w, kind)| match kind {
            0 => Some(AnySurface::new(u, v, n, c).ok()?.into()),
            1 => Some(AnyRationalSurface::new(u, v, n, c, w).ok()?.into()),
            _ => Some(AnyRationalSurface::from_homogeneous(u, v, n, weighted(c, w, n)).ok()?.into()),
        })
    })
}

fn mesh() -> impl Strategy<Value = Value> {
    let points = |exact| {
        coords(exact, 15).prop_map(|c| -> AnyMesh {
            let faces: [&[usize]; 2] = [&[0, 1, 2, 3], &[2, 1, 4]];
            match c {
                Over::Float(c) => {
                    let points = c.chunks(3).map(nalgebra::SVector::<f64, 3>::from_column_slice);
                    ControlMesh::new(points.collect(), faces).unwrap().into()
                }
                Over::Exact(c) => {
                    let point = |c: &[Q]| nalgebra::SVector::<Q, 3>::from_fn(|i, _| c[i].clone());
                    ControlMesh::new(c.chunks(3).map(point).collect(), faces).unwrap().into()
                }
            }
        })
    };
    any::<bool>().prop_flat_map(points).prop_map(Value::from)
}

pub fn value() -> impl Strategy<Value = Value> {
    let number = prop_oneof![float().prop_map(Number::Float), fraction().prop_map(Number::Exact)];
    let point = (any::<bool>(), 1_usize..5).prop_flat_map(|(exact, n)| coords(exact, n));
    prop_oneof![
        1 => number.prop_map(Value::from),
        1 => point.prop_map(Value::from),
        4 => curve(),
        3 => surface(),
        1 => mesh()
    ]
}

/// A few entries, with names of any letters or none.
pub fn entries() -> impl Strategy<Value = Vec<Entry>> {
    let name = prop_oneof![Just(None), any::<String>().prop_map(Some)];
    vec((name, value()).prop_map(|(name, value)| Entry { name, value }), 0..4)
}
