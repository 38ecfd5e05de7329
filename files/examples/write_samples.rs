//! Writes curves and surfaces of many kinds into a folder, in JSON and in the formats of CAD, for `files/check/cad`.

use std::path::Path;
use symspline::SplineSpace;
use symspline_dynamic::{AnyRational, AnyRationalSurface, AnySpace, AnySpline, AnySurface, Over};
use symspline_files::{Entry, write};

type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

/// Numbers with all their digits, from -1 to 1: a sequence that any start begins.
struct Digits(u64);

impl Digits {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn all(&mut self, count: usize, size: f64) -> Over<Vec<f64>, Vec<symspline::Q>> {
        Over::Float((0..count).map(|_| self.next() * size).collect())
    }

    fn weights(&mut self, count: usize) -> Over<Vec<f64>, Vec<symspline::Q>> {
        Over::Float((0..count).map(|_| 1.5 + self.next()).collect())
    }

    /// Knots that grow by steps with all digits.
    fn knots(&mut self, count: usize) -> Vec<f64> {
        (0..count).scan(self.next(), |t, _| Some(std::mem::replace(t, *t + 1.2 + self.next()))).collect()
    }
}

/// The spaces of a degree: Bézier, clamped with double knots, unclamped, periodic.
fn spaces(digits: &mut Digits, degree: usize) -> Outcome<Vec<(&'static str, SplineSpace<f64>)>> {
    let mut inner = digits.knots(5);
    if degree > 1 {
        inner.insert(2, inner[2]);
    }
    let round = digits.knots(degree + 3);
    let period = round[round.len() - 1] - round[0] + 0.7;
    Ok(vec![
        ("Bezier", SplineSpace::bezier(degree, digits.next() - 1.0, digits.next() + 1.0)?),
        ("clamped", SplineSpace::clamped(degree, inner)?),
        ("unclamped", SplineSpace::new(degree, digits.knots(2 * degree + 5))?),
        ("periodic", SplineSpace::periodic(degree, round, period)?),
    ])
}

fn main() -> Outcome<()> {
    let folder = std::env::args().nth(1).ok_or("a folder is wanted")?;
    let mut digits = Digits(1);
    let (mut curves, mut surfaces) = (Vec::new(), Vec::new());
    for degree in [1, 2, 3, 5, 9, 16] {
        for (kind, space) in spaces(&mut digits, degree)? {
            for (dim, size) in [(2, 1.0), (3, 1e3)] {
                let name = format!("{kind} curve of degree {degree} in {dim}D");
                let (any, count) = (AnySpace::from(space.clone()), space.dim());
                let points = digits.all(dim * count, size);
                curves.push(Entry::named(name.clone(), AnySpline::new(any.clone(), dim, points.clone())?));
                let rational = AnyRational::new(any, dim, points, digits.weights(count))?;
                curves.push(Entry::named(format!("rational {name}"), rational));
            }
        }
    }
    for size in [1e-5, 1e6, 1e12] {
        let space = SplineSpace::clamped(3, [0.0, 1e-3 * size, size])?;
        let points = digits.all(3 * space.dim(), size);
        curves
            .push(Entry::named(format!("curve of size {size:e}"), AnySpline::new(space.into(), 3, points)?));
    }
    for (p, q) in [(1, 1), (2, 3), (4, 2)] {
        for (u_kind, u) in spaces(&mut digits, p)? {
            for (v_kind, v) in spaces(&mut digits, q)? {
                let name = format!("surface of degree {p} ({u_kind}) and {q} ({v_kind})");
                let count = u.dim() * v.dim();
                let (u, v) = (AnySpace::from(u.clone()), AnySpace::from(v));
                let points = digits.all(3 * count, 1e2);
                surfaces.push(Entry::named(
                    name.clone(),
                    AnySurface::new(u.clone(), v.clone(), 3, points.clone())?,
                ));
                let rational = AnyRationalSurface::new(u, v, 3, points, digits.weights(count))?;
                surfaces.push(Entry::named(format!("rational {name}"), rational));
            }
        }
    }
    let in_folder = |name: &str| Path::new(&folder).join(name);
    write(&in_folder("curves.dxf"), &curves)?;
    write(&in_folder("curves.json"), &curves)?;
    write(&in_folder("surfaces.json"), &surfaces)?;
    for ending in ["step", "iges"] {
        write(&in_folder(&format!("curves.{ending}")), &curves)?;
        write(&in_folder(&format!("surfaces.{ending}")), &surfaces)?;
    }
    Ok(())
}
