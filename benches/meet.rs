//! What does it cost to find where curves meet? Growth with the number of spans where meetings are few (time a span), two
//! cubics with nine meetings, a curve and itself, and a line through a surface.

use criterion::Throughput;
use nalgebra::{SVector, vector};
use std::hint::black_box;
use symspline::{Curve, Result, SplineSpace, Surface};

const TOLERANCE: f64 = 1e-9;

/// A wave with `spans` spans over `[0, 1]`.
fn wave(spans: usize, turns: f64, up: f64) -> Result<Curve<f64, 2>> {
    let space = SplineSpace::uniform(3, spans, 0.0, 1.0)?;
    let point = |x: f64| vector![x, 0.1 * (turns * x).sin() + up];
    let points = space.greville().into_iter().map(point).collect();
    Curve::new(space, points)
}

fn cubic(points: [[f64; 2]; 4]) -> Result<Curve<f64, 2>> {
    Curve::new(SplineSpace::bezier(3, 0.0, 1.0)?, points.map(SVector::from).to_vec())
}

fn main() -> Result<()> {
    let mut criterion = numbers::criterion();
    let group = &mut criterion.benchmark_group("meet");

    let wild = [[0.0, 0.0], [0.5, 10.0 / 3.0], [0.5, -7.0 / 3.0], [1.0, 1.0]];
    let (one, other) = (cubic(wild)?, cubic(wild.map(|[x, y]| [y, x]))?);
    let found = one.intersections(&other, &TOLERANCE)?;
    assert!(found.is_proved() && found.meetings.len() == 9);
    group.bench_function("nine meetings of two cubics", |b| {
        b.iter(|| one.intersections(black_box(&other), &TOLERANCE));
    });

    for spans in [100, 1000, 10_000] {
        let (one, other) = (wave(spans, 9.0, 0.0)?, wave(spans, 20.0, 0.01)?);
        let found = one.intersections(&other, &TOLERANCE)?;
        assert!(found.is_proved() && found.meetings.len() == 4);
        group.throughput(Throughput::Elements(spans as u64));
        group.bench_function(format!("two waves of {spans} spans"), |b| {
            b.iter(|| one.intersections(black_box(&other), &TOLERANCE));
        });
    }

    for spans in [100, 1000] {
        let curve = wave(spans, 9.0, 0.0)?;
        assert_eq!(curve.intersections(&curve, &TOLERANCE)?.overlaps.len(), 1);
        group.throughput(Throughput::Elements(spans as u64));
        group.bench_function(format!("a wave of {spans} spans and itself"), |b| {
            b.iter(|| curve.intersections(black_box(&curve), &TOLERANCE));
        });
    }

    let space = SplineSpace::uniform(3, 30, 0.0, 1.0)?;
    let places = space.greville();
    let height = |x: f64, y: f64| 0.1 * (9.0 * x).sin() * (7.0 * y).cos();
    let points = places.iter().flat_map(|x| places.iter().map(|y| vector![*x, *y, height(*x, *y)]));
    let surface = Surface::new(space.clone(), space, points.collect())?;
    let (origin, direction) = (vector![0.0, 0.3, 0.02], vector![1.0, 0.2, 0.0]);
    assert_eq!(surface.meet_line(&origin, &direction, &TOLERANCE)?.overlaps.len(), 0);
    group.throughput(Throughput::Elements(900));
    group.bench_function("a line and a surface of 900 patches", |b| {
        b.iter(|| surface.meet_line(black_box(&origin), &direction, &TOLERANCE));
    });
    Ok(())
}
