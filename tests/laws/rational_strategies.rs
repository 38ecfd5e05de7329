//! Rational splines that love corner cases: weights of all sizes, and denominators that are positive although some of
//! their coefficients are not.

use crate::strategies::{Kind, coeffs, number, point, space, spaces, three_spaces};
use proptest::prelude::*;
use symspline::{
    Coeff, Function, Interval, NurbsCurve, NurbsSurface, Q, Rational, RationalFunction, Rectangle, Scalar,
    Spline, SplineSpace, TensorSpline, Weighted,
};

/// A weight: small numbers, fractions, tiny, huge.
pub fn weight() -> impl Strategy<Value = Q> + Clone {
    prop_oneof![
        4 => Just(Q::int(1)),
        5 => (1_i64..=9).prop_map(Q::int),
        4 => (1_i64..=9, 1_i64..=9).prop_map(|(n, d)| Q::frac(n, d)),
        1 => (1_i64..=9).prop_map(|n| Q::int(n * 1_000_000_007)),
        1 => (1_i64..=9).prop_map(|n| Q::frac(n, 1_000_003)),
    ]
    .boxed()
}

/// What a rational spline is made of but for its space: points, weights, and whether the denominator shall be
/// `g² + floor max²` with `g` a spline of the space and weights (at most `max`) for its coefficients, every other one negative.
#[derive(Clone, Debug)]
pub struct Parts<C> {
    points: Vec<C>,
    weights: Vec<Q>,
    squared: Option<Q>,
}

fn parts<C: Coeff<Q>>(one: impl Strategy<Value = C> + Clone) -> impl Strategy<Value = Parts<C>> {
    let floor = prop_oneof![Just(Q::frac(1, 8)), Just(Q::int(1)), Just(Q::frac(1, 64))];
    let squared = prop_oneof![3 => Just(None), 1 => floor.prop_map(Some)];
    (coeffs(one), coeffs(weight()), squared).prop_map(|(points, weights, squared)| Parts {
        points,
        weights,
        squared,
    })
}

/// `g` with coefficients of both signs, so that it has zeros.
fn wave(weights: &[Q], dim: usize) -> Vec<Q> {
    (0..dim).map(|i| if i % 2 == 0 { weights[i].clone() } else { -weights[i].clone() }).collect()
}

/// `floor` in proportion to the squares of the coefficients.
fn raised(floor: &Q, g: &[Q]) -> Q {
    let largest = g.iter().map(Q::abs).max().expect("a coefficient");
    largest.clone() * largest * floor
}

/// As many points as are asked for.
fn cycled<C: Clone>(points: &[C], dim: usize) -> Vec<C> {
    points.iter().cycle().take(dim).cloned().collect()
}

fn paired<C: Clone>(points: &[C], weights: &[Q]) -> Vec<Weighted<Q, C>> {
    let pair = |(point, weight): (C, &Q)| Weighted { point, weight: weight.clone() };
    cycled(points, weights.len()).into_iter().zip(weights).map(pair).collect()
}

impl<C: Coeff<Q>> Parts<C> {
    /// The rational spline of one parameter.
    fn over(&self, space: SplineSpace<Q>) -> Rational<Interval, Q, C> {
        let dim = space.dim();
        let Some(floor) = &self.squared else {
            return Rational::<Interval, Q, C>::new(
                space,
                cycled(&self.points, dim),
                cycled(&self.weights, dim),
            )
            .expect("positive weights");
        };
        let g = Function::new(space, wave(&self.weights, dim)).expect("a function");
        let bottom =
            g.times(&g).and_then(|square| square.translated(&raised(floor, g.coeffs()))).expect("a square");
        let lifted = Spline::new(bottom.space().clone(), paired(&self.points, bottom.coeffs()));
        Rational::from_lifted(lifted.expect("a lifted spline")).expect("a square and more is positive")
    }

    /// The rational surface.
    fn over_both(&self, u: SplineSpace<Q>, v: SplineSpace<Q>) -> Rational<Rectangle, Q, C> {
        let dim = u.dim() * v.dim();
        let weights = cycled(&self.weights, dim);
        let Some(floor) = &self.squared else {
            return Rational::<Rectangle, Q, C>::new(u, v, cycled(&self.points, dim), weights)
                .expect("positive weights");
        };
        let g = TensorSpline::new(u, v, wave(&weights, dim)).expect("a function");
        let bottom =
            g.times(&g).and_then(|square| square.translated(&raised(floor, g.coeffs()))).expect("a square");
        let (u, v) = (bottom.u().clone(), bottom.v().clone());
        let lifted =
            TensorSpline::new(u, v, paired(&self.points, bottom.coeffs())).expect("a lifted surface");
        Rational::from_lifted(lifted).expect("a square and more is positive")
    }
}

/// A rational function.
pub fn rational(kind: Kind) -> impl Strategy<Value = RationalFunction<Q>> {
    (space(kind), parts(number().boxed())).prop_map(|(space, parts)| parts.over(space))
}

/// Two rational functions on one domain.
pub fn rationals(kind: Kind) -> impl Strategy<Value = [RationalFunction<Q>; 2]> {
    let parts = || parts(number().boxed());
    (spaces(kind, kind), parts(), parts()).prop_map(|([r, s], p, q)| [p.over(r), q.over(s)])
}

/// Three rational functions on one domain.
pub fn three_rationals(kind: Kind) -> impl Strategy<Value = [RationalFunction<Q>; 3]> {
    let parts = || parts(number().boxed());
    (three_spaces(kind), parts(), parts(), parts())
        .prop_map(|([r, s, t], p, q, o)| [p.over(r), q.over(s), o.over(t)])
}

/// A rational function, and one on the same domain without zeros and of either sign.
pub fn dividend_and_divisor(kind: Kind) -> impl Strategy<Value = [RationalFunction<Q>; 2]> {
    let sign = prop_oneof![Just(Q::int(1)), Just(Q::int(-1))];
    (spaces(kind, kind), parts(number().boxed()), parts(weight()), sign)
        .prop_map(|([r, s], p, q, sign)| [p.over(r), q.over(s).scaled(&sign).expect("a finite sign")])
}

/// A rational curve.
pub fn nurbs<const N: usize>(kind: Kind) -> impl Strategy<Value = NurbsCurve<Q, N>> {
    (space(kind), parts(point::<N>().boxed())).prop_map(|(space, parts)| parts.over(space))
}

/// Two rational curves on one domain.
pub fn two_nurbs<const N: usize>(kind: Kind) -> impl Strategy<Value = [NurbsCurve<Q, N>; 2]> {
    let parts = || parts(point::<N>().boxed());
    (spaces(kind, kind), parts(), parts()).prop_map(|([r, s], p, q)| [p.over(r), q.over(s)])
}

/// A rational surface.
pub fn nurbs_surface<const N: usize>(kind: Kind) -> impl Strategy<Value = NurbsSurface<Q, N>> {
    (space(kind), space(kind), parts(point::<N>().boxed())).prop_map(|(u, v, parts)| parts.over_both(u, v))
}

/// Two rational surfaces on one domain.
pub fn two_nurbs_surfaces<const N: usize>(kind: Kind) -> impl Strategy<Value = [NurbsSurface<Q, N>; 2]> {
    let parts = || parts(point::<N>().boxed());
    (spaces(kind, kind), spaces(kind, kind), parts(), parts())
        .prop_map(|([u, r], [v, s], p, q)| [p.over_both(u, v), q.over_both(r, s)])
}

/// A rational surface and a scalar one on the same domain, without zeros.
pub fn surface_and_divisor<const N: usize>(
    kind: Kind,
) -> impl Strategy<Value = (NurbsSurface<Q, N>, Rational<Rectangle, Q>)> {
    (spaces(kind, kind), spaces(kind, kind), parts(point::<N>().boxed()), parts(weight()))
        .prop_map(|([u, r], [v, s], p, q)| (p.over_both(u, v), q.over_both(r, s)))
}
