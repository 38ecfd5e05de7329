//! Operators on a cubic space curve with simple knots. Results are evaluated exactly, as the rational images of what
//! came out.

use crate::candidates::{Operator, Operators, Parts};
use crate::data::{CurveData, Point, q, rounded};
use crate::enter;
use crate::measure::{Found, Race, Session};
use crate::peers::bounds::Bounds;
use crate::peers::symspline::Symspline;
use crate::rows::spread;
use nalgebra::SVector;
use std::hint::black_box;
use symspline::{Curve, Q, SplineSpace, chord_length};

const GROUP: &str = "Operators";
/// Relative to the largest value; the tolerance of removals and reductions is `1e-9` where a crate takes one.
const ACCURACY: f64 = 1e-9;
/// Derivatives and integrals of scaled knots lose digits with the length of the domain.
const INTEGRALS: f64 = 1e-9;

macro_rules! all {
    ($call:ident $arguments:tt) => {
        enter!($call $arguments: Symspline, Bounds; "curvo" => crate::peers::curvo::Curvo,
            "truck" => crate::peers::truck::Truck, "monstertruck" => crate::peers::monstertruck::Monstertruck,
            "bsplines" => crate::peers::bsplines::Bsplines)
    };
}

/// A third into some of the spans, and the ends.
fn samples(data: &CurveData) -> Vec<f64> {
    let breaks = &data.knots[data.degree..data.knots.len() - data.degree];
    let inside = spread(breaks.len() - 1).into_iter().map(|k| breaks[k] + (breaks[k + 1] - breaks[k]) / 3.0);
    inside.chain([breaks[0], breaks[breaks.len() - 1]]).collect()
}

fn values(curve: &Curve<Q, 3>, xs: &[f64]) -> Vec<f64> {
    let exactly = |x: &f64| curve.at(&q(*x)).expect("the parameter is in the domain");
    rounded(&xs.iter().map(exactly).collect::<Vec<_>>())
}

/// What the parts say at the samples. Ends of scaled knots may be off by a rounding.
fn found(mut parts: Parts, xs: &[f64]) -> Found {
    let (first, last) = (xs[xs.len() - 2], xs[xs.len() - 1]);
    for t in &mut parts.knots {
        let near = |end: f64| (*t - end).abs() <= 1e-15 * last;
        *t = if near(first) {
            first
        } else if near(last) {
            last
        } else {
            *t
        };
    }
    let size = Some(parts.points.len());
    let space = SplineSpace::new(parts.degree, parts.knots).expect("the knots are valid");
    let points = parts.points.into_iter().map(SVector::from).collect();
    let curve = Curve::<f64, 3>::new(space, points).expect("one point a basis function");
    Found { values: values(&curve.to_exact().expect("points are finite"), xs), size }
}

fn expected(curve: &Curve<Q, 3>, xs: &[f64], size: usize) -> Found {
    Found { values: values(curve, xs), size: Some(size) }
}

pub fn rows(session: &mut Session, sizes: &[usize]) {
    for spans in sizes {
        refinement(session, *spans);
    }
    for spans in sizes {
        elevation(session, *spans);
    }
    for spans in sizes {
        removal(session, *spans);
    }
    for spans in sizes {
        reduction(session, *spans);
    }
    for spans in sizes {
        calculus(session, *spans, true);
    }
    for spans in sizes {
        calculus(session, *spans, false);
    }
    for spans in sizes {
        pieces(session, *spans);
    }
    for points in [100, 1000] {
        interpolation(session, points);
    }
}

/// The middles of the spans.
fn middles(data: &CurveData) -> Vec<f64> {
    let breaks = &data.knots[data.degree..data.knots.len() - data.degree];
    breaks.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect()
}

/// The data of the same curve with twice as many spans or a degree more.
fn other(data: &CurveData, f: impl Fn(&Curve<f64, 3>) -> Curve<f64, 3>) -> CurveData {
    let parts = Symspline::parts(&f(&Symspline::curve(data)));
    let weights = vec![1.0; parts.points.len()];
    CurveData { degree: parts.degree, knots: parts.knots, points: parts.points, weights }
}

fn refinement(session: &mut Session, spans: usize) {
    fn enter<O: Operators>(race: &mut Race, data: &CurveData, knots: &[f64], xs: &[f64]) {
        if let Some(refine) = O::REFINE {
            let knots = knots.to_vec();
            race.add(
                O::COLUMN,
                || (O::curve(data), None),
                move |(curve, fine), _| *fine = Some(refine(black_box(curve), &knots)),
                |(_, fine)| found(O::parts(fine.as_ref().expect("it ran")), xs),
            );
        }
    }
    let data = &CurveData::new(3, spans);
    let (knots, xs) = (middles(data), samples(data));
    let race = session.race(GROUP, "a knot in the middle of each span", (spans, "span"));
    let mut race = race.expect(expected(&data.exact(), &xs, 2 * spans + 3), ACCURACY);
    all!(enter(&mut race, data, &knots, &xs));
    session.rows.push(race.run());
}

/// Enters an operator without arguments.
fn apply<O: Operators>(race: &mut Race, data: &CurveData, operator: Operator<O::Curve>, xs: &[f64]) {
    if let Some(operator) = operator {
        race.add(
            O::COLUMN,
            || (O::curve(data), None),
            move |(curve, result), _| *result = Some(operator(black_box(curve))),
            |(_, result)| found(O::parts(result.as_ref().expect("it ran")), xs),
        );
    }
}

fn elevation(session: &mut Session, spans: usize) {
    fn enter<O: Operators>(race: &mut Race, data: &CurveData, xs: &[f64]) {
        apply::<O>(race, data, O::ELEVATE, xs);
    }
    let data = &CurveData::new(3, spans);
    let xs = samples(data);
    let race = session.race(GROUP, "elevation by one", (spans, "span"));
    let mut race = race.expect(expected(&data.exact(), &xs, 2 * spans + 3), ACCURACY);
    all!(enter(&mut race, data, &xs));
    session.rows.push(race.run());
}

fn removal(session: &mut Session, spans: usize) {
    fn enter<O: Operators>(race: &mut Race, data: &CurveData, xs: &[f64]) {
        apply::<O>(race, data, O::REMOVE, xs);
    }
    let coarse = CurveData::new(3, spans);
    let xs = samples(&coarse);
    let fine = &other(&coarse, |curve| curve.inserted(&middles(&coarse)).expect("the knots are new"));
    let race = session.race(GROUP, "the inserted knots taken out", (spans, "knot"));
    let mut race = race.expect(expected(&coarse.exact(), &xs, spans + 3), ACCURACY);
    all!(enter(&mut race, fine, &xs));
    session.rows.push(race.run());
}

fn reduction(session: &mut Session, spans: usize) {
    fn enter<O: Operators>(race: &mut Race, data: &CurveData, xs: &[f64]) {
        apply::<O>(race, data, O::REDUCE, xs);
    }
    let cubic = CurveData::new(3, spans);
    let xs = samples(&cubic);
    let quartic = &other(&cubic, |curve| curve.elevated(1).expect("the degree is low"));
    let race = session.race(GROUP, "the elevated degree lowered", (spans, "span"));
    let mut race = race.expect(expected(&cubic.exact(), &xs, spans + 3), ACCURACY);
    all!(enter(&mut race, quartic, &xs));
    session.rows.push(race.run());
}

/// The derivative, or the antiderivative.
fn calculus(session: &mut Session, spans: usize, down: bool) {
    fn derive<O: Operators>(race: &mut Race, data: &CurveData, xs: &[f64]) {
        apply::<O>(race, data, O::DERIVE, xs);
    }
    fn integrate<O: Operators>(race: &mut Race, data: &CurveData, xs: &[f64]) {
        apply::<O>(race, data, O::INTEGRATE, xs);
    }
    let data = &CurveData::new(3, spans);
    let xs = samples(data);
    let (name, exact) = match down {
        true => ("derivative", data.exact().derivative()),
        false => ("antiderivative", data.exact().antiderivative()),
    };
    let size = if down { spans + 2 } else { spans + 4 };
    let exact = exact.expect("the curve is smooth and not periodic");
    let mut race = session.race(GROUP, name, (spans, "span")).expect(expected(&exact, &xs, size), INTEGRALS);
    if down {
        all!(derive(&mut race, data, &xs));
    } else {
        all!(integrate(&mut race, data, &xs));
    }
    session.rows.push(race.run());
}

fn pieces(session: &mut Session, spans: usize) {
    fn enter<O: Operators>(race: &mut Race, data: &CurveData, xs: &[f64]) {
        if let Some(split) = O::SPLIT {
            race.add(
                O::COLUMN,
                || (O::curve(data), None),
                move |(curve, pieces), _| *pieces = Some(split(black_box(curve))),
                |(_, pieces)| found(O::joined(pieces.as_ref().expect("it ran")), xs),
            );
        }
    }
    let data = &CurveData::new(3, spans);
    let xs = samples(data);
    let race = session.race(GROUP, "all Bezier pieces", (spans, "span"));
    let mut race = race.expect(expected(&data.exact(), &xs, 4 * spans), ACCURACY);
    all!(enter(&mut race, data, &xs));
    session.rows.push(race.run());
}

fn interpolation(session: &mut Session, count: usize) {
    fn enter<O: Operators>(race: &mut Race, points: &[Point], xs: &[f64]) {
        if let Some(interpolate) = O::INTERPOLATE {
            let points = points.to_vec();
            race.add(
                O::COLUMN,
                || None,
                move |curve, _| *curve = Some(interpolate(black_box(&points))),
                |curve| found(O::parts(curve.as_ref().expect("it ran")), xs),
            );
        }
    }
    let points = CurveData::new(3, count - 3).points;
    let vectors: Vec<SVector<f64, 3>> = points.iter().map(|point| SVector::from(*point)).collect();
    let parameters = chord_length(&vectors).expect("points differ");
    let chosen: Vec<usize> = spread(count).into_iter().chain([0, count - 1]).collect();
    let xs: Vec<f64> = chosen.iter().map(|i| parameters[*i]).collect();
    let values = chosen.iter().flat_map(|i| points[*i]).collect();
    let race = session.race(GROUP, "interpolation at chord lengths", (count, "point"));
    let mut race = race.expect(Found { values, size: Some(count) }, ACCURACY);
    all!(enter(&mut race, &points, &xs));
    session.rows.push(race.run());
}
