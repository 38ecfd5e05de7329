//! How do time and memory grow with the number of control points, up to a million?
//!
//! A cubic space curve on uneven knots, and a bicubic surface with as many rows as columns. A row of the tables is an
//! operation, a column a number of control points, a cell the time of the operation and the peak memory of a process that
//! makes the operands and runs it. Each cell is such a process, so that peaks do not mix, and checks its result.
//!
//! `cargo run --release --example large`

#![allow(clippy::print_stdout, reason = "printing is what this program does")]

use nalgebra::{SVector, vector};
use std::error::Error;
use std::hint::black_box;
use std::io::{Write, stdout};
use std::process::Command;
use std::time::{Duration, Instant};
use symspline::Direction::{U, V};
use symspline::{Curve, Evaluate, Function, Q, Result, SplineSpace, Surface, TensorSpline};

type Outcome<X> = std::result::Result<X, Box<dyn Error>>;
type Point = SVector<f64, 3>;
type Parameters = fn(usize, usize) -> Vec<f64>;
type Pairs = Vec<(f64, f64)>;

/// A name, and the program of a cell for a number of control points.
type Operation = (&'static str, fn(usize) -> Outcome<Cost>);

/// The time of an operation, and the peak memory of the process up to its end in megabytes, where the system tells.
type Cost = (Duration, Option<usize>);

const MILLION: usize = 1_000_000;

const CURVES: [Operation; 17] = [
    ("make", |n| timed(|| curve(n)).and_then(|(c, cost)| close([c.at(&0.0)?, point(0)], cost))),
    ("10⁶ values, in order", |n| values(n, sorted, false)),
    ("10⁶ values, at random", |n| values(n, random, false)),
    ("make an evaluator", |n| on(a_curve(n)?, |c| c.evaluator(), |c, e, x| Ok([c.at(x)?, e.at(x)?]))),
    ("10⁶ values by it, in order", |n| values(n, sorted, true)),
    ("10⁶ values by it, at random", |n| values(n, random, true)),
    ("insert a knot in every span", |n| {
        on(a_curve(n)?, |c| c.embedded(&c.space().bisected()?), |c, d, x| Ok([c.at(x)?, d.at(x)?]))
    }),
    ("remove these knots", |n| {
        let fine = curve(n)?.embedded(&space(3, n - 3)?.bisected()?)?;
        let back = |_: &_| fine.without_spare_knots(&1e-12);
        on(a_curve(n)?, back, |c, back, _| Ok([c.coeffs()[n / 2], back.spline.coeffs()[n / 2]]))
    }),
    ("raise the degree", |n| on(a_curve(n)?, |c| c.elevated(1), |c, d, x| Ok([c.at(x)?, d.at(x)?]))),
    ("lower it again", |n| {
        let raised = curve(n)?.elevated(1)?;
        let back = |_: &_| raised.degree_lowered(1)?.within(&1e-12);
        on(a_curve(n)?, back, |c, back, x| Ok([c.at(x)?, back.at(x)?]))
    }),
    ("product with a quadratic function", |n| {
        let f = Function::new(space(2, n - 3)?, (0..n - 1).map(|i| point(i)[0]).collect())?;
        on(a_curve(n)?, |c| c.times(&f), |c, product, x| Ok([c.at(x)? * f.at(x)?, product.at(x)?]))
    }),
    ("derivative", |n| on(a_curve(n)?, Curve::derivative, |c, d, x| Ok([c.derivative_at(x, 1)?, d.at(x)?]))),
    ("antiderivative", |n| {
        on(a_curve(n)?, Curve::antiderivative, |c, area, x| Ok([c.at(x)?, area.derivative_at(x, 1)?]))
    }),
    ("integral", |n| {
        let end = curve(n)?.antiderivative()?.coeffs()[n];
        on(a_curve(n)?, Curve::integral, |_, integral, _| Ok([end, *integral]))
    }),
    ("inner product with itself", |n| {
        let c = curve(n)?;
        let (inner, cost) = timed(|| c.inner(&c))?;
        let images = c.space().gram(c.space(), 0, 0)?.apply(c.coeffs())?;
        let expected: f64 = c.coeffs().iter().zip(&images).map(|(a, b)| a.dot(b)).sum();
        close([Point::x() * (inner / expected), Point::x()], cost)
    }),
    ("Gram matrix", |n| {
        let space = space(3, n - 3)?;
        let (gram, cost) = timed(|| space.gram(&space, 0, 0))?;
        let found: f64 = gram.apply(&vec![1.0; n])?.iter().sum();
        close([Point::x() * (found / knot(n - 3)), Point::x()], cost)
    }),
    ("to rationals", |n| {
        let at = |exact: &Curve<Q, 3>, x: &f64| {
            Ok::<_, symspline::Error>(exact.at(&Q::try_from(*x)?)?.map(|q| q.to_f64()))
        };
        on(a_curve(n)?, Curve::to_exact, |c, exact, x| Ok([c.at(x)?, at(exact, x)?]))
    }),
];

const SURFACES: [Operation; 11] = [
    ("make", |n| timed(|| surface(n)).and_then(|(s, cost)| close([s.at(&0.0, &0.0)?, point(0)], cost))),
    ("10⁶ values, in order", |n| values_on(n, sorted, false)),
    ("10⁶ values, at random", |n| values_on(n, random, false)),
    ("make an evaluator", |n| {
        on(a_surface(n)?, |s| s.evaluator(), |s, e, (u, v)| Ok([s.at(u, v)?, e.at(&(*u, *v))?]))
    }),
    ("10⁶ values by it, in order", |n| values_on(n, sorted, true)),
    ("10⁶ values by it, at random", |n| values_on(n, random, true)),
    ("insert a knot in every span along u", |n| {
        let finer = |s: &Surface<f64, 3>| s.embedded(&s.u().bisected()?, s.v());
        on(a_surface(n)?, finer, |s, fine, (u, v)| Ok([s.at(u, v)?, fine.at(u, v)?]))
    }),
    ("raise the degree along v", |n| {
        on(a_surface(n)?, |s| s.elevated(V, 1), |s, t, (u, v)| Ok([s.at(u, v)?, t.at(u, v)?]))
    }),
    ("product with a bilinear function", |n| {
        let line = space(1, n.isqrt() - 3)?;
        let heights = (0..line.dim() * line.dim()).map(|i| point(i)[0]).collect();
        let f = TensorSpline::new(line.clone(), line, heights)?;
        on(a_surface(n)?, |s| s.times(&f), |s, t, (u, v)| Ok([s.at(u, v)? * f.at(u, v)?, t.at(u, v)?]))
    }),
    ("antiderivative along u", |n| {
        let slope = |s: &Surface<f64, 3>, u: &f64, v: &f64| s.derivative_at(u, v, 1, 0);
        on(a_surface(n)?, |s| s.antiderivative(U), |s, t, (u, v)| Ok([s.at(u, v)?, slope(t, u, v)?]))
    }),
    ("integral", |n| {
        let twice = surface(n)?.antiderivative(U)?.antiderivative(V)?;
        let corner = twice.coeffs()[twice.coeffs().len() - 1];
        on(a_surface(n)?, |s| s.integral(), |_, integral, _| Ok([corner, *integral]))
    }),
];

fn main() -> Outcome<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [table, row, size] = &arguments[..] {
        let operations: &[Operation] = if table == "curves" { &CURVES } else { &SURFACES };
        let cost = operations[row.parse::<usize>()?].1(size.parse()?)?;
        let peak = cost.1.map(|peak| format!(", {peak} MB")).unwrap_or_default();
        println!("{:.1} ms{peak}", 1e3 * cost.0.as_secs_f64());
        return Ok(());
    }
    table("curves", &CURVES, [10_000, 100_000, MILLION])?;
    table("surfaces", &SURFACES, [100 * 100, 316 * 316, 1000 * 1000])
}

/// Prints a table, every cell from a process of its own.
fn table(name: &str, operations: &[Operation], sizes: [usize; 3]) -> Outcome<()> {
    println!("| {name} | {} | {} | {} |\n|---|---|---|---|", sizes[0], sizes[1], sizes[2]);
    for (row, (operation, _)) in operations.iter().enumerate() {
        print!("| {operation} |");
        for size in sizes {
            let arguments = [name.to_string(), row.to_string(), size.to_string()];
            let output = Command::new(std::env::current_exe()?).args(arguments).output()?;
            let text = if output.status.success() { &output.stdout } else { &output.stderr };
            print!(" {} |", String::from_utf8_lossy(text).trim());
            stdout().flush()?;
        }
        println!();
    }
    println!();
    Ok(())
}

fn timed<X>(operation: impl FnOnce() -> Result<X>) -> Outcome<(X, Cost)> {
    let start = Instant::now();
    let (result, time) = (black_box(operation()?), start.elapsed());
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = peak.and_then(|peak| peak.trim().strip_suffix(" kB")?.parse::<usize>().ok());
    Ok((result, (time, kilobytes.map(|kilobytes| kilobytes / 1000))))
}

/// The cost, if what was found is what was expected.
fn close([expected, found]: [Point; 2], cost: Cost) -> Outcome<Cost> {
    if (found - expected).norm() <= 1e-9 * (1.0 + expected.norm()) {
        return Ok(cost);
    }
    Err(format!("found {found} instead of {expected}").into())
}

/// Checks some of a million values.
fn batch(
    operation: impl FnOnce() -> Result<Vec<Point>>,
    expected: impl Fn(usize) -> Result<Point>,
) -> Outcome<Cost> {
    let (values, cost) = timed(operation)?;
    (0..values.len()).step_by(1001).try_fold(cost, |cost, i| close([expected(i)?, values[i]], cost))
}

/// Checks at a thousand places what becomes of a spline.
fn on<S, X, P>(
    (s, places): (S, Vec<P>),
    operation: impl FnOnce(&S) -> Result<X>,
    pair: impl Fn(&S, &X, &P) -> Result<[Point; 2]>,
) -> Outcome<Cost> {
    let (result, cost) = timed(|| operation(&s))?;
    places.iter().try_fold(cost, |cost, x| close(pair(&s, &result, x)?, cost))
}

/// Values at a million parameters, by an evaluator or without.
fn values(n: usize, parameters: Parameters, prepared: bool) -> Outcome<Cost> {
    let (c, x) = (curve(n)?, parameters(n - 3, MILLION));
    let evaluator = prepared.then(|| c.evaluator()).transpose()?;
    batch(|| evaluator.as_ref().map_or_else(|| c.eval(&x), |e| e.eval(&x)), |i| c.at(&x[i]))
}

fn values_on(n: usize, parameters: Parameters, prepared: bool) -> Outcome<Cost> {
    let (s, x) = (surface(n)?, pairs(n, parameters, 1000));
    let evaluator = prepared.then(|| s.evaluator()).transpose()?;
    batch(|| evaluator.as_ref().map_or_else(|| s.eval(&x), |e| e.eval(&x)), |i| s.at(&x[i].0, &x[i].1))
}

/// A curve, and parameters.
fn a_curve(n: usize) -> Result<(Curve<f64, 3>, Vec<f64>)> {
    Ok((curve(n)?, random(n - 3, 1000)))
}

fn a_surface(n: usize) -> Result<(Surface<f64, 3>, Pairs)> {
    Ok((surface(n)?, pairs(n, random, 32)))
}

fn curve(n: usize) -> Result<Curve<f64, 3>> {
    Curve::new(space(3, n - 3)?, (0..n).map(point).collect())
}

fn surface(n: usize) -> Result<Surface<f64, 3>> {
    let space = space(3, n.isqrt() - 3)?;
    Surface::new(space.clone(), space, (0..n).map(point).collect())
}

fn space(degree: usize, spans: usize) -> Result<SplineSpace<f64>> {
    SplineSpace::clamped(degree, (0..=spans).map(knot))
}

fn knot(i: usize) -> f64 {
    i as f64 + 0.3 * (i as f64).sin()
}

fn point(i: usize) -> Point {
    let x = i as f64;
    vector![(0.7 * x).cos(), (0.3 * x).sin(), 1.0 + (0.2 * x).cos()]
}

fn sorted(spans: usize, count: usize) -> Vec<f64> {
    let mut parameters = random(spans, count);
    parameters.sort_by(f64::total_cmp);
    parameters
}

/// Parameters in a domain, by a congruential generator: no cache or predictor follows them.
fn random(spans: usize, count: usize) -> Vec<f64> {
    let next =
        |s: &u64| Some(s.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407));
    let states = std::iter::successors(Some(1_u64), next).skip(1).take(count);
    states.map(|s| knot(spans) * ((s >> 11) as f64 / (1_u64 << 53) as f64)).collect()
}

/// `side²` parameters: in order, row by row.
fn pairs(n: usize, parameters: Parameters, side: usize) -> Pairs {
    let spans = n.isqrt() - 3;
    let (us, vs) = (parameters(spans, side * side), parameters(spans, side * side));
    (0..side * side).map(|i| (us[i], vs[i % side * side])).collect()
}
