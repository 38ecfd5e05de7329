//! Points and derivatives of a cubic curve with 1000 control points at 100 000 parameters.

use crate::candidates::CurvePoints;
use crate::data::{CurveData, q, random, rounded, sorted};
use crate::enter;
use crate::measure::{Found, Race, Session};
use crate::peers::bounds::{Direct, Fraction, Polynomial};
use crate::peers::prepared;
use crate::rows::spread;
use std::hint::black_box;
use symspline::{Curve, NurbsCurve};

const SPANS: usize = 997;
const COUNT: usize = 100_000;
const POINTS: (usize, &str) = (COUNT, "point");

/// Relative to the largest value: knots of some crates are scaled, which costs digits of parameters.
const VALUES: f64 = 1e-12;
const DERIVATIVES: f64 = 1e-10;

macro_rules! polynomial {
    ($call:ident $arguments:tt) => {
        enter!($call $arguments: Curve<f64, 3>, prepared::Polynomial, Direct, Polynomial; "curvo" => crate::peers::curvo::Polynomial,
            "truck" => crate::peers::truck::Polynomial, "monstertruck" => crate::peers::monstertruck::Polynomial,
            "bsplines" => crate::peers::bsplines::Scaled)
    };
}

macro_rules! rational {
    ($call:ident $arguments:tt) => {
        enter!($call $arguments: NurbsCurve<f64, 3>, prepared::Fraction, Fraction; "curvo" => crate::peers::curvo::Fraction,
            "truck" => crate::peers::truck::Fraction, "monstertruck" => crate::peers::monstertruck::Fraction)
    };
}

pub fn rows(session: &mut Session) {
    let data = &CurveData::new(3, SPANS);
    let exact = data.exact();
    let fraction = data.exact_rational();
    let parameters = [("sorted", &sorted(COUNT, data.end())), ("random", &random(COUNT, data.end()))];
    let values = |xs: &[f64]| {
        let exactly = |i: usize| exact.at(&q(xs[i])).expect("the parameter is in the domain");
        rounded(&spread(COUNT).into_iter().map(exactly).collect::<Vec<_>>())
    };
    let derivatives = |xs: &[f64]| {
        let exactly = |i: usize| exact.derivatives_at(&q(xs[i]), 2).expect("the parameter is in the domain");
        rounded(&spread(COUNT).into_iter().flat_map(exactly).collect::<Vec<_>>())
    };
    let quotients = |xs: &[f64]| {
        let exactly = |i: usize| fraction.at(&q(xs[i])).expect("the parameter is in the domain");
        rounded(&spread(COUNT).into_iter().map(exactly).collect::<Vec<_>>())
    };

    for (order, xs) in parameters {
        let mut race = session.race("Curve", &format!("point, one at a time, {order}"), POINTS);
        race = race.expect(values(xs), VALUES).in_laps();
        polynomial!(singles(&mut race, data, xs));
        session.rows.push(race.run());
    }
    for (order, xs) in parameters {
        let mut race = session.race("Curve", &format!("points, batch, {order}"), POINTS);
        race = race.expect(values(xs), VALUES).in_laps();
        polynomial!(batch(&mut race, data, xs));
        session.rows.push(race.run());
    }
    for (order, xs) in parameters {
        let mut race = session.race("Curve", &format!("two derivatives, one at a time, {order}"), POINTS);
        race = race.expect(derivatives(xs), DERIVATIVES).in_laps();
        polynomial!(single_derivatives(&mut race, data, xs));
        session.rows.push(race.run());
    }
    for (order, xs) in parameters {
        let mut race = session.race("Curve", &format!("two derivatives, batch, {order}"), POINTS);
        race = race.expect(derivatives(xs), DERIVATIVES).in_laps();
        polynomial!(batch_of_derivatives(&mut race, data, xs));
        session.rows.push(race.run());
    }
    let mut race = session.race("Curve", "table built", (SPANS, "span"));
    race = race.expect(Vec::new(), VALUES);
    build::<prepared::Polynomial>(&mut race, data);
    build::<Polynomial>(&mut race, data);
    session.rows.push(race.run());

    for (order, xs) in parameters {
        let mut race = session.race("Rational curve", &format!("point, one at a time, {order}"), POINTS);
        race = race.expect(quotients(xs), VALUES).in_laps();
        rational!(singles(&mut race, data, xs));
        session.rows.push(race.run());
    }
    for (order, xs) in parameters {
        let mut race = session.race("Rational curve", &format!("points, batch, {order}"), POINTS);
        race = race.expect(quotients(xs), VALUES).in_laps();
        rational!(batch(&mut race, data, xs));
        session.rows.push(race.run());
    }
}

fn flat<C: CurvePoints>(points: impl IntoIterator<Item = C::Point>) -> Found {
    points.into_iter().flat_map(C::coordinates).collect::<Vec<_>>().into()
}

fn singles<C: CurvePoints>(race: &mut Race, data: &CurveData, xs: &[f64]) {
    let xs = xs.to_vec();
    let points = xs.clone();
    race.add(
        C::COLUMN,
        || C::of(data),
        move |curve, lap| lap.of(&xs).iter().for_each(|x| _ = black_box(curve.at(*x))),
        |curve| flat::<C>(spread(COUNT).into_iter().map(|i| curve.at(points[i]))),
    );
}

fn batch<C: CurvePoints>(race: &mut Race, data: &CurveData, xs: &[f64]) {
    let xs = xs.to_vec();
    let points = xs.clone();
    race.add(
        C::COLUMN,
        || (C::of(data), Vec::new()),
        move |(curve, out), lap| curve.fill(black_box(lap.of(&xs)), out),
        |(curve, _)| {
            let mut out = Vec::new();
            curve.fill(&points, &mut out);
            flat::<C>(spread(COUNT).into_iter().map(|i| out[i]))
        },
    );
}

fn single_derivatives<C: CurvePoints>(race: &mut Race, data: &CurveData, xs: &[f64]) {
    if C::DERIVATIVES {
        let xs = xs.to_vec();
        let points = xs.clone();
        race.add(
            C::COLUMN,
            || C::of(data),
            move |curve, lap| lap.of(&xs).iter().for_each(|x| _ = black_box(curve.derivatives(*x))),
            |curve| flat::<C>(spread(COUNT).into_iter().flat_map(|i| curve.derivatives(points[i]))),
        );
    }
}

fn batch_of_derivatives<C: CurvePoints>(race: &mut Race, data: &CurveData, xs: &[f64]) {
    if C::DERIVATIVES {
        let xs = xs.to_vec();
        let points = xs.clone();
        race.add(
            C::COLUMN,
            || (C::of(data), Vec::new()),
            move |(curve, out), lap| curve.fill_derivatives(black_box(lap.of(&xs)), out),
            |(curve, _)| {
                let mut out = Vec::new();
                curve.fill_derivatives(&points, &mut out);
                flat::<C>(spread(COUNT).into_iter().flat_map(|i| out[i]))
            },
        );
    }
}

fn build<C: CurvePoints>(race: &mut Race, data: &CurveData) {
    let data = data.clone();
    race.add(
        C::COLUMN,
        || None,
        move |curve, _| *curve = Some(C::of(&data)),
        |_: &Option<C>| Vec::new().into(),
    );
}
