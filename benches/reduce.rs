//! What does it cost to lower the degree of a cubic space curve that was elevated by one, and to approximate it by
//! parabolas? Time a control point of the cubic, so linear growth is a constant.

use criterion::{BenchmarkGroup, Throughput, measurement::WallTime};
use numbers::{FLOATS, FRACTIONS, IMAGES, Numbers, assert_close};
use std::hint::black_box;
use symspline::{Contact, Continuity, Result, Scalar};

fn main() -> Result<()> {
    let mut criterion = numbers::criterion();
    let mut group = criterion.benchmark_group("reduce");
    for points in [100, 1000, 10_000] {
        reduce(&mut group, &FLOATS, points, 1e-13)?;
    }
    for points in [10, 100] {
        reduce(&mut group, &FRACTIONS, points, Scalar::int(0))?;
        reduce(&mut group, &IMAGES, points, Scalar::int(0))?;
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}

fn reduce<T: Scalar>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    numbers: &Numbers<T>,
    points: usize,
    accuracy: T,
) -> Result<()> {
    let curve = numbers.curve::<3>(3, points - 3)?;
    let elevated = curve.elevated(1)?;
    let lowered = elevated.degree_lowered(1)?;
    assert_eq!(lowered.spline.space(), curve.space());
    assert!(lowered.bound <= accuracy.clone() * T::int(10));
    for (found, expected) in lowered.spline.coeffs().iter().zip(curve.coeffs()) {
        assert_close(found, expected, accuracy.clone());
    }

    group.throughput(Throughput::Elements(points as u64));
    group.bench_function(format!("elevate and undo/{}/{points}", numbers.name), |b| {
        b.iter(|| black_box(&curve).elevated(1)?.degree_lowered(1));
    });
    if !T::EXACT {
        let parabolas =
            |curve: &symspline::Curve<T, 3>| curve.degree_reduced(1, Continuity::AtMost(0), Contact::both(1));
        assert!(parabolas(&curve)?.bound <= T::frac(1, 2));
        group.bench_function(format!("least squares/{}/{points}", numbers.name), |b| {
            b.iter(|| parabolas(black_box(&curve)));
        });
    }
    Ok(())
}
