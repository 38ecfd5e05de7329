//! What does it cost to keep a fine-tuned curve closed? Rings of 10 to 1000 vertices, a scale of twelve values of which one is
//! raised: by the nearest scale that closes, whole and while dragged, over both fields, and by springs, which know `f64` only.

use nalgebra::vector;
use numbers::Group;
use std::f64::consts::TAU;
use std::hint::black_box;
use symspline::{Condition, Curve, FineTuner, Function, Norm, Q, Result, Scalar, SplineSpace, Springs};

fn main() -> Result<()> {
    let mut criterion = numbers::criterion();
    ask(&mut criterion.benchmark_group("closed"))?;
    criterion.final_summary();
    Ok(())
}

fn ask(group: &mut Group<'_>) -> Result<()> {
    for vertices in [10, 100, 1000] {
        let (curve, alpha) = (ring(vertices, |x| x)?, raised::<f64>()?);
        let relaxed = curve.fine_tuned_closed(&alpha, &Springs { uniform: true, ..Springs::default() })?;
        assert!(relaxed.converged, "{relaxed:?}");
        let springs = Springs { uniform: true, ..Springs::default() };
        group.bench_function(format!("{vertices} vertices, springs/f64"), |b| {
            b.iter(|| black_box(&curve).fine_tuned_closed(&alpha, &springs));
        });
        nearest(group, vertices, "f64", &curve, &alpha)?;
    }
    for vertices in [10, 100] {
        let exact = |x: f64| Q::frac((x * 64.0).round() as i64, 64);
        nearest(group, vertices, "Q small", &ring(vertices, exact)?, &raised()?)?;
    }
    Ok(())
}

/// The closed quadratic of a wavy polygon.
fn ring<T: Scalar>(vertices: usize, number: impl Fn(f64) -> T) -> Result<Curve<T, 2>> {
    let vertex = |i: usize| {
        let angle = TAU * i as f64 / vertices as f64;
        let radius = 10.0 + 2.0 * (3.0 * angle).cos();
        vector![number(radius * angle.cos()), number(radius * angle.sin())]
    };
    Curve::closed(2, (0..vertices).map(vertex).collect())
}

fn raised<T: Scalar>() -> Result<Function<T>> {
    let mut values = vec![T::one(); 12];
    values[3] = T::frac(3, 2);
    Function::new(SplineSpace::uniform_periodic(1, 12, T::zero(), T::one())?, values)
}

fn nearest<T: Scalar>(
    group: &mut Group<'_>,
    vertices: usize,
    field: &str,
    curve: &Curve<T, 2>,
    alpha: &Function<T>,
) -> Result<()> {
    let prepare =
        |curve: &Curve<T, 2>| FineTuner::constrained(curve, alpha.space(), &[Condition::End], Norm::L2);
    let tuner = prepare(curve)?;
    let mut points = tuner.tuned(alpha.coeffs())?.into_coeffs();
    assert!(tuner.space().is_periodic());
    group.bench_function(format!("{vertices} vertices, nearest scale, whole/{field}"), |b| {
        b.iter(|| prepare(black_box(curve))?.tuned(alpha.coeffs()));
    });
    group.bench_function(format!("{vertices} vertices, nearest scale, a drag/{field}"), |b| {
        b.iter(|| tuner.tune_into(black_box(alpha.coeffs()), &mut points));
    });
    Ok(())
}
