//! What do least squares cost? A cubic plane curve with 72 control points through 800 points, and growth in the
//! number of points: time a point.

mod numbers;

use criterion::{BenchmarkGroup, Throughput, measurement::WallTime};
use nalgebra::SVector;
use numbers::{FLOATS, FRACTIONS, IMAGES, Numbers, assert_close};
use std::hint::black_box;
use symspline::{Curve, Ends, Result, Scalar, approximation_space};

fn main() -> Result<()> {
    let mut criterion = numbers::criterion();
    let mut group = criterion.benchmark_group("fit");
    for points in [800, 8000, 80_000] {
        fit(&mut group, &FLOATS, points, 72, points as f64 * f64::EPSILON)?;
    }
    for controls in [10, 100] {
        fit(&mut group, &FRACTIONS, 4 * controls, controls, Scalar::int(0))?;
    }
    fit(&mut group, &IMAGES, 40, 10, Scalar::int(0))?;
    group.finish();
    criterion.final_summary();
    Ok(())
}

fn fit<T: Scalar>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    numbers: &Numbers<T>,
    points: usize,
    controls: usize,
    accuracy: T,
) -> Result<()> {
    let parameters: Vec<T> = (0..points).map(numbers.knot).collect();
    let data: Vec<SVector<T, 2>> =
        (0..points).map(|i| SVector::from_fn(|axis, _| (numbers.value)(2 * i + axis))).collect();
    let space = approximation_space(3, &parameters, controls)?;
    // The fit of points on a spline of the space is that spline.
    let control = |i: usize| SVector::from_fn(|axis, _| (numbers.value)(2 * i + axis));
    let original = Curve::<T, 2>::new(space.clone(), (0..controls).map(control).collect())?;
    let found = Curve::least_squares(&space, &parameters, &original.eval(&parameters)?, Ends::Held)?;
    for (c, d) in found.coeffs().iter().zip(original.coeffs()) {
        assert_close(c, d, accuracy.clone());
    }

    group.throughput(Throughput::Elements(points as u64));
    group.bench_function(format!("{}/{points} points, {controls} controls", numbers.name), |b| {
        b.iter(|| Curve::least_squares(&space, black_box(&parameters), &data, Ends::Held));
    });
    Ok(())
}
