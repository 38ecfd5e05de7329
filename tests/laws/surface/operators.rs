//! Laws of the operators of one variable along either direction.

use super::{BOTH, SIDE, SMOOTH_SIDE, across};
use crate::strategies::{
    OPEN, cases, field, fields, indices, insertable, number, point, probe_pairs, probes, spaces, surface,
    surfaces,
};
use nalgebra::vector;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use symspline::Direction::{U, V};
use symspline::{Direction, Q, Result, Row, Scalar, Spline, SplineSpace, TensorSpline};

/// The operators that are tried in both directions.
#[derive(Clone, Copy, Debug)]
enum Operator {
    Insert,
    Elevate,
    Clamp,
    Restrict,
    Reverse,
    Derive,
}
use Operator::{Clamp, Derive, Elevate, Insert, Restrict, Reverse};

impl Operator {
    /// The operator on splines of one variable.
    fn on<C: symspline::Coeff<Q>>(self, f: &Spline<Q, C>) -> Result<Spline<Q, C>> {
        let (a, b) = f.domain();
        let part = |n: i64| a.clone() + (b.clone() - a) * Q::frac(13 * n, 101);
        match self {
            Insert => f.inserted(&[part(2), part(4)]),
            Elevate => f.elevated(2),
            Clamp => f.clamped_ends(),
            Restrict => f.restricted(&part(1), &part(5)),
            Reverse => f.reversed(),
            Derive => f.derivative(),
        }
    }

    /// The same by the named method of surfaces.
    fn named(self, s: &TensorSpline<Q>, direction: Direction) -> Result<TensorSpline<Q>> {
        let (a, b) = s.space(direction).domain();
        let part = |n: i64| a.clone() + (b.clone() - a) * Q::frac(13 * n, 101);
        match self {
            Insert => s.inserted(direction, &[part(2), part(4)]),
            Elevate => s.elevated(direction, 2),
            Clamp => s.along(direction, Spline::clamped_ends),
            Restrict => s.restricted(direction, &part(1), &part(5)),
            Reverse => s.reversed(direction),
            Derive => s.derivative(direction),
        }
    }
}

fn operator() -> impl Strategy<Value = Operator> {
    select(vec![Insert, Elevate, Clamp, Restrict, Reverse, Derive])
}

/// The mirror image of `x` in the domain of `space`.
fn mirrored(space: &SplineSpace<Q>, x: &Q) -> Q {
    let (a, b) = space.domain();
    a.clone() + b - x
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn along_v_each_row_is_a_spline(s in field(SMOOTH_SIDE, SMOOTH_SIDE), op in operator()) {
        let (found, n) = (op.named(&s, V)?, s.v().dim());
        prop_assert_eq!(found.u(), s.u());
        for (row, coeffs) in found.rows().zip(s.coeffs().chunks(n)) {
            let expected = op.on(&Spline::new(s.v().clone(), coeffs.to_vec())?)?;
            prop_assert_eq!((row, found.v()), (expected.coeffs(), expected.space()));
        }
        prop_assert_eq!(found.rows().len(), s.u().dim());
    }

    #[test]
    fn along_u_each_column_is_a_spline(s in field(SMOOTH_SIDE, SMOOTH_SIDE), op in operator()) {
        let (found, n) = (op.named(&s, U)?, s.v().dim());
        prop_assert_eq!(found.v(), s.v());
        for j in 0..n {
            let column = s.coeffs()[j..].iter().step_by(n).cloned().collect();
            let expected = op.on(&Spline::new(s.u().clone(), column)?)?;
            prop_assert!(found.coeffs()[j..].iter().step_by(n).eq(expected.coeffs()));
            prop_assert_eq!(found.u(), expected.space());
        }
    }

    #[test]
    fn operators_along_different_directions_commute(
        s in field(SMOOTH_SIDE, SMOOTH_SIDE),
        one in operator(),
        two in operator(),
    ) {
        let u_first = s.along(U, |f| one.on(f))?.along(V, |f| two.on(f))?;
        let v_first = s.along(V, |f| two.on(f))?.along(U, |f| one.on(f))?;
        prop_assert_eq!(u_first, v_first);
    }

    #[test]
    fn an_operator_along_v_is_that_along_u_of_the_transposed(
        s in field(SMOOTH_SIDE, SMOOTH_SIDE),
        op in operator(),
    ) {
        prop_assert_eq!(op.named(&s, V)?, op.named(&s.transposed(), U)?.transposed());
    }

    #[test]
    fn finer_spaces_change_no_value(
        s in surface::<2>(SIDE, SIDE),
        (us, vs, raises) in (indices(3), indices(3), [0_usize..3, 0_usize..3]),
    ) {
        let (u, v) = (insertable(s.u(), &us), insertable(s.v(), &vs));
        let inserted = s.inserted(U, &u)?.inserted(V, &v)?;
        prop_assert_eq!((inserted.u(), inserted.v()), (&s.u().refined(&u)?, &s.v().refined(&v)?));
        let elevated = s.elevated(U, raises[0])?.elevated(V, raises[1])?;
        let spaces = (s.u().elevated(raises[0])?, s.v().elevated(raises[1])?);
        prop_assert_eq!((elevated.u(), elevated.v()), (&spaces.0, &spaces.1));
        prop_assert_eq!(&s.embedded(&spaces.0, &spaces.1)?, &elevated);
        let clamped = s.clamped_ends()?;
        prop_assert!(clamped.u().is_clamped() && clamped.v().is_clamped());
        for (u, v) in probe_pairs(&s) {
            let value = s.at(&u, &v)?;
            for same in [&inserted, &elevated, &clamped] {
                prop_assert_eq!(&same.at(&u, &v)?, &value);
            }
        }
        for same in [&inserted, &elevated, &clamped] {
            prop_assert!(s.same_function(same)? && same.same_function(&s)?);
        }
    }

    #[test]
    fn embedding_into_two_spaces_changes_no_value(
        [u, x] in spaces(SIDE, OPEN.few(2)),
        [v, y] in spaces(SIDE, OPEN.few(2)),
        c in number(),
    ) {
        let coeffs = (0..u.dim() * v.dim()).map(|i| c.clone() + Q::int((i * i % 11) as i64)).collect();
        let s = TensorSpline::new(u.clone(), v.clone(), coeffs)?;
        let (u, v) = (u.union(&x)?, v.union(&y)?);
        let embedded = s.embedded(&u, &v)?;
        prop_assert_eq!((embedded.u(), embedded.v()), (&u, &v));
        for (x, y) in probe_pairs(&s) {
            prop_assert_eq!(embedded.at(&x, &y)?, s.at(&x, &y)?);
        }
    }

    #[test]
    fn restrictions_and_parts_keep_values_and_parameters(
        s in field(SIDE, SIDE),
        direction in select(BOTH.to_vec()),
        places in [any::<Index>(), any::<Index>()],
    ) {
        let all = probes(s.space(direction));
        let mut ends = places.map(|place| place.get(&all).clone());
        ends.sort();
        let [a, b] = ends;
        prop_assume!(a < b);
        let part = s.restricted(direction, &a, &b)?;
        prop_assert_eq!(part.space(direction).domain(), (&a, &b));
        prop_assert_eq!(part.space(across(direction)), s.space(across(direction)));
        let at = |u: &Q, v: &Q| match direction {
            U => s.isocurve(V, v)?.at_left(u),
            V => s.isocurve(U, u)?.at_left(v),
        };
        for (u, v) in probe_pairs(&part) {
            // At its end the part has the left limit.
            let x = if direction == U { &u } else { &v };
            let expected = if *x == b { at(&u, &v)? } else { s.at(&u, &v)? };
            prop_assert_eq!(part.at(&u, &v)?, expected);
        }
        let (start, end) = s.space(direction).domain();
        if *start < a {
            let both = (s.restricted(direction, start, &a)?, s.restricted(direction, &a, end)?);
            prop_assert_eq!(s.split(direction, &a)?, both);
        }
    }

    #[test]
    fn reversing_mirrors_one_parameter(s in field(SIDE, SIDE)) {
        let (back_u, back_v) = (s.reversed(U)?, s.reversed(V)?);
        for (u, v) in probe_pairs(&s) {
            // Between knots, where sides do not matter.
            let inside = |space: &SplineSpace<Q>, x: &Q| !space.knots().contains(x);
            if inside(s.u(), &u) && inside(s.v(), &v) {
                let value = s.at(&u, &v)?;
                prop_assert_eq!(&back_u.at(&mirrored(s.u(), &u), &v)?, &value);
                prop_assert_eq!(&back_v.at(&u, &mirrored(s.v(), &v))?, &value);
            }
        }
        prop_assert_eq!(&back_u.reversed(U)?, &s);
        prop_assert_eq!(back_v.reversed(V)?, s);
    }

    #[test]
    fn sums_are_pointwise([s, t] in fields([SIDE; 2], [SIDE; 2]), factor in number()) {
        let combined = s.plus_scaled(&factor, &t)?;
        prop_assert_eq!(combined.u(), &s.u().union(t.u())?);
        prop_assert_eq!(combined.v(), &s.v().union(t.v())?);
        let (sum, difference, multiple) = (s.sum(&t)?, s.difference(&t)?, s.scaled(&factor)?);
        for (u, v) in probe_pairs(&combined) {
            let (x, y) = (s.at(&u, &v)?, t.at(&u, &v)?);
            prop_assert_eq!(combined.at(&u, &v)?, x.clone() + factor.clone() * &y);
            prop_assert_eq!(sum.at(&u, &v)?, x.clone() + &y);
            prop_assert_eq!(difference.at(&u, &v)?, x.clone() - &y);
            prop_assert_eq!(multiple.at(&u, &v)?, x * &factor);
        }
        let named = (sum, difference, multiple, s.scaled(&Q::int(-1))?);
        prop_assert_eq!((&s + &t, &s - &t, &s * factor, -&s), named);
        prop_assert_eq!(s.same_function(&t)?, (&s - &t).coeffs().iter().all(|c| *c == Q::int(0)));
    }

    #[test]
    fn translation_moves_every_point([s, _] in surfaces::<3>([SIDE; 2], [SIDE; 2]), by in point::<3>()) {
        let moved = s.translated(&by)?;
        for (u, v) in probe_pairs(&s) {
            prop_assert_eq!(moved.at(&u, &v)?, s.at(&u, &v)? + &by);
        }
        for axis in 0..3 {
            prop_assert_eq!(moved.coordinate(axis)?, s.coordinate(axis)?.translated(&by[axis])?);
        }
    }

    #[test]
    fn rows_take_any_operator_and_functional(s in field(SIDE, SIDE), direction in select(BOTH.to_vec())) {
        // To points: the coefficients may change their kind on the way.
        let doubled = s.along(direction, |rows| {
            let pair = |row: &Row<Q>| Row(row.iter().map(|c| vector![c.clone(), c.clone()]).collect());
            Spline::new(rows.space().clone(), rows.coeffs().iter().map(pair).collect())
        })?;
        prop_assert_eq!(&doubled.coordinate(0)?, &s);
        prop_assert_eq!(&doubled.coordinate(1)?, &s);
        let (a, b) = s.space(direction).domain();
        let total = s.contracted(direction, |rows| rows.integral_between(a, b))?;
        prop_assert_eq!(total.space(), s.space(across(direction)));
    }
}

/// A closed ring keeps its seam through every operator that keeps rings.
#[test]
fn rings_stay_rings() -> Result<()> {
    let ring: SplineSpace<Q> = SplineSpace::periodic(2, [0, 1, 3].map(Q::int), Q::int(4))?;
    let line = SplineSpace::clamped(1, [0, 1].map(Q::int))?;
    let s = TensorSpline::new(ring, line, (0..6).map(Q::int).collect())?;
    for round in
        [s.inserted(U, &[Q::int(2)])?, s.elevated(U, 1)?, s.reversed(U)?, s.derivative(U)?, s.times(&s)?]
    {
        assert!(round.u().is_periodic() && !round.v().is_periodic());
        assert!(round.transposed().v().is_periodic());
    }
    assert!(!s.restricted(U, &Q::int(0), &Q::int(4))?.u().is_periodic());
    Ok(())
}
