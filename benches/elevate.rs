//! What does it cost to raise the degree of a cubic space curve by one? Time a control point, so linear growth is a
//! constant.

mod numbers;

use criterion::{BenchmarkGroup, Throughput, measurement::WallTime};
use numbers::{FLOATS, FRACTIONS, IMAGES, Numbers, assert_close};
use std::hint::black_box;
use symspline::{Result, Scalar};

fn main() -> Result<()> {
    let mut criterion = numbers::criterion();
    let mut group = criterion.benchmark_group("elevate");
    for points in [100, 1000, 10_000] {
        elevate(&mut group, &FLOATS, points, f64::EPSILON)?;
    }
    for points in [10, 100] {
        elevate(&mut group, &FRACTIONS, points, Scalar::int(0))?;
        elevate(&mut group, &IMAGES, points, Scalar::int(0))?;
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}

fn elevate<T: Scalar>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    numbers: &Numbers<T>,
    points: usize,
    epsilon: T,
) -> Result<()> {
    let spans = points - 3;
    let curve = numbers.curve::<3>(3, spans)?;
    let elevated = curve.elevated(1)?;
    for x in numbers.samples(spans, 50) {
        assert_close(&elevated.at(&x)?, &curve.at(&x)?, T::int(8) * epsilon.clone());
    }
    let table = curve.space().embedding(elevated.space())?;
    assert_eq!(table.apply(curve.coeffs())?, elevated.coeffs());

    group.throughput(Throughput::Elements(points as u64));
    group.bench_function(format!("curve/{}/{points}", numbers.name), |b| {
        b.iter(|| black_box(&curve).elevated(1));
    });
    group.bench_function(format!("table at hand/{}/{points}", numbers.name), |b| {
        b.iter(|| table.apply(black_box(curve.coeffs())));
    });
    Ok(())
}
