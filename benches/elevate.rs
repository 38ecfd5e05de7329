//! What does it cost to raise the degree of a cubic space curve by one? Time a control point, so linear growth is a
//! constant.

use criterion::Throughput;
use numbers::{Group, Numbers, Question, assert_close};
use std::hint::black_box;
use symspline::{Result, Scalar};

fn main() -> Result<()> {
    numbers::run::<Elevation>()
}

struct Elevation;

impl Question for Elevation {
    const NAME: &'static str = "elevate";
    type Size = usize;
    const FLOATS: &'static [usize] = &[100, 1000, 10_000];
    const FRACTIONS: &'static [usize] = &[10, 100];

    fn ask<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, points: usize) -> Result<()> {
        let epsilon = (numbers.epsilon)();
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
}
