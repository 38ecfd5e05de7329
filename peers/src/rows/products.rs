//! Products of two functions over the same simple knots. No other crate here multiplies splines.

use crate::bounds::product::{
    Scalars, cubic, cubic_pieces, multiply_cubic, multiply_quadratic, quadratic, quadratic_pieces,
};
use crate::data::{knots, q, wave};
use crate::measure::{Column, Found, Session};
use crate::rows::spread;
use std::hint::black_box;
use symspline::{Function, Q, SplineSpace};

const GROUP: &str = "Products";
const ACCURACY: f64 = 1e-12;

pub fn rows(session: &mut Session, sizes: &[usize]) {
    for degree in [3, 2] {
        for spans in sizes {
            product(session, degree, *spans);
        }
        for spans in sizes {
            bernstein(session, degree, *spans);
        }
    }
}

fn function(degree: usize, t: &[f64], shift: usize) -> Function<f64> {
    let space = SplineSpace::new(degree, t.iter().copied()).expect("the knots are valid");
    let coeffs = (0..space.dim()).map(|k| wave(k + shift)).collect();
    Function::new(space, coeffs).expect("one coefficient a basis function")
}

fn exact(f: &Function<f64>) -> Function<Q> {
    f.to_exact().expect("all numbers are finite")
}

fn values(f: impl Fn(&Q) -> Q, t: &[f64], degree: usize) -> Vec<f64> {
    let breaks = &t[degree..t.len() - degree];
    let inside = |k: usize| breaks[k] + (breaks[k + 1] - breaks[k]) / 3.0;
    spread(breaks.len() - 1).into_iter().map(|k| f(&q(inside(k))).to_f64()).collect()
}

/// From coefficients to coefficients.
fn product(session: &mut Session, degree: usize, spans: usize) {
    const INSIDE: &str = "the parameter is in the domain";
    let t = &knots(degree, spans);
    let (f, g) = (function(degree, t, 0), function(degree, t, 2));
    let (exact_f, exact_g) = (exact(&f), exact(&g));
    let expected = values(|x| exact_f.at(x).expect(INSIDE) * exact_g.at(x).expect(INSIDE), t, degree);
    let size = Some((degree + 1) * spans + degree);
    let look = |h: &Function<f64>| {
        let values = values(|x| exact(h).at(x).expect(INSIDE), t, degree);
        Found { values, size: Some(h.coeffs().len()) }
    };
    let name = format!("product {degree} x {degree}");
    let mut race = session.race(GROUP, &name, (spans, "span"));
    race = race.expect(Found { values: expected, size }, ACCURACY);
    race.add(
        Column::Symspline,
        || (f.clone(), g.clone(), None),
        |(f, g, h), _| *h = Some(black_box(&*f).times(g).expect("domains agree")),
        |(_, _, h)| look(h.as_ref().expect("it ran")),
    );
    let multiply = if degree == 3 { cubic } else { quadratic };
    race.add(
        Column::Bound,
        || (t.clone(), f.coeffs().to_vec(), g.coeffs().to_vec(), None),
        move |(t, f, g, h), _| *h = Some(multiply(black_box(t), f, g)),
        |(_, _, _, h): &(_, _, _, Option<Scalars>)| {
            let h = h.clone().expect("it ran");
            let space = SplineSpace::new(h.degree, h.knots).expect("the knots are valid");
            look(&Function::new(space, h.coeffs).expect("one coefficient a basis function"))
        },
    );
    session.rows.push(race.run());
}

/// The Bernstein products alone, of pieces at hand: symspline's whole product beside them.
fn bernstein(session: &mut Session, degree: usize, spans: usize) {
    let t = &knots(degree, spans);
    let (f, g) = (function(degree, t, 0), function(degree, t, 2));
    let name = format!("product {degree} x {degree}, bound without cutting and recomposing");
    let mut race = session.race(GROUP, &name, (spans, "span")).expect(Vec::new(), ACCURACY);
    race.add(
        Column::Symspline,
        || (f.clone(), g.clone(), None),
        |(f, g, h), _| *h = Some(black_box(&*f).times(g).expect("domains agree")),
        |_| Vec::new().into(),
    );
    if degree == 3 {
        race.add(
            Column::Bound,
            || (cubic_pieces(t, f.coeffs()), cubic_pieces(t, g.coeffs()), Vec::new()),
            |(f, g, h), _| *h = multiply_cubic(black_box(f), g),
            |_| Vec::new().into(),
        );
    } else {
        race.add(
            Column::Bound,
            || (quadratic_pieces(t, f.coeffs()), quadratic_pieces(t, g.coeffs()), Vec::new()),
            |(f, g, h), _| *h = multiply_quadratic(black_box(f), g),
            |_| Vec::new().into(),
        );
    }
    session.rows.push(race.run());
}
