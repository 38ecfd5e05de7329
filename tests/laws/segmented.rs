//! Laws of fine tuning in the space that the curve had: nearest by its normal equations, and the rest exactly as it was.

use crate::local::{HOLDS, curve_and_portion, in_space, local, rise, wave};
use crate::strategies::{ANY, Kind, cases, number, point, probes};
use nalgebra::vector;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use symspline::{
    Coeff, Curve, Error, Function, Hold, LocallyTuned, Norm, Q, Scalar, ShapeError, SplineSpace,
};

/// Small numbers, since projections are exact.
const SMALL: Kind = ANY.of_degree(1, 3).smooth(1).few(3);

/// A curve with many knots, open, unclamped or closed, and a scale function on a wide portion of it.
fn long_curve_and_portion() -> impl Strategy<Value = (Curve<Q, 2>, Function<Q>)> {
    let ends = (0_i64..=3, 0_i64..=3);
    (1_usize..=3, 0..3, 6_usize..=8, vec(point::<2>(), 16), ends, vec(number(), 3), any::<bool>()).prop_map(
        |(p, shape, spans, points, (i, k), values, double)| {
            let (a, b) = (Q::int(0), Q::int(spans as i64));
            let open = SplineSpace::uniform(p, spans, a.clone(), b.clone()).expect("even knots");
            let space = match shape {
                0 => open,
                1 => open.unclamped_ends().expect("even knots"),
                _ => SplineSpace::uniform_periodic(p, spans, a, b.clone()).expect("even knots"),
            };
            let more = if double { vec![Q::int(1); p.min(2) - 1] } else { Vec::new() };
            let space = space.refined(&more).expect("room for a knot");
            let c = Curve::new(space.clone(), points[..space.dim()].to_vec()).expect("as many points");
            let (start, end) = (Q::frac(i, 2), b - Q::frac(k, 2));
            let inner = Q::int(3);
            let scales = SplineSpace::clamped(1, [start, inner, end]).expect("in order");
            (c, Function::new(scales, values).expect("three values"))
        },
    )
}

/// The basis functions that may change the portion: they vanish outside, and up to order `j` at its ends.
fn free(space: &SplineSpace<Q>, (a, b): (&Q, &Q), j: usize) -> symspline::Result<Vec<usize>> {
    let mut free = Vec::new();
    for i in 0..space.dim() {
        if is_free(space, i, (a, b), j)? {
            free.push(i);
        }
    }
    Ok(free)
}

fn is_free(space: &SplineSpace<Q>, i: usize, (a, b): (&Q, &Q), j: usize) -> symspline::Result<bool> {
    let ((start, end), p, f) = (space.domain(), space.degree(), unit(space, i)?);
    for (s, t) in [(start, a), (b, end)] {
        if s < t && !f.restricted(s, t)?.coeffs().iter().all(|c| *c == Q::int(0)) {
            return Ok(false);
        }
    }
    let mut order = Some(j);
    if space.is_periodic() && (a == start && b == end) {
        // The whole ring is open at the seam: there the space says how smooth it is.
        order = order.max(p.checked_sub(space.breaks()[0].1));
    }
    let f = f.restricted(a, b)?;
    let vanishes = |x: &Q| f.derivatives_at(x, order.unwrap_or(0)).map(|d| d.iter().all(|d| *d == Q::int(0)));
    Ok(vanishes(a)? && vanishes(b)?)
}

fn unit(space: &SplineSpace<Q>, i: usize) -> symspline::Result<Function<Q>> {
    Function::new(space.clone(), (0..space.dim()).map(|k| Q::int(i64::from(k == i))).collect())
}

/// That the result is the nearest one.
fn check(tuned: &LocallyTuned<Q, 2>, j: usize) -> Result<(), TestCaseError> {
    let (c, (a, b)) = (tuned.original(), tuned.portion());
    let space = if c.space().is_periodic() { c.space().clone() } else { c.space().clamped_ends()? };
    let free = free(&space, (a, b), j)?;
    let near = match tuned.in_original_space() {
        Ok(near) => near,
        Err(error) => {
            let (start, end) = (a.to_string(), b.to_string());
            let expected = if j > c.degree() {
                Error::DegreeTooLow { degree: c.degree(), needed: j }
            } else {
                ShapeError::NothingLocal { start, end }.into()
            };
            prop_assert!(free.is_empty() || j > c.degree());
            prop_assert_eq!(error, expected);
            return Ok(());
        }
    };
    let (g, bound) = (&near.spline, &near.bound);
    prop_assert!(!free.is_empty());
    prop_assert_eq!(g.space(), c.space());
    // Nothing but what is free has changed.
    let change = g.embedded(&space)?.difference(&c.embedded(&space)?)?;
    prop_assert!((0..space.dim()).all(|i| free.contains(&i) || change.coeffs()[i].vanishes()));
    // What is left of the difference is orthogonal to all that could be changed.
    let left = tuned.tuned().curve.difference(&g.restricted(a, b)?)?;
    for i in free {
        prop_assert!(left.weighted_integral(&unit(&space, i)?.restricted(a, b)?)?.vanishes(), "{}", i);
    }
    let whole = tuned.joined()?;
    for x in probes(g.space()) {
        prop_assert!((g.at(&x)? - whole.at(&x)?).squared_size() <= bound.clone() * bound);
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(40))]

    #[test]
    fn it_is_the_nearest_curve_of_the_space((c, alpha) in curve_and_portion(SMALL, 0..=1), (j, hold) in select(&HOLDS[..])) {
        if let Some(local) = local(&c, &alpha, hold)? {
            check(&local, j)?;
        }
    }

    #[test]
    fn long_portions_too((c, alpha) in long_curve_and_portion(), (j, hold) in select(&HOLDS[..])) {
        if let Some(local) = local(&c, &alpha, hold)? {
            check(&local, j)?;
        }
    }

    #[test]
    fn what_is_of_the_space_comes_back((c, alpha) in curve_and_portion(SMALL, 0..=2), (_, hold) in select(&HOLDS[..])) {
        let one = Function::constant(alpha.space().clone(), Q::int(1))?;
        let Some(local) = local(&c, &one, hold)? else { return Ok(()) };
        if let Ok(near) = local.in_original_space() {
            prop_assert_eq!((near.spline, near.bound), (c, Q::int(0)));
        }
    }

    #[test]
    fn a_free_end_goes_where_it_was_tuned_to((c, alpha) in curve_and_portion(SMALL, 0..=1)) {
        let (a, b) = alpha.domain();
        prop_assume!(b == c.domain().1 && !c.space().is_periodic());
        let tuned = c.fine_tuned_on(symspline::Scale::Signed(&alpha), Hold::Start);
        let Ok(local) = tuned else { return Ok(()) };
        if let Ok(near) = local.in_original_space() {
            prop_assert_eq!(near.spline.space(), c.space());
            prop_assert_eq!(near.spline.at(b)?, local.tuned().curve.at(b)?);
            prop_assert_eq!(near.spline.at(a)?, c.at(a)?);
        }
    }
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn in_space_control_points_outside_stay_to_the_bit((c, alpha) in in_space(), (_, hold) in select(&HOLDS[..])) {
        let (a, b) = alpha.domain();
        let Ok(near) = c.fine_tuned_on(&alpha, hold).and_then(|local| local.in_original_space()) else { return Ok(()) };
        prop_assert_eq!(near.spline.space(), c.space());
        let t = c.space().knots();
        let inside = |i: usize| *a <= t[i] && t[i + c.degree() + 1] <= *b;
        for (i, (before, after)) in c.coeffs().iter().zip(near.spline.coeffs()).enumerate() {
            prop_assert!(inside(i) || before == after);
        }
        let whole = c.fine_tuned_on(&alpha, hold)?.joined()?;
        for k in 0..=80 {
            let x = f64::from(k) * 0.05;
            prop_assert!((near.spline.at(&x)? - whole.at(&x)?).norm() <= near.bound);
        }
    }
}

#[test]
fn sections_tuned_one_after_the_other_keep_their_space() -> symspline::Result<()> {
    let c = wave(3, &[0, 1, 2, 3, 4, 5, 6, 7, 8])?;
    let alpha = rise(Q::int(1), Q::int(7))?;
    let once = c.fine_tuned_on(&alpha, Hold::Tangents)?.in_original_space()?.spline;
    let twice = once.fine_tuned_on(&alpha, Hold::Points)?.in_original_space()?.spline;
    assert!(once.space() == c.space() && twice.space() == c.space() && once != c && twice != once);
    Ok(())
}

#[test]
fn a_nearest_scale_is_kept_in_the_space_too() -> symspline::Result<()> {
    let c = wave(3, &[0, 1, 2, 3, 4, 5, 6, 7, 8])?;
    let scales = SplineSpace::clamped(2, [1, 2, 3, 4, 5, 6, 7].map(Q::int))?;
    let wanted = Function::constant(scales, Q::int(1))?.dragged(&Q::int(4), Q::int(2), Norm::Coefficients)?;
    let local = c.fine_tuned_on_by_nearest(&wanted, 1, Norm::Coefficients)?;
    check(&local, 1).expect("the nearest");
    Ok(())
}

#[test]
fn without_a_free_control_point_it_says_so() -> symspline::Result<()> {
    let points = vec![vector![0.0, 0.0], vector![1.0, 2.0], vector![2.0, 0.0]];
    let curve = Curve::new(SplineSpace::bezier(2, 0.0, 1.0)?, points)?;
    let alpha = Function::new(SplineSpace::bezier(1, 0.25, 1.0)?, vec![1.0, 2.0])?;
    let refused = curve.fine_tuned_on(&alpha, Hold::Points)?.in_original_space().unwrap_err();
    assert_eq!(refused, Error::Shape(ShapeError::NothingLocal { start: "0.25".into(), end: "1".into() }));
    Ok(())
}
