//! What does fine tuning cost? The three plane curves of [Miura] Table 1, by their sizes: degree and number of
//! control points of the curve, degree and number of values of the scale function; uniform clamped knots.

mod numbers;

use criterion::{BenchmarkGroup, measurement::WallTime};
use nalgebra::SVector;
use numbers::{FLOATS, FRACTIONS, IMAGES, Numbers, assert_close};
use std::hint::black_box;
use symspline::{Curve, Function, Result, Scalar, SplineSpace};

fn main() -> Result<()> {
    let mut criterion = numbers::criterion();
    let mut group = criterion.benchmark_group("fine tune");
    for (curve, alpha) in [((2, 181), (1, 2)), ((3, 72), (2, 6)), ((3, 159), (2, 3))] {
        fine_tune(&mut group, &FLOATS, curve, alpha, f64::EPSILON)?;
        fine_tune(&mut group, &FRACTIONS, curve, alpha, Scalar::int(0))?;
        fine_tune(&mut group, &IMAGES, curve, alpha, Scalar::int(0))?;
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}

fn fine_tune<T: Scalar>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    numbers: &Numbers<T>,
    (degree, points): (usize, usize),
    (alpha_degree, values): (usize, usize),
    epsilon: T,
) -> Result<()> {
    let control = |i: usize| SVector::from_fn(|axis, _| (numbers.value)(2 * i + axis));
    let curve = Curve::<T, 2>::new(uniform(degree, points)?, (0..points).map(control).collect())?;
    // Between 1 and 3, so that the tangent keeps its direction.
    let scale = (0..values).map(|i| (numbers.value)(i) + T::int(2)).collect();
    let alpha = Function::new(uniform(alpha_degree, values)?, scale)?;

    let tuned = curve.fine_tuned(&alpha)?;
    for x in (0..20).map(|i| T::frac(3 * i + 1, 60)) {
        let expected = curve.derivative_at(&x, 1)? * alpha.at(&x)?;
        assert_close(&tuned.derivative_at(&x, 1)?, &expected, epsilon.clone() * T::int(100 * points as i64));
    }
    let name = format!("degree {degree}, {points} points/{}", numbers.name);
    group.bench_function(name, |b| b.iter(|| black_box(&curve).fine_tuned(&alpha)));
    Ok(())
}

/// The clamped space of dimension `dim` over uniform knots from 0 to 1.
fn uniform<T: Scalar>(degree: usize, dim: usize) -> Result<SplineSpace<T>> {
    let spans = (dim - degree) as i64;
    SplineSpace::clamped(degree, (0..=spans).map(|i| T::frac(i, spans)))
}
