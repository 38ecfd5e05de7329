//! What do the cheap operators cost on a cubic space curve: sums, derivatives, cutting, opening, joining, reversing,
//! stretching? Time a span, so linear growth is a constant.

use criterion::Throughput;
use numbers::{Group, Numbers, Question, assert_close};
use std::hint::black_box;
use symspline::{Curve, Result, Scalar, SplineSpace};

fn main() -> Result<()> {
    numbers::run::<Rearrangement>()
}

struct Rearrangement;

impl Question for Rearrangement {
    const NAME: &'static str = "rearrange";
    type Size = usize;
    const FLOATS: &'static [usize] = &[100, 1000, 10_000];
    const FRACTIONS: &'static [usize] = &[10, 100];

    fn ask<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, spans: usize) -> Result<()> {
        let epsilon = (numbers.epsilon)();
        let (cubic, quadratic) = (numbers.curve::<3>(3, spans)?, numbers.curve::<3>(2, spans)?);
        let (a, b) = cubic.domain();
        let third = a.clone() + (b.clone() - a) / T::int(3);
        let (left, right) = cubic.split(&third)?;
        let round = SplineSpace::periodic(3, (0..spans).map(numbers.knot), (numbers.knot)(spans))?;
        let ring = Curve::new(round, cubic.coeffs()[..spans].to_vec())?;
        let joined = left.join(&right)?;
        for x in numbers.samples(spans, 50) {
            let accuracy = T::int(32) * epsilon.clone();
            assert_close(
                &(&cubic + &quadratic).at(&x)?,
                &(cubic.at(&x)? + quadratic.at(&x)?),
                accuracy.clone(),
            );
            assert_close(&joined.at(&x)?, &cubic.at(&x)?, accuracy.clone());
            assert_close(&ring.clamped_ends()?.at(&x)?, &ring.at(&x)?, accuracy);
        }

        group.throughput(Throughput::Elements(spans as u64));
        let mut bench = |what: &str, work: &dyn Fn() -> Result<Curve<T, 3>>| {
            group
                .bench_function(format!("{what}/{}/{spans}", numbers.name), |b| b.iter(|| black_box(work())));
        };
        bench("sum of degrees 2 and 3", &|| cubic.sum(&quadratic));
        bench("sum in one space", &|| cubic.sum(&cubic));
        bench("scaled", &|| cubic.scaled(&third));
        bench("derivative", &|| cubic.derivative());
        bench("split", &|| Ok(cubic.split(&third)?.1));
        bench("pieces", &|| cubic.embedded(&cubic.space().pieces(3)?));
        bench("clamped ring", &|| ring.clamped_ends());
        bench("join", &|| left.join(&right));
        bench("reversed", &|| cubic.reversed());
        bench("reparametrised", &|| cubic.reparametrised(&T::int(0), &T::int(1)));
        Ok(())
    }
}
