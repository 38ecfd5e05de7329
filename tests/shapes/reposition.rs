//! Laws of points moved by control points: by exactly the vector asked for, and nothing elsewhere.

use crate::rational_strategies::{nurbs, nurbs_surface};
use crate::strategies::{ANY, Kind, cases, curve, indices, point, probes, space, surface};
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{
    Coeff, Controlled, Direction, Drag, Error, LegPoint, Q, Scalar, ShapeError, SplineSpace, confined,
};

const SMALL: Kind = ANY.of_degree(0, 3);
const FEW: Kind = SMALL.few(2);

/// A place among those where things happen, its coordinates picked one by one.
fn pick<S: Controlled<Q>>(
    shape: &S,
    places: &[Index],
    make: impl Fn(Vec<Q>) -> S::Parameter,
) -> S::Parameter {
    let along =
        |(direction, place): (&Direction, &Index)| place.get(&probes(shape.space_along(*direction))).clone();
    make(S::DIRECTIONS.iter().zip(places).map(along).collect())
}

fn alone(mut x: Vec<Q>) -> Q {
    x.remove(0)
}

fn pair(x: Vec<Q>) -> (Q, Q) {
    (x[0].clone(), x[1].clone())
}

/// The edit moves the point at `at` by exactly `by`, again and again, and no control points but its own.
fn moves_exactly<S: Controlled<Q>>(
    shape: &S,
    at: &S::Parameter,
    by: &S::Point,
    drag: Result<Drag<Q>, Error>,
) -> Result<(), TestCaseError> {
    let drag = match drag {
        Ok(drag) => drag,
        Err(Error::Shape(ShapeError::NoInfluence { .. } | ShapeError::NoNodeBefore { .. })) => return Ok(()),
        Err(other) => return Err(other.into()),
    };
    let mut moved = shape.clone();
    for times in 1..=2 {
        drag.apply(&mut moved, std::slice::from_ref(by))?;
        let expected = shape.derivative_of(at, S::VALUE)?.plus_scaled(&Q::int(times), by);
        prop_assert_eq!(moved.derivative_of(at, S::VALUE)?, expected);
    }
    for i in (0..shape.control_count()).filter(|i| !drag.indices().contains(i)) {
        prop_assert_eq!(moved.control_point(i), shape.control_point(i));
    }
    prop_assert!((0..shape.control_count()).all(|i| moved.control_weight(i) == shape.control_weight(i)));
    Ok(())
}

/// One, the nearest, the two or four around, with shares as they are by default or given.
fn every_grip<S: Controlled<Q>>(
    shape: &S,
    at: &S::Parameter,
    by: &S::Point,
    gamma: &S::Parameter,
    any: S::Index,
) -> Result<(), TestCaseError> {
    moves_exactly(shape, at, by, Drag::by_one(shape, at, any))?;
    let nearest = Drag::by_nearest(shape, at);
    let mut weights = (0..shape.control_count()).map(|i| shape.control_weight(i));
    let at_infinity = weights.any(|w| w == Ok(Q::int(0)));
    prop_assert!(nearest.is_ok() || at_infinity, "the nearest has influence: {:?}", nearest);
    moves_exactly(shape, at, by, nearest)?;
    moves_exactly(shape, at, by, Drag::by_neighbours(shape, at, None))?;
    moves_exactly(shape, at, by, Drag::by_neighbours(shape, at, Some(gamma)))
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn points_of_curves_move_as_asked(
        c in curve::<2>(SMALL), r in nurbs::<3>(SMALL), places in indices(3), by in (point::<2>(), point::<3>()),
        gamma in (0_i64..=4).prop_map(|n| Q::frac(n, 4)),
    ) {
        prop_assume!(places.len() == 3);
        let at = pick(&c, &places, alone);
        every_grip(&c, &at, &by.0, &gamma, places[1].index(c.control_count()))?;
        let at = pick(&r, &places, alone);
        every_grip(&r, &at, &by.1, &gamma, places[1].index(r.control_count()))?;
    }

    #[test]
    fn points_of_surfaces_move_as_asked(
        s in surface::<3>(FEW, FEW), r in nurbs_surface::<2>(FEW), places in indices(4),
        by in (point::<3>(), point::<2>()), gamma in (0_i64..=4, 0_i64..=4),
    ) {
        prop_assume!(places.len() == 4);
        let gamma = (Q::frac(gamma.0, 4), Q::frac(gamma.1, 4));
        let at = pick(&s, &places, pair);
        let any = (places[2].index(s.u().dim()), places[3].index(s.v().dim()));
        every_grip(&s, &at, &by.0, &gamma, any)?;
        let at = pick(&r, &places, pair);
        let any = (places[2].index(r.u().dim()), places[3].index(r.v().dim()));
        every_grip(&r, &at, &by.1, &gamma, any)?;
    }

    #[test]
    fn outside_the_support_nothing_moves(c in nurbs::<2>(SMALL), place in any::<Index>(), by in point::<2>()) {
        let k = place.index(c.control_count());
        let Some(x) = probes(c.space()).into_iter().find(|x| Drag::by_one(&c, x, k).is_ok()) else { return Ok(()) };
        let moved = Drag::by_one(&c, &x, k)?.applied(&c, &[by])?;
        let dim = c.space().dim();
        let near: Vec<(Q, Q)> = (k..c.space().knots().len() - c.degree() - 1)
            .step_by(dim)
            .map(|i| c.space().support(i).map(|(a, b)| (a.clone(), b.clone())))
            .collect::<Result<_, _>>()?;
        for y in probes(c.space()) {
            if near.iter().all(|(a, b)| y < *a || y >= *b) && y < *c.domain().1 {
                prop_assert_eq!(moved.at(&y)?, c.at(&y)?);
            }
        }
    }

    #[test]
    fn nodes_are_where_they_were_asked_for(space in space(ANY.of_degree(1, 4)), place in any::<Index>()) {
        let x = place.get(&probes(&space)).clone();
        let nearest = space.nearest_node(&x)?;
        let active = space.basis(&x)?;
        let distance = |i: usize| (space.node(i).expect("a node") - &x).abs();
        for i in 0..=space.degree() {
            prop_assert!(distance(nearest) <= distance(active.first() + i));
        }
        match space.node_placing_knot(&x) {
            Ok(None) => prop_assert_eq!(space.node(space.node_before(&x)?)?, x),
            Ok(Some(knot)) => {
                prop_assert!(!space.knots().contains(&knot));
                let finer = match space.refined(std::slice::from_ref(&knot)) {
                    // Beyond the ends of an unclamped space.
                    Err(Error::OutsideDomain { .. }) if !space.is_clamped() => return Ok(()),
                    finer => finer?,
                };
                let nodes = (0..finer.knots().len() - finer.degree() - 1).map(|i| finer.node(i));
                let nodes = nodes.collect::<Result<Vec<Q>, _>>()?;
                prop_assert!(nodes.contains(&x), "{:?} has no node {}", nodes, x);
            }
            Err(Error::Shape(ShapeError::KnotThere { knot })) => {
                prop_assert!(space.knots().iter().any(|t| t.to_string() == knot));
            }
            Err(Error::Shape(ShapeError::NoNodeBefore { .. })) => prop_assert!(!space.is_clamped()),
            Err(Error::TooFewKnots { .. }) => prop_assert!(space.is_periodic() && space.dim() < space.degree()),
            Err(other) => return Err(other.into()),
        }
    }

    #[test]
    fn points_of_legs_become_control_points(
        c in nurbs::<2>(SMALL), s in nurbs_surface::<3>(FEW), places in indices(2), fraction in 1_i64..=6,
    ) {
        prop_assume!(places.len() == 2);
        let fraction = Q::frac(fraction, 7);
        leg_point(&c, Direction::U, places[0].index(c.control_count()), &fraction, |k, _| Ok(k))?;
        let (i, j) = (places[0].index(s.u().dim()), places[1].index(s.v().dim()));
        let m = s.v().dim();
        leg_point(&s, Direction::U, (i, j), &fraction, |k, _| Ok(k * m + j))?;
        leg_point(&s, Direction::V, (i, j), &fraction, |k, finer| finer.flat((i, k)))?;
    }

    #[test]
    fn confined_pulls_change_nothing_outside(
        c in nurbs::<2>(ANY.of_degree(1, 3)), places in indices(3), by in point::<2>(),
    ) {
        prop_assume!(places.len() == 3);
        let mut picked: Vec<Q> = places.iter().map(|place| place.get(&probes(c.space())).clone()).collect();
        picked.sort();
        picked.dedup();
        let [start, x, end] = &picked[..] else { return Ok(()) };
        let (finer, k) = confined(&c, Direction::U, x, (start, end))?;
        prop_assert!(finer.same_function(&c)?);
        prop_assume!(finer.control_weight(k)? != Q::int(0));
        let pulled = Drag::by_one(&finer, x, k)?.applied(&finer, std::slice::from_ref(&by))?;
        prop_assert_eq!(pulled.at(x)?, c.at(x)?.plus_scaled(&Q::int(1), &by));
        let (a, b) = c.domain();
        for (from, to) in [(a, start), (end, b)] {
            if from < to {
                let (new, old) = (pulled.restricted(from, to)?, c.restricted(from, to)?);
                prop_assert!(new.same_function(&old)?);
            }
        }
        // No knot became more frequent, and new ones are in the interval.
        for (t, count) in finer.space().breaks() {
            let before = c.space().breaks().into_iter().find(|(old, _)| *old == t).map_or(0, |(_, count)| count);
            prop_assert!(count == before || (before, count) == (0, 1) && start <= &t && &t <= end);
        }
    }
}

/// The point of the leg is a control point of the finer shape, which is the same.
fn leg_point<S: Controlled<Q>>(
    shape: &S,
    direction: Direction,
    index: S::Index,
    fraction: &Q,
    place: impl Fn(usize, &S) -> Result<usize, Error>,
) -> Result<(), TestCaseError> {
    let leg = match LegPoint::new(shape, direction, index, fraction.clone()) {
        Err(Error::IndexOutOfRange { .. }) => return Ok(()),
        leg => leg?,
    };
    let (finer, k) = match leg.inserted(shape) {
        Err(Error::Multiplicity { .. } | Error::DegreeTooLow { .. } | Error::TooFewKnots { .. }) => {
            return Ok(());
        }
        Err(Error::Weight { .. }) => {
            let weights = (0..shape.control_count()).map(|i| shape.control_weight(i));
            prop_assert!(weights.collect::<Result<Vec<Q>, _>>()?.iter().any(|w| *w <= Q::int(0)));
            return Ok(());
        }
        Err(Error::OutsideDomain { .. }) => {
            let space = shape.space_along(direction);
            prop_assert!(!space.is_clamped() && !space.is_periodic());
            return Ok(());
        }
        done => done?,
    };
    let start = shape.flat(index)?;
    let stride = if direction == S::DIRECTIONS[S::DIRECTIONS.len() - 1] {
        1
    } else {
        shape.space_along(Direction::V).dim()
    };
    let space: &SplineSpace<Q> = shape.space_along(direction);
    let i = start / stride % space.dim();
    let end = start - i * stride + space.slot(i + 1) * stride;
    let (p, q) = (shape.control_point(start)?, shape.control_point(end)?);
    let target = p.scaled(&(Q::int(1) - fraction)).plus_scaled(fraction, &q);
    let found = finer.control_point(place(k, &finer)?)?;
    prop_assert_eq!(&found, &target);
    // From the point itself.
    if !p.minus(&q).vanishes() {
        let again = LegPoint::at(shape, direction, index, &target, &Q::int(0))?;
        prop_assert_eq!(again.fraction(), fraction);
    }
    Ok(())
}

#[test]
fn what_cannot_be_moved_is_refused() {
    let space = SplineSpace::clamped(2, [0, 1, 2].map(Q::int)).unwrap();
    let f = symspline::Function::constant(space, Q::int(1)).unwrap();
    let no_influence = |result: Result<Drag<Q>, Error>| {
        assert!(matches!(result, Err(Error::Shape(ShapeError::NoInfluence { .. }))), "{result:?}");
    };
    no_influence(Drag::by_one(&f, &Q::int(0), 1));
    no_influence(Drag::by_one(&f, &Q::frac(1, 2), 3));
    no_influence(Drag::by_shares(&f, &Q::frac(1, 2), &[(1, Q::int(0))]));
    no_influence(Drag::by_shares(&f, &Q::frac(1, 2), &[]));
    assert!(matches!(Drag::by_one(&f, &Q::int(0), 4), Err(Error::IndexOutOfRange { index: 4, length: 4 })));
    assert!(matches!(Drag::by_one(&f, &Q::int(3), 0), Err(Error::OutsideDomain { .. })));
    let drag = Drag::by_one(&f, &Q::int(0), 0).unwrap();
    let mut other = f.inserted(&[Q::frac(1, 3)]).unwrap();
    let before = other.clone();
    assert_eq!(drag.apply(&mut other, &[Q::int(1)]), Err(Error::CoefficientCount { expected: 4, found: 5 }));
    assert_eq!(drag.apply(&mut other, &[]), Err(Error::CoefficientCount { expected: 4, found: 5 }));
    assert_eq!(other, before);
    let leg = LegPoint::new(&f, Direction::U, 1, Q::int(1));
    assert!(matches!(leg, Err(Error::Shape(ShapeError::NotOnLeg { .. }))));
    assert!(matches!(LegPoint::new(&f, Direction::U, 3, Q::frac(1, 2)), Err(Error::IndexOutOfRange { .. })));
    // All coefficients are one: the leg has no length.
    assert!(matches!(LegPoint::at(&f, Direction::U, 1, &Q::int(1), &Q::int(0)), Err(Error::ZeroLeg { .. })));
}

#[test]
fn huge_moves_leave_the_curve_as_it_is() {
    let mut f = symspline::Function::constant(SplineSpace::bezier(2, 0.0, 1.0).unwrap(), 1e308).unwrap();
    let before = f.clone();
    let drag = Drag::by_one(&f, &0.5, 1).unwrap();
    assert!(matches!(drag.apply(&mut f, &[1e308]), Err(Error::NotFinite { .. })));
    assert_eq!(f, before);
}

#[test]
fn confined_pulls_have_their_knots_to_both_sides() {
    for degree in 1..6 {
        let space = SplineSpace::bezier(degree, Q::int(0), Q::int(1)).unwrap();
        let f = symspline::Function::constant(space, Q::int(0)).unwrap();
        let [start, x, end] = [2, 3, 8].map(|i| Q::frac(i, 10));
        let (finer, k) = confined(&f, Direction::U, &x, (&start, &end)).unwrap();
        let count = |from: &Q, to: &Q| finer.space().knots().iter().filter(|t| from < t && *t < to).count();
        let (before, after) = (count(&start, &x), count(&x, &end));
        assert!(before.abs_diff(after) <= 2, "degree {degree}: {before} and {after}");
        let (from, to) = finer.space().support(k).unwrap();
        assert!(start <= *from && *to <= end);
    }
}

#[test]
fn legs_across_the_seam_of_a_ring_have_their_points() {
    let space = SplineSpace::uniform_periodic(2, 5, Q::int(0), Q::int(5)).unwrap();
    let points = [1, 4, 9, 16, 25].map(Q::int).to_vec();
    let ring = symspline::Function::new(space, points.clone()).unwrap();
    for k in 0..5 {
        // The knot in the middle is there already, for one leg at the seam.
        let leg = LegPoint::new(&ring, Direction::U, k, Q::frac(1, 2)).unwrap();
        assert_eq!(leg.is_knot(&ring), Ok(true));
        let (finer, place) = leg.inserted(&ring).unwrap();
        assert_eq!(finer.coeffs()[place], (points[k].clone() + &points[(k + 1) % 5]) / Q::int(2));
        assert_eq!(finer.same_function(&ring), Ok(true));
    }
    let seam = |x: &Q| ring.space().node_placing_knot(x).unwrap_err();
    for x in [Q::int(0), Q::int(1), Q::int(4)] {
        assert!(matches!(seam(&x), Error::Shape(ShapeError::KnotThere { .. })));
    }
    assert_eq!(seam(&Q::int(0)), ShapeError::KnotThere { knot: "0".into() }.into());
}
