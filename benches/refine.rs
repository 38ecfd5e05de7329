//! What does it cost to insert a knot in the middle of every span of a cubic space curve, all at once? Time a new
//! knot, so linear growth is a constant.

mod numbers;

use criterion::{BenchmarkGroup, Throughput, measurement::WallTime};
use numbers::{FLOATS, FRACTIONS, IMAGES, Numbers, assert_close};
use std::hint::black_box;
use symspline::{Result, Scalar};

fn main() -> Result<()> {
    let mut criterion = numbers::criterion();
    let mut group = criterion.benchmark_group("refine");
    for spans in [100, 1000, 10_000] {
        refine(&mut group, &FLOATS, spans, f64::EPSILON)?;
    }
    for spans in [10, 100] {
        refine(&mut group, &FRACTIONS, spans, Scalar::int(0))?;
        refine(&mut group, &IMAGES, spans, Scalar::int(0))?;
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}

fn refine<T: Scalar>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    numbers: &Numbers<T>,
    spans: usize,
    epsilon: T,
) -> Result<()> {
    let curve = numbers.curve::<3>(3, spans)?;
    let middle = |i: usize| ((numbers.knot)(i) + (numbers.knot)(i + 1)) / T::int(2);
    let knots: Vec<T> = (0..spans).map(middle).collect();
    let refined = curve.inserted(&knots)?;
    assert_eq!(refined.coeffs().len(), curve.coeffs().len() + spans);
    for x in numbers.samples(spans, 50) {
        assert_close(&refined.at(&x)?, &curve.at(&x)?, T::int(8) * epsilon.clone());
    }

    group.throughput(Throughput::Elements(spans as u64));
    group.bench_function(format!("{}/{spans}", numbers.name), |b| {
        b.iter(|| curve.inserted(black_box(&knots)));
    });
    Ok(())
}
