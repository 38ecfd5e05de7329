//! What does it cost to remove the knots that were inserted in the middle of every span of a cubic space curve? Time a
//! knot, so linear growth is a constant.

use criterion::{BenchmarkGroup, Throughput, measurement::WallTime};
use numbers::{FLOATS, FRACTIONS, IMAGES, Numbers, assert_close};
use std::hint::black_box;
use symspline::{Result, Scalar};

fn main() -> Result<()> {
    let mut criterion = numbers::criterion();
    let mut group = criterion.benchmark_group("remove");
    for knots in [100, 1000, 10_000] {
        remove(&mut group, &FLOATS, knots, 1e-12)?;
    }
    for knots in [10, 100] {
        remove(&mut group, &FRACTIONS, knots, Scalar::int(0))?;
        remove(&mut group, &IMAGES, knots, Scalar::int(0))?;
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}

fn remove<T: Scalar>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    numbers: &Numbers<T>,
    knots: usize,
    tolerance: T,
) -> Result<()> {
    let curve = numbers.curve::<3>(3, knots)?;
    let fine = curve.embedded(&curve.space().bisected()?)?;
    let thin = fine.without_spare_knots(&tolerance)?;
    assert_eq!(thin.spline.space(), curve.space());
    assert!(thin.bound <= tolerance);
    for (found, expected) in thin.spline.coeffs().iter().zip(curve.coeffs()) {
        assert_close(found, expected, T::int(10) * tolerance.clone());
    }

    group.throughput(Throughput::Elements(knots as u64));
    group.bench_function(format!("all that were inserted/{}/{knots}", numbers.name), |b| {
        b.iter(|| black_box(&fine).without_spare_knots(&tolerance));
    });
    group.bench_function(format!("none of the others/{}/{knots}", numbers.name), |b| {
        b.iter(|| black_box(&curve).without_spare_knots(&tolerance));
    });
    Ok(())
}
