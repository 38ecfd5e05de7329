//! What does a composition cost? Cubics of a line, an increasing parabola and an increasing cubic, with as many spans each,
//! their knots apart. Time a span, so linear growth is a constant.

use criterion::{BenchmarkGroup, Throughput, measurement::WallTime};
use numbers::{FLOATS, FRACTIONS, IMAGES, Numbers, assert_close};
use std::hint::black_box;
use symspline::roots::Solvable;
use symspline::{Function, Result, Scalar, SplineSpace};

fn main() -> Result<()> {
    let mut criterion = numbers::criterion();
    let mut group = criterion.benchmark_group("compose");
    for spans in [100, 1000, 10_000] {
        for degree in 1..=3 {
            compose(&mut group, &FLOATS, degree, spans, f64::EPSILON)?;
        }
    }
    for spans in [10, 100] {
        // Higher degrees cross the knots at irrational parameters.
        compose(&mut group, &FRACTIONS, 1, spans, Scalar::int(0))?;
        compose(&mut group, &IMAGES, 1, spans, Scalar::int(0))?;
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}

/// An increasing function onto `[knot(0), knot(spans)]` with `spans` spans of its own.
fn increasing<T: Scalar>(numbers: &Numbers<T>, degree: usize, spans: usize) -> Result<Function<T>> {
    let knots = (0..=spans).map(|i| T::frac(i as i64, spans as i64));
    let space = SplineSpace::clamped(degree, knots)?;
    let last = space.dim() - 1;
    let [a, b] = [0, spans].map(numbers.knot);
    let value = |i: usize| {
        let wave = T::frac([0, 1, -1][i % 3], 4);
        let rise = if i == 0 || i == last { T::int(i as i64) } else { T::int(i as i64) + wave };
        a.clone() + (b.clone() - &a) * rise / T::int(last as i64)
    };
    Function::new(space, (0..=last).map(value).collect())
}

fn compose<T: Solvable>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    numbers: &Numbers<T>,
    degree: usize,
    spans: usize,
    epsilon: T,
) -> Result<()> {
    let (outer, inner) = (numbers.function(3, spans)?, increasing(numbers, degree, spans)?);
    let composed = outer.composed(&inner)?;
    for i in 0..50 {
        let x = T::frac(2 * i + 1, 100);
        // The position in the span of the outer function is rounded relative to its whole domain.
        let accuracy = T::int(8 * spans as i64) * &epsilon;
        assert_close(&composed.at(&x)?, &outer.at(&inner.at(&x)?)?, accuracy);
    }
    group.throughput(Throughput::Elements(spans as u64));
    group.bench_function(format!("3 of {degree}/{}/{spans}", numbers.name), |b| {
        b.iter(|| black_box(&outer).composed(&inner));
    });
    Ok(())
}
