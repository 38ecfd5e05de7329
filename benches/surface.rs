//! What does a point, a normal, a product or an elevation of a surface cost? Time a point, or a patch: linear growth is
//! a constant.
//!
//! Points are those of a bicubic surface in space with 50 by 50 patches, 100 000 of them, in random order or on a grid.

use criterion::Throughput;
use numbers::{FLOATS, Group, IMAGES, Numbers, Question, assert_close};
use std::hint::black_box;
use symspline::Direction::{U, V};
use symspline::{Q, Result, Scalar, Surface};

const SPANS: usize = 50;
const COUNT: usize = 100_000;

struct Products;

impl Question for Products {
    const NAME: &'static str = "surface";
    type Size = usize;
    const FLOATS: &'static [usize] = &[10, 30, 100];
    const FRACTIONS: &'static [usize] = &[2, 4];

    fn ask<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, spans: usize) -> Result<()> {
        let (s, f) = (numbers.surface::<3>(3, spans)?, numbers.field(3, spans)?);
        let (square, along_u, along_v) = (f.times(&f)?, s.elevated(U, 1)?, s.elevated(V, 1)?);
        let samples = numbers.samples(spans, 10);
        for (u, v) in samples.iter().flat_map(|u| samples.iter().map(move |v| (u, v))) {
            let value = f.at(u, v)?;
            let accuracy = T::int(64) * (numbers.epsilon)();
            assert_close(&square.at(u, v)?, &(value.clone() * value), accuracy.clone());
            assert_close(&along_u.at(u, v)?, &s.at(u, v)?, accuracy.clone());
            assert_close(&along_v.at(u, v)?, &s.at(u, v)?, accuracy);
        }

        group.throughput(Throughput::Elements((spans * spans) as u64));
        let name = |what: &str| format!("{what}/{}/{spans}", numbers.name);
        group.bench_function(name("product 3x3"), |b| b.iter(|| black_box(&f).times(&f)));
        for (direction, what) in [(U, "elevated along u"), (V, "elevated along v")] {
            group.bench_function(name(what), |b| b.iter(|| black_box(&s).elevated(direction, 1)));
        }
        Ok(())
    }
}

fn main() -> Result<()> {
    let mut criterion = numbers::criterion();
    points(&mut criterion.benchmark_group("surface points"))?;
    numbers::ask::<Products>(&mut criterion)?;
    criterion.final_summary();
    Ok(())
}

fn points(group: &mut Group<'_>) -> Result<()> {
    let surface = FLOATS.surface::<3>(3, SPANS)?;
    let end = *surface.u().domain().1;
    let random: Vec<f64> = numbers::random(2 * COUNT).map(|x| end * x).collect();
    let pairs: Vec<(f64, f64)> = random.chunks(2).map(|pair| (pair[0], pair[1])).collect();
    let even = |count: usize| (0..count).map(|i| end * i as f64 / (count - 1) as f64).collect::<Vec<_>>();
    let (us, vs) = (even(1000), even(COUNT / 1000));
    check(&surface, &pairs, (&us, &vs))?;

    group.throughput(Throughput::Elements(COUNT as u64));
    group.bench_function("at/random", |b| {
        b.iter(|| pairs.iter().for_each(|(u, v)| _ = black_box(surface.at(u, v))));
    });
    group.bench_function("eval/random", |b| b.iter(|| surface.eval(black_box(&pairs))));
    group.bench_function("eval_grid/1000 x 100", |b| b.iter(|| surface.eval_grid(black_box(&us), &vs)));
    group.bench_function("eval_grid/100 x 1000", |b| b.iter(|| surface.eval_grid(black_box(&vs), &us)));
    group.bench_function("tangents_at/random", |b| {
        b.iter(|| pairs.iter().for_each(|(u, v)| _ = black_box(surface.tangents_at(u, v))));
    });
    group.bench_function("normal_at/random", |b| {
        b.iter(|| pairs.iter().for_each(|(u, v)| _ = black_box(surface.normal_at(u, v))));
    });
    group.bench_function("derivatives_at 2/random", |b| {
        b.iter(|| pairs.iter().for_each(|(u, v)| _ = black_box(surface.derivatives_at(u, v, 2))));
    });
    Ok(())
}

/// Batches against single values, and all of them against exact arithmetic.
fn check(surface: &Surface<f64, 3>, pairs: &[(f64, f64)], (us, vs): (&[f64], &[f64])) -> Result<()> {
    for ((u, v), value) in pairs.iter().zip(surface.eval(pairs)?) {
        assert_close(&value, &surface.at(u, v)?, 4.0 * f64::EPSILON);
    }
    for (k, value) in surface.eval_grid(us, vs)?.iter().enumerate() {
        assert_close(value, &surface.at(&us[k / vs.len()], &vs[k % vs.len()])?, 8.0 * f64::EPSILON);
    }
    let exact: Surface<Q, 3> = IMAGES.surface(3, SPANS)?;
    for (u, v) in pairs.iter().step_by(COUNT / 20) {
        let truth = exact.derivatives_at(&Q::try_from(*u)?, &Q::try_from(*v)?, 2)?;
        let rounded = |k: usize, l: usize| truth[k][l].map(|q| q.to_f64());
        assert_close(&surface.at(u, v)?, &rounded(0, 0), 8.0 * f64::EPSILON);
        let ([value, along_u, along_v], all) = (surface.tangents_at(u, v)?, surface.derivatives_at(u, v, 2)?);
        for (found, k, l) in [(value, 0, 0), (along_u, 1, 0), (along_v, 0, 1)] {
            assert_close(&found, &rounded(k, l), 64.0 * f64::EPSILON);
        }
        for (k, row) in all.iter().enumerate() {
            row.iter()
                .enumerate()
                .for_each(|(l, found)| assert_close(found, &rounded(k, l), 256.0 * f64::EPSILON));
        }
        assert_close(&surface.normal_at(u, v)?, &along_u.cross(&along_v), 4.0 * f64::EPSILON);
    }
    Ok(())
}
