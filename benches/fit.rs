//! What do least squares cost? A cubic plane curve with 72 control points through 800 points, and growth in the
//! number of points: time a point.

use criterion::Throughput;
use nalgebra::SVector;
use numbers::{Group, Numbers, Question, assert_close};
use std::hint::black_box;
use symspline::{Curve, Ends, Result, Scalar, approximation_space};

fn main() -> Result<()> {
    numbers::run::<Fits>()
}

struct Fits;

impl Question for Fits {
    const NAME: &'static str = "fit";
    type Size = (usize, usize);
    const FLOATS: &'static [Self::Size] = &[(800, 72), (8000, 72), (80_000, 72)];
    const FRACTIONS: &'static [Self::Size] = &[(40, 10), (400, 100)];
    const IMAGES: &'static [Self::Size] = &[(40, 10)];

    fn ask<T: Scalar>(
        group: &mut Group<'_>,
        numbers: &Numbers<T>,
        (points, controls): Self::Size,
    ) -> Result<()> {
        let accuracy = T::int(points as i64) * (numbers.epsilon)();
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
}
