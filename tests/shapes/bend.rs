//! Laws of bends: the cross ratio is met, and the ends are carried along as rigid bodies.

use crate::rational_strategies::{nurbs, nurbs_surface};
use crate::strategies::{ANY, Kind, OPEN, cases, curve, number, point, probes, surface};
use nalgebra::{SVector, vector};
use proptest::prelude::*;
use proptest::sample::{Index, select};
use symspline::shape::bend_ratio::bent_share;
use symspline::{
    Axis, Bend, BendCentre, Bendable, ByShare, Controlled, Curve, Direction, Error, Flat, Function, Q,
    Refinement, Rotation, Round, Scalar, ShapeError, Sphere, SplineSpace, Surface, bent_point,
};

const KIND: Kind = ANY.of_degree(1, 3);
const SMALL: Kind = OPEN.of_degree(1, 2).few(3);

type Point<const N: usize> = SVector<Q, N>;

fn dot<const N: usize>(a: &Point<N>, b: &Point<N>) -> Q {
    Q::dot(a.iter().zip(b.iter()))
}

fn minus<const N: usize>(a: &Point<N>, b: &Point<N>) -> Point<N> {
    SVector::from_fn(|i, _| a[i].clone() - &b[i])
}

/// A share that depends on the point alone, between 1/3 and 3.
fn wild<const N: usize>(point: &Point<N>) -> Q {
    let sum = point.iter().fold(Q::int(1), |sum, x| sum + x * x);
    (sum.clone() + Q::int(8)) / (sum * Q::int(3))
}

/// A shape, knots of it with local control points in between, and which those are.
fn picked<S: Controlled<Q>>(shape: &S, [i, j]: &[Index; 2]) -> Option<(S, (Q, Q), Vec<usize>)> {
    let probes = probes(shape.space_along(Direction::U));
    let (a, b) = (i.get(&probes).clone(), j.get(&probes).clone());
    let (a, b) = if a < b { (a, b) } else { (b, a) };
    let fine = Refinement::Count(3).of(shape, Direction::U, &a, &b).ok()?;
    let local: Vec<usize> = fine.space_along(Direction::U).local_coeffs(&a, &b).ok()?.collect();
    (!local.is_empty()).then_some((fine, (a, b), local))
}

/// Moves the control points of one row to given places.
fn placed<S: Controlled<Q, Point = Point<N>>, const N: usize>(
    shape: &S,
    places: impl IntoIterator<Item = (usize, Point<N>)>,
) -> Result<S, TestCaseError> {
    let mut shape = shape.clone();
    for (i, place) in places {
        let by = minus(&place, &shape.control_point(i)?);
        shape.move_points(&[(i, by)])?;
    }
    Ok(shape)
}

/// Bends a curve whose first and last mapped legs go from one axis of a right angle to the other, so that all lengths are rational.
fn check_tails<S, const N: usize>(
    curve: &S,
    pick: &[Index; 2],
    axes: &[Point<N>; 2],
    [old, new]: [[i64; 2]; 2],
    centre: &Point<N>,
) -> Result<(), TestCaseError>
where
    S: Controlled<Q, Point = Point<N>, Parameter = Q, Order = usize>,
{
    let Some((fine, (start, end), local)) = picked(curve, pick) else { return Ok(()) };
    let space = fine.space_along(Direction::U).clone();
    if space.is_periodic() {
        if local.len() == space.dim() {
            return Ok(());
        }
        let bend = Bend::new(centre.clone(), Round(Q::int(1)), Q::int(1)).on(start, end);
        prop_assert_eq!(bend.apply(&fine).err(), Some(ShapeError::NoEnds.into()));
        return Ok(());
    }
    let on_axis =
        |k: usize, x: i64| SVector::from_fn(|c, _| centre[c].clone() + axes[k][c].clone() * Q::int(x));
    let (s, t) = (local[0], local[local.len() - 1]);
    let ends: Vec<usize> = [s, s + 1, t.max(1) - 1, t].into_iter().filter(|i| local.contains(i)).collect();
    let fine = placed(&fine, ends.iter().map(|i| (*i, on_axis((i - s) % 2, old[(i - s) % 2]))))?;
    let shares = [0, 1].map(|k| Q::frac(new[k], old[k]));
    let about = ByShare(|o: &Point<N>, p: &Point<N>| {
        let k = (0..2).find(|k| *p == on_axis(*k, old[*k]));
        Ok((o != p).then(|| k.map_or_else(|| wild(p), |k| shares[k].clone())))
    });
    let bend = Bend::new(centre.clone(), about, Q::int(1)).on(start.clone(), end.clone());
    let bent = match bend.apply(&fine) {
        Err(Error::Shape(ShapeError::AtCentre { .. })) => return Ok(()),
        bent => bent?,
    };
    let (before, after) = (fine.control_points()?, bent.control_points()?);
    for i in &local {
        let t = match (0..2).find(|k| before[*i] == on_axis(*k, old[*k])) {
            Some(k) => shares[k].clone(),
            None => wild(&before[*i]),
        };
        prop_assert_eq!(minus(&after[*i], centre), minus(&before[*i], centre).map(|x| x * &t));
    }
    let still = bend.clone().without_tails().apply(&fine)?.control_points()?;
    for i in 0..before.len() {
        prop_assert_eq!(&still[i], if local.contains(&i) { &after[i] } else { &before[i] });
    }
    let (a, b) = (space.domain().0.clone(), space.domain().1.clone());
    let inside = probes(&space);
    let sides = [
        (s, (s + 1).min(t), (0..s).collect::<Vec<_>>(), (a, start)),
        (t, t.saturating_sub(1).max(s), (t + 1..space.dim()).collect(), (end, b)),
    ];
    for (pivot, next, tail, (from, to)) in sides {
        let legs = [&before, &after].map(|points| minus(&points[next], &points[pivot]));
        // Every vector from the pivot keeps its products with every other, in the plane with its sign.
        let mut rigid: Vec<[Point<N>; 2]> =
            tail.iter().map(|i| [&before, &after].map(|points| minus(&points[*i], &points[pivot]))).collect();
        // The curve on that side, in its inside: at the end there may be a jump.
        if !tail.is_empty() {
            for ends in inside.windows(2).filter(|ends| from <= ends[0] && ends[1] <= to) {
                let x = (ends[0].clone() + &ends[1]) * Q::frac(1, 2);
                let places = [(&fine, &before), (&bent, &after)];
                let [p, q] =
                    places.map(|(c, points)| c.derivative_of(&x, 0).map(|p| minus(&p, &points[pivot])));
                rigid.push([p?, q?]);
            }
        }
        for [v, w] in &rigid {
            for [x, y] in &rigid {
                prop_assert_eq!(dot(v, x), dot(w, y));
                if N == 2 {
                    let cross = |a: &Point<N>, b: &Point<N>| a[0].clone() * &b[1] - a[1].clone() * &b[0];
                    prop_assert_eq!(cross(v, x), cross(w, y));
                }
            }
        }
        // A leg keeps its angles: (v·leg)/|leg| does not change.
        if pivot != next {
            let [len, bent_len] = legs.each_ref().map(|leg| dot(leg, leg));
            for [v, w] in &rigid {
                let (x, y) = (dot(v, &legs[0]), dot(w, &legs[1]));
                prop_assert_eq!(x.clone() * &x * &bent_len, y.clone() * &y * &len);
                prop_assert!(x * y >= Q::int(0));
            }
        } else {
            for [v, w] in &rigid {
                prop_assert_eq!(v, w);
            }
        }
    }
    Ok(())
}

/// Legs of right triangles with whole sides.
fn triangle() -> impl Strategy<Value = [i64; 2]> {
    select(vec![[3, 4], [4, 3], [5, 12], [12, 5], [8, 15], [20, 21], [28, 45]])
}

/// Two vectors of length 1 at a right angle.
fn plane_axes() -> impl Strategy<Value = [Point<2>; 2]> {
    select(vec![[1, 0, 1], [3, 4, 5], [-5, 12, 13]])
        .prop_map(|[x, y, r]| [vector![Q::frac(x, r), Q::frac(y, r)], vector![Q::frac(-y, r), Q::frac(x, r)]])
}

fn space_axes() -> impl Strategy<Value = [Point<3>; 2]> {
    let frame = |x: [i64; 3], y: [i64; 3], r: i64| [x, y].map(|v| SVector::from(v.map(|c| Q::frac(c, r))));
    select(vec![
        frame([1, 2, 2], [2, 1, -2], 3),
        frame([2, 3, 6], [3, -6, 2], 7),
        frame([0, 1, 0], [0, 0, -1], 1),
    ])
}

/// What a bend of a surface along `u` does to each row is what it does to the row as a curve; along `v` it is the same on the
/// transposed surface.
fn check_rows<O, B>(s: &Surface<Q, 3>, on: (Q, Q), bend: &Bend<Q, O, B>) -> Result<(), TestCaseError>
where
    O: BendCentre<Q, 3> + Clone,
    B: Bendable<Q, 3> + Clone,
{
    let bend = bend.clone().on(on.0, on.1);
    let (along_u, along_v) = (bend.apply(s), bend.clone().along(Direction::V).apply(&s.transposed()));
    let along_u = match (along_u, along_v) {
        (Ok(u), Ok(v)) => {
            prop_assert_eq!(&u.transposed(), &v);
            u
        }
        (u, v) => {
            prop_assert!(u.is_err() && v.is_err());
            return Ok(());
        }
    };
    let columns = s.v().dim();
    for j in 0..columns {
        let row = |s: &Surface<Q, 3>| {
            Curve::new(s.u().clone(), s.coeffs().iter().skip(j).step_by(columns).cloned().collect())
        };
        prop_assert_eq!(bend.apply(&row(s)?)?, row(&along_u)?);
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn the_cross_ratio_is_met_or_the_pole_is_told(s in number(), lambda in number(), p in point::<3>(), o in point::<3>()) {
        let one = Q::int(1);
        // The conditions one by one.
        let fine = s >= Q::int(0)
            && if lambda < Q::int(0) {
                s > one.clone() / (one.clone() - &lambda) || s == Q::int(0)
            } else if s > one && lambda > Q::int(0) {
                lambda > one.clone() - one.clone() / &s
            } else {
                lambda > Q::int(0) || s != one
            };
        match bent_share(&s, &lambda) {
            Some(t) => {
                prop_assert!(fine && t >= Q::int(0));
                prop_assert_eq!(lambda.clone() * &s * (one.clone() - &t), t.clone() * (one.clone() - &s));
                prop_assert_eq!(bent_point(&o, &p, &s, &lambda).map(|q| minus(&q, &o)), Some(minus(&p, &o).map(|x| x * &t)));
                if lambda == one {
                    prop_assert_eq!(t, s);
                }
            }
            None => prop_assert!(!fine && bent_point(&o, &p, &s, &lambda).is_none()),
        }
    }

    #[test]
    fn tails_of_plane_curves_are_rigid(
        c in curve::<2>(KIND), pick in any::<[Index; 2]>(), axes in plane_axes(), legs in [triangle(), triangle()], o in point::<2>(),
    ) {
        check_tails(&c, &pick, &axes, legs, &o)?;
    }

    #[test]
    fn tails_of_space_curves_are_rigid(
        c in curve::<3>(KIND), pick in any::<[Index; 2]>(), axes in space_axes(), legs in [triangle(), triangle()], o in point::<3>(),
    ) {
        check_tails(&c, &pick, &axes, legs, &o)?;
    }

    #[test]
    fn tails_of_rational_curves_are_rigid(
        c in nurbs::<2>(KIND.of_degree(1, 2)), pick in any::<[Index; 2]>(), axes in plane_axes(), legs in [triangle(), triangle()],
        o in point::<2>(),
    ) {
        if c.control_points().is_ok() {
            check_tails(&c, &pick, &axes, legs, &o)?;
        }
    }

    #[test]
    fn ratio_one_puts_control_points_on_the_bend_line(
        c in curve::<2>(KIND), pick in any::<[Index; 2]>(), o in point::<2>(), q in point::<2>(), n in point::<2>(),
        lambda in (1_i64..9, 1_i64..9),
    ) {
        let Some((fine, (start, end), local)) = picked(&c, &pick) else { return Ok(()) };
        let flat = Flat { origin: q.clone(), normal: n.clone() };
        let bend = |ratio: Q| Bend::new(o.clone(), flat.clone(), ratio).on(start.clone(), end.clone()).without_tails();
        let height = |p: &Point<2>| dot(&minus(p, &q), &n);
        let reached = |p: &Point<2>| {
            let (rate, off) = (dot(&minus(p, &o), &n), -height(&o));
            *p != o && rate != Q::int(0) && off / rate > Q::int(0)
        };
        match bend(Q::int(1)).apply(&fine) {
            Ok(on) => {
                for i in &local {
                    let i = fine.space().slot(*i);
                    prop_assert_eq!(height(&on.coeffs()[i]), Q::int(0));
                    prop_assert!(reached(&fine.coeffs()[i]));
                }
                // Any other ratio is the cross ratio of O, R, P', P.
                let lambda = Q::frac(lambda.0, lambda.1);
                let Ok(bent) = bend(lambda.clone()).apply(&fine) else { return Ok(()) };
                for i in &local {
                    let i = fine.space().slot(*i);
                    let [r, p, image] = [&on, &fine, &bent].map(|c| minus(&c.coeffs()[i], &o));
                    let (s, t) = (dot(&r, &p) / dot(&p, &p), dot(&image, &p) / dot(&p, &p));
                    prop_assert_eq!(&image, &p.map(|x| x * &t));
                    prop_assert_eq!(lambda.clone() * &s * (Q::int(1) - &t), t * (Q::int(1) - s));
                }
            }
            Err(Error::Shape(ShapeError::NoBendPoint { index } | ShapeError::AtCentre { index })) => {
                prop_assert!(!reached(&fine.coeffs()[index]));
                prop_assert!(local.iter().any(|i| fine.space().slot(*i) == index));
            }
            Err(error) => prop_assert!(false, "{error}"),
        }
    }

    #[test]
    fn ratios_are_taken_at_the_nodes(
        c in curve::<2>(KIND), o in point::<2>(), [a, b] in [1_i64..9, 1_i64..9],
    ) {
        let (start, end) = c.domain();
        let ratio = Function::new(SplineSpace::bezier(1, start.clone(), end.clone())?, vec![Q::int(a), Q::int(b)])?;
        let about = ByShare(|_: &Point<2>, p: &Point<2>| Ok(Some(wild(p))));
        let bent = Bend::new(o.clone(), about, ratio.clone()).apply(&c);
        let round = end.clone() - start;
        let lambda = |i: usize| {
            let mut node = c.space().node(i)?;
            // At the same place of the ring, or at the end of an unclamped space.
            while c.space().is_periodic() && node < *start {
                node += &round;
            }
            ratio.at(&node.clamp(start.clone(), end.clone()))
        };
        let first = c.coeffs().iter().position(|p| *p == o);
        match bent {
            Ok(bent) => for (i, p) in c.coeffs().iter().enumerate() {
                prop_assert_eq!(Some(bent.coeffs()[i].clone()), bent_point(&o, p, &wild(p), &lambda(i)?));
            },
            Err(error) => prop_assert_eq!(error, ShapeError::AtCentre { index: first.unwrap_or(usize::MAX) }.into()),
        }
    }

    #[test]
    fn surfaces_are_bent_row_by_row(
        s in surface::<3>(SMALL, SMALL), pick in any::<[Index; 2]>(), o in point::<3>(), v in point::<3>(), lambda in number(),
    ) {
        let probes = probes(s.u());
        let ends = pick.map(|i| i.get(&probes).clone());
        let about = ByShare(|_: &Point<3>, p: &Point<3>| Ok(Some(wild(p))));
        let on = (ends.iter().min().expect("two").clone(), ends.iter().max().expect("two").clone());
        let bend = Bend::new(o.clone(), about, lambda.clone()).refined(Refinement::Count(2)).without_tails();
        check_rows(&s, on.clone(), &bend)?;
        if let Ok(axis) = Axis::new(o, v) {
            let bend = Bend::new(axis, about, lambda).refined(Refinement::Count(2));
            check_rows(&s, on.clone(), &bend.clone().without_tails())?;
            check_rows(&s, on, &bend)?;
        }
    }

    #[test]
    fn rational_surfaces_keep_their_weights(s in nurbs_surface::<3>(SMALL.of_degree(1, 2)), o in point::<3>(), lambda in 1_i64..9) {
        let about = ByShare(|_: &Point<3>, p: &Point<3>| Ok(Some(wild(p))));
        let lambda = Q::int(lambda);
        let Ok(bent) = Bend::new(o.clone(), about, lambda.clone()).along(Direction::V).apply(&s) else { return Ok(()) };
        prop_assert!(s.weights().eq(bent.weights()));
        for (p, image) in s.points()?.iter().zip(bent.points()?) {
            prop_assert_eq!(Some(image), bent_point(&o, p, &wild(p), &lambda));
        }
    }

    #[test]
    fn axes_have_right_angles(p in point::<3>(), o in point::<3>(), v in point::<3>()) {
        match Axis::new(o.clone(), v.clone()) {
            Ok(axis) => {
                let foot = axis.centre_of(&p)?;
                prop_assert_eq!(dot(&minus(&p, &foot), &v), Q::int(0));
                let off = minus(&foot, &o);
                let w = dot(&off, &v) / dot(&v, &v);
                prop_assert_eq!(off, v.map(|x| x * &w));
            }
            Err(error) => prop_assert_eq!(error, ShapeError::NoDirection { what: "axis" }.into()),
        }
    }

    #[test]
    fn rotations_are_the_least(v in point::<3>(), w in point::<3>(), x in point::<3>(), k in 1_i64..9) {
        // Any reflection of `v` has its length; times k.
        let lengths = dot(&w, &w);
        let to = if lengths == Q::int(0) { v.clone() } else {
            let share = Q::int(2) * dot(&v, &w) / lengths;
            minus(&v, &w.map(|c| c * &share))
        };
        let turn = Rotation::between(&v, &to.map(|c| c * Q::int(k)))?;
        prop_assert_eq!(&turn.of(&v), &to);
        prop_assert_eq!(dot(&turn.of(&x), &turn.of(&v)), dot(&x, &v));
        prop_assert_eq!(dot(&turn.of(&x), &turn.of(&x)), dot(&x, &x));
        let cross = |a: &Point<3>, b: &Point<3>| {
            let minor = |i: usize, j: usize| a[i].clone() * &b[j] - a[j].clone() * &b[i];
            vector![minor(1, 2), minor(2, 0), minor(0, 1)]
        };
        // No reflection, and what is across both stays.
        prop_assert_eq!(turn.of(&cross(&v, &x)), cross(&turn.of(&v), &turn.of(&x)));
        let axis = cross(&v, &to);
        prop_assert_eq!(turn.of(&axis), axis);
    }

    #[test]
    fn spheres_are_met(o in point::<3>(), p in point::<3>(), m in point::<3>(), along in number()) {
        // Through a point of the ray, so that the root is in the field.
        let way = minus(&p, &o);
        let on = SVector::from_fn(|i, _| o[i].clone() + along.clone() * &way[i]);
        let off = minus(&on, &m);
        let square = dot(&off, &off);
        let radius = square.root_above();
        if o == p || radius.clone() * &radius != square {
            return Ok(());
        }
        let share = Sphere { centre: m.clone(), radius: radius.clone() }.share(&o, &p)?;
        if let Some(s) = &share {
            let found = SVector::from_fn(|i, _| o[i].clone() + s.clone() * &way[i]);
            prop_assert_eq!(dot(&minus(&found, &m), &minus(&found, &m)), radius.clone() * &radius);
            prop_assert!(*s > Q::int(0));
        }
        if along > Q::int(0) {
            let off = |s: &Q| (s.clone() - Q::int(1)).abs();
            prop_assert!(share.is_some_and(|s| off(&s) <= off(&along)));
        }
    }
}
