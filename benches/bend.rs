//! What does it cost to flatten and to bend? Curves with 10, 100 and 1000 control points, a bend with its ends carried along,
//! about a circle and about a curve, and sheets about a cylinder.
//!
//! The bends about circles and curves are over `f64`; flattening and a bend about a line with no ends carried over `Q` too.

use nalgebra::{SVector, vector};
use numbers::{Group, Numbers, Question, criterion};
use std::hint::black_box;
use symspline::{
    Axis, Bend, Curve, Direction, Flat, Flatten, OffsetAxis, Onto, Result, Round, Scalar, SplineSpace,
    Surface, circle,
};

fn main() -> Result<()> {
    let mut criterion = criterion();
    numbers::ask::<Moves>(&mut criterion)?;
    let mut group = criterion.benchmark_group("bend");
    for n in [10, 100, 1000] {
        curves(&mut group, n)?;
    }
    for n in [10, 30] {
        sheets(&mut group, n)?;
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}

struct Moves;

impl Question for Moves {
    const NAME: &'static str = "flatten";
    type Size = usize;
    const FLOATS: &'static [usize] = &[10, 100, 1000];
    const FRACTIONS: &'static [usize] = Self::FLOATS;

    fn ask<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, n: usize) -> Result<()> {
        let space = numbers.space(3, n - 3)?;
        let (start, end) = ((numbers.knot)(1), (numbers.knot)(n - 4));
        let points = (0..n).map(|i| vector![T::int(i as i64), (numbers.value)(i) + T::int(2)]).collect();
        let curve = Curve::<T, 2>::new(space, points)?;
        let zero = || vector![T::zero(), T::zero()];
        let tool = Flatten::new(Onto::line(zero(), vector![T::one(), T::frac(1, 8)])?)
            .local_to((start.clone(), end.clone()));
        let done = tool.apply(&curve)?;
        assert_eq!(done.projected.len(), curve.space().local_coeffs(&start, &end)?.len());
        group.bench_function(format!("{n} points/{}", numbers.name), |b| {
            b.iter(|| tool.apply(black_box(&curve)));
        });
        let flat = Flat { origin: zero(), normal: vector![T::zero(), T::one()] };
        let centre = vector![T::int(n as i64 / 2), T::int(-9)];
        let bend = Bend::new(centre, flat, T::int(2)).on(start, end).without_tails();
        bend.apply(&curve)?;
        group.bench_function(format!("{n} points, bent about a line/{}", numbers.name), |b| {
            b.iter(|| bend.apply(black_box(&curve)));
        });
        Ok(())
    }
}

/// Bends of a straight curve about a circle, and about the same circle as a rational curve.
fn curves(group: &mut Group<'_>, n: usize) -> Result<()> {
    let space = SplineSpace::uniform(3, n - 3, 0.0, 1.0)?;
    let points = (0..n).map(|i| vector![i as f64 / n as f64 - 0.5, 1.0]).collect();
    let curve = Curve::<f64, 2>::new(space, points)?;
    let knots = curve.space().breaks();
    let (start, end) = (knots[1].0, knots[knots.len() - 2].0);
    let centre: SVector<f64, 2> = vector![0.0, 0.0];
    let round = Bend::new(centre, Round(0.9), 2.0).on(start, end);
    let ring = Bend::new(centre, circle(&centre, &0.9)?, 2.0).on(start, end);
    let (a, b) = (round.apply(&curve)?, ring.apply(&curve)?);
    assert!(a.coeffs().iter().zip(b.coeffs()).all(|(p, q)| (p - q).norm() < 1e-12));
    group.bench_function(format!("{n} points, circle"), |b| b.iter(|| round.apply(black_box(&curve))));
    group.bench_function(format!("{n} points, rational curve"), |b| b.iter(|| ring.apply(black_box(&curve))));
    Ok(())
}

/// Bends of an `n` by `n` sheet about a straight axis and about the offset of an isocurve.
fn sheets(group: &mut Group<'_>, n: usize) -> Result<()> {
    let space = SplineSpace::uniform(3, n - 3, 0.0, 1.0)?;
    let nodes = space.greville();
    let points =
        nodes.iter().flat_map(|x| nodes.iter().map(move |y| vector![*x, *y, 0.1 * (x * y).sin()])).collect();
    let sheet = Surface::<f64, 3>::new(space.clone(), space.clone(), points)?;
    let knots = space.breaks();
    let (start, end) = (knots[1].0, knots[knots.len() - 2].0);
    let straight = Axis::new(vector![0.5, 0.0, -1.0], vector![0.0, 1.0, 0.0])?;
    let offset = OffsetAxis::new(&sheet, Direction::U, 0.5, -1.0)?;
    let about_line = Bend::new(straight, Round(0.9), 2.0).on(start, end);
    let about_offset = Bend::new(offset, Round(0.9), 2.0).on(start, end);
    about_line.apply(&sheet)?;
    about_offset.apply(&sheet)?;
    group.bench_function(format!("{n} x {n} sheet, straight axis"), |b| {
        b.iter(|| about_line.apply(black_box(&sheet)));
    });
    group.bench_function(format!("{n} x {n} sheet, offset axis"), |b| {
        b.iter(|| about_offset.apply(black_box(&sheet)));
    });
    Ok(())
}
