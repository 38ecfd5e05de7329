//! Laws of warps: control points move by what was asked for, nothing changes outside, and what decides about it, bumps,
//! polygons and gravity fields.

use crate::rational_strategies::{nurbs, nurbs_surface};
use crate::regions::{interval, same_around, same_outside};
use crate::strategies::{ANY, Kind, cases, curve, number, point, space, surface};
use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use std::fmt::Debug;
use symspline::{
    Assigned, Bump, Curve, CurveGravity, Direction, Error, Gravity, Polygons, Q, Refinement, Region,
    Reshaped, Scalar, ShapeError, Spline, SplineSpace, Surface, UnitNormal, Warp, Workable,
};

const CURVE: Kind = ANY.of_degree(0, 4).few(3);
const SIDE: Kind = ANY.of_degree(0, 2).few(1);

/// A place in a list, twice: an interval.
type Ends = (Index, Index);

/// Positive numbers below, at and above one.
fn weight() -> impl Strategy<Value = Q> {
    select([(1, 1000), (1, 5), (1, 1), (7, 3), (30, 1), (1_000_000, 1)].map(|(p, q)| Q::frac(p, q)).to_vec())
}

fn share() -> impl Strategy<Value = Q> {
    (0_i64..=24).prop_map(|n| Q::frac(n, 24))
}

/// A tolerance, or no removal.
fn tolerance() -> impl Strategy<Value = Option<Q>> {
    select(vec![None, Some(Q::int(0)), Some(Q::frac(1, 10)), Some(Q::int(3)), Some(Q::int(1_000_000))])
}

/// The nodes of the control points in a window, from the definition.
fn nodes(space: &SplineSpace<Q>, (a, b): (&Q, &Q)) -> Vec<(usize, Q)> {
    let (t, p) = (space.knots(), space.degree());
    let mean = |i: usize| match p {
        0 => (t[i].clone() + &t[i + 1]) / Q::int(2),
        _ => t[i + 1..=i + p].iter().fold(Q::int(0), |sum, x| sum + x) / Q::int(p as i64),
    };
    let (first, last) = space.domain();
    let turns = |j: usize| (j..t.len() - p - 1).step_by(space.dim());
    let reaches_out = |i: usize| {
        let (from, to) = (t[i].clone().max(first.clone()), t[i + p + 1].clone().min(last.clone()));
        from < to && !(a <= &from && &to <= b)
    };
    // A place in the domain, if there is one.
    let node = |j: usize| {
        let mut nodes = turns(j).map(mean);
        nodes.find(|x| first <= x && x <= last).unwrap_or_else(|| mean(j).clamp(first.clone(), last.clone()))
    };
    let free = (0..space.dim()).filter(|j| !turns(*j).any(reaches_out));
    free.map(|j| (j, (node(j) - a) / (b.clone() - a))).collect()
}

/// Warps a shape and checks what is true of all of them. `shares` are those expected, in the order of the list of places;
/// `same` says whether two shapes are one outside the region.
fn check<S, P>(
    shape: &S,
    region: Region<Q, P>,
    tolerance: Option<Q>,
    displacement: impl Fn(&Assigned<P>) -> Option<S::Point>,
    expected: impl Fn(&S) -> Vec<(usize, P)>,
    same: impl Fn(&S, &S) -> symspline::Result<bool>,
) -> Result<(), TestCaseError>
where
    S: Workable<Q, Parameter = P> + PartialEq,
    P: Clone + Debug + PartialEq,
{
    let warp = |region| Warp::new(region, |at: &Assigned<P>| Ok(displacement(at))).apply(shape);
    let finer = region.refine(shape)?;
    let shares = expected(&finer);
    let warped = match warp(region.clone()) {
        Err(Error::Shape(ShapeError::NoFreePoints)) => {
            prop_assert!(shares.is_empty());
            return Ok(());
        }
        warped => warped?,
    };
    let Reshaped { shape: new, moved, removed, bound, .. } = &warped;
    prop_assert!(removed.is_empty() && *bound == Q::int(0));
    let mut points = finer.control_points()?;
    let mut count = 0;
    for (place, share) in &shares {
        let parameter = S::place(|direction| {
            let (from, to) = region.corners();
            let (a, b) = (S::coordinate(from, direction), S::coordinate(to, direction));
            a.clone() + (b.clone() - a) * S::coordinate(share, direction)
        });
        if let Some(by) = displacement(&Assigned { share: share.clone(), parameter }) {
            symspline::Coeff::add_scaled(&mut points[*place], &Q::int(1), &by);
            count += 1;
        }
    }
    prop_assert_eq!(*moved, count);
    prop_assert_eq!(&new.control_points()?, &points);
    prop_assert!(same(&finer, shape)? && same(new, shape)?);
    if let Some(tolerance) = tolerance {
        let thin = warp(region.thinned(tolerance.clone()))?;
        prop_assert!(thin.bound <= tolerance && same(&thin.shape, shape)?);
        for direction in S::DIRECTIONS {
            let count = |knots: &[(Direction, Q)]| knots.iter().filter(|(d, _)| d == direction).count();
            let dim = |shape: &S| shape.space_along(*direction).dim();
            prop_assert_eq!(dim(&thin.shape) + count(&thin.removed), dim(shape) + count(&thin.inserted));
        }
    }
    Ok(())
}

/// The surface's control points in the window with their shares.
fn nodes_of_surface(
    (u, v): (&SplineSpace<Q>, &SplineSpace<Q>),
    from: &(Q, Q),
    to: &(Q, Q),
) -> Vec<(usize, (Q, Q))> {
    let (own, other) = (nodes(u, (&from.0, &to.0)), nodes(v, (&from.1, &to.1)));
    let row = |(i, s): (usize, Q)| {
        let place = move |j: usize| u.slot(i) * v.dim() + v.slot(j);
        other.iter().map(move |(j, t)| (place(*j), (s.clone(), t.clone()))).collect::<Vec<_>>()
    };
    own.into_iter().flat_map(row).collect()
}

/// By how much the knots of the region exceed the degree.
fn refinement(degree: usize, more: usize) -> Refinement<Q> {
    Refinement::Count(degree + more)
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn curves_warp_in_the_interval_only(
        c in curve::<2>(CURVE), ends in any::<Ends>(), more in 0_usize..5, w in weight(), by in point::<2>(), tolerance in tolerance(),
    ) {
        let (a, b) = interval(c.space(), ends);
        let bump = Bump::new(w)?;
        let region = Region::new(a.clone(), b.clone()).refined(refinement(c.degree(), more));
        let expected = |finer: &Curve<Q, 2>| {
            nodes(finer.space(), (&a, &b)).into_iter().map(|(i, t)| (finer.space().slot(i), t)).collect()
        };
        check(&c, region, tolerance, |at| Some(by.clone() * bump.at(&at.share)), expected, |f, g| same_outside(f, g, (&a, &b)))?;
    }

    #[test]
    fn rational_curves_warp_in_the_interval_only(
        c in nurbs::<3>(CURVE), ends in any::<Ends>(), more in 0_usize..3, by in point::<3>(), tolerance in tolerance(),
    ) {
        prop_assume!(c.weights().all(|w| *w > Q::int(0)));
        let (a, b) = interval(c.space(), ends);
        let region = Region::new(a.clone(), b.clone()).refined(refinement(c.lifted().degree(), more));
        let expected = |finer: &symspline::NurbsCurve<Q, 3>| {
            nodes(finer.space(), (&a, &b)).into_iter().map(|(i, t)| (finer.space().slot(i), t)).collect()
        };
        // Any function of the parameter, and one that leaves some points alone.
        let by = |at: &Assigned<Q>| (at.share != Q::frac(1, 2)).then(|| by.clone() * at.parameter.clone());
        check(&c, region, tolerance, by, expected, |f, g| same_outside(f.lifted(), g.lifted(), (&a, &b)))?;
    }

    #[test]
    fn surfaces_warp_in_the_rectangle_only(
        s in surface::<3>(SIDE, SIDE), sides in any::<(Ends, Ends)>(), w in weight(), by in point::<3>(), tolerance in tolerance(),
    ) {
        let ((a, b), (c, d)) = (interval(s.u(), sides.0), interval(s.v(), sides.1));
        let (from, to, bump) = ((a, c), (b, d), Bump::new(w)?);
        let region = Region::new(from.clone(), to.clone())
            .refined_along(Direction::U, refinement(s.u().degree(), 2))
            .refined_along(Direction::V, refinement(s.v().degree(), 1));
        let expected = |finer: &Surface<Q, 3>| nodes_of_surface((finer.u(), finer.v()), &from, &to);
        check(&s, region, tolerance, |at| Some(by.clone() * bump.at_pair(&at.share)), expected, |f, g| same_around(f, g, &from, &to))?;
    }

    #[test]
    fn rational_surfaces_are_punched_in_the_rectangle_only(
        s in nurbs_surface::<2>(SIDE), sides in any::<(Ends, Ends)>(), by in point::<2>(), tolerance in tolerance(),
    ) {
        prop_assume!(s.weights().all(|w| *w > Q::int(0)));
        let ((a, b), (c, d)) = (interval(s.u(), sides.0), interval(s.v(), sides.1));
        let (from, to) = ((a.clone(), c.clone()), (b.clone(), d.clone()));
        let die = Polygons::new([[(a, c.clone()), (b.clone(), d), (b, c)]])?;
        let region = Region::new(from.clone(), to.clone()).refined(refinement(2, 1));
        let expected = |finer: &symspline::NurbsSurface<Q, 2>| nodes_of_surface((finer.u(), finer.v()), &from, &to);
        let punch = |at: &Assigned<(Q, Q)>| die.contains(&at.parameter).then(|| by.clone());
        check(&s, region, tolerance, punch, expected, |f, g| same_around(f.lifted(), g.lifted(), &from, &to))?;
    }

    /// Where all control points with influence move by one vector, so does the shape.
    #[test]
    fn a_warp_by_one_translates_the_middle(c in nurbs::<2>(CURVE), ends in any::<Ends>(), by in point::<2>()) {
        let p = c.lifted().degree();
        let (a, b) = interval(c.space(), ends);
        let region = Region::new(a.clone(), b.clone()).refined(Refinement::Count(2 * p + 2));
        let warped = Warp::along(region, |_| Q::int(1), by.clone()).apply(&c)?.shape;
        let space = warped.space();
        let free = space.local_coeffs(&a, &b)?;
        prop_assert!(free.len() > p);
        let (from, to) = (&space.knots()[free.start + p], &space.knots()[free.end]);
        prop_assert!(from < to);
        for n in 0_i64..=6 {
            let x = from.clone() + (to.clone() - from) * Q::frac(n, 6);
            let x = if n == 6 { &x - &((to.clone() - from) / Q::int(1000)) } else { x };
            prop_assert_eq!(warped.at(&x)?, c.at(&x)? + &by);
        }
    }
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn bumps_are_the_rational_basis_function(w in weight(), s in share(), t in share()) {
        let knots = [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4].map(|n| Q::frac(n, 4));
        let space = SplineSpace::new(3, knots)?;
        let hat = Spline::new(space, [0, 0, 0, 1, 0, 0, 0].map(Q::int).to_vec())?;
        let rational = |n: Q| n.clone() * &w / (Q::int(1) + (w.clone() - Q::int(1)) * n);
        let bump = Bump::new(w.clone())?;
        let half = Q::frac(1, 2);
        prop_assert_eq!(bump.at(&t), rational(hat.at(&t)?) / rational(hat.at(&half)?));
        let pair = |s: &Q, t: &Q| Ok::<_, Error>(rational(hat.at(s)? * hat.at(t)?));
        prop_assert_eq!(bump.at_pair(&(s.clone(), t.clone())), pair(&s, &t)? / pair(&half, &half)?);
        let value = bump.at(&t);
        prop_assert!(value >= Q::int(0) && value <= Q::int(1));
        prop_assert_eq!(value == Q::int(1), t == half);
        prop_assert_eq!(bump.at(&(Q::int(1) - &t)), value);
        prop_assert_eq!(bump.at_pair(&(t.clone(), half)) == Q::int(0), bump.at(&t) == Q::int(0));
    }

    #[test]
    fn bumps_of_any_weight_are_finite(exponent in -300_i32..=300, t in -0.5_f64..1.5) {
        let bump = Bump::new(10_f64.powi(exponent))?;
        prop_assert!((0.0..=1.0 + 1e-15).contains(&bump.at(&t)));
        prop_assert!((0.0..=1.0 + 1e-15).contains(&bump.at_pair(&(t, 1.0 - t))));
        prop_assert_eq!(bump.at(&0.5), 1.0);
        prop_assert!((0.0..=1.0).contains(&t) || bump.at(&t) == 0.0);
    }

    /// Crossings are counted along another ray: towards a far point, by the sides on which points are.
    #[test]
    fn inside_is_what_a_ray_leaves_an_odd_number_of_times(
        polygons in vec(vec((-4_i64..=4, -4_i64..=4), 3..8), 1..4),
        (u, v) in (-9_i64..=9, -9_i64..=9),
        turn in 0_usize..8,
    ) {
        let of = |(u, v): &(i64, i64)| (Q::int(*u), Q::int(*v));
        let region = Polygons::new(polygons.iter().map(|polygon| polygon.iter().map(of)))?;
        let side = |a: (i64, i64), b: (i64, i64), c: (i64, i64)| ((b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0)).signum();
        // Everything twice as large, so that the point may have halves.
        let (point, far) = ((u, v), (u + 100_003, v + 1_000_003));
        let (mut crossings, mut on_edge) = (0, false);
        for polygon in &polygons {
            for i in 0..polygon.len() {
                let double = |(u, v): (i64, i64)| (2 * u, 2 * v);
                let (a, b) = (double(polygon[i]), double(polygon[(i + 1) % polygon.len()]));
                let between = |x: i64, p: i64, q: i64| p.min(q) <= x && x <= p.max(q);
                on_edge |= side(a, b, point) == 0 && between(u, a.0, b.0) && between(v, a.1, b.1);
                let across = side(point, far, a) * side(point, far, b) < 0 && side(a, b, point) * side(a, b, far) < 0;
                crossings += usize::from(across);
            }
        }
        let found = region.contains(&(Q::frac(u, 2), Q::frac(v, 2)));
        prop_assert_eq!(found, on_edge || crossings % 2 == 1);
        // Where a polygon begins and which way it goes does not matter; and binary fractions are exact.
        let turned = polygons.iter().map(|polygon| {
            let mut turned: Vec<(f64, f64)> = polygon.iter().rev().map(|(u, v)| (*u as f64, *v as f64)).collect();
            let by = turn % turned.len();
            turned.rotate_left(by);
            turned
        });
        prop_assert!(on_edge || Polygons::new(turned)?.contains(&(u as f64 / 2.0, v as f64 / 2.0)) == found);
    }

    #[test]
    fn the_pull_comes_from_the_nearest_place(
        lines in vec(vec((-4_i64..=4, -4_i64..=4), 1..6), 1..4),
        (u, v) in (number(), number()),
        thirds in 0_i64..30,
    ) {
        let of = |(u, v): &(i64, i64)| (Q::int(*u), Q::int(*v));
        let radius = Q::frac(thirds, 3);
        let field = Gravity::new(lines.iter().map(|line| line.iter().map(of)), radius.clone())?;
        let square = |a: &(Q, Q), b: &(Q, Q)| {
            let (x, y) = (a.0.clone() - &b.0, a.1.clone() - &b.1);
            x.clone() * &x + y.clone() * &y
        };
        let on = |line: &[(i64, i64)], leg: usize, share: Q| {
            let (a, b) = (of(&line[leg]), of(&line[(leg + 1).min(line.len() - 1)]));
            (a.0.clone() + (b.0 - &a.0) * &share, a.1.clone() + (b.1 - &a.1) * &share)
        };
        let point = (u, v);
        let limit = field.pull(&point).map_or(radius.clone() * &radius, |pull| pull.squared_distance);
        // No place of a line is nearer.
        for line in &lines {
            for leg in 0..line.len() {
                for n in 0..=8 {
                    let distance = square(&on(line, leg, Q::frac(n, 8)), &point);
                    prop_assert!(distance >= limit && (field.pull(&point).is_some() || distance > limit));
                }
            }
        }
        if let Some(pull) = field.pull(&point) {
            prop_assert!(pull.squared_distance <= *field.squared_radius());
            prop_assert_eq!(square(&pull.foot, &point), pull.squared_distance);
            let leg = (0..lines[pull.line].len().max(2) - 1).rev().find(|leg| Q::int(*leg as i64) <= pull.place).expect("not negative");
            let share = pull.place - Q::int(leg as i64);
            prop_assert!(on(&lines[pull.line], leg, share) == pull.foot);
            // The foot on a leg is where both ends are at a right or blunt angle.
            let last = lines[pull.line].len() - 1;
            for end in [leg, (leg + 1).min(last)].map(|i| of(&lines[pull.line][i])) {
                let dot = (end.0 - &pull.foot.0) * (point.0.clone() - &pull.foot.0) + (end.1 - &pull.foot.1) * (point.1.clone() - &pull.foot.1);
                prop_assert!(dot <= Q::int(0));
            }
        }
    }

    /// A polyline as a curve of degree one.
    #[test]
    fn the_field_of_a_curve_is_that_of_its_polyline(line in vec((-4_i32..=4, -4_i32..=4), 2..6), u in -5.0_f64..5.0, v in -5.0_f64..5.0) {
        let line: Vec<(f64, f64)> = line.iter().map(|(u, v)| (f64::from(*u), f64::from(*v))).collect();
        let points: Vec<_> = line.iter().map(|(u, v)| vector![*u, *v]).collect();
        let curve = Curve::new(SplineSpace::clamped(1, (0..line.len()).map(|i| i as f64))?, points)?;
        let (by_lines, by_curve) = (Gravity::new([line], 2.0)?, CurveGravity::new(&[curve], 2.0)?);
        match (by_lines.pull(&(u, v)), by_curve.pull(&(u, v))?) {
            (Some(one), Some(other)) => {
                prop_assert!((one.squared_distance.sqrt() - other.squared_distance.sqrt()).abs() < 1e-9);
            }
            (one, other) => {
                let distance = one.or(other).map_or(2.0, |pull| pull.squared_distance.sqrt());
                prop_assert!((distance - 2.0).abs() < 1e-9);
            }
        }
    }

    /// Lengths do not depend on where a polygon is and how it is turned.
    #[test]
    fn chords_of_a_moved_curve_are_the_same(points in vec((-9_i32..=9, -9_i32..=9), 6..20), (i, j) in any::<Ends>(), by in -3.0_f64..3.0) {
        let points: Vec<SVector<f64, 2>> = points.iter().map(|(x, y)| vector![f64::from(*x), f64::from(*y)]).collect();
        let space = SplineSpace::uniform(3, points.len() - 3, 0.0, 1.0)?;
        let moved = |p: &SVector<f64, 2>| vector![-p[1] + 2.0, p[0] - 1.0];
        let turned = Curve::new(space.clone(), points.iter().map(moved).collect())?;
        let curve = Curve::new(space, points)?;
        let breaks = curve.space().breaks();
        let (i, j) = (i.index(breaks.len() - 1), j.index(breaks.len() - 1));
        let region = Region::new(breaks[i.min(j)].0, breaks[i.max(j) + 1].0).refined(Refinement::Count(9));
        let bump = Bump::new(2.0)?;
        let warp = |w: SVector<f64, 2>| Warp::along(region.clone(), |at| bump.at(&at.share), w);
        let one = warp(vector![0.0, by]).apply_by_chords(&curve);
        let Ok(one) = one else { return Ok(()) };
        let other = warp(vector![-by, 0.0]).apply_by_chords(&turned)?;
        for (p, q) in one.shape.coeffs().iter().zip(other.shape.coeffs()) {
            prop_assert!((moved(p) - q).norm() < 1e-9);
        }
    }
}

/// Points of equal distances have chords as they have nodes, but for those at clamped ends.
#[test]
fn chords_by_hand() -> symspline::Result<()> {
    let points: Vec<_> = [0.0, 1.0, 3.0, 4.0, 7.0, 8.0].map(|x| vector![x, 0.0]).to_vec();
    let curve = Curve::new(SplineSpace::clamped(1, (0..6).map(f64::from))?, points)?;
    let shares = |a: f64, b: f64| {
        let lift = |at: &Assigned<f64>| Ok(Some(vector![0.0, at.share]));
        let warped = Warp::new(Region::new(a, b), lift).apply_by_chords(&curve)?.shape;
        Ok::<Vec<f64>, Error>(warped.coeffs().iter().map(|p| p[1]).collect())
    };
    // From the second point, before the first that moves, to the fifth.
    assert_eq!(shares(1.0, 4.0)?, [0.0, 0.0, 2.0 / 6.0, 3.0 / 6.0, 0.0, 0.0]);
    // At the start there is none before.
    assert_eq!(shares(0.0, 3.0)?, [0.0, 0.25, 0.75, 0.0, 0.0, 0.0]);
    assert_eq!(shares(0.0, 5.0)?, [0.0, 1.0 / 8.0, 3.0 / 8.0, 4.0 / 8.0, 7.0 / 8.0, 1.0]);
    Ok(())
}

/// Chords of a net are means over its lines, and lines of no length do not count.
#[test]
fn chords_of_a_net() -> symspline::Result<()> {
    let line = SplineSpace::clamped(1, (0..4).map(f64::from))?;
    // Along u the points are at 0, 1, 2, 4 on the outer lines and at 0, 1, 3, 4 on the inner ones; the first line has no length.
    let across = [[0.0; 4], [0.0, 1.0, 3.0, 4.0], [0.0, 1.0, 3.0, 4.0], [0.0, 1.0, 2.0, 4.0]];
    let points = (0..16).map(|k| vector![across[k % 4][k / 4], (k % 4) as f64, 0.0]);
    let net = Surface::new(line.clone(), line, points.map(|p: SVector<f64, 3>| p).collect())?;
    let lift = |at: &Assigned<(f64, f64)>| Ok(Some(vector![0.0, 0.0, at.share.0]));
    let warped = Warp::new(Region::new((0.0, 0.0), (3.0, 3.0)), lift).apply_by_chords(&net)?.shape;
    let heights: Vec<f64> = warped.coeffs().iter().step_by(4).map(|p| p[2]).collect();
    let third = (0.75 + 0.75 + 0.5) / 3.0;
    assert!(heights.iter().zip([0.0, 0.25, third, 1.0]).all(|(x, y)| (x - y).abs() < 1e-15), "{heights:?}");
    Ok(())
}

/// In a ring there is always a neighbour.
#[test]
fn chords_around_a_seam() -> symspline::Result<()> {
    let space = SplineSpace::uniform_periodic(1, 4, 0.0, 4.0)?;
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 3.0], [0.0, 3.0]].map(|[x, y]| vector![x, y]);
    let ring = Curve::new(space, square.to_vec())?;
    let shares = |a: f64, b: f64| {
        let seen = std::cell::RefCell::new(Vec::new());
        let look = |at: &Assigned<f64>| {
            seen.borrow_mut().push(at.share);
            Ok(None)
        };
        Warp::new(Region::new(a, b), look).apply_by_chords(&ring)?;
        Ok::<_, Error>(seen.into_inner())
    };
    let sum = |shares: Vec<f64>| shares.iter().sum::<f64>();
    let all = [shares(0.0, 2.0)?, shares(1.0, 3.0)?, shares(2.0, 4.0)?];
    assert!(all.iter().all(|shares| shares.len() == 1), "{all:?}");
    // Legs of lengths 1, 3, 1, 3 alternate.
    assert!(all.into_iter().map(sum).all(|share| [0.25, 0.75].contains(&share)));
    Ok(())
}

/// Directions that bend with the shape; where there is none the error says so.
#[test]
fn normals_for_directions() -> symspline::Result<()> {
    let line = Curve::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![vector![0.0, 0.0], vector![4.0, 0.0]])?;
    let region = Region::new(0.25, 0.75).refined(Refinement::Count(5));
    let bump = Bump::new(1.0)?;
    let along = |at: &Assigned<f64>| Ok(Some(line.unit_normal(&at.parameter)? * bump.at(&at.share)));
    let warped = Warp::new(region.clone(), along).apply(&line)?.shape;
    let constant =
        Warp::along(region.clone(), |at| bump.at(&at.share), vector![0.0, 1.0]).apply(&line)?.shape;
    assert_eq!(warped, constant);

    let straight = Curve::new(
        SplineSpace::bezier(2, 0.0, 1.0)?,
        (0..3).map(|x| vector![f64::from(x), 0.0, 0.0]).collect(),
    )?;
    let along = |at: &Assigned<f64>| Ok(Some(straight.unit_normal(&at.parameter)?));
    assert!(matches!(Warp::new(region, along).apply(&straight), Err(Error::Straight { .. })));
    Ok(())
}

/// What cannot be done is refused, and numbers of all sizes are fine or refused.
#[test]
fn refusals() -> symspline::Result<()> {
    let line =
        Curve::new(SplineSpace::bezier(3, 0.0, 1.0)?, (0..4).map(|x| vector![f64::from(x), 0.0]).collect())?;
    let warp = |a: f64, b: f64, knots: usize, by: f64| {
        Warp::along(Region::new(a, b).refined(Refinement::Count(knots)), |_| 1.0, vector![0.0, by])
            .apply(&line)
    };
    assert!(matches!(warp(0.2, 0.8, 1, 1.0), Err(Error::Shape(ShapeError::NoFreePoints))));
    assert!(matches!(warp(0.8, 0.2, 9, 1.0), Err(Error::EmptyDomain { .. })));
    assert!(matches!(warp(0.5, 1.5, 9, 1.0), Err(Error::OutsideDomain { .. })));
    assert!(warp(f64::NAN, 0.8, 9, 1.0).is_err());
    assert!(matches!(warp(0.2, 0.8, usize::MAX, 1.0), Err(Error::TooLarge { .. })));
    assert!(matches!(warp(0.2, 0.8, 9, f64::NAN), Err(Error::NotFinite { .. })));
    assert!(warp(0.2, 0.8, 9, 1e300).is_ok() && warp(0.2, 0.8, 9, 1e-300).is_ok());
    let region = Region::new(0.2, 0.8).refined(Refinement::Count(9)).thinned(-1.0);
    let thin = Warp::along(region, |_| 1.0, vector![0.0, 1.0]).apply(&line);
    assert!(matches!(thin, Err(Error::BadTolerance { .. })));
    let few = Warp::along(Region::new(0.0, 1.0), |_| 1.0, vector![0.0, 1.0])
        .apply_with(&line, |_, _| Ok(vec![vec![0.5]]));
    assert!(matches!(few, Err(Error::Shape(ShapeError::Shares))));
    let heap = Curve::new(SplineSpace::bezier(3, 0.0, 1.0)?, vec![vector![1.0, 1.0]; 4])?;
    let by_chords = Warp::along(Region::new(0.0, 1.0), |_| 1.0, vector![0.0, 1.0]).apply_by_chords(&heap);
    assert!(matches!(by_chords, Err(Error::NoLength)));
    for spacing in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-300] {
        assert!(Refinement::Spacing(spacing).knots(line.space(), &0.2, &0.8).is_err());
    }

    for weight in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(Bump::new(weight), Err(Error::Weight { .. })));
    }
    assert!(matches!(Polygons::new([[(0.0, 0.0), (1.0, 0.0)]]), Err(Error::TooFewPoints { .. })));
    assert!(matches!(
        Polygons::new([[(0.0, f64::NAN), (1.0, 0.0), (0.0, 1.0)]]),
        Err(Error::NotFinite { .. })
    ));
    let large = Polygons::new([[(-1e300, -1e300), (1e300, -1e300), (0.0, 1e300)]])?;
    assert!(large.contains(&(0.0, 0.0)) && !large.contains(&(-1e300, 0.0)));
    let small = Polygons::new([[(-1e-300, -1e-300), (1e-300, -1e-300), (0.0, 1e-300)]])?;
    assert!(small.contains(&(0.0, 0.0)) && !small.contains(&(-1e-300, 0.0)));
    assert!(matches!(Gravity::new([vec![]], 1.0), Err(Error::TooFewPoints { .. })));
    assert!(matches!(Gravity::new([[(0.0, 0.0)]], -1.0), Err(Error::BadTolerance { .. })));
    assert!(matches!(Gravity::new([[(0.0, 0.0)]], 1e300), Err(Error::BadTolerance { .. })));
    let long = Gravity::new([[(-1e300, 0.0), (1e300, 0.0)]], 1.0)?;
    assert!(matches!(Gravity::new([[(-1e308, 0.0), (1e308, 0.0)]], 1.0), Err(Error::NotFinite { .. })));
    let twice = Gravity::new([[(0.0, 0.0), (1.0, 0.0)], [(1.0, 0.0), (0.0, 0.0)]], 1.0)?;
    assert!(twice.pull(&(0.25, 0.5)).is_some_and(|pull| (pull.line, pull.place) == (0, 0.25)));
    assert!(matches!(Gravity::new([[(0.0, 0.0)]], 1e-200), Err(Error::BadTolerance { .. })));
    assert!(long.pull(&(3.0, 0.5)).is_some_and(|pull| pull.squared_distance == 0.25));
    assert!(matches!(CurveGravity::new(&[line], f64::NAN), Err(Error::BadTolerance { .. })));
    Ok(())
}

proptest! {
    #![proptest_config(cases(24))]

    /// A gravity field pulls the control points near a polyline, and no others.
    #[test]
    fn polylines_pull_what_is_near(s in surface::<3>(SIDE, SIDE), sides in any::<(Ends, Ends)>(), by in point::<3>(), fifths in 0_i64..5) {
        let ((a, b), (c, d)) = (interval(s.u(), sides.0), interval(s.v(), sides.1));
        let (from, to) = ((a.clone(), c), (b.clone(), d));
        let radius = (b - a) * Q::frac(fifths, 5);
        let field = Gravity::new([[from.clone(), to.clone()]], radius.clone())?;
        let region = Region::new(from.clone(), to.clone()).refined(refinement(2, 2));
        let pulled = |at: &Assigned<(Q, Q)>| field.pull(&at.parameter).map(|pull| {
            let share = if radius == Q::int(0) { Q::int(1) } else { Q::int(1) - pull.squared_distance / field.squared_radius() };
            by.clone() * share
        });
        let expected = |finer: &Surface<Q, 3>| nodes_of_surface((finer.u(), finer.v()), &from, &to);
        check(&s, region, Some(Q::frac(1, 2)), pulled, expected, |f, g| same_around(f, g, &from, &to))?;
    }

    #[test]
    fn windows_are_free(s in space(ANY.of_degree(0, 3)), ends in any::<Ends>()) {
        let (a, b) = interval(&s, ends);
        let flat = Spline::constant(s, Q::int(1))?;
        let region = Region::new(a, b).refined(Refinement::Count(4));
        let finer = region.refine(&flat)?;
        let window = region.window(&finer)?;
        prop_assert_eq!(window.len(), window.flat(&finer).count());
        let mut places: Vec<usize> = window.flat(&finer).collect();
        places.sort_unstable();
        places.dedup();
        prop_assert_eq!(window.len(), places.len());
    }
}
