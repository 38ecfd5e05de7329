//! What do an antiderivative, a definite integral and a Gram matrix cost? Time a span, so linear growth is a constant.

mod numbers;

use criterion::{BenchmarkGroup, Throughput, measurement::WallTime};
use numbers::{FLOATS, FRACTIONS, IMAGES, Numbers, assert_close};
use std::hint::black_box;
use symspline::{Result, Scalar};

fn main() -> Result<()> {
    let mut criterion = numbers::criterion();
    let mut group = criterion.benchmark_group("integrate");
    for spans in [100, 1000, 10_000] {
        integrate(&mut group, &FLOATS, spans, f64::EPSILON)?;
    }
    for spans in [10, 100] {
        integrate(&mut group, &FRACTIONS, spans, Scalar::int(0))?;
        integrate(&mut group, &IMAGES, spans, Scalar::int(0))?;
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}

fn integrate<T: Scalar>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    numbers: &Numbers<T>,
    spans: usize,
    epsilon: T,
) -> Result<()> {
    let (curve, space) = (numbers.curve::<3>(3, spans)?, numbers.space(3, spans)?);
    let (a, b) = curve.domain();
    let accuracy = epsilon * T::int(8 * spans as i64);
    let sum = curve.antiderivative()?;
    for x in numbers.samples(spans, 10) {
        assert_close(&sum.derivative_at(&x, 1)?, &curve.at(&x)?, accuracy.clone());
        assert_close(&sum.at(&x)?, &curve.integral_between(a, &x)?, accuracy.clone());
    }
    // Rows of the Gram matrix sum to the integrals of the basis functions.
    let gram = space.gram(&space, 0, 0)?;
    let masses = space.integral_between(a, b)?;
    for (row, mass) in gram.rows().zip(masses.weights()) {
        assert_close(&row.1.iter().fold(T::zero(), |sum, w| sum + w), mass, accuracy.clone());
    }

    group.throughput(Throughput::Elements(spans as u64));
    let name = |what: &str| format!("{what}/{}/{spans}", numbers.name);
    group.bench_function(name("antiderivative"), |bench| bench.iter(|| black_box(&curve).antiderivative()));
    group.bench_function(name("integral"), |bench| bench.iter(|| black_box(&curve).integral()));
    group.bench_function(name("gram"), |bench| bench.iter(|| black_box(&space).gram(&space, 0, 0)));
    Ok(())
}
