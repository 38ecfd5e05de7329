//! Laws of flattening: what is flat, what changed, and what the rules let through.

use crate::rational_strategies::{nurbs, nurbs_surface};
use crate::strategies::{ANY, Kind, cases, curve, number, point, probes, surface};
use nalgebra::{SVector, vector};
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{
    Controlled, Direction, Error, Flatten, Flattened, Onto, Part, Q, Refinement, Scalar, ShapeError, Side,
    SplineSpace, Surface,
};

const KIND: Kind = ANY.of_degree(0, 3);
const SMALL: Kind = ANY.of_degree(0, 2).few(3);

type Point<const N: usize> = SVector<Q, N>;

fn dot<const N: usize>(a: &Point<N>, b: &Point<N>) -> Q {
    Q::dot(a.iter().zip(b.iter()))
}

fn minus<const N: usize>(a: &Point<N>, b: &Point<N>) -> Point<N> {
    SVector::from_fn(|i, _| a[i].clone() - &b[i])
}

/// Two parameters in order, among the places where things happen.
fn interval(space: &SplineSpace<Q>, [i, j]: &[Index; 2]) -> Option<(Q, Q)> {
    let probes = probes(space);
    let (a, b) = (i.get(&probes).clone(), j.get(&probes).clone());
    match a.cmp(&b) {
        std::cmp::Ordering::Less => Some((a, b)),
        std::cmp::Ordering::Equal => None,
        std::cmp::Ordering::Greater => Some((b, a)),
    }
}

/// A line in the plane, or a plane in space, with a projection onto it.
fn onto<const N: usize>() -> impl Strategy<Value = [Point<N>; 3]> {
    [point::<N>(), point(), point()]
        .prop_filter("not parallel", |[_, normal, along]| dot(normal, along) != Q::int(0))
}

fn line([origin, normal, along]: &[Point<2>; 3]) -> Onto<Q, 2> {
    Onto::line_along(origin.clone(), vector![normal[1].clone(), -normal[0].clone()], along.clone())
        .expect("not parallel")
}

fn plane([origin, normal, along]: &[Point<3>; 3]) -> Onto<Q, 3> {
    Onto::plane_along(origin.clone(), normal.clone(), along.clone()).expect("not parallel")
}

/// Each control point is where it was, or where the projection took it.
fn check_points<S: Controlled<Q, Point = Point<N>>, const N: usize>(
    before: &S,
    flat: &Flattened<Q, S>,
    [origin, normal, along]: &[Point<N>; 3],
) -> Result<(), TestCaseError> {
    let (old, new) = (before.control_points()?, flat.shape.control_points()?);
    for (i, (old, new)) in old.iter().zip(&new).enumerate() {
        if flat.projected.contains(&i) {
            let by = minus(new, old);
            prop_assert_eq!(dot(&minus(new, origin), normal), Q::int(0));
            let alpha = dot(&by, along) / dot(along, along);
            prop_assert_eq!(by, along.map(|x| x * &alpha));
        } else {
            prop_assert_eq!(old, new);
        }
    }
    Ok(())
}

/// As many places inside each span as make a height that vanishes at all of them vanish on the span.
fn places(space: &SplineSpace<Q>) -> Vec<Vec<Q>> {
    let count = space.degree() as i64 + 1;
    let inside = |ends: &[(Q, usize)]| {
        let (a, b) = (ends[0].0.clone(), ends[1].0.clone());
        (1..=count).map(|k| a.clone() + (b.clone() - &a) * Q::frac(k, count + 1)).collect()
    };
    space.breaks().windows(2).map(inside).collect()
}

/// The flat intervals are flat, and nothing else is.
fn check_intervals<S: Controlled<Q, Point = Point<N>, Parameter = Q, Order = usize>, const N: usize>(
    flat: &Flattened<Q, S>,
    [origin, normal, _]: &[Point<N>; 3],
) -> Result<(), TestCaseError> {
    for span in places(flat.shape.space_along(Direction::U)) {
        let told = flat.flat.iter().any(|part| part[0].0 < span[0] && span[0] < part[0].1);
        let mut is_flat = true;
        for x in &span {
            is_flat &= dot(&minus(&flat.shape.derivative_of(x, 0)?, origin), normal) == Q::int(0);
        }
        prop_assert_eq!(told, is_flat);
    }
    prop_assert!(flat.flat.windows(2).all(|parts| parts[0][0].1 < parts[1][0].0));
    Ok(())
}

/// What is outside of what is said to have changed is the same.
fn check_changed<S: Controlled<Q, Point = Point<N>, Parameter = Q, Order = usize>, const N: usize>(
    before: &S,
    flat: &Flattened<Q, S>,
) -> Result<(), TestCaseError> {
    for span in places(flat.shape.space_along(Direction::U)) {
        let inside = flat.changed.as_ref().is_some_and(|b| b[0].0 < span[0] && span[0] < b[0].1);
        for x in span.iter().filter(|_| !inside) {
            prop_assert_eq!(before.derivative_of(x, 0)?, flat.shape.derivative_of(x, 0)?);
        }
    }
    Ok(())
}

/// All that holds for curves.
fn check_curve<S: Controlled<Q, Point = Point<2>, Parameter = Q, Order = usize>>(
    curve: &S,
    data: &[Point<2>; 3],
    pick: &[Index; 2],
    count: usize,
) -> Result<(), TestCaseError> {
    let all = Flatten::new(line(data));
    let done = all.apply(curve)?;
    check_points(curve, &done, data)?;
    let (a, b) = curve.space_along(Direction::U).domain();
    prop_assert_eq!(&done.flat, &vec![vec![(a.clone(), b.clone())]]);
    for side in [Side::Positive, Side::Negative] {
        let done = all.clone().on_side(side).apply(curve)?;
        check_points(curve, &done, data)?;
        check_intervals(&done, data)?;
        let places = curve.control_points()?;
        for (i, (old, new)) in places.iter().zip(done.shape.control_points()?).enumerate() {
            let heights = [old, &new]
                .map(|p| dot(&minus(p, &data[0]), &vector![data[1][0].clone(), data[1][1].clone()]));
            let [old, new] = heights.map(|h| if side == Side::Positive { h } else { -h });
            prop_assert_eq!(done.projected.contains(&i), old > Q::int(0));
            prop_assert_eq!(new, if old > Q::int(0) { Q::int(0) } else { old });
        }
    }
    let Some((start, end)) = interval(curve.space_along(Direction::U), pick) else { return Ok(()) };
    for refined in [false, true] {
        let rule = |tool: Flatten<Q, 2>| if refined { tool.refined(Refinement::Count(count)) } else { tool };
        let local = rule(all.clone().local_to((start.clone(), end.clone()))).apply(curve)?;
        let whole = rule(all.clone().whole((start.clone(), end.clone()))).apply(curve)?;
        for done in [&local, &whole] {
            let fine = if refined {
                Refinement::Count(count).of(curve, Direction::U, &start, &end)?
            } else {
                curve.clone()
            };
            check_points(&fine, done, data)?;
            check_intervals(done, data)?;
            check_changed(curve, done)?;
        }
        if let Some(changed) = &local.changed {
            prop_assert!(start <= changed[0].0 && changed[0].1 <= end);
        }
        prop_assert!(whole.flat.iter().any(|part| part[0].0 <= start && end <= part[0].1));
        let space = local.shape.space_along(Direction::U);
        if refined {
            let mut free: Vec<usize> = space.local_coeffs(&start, &end)?.map(|i| space.slot(i)).collect();
            free.sort_unstable();
            prop_assert_eq!(local.projected, free);
        }
        if refined && space.is_clamped() {
            // From p before the last span of `start` to before the first copy of `end`.
            let first = space.locate(&start)? - space.degree();
            let past = space.knots().partition_point(|t| t < &end);
            prop_assert_eq!(whole.projected, (first..past).collect::<Vec<_>>());
        }
    }
    Ok(())
}

/// All that holds for surfaces.
fn check_surface<S>(s: &S, data: &[Point<3>; 3], [i, j]: &[[Index; 2]; 2]) -> Result<(), TestCaseError>
where
    S: Controlled<Q, Point = Point<3>, Parameter = (Q, Q), Order = (usize, usize)> + PartialEq,
{
    let (u, v) = (s.space_along(Direction::U), s.space_along(Direction::V));
    let (Some(x), Some(y)) = (interval(u, i), interval(v, j)) else { return Ok(()) };
    let corner = |a: &Q, b: &Q| [a.clone(), b.clone()];
    let same: Part<Q> =
        Part::Polygon(vec![corner(&x.0, &y.0), corner(&x.1, &y.0), corner(&x.1, &y.1), corner(&x.0, &y.1)]);
    let half = Part::Polygon(vec![corner(&x.0, &y.0), corner(&x.1, &y.0), corner(&x.1, &y.1)]);
    let rectangle = Part::from([x.clone(), y.clone()]);
    let tool = Flatten::new(plane(data));
    let local = tool.clone().local_to(rectangle.clone()).apply(s)?;
    let whole = tool.clone().whole(rectangle).apply(s)?;
    prop_assert_eq!(&local, &tool.clone().local_to(same.clone()).apply(s)?);
    prop_assert_eq!(&whole, &tool.clone().whole(same).apply(s)?);
    let triangle = tool.clone().local_to(half.clone()).apply(s)?;
    prop_assert!(triangle.projected.iter().all(|k| local.projected.contains(k)));
    let above = tool.on_side(Side::Positive).apply(s)?;
    let inside = |place: &(Q, Q), part: &[(Q, Q)]| {
        part[0].0 < place.0 && place.0 < part[0].1 && part[1].0 < place.1 && place.1 < part[1].1
    };
    for done in [&local, &whole, &triangle, &above] {
        check_points(s, done, data)?;
        for us in places(u) {
            for vs in places(v) {
                let first = (us[0].clone(), vs[0].clone());
                let told = done.flat.iter().filter(|part| inside(&first, part)).count();
                let changed = done.changed.as_ref().is_some_and(|part| inside(&first, part));
                let mut is_flat = true;
                for place in us.iter().flat_map(|u| vs.iter().map(move |v| (u.clone(), v.clone()))) {
                    let found = done.shape.derivative_of(&place, (0, 0))?;
                    is_flat &= dot(&minus(&found, &data[0]), &data[1]) == Q::int(0);
                    prop_assert!(changed || found == s.derivative_of(&place, (0, 0))?);
                }
                prop_assert_eq!(told, usize::from(is_flat));
            }
        }
    }
    for (done, part) in [(&local, None), (&triangle, Some(&half))] {
        let Some(changed) = &done.changed else { continue };
        prop_assert!(
            x.0 <= changed[0].0 && changed[0].1 <= x.1 && y.0 <= changed[1].0 && changed[1].1 <= y.1
        );
        // Nothing changes outside the triangle, whose upper left corner is cut off.
        if let Some(part) = part {
            for (a, b) in places(u)
                .concat()
                .into_iter()
                .flat_map(|a| places(v).concat().into_iter().map(move |b| (a.clone(), b)))
            {
                if !part.contains(&[a.clone(), b.clone()]) {
                    let place = (a, b);
                    prop_assert_eq!(
                        done.shape.derivative_of(&place, (0, 0))?,
                        s.derivative_of(&place, (0, 0))?
                    );
                }
            }
        }
    }
    let covers =
        |part: &Vec<(Q, Q)>| part[0].0 <= x.0 && x.1 <= part[0].1 && part[1].0 <= y.0 && y.1 <= part[1].1;
    prop_assert!(whole.flat.iter().any(covers) || whole.flat.len() > 1);
    for (a, b) in
        places(u).concat().iter().flat_map(|a| places(v).concat().into_iter().map(move |b| (a.clone(), b)))
    {
        if x.0 < a && a < x.1 && y.0 < b && b < y.1 {
            prop_assert!(whole.flat.iter().any(|part| inside(&(a.clone(), b.clone()), part)));
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(16))]

    #[test]
    fn flat_parts_are_flat_and_the_rest_stays(
        c in curve::<2>(KIND),
        data in onto::<2>(),
        pick in any::<[Index; 2]>(),
        count in 0_usize..6,
    ) {
        check_curve(&c, &data, &pick, count)?;
    }

    #[test]
    fn flat_parts_of_rational_curves(
        c in nurbs::<2>(KIND),
        data in onto::<2>(),
        pick in any::<[Index; 2]>(),
        count in 0_usize..6,
    ) {
        if c.control_points().is_ok() {
            check_curve(&c, &data, &pick, count)?;
        }
    }

    #[test]
    fn flat_parts_of_surfaces(
        s in surface::<3>(SMALL, SMALL),
        data in onto::<3>(),
        picks in any::<[[Index; 2]; 2]>(),
    ) {
        check_surface(&s, &data, &picks)?;
    }

    #[test]
    fn flat_parts_of_rational_surfaces(
        s in nurbs_surface::<3>(SMALL.of_degree(0, 1)),
        data in onto::<3>(),
        picks in any::<[[Index; 2]; 2]>(),
    ) {
        if s.control_points().is_ok() {
            check_surface(&s, &data, &picks)?;
        }
    }

    #[test]
    fn segments_and_regions_accept_what_is_in_them(
        c in curve::<3>(KIND),
        data in onto::<3>(),
        ends in [point::<3>(), point()],
        radius in number(),
    ) {
        let tool = Flatten::new(plane(&data));
        let all = tool.apply(&c)?.shape;
        let check = |flat: Flattened<Q, _>, accepts: &dyn Fn(&Point<3>) -> bool| -> Result<(), TestCaseError> {
            check_points(&c, &flat, &data)?;
            for (i, image) in all.coeffs().iter().enumerate() {
                prop_assert_eq!(flat.projected.contains(&i), accepts(image));
            }
            Ok(())
        };
        let [a, b] = &ends;
        let radius = radius.abs();
        let ball = tool.clone().within_ball(a.clone(), radius.clone()).apply(&c)?;
        check(ball, &|p| dot(&minus(p, a), &minus(p, a)) <= radius.clone() * &radius)?;
        // A triangle with a corner each at three projected points holds them, and the middles of its sides.
        let corners: Vec<_> = all.coeffs().iter().take(3).cloned().collect();
        let inside = tool.clone().within_polygon(corners.clone()).apply(&c);
        match corners.len() {
            3 => {
                let inside = inside?;
                prop_assert!((0..3).all(|i| inside.projected.contains(&i)));
            }
            found => prop_assert_eq!(inside.unwrap_err(), Error::TooFewPoints { expected: 3, found }),
        }
        if a == b {
            let error = tool.within_segment(a.clone(), b.clone()).apply(&c).unwrap_err();
            prop_assert_eq!(error, ShapeError::NoDirection { what: "segment" }.into());
        } else {
            let between = tool.clone().within_segment(a.clone(), b.clone()).apply(&c)?;
            let way = minus(b, a);
            check(between, &|p| {
                let share = dot(&minus(p, a), &way);
                Q::int(0) <= share && share <= dot(&way, &way)
            })?;
            let fronts = tool.in_front_of(a.clone(), way.clone()).apply(&c)?;
            for (i, p) in c.coeffs().iter().enumerate() {
                prop_assert_eq!(fronts.projected.contains(&i), dot(&minus(p, a), &way) > Q::int(0));
            }
        }
    }

    #[test]
    fn refinement_goes_on_until_something_is_flat(
        c in curve::<2>(KIND.few(2)),
        data in onto::<2>(),
        pick in any::<[Index; 2]>(),
    ) {
        let Some((start, end)) = interval(c.space(), &pick) else { return Ok(()) };
        let tool = Flatten::new(line(&data)).local_to((start.clone(), end.clone()));
        let done = tool.until_flat(200).apply(&c)?;
        let here = done.flat.iter().filter(|part| part[0].0 < end && start < part[0].1);
        prop_assert!(here.count() > 0);
        check_intervals(&done, &data)?;
        check_changed(&c, &done)?;
        // No knots are inserted elsewhere.
        let outside = |s: &SplineSpace<Q>| {
            s.breaks().into_iter().filter(|(t, _)| *t <= start || end <= *t).collect::<Vec<_>>()
        };
        prop_assert_eq!(outside(done.shape.space()), outside(c.space()));
        // A whole interval is flat at once.
        let at_once = Flatten::new(line(&data)).whole((start, end)).until_flat(0).apply(&c)?;
        prop_assert_eq!(at_once.shape.space(), c.space());
    }

    #[test]
    fn lines_in_space(c in curve::<3>(KIND), data in onto::<3>(), pick in any::<[Index; 2]>()) {
        let [origin, direction, normal] = &data;
        let onto = Onto::space_line_within(origin.clone(), direction.clone(), normal.clone())?;
        let tool = Flatten::new(onto);
        prop_assert_eq!(tool.clone().on_side(Side::Positive).apply(&c).unwrap_err(), ShapeError::NoSides.into());
        let Some((start, end)) = interval(c.space(), &pick) else { return Ok(()) };
        let done = tool.whole((start.clone(), end.clone())).apply(&c)?;
        for i in &done.projected {
            let (old, new) = (&c.coeffs()[*i], &done.shape.coeffs()[*i]);
            // On the line, and at the same height across the normal.
            let off = minus(new, origin);
            let share = dot(&off, direction) / dot(direction, direction);
            prop_assert_eq!(off, direction.map(|x| x * &share));
            prop_assert_eq!(dot(&minus(new, old), normal), Q::int(0));
        }
        prop_assert!(done.flat.iter().any(|part| part[0].0 <= start && end <= part[0].1));
        check_changed(&c, &done)?;
    }
}

/// The parameters must be those of the shape, and inside.
#[test]
fn parts_of_the_wrong_kind_are_refused() {
    let line = SplineSpace::bezier(1, Q::int(0), Q::int(1)).unwrap();
    let points = vec![vector![Q::int(0), Q::int(0), Q::int(1)]; 4];
    let s = Surface::new(line.clone(), line, points).unwrap();
    let up = || vector![Q::int(0), Q::int(0), Q::int(1)];
    let tool = Flatten::new(Onto::plane(up().map(|x| x * Q::int(0)), up()).unwrap());
    let other = tool.clone().local_to((Q::int(0), Q::int(1))).apply(&s).unwrap_err();
    assert_eq!(other, ShapeError::OtherParameters.into());
    assert!(tool.clone().whole(Part::Polygon(Vec::new())).apply(&s).is_err());
    let outside = [(Q::int(0), Q::int(2)), (Q::int(0), Q::int(1))];
    assert!(matches!(tool.clone().whole(outside).apply(&s), Err(Error::OutsideDomain { .. })));
    // Nothing is above, however fine it gets.
    let below = tool.on_side(Side::Negative).until_flat(100).apply(&s).unwrap_err();
    assert!(matches!(below, Error::Shape(ShapeError::NotFlat { limit: 100, .. })), "{below:?}");
}
