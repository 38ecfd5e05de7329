//! Points, tangents and normals of a bicubic surface with 50 by 50 patches at 100 000 points.

use crate::candidates::SurfacePoints;
use crate::data::{SurfaceData, q, random, rounded, sorted};
use crate::enter;
use crate::measure::{Found, Race, Session};
use crate::peers::bounds::{DirectSurface, FractionPatches, PolynomialPatches};
use crate::peers::prepared;
use crate::rows::spread;
use nalgebra::SVector;
use std::hint::black_box;
use symspline::{NurbsSurface, Surface};

const SPANS: usize = 50;
const COUNT: usize = 100_000;
const POINTS: (usize, &str) = (COUNT, "point");
const GRID: (usize, usize) = (1000, 100);
const VALUES: f64 = 1e-12;
/// The grid of curvo makes its parameters by adding up steps.
const ON_GRID: f64 = 1e-10;
const DERIVATIVES: f64 = 1e-11;

macro_rules! polynomial {
    ($call:ident $arguments:tt) => {
        enter!($call $arguments: Surface<f64, 3>, prepared::PolynomialSurface, DirectSurface, PolynomialPatches;
            "curvo" => crate::peers::curvo::PolynomialSurface, "truck" => crate::peers::truck::PolynomialSurface,
            "monstertruck" => crate::peers::monstertruck::PolynomialSurface)
    };
}

macro_rules! rational {
    ($call:ident $arguments:tt) => {
        enter!($call $arguments: NurbsSurface<f64, 3>, prepared::FractionSurface, FractionPatches;
            "curvo" => crate::peers::curvo::FractionSurface, "truck" => crate::peers::truck::FractionSurface,
            "monstertruck" => crate::peers::monstertruck::FractionSurface)
    };
}

pub fn rows(session: &mut Session) {
    let data = &SurfaceData::new(3, SPANS);
    let end = data.end();
    let pairs: Vec<(f64, f64)> = random(2 * COUNT, end).chunks(2).map(|pair| (pair[0], pair[1])).collect();
    let (us, vs) = (sorted(GRID.0, end), sorted(GRID.1, end));
    let (exact, fraction) = (data.exact(), data.exact_rational());
    const INSIDE: &str = "the point is in the domain";
    let at = |pairs: &[(f64, f64)]| -> Vec<f64> {
        let exactly = |i: usize| exact.at(&q(pairs[i].0), &q(pairs[i].1)).expect(INSIDE);
        rounded(&spread(COUNT).into_iter().map(exactly).collect::<Vec<_>>())
    };
    let quotients: Vec<f64> = {
        let exactly = |i: usize| fraction.at(&q(pairs[i].0), &q(pairs[i].1)).expect(INSIDE);
        rounded(&spread(COUNT).into_iter().map(exactly).collect::<Vec<_>>())
    };
    let tangents: Vec<[SVector<f64, 3>; 3]> = {
        let exactly = |i: usize| exact.tangents_at(&q(pairs[i].0), &q(pairs[i].1)).expect(INSIDE);
        spread(COUNT).into_iter().map(|i| exactly(i).map(|c| c.map(|x| x.to_f64()))).collect()
    };
    let normals: Vec<f64> =
        tangents.iter().flat_map(|[_, a, b]| <[f64; 3]>::from(a.cross(b).normalize())).collect();
    let tangents: Vec<f64> = tangents.into_iter().flatten().flat_map(<[f64; 3]>::from).collect();
    let on_grid: Vec<(f64, f64)> = us.iter().flat_map(|u| vs.iter().map(move |v| (*u, *v))).collect();

    let mut race =
        session.race("Surface", "point, one at a time, random", POINTS).expect(at(&pairs), VALUES).in_laps();
    polynomial!(singles(&mut race, data, &pairs));
    session.rows.push(race.run());

    let mut race =
        session.race("Surface", "points, batch, random", POINTS).expect(at(&pairs), VALUES).in_laps();
    polynomial!(batch(&mut race, data, &pairs));
    session.rows.push(race.run());

    let mut race = session.race("Surface", "points, grid 1000 x 100", POINTS).expect(at(&on_grid), ON_GRID);
    polynomial!(grid(&mut race, data, &us, &vs));
    session.rows.push(race.run());

    let mut race =
        session.race("Surface", "first derivatives, random", POINTS).expect(tangents, DERIVATIVES).in_laps();
    polynomial!(tangent_planes(&mut race, data, &pairs));
    session.rows.push(race.run());

    let mut race =
        session.race("Surface", "unit normal, random", POINTS).expect(normals, DERIVATIVES).in_laps();
    polynomial!(normal_vectors(&mut race, data, &pairs));
    session.rows.push(race.run());

    let mut race =
        session.race("Surface", "table built", (SPANS * SPANS, "patch")).expect(Vec::new(), VALUES);
    build::<prepared::PolynomialSurface>(&mut race, data);
    build::<PolynomialPatches>(&mut race, data);
    session.rows.push(race.run());

    let race = session.race("Rational surface", "point, one at a time, random", POINTS);
    let mut race = race.expect(quotients.clone(), VALUES).in_laps();
    rational!(singles(&mut race, data, &pairs));
    session.rows.push(race.run());

    let mut race =
        session.race("Rational surface", "points, batch, random", POINTS).expect(quotients, VALUES).in_laps();
    rational!(batch(&mut race, data, &pairs));
    session.rows.push(race.run());
}

fn flat<S: SurfacePoints>(points: impl IntoIterator<Item = S::Point>) -> Found {
    points.into_iter().flat_map(S::coordinates).collect::<Vec<_>>().into()
}

fn singles<S: SurfacePoints>(race: &mut Race, data: &SurfaceData, pairs: &[(f64, f64)]) {
    let pairs = pairs.to_vec();
    let points = pairs.clone();
    race.add(
        S::COLUMN,
        || S::of(data),
        move |surface, lap| lap.of(&pairs).iter().for_each(|(u, v)| _ = black_box(surface.at(*u, *v))),
        |surface| flat::<S>(spread(COUNT).into_iter().map(|i| surface.at(points[i].0, points[i].1))),
    );
}

fn batch<S: SurfacePoints>(race: &mut Race, data: &SurfaceData, pairs: &[(f64, f64)]) {
    let pairs = pairs.to_vec();
    let points = pairs.clone();
    race.add(
        S::COLUMN,
        || (S::of(data), Vec::new()),
        move |(surface, out), lap| surface.fill(black_box(lap.of(&pairs)), out),
        |(surface, _)| {
            let mut out = Vec::new();
            surface.fill(&points, &mut out);
            flat::<S>(spread(COUNT).into_iter().map(|i| out[i]))
        },
    );
}

fn grid<S: SurfacePoints>(race: &mut Race, data: &SurfaceData, us: &[f64], vs: &[f64]) {
    let (us, vs) = (us.to_vec(), vs.to_vec());
    race.add(
        S::COLUMN,
        || (S::of(data), Vec::with_capacity(COUNT)),
        move |(surface, out), _| surface.grid(black_box(&us), &vs, out),
        |(_, out)| flat::<S>(spread(COUNT).into_iter().map(|i| out[i])),
    );
}

fn tangent_planes<S: SurfacePoints>(race: &mut Race, data: &SurfaceData, pairs: &[(f64, f64)]) {
    if S::TANGENTS {
        let pairs = pairs.to_vec();
        let points = pairs.clone();
        race.add(
            S::COLUMN,
            || S::of(data),
            move |surface, lap| {
                lap.of(&pairs).iter().for_each(|(u, v)| _ = black_box(surface.tangents(*u, *v)))
            },
            |surface| {
                flat::<S>(spread(COUNT).into_iter().flat_map(|i| surface.tangents(points[i].0, points[i].1)))
            },
        );
    }
}

fn normal_vectors<S: SurfacePoints>(race: &mut Race, data: &SurfaceData, pairs: &[(f64, f64)]) {
    if S::TANGENTS {
        let pairs = pairs.to_vec();
        let points = pairs.clone();
        race.add(
            S::COLUMN,
            || S::of(data),
            move |surface, lap| {
                lap.of(&pairs).iter().for_each(|(u, v)| _ = black_box(surface.normal(*u, *v)))
            },
            |surface| flat::<S>(spread(COUNT).into_iter().map(|i| surface.normal(points[i].0, points[i].1))),
        );
    }
}

fn build<S: SurfacePoints>(race: &mut Race, data: &SurfaceData) {
    let data = data.clone();
    race.add(
        S::COLUMN,
        || None,
        move |surface, _| *surface = Some(S::of(&data)),
        |_: &Option<S>| Vec::new().into(),
    );
}
