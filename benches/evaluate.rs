//! What does a point of a curve cost? One at a time or in a batch, in order or not, alone or with two derivatives, from the
//! spline or from its evaluator.
//!
//! A cubic space curve with 1000 control points at 100 000 parameters: in order, 100 in a row share a span.

use criterion::Throughput;
use nalgebra::SVector;
use numbers::{FLOATS, FRACTIONS, Group, IMAGES, Numbers, assert_close};
use std::hint::black_box;
use symspline::{Curve, Evaluate, Q, Result, Scalar};

const SPANS: usize = 997;
const COUNT: usize = 100_000;

fn main() -> Result<()> {
    let mut criterion = numbers::criterion();
    floats(&mut criterion.benchmark_group("evaluate f64"))?;
    let mut group = criterion.benchmark_group("evaluate Q");
    for spans in [7, 97] {
        exact(&mut group, &FRACTIONS, spans)?;
        exact(&mut group, &IMAGES, spans)?;
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}

fn floats(group: &mut Group<'_>) -> Result<()> {
    let curve = FLOATS.curve::<3>(3, SPANS)?;
    let end = *curve.domain().1;
    let sorted: Vec<f64> = (0..COUNT).map(|i| end * i as f64 / (COUNT - 1) as f64).collect();
    let random: Vec<f64> = numbers::random(COUNT).map(|x| end * x).collect();
    let mut values = vec![SVector::zeros(); COUNT];
    check(&curve, &sorted)?;
    let evaluator = curve.evaluator()?;
    for (x, value) in sorted.iter().zip(evaluator.eval(&sorted)?) {
        assert_close(&value, &curve.at(x)?, 128.0 * f64::EPSILON);
    }
    group.bench_function("evaluator", |b| b.iter(|| black_box(&curve).evaluator()));

    group.throughput(Throughput::Elements(COUNT as u64));
    for (order, parameters) in [("sorted", &sorted), ("random", &random)] {
        group.bench_function(format!("at/{order}"), |b| {
            b.iter(|| parameters.iter().for_each(|x| _ = black_box(curve.at(x))));
        });
        group.bench_function(format!("eval_into/{order}"), |b| {
            b.iter(|| curve.eval_into(black_box(parameters), &mut values));
        });
        group.bench_function(format!("evaluator at/{order}"), |b| {
            b.iter(|| parameters.iter().for_each(|x| _ = black_box(evaluator.at(x))));
        });
        group.bench_function(format!("evaluator eval_into/{order}"), |b| {
            b.iter(|| evaluator.eval_into(black_box(parameters), &mut values));
        });
        group.bench_function(format!("evaluator derivatives_at 3/{order}"), |b| {
            b.iter(|| parameters.iter().for_each(|x| _ = black_box(evaluator.derivatives_at::<3>(x))));
        });
        group.bench_function(format!("derivatives_at 2/{order}"), |b| {
            b.iter(|| parameters.iter().for_each(|x| _ = black_box(curve.derivatives_at(x, 2))));
        });
    }
    Ok(())
}

/// Single values, batches and derivatives against exact arithmetic, and all of the batch against single values.
fn check(curve: &Curve<f64, 3>, parameters: &[f64]) -> Result<()> {
    let batch = curve.eval(parameters)?;
    for (x, value) in parameters.iter().zip(&batch) {
        assert_close(value, &curve.at(x)?, 4.0 * f64::EPSILON);
    }
    let exact = IMAGES.curve::<3>(3, SPANS)?;
    for (x, value) in parameters.iter().zip(&batch).step_by(COUNT / 50) {
        let truth = exact.derivatives_at(&Q::try_from(*x)?, 2)?;
        let rounded = truth.iter().map(|c| c.map(|q| q.to_f64()));
        assert_close(value, &truth[0].map(|q| q.to_f64()), 4.0 * f64::EPSILON);
        for (found, expected) in curve.derivatives_at(x, 2)?.iter().zip(rounded) {
            assert_close(found, &expected, 64.0 * f64::EPSILON);
        }
    }
    Ok(())
}

/// Ten parameters a span, in order.
fn exact(group: &mut Group<'_>, numbers: &Numbers<Q>, spans: usize) -> Result<()> {
    let curve = numbers.curve::<3>(3, spans)?;
    let inside = |i: usize| {
        let [a, b] = [i / 10, i / 10 + 1].map(numbers.knot);
        &a + (&b - &a) * Q::frac((i % 10) as i64, 10)
    };
    let parameters: Vec<Q> = (0..10 * spans).map(inside).collect();
    let singles = parameters.iter().map(|x| curve.at(x)).collect::<Result<Vec<_>>>()?;
    assert_eq!(curve.eval(&parameters)?, singles);

    let points = spans + 3;
    group.throughput(Throughput::Elements(parameters.len() as u64));
    group.bench_function(format!("at/{}/{points}", numbers.name), |b| {
        b.iter(|| parameters.iter().for_each(|x| _ = black_box(curve.at(x))));
    });
    group.bench_function(format!("eval/{}/{points}", numbers.name), |b| {
        b.iter(|| curve.eval(black_box(&parameters)));
    });
    Ok(())
}
