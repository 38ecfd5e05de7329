//! What does the nearest point of a curve or surface cost? Many points near a cubic space curve of 100 spans and near a bicubic
//! surface of 10 by 10 patches, beside what one would write by hand: the nearest of many samples, then Newton's method.

use criterion::Throughput;
use nalgebra::{SVector, vector};
use numbers::Group;
use std::hint::black_box;
use symspline::{Curve, Evaluate, Evaluator, Result, SplineSpace, Surface, circle};

const COUNT: usize = 10_000;
const SPANS: usize = 100;

/// How many samples a span the plain way takes.
const SAMPLES: usize = 8;

type Point = SVector<f64, 3>;

fn main() -> Result<()> {
    let mut criterion = numbers::criterion();
    let mut group = criterion.benchmark_group("project");
    curves(&mut group)?;
    surfaces(&mut group)?;
    group.finish();
    criterion.final_summary();
    Ok(())
}

/// A spiral with a wave.
fn spiral() -> Result<Curve<f64, 3>> {
    let space = SplineSpace::uniform(3, SPANS, 0.0, 1.0)?;
    let point = |i: usize| {
        let t = 0.15 * i as f64;
        vector![t.cos() * (1.0 + 0.05 * t), t.sin() * (1.0 + 0.03 * t), 0.05 * t + 0.3 * (0.7 * t).sin()]
    };
    let points = (0..space.dim()).map(point).collect();
    Curve::new(space, points)
}

/// Points of a box.
fn scattered(count: usize, low: Point, high: Point) -> Vec<Point> {
    let shares: Vec<f64> = numbers::random(3 * count).collect();
    shares.chunks(3).map(|s| low + (high - low).component_mul(&vector![s[0], s[1], s[2]])).collect()
}

/// Samples of a curve, and its evaluator.
struct Plain {
    samples: Vec<(f64, Point)>,
    evaluator: Evaluator<f64, Point>,
    domain: (f64, f64),
}

impl Plain {
    fn new(curve: &Curve<f64, 3>) -> Result<Self> {
        let (a, b) = (*curve.domain().0, *curve.domain().1);
        let count = SAMPLES * SPANS;
        let parameters: Vec<f64> = (0..=count).map(|i| a + (b - a) * i as f64 / count as f64).collect();
        let evaluator = curve.evaluator()?;
        let points = evaluator.eval(&parameters)?;
        Ok(Self { samples: parameters.into_iter().zip(points).collect(), evaluator, domain: (a, b) })
    }

    /// The distance of the nearest sample after some steps.
    fn distance(&self, point: &Point) -> Result<f64> {
        let nearer = |one: (f64, f64), other: (f64, f64)| if other.1 < one.1 { other } else { one };
        let squares = self.samples.iter().map(|(x, sample)| (*x, (sample - point).norm_squared()));
        let (mut x, _) = squares.reduce(nearer).expect("a sample");
        for _ in 0..6 {
            let [value, first, second] = self.evaluator.derivatives_at::<3>(&x)?;
            let off = value - point;
            let step = first.dot(&off) / (first.norm_squared() + second.dot(&off));
            x = (x - step).clamp(self.domain.0, self.domain.1);
            if step.abs() < 1e-12 {
                break;
            }
        }
        Ok((self.evaluator.at(&x)? - point).norm())
    }
}

fn curves(group: &mut Group<'_>) -> Result<()> {
    let curve = spiral()?;
    let (projector, plain) = (curve.projector()?, Plain::new(&curve)?);
    let points = scattered(COUNT, vector![-2.0, -2.0, -0.5], vector![2.0, 2.0, 1.5]);
    for point in &points {
        let (foot, by_hand) = (projector.foot(point)?, plain.distance(point)?);
        // Newton's method may go astray; never is it nearer.
        assert!(foot.distance <= by_hand + 1e-12);
    }
    group.bench_function("prepare a curve", |b| b.iter(|| black_box(&curve).projector()));
    group.throughput(Throughput::Elements(COUNT as u64));
    group.bench_function("curve/feet", |b| b.iter(|| projector.feet(black_box(&points))));
    group.bench_function("curve/foot", |b| {
        b.iter(|| points.iter().for_each(|point| _ = black_box(projector.foot(point))));
    });
    group.bench_function("curve/by samples", |b| {
        b.iter(|| points.iter().for_each(|point| _ = black_box(plain.distance(point))));
    });
    let on: Vec<Point> =
        numbers::random(COUNT).map(|share| curve.at(&(share * curve.domain().1))).collect::<Result<_>>()?;
    group.bench_function("curve/points on it", |b| b.iter(|| projector.feet(black_box(&on))));
    group.bench_function("curve/nearest, all feet", |b| {
        b.iter(|| points.iter().for_each(|point| _ = black_box(projector.nearest(point, 1e-9))));
    });
    let round = circle(&vector![0.0, 0.0], &1.0)?.projector()?;
    let flat: Vec<_> = points.iter().map(|point| point.xy()).collect();
    group.bench_function("circle/feet", |b| b.iter(|| round.feet(black_box(&flat))));
    Ok(())
}

fn surfaces(group: &mut Group<'_>) -> Result<()> {
    let space = SplineSpace::uniform(3, 10, 0.0, 1.0)?;
    let n = space.dim();
    let point = |k: usize| {
        let (i, j) = ((k / n) as f64, (k % n) as f64);
        vector![0.1 * i, 0.1 * j, 0.2 * (0.9 * i).sin() * (0.7 * j).cos()]
    };
    let surface = Surface::new(space.clone(), space, (0..n * n).map(point).collect())?;
    let projector = surface.projector()?;
    let points = scattered(COUNT / 10, vector![-0.2, -0.2, -0.5], vector![1.4, 1.4, 0.5]);
    group.throughput(Throughput::Elements(points.len() as u64));
    group.bench_function("surface/feet", |b| b.iter(|| projector.feet(black_box(&points))));
    group.bench_function("surface/nearest, all feet", |b| {
        b.iter(|| points.iter().for_each(|point| _ = black_box(projector.nearest(point, 1e-9))));
    });
    Ok(())
}
