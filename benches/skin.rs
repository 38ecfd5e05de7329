//! What does a skin cost? A bicubic surface with tangents at both ends, through 5 to 80 sections of `n` control points each: time a
//! control point, which over `f64` should depend on neither; over `Q` numbers grow with the number of sections. Beside it what
//! bringing the sections into one space takes, where they are in one already.

use criterion::Throughput;
use nalgebra::SVector;
use numbers::{Group, Numbers, Question, assert_close};
use std::hint::black_box;
use symspline::{Curve, Direction, Result, Scalar, Skin};

fn main() -> Result<()> {
    numbers::run::<Skins>()
}

struct Skins;

impl Question for Skins {
    const NAME: &'static str = "skin";
    /// Sections, and the control points of each.
    type Size = (usize, usize);
    const FLOATS: &'static [Self::Size] =
        &[(5, 20), (10, 20), (20, 20), (40, 20), (80, 20), (20, 80), (20, 320)];
    const FRACTIONS: &'static [Self::Size] = &[(5, 10), (10, 10), (20, 10), (40, 10), (80, 10), (10, 40)];
    const IMAGES: &'static [Self::Size] = &[(5, 10), (10, 10)];

    fn ask<T: Scalar>(
        group: &mut Group<'_>,
        numbers: &Numbers<T>,
        (count, controls): Self::Size,
    ) -> Result<()> {
        let space = numbers.space(3, controls - 3)?;
        let point = |i: usize| SVector::<T, 3>::from_fn(|axis, _| (numbers.value)(3 * i + axis));
        let section =
            |k: usize| Curve::new(space.clone(), (0..controls).map(|i| point(k * controls + i)).collect());
        let sections: Vec<Curve<T, 3>> = (0..count).map(section).collect::<Result<_>>()?;
        let places: Vec<T> = (0..count).map(numbers.knot).collect();
        let skin = Skin::through(&sections)?.with_parameters(&places)?;
        let skin = skin.start_tangents(&sections[1])?.end_tangents(&sections[0])?;
        let surface = skin.surface(3)?;
        for (v, section) in places.iter().zip(&sections) {
            let met = surface.isocurve(Direction::V, v)?;
            for (c, d) in met.coeffs().iter().zip(section.coeffs()) {
                assert_close(c, d, T::int(100) * (numbers.epsilon)());
            }
        }
        let named = |what: &str| format!("{what}, {count} sections, {controls} controls/{}", numbers.name);
        group.throughput(Throughput::Elements((count * controls) as u64));
        group.bench_function(named("surface"), |b| b.iter(|| black_box(&skin).surface(3)));
        group.bench_function(named("compatible"), |b| b.iter(|| Skin::through(black_box(&sections))));
        Ok(())
    }
}
