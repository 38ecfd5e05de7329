//! What does fine tuning of a surface cost? The five surfaces of [Miura] Table 1, by their sizes: bicubic, the number of
//! control points in each direction, a biquadratic scale function and the number of its values; uniform clamped knots.
//!
//! Whole along one path and two, with held boundary; while a value of the scale is dragged; and how both grow with the
//! number of patches, the scale with one value a patch.

use nalgebra::SVector;
use numbers::{Group, Numbers, Question, assert_close};
use std::hint::black_box;
use symspline::{
    Edge, Edges, Fit, Norm, Path, Result, Scalar, SplineSpace, Surface, SurfaceCondition, SurfaceTuner,
    TensorSpline,
};

fn main() -> Result<()> {
    numbers::run::<FineTuning>()
}

struct FineTuning;

impl Question for FineTuning {
    const NAME: &'static str = "fine tune surface";
    /// Control points and values of the scale in each direction.
    type Size = [(usize, usize); 2];
    const FLOATS: &'static [Self::Size] = &[
        [(4, 4), (3, 3)],
        [(4, 4), (3, 4)],
        [(5, 5), (3, 3)],
        [(4, 8), (3, 3)],
        [(6, 12), (3, 4)],
        // Patches with a value each.
        [(7, 7), (6, 6)],
        [(11, 11), (10, 10)],
        [(19, 19), (18, 18)],
        [(35, 35), (34, 34)],
    ];
    const FRACTIONS: &'static [Self::Size] = &[[(4, 4), (3, 3)], [(6, 12), (3, 4)]];

    fn ask<T: Scalar>(
        group: &mut Group<'_>,
        numbers: &Numbers<T>,
        [(rows, columns), (height, width)]: Self::Size,
    ) -> Result<()> {
        let control = |i: usize| SVector::from_fn(|axis, _| (numbers.value)(3 * i + axis));
        let points = (0..rows * columns).map(control).collect();
        let surface = Surface::<T, 2>::new(uniform(3, rows)?, uniform(3, columns)?, points)?;
        // Between 1 and 3, so that it is positive.
        let values: Vec<T> = (0..height * width).map(|i| (numbers.value)(i) + T::int(2)).collect();
        let alpha = TensorSpline::new(uniform(2, height)?, uniform(2, width)?, values)?;
        let (scales, size) = ((alpha.u(), alpha.v()), format!("{rows} x {columns}, {height} x {width}"));

        let whole = surface.fine_tuned(&alpha, Path::UThenV)?;
        let tolerance = (numbers.epsilon)() * T::int(1000 * (rows + columns) as i64);
        for i in 0..20 {
            let (u, v) = (T::frac(3 * i + 1, 60), T::frac(7 * i % 60 + 1, 61));
            let expected = surface.derivative_at(&u, &v, 0, 1)? * alpha.at(&u, &v)?;
            assert_close(&whole.derivative_at(&u, &v, 0, 1)?, &expected, tolerance.clone());
        }
        for (path, name) in [(Path::UThenV, "one path"), (Path::Both, "two paths")] {
            let label = format!("{size}, {name}/{}", numbers.name);
            group.bench_function(label, |b| b.iter(|| black_box(&surface).fine_tuned(&alpha, path)));
        }
        let boundary = Edges::all(Fit::Position);
        // Among small numbers a line of control points may begin and end at one point.
        let holds = surface.fine_tuned_holding(&alpha, Path::Both, boundary).is_ok();
        if holds {
            let label = format!("{size}, two paths, boundary held/{}", numbers.name);
            group.bench_function(label, |b| {
                b.iter(|| black_box(&surface).fine_tuned_holding(&alpha, Path::Both, boundary));
            });
        }

        let label = format!("{size}, prepared/{}", numbers.name);
        group.bench_function(label, |b| {
            b.iter(|| SurfaceTuner::free(black_box(&surface), scales, Path::Both));
        });
        let free = SurfaceTuner::free(&surface, scales, Path::Both)?;
        let mut tuners =
            vec![("one path", SurfaceTuner::free(&surface, scales, Path::UThenV)?), ("two paths", free)];
        if holds {
            let held = SurfaceTuner::prepare(&surface, scales, Path::Both, boundary)?;
            tuners.push(("two paths, boundary held", held));
        }
        if rows * columns <= 72 {
            let kept = [SurfaceCondition::Edge { edge: Edge::VStart, order: 0 }];
            let norm = Norm::Coefficients;
            let under = SurfaceTuner::constrained(&surface, scales, Path::Both, &kept, norm)?.signed();
            tuners.push(("two paths, one edge kept by the scale", under));
        }
        for (name, tuner) in &tuners {
            let mut points = tuner.tuned(alpha.coeffs())?.into_coeffs();
            let mut dragged = alpha.coeffs().to_vec();
            let label = format!("{size}, drag, {name}/{}", numbers.name);
            group.bench_function(label, |b| {
                b.iter(|| {
                    dragged[0] += T::frac(1, 1 << 20);
                    tuner.tune_into(black_box(&dragged), &mut points)
                });
            });
        }
        Ok(())
    }
}

fn uniform<T: Scalar>(degree: usize, count: usize) -> Result<SplineSpace<T>> {
    SplineSpace::uniform(degree, count - degree, T::zero(), T::one())
}
