//! What do an antiderivative, a definite integral and a Gram matrix cost? Time a span, so linear growth is a constant.

use criterion::Throughput;
use numbers::{Group, Numbers, Question, assert_close};
use std::hint::black_box;
use symspline::{Result, Scalar};

fn main() -> Result<()> {
    numbers::run::<Integrals>()
}

struct Integrals;

impl Question for Integrals {
    const NAME: &'static str = "integrate";
    type Size = usize;
    const FLOATS: &'static [usize] = &[100, 1000, 10_000];
    const FRACTIONS: &'static [usize] = &[10, 100];

    fn ask<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, spans: usize) -> Result<()> {
        let epsilon = (numbers.epsilon)();
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
        group.bench_function(name("antiderivative"), |bench| {
            bench.iter(|| black_box(&curve).antiderivative());
        });
        group.bench_function(name("integral"), |bench| bench.iter(|| black_box(&curve).integral()));
        group.bench_function(name("gram"), |bench| bench.iter(|| black_box(&space).gram(&space, 0, 0)));
        Ok(())
    }
}
