//! What does a proof cost? Zeros of a scalar spline, and the curvature profile of a car body before and after fine
//! tuning, over `f64` and over the exact numbers that the floats are; beside them samples of the curvature, which prove
//! nothing.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use nalgebra::{SVector, vector};
use std::hint::black_box;
use symspline::{Analyse, Curve, Ends, Function, SplineSpace, chord_length};

/// A wave with about one zero every second span.
fn wave(spans: usize) -> Function<f64> {
    let space = SplineSpace::uniform(3, spans, 0.0, 1.0).expect("a domain");
    let values = (0..space.dim()).map(|i| (1.7 * i as f64).sin()).collect();
    Function::new(space, values).expect("as many values")
}

fn zeros(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("zeros of a cubic");
    for spans in [10, 100, 1000, 10_000] {
        let f = wave(spans);
        group.bench_function(BenchmarkId::new("f64", spans), |b| b.iter(|| black_box(&f).zeros()));
        if spans <= 1000 {
            let f = f.to_exact().expect("finite");
            group.bench_function(BenchmarkId::new("Q", spans), |b| b.iter(|| black_box(&f).zeros()));
        }
    }
}

/// The measured points of the example `fine_tune`.
fn car() -> Vec<SVector<f64, 2>> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../data/car_prius_profile_3.csv");
    let mut reader = csv::Reader::from_path(path).expect("the data are there");
    let record = |record: csv::Result<csv::StringRecord>| {
        let record = record.expect("a table");
        let [y, z] = [1, 2].map(|i| record[i].trim().parse().expect("a number"));
        vector![y, z]
    };
    reader.records().map(record).collect()
}

fn profiles(criterion: &mut Criterion) {
    let (points, space) = (car(), SplineSpace::uniform(3, 69, 0.0, 1.0).expect("a domain"));
    let parameters = chord_length(&points).expect("many points");
    let car = Curve::least_squares(&space, &parameters, &points, Ends::Held).expect("enough points");
    let alpha = SplineSpace::uniform(2, 4, 0.0, 1.0).expect("a domain");
    let alpha = Function::new(alpha, vec![1.0, 1.0, 0.5, 2.0, 1.0, 1.0]).expect("six values");
    let tuned = car.fine_tuned(&alpha).expect("one domain");
    let mut group = criterion.benchmark_group("curvature profile");
    for (name, curve) in [("degree 3", &car), ("degree 5", &tuned)] {
        group.bench_function(format!("{name}/f64"), |b| b.iter(|| black_box(curve).profile()));
        let exact = curve.to_exact().expect("finite");
        group.bench_function(format!("{name}/Q"), |b| b.iter(|| black_box(&exact).profile()));
        let at: Vec<f64> = (0..69 * 24).map(|i| i as f64 / (69.0 * 24.0)).collect();
        group.bench_function(format!("{name}/samples"), |b| {
            b.iter(|| curve.curvature_profile(black_box(&at)));
        });
    }
}

criterion_group!(benches, zeros, profiles);
criterion_main!(benches);
