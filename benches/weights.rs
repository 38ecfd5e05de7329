//! What does a change of weights cost? Of a cubic and of a bicubic surface with so many control points: prepared pulls by one
//! and by two weights, applied in place again and again; a weight set in place; and for comparison the shape copied, and made
//! anew from control points and weights.

use nalgebra::SVector;
use numbers::{Group, Numbers, Question, assert_close};
use std::hint::black_box;
use symspline::{
    Coeff, NurbsCurve, NurbsSurface, Result, Scalar, SplineSpace, Weighed, WeightPairPull, WeightPull,
};

fn main() -> Result<()> {
    let mut criterion = numbers::criterion();
    numbers::ask::<OfCurves>(&mut criterion)?;
    numbers::ask::<OfSurfaces>(&mut criterion)?;
    criterion.final_summary();
    Ok(())
}

/// The clamped cubic space of dimension `dim`.
fn cubic<T: Scalar>(numbers: &Numbers<T>, dim: usize) -> Result<SplineSpace<T>> {
    numbers.space(3, dim - 3)
}

fn point<T: Scalar, const N: usize>(numbers: &Numbers<T>, i: usize) -> SVector<T, N> {
    SVector::from_fn(|axis, _| (numbers.value)(N * i + axis))
}

/// A weight between 1 and 3.
fn weight<T: Scalar>(numbers: &Numbers<T>, i: usize) -> T {
    (numbers.value)(i) + T::int(2)
}

/// The point at `at`, moved by the weights of `picks` by the half and a quarter of the way, again and again.
fn ask_of<T: Scalar, S: Weighed<T>>(
    group: &mut Group<'_>,
    numbers: &Numbers<T>,
    what: &str,
    mut shape: S,
    at: &S::Parameter,
    picks: [S::Index; 2],
) -> Result<()> {
    let name = |task: &str| format!("{what}, {task}/{}", numbers.name);
    let steps = [T::frac(1, 4), T::frac(1, 2)];
    let accuracy = (numbers.epsilon)() * T::int(100);
    let pull = WeightPull::new(&shape, at, picks[0])?;
    for fraction in &steps {
        pull.apply(&mut shape, fraction)?;
        assert_close(&shape.derivative_of(at, S::VALUE)?, &pull.point_at(fraction), accuracy.clone());
    }
    group.bench_function(name("one weight prepared"), |b| {
        b.iter(|| WeightPull::new(black_box(&shape), at, picks[0]));
    });
    let mut turn = steps.iter().cycle();
    group.bench_function(name("one weight pulled"), |b| {
        b.iter(|| turn.next().map(|fraction| pull.apply(&mut shape, black_box(fraction))));
    });
    let mut turn = [T::int(1), T::int(2)].into_iter().cycle();
    group.bench_function(name("one weight set"), |b| {
        b.iter(|| turn.next().map(|weight| shape.set_weights(black_box(&[(pull.index(), weight)]))));
    });
    let pull = WeightPairPull::new(&shape, at, picks)?;
    group.bench_function(name("two weights prepared"), |b| {
        b.iter(|| WeightPairPull::new(black_box(&shape), at, picks));
    });
    let mut turn = steps.iter().cycle();
    group.bench_function(name("two weights pulled along"), |b| {
        b.iter(|| turn.next().map(|fraction| pull.apply_along(&mut shape, black_box(fraction))));
    });
    let third = T::frac(1, 3);
    let [p, q] = pull.control_points();
    let mut target = pull.base().clone();
    target.scale(&third);
    for corner in [p, q] {
        target.add_scaled(&third, corner);
    }
    let tolerance = (numbers.epsilon)() * T::int(1 << 20);
    pull.apply_to(&mut shape, &target, &tolerance)?;
    assert_close(&shape.derivative_of(at, S::VALUE)?, &target, accuracy);
    group.bench_function(name("two weights pulled to a target"), |b| {
        b.iter(|| pull.apply_to(&mut shape, black_box(&target), &tolerance));
    });
    group.bench_function(name("copied"), |b| b.iter(|| black_box(&shape).clone()));
    Ok(())
}

struct OfCurves;

impl Question for OfCurves {
    const NAME: &'static str = "weights of curves";
    type Size = usize;
    const FLOATS: &'static [usize] = &[10, 100, 1000];
    const FRACTIONS: &'static [usize] = &[10, 1000];

    fn ask<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, dim: usize) -> Result<()> {
        let space = cubic(numbers, dim)?;
        let points: Vec<_> = (0..dim).map(|i| point::<T, 2>(numbers, i)).collect();
        let weights: Vec<T> = (0..dim).map(|i| weight(numbers, i)).collect();
        let curve = NurbsCurve::new(space, points.clone(), weights.clone())?;
        let leg = dim / 2;
        let at = curve.space().between_nodes(leg)?;
        let what = format!("{dim} points");
        let name = format!("{what}, made anew/{}", numbers.name);
        group.bench_function(name, |b| {
            b.iter(|| NurbsCurve::new(curve.space().clone(), points.clone(), weights.clone()));
        });
        ask_of(group, numbers, &what, curve, &at, [leg, leg + 1])
    }
}

struct OfSurfaces;

impl Question for OfSurfaces {
    const NAME: &'static str = "weights of surfaces";
    type Size = usize;
    const FLOATS: &'static [usize] = &[10, 32];
    const FRACTIONS: &'static [usize] = &[10];

    fn ask<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, dim: usize) -> Result<()> {
        let space = cubic(numbers, dim)?;
        let points = (0..dim * dim).map(|i| point::<T, 3>(numbers, i)).collect();
        let weights = (0..dim * dim).map(|i| weight(numbers, i)).collect();
        let leg = dim / 2;
        let at = space.between_nodes(leg)?;
        let surface = NurbsSurface::new(space.clone(), space, points, weights)?;
        let picks = [(leg, leg), (leg + 1, leg)];
        ask_of(group, numbers, &format!("{dim} x {dim} points"), surface, &(at.clone(), at), picks)
    }
}
