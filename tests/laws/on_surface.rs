//! Laws of curves on surfaces.

use crate::strategies::{CLAMPED, Kind, SMOOTH, cases, number, probes, space};
use nalgebra::vector;
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{Curve, Direction, Function, Q, Scalar, SplineSpace, TensorSpline};

const FLAT: Kind = CLAMPED.of_degree(0, 2);

/// A scalar surface, with jumps and kinks.
fn surface() -> impl Strategy<Value = TensorSpline<Q>> {
    (space(FLAT), space(FLAT), vec(number(), 64)).prop_map(|(u, v, numbers)| {
        let coeffs = numbers.into_iter().cycle().take(u.dim() * v.dim()).collect();
        TensorSpline::new(u, v, coeffs).expect("as many coefficients as the grid has")
    })
}

/// A polygon in the domain of a surface, from points given as shares of the sides: all cuts are rational.
fn polygon(surface: &TensorSpline<Q>, shares: &[(i64, i64)]) -> Curve<Q, 2> {
    let place = |space: &SplineSpace<Q>, share: i64| {
        let (a, b) = space.domain();
        a.clone() + (b.clone() - a) * Q::frac(share, 12)
    };
    let points = shares.iter().map(|(x, y)| vector![place(surface.u(), *x), place(surface.v(), *y)]);
    let spans = shares.len() - 1;
    let space = SplineSpace::uniform(1, spans, Q::int(0), Q::int(1)).expect("a polygon has a span");
    Curve::new(space, points.collect()).expect("as many points as corners")
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn composition_gives_the_values_on_the_surface(
        s in surface(),
        shares in vec((0_i64..=12, 0_i64..=12), 2..5),
    ) {
        let curve = polygon(&s, &shares);
        let composed = s.composed(&curve)?;
        let degree = s.u().degree() + s.v().degree();
        prop_assert_eq!(composed.degree(), degree);
        for x in probes(composed.space()) {
            // Where a kink of the surface is crossed the side counts; between the knots there is but one value.
            if composed.space().breaks().iter().all(|(t, _)| *t != x) {
                let point = curve.at(&x)?;
                prop_assert_eq!(composed.at(&x)?, s.at(&point[0], &point[1])?);
            }
        }
    }

    #[test]
    fn isocurves_are_compositions(s in surface(), share in 0_i64..12) {
        let (a, b) = s.u().domain();
        let x = s.v().domain().0.clone() + (s.v().domain().1.clone() - s.v().domain().0) * Q::frac(share, 12);
        let space = SplineSpace::bezier(1, a.clone(), b.clone())?;
        let line = Curve::new(space, vec![vector![a.clone(), x.clone()], vector![b.clone(), x.clone()]])?;
        prop_assert!(s.composed(&line)?.same_function(&s.isocurve(Direction::V, &x)?)?);
    }

    #[test]
    fn products_compose_factor_by_factor(
        s in surface(),
        t in surface(),
        shares in vec((0_i64..=12, 0_i64..=12), 2..4),
    ) {
        let [u, v] = [s.u(), s.v()].map(|space| (space.domain().0.clone(), space.domain().1.clone()));
        let t = TensorSpline::new(
            t.u().reparametrised(&u.0, &u.1)?,
            t.v().reparametrised(&v.0, &v.1)?,
            t.coeffs().to_vec(),
        )?;
        let curve = polygon(&s, &shares);
        let whole = s.times(&t)?.composed(&curve)?;
        let parts: Function<Q> = s.composed(&curve)?.times(&t.composed(&curve)?)?;
        prop_assert!(whole.same_function(&parts)?);
    }

    #[test]
    fn the_chain_rule_holds(shares in vec((0_i64..=12, 0_i64..=12), 2..4), numbers in vec(number(), 12),
        u in space(SMOOTH.of_degree(1, 2)), v in space(SMOOTH.of_degree(1, 2))) {
        let (u, v) = (u.clamped_ends()?, v.clamped_ends()?);
        let count = u.dim() * v.dim();
        let s = TensorSpline::new(u, v, numbers.into_iter().cycle().take(count).collect())?;
        // One segment, so that the slope of the curve is constant.
        let curve = polygon(&s, &shares[..2]);
        let slope = curve.derivative()?;
        let along = |direction: Direction, axis: usize| -> symspline::Result<Function<Q>> {
            s.derivative(direction)?.composed(&curve)?.times(&slope.coordinate(axis)?)
        };
        let sum = along(Direction::U, 0)?.sum(&along(Direction::V, 1)?)?;
        let whole = s.composed(&curve)?.derivative()?;
        for x in probes(sum.space()) {
            if sum.space().breaks().iter().all(|(t, _)| *t != x) {
                prop_assert_eq!(whole.at(&x)?, sum.at(&x)?);
            }
        }
    }
}
