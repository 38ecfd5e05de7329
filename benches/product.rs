//! What does a product cost? Parabolas, cubics, and a scalar with a plane curve, over the same uneven knots. Time a
//! span, so linear growth is a constant.

mod numbers;

use criterion::{BenchmarkGroup, Throughput, measurement::WallTime};
use numbers::{FLOATS, FRACTIONS, IMAGES, Numbers, assert_close};
use std::hint::black_box;
use symspline::{Coeff, Function, Result, Scalar, Spline};

type Group<'a> = BenchmarkGroup<'a, WallTime>;

fn main() -> Result<()> {
    let mut criterion = numbers::criterion();
    let mut group = criterion.benchmark_group("product");
    for spans in [100, 1000, 10_000] {
        products(&mut group, &FLOATS, spans, f64::EPSILON)?;
    }
    for spans in [10, 100] {
        products(&mut group, &FRACTIONS, spans, Scalar::int(0))?;
        products(&mut group, &IMAGES, spans, Scalar::int(0))?;
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}

fn products<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, spans: usize, epsilon: T) -> Result<()> {
    let [parabolas, cubics] = [2, 3].map(|degree| numbers.function(degree, spans));
    let (parabolas, cubics, curve) = (parabolas?, cubics?, numbers.curve::<2>(3, spans)?);
    group.throughput(Throughput::Elements(spans as u64));
    let samples = numbers.samples(spans, 50);
    let name = |what: &str| format!("{what}/{}/{spans}", numbers.name);
    product(group, name("2x2"), &parabolas, &parabolas, &samples, &epsilon)?;
    product(group, name("3x3"), &cubics, &cubics, &samples, &epsilon)?;
    product(group, name("2x3 curve"), &parabolas, &curve, &samples, &epsilon)
}

fn product<T: Scalar, C: Coeff<T>>(
    group: &mut Group<'_>,
    name: String,
    f: &Function<T>,
    g: &Spline<T, C>,
    samples: &[T],
    epsilon: &T,
) -> Result<()> {
    let product = g.times(f)?;
    for x in samples {
        let expected = g.at(x)?.scaled(&f.at(x)?);
        assert_close(&product.at(x)?, &expected, T::int(32) * epsilon);
    }
    group.bench_function(name, |b| b.iter(|| black_box(g).times(f)));
    Ok(())
}
