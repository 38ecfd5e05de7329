//! What does it cost to insert a knot in the middle of every span of a cubic space curve, all at once? Time a new
//! knot, so linear growth is a constant.

use criterion::Throughput;
use numbers::{Group, Numbers, Question, assert_close};
use std::hint::black_box;
use symspline::{Result, Scalar};

fn main() -> Result<()> {
    numbers::run::<Refinement>()
}

struct Refinement;

impl Question for Refinement {
    const NAME: &'static str = "refine";
    type Size = usize;
    const FLOATS: &'static [usize] = &[100, 1000, 10_000];
    const FRACTIONS: &'static [usize] = &[10, 100];

    fn ask<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, spans: usize) -> Result<()> {
        let epsilon = (numbers.epsilon)();
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
}
