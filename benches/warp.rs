//! What does a warp cost? A cubic plane curve of `n` spans is warped in its middle half, with as many knots more as it has
//! spans there; and a bicubic surface of `n` coefficients.
//!
//! In the steps of the book: refined alone, refined and moved, and thinned out afterwards; and what decides which control
//! points move, for `n` points: a polygon of a hundred corners, and a gravity field of a hundred legs.

use numbers::{Group, Numbers, Question, assert_close};
use std::hint::black_box;
use symspline::{Bump, Gravity, Polygons, Refinement, Region, Result, Scalar, SplineSpace, Surface, Warp};

fn main() -> Result<()> {
    numbers::run::<Warping>()
}

struct Warping;

impl Question for Warping {
    const NAME: &'static str = "warp";
    type Size = usize;
    const FLOATS: &'static [usize] = &[10, 100, 1000];
    const FRACTIONS: &'static [usize] = &[10, 100];
    const IMAGES: &'static [usize] = &[10];

    fn ask<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, spans: usize) -> Result<()> {
        let named = |what: &str| format!("{what}, {spans}/{}", numbers.name);
        let curve = numbers.curve::<2>(3, spans)?;
        let ends = ((numbers.knot)(spans / 4), (numbers.knot)(spans - spans / 4));
        let region = Region::new(ends.0.clone(), ends.1.clone()).refined(Refinement::Count(spans / 2 + 4));
        group.bench_function(named("refined"), |b| b.iter(|| region.refine(black_box(&curve))));

        let bump = Bump::new(T::int(4))?;
        let vector = nalgebra::vector![T::int(0), T::int(1)];
        let warp = |region: &Region<T>| Warp::along(region.clone(), |at| bump.at(&at.share), vector.clone());
        let moved = warp(&region);
        let warped = moved.apply(&curve)?;
        let tolerance = T::frac(1, 100);
        let thinned = warp(&region.clone().thinned(tolerance.clone()));
        let thin = thinned.apply(&curve)?;
        assert!(thin.bound <= tolerance && warped.moved > spans / 2);
        for x in [&ends.0, &ends.1] {
            assert_close(&thin.shape.at(x)?, &curve.at(x)?, (numbers.epsilon)() * T::int(100 * spans as i64));
        }
        group.bench_function(named("moved"), |b| b.iter(|| moved.apply(black_box(&curve))));
        group.bench_function(named("thinned"), |b| b.iter(|| thinned.apply(black_box(&curve))));

        let side = (spans as f64).sqrt() as usize;
        let space = SplineSpace::uniform(3, side, T::int(0), T::int(1))?;
        let point = |i: usize| nalgebra::SVector::<T, 3>::from_fn(|axis, _| (numbers.value)(3 * i + axis));
        let net = (0..space.dim() * space.dim()).map(point).collect();
        let surface = Surface::new(space.clone(), space, net)?;
        let (from, to) = ((T::frac(1, 7), T::frac(1, 7)), (T::frac(6, 7), T::frac(6, 7)));
        let region = Region::new(from, to).refined(Refinement::Count(side + 4));
        let up = nalgebra::vector![T::int(0), T::int(0), T::int(1)];
        let patch = Warp::along(region, |at| bump.at_pair(&at.share), up);
        group.bench_function(named("surface"), |b| b.iter(|| patch.apply(black_box(&surface))));

        let corners: Vec<(T, T)> =
            (0..100).map(|i| (T::frac(37 * i % 101, 101), T::frac(53 * i % 97, 97))).collect();
        let (die, field) = (Polygons::new([corners.clone()])?, Gravity::new([corners], T::frac(1, 50))?);
        let places: Vec<(T, T)> =
            (0..spans as i64).map(|i| (T::frac(7 * i % 64, 64), T::frac(11 * i % 81, 81))).collect();
        group.bench_function(named("in a polygon"), |b| {
            b.iter(|| places.iter().filter(|place| die.contains(black_box(place))).count());
        });
        group.bench_function(named("in a field"), |b| {
            b.iter(|| places.iter().filter_map(|place| field.pull(black_box(place))).count());
        });
        Ok(())
    }
}
