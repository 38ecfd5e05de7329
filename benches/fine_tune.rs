//! What does fine tuning cost? The three plane curves of [Miura] Table 1, by their sizes: degree and number of
//! control points of the curve, degree and number of values of the scale function; uniform clamped knots.

mod numbers;

use nalgebra::SVector;
use numbers::{Group, Numbers, Question, assert_close};
use std::hint::black_box;
use symspline::{Curve, FineTuner, Function, Result, Scalar, SplineSpace};

fn main() -> Result<()> {
    numbers::run::<FineTuning>()
}

struct FineTuning;

impl Question for FineTuning {
    const NAME: &'static str = "fine tune";
    type Size = [(usize, usize); 2];
    const FLOATS: &'static [Self::Size] = &[[(2, 181), (1, 2)], [(3, 72), (2, 6)], [(3, 159), (2, 3)]];
    const FRACTIONS: &'static [Self::Size] = Self::FLOATS;

    fn ask<T: Scalar>(
        group: &mut Group<'_>,
        numbers: &Numbers<T>,
        [(degree, points), (alpha_degree, values)]: Self::Size,
    ) -> Result<()> {
        let epsilon = (numbers.epsilon)();
        let control = |i: usize| SVector::from_fn(|axis, _| (numbers.value)(2 * i + axis));
        let curve = Curve::<T, 2>::new(uniform(degree, points)?, (0..points).map(control).collect())?;
        // Between 1 and 3, so that the tangent keeps its direction.
        let scale = (0..values).map(|i| (numbers.value)(i) + T::int(2)).collect();
        let alpha = Function::new(uniform(alpha_degree, values)?, scale)?;

        let tuned = curve.fine_tuned(&alpha)?;
        for x in (0..20).map(|i| T::frac(3 * i + 1, 60)) {
            let expected = curve.derivative_at(&x, 1)? * alpha.at(&x)?;
            assert_close(
                &tuned.derivative_at(&x, 1)?,
                &expected,
                epsilon.clone() * T::int(100 * points as i64),
            );
        }
        let name = format!("degree {degree}, {points} points/{}", numbers.name);
        group.bench_function(name, |b| b.iter(|| black_box(&curve).fine_tuned(&alpha)));

        // While a value of the scale is dragged.
        let tuning = FineTuner::free(&curve, alpha.space())?;
        let mut points = tuning.tuned(alpha.coeffs())?.into_coeffs();
        for (point, expected) in points.iter().zip(tuned.coeffs()) {
            assert_close(point, expected, epsilon.clone() * T::int(100 * tuned.coeffs().len() as i64));
        }
        let name = format!(
            "degree {degree}, {points} points, a drag/{}",
            numbers.name,
            points = curve.coeffs().len()
        );
        group.bench_function(name, |b| b.iter(|| tuning.tune_into(black_box(alpha.coeffs()), &mut points)));
        Ok(())
    }
}

/// The clamped space of dimension `dim` over uniform knots from 0 to 1.
fn uniform<T: Scalar>(degree: usize, dim: usize) -> Result<SplineSpace<T>> {
    let spans = (dim - degree) as i64;
    SplineSpace::clamped(degree, (0..=spans).map(|i| T::frac(i, spans)))
}
