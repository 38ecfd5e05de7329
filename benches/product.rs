//! What does a product cost? Parabolas, cubics, and a scalar with a plane curve, over the same uneven knots. Time a
//! span, so linear growth is a constant.

use criterion::Throughput;
use numbers::{Group, Numbers, Question, assert_close};
use std::hint::black_box;
use symspline::{Coeff, Function, Result, Scalar, Spline};

fn main() -> Result<()> {
    numbers::run::<Products>()
}

struct Products;

impl Question for Products {
    const NAME: &'static str = "product";
    type Size = usize;
    const FLOATS: &'static [usize] = &[100, 1000, 10_000];
    const FRACTIONS: &'static [usize] = &[10, 100];

    fn ask<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, spans: usize) -> Result<()> {
        let epsilon = (numbers.epsilon)();
        let [parabolas, cubics] = [2, 3].map(|degree| numbers.function(degree, spans));
        let (parabolas, cubics, curve) = (parabolas?, cubics?, numbers.curve::<2>(3, spans)?);
        group.throughput(Throughput::Elements(spans as u64));
        let samples = numbers.samples(spans, 50);
        let name = |what: &str| format!("{what}/{}/{spans}", numbers.name);
        product(group, name("2x2"), &parabolas, &parabolas, &samples, &epsilon)?;
        product(group, name("3x3"), &cubics, &cubics, &samples, &epsilon)?;
        product(group, name("2x3 curve"), &parabolas, &curve, &samples, &epsilon)
    }
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
