//! What do pulls and constraints cost, apart from the copy of a shape? Prepared and dragged apart, on cubic curves in space of
//! 10, 100 and 1000 control points and bicubic surfaces of 20 x 20 and 100 x 100: nothing here should depend on the size.

use nalgebra::SVector;
use numbers::{Group, Numbers, Question};
use std::hint::black_box;
use symspline::{Constraints, Controlled, Curve, Drag, NurbsCurve, Result, Scalar, Surface};

fn main() -> Result<()> {
    numbers::run::<Constraining>()
}

struct Constraining;

/// What is shaped.
#[derive(Clone, Copy)]
enum Size {
    Curve(usize),
    Surface(usize),
}

impl Question for Constraining {
    const NAME: &'static str = "constrain";
    type Size = Size;
    const FLOATS: &'static [Size] =
        &[Size::Curve(10), Size::Curve(100), Size::Curve(1000), Size::Surface(20), Size::Surface(100)];
    const FRACTIONS: &'static [Size] = &[Size::Curve(10), Size::Curve(100), Size::Surface(20)];

    fn ask<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, size: Size) -> Result<()> {
        match size {
            Size::Curve(n) => on_curve(group, numbers, n),
            Size::Surface(n) => on_surface(group, numbers, n),
        }
    }
}

/// A place in span `i`, where nothing is simple.
fn place<T: Scalar>(numbers: &Numbers<T>, i: usize) -> T {
    let [a, b] = [i, i + 1].map(numbers.knot);
    (a * T::int(2) + b) / T::int(3)
}

/// There and back, so that numbers do not grow: what is timed is two drags.
fn there_and_back<T: Scalar, S: Controlled<T>>(
    shape: &mut S,
    drag: &Drag<T>,
    by: &[S::Point; 2],
) -> Result<()> {
    drag.apply(shape, &by[..1])?;
    drag.apply(shape, &by[1..])
}

fn on_curve<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, n: usize) -> Result<()> {
    let curve: Curve<T, 3> = numbers.curve(3, n - 3)?;
    let weights = (0..n).map(|i| (numbers.value)(i) + T::int(2)).collect();
    let rational = NurbsCurve::new(curve.space().clone(), curve.coeffs().to_vec(), weights)?;
    let x = place(numbers, n / 2 - 2);
    let up: SVector<T, 3> = SVector::from_fn(|axis, _| T::int(axis as i64));
    let by = [up.clone(), -up.clone()];
    let name = |what: &str| format!("{what}/{} {n}", numbers.name);

    group.bench_function(name("copy"), |b| b.iter(|| black_box(&curve).clone()));
    let mut shape = curve.clone();
    group.bench_function(name("nearest control point, found and moved"), |b| {
        b.iter(|| Drag::by_nearest(black_box(&shape), &x)?.apply(&mut shape, &by[..1]));
    });
    let mut shape = rational;
    group.bench_function(name("nearest control point, rational"), |b| {
        b.iter(|| Drag::by_nearest(black_box(&shape), &x)?.apply(&mut shape, &by[..1]));
    });
    let mut shape = curve.clone();
    let drag = Drag::by_nearest(&curve, &x)?;
    group.bench_function(name("two pulls of it"), |b| b.iter(|| there_and_back(&mut shape, &drag, &by)));

    let three =
        |curve| Constraints::on(curve).derivative(&x, 0)?.derivative(&x, 1)?.derivative(&x, 2)?.prepare();
    let changes = [SVector::zeros(), SVector::zeros(), up.clone()];
    let back = [SVector::zeros(), SVector::zeros(), -up];
    let mut shape = curve.clone();
    group.bench_function(name("three constraints, prepared and dragged"), |b| {
        b.iter(|| three(black_box(&shape))?.matrix().applied(&shape, &changes).map(|_| ()));
    });
    group.bench_function(name("three constraints, prepared"), |b| b.iter(|| three(black_box(&curve))));
    let held = three(&curve)?;
    group.bench_function(name("three constraints, two drags"), |b| {
        b.iter(|| held.drag(&mut shape, &changes).and_then(|()| held.drag(&mut shape, &back)));
    });
    if n >= 1000 {
        let mut wanted = Constraints::on(&curve);
        for i in 0..100 {
            wanted = wanted.point(&place(numbers, i * (n - 4) / 100))?;
        }
        group.bench_function(name("100 constraints, prepared"), |b| b.iter(|| black_box(&wanted).prepare()));
        let mut crowded = Constraints::on(&curve);
        for i in 0..100 {
            crowded = crowded.point(&place(numbers, i))?;
        }
        group.bench_function(name("100 constraints side by side, prepared"), |b| {
            b.iter(|| black_box(&crowded).prepare());
        });
    }
    Ok(())
}

fn on_surface<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, n: usize) -> Result<()> {
    let surface: Surface<T, 3> = numbers.surface(3, n - 3)?;
    let middle = place(numbers, n / 2 - 2);
    let up: SVector<T, 3> = SVector::from_fn(|axis, _| T::int(axis as i64));
    let by = [up.clone(), -up.clone()];
    let name = |what: &str| format!("{what}/{} {n} x {n}", numbers.name);

    group.bench_function(name("copy"), |b| b.iter(|| black_box(&surface).clone()));
    let at = [(); 2].map(|()| middle.clone()).into();
    let mut shape = surface.clone();
    group.bench_function(name("nearest control point, found and moved"), |b| {
        b.iter(|| Drag::by_nearest(black_box(&shape), &at)?.apply(&mut shape, &by[..1]));
    });
    // Ten places in a row, a span apart.
    let ten = |surface| {
        let step = |i: usize| (place(numbers, n / 2 + i - 6), place(numbers, n / 2 - i + 3));
        (0..10).try_fold(Constraints::on(surface), |wanted, i| wanted.point(&step(i)))?.prepare()
    };
    group.bench_function(name("ten constraints, prepared"), |b| b.iter(|| ten(black_box(&surface))));
    let held = ten(&surface)?;
    let changes = vec![up; 10];
    let mut shape = surface.clone();
    group.bench_function(name("ten constraints, dragged"), |b| b.iter(|| held.drag(&mut shape, &changes)));
    Ok(())
}
