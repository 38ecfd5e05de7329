//! Laws of local fine tuning: the rest of the curve stays, exactly, and the portion meets it as smoothly as is held.

use crate::strategies::{ANY, Kind, RING, cases, coeffs, curve, number, probes};
use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{
    Coeff, Curve, Error, Function, Hold, LocallyTuned, Norm, Q, Scalar, Scale, Spline, SplineSpace,
};

/// Curves of all sorts, jumps included.
pub const CURVE: Kind = ANY.of_degree(1, 4).few(3);
pub const HOLDS: [(usize, Hold); 3] = [(0, Hold::Points), (1, Hold::Tangents), (2, Hold::Curvatures)];

/// A curve and a scale function on a portion of it, whose knots are partly those of the curve.
pub fn curve_and_portion(
    kind: Kind,
    degrees: std::ops::RangeInclusive<usize>,
) -> impl Strategy<Value = (Curve<Q, 2>, Function<Q>)> {
    let ends = (any::<Index>(), any::<Index>());
    let knots = vec((any::<Index>(), 1_usize..=2), 0..=2);
    (curve::<2>(kind), ends, degrees, knots, coeffs(number().boxed())).prop_map(
        |(c, (i, j), q, knots, values)| {
            let places = probes(c.space());
            let (i, j) = (i.index(places.len()), j.index(places.len() - 1));
            let j = if j >= i { j + 1 } else { j };
            let (a, b) = (&places[i.min(j)], &places[i.max(j)]);
            let inside: Vec<&Q> = places.iter().filter(|t| a < *t && *t < b).collect();
            let mut inner: Vec<(Q, usize)> = Vec::new();
            for (place, copies) in knots {
                if !inside.is_empty() && inner.iter().all(|(t, _)| t != *place.get(&inside)) {
                    inner.push(((*place.get(&inside)).clone(), copies.min(q + 1)));
                }
            }
            inner.sort();
            let inner = inner.into_iter().flat_map(|(t, copies)| std::iter::repeat_n(t, copies));
            let space = SplineSpace::clamped(q, [a.clone()].into_iter().chain(inner).chain([b.clone()]));
            let space = space.expect("knots in order");
            let values = values[..space.dim()].to_vec();
            (c, Function::new(space, values).expect("as many values as the space has"))
        },
    )
}

fn copies(space: &SplineSpace<Q>, t: &Q) -> usize {
    space.breaks().iter().find(|(s, _)| s == t).map_or(0, |(_, m)| *m)
}

/// The result, or nothing where there is a good reason for that.
pub fn local(
    c: &Curve<Q, 2>,
    alpha: &Function<Q>,
    hold: Hold,
) -> Result<Option<LocallyTuned<Q, 2>>, TestCaseError> {
    let (a, b) = alpha.domain();
    let breaks = c.space().breaks();
    let jumps = breaks.iter().any(|(t, m)| a < t && t < b && *m > c.degree());
    let middle = c.restricted(a, b)?;
    match (c.fine_tuned_on(Scale::Signed(alpha), hold), middle.fine_tuned_holding(Scale::Signed(alpha), hold))
    {
        (Ok(local), Ok(held)) => {
            prop_assert!(!jumps);
            prop_assert_eq!(&local.tuned().curve, &held.curve);
            prop_assert_eq!(local.portion(), (a, b));
            prop_assert_eq!(local.original(), c);
            Ok(Some(local))
        }
        (Err(error), Err(expected)) => {
            prop_assert_eq!(jumps, matches!(error, Error::Discontinuous { .. }));
            prop_assert_eq!(error, expected);
            Ok(None)
        }
        (found, expected) => Err(TestCaseError::fail(format!("{found:?} instead of {expected:?}"))),
    }
}

/// That `whole` is `c` outside the portion and `portion` inside.
pub fn check_pieces(
    whole: &Curve<Q, 2>,
    c: &Curve<Q, 2>,
    portion: &Curve<Q, 2>,
) -> Result<(), TestCaseError> {
    let ((start, end), (a, b)) = (c.domain(), portion.domain());
    prop_assert_eq!(whole.domain(), c.domain());
    prop_assert!(whole.restricted(a, b)?.same_function(portion)?);
    for (s, t) in [(start, a), (b, end)] {
        if s < t {
            prop_assert!(whole.restricted(s, t)?.same_function(&c.restricted(s, t)?)?);
        }
    }
    prop_assert_eq!(whole.space().is_periodic(), c.space().is_periodic());
    Ok(())
}

/// The copies that `t` has in a whole of degree `p` with a portion over `portion`, if up to `j` derivatives agree.
fn expected_copies(t: &Q, c: &Curve<Q, 2>, portion: &SplineSpace<Q>, j: usize) -> usize {
    let (p, (a, b), (start, end)) = (portion.degree(), portion.domain(), c.domain());
    let ring = c.space().is_periodic();
    let own = copies(c.space(), t);
    let raised = if own > 0 { own + p - c.degree() } else { 0 };
    let at = |x: &Q| t == x || ring && (t == start && x == end || t == end && x == start);
    if at(a) || at(b) {
        let free = !ring && (t == start || t == end);
        if free { p + 1 } else { raised.max(p.saturating_sub(j)) }
    } else if a < t && t < b {
        copies(portion, t)
    } else {
        raised.min(p + 1)
    }
}

pub fn check_copies(
    whole: &Curve<Q, 2>,
    c: &Curve<Q, 2>,
    portion: &SplineSpace<Q>,
    j: usize,
) -> Result<(), TestCaseError> {
    for space in [whole.space(), c.space(), portion] {
        for (t, _) in space.breaks() {
            prop_assert_eq!(copies(whole.space(), &t), expected_copies(&t, c, portion, j), "{}", t);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn the_rest_is_untouched((c, alpha) in curve_and_portion(CURVE, 0..=2)) {
        let ((start, end), (a, b)) = (c.domain(), alpha.domain());
        for (_, hold) in HOLDS {
            let Some(local) = local(&c, &alpha, hold)? else { continue };
            for (piece, s, t) in [(local.before(), start, a), (local.after(), b, end)] {
                let expected = (s < t).then(|| c.restricted(s, t)).transpose()?;
                prop_assert_eq!(piece, expected.as_ref());
            }
        }
    }

    #[test]
    fn what_is_held_meets_the_rest((c, alpha) in curve_and_portion(CURVE, 0..=2)) {
        for (j, hold) in HOLDS {
            let Some(local) = local(&c, &alpha, hold)? else { continue };
            let (a, b) = alpha.domain();
            let (tuned, middle) = (&local.tuned().curve, c.restricted(a, b)?);
            for x in [a, b] {
                prop_assert_eq!(tuned.derivatives_at(x, j)?, middle.derivatives_at(x, j)?);
            }
        }
    }

    #[test]
    fn the_whole_is_its_pieces((c, alpha) in curve_and_portion(CURVE, 0..=2)) {
        for (j, hold) in HOLDS {
            let Some(local) = local(&c, &alpha, hold)? else { continue };
            let whole = local.joined()?;
            prop_assert_eq!(whole.degree(), c.degree() + alpha.degree());
            check_pieces(&whole, &c, &local.tuned().curve)?;
            check_copies(&whole, &c, local.tuned().curve.space(), j)?;
            prop_assert!(whole.space().contains(c.space()));
        }
    }

    #[test]
    fn a_constant_scale_gives_the_whole_back((c, alpha) in curve_and_portion(CURVE, 0..=2), level in 1_i64..4) {
        let one = Function::constant(alpha.space().clone(), Q::int(level))?;
        for (_, hold) in HOLDS {
            let Some(local) = local(&c, &one, hold)? else { continue };
            prop_assert!(local.joined()?.same_function(&c)?);
        }
    }

    #[test]
    fn only_the_start_is_held_where_nothing_follows((c, alpha) in curve_and_portion(CURVE, 0..=2)) {
        let (a, b) = alpha.domain();
        let last = b == c.domain().1 && !c.space().is_periodic();
        match c.fine_tuned_on(Scale::Signed(&alpha), Hold::Start) {
            Ok(local) => {
                let tuned = &local.tuned().curve;
                prop_assert_eq!(tuned, &c.restricted(a, b)?.fine_tuned(Scale::Signed(&alpha))?);
                prop_assert!(last || tuned.at(b)? == c.restricted(a, b)?.at(b)?);
                check_pieces(&local.joined()?, &c, tuned)?;
                check_copies(&local.joined()?, &c, tuned.space(), 0)?;
            }
            Err(Error::EndsDoNotMeet { .. }) => prop_assert!(!last),
            Err(error) => {
                let discontinuous = matches!(error, Error::Discontinuous { .. });
                prop_assert!(discontinuous, "{}", error);
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn portions_over_the_seam_are_tuned_where_it_is_moved(c in curve::<2>(RING.of_degree(2, 3).smooth(1)), rise in number()) {
        let ((start, end), period) = (c.domain(), c.domain().1.clone() - c.domain().0);
        let place = |k: i64| start.clone() + period.clone() * Q::frac(k, 4);
        let turned = c.with_seam_at(&place(2))?;
        let space = SplineSpace::bezier(1, place(3), place(5))?;
        let alpha = Function::new(space, vec![rise.clone(), rise + Q::int(1)])?;
        let Some(local) = local(&turned, &alpha, Hold::Tangents)? else { return Ok(()) };
        let whole = local.joined()?.with_seam_at(end)?.reparametrised(start, end)?;
        prop_assert!(whole.restricted(&place(1), &place(3))?.same_function(&c.restricted(&place(1), &place(3))?)?);
        prop_assert_eq!(whole.at(start)?, local.tuned().curve.at(end)?);
        // The old seam is as smooth as it was.
        let raised = copies(c.space(), start) + 1;
        prop_assert_eq!(copies(whole.space(), start), raised);
    }
}

/// A curve in space and a positive scale on a portion, over `f64`.
pub fn in_space() -> impl Strategy<Value = (Curve<f64, 3>, Function<f64>)> {
    let ends = (0.0_f64..=1.9, 2.1_f64..=4.0);
    (2_usize..=4, vec(vec(-8_i32..=8, 3), 8), ends, 0_usize..=2, vec(0.5_f64..2.0, 4)).prop_map(
        |(n, points, (a, b), q, levels)| {
            let points = points.iter().map(|x| SVector::from_fn(|i, _| f64::from(x[i])));
            let space = SplineSpace::clamped(n, [0.0, 1.0, 1.5, 3.0, 4.0]).expect("a clamped space");
            let scale = SplineSpace::clamped(q, [a, 2.0, b]).expect("a clamped space");
            let curve = Curve::new(space, points.take(n + 4).collect()).expect("as many control points");
            let levels = levels[..scale.dim()].to_vec();
            (curve, Function::new(scale, levels).expect("as many levels"))
        },
    )
}

/// The control points of `whole` whose basis functions lie within `[a, b]`, and the others, by their indices.
pub fn inside<C: Coeff<f64>>(whole: &Spline<f64, C>, a: f64, b: f64) -> impl Fn(usize) -> bool + '_ {
    let (t, p) = (whole.space().knots(), whole.degree());
    move |i| a <= t[i] && t[i + p + 1] <= b
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn control_points_in_space_are_copied((c, alpha) in in_space()) {
        let (&a, &b) = alpha.domain();
        for (j, hold) in HOLDS {
            let local = match c.fine_tuned_on(&alpha, hold) {
                Err(Error::NoChord | Error::CoefficientCount { .. }) => continue,
                local => local?,
            };
            let (whole, tuned) = (local.joined()?, &local.tuned().curve);
            let raised = c.embedded(whole.space())?;
            let within = inside(&whole, a, b);
            let (inner, outer): (Vec<usize>, Vec<usize>) = (0..whole.coeffs().len()).partition(|&i| within(i));
            prop_assert!(outer.iter().all(|&i| whole.coeffs()[i] == raised.coeffs()[i]));
            // At the ends of the curve all are copied.
            let from = if a == 0.0 { 0 } else { (j + 1).min(tuned.degree() + 1) };
            let copied: Vec<_> = inner.iter().map(|&i| whole.coeffs()[i]).collect();
            prop_assert!(tuned.coeffs()[from..].starts_with(&copied));
            let size = c.size_bound()?.max(tuned.size_bound()?).max(raised.size_bound()?);
            for k in 0..=40 {
                let x = f64::from(k) * 0.1;
                let piece = if x < a { &c } else if x < b { tuned } else { &c };
                prop_assert!((whole.at(&x)? - piece.at(&x)?).norm() <= 64.0 * f64::EPSILON * size);
            }
        }
    }

}

/// A clamped curve that turns this way and that.
pub fn wave(n: usize, breaks: &[i64]) -> symspline::Result<Curve<Q, 2>> {
    let space = SplineSpace::clamped(n, breaks.iter().copied().map(Q::int))?;
    let points = (0..space.dim() as i64).map(|i| vector![Q::int(i), Q::int(i * i * i % 7)]).collect();
    Curve::new(space, points)
}

/// A scale that rises from 1 to 2.
pub fn rise(a: Q, b: Q) -> symspline::Result<Function<Q>> {
    Function::new(SplineSpace::bezier(1, a, b)?, vec![Q::int(1), Q::int(2)])
}

#[test]
fn what_cannot_be_tuned_is_refused() -> symspline::Result<()> {
    let c = wave(2, &[0, 1, 2, 3, 4])?;
    for (a, b) in [(-1, 2), (2, 5), (5, 6)] {
        let refused = c.fine_tuned_on(&rise(Q::int(a), Q::int(b))?, Hold::Points);
        assert!(matches!(refused, Err(Error::OutsideDomain { .. })), "{a} {b}");
    }
    let alpha = rise(Q::int(1), Q::int(3))?;
    let start = c.fine_tuned_on(&alpha, Hold::Start);
    assert!(matches!(start, Err(Error::EndsDoNotMeet { .. })));
    assert!(c.fine_tuned_on(&rise(Q::int(1), Q::int(4))?, Hold::Start).is_ok());
    let negative = alpha.scaled(&Q::int(-1))?;
    assert!(matches!(c.fine_tuned_on(&negative, Hold::Points), Err(Error::NotPositive { .. })));
    assert!(c.fine_tuned_on(Scale::Signed(&negative), Hold::Points).is_ok());
    let torn = wave(2, &[0, 1, 2, 2, 2, 3, 4])?;
    let jump = torn.fine_tuned_on(&alpha, Hold::Points).unwrap_err();
    assert_eq!(jump, Error::Discontinuous { knot: "2".into() });
    // A jump at an end of the portion stays.
    let beside = torn.fine_tuned_on(&rise(Q::int(2), Q::int(4))?, Hold::Curvatures)?.joined()?;
    assert_eq!(beside.at_left(&Q::int(2))?, torn.at_left(&Q::int(2))?);
    assert_eq!(beside.derivatives_at(&Q::int(2), 2)?, torn.derivatives_at(&Q::int(2), 2)?);
    Ok(())
}

#[test]
fn a_closed_portion_has_no_chord() -> symspline::Result<()> {
    let points =
        [(0, 0), (1, 0), (3, 2), (-1, 2), (1, 0), (2, 0)].map(|(x, y)| vector![Q::int(x), Q::int(y)]);
    let loops = Curve::new(SplineSpace::clamped(1, [0, 1, 2, 3, 4, 5].map(Q::int))?, points.to_vec())?;
    let alpha = rise(Q::int(1), Q::int(4))?;
    assert_eq!(loops.fine_tuned_on(&alpha, Hold::Points).unwrap_err(), Error::NoChord);
    assert!(loops.fine_tuned_on(&alpha, Hold::Tangents).is_ok());
    Ok(())
}

#[test]
fn numbers_at_the_ends_of_the_range_give_values_or_errors() -> symspline::Result<()> {
    for size in [1e300, 1e-300, 1e154, 1e-160] {
        for scale in [1.0, 1e-200, 1e200] {
            let points =
                [[0.0, 0.0], [1.0, 2.0], [2.0, 0.0], [3.0, 1.0]].map(|[x, y]| vector![x * size, y * size]);
            let c = Curve::new(SplineSpace::clamped(2, [0.0, 1.0, 2.0])?, points.to_vec())?;
            let alpha = Function::new(SplineSpace::bezier(1, 0.5, 1.5)?, vec![scale, 2.0 * scale])?;
            for (_, hold) in HOLDS {
                let Ok(local) = c.fine_tuned_on(&alpha, hold) else { continue };
                drop((local.joined(), local.reduced(&(1e-3 * size)), local.reduced(&1e-3)));
            }
        }
    }
    // An end next to a knot.
    let c = Curve::new(
        SplineSpace::clamped(1, [0.0, 1.0, 2.0])?,
        vec![vector![0.0, 0.0], vector![1.0, 1.0], vector![2.0, 0.0]],
    )?;
    let alpha = Function::new(SplineSpace::bezier(1, 1.0 - f64::EPSILON / 2.0, 2.0)?, vec![1.0, 2.0])?;
    let whole = c.fine_tuned_on(&alpha, Hold::Points).and_then(|local| local.joined());
    assert!(whole.is_err() || whole.is_ok_and(|whole| whole.at(&0.5).is_ok()));
    Ok(())
}

#[test]
fn constants_have_nothing_to_tune() -> symspline::Result<()> {
    let space = SplineSpace::clamped(0, [0, 2].map(Q::int))?;
    let c = Curve::new(space, vec![vector![Q::int(1), Q::int(2)]])?;
    for (a, b) in [(0, 1), (1, 2), (0, 2)] {
        let alpha = rise(Q::int(a), Q::int(b))?;
        let local = c.fine_tuned_on(&alpha, Hold::Start)?;
        assert!(local.joined()?.same_function(&c)?);
        assert!(c.fine_tuned_on(&alpha, Hold::Points).is_err());
        let level = Function::constant(SplineSpace::bezier(0, Q::int(a), Q::int(b))?, Q::int(3))?;
        assert!(c.fine_tuned_on(&level, Hold::Start)?.joined()?.same_function(&c)?);
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn a_nearest_scale_holds_the_ends_of_a_portion(
        (c, alpha) in curve_and_portion(CURVE, 0..=2), order in 0_usize..3, lift in number(),
    ) {
        let wanted = alpha.translated(&lift)?;
        // With jumps at the ends α has no one-sided derivatives to hold, and curves that jump cannot be tuned at all.
        let Ok(local) = c.fine_tuned_on_by_nearest(&wanted, order, Norm::L2) else { return Ok(()) };
        let (portion, (a, b)) = (&local.tuned().curve, alpha.domain());
        let before = c.restricted(a, b)?;
        let whole = local.joined()?;
        check_pieces(&whole, &c, portion)?;
        check_copies(&whole, &c, portion.space(), order)?;
        let order = order.min(alpha.degree() + 1);
        prop_assert_eq!(portion.derivatives_at(a, order)?, before.derivatives_at(a, order)?);
        prop_assert_eq!(portion.derivatives_at(b, order)?, before.derivatives_at(b, order)?);
        // Tangents keep their directions.
        let (speed, own) = (portion.derivative()?, before.derivative()?);
        let turned = speed.cross(&own)?;
        prop_assert!(turned.coeffs().iter().all(|c| *c == Q::int(0)));
        for x in probes(portion.space()) {
            let forwards = speed.at(&x)?.dot(&own.at(&x)?);
            prop_assert!(forwards > Q::int(0) || own.at(&x)?.iter().all(|c| *c == Q::int(0)));
        }
    }
}
