//! Laws of regions: where knots go, which control points are free, and knots removed without a change elsewhere.

use crate::strategies::{
    ANY, CLAMPED, Kind, OPEN, cases, curve, function, indices, insertable, probes, space, surface,
};
use nalgebra::vector;
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{
    Coeff, Controlled, Direction, Keep, Q, Refinement, Scalar, Spline, SplineSpace, Surface, TensorSpline,
};

const SMALL: Kind = ANY.of_degree(0, 5);
const SIDE: Kind = ANY.of_degree(0, 3).few(2);

/// Two different parameters of a space, ascending.
pub fn interval(space: &SplineSpace<Q>, (i, j): (Index, Index)) -> (Q, Q) {
    let places = probes(space);
    let (i, j) = (i.index(places.len()), j.index(places.len() - 1));
    let j = if j >= i { j + 1 } else { j };
    (places[i.min(j)].clone(), places[i.max(j)].clone())
}

/// More than what a removal of some knots amplifies: spans differ by factors of up to `10^12`, once for each degree.
fn great() -> Q {
    (0..30).fold(Q::int(1), |great, _| great * Q::int(1_000_000_000_000))
}

/// Two different knots inside or at the ends of a domain.
fn knots_of(space: &SplineSpace<Q>, (i, j): (Index, Index)) -> (Q, Q) {
    let breaks = space.breaks();
    let (i, j) = (i.index(breaks.len()), j.index(breaks.len() - 1));
    let j = if j >= i { j + 1 } else { j };
    (breaks[i.min(j)].0.clone(), breaks[i.max(j)].0.clone())
}

/// Whether two splines are the same function from `a` to `b`.
pub fn same_on<C: Coeff<Q>>(f: &Spline<Q, C>, g: &Spline<Q, C>, a: &Q, b: &Q) -> symspline::Result<bool> {
    Ok(a >= b || f.restricted(a, b)?.same_function(&g.restricted(a, b)?)?)
}

/// Whether two splines are the same function outside `[start, end]`.
pub fn same_outside<C: Coeff<Q>>(
    f: &Spline<Q, C>,
    g: &Spline<Q, C>,
    (start, end): (&Q, &Q),
) -> symspline::Result<bool> {
    let (a, b) = f.domain();
    Ok(same_on(f, g, a, start)? && same_on(f, g, end, b)?)
}

/// Whether two surfaces are the same outside a rectangle.
pub fn same_around<C: Coeff<Q>>(
    f: &TensorSpline<Q, C>,
    g: &TensorSpline<Q, C>,
    from: &(Q, Q),
    to: &(Q, Q),
) -> symspline::Result<bool> {
    let strip = |s: &TensorSpline<Q, C>, direction, a: &Q, b: &Q| s.restricted(direction, a, b);
    let sides = [(Direction::U, &from.0, &to.0), (Direction::V, &from.1, &to.1)];
    for (direction, start, end) in sides {
        let (a, b) = f.space(direction).domain();
        for (a, b) in [(a, start), (end, b)] {
            if a < b && !strip(f, direction, a, b)?.same_function(&strip(g, direction, a, b)?)? {
                return Ok(false);
            }
        }
    }
    Ok(true)
}

/// The knots between `a` and `b`, both included.
fn between(space: &SplineSpace<Q>, a: &Q, b: &Q) -> Vec<Q> {
    space.breaks().into_iter().map(|(t, _)| t).filter(|t| a <= t && t <= b).collect()
}

/// The definition: the longest span found by looking at all, and halved.
fn halved(mut ends: Vec<Q>, is_done: impl Fn(usize, &Q) -> bool) -> Vec<Q> {
    for added in 0.. {
        let length = |i: usize| ends[i + 1].clone() - &ends[i];
        let longest = (0..ends.len() - 1).fold(0, |best, i| if length(i) > length(best) { i } else { best });
        if is_done(added, &length(longest)) {
            break;
        }
        let middle = (ends[longest].clone() + &ends[longest + 1]) / Q::int(2);
        ends.insert(longest + 1, middle);
    }
    ends
}

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn the_longest_span_is_halved(s in space(ANY), ends in any::<(Index, Index)>(), count in 0_usize..9, parts in 1_i64..9) {
        let (a, b) = interval(&s, ends);
        let mut ends = between(&s, &a, &b);
        ends.retain(|t| a < *t && *t < b);
        ends.insert(0, a.clone());
        ends.push(b.clone());
        let spacing = (b.clone() - &a) / Q::int(parts);
        let old = s.breaks();
        let is_old = |t: &Q| old.iter().any(|(k, _)| k == t);
        for (refinement, expected) in [
            (Refinement::Count(count), halved(ends.clone(), |added, _| added == count)),
            (Refinement::Spacing(spacing.clone()), halved(ends.clone(), |_, longest| *longest <= spacing)),
        ] {
            let knots = refinement.knots(&s, &a, &b)?;
            prop_assert!(knots.iter().all(|t| !is_old(t)) && knots.windows(2).all(|pair| pair[0] < pair[1]));
            let finer = s.refined(&knots)?;
            prop_assert_eq!(between(&finer, &a, &b), expected);
        }
    }

    #[test]
    fn free_are_those_without_influence_outside(s in space(SMALL), ends in any::<(Index, Index)>()) {
        let ((a, b), p, t) = (knots_of(&s, ends), s.degree(), s.knots());
        // In the domain, at every turn.
        let reaches_out = |i: &usize| {
            let (from, to) = (t[*i].clone().max(s.domain().0.clone()), t[i + p + 1].clone().min(s.domain().1.clone()));
            from < to && !(a <= from && to <= b)
        };
        let out: Vec<usize> = (0..t.len() - p - 1).filter(reaches_out).map(|i| s.slot(i)).collect();
        let expected: Vec<usize> = (0..s.dim()).filter(|j| !out.contains(j)).collect();
        let local = s.local_coeffs(&a, &b)?;
        let mut found: Vec<usize> = local.clone().map(|i| s.slot(i)).collect();
        found.sort_unstable();
        prop_assert_eq!(found, expected);
        if !s.is_periodic() && p > 0 {
            return Ok(());
        }
        prop_assert!(local.into_iter().all(|i| s.node(i).is_ok_and(|node| a <= node && node <= b)));
    }

    #[test]
    fn removable_knots_change_the_interval_only(f in function(OPEN.of_degree(0, 6)), ends in any::<(Index, Index)>()) {
        let ((a, b), p, t) = (knots_of(f.space(), ends), f.degree(), f.space().knots());
        for keep in [Keep::Left, Keep::Right] {
            let removable = f.space().removable_knots(&a, &b, keep)?;
            for r in p + 1..f.space().dim() {
                let (c, d) = f.without_knot(r, keep)?.changed;
                prop_assert_eq!(removable.contains(&r), a <= c && d <= b, "knot {} at {}", t[r].clone(), r);
            }
        }
    }

    #[test]
    fn removable_knots_of_any_space(f in function(SMALL), ends in any::<(Index, Index)>()) {
        let (a, b) = knots_of(f.space(), ends);
        let big = !f.space().is_periodic() || f.space().dim() > f.degree() + 1;
        for keep in [Keep::Left, Keep::Right] {
            for r in f.space().removable_knots(&a, &b, keep)?.filter(|_| big) {
                let dropped = f.without_knot(r, keep)?;
                prop_assert!(same_outside(&f, &dropped.spline, (&a, &b))?);
            }
        }
    }

    #[test]
    fn thinning_keeps_what_is_outside(
        c in curve::<2>(SMALL),
        places in indices(5),
        ends in any::<(Index, Index)>(),
        twentieths in 0_i64..60,
    ) {
        let fine = c.inserted(&insertable(c.space(), &places))?;
        let (a, b) = interval(fine.space(), ends);
        let tolerance = c.size_bound()? * Q::frac(twentieths, 20);
        let thin = fine.without_spare_knots_on(&a, &b, &tolerance)?;
        prop_assert!(same_outside(&fine, &thin.spline, (&a, &b))?);
        prop_assert!(fine.space().contains(thin.spline.space()));
        prop_assert!(thin.bound <= tolerance);
        for x in probes(fine.space()) {
            let off = fine.at(&x)? - thin.spline.at(&x)?;
            prop_assert!(off.squared_size() <= thin.bound.clone() * &thin.bound);
        }
        // The seam of a ring is both ends.
        let seam = fine.space().is_periodic().then(|| fine.domain());
        let inside = |t: &Q| a <= *t && *t <= b || seam.is_some_and(|(start, end)| t == start || t == end);
        let outside = |s: &SplineSpace<Q>| -> Vec<(Q, usize)> {
            s.breaks().into_iter().filter(|(t, _)| !inside(t)).collect()
        };
        prop_assert_eq!(outside(fine.space()), outside(thin.spline.space()));
    }

    #[test]
    fn thinning_undoes_insertion(c in curve::<2>(SMALL), places in indices(5), ends in any::<(Index, Index)>()) {
        let (a, b) = interval(c.space(), ends);
        let mut knots = insertable(c.space(), &places);
        knots.retain(|t| a <= *t && *t <= b);
        let fine = c.inserted(&knots)?;
        let thin = fine.without_spare_knots_on(&a, &b, &Q::int(0))?;
        prop_assert_eq!(thin.bound, Q::int(0));
        prop_assert!(thin.spline.same_function(&c)?);
        let tight = fine.space().is_periodic() && thin.spline.space().dim() < c.degree() + 2;
        prop_assert!(tight || c.space().contains(thin.spline.space()));
    }

    /// With room enough a knot stays only if it cannot go without a change outside.
    #[test]
    fn with_room_enough_all_removable_knots_go(c in curve::<2>(OPEN.of_degree(0, 5)), places in indices(5), ends in any::<(Index, Index)>()) {
        let fine = c.inserted(&insertable(c.space(), &places))?;
        let (a, b) = knots_of(fine.space(), ends);
        let most = (c.size_bound()? + Q::int(1)) * great();
        let thin = fine.without_spare_knots_on(&a, &b, &most)?.spline;
        for keep in [Keep::Left, Keep::Right] {
            prop_assert!(thin.space().removable_knots(&a, &b, keep).map_or(true, |range| range.is_empty()));
        }
    }

    /// On the whole domain there is no outside: everything may go that a knot vector need not have.
    #[test]
    fn on_the_whole_domain_all_knots_go(c in curve::<2>(ANY.of_degree(0, 5)), places in indices(5)) {
        let fine = c.inserted(&insertable(c.space(), &places))?;
        let (a, b) = fine.domain();
        let most = (c.size_bound()? + Q::int(1)) * great();
        let thin = fine.without_spare_knots_on(a, b, &most)?.spline;
        prop_assert_eq!(thin.space().dim(), fine.space().dim().min(c.degree() + 1));
        prop_assert_eq!(fine.space().local_coeffs(a, b)?.len(), fine.space().dim());
        for keep in [Keep::Left, Keep::Right] {
            let inside = fine.space().breaks().iter().filter(|(t, _)| a < t && t < b).map(|(_, copies)| copies).sum::<usize>();
            prop_assert_eq!(fine.space().removable_knots(a, b, keep)?.len(), inside);
        }
    }

    #[test]
    fn thinning_a_surface_keeps_what_is_outside(
        s in surface::<2>(SIDE, SIDE),
        places in (indices(3), indices(3)),
        sides in any::<((Index, Index), (Index, Index))>(),
        halves in 0_i64..9,
    ) {
        let fine: Surface<Q, 2> = s
            .inserted(Direction::U, &insertable(s.u(), &places.0))?
            .inserted(Direction::V, &insertable(s.v(), &places.1))?;
        let ((a, b), (c, d)) = (interval(fine.u(), sides.0), interval(fine.v(), sides.1));
        let (from, to) = ((a, c), (b, d));
        let tolerance = Q::int(halves * halves * halves);
        let thin = fine.without_spare_knots_on(&from, &to, &tolerance)?;
        prop_assert!(thin.bound <= tolerance);
        prop_assert!(same_around(&fine, &thin.spline, &from, &to)?);
        prop_assert!(fine.u().contains(thin.spline.u()) && fine.v().contains(thin.spline.v()));
        for u in probes(fine.u()) {
            for v in probes(fine.v()) {
                let off = fine.at(&u, &v)? - thin.spline.at(&u, &v)?;
                prop_assert!(off.squared_size() <= thin.bound.clone() * &thin.bound);
            }
        }
        if halves == 0 {
            prop_assert!(thin.spline.same_function(&s)?);
        }
    }

    /// What was changed inside a rectangle in a refined surface does not keep the knots from going that were inserted.
    #[test]
    fn inserted_knots_of_a_surface_go(s in surface::<2>(CLAMPED.of_degree(1, 3).few(2), SIDE), sides in any::<((Index, Index), (Index, Index))>()) {
        let ((a, b), (c, d)) = (interval(s.u(), sides.0), interval(s.v(), sides.1));
        let finer = Refinement::Count(4 * s.u().degree()).of(&s, Direction::U, &a, &b)?;
        let mut finer = Refinement::Count(4 * s.v().degree()).of(&finer, Direction::V, &c, &d)?;
        let (i, j) = (finer.u().local_coeffs(&a, &b)?, finer.v().local_coeffs(&c, &d)?);
        prop_assume!(!i.is_empty() && !j.is_empty());
        let place = finer.u().slot(i.start) * finer.v().dim() + finer.v().slot(j.start);
        finer.move_points(&[(place, vector![Q::int(3), Q::int(-1)])])?;
        let most = Q::int(1_000_000_000_000_000_000);
        let thin = finer.without_spare_knots_on(&(a.clone(), c.clone()), &(b.clone(), d.clone()), &most)?.spline;
        prop_assert!(same_around(&finer, &thin, &(a.clone(), c), &(b.clone(), d))?);
        // Of those inserted inside no knot has a basis function left between the ends.
        for keep in [Keep::Left, Keep::Right] {
            let t = thin.u().knots();
            let removable = thin.u().removable_knots(&a, &b, keep).map_or(0..0, |range| range);
            prop_assert!(removable.into_iter().all(|r| s.u().knots().contains(&t[r])));
        }
    }
}
