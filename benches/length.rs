//! What does a certified arc length cost, beside adaptive Simpson of the same accuracy without a certificate? And its inverse?
//!
//! A space curve of 100 spans to `1e-12`, and the parameters of 1000 points at equal lengths.

use numbers::FLOATS;
use std::hint::black_box;
use symspline::{Curve, NurbsCurve, Result, circle};

const SPANS: usize = 100;
const ACCURACY: f64 = 1e-12;

fn main() -> Result<()> {
    let mut criterion = numbers::criterion();
    let mut group = criterion.benchmark_group("length");
    for degree in [2, 3, 5] {
        let curve = FLOATS.curve::<3>(degree, SPANS)?;
        let length = curve.arc_length(&ACCURACY)?;
        let simple = simpson(&curve, ACCURACY * length.total())?;
        assert!((simple - length.total()).abs() <= length.bound() + 1e-10 * simple);
        group.bench_function(format!("certified/{degree}"), |b| {
            b.iter(|| black_box(&curve).arc_length(&ACCURACY));
        });
        group.bench_function(format!("simpson/{degree}"), |b| {
            b.iter(|| simpson(black_box(&curve), ACCURACY * length.total()));
        });
        group.bench_function(format!("evenly 1000/{degree}"), |b| b.iter(|| black_box(&length).evenly(1000)));
    }
    let rational = NurbsCurve::from_polynomial(&FLOATS.curve::<3>(3, SPANS)?)?;
    group.bench_function("certified/rational 3", |b| b.iter(|| black_box(&rational).arc_length(&ACCURACY)));
    let circle = circle(&nalgebra::vector![1.0, 2.0], &3.0)?;
    group.bench_function("certified/circle", |b| b.iter(|| black_box(&circle).arc_length(&ACCURACY)));
    group.finish();
    criterion.final_summary();
    Ok(())
}

/// Adaptive Simpson with the usual estimate of the error, a fifteenth of the last change.
fn simpson(curve: &Curve<f64, 3>, tolerance: f64) -> Result<f64> {
    let evaluator = curve.derivative()?.evaluator()?;
    let speed = |x: f64| symspline::Evaluate::at(&evaluator, &x).map(|d| d.norm());
    let ends: Vec<f64> = curve.space().breaks().into_iter().map(|(t, _)| t).collect();
    let mut sum = 0.0;
    for ends in ends.windows(2) {
        // At the end of a span the left limit, which a smooth curve has in common with the right one.
        let [a, b] = [ends[0], ends[1]];
        let middle = a.midpoint(b);
        let values = [speed(a)?, speed(middle)?, speed(b)?];
        sum += halved(&speed, [a, b], values, tolerance / (ends.len() * SPANS) as f64, 40)?;
    }
    Ok(sum)
}

fn halved(
    speed: &impl Fn(f64) -> Result<f64>,
    [a, b]: [f64; 2],
    [start, middle, end]: [f64; 3],
    tolerance: f64,
    depth: usize,
) -> Result<f64> {
    let centre = a.midpoint(b);
    let (left, right) = (speed(a.midpoint(centre))?, speed(centre.midpoint(b))?);
    let whole = (start + 4.0 * middle + end) * (b - a) / 6.0;
    let halves = (start + 4.0 * left + 2.0 * middle + 4.0 * right + end) * (b - a) / 12.0;
    let change = halves - whole;
    if change.abs() <= 15.0 * tolerance || depth == 0 {
        return Ok(halves + change / 15.0);
    }
    let before = halved(speed, [a, centre], [start, left, middle], tolerance / 2.0, depth - 1)?;
    Ok(before + halved(speed, [centre, b], [middle, right, end], tolerance / 2.0, depth - 1)?)
}
