//! What do elastic curves and surfaces cost? Cubic curves in space of 10 to 10 000 control points, bicubic surfaces of up to
//! 300 x 300, of a material that resists all there is, held at the ends: the stiffness made, a force prepared and pushed, a set of
//! forces. All should be linear in the number of control points.
//!
//! The energy with free weights of its derivatives is solved as a band matrix over the grid, which is not linear.

use nalgebra::SVector;
use numbers::{Group, Numbers, Question};
use std::hint::black_box;
use symspline::{
    Breadth, Controlled, Curve, Elastic, Forces, FullEnergy, Material, Pull, Relaxation, Result, Scalar,
    Stiffness, Surface,
};

fn main() -> Result<()> {
    numbers::run::<Deforming>()
}

struct Deforming;

/// What is deformed.
#[derive(Clone, Copy)]
enum Size {
    Curve(usize),
    Surface(usize),
}
use Size::{Curve as C, Surface as S};

impl Question for Deforming {
    const NAME: &'static str = "deform";
    type Size = Size;
    const FLOATS: &'static [Size] =
        &[C(10), C(100), C(1000), C(10_000), S(20), S(50), S(100), S(200), S(300)];
    const FRACTIONS: &'static [Size] = &[C(10), C(100), S(10)];
    const IMAGES: &'static [Size] = &[C(10)];

    fn ask<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, size: Size) -> Result<()> {
        match size {
            C(n) => on_curve(group, numbers, n),
            S(n) => on_surface(group, numbers, n),
        }
    }
}

fn material<T: Scalar>() -> Result<Material<T>> {
    Material::of_orders([T::frac(1, 10), T::int(1), T::int(2)])
}

/// A place in span `i`, where nothing is simple.
fn place<T: Scalar>(numbers: &Numbers<T>, i: usize) -> T {
    let [a, b] = [i, i + 1].map(numbers.knot);
    (a * T::int(2) + b) / T::int(3)
}

/// There and back, so that numbers do not grow: what is timed is two pushes.
fn there_and_back<T: Scalar, S: Controlled<T>>(
    shape: &mut S,
    pull: &Pull<T, S>,
    by: &[S::Point; 2],
) -> Result<()> {
    pull.push(shape, &by[0])?;
    pull.push(shape, &by[1])
}

fn on_curve<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, n: usize) -> Result<()> {
    let mut curve: Curve<T, 3> = numbers.curve(3, n - 3)?;
    let (material, breadth) = (material::<T>()?, Breadth::BetweenEnds(1));
    let space = curve.space().clone();
    let x = place(numbers, n / 2 - 2);
    let up: SVector<T, 3> = SVector::from_fn(|axis, _| T::int(axis as i64));
    let by = [up.clone(), -up.clone()];
    let name = |what: &str| format!("{what}/{} {n}", numbers.name);

    group.bench_function(name("stiffness made"), |b| {
        b.iter(|| Stiffness::new(black_box(&space), &material, &breadth));
    });
    let elastic = Elastic::of(&curve, &material, std::slice::from_ref(&breadth))?;
    let mut moved = curve.clone();
    let target = curve.at(&x)? + &up;
    let pull = elastic.pull(&curve, &x)?;
    pull.move_to(&mut moved, &target)?;
    numbers::assert_close(&moved.at(&x)?, &target, T::frac(1, 1_000_000_000));
    group.bench_function(name("force prepared"), |b| b.iter(|| elastic.pull(black_box(&curve), &x)));
    let mut forces = Forces::new(&elastic, &curve)?;
    for i in 0..(n - 3).min(20) {
        forces.at(&place(numbers, i * (n - 3) / (n - 3).min(20)), up.clone())?;
    }
    group.bench_function(name("20 forces"), |b| b.iter(|| black_box(&forces).displacements()));
    group.bench_function(name("two pushes"), |b| b.iter(|| there_and_back(&mut curve, &pull, &by)));
    if !T::EXACT {
        let relaxation = Relaxation::new(&space, &material, &breadth, T::frac(1, 10))?;
        group.bench_function(name("step of relaxation"), |b| {
            b.iter(|| relaxation.step(black_box(&mut curve)));
        });
    }
    Ok(())
}

fn on_surface<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, n: usize) -> Result<()> {
    let mut surface: Surface<T, 3> = numbers.surface(3, n - 3)?;
    let material = material::<T>()?;
    let breadths = [Breadth::BetweenEnds(1), Breadth::BetweenEnds(1)];
    let x = place(numbers, n / 2 - 2);
    let at = (x.clone(), x);
    let up: SVector<T, 3> = SVector::from_fn(|axis, _| T::int(axis as i64));
    let by = [up.clone(), -up.clone()];
    let name = |what: &str| format!("{what}/{} {n} x {n}", numbers.name);

    let elastic = Elastic::of(&surface, &material, &breadths)?;
    let mut moved = surface.clone();
    let target = surface.at(&at.0, &at.1)? + &up;
    let pull = elastic.pull(&surface, &at)?;
    pull.move_to(&mut moved, &target)?;
    numbers::assert_close(&moved.at(&at.0, &at.1)?, &target, T::frac(1, 1_000_000_000));
    group.bench_function(name("force prepared"), |b| b.iter(|| elastic.pull(black_box(&surface), &at)));
    let mut forces = Forces::new(&elastic, &surface)?;
    for i in 0..(n - 3).min(20) {
        let x = place(numbers, i * (n - 3) / (n - 3).min(20));
        forces.at(&(x.clone(), x), up.clone())?;
    }
    group.bench_function(name("20 forces"), |b| b.iter(|| black_box(&forces).displacements()));
    if n <= 100 {
        let plate = FullEnergy::thin_plate(T::int(1), T::int(2))?;
        let (u, v) = (surface.u(), surface.v());
        let load = forces.load()?;
        group.bench_function(name("20 forces on a thin plate"), |b| {
            b.iter(|| plate.solved((black_box(u), v), &load, [&breadths[0], &breadths[1]]));
        });
    }
    group.bench_function(name("two pushes"), |b| b.iter(|| there_and_back(&mut surface, &pull, &by)));
    Ok(())
}
