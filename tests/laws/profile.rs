//! Laws of curvature profiles: events and runs against the curvature itself, known curves, invariance.

use crate::rational_strategies::nurbs;
use crate::strategies::{ANY, Kind, SMOOTH, cases, curve, function, probes};
use nalgebra::{SVector, vector};
use proptest::prelude::*;
use std::cmp::Ordering;
use symspline::roots::RootValue;
use symspline::{
    Analyse, Certified, CurvatureProfile, Curve, Ends, EventKind, Function, NurbsCurve, Place, Q, Result,
    Scalar, SplineSpace, Turning, Weighted, circle, ellipse,
};

type Outcome = std::result::Result<(), TestCaseError>;

/// The squared curvature with the sign of the curvature, from the first two derivatives; none where the first vanishes.
fn signed_square<const N: usize>(first: &SVector<Q, N>, second: &SVector<Q, N>) -> Option<Q> {
    let dot = |c: &SVector<Q, N>, d: &SVector<Q, N>| Q::dot(c.iter().zip(d.iter()));
    let speed = dot(first, first);
    if speed == Q::int(0) {
        return None;
    }
    // |c × d|² = |c|² |d|² - (c·d)².
    let along = dot(first, second);
    let square = &speed * dot(second, second) - &along * &along;
    let left = N > 2 || &first[0] * &second[1] >= &first[1] * &second[0];
    let square = square / (&speed * &speed * &speed);
    Some(if left { square } else { -square })
}

/// Checks that the curvature runs as the profile says, at several places of every run.
fn check_runs<const N: usize>(
    profile: &CurvatureProfile<Q>,
    derivatives: impl Fn(&Q) -> Result<Vec<SVector<Q, N>>>,
) -> Outcome {
    let mut at = profile.domain().0.clone();
    for run in profile.runs() {
        prop_assert!(at <= *run.start.bounds().1, "runs follow each other");
        at = run.end.bounds().1.clone();
        let (low, high) = (run.start.bounds().1, run.end.bounds().0);
        if low >= high {
            continue;
        }
        let mut last: Option<Q> = None;
        for share in [1, 13, 300, 499, 771, 995, 999] {
            let d = derivatives(&(low + (high - low) * Q::frac(share, 1000)))?;
            let Some(square) = signed_square(&d[1], &d[2]) else {
                prop_assert_eq!(run.trend, Ordering::Equal);
                continue;
            };
            if let Some(last) = last.replace(square.clone()) {
                prop_assert_eq!(square.cmp(&last), run.trend);
            }
        }
    }
    prop_assert_eq!(&at, profile.domain().1);
    Ok(())
}

/// The squared length.
fn dot<const N: usize>(c: &SVector<Q, N>) -> Q {
    Q::dot(c.iter().zip(c.iter()))
}

fn kinds<T: Certified>(profile: &CurvatureProfile<T>) -> Vec<EventKind> {
    profile.events().iter().map(|event| event.kind).collect()
}

fn bezier(points: &[[i64; 2]]) -> Curve<Q, 2> {
    let points = points.iter().map(|c| SVector::from(c.map(Q::int))).collect::<Vec<_>>();
    let space = SplineSpace::bezier(points.len() - 1, Q::int(0), Q::int(1)).expect("a domain");
    Curve::new(space, points).expect("as many points")
}

/// Curves on few spans: their conditions have high degrees.
const SMALL: Kind = ANY.of_degree(0, 4).few(2);

/// The values of the powers `-1 <= x <= 1` of one polynomial an axis, lowest first, over a common denominator.
fn rational(x: &[i64], y: &[i64], w: &[i64]) -> NurbsCurve<Q, 2> {
    let degree = [x, y, w].iter().map(|c| c.len() - 1).max().expect("three");
    let sum = |c: &[i64]| {
        let zero = Function::constant(
            SplineSpace::bezier(degree, Q::int(-1), Q::int(1)).expect("a domain"),
            Q::int(0),
        );
        c.iter().enumerate().fold(zero.expect("zero"), |sum, (power, c)| {
            let power = Function::monomial(power, Q::int(-1), Q::int(1)).expect("a power");
            sum.plus_scaled(&Q::int(*c), &power).expect("one domain")
        })
    };
    let [x, y, w] = [sum(x), sum(y), sum(w)];
    let lifted = (0..=degree).map(|i| Weighted {
        point: vector![x.coeffs()[i].clone(), y.coeffs()[i].clone()],
        weight: w.coeffs()[i].clone(),
    });
    let lifted = symspline::Spline::new(w.space().clone(), lifted.collect()).expect("as many points");
    NurbsCurve::from_lifted(lifted).expect("a positive denominator")
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn plane_curves_bend_as_their_profiles_say(c in curve::<2>(SMALL)) {
        check_runs(&c.profile()?, |x| c.derivatives_at(x, 2))?;
    }

    #[test]
    fn space_curves_bend_as_their_profiles_say(c in curve::<3>(ANY.of_degree(0, 3).few(1))) {
        check_runs(&c.profile()?, |x| c.derivatives_at(x, 2))?;
    }

    #[test]
    fn rational_curves_bend_as_their_profiles_say(c in nurbs::<2>(ANY.of_degree(0, 2).few(1))) {
        check_runs(&c.profile()?, |x| c.derivatives_at(x, 2))?;
    }

    #[test]
    fn rational_curves_in_space_bend_as_their_profiles_say(c in nurbs::<3>(ANY.of_degree(0, 2).few(1))) {
        check_runs(&c.profile()?, |x| c.derivatives_at(x, 2))?;
    }

    #[test]
    fn the_curvature_changes_its_sign_at_inflections_only(c in curve::<2>(SMALL)) {
        let profile = c.profile()?;
        let cuts = [EventKind::Inflection, EventKind::Cusp, EventKind::Corner, EventKind::Gap, EventKind::Stationary];
        let events: Vec<_> = profile.events().iter().filter(|event| cuts.contains(&event.kind)).collect();
        let mut last: Option<(Q, Ordering)> = None;
        for x in probes(c.space()) {
            let d = c.derivatives_at(&x, 2)?;
            let Some(square) = signed_square(&d[1], &d[2]) else { continue };
            let sign = square.cmp(&Q::int(0));
            // Nothing is said within an enclosure.
            let within = |event: &&symspline::Event<Q>| {
                let (low, high) = event.place.bounds();
                matches!(event.place, Place::At(_)) && *low < x && x < *high
            };
            if sign == Ordering::Equal || events.iter().any(within) {
                continue;
            }
            if let Some((y, before)) = last.replace((x.clone(), sign)) {
                let between = |event: &&&symspline::Event<Q>| {
                    let (low, high) = event.place.bounds();
                    // What is enclosed is strictly inside.
                    let enclosed = matches!(event.place, Place::At(RootValue::Enclosed(..)));
                    (*low < x || !enclosed && *low == x) && y < *high
                };
                let cut = |kind| kind != EventKind::Inflection;
                let inside: Vec<EventKind> = events.iter().filter(between).map(|event| event.kind).collect();
                if !inside.iter().any(|kind| cut(*kind)) {
                    prop_assert_eq!(inside.len() % 2 == 1, before != sign, "from {} to {}", y, x);
                }
            }
        }
    }

    #[test]
    fn enclosed_curvatures_hold_what_the_formula_gives(c in curve::<2>(SMALL)) {
        for event in c.profile()?.events() {
            let Place::At(RootValue::Exact(x)) = &event.place else { continue };
            let d = c.derivatives_at(x, 2)?;
            let Some(square) = signed_square(&d[1], &d[2]) else { continue };
            let bounds = event.curvature[1];
            if x == c.domain().1 {
                continue;
            }
            // Where the curve hardly moves nothing is known; on moderate spans it is.
            let breaks = c.space().breaks();
            let moderate = breaks.windows(2).all(|ends| (&ends[1].0 - &ends[0].0) == Q::int(1));
            prop_assert!(!moderate || bounds.low.is_finite() || dot(&d[1]) < Q::frac(1, 1000));
            if !(bounds.low.is_finite() && bounds.high.is_finite()) {
                continue;
            }
            let signed = |x: f64| Q::try_from(x).map(|x| if x < Q::int(0) { -(&x * &x) } else { &x * &x });
            prop_assert!(signed(bounds.low)? <= square && square <= signed(bounds.high)?);
        }
    }

    #[test]
    fn similarities_keep_profiles(c in curve::<2>(SMALL), by in -5_i64..=5) {
        // A turn by the angle of 3, 4, 5, and a scale.
        let [cos, sin] = [Q::frac(3, 5), Q::frac(4, 5)];
        let turned = |p: &SVector<Q, 2>| {
            vector![&p[0] * &cos - &p[1] * &sin + Q::int(by), &p[0] * &sin + &p[1] * &cos].map(|x| x * Q::frac(7, 2))
        };
        let moved = Curve::new(c.space().clone(), c.coeffs().iter().map(turned).collect())?;
        let (one, other) = (c.profile()?, moved.profile()?);
        prop_assert_eq!(one.differs_at(&other), None);
        prop_assert_eq!(one.runs(), other.runs());
        let places = |profile: &CurvatureProfile<Q>| profile.events().iter().map(|event| event.place.clone()).collect::<Vec<_>>();
        prop_assert_eq!(places(&one), places(&other));
    }

    #[test]
    fn profiles_do_not_depend_on_the_space(c in curve::<2>(ANY.of_degree(0, 3).few(2))) {
        let profile = c.profile()?;
        prop_assert_eq!(profile.runs(), c.elevated(1)?.profile()?.runs());
        prop_assert_eq!(profile.differs_at(&c.elevated(1)?.profile()?), None);
        let (a, b) = c.domain();
        if let Ok(finer) = c.inserted(&[a + (b - a) * Q::frac(1, 3)]) {
            prop_assert_eq!(profile.differs_at(&finer.profile()?), None);
        }
        let lifted = NurbsCurve::from_polynomial(&c)?.profile()?;
        prop_assert_eq!(profile.differs_at(&lifted), None);
        prop_assert_eq!(profile.runs(), lifted.runs());
    }

    #[test]
    fn backwards_the_signed_curvature_is_mirrored(c in curve::<2>(SMALL)) {
        // An open curve, whose events at the seam have no side to change.
        let (profile, back) = (c.profile()?, c.reversed()?.profile()?);
        for (one, other) in [(EventKind::Maximum, EventKind::Minimum), (EventKind::Inflection, EventKind::Inflection),
            (EventKind::Cusp, EventKind::Cusp), (EventKind::Corner, EventKind::Corner), (EventKind::Jump, EventKind::Jump)] {
            // Backwards the sign changes, and with it what is a maximum.
            prop_assert_eq!(profile.count(one), back.count(other));
        }
    }

    #[test]
    fn floats_have_the_profiles_of_their_exact_images(c in curve::<2>(SMALL)) {
        let Ok(rounded) = c.to_f64() else { return Ok(()) };
        let (found, expected) = (rounded.profile()?, rounded.to_exact()?.profile()?);
        prop_assert_eq!(found.events().len(), expected.events().len());
        // Different events within one rounding may change places.
        for kind in kinds(&found) {
            let (found, expected) = (found.events().iter(), expected.events().iter());
            let (found, mut expected) = (found.filter(|e| e.kind == kind), expected.filter(|e| e.kind == kind));
            for event in found {
                let exact = expected.next().expect("as many events of a kind");
                let ((low, high), (least, most)) = (event.place.bounds(), exact.place.bounds());
                prop_assert!(Q::try_from(*low)? <= *most && *least <= Q::try_from(*high)?);
                prop_assert_eq!(event.turn, exact.turn);
            }
        }
        let trends: Vec<Ordering> = found.runs().iter().map(|run| run.trend).collect();
        prop_assert_eq!(trends, expected.runs().iter().map(|run| run.trend).collect::<Vec<_>>());
    }

    #[test]
    fn fine_tuning_keeps_inflections(c in curve::<2>(SMOOTH.of_degree(2, 3).few(1)), alpha in function(SMOOTH.of_degree(1, 2).few(1))) {
        // A positive α on the domain of the curve.
        let (a, b) = c.domain();
        let alpha = alpha.reparametrised(a, b)?;
        let positive = alpha.coeffs().iter().map(|c| c.abs() + Q::frac(1, 3)).collect();
        let tuned = c.fine_tuned(&Function::new(alpha.space().clone(), positive)?)?;
        let places = |profile: &CurvatureProfile<Q>| {
            let inflections = profile.events().iter().filter(|event| event.kind == EventKind::Inflection);
            inflections.map(|event| event.place.clone()).filter(|place| {
                // A seam that was closed may be open now.
                place.bounds().0 > a
            }).collect::<Vec<_>>()
        };
        let (before, after) = (places(&c.profile()?), places(&tuned.profile()?));
        prop_assert_eq!(before.len(), after.len());
        for (one, other) in before.iter().zip(&after) {
            let ((low, high), (least, most)) = (one.bounds(), other.bounds());
            prop_assert!(low <= most && least <= high);
        }
    }

    #[test]
    fn gentle_scales_keep_the_sequence_of_events(by in proptest::collection::vec(-20_i64..=20, 3)) {
        // α within a fiftieth of 1; the wave has simple extrema only.
        let wave = bezier(&[[0, 0], [1, 2], [2, -2], [3, 0]]);
        let alpha = by.iter().map(|by| Q::int(1) + Q::frac(*by, 1000)).collect();
        let alpha = Function::new(SplineSpace::bezier(2, Q::int(0), Q::int(1))?, alpha)?;
        prop_assert_eq!(wave.profile()?.differs_at(&wave.fine_tuned(&alpha)?.profile()?), None);
    }

    #[test]
    fn typical_curves_are_monotone(degree in 2_usize..=5, stretch in 13_i64..=20) {
        // Each leg of the control polygon is the one before, turned by the angle of 3, 4, 5 and stretched by 1.3 to 2, more than 5 / 4:
        // then the curvature falls all the way [Mineur, Lichah, Castelain and Giaume, 1998].
        let (mut leg, mut point) = (vector![Q::int(1), Q::int(0)], vector![Q::int(0), Q::int(0)]);
        let mut points = vec![point.clone()];
        for _ in 0..degree {
            point = &point + &leg;
            points.push(point.clone());
            leg = vector![&leg[0] * Q::frac(4, 5) - &leg[1] * Q::frac(3, 5), &leg[0] * Q::frac(3, 5) + &leg[1] * Q::frac(4, 5)]
                .map(|x| x * Q::frac(stretch, 10));
        }
        let c = Curve::new(SplineSpace::bezier(degree, Q::int(0), Q::int(1))?, points)?;
        let profile = c.profile()?;
        prop_assert_eq!(profile.trend_on(&Q::int(0), &Q::int(1))?, Some(Ordering::Less));
        prop_assert_eq!(profile.events().len(), 0);
        prop_assert_eq!(profile.runs().len(), 1);
    }
}

#[test]
fn strong_scales_make_extrema() {
    let arch = bezier(&[[0, 0], [1, 2], [2, 0]]);
    let space = SplineSpace::bezier(2, Q::int(0), Q::int(1)).expect("a domain");
    let alpha = Function::new(space, [1, 20, 1].map(Q::int).to_vec()).expect("three values");
    let tuned = arch.fine_tuned(&alpha).and_then(|tuned| tuned.profile()).expect("a profile");
    assert_eq!(kinds(&arch.profile().expect("a profile")), [EventKind::Minimum]);
    assert!(tuned.events().len() > 1 && arch.profile().expect("a profile").differs_at(&tuned).is_some());
}

#[test]
fn circles_have_no_events() {
    let exact = circle(&vector![Q::int(1), Q::int(2)], &Q::int(3)).expect("a circle");
    let profile = exact.profile().expect("a profile");
    assert!(profile.events().is_empty());
    assert_eq!(profile.trend_on(&Q::int(0), &Q::int(1)), Ok(Some(Ordering::Equal)));
    let line = bezier(&[[0, 0], [1, 2], [2, 4], [3, 6]]).profile().expect("a profile");
    assert!(line.events().is_empty());
}

#[test]
fn ellipses_have_four_vertices() {
    let centre = vector![Q::int(0), Q::int(0)];
    for (long, short) in [(3, 1), (1, 3), (1001, 1000)] {
        let ellipse = ellipse(&centre, &vector![Q::int(long), Q::int(0)], &vector![Q::int(0), Q::int(short)]);
        let profile = ellipse.and_then(|ellipse| ellipse.profile()).expect("a profile");
        assert_eq!((profile.count(EventKind::Maximum), profile.count(EventKind::Minimum)), (2, 2));
        assert_eq!(profile.events().len(), 4);
        let quarters = profile.events().iter().map(|event| event.place.clone());
        assert!(quarters.zip(0..).all(|(place, i)| place == Place::At(RootValue::Exact(Q::frac(i, 4)))));
    }
}

#[test]
fn the_cardioid_has_one_cusp() {
    // -4 t² (1 + i t)² / (1 + t²)², its cusp in 0.
    let cardioid = rational(&[0, 0, -4, 0, 4], &[0, 0, 0, -8], &[1, 0, 2, 0, 1]);
    let profile = cardioid.profile().expect("a profile");
    assert_eq!(kinds(&profile), [EventKind::Cusp]);
    assert_eq!(profile.events()[0].place, Place::At(RootValue::Exact(Q::int(0))));
    assert_eq!(profile.events()[0].turn, std::f64::consts::PI);
}

#[test]
fn standing_still_is_no_cusp_unless_the_curve_turns_back() {
    // (t², t³) turns back in 0, (t³, t⁶) does not.
    let cusp = rational(&[0, 0, 1], &[0, 0, 0, 1], &[1]).profile().expect("a profile");
    assert_eq!(kinds(&cusp), [EventKind::Cusp]);
    let slow = rational(&[0, 0, 0, 1], &[0, 0, 0, 0, 0, 0, 1], &[1]).profile().expect("a profile");
    assert_eq!(slow.count(EventKind::Stationary), 1);
    assert_eq!(slow.count(EventKind::Cusp), 0);
    // A segment there and back.
    let back = bezier(&[[0, 0], [2, 0], [0, 0]]).profile().expect("a profile");
    assert_eq!(back.count(EventKind::Cusp), 2, "in the middle, and where it is closed");
}

#[test]
fn knots_are_told_apart() {
    // A corner in 1, a jump of the curvature in 2 (quadratic on both sides), a gap in 3.
    let points = [[0, 0], [0, 2], [2, 2], [4, 2], [4, 4], [4, 6], [0, 8], [9, 9], [9, 0], [0, 0]];
    let knots = [0, 0, 0, 1, 1, 2, 3, 3, 3, 4, 4, 5, 5, 5].map(Q::int);
    let space = SplineSpace::new(2, knots).expect("knots ascend");
    let points = points.iter().map(|c| SVector::from(c.map(Q::int))).collect::<Vec<_>>();
    let dim = space.dim();
    let c = Curve::new(space, points.into_iter().cycle().take(dim).collect()).expect("as many points");
    let profile = c.profile().expect("a profile");
    let at = |x: i64| {
        let here =
            profile.events().iter().filter(|event| event.place == Place::At(RootValue::Exact(Q::int(x))));
        here.map(|event| event.kind).collect::<Vec<_>>()
    };
    assert!(at(2).contains(&EventKind::Jump));
    assert!(at(3).contains(&EventKind::Gap));
    assert!(at(4).contains(&EventKind::Corner));
}

#[test]
fn no_corner_is_too_small_and_no_straight_cusp_is_run_over() {
    let tiny = (0..200).fold(Q::int(1), |tiny, _| tiny / Q::int(10));
    let points =
        [[Q::int(0), Q::int(0)], [Q::int(1), Q::int(1)], [Q::int(2), Q::int(2) + tiny]].map(Into::into);
    let space = SplineSpace::clamped(1, [0, 1, 2].map(Q::int)).expect("knots ascend");
    let bent = Curve::<Q, 2>::new(space, points.to_vec()).expect("points").profile().expect("a profile");
    assert!(bent.count(EventKind::Corner) == 1 && bent.events()[0].turn > 0.0 && bent.runs().len() == 2);
    let back = bezier(&[[0, 0], [3, 0], [1, 0]]).profile().expect("a profile");
    assert_eq!((back.count(EventKind::Cusp), back.runs().len()), (1, 2));
    assert_eq!(back.trend_on(&Q::int(0), &Q::int(1)).expect("in the domain"), None);
}

#[test]
fn hostile_curves_are_answered() {
    let space = |p| SplineSpace::clamped(p, [0.0, 0.25, 1.0]).expect("knots ascend");
    for size in [0.0, 1e-310, 1e-300, 1e-13, 1.0, 1e10, 1e150, 1e300] {
        for p in 0..=4 {
            let points: Vec<_> =
                (0..p + 2).map(|i| vector![size * (i as f64).sin(), size * (3.0 * i as f64).cos()]).collect();
            let c = Curve::new(space(p), points).expect("finite points");
            let profile = c.profile().expect("a profile");
            let exact = c.to_exact().and_then(|c| c.profile()).expect("a profile");
            assert_eq!(kinds(&profile), kinds(&exact), "size {size:e}, degree {p}");
        }
    }
}

#[test]
fn a_fitted_clothoid_is_monotone() {
    // κ = s: x = ∫ cos(s²/2) ds, y = ∫ sin(s²/2) ds, by Simpson's rule on short steps.
    let (start, end, count) = (0.25, 1.75, 600);
    let step = (end - start) / f64::from(count);
    let direction = |s: f64| vector![(s * s / 2.0).cos(), (s * s / 2.0).sin()];
    let mut points = vec![vector![0.0, 0.0]];
    for i in 0..count {
        let s = start + step * f64::from(i);
        let rule = direction(s) + direction(s + step / 2.0) * 4.0 + direction(s + step);
        points.push(points[points.len() - 1] + rule * (step / 6.0));
    }
    let parameters: Vec<f64> = (0..=count).map(|i| start + step * f64::from(i)).collect();
    let space = SplineSpace::uniform(5, 6, start, parameters[points.len() - 1]).expect("a domain");
    let fit = Curve::least_squares(&space, &parameters, &points, Ends::Held).expect("enough points");
    let profile = fit.profile().expect("a profile");
    assert!(profile.events().is_empty(), "{:?}", profile.events());
    assert_eq!(profile.trend_on(fit.domain().0, fit.domain().1), Ok(Some(Ordering::Greater)));
    // Its logarithmic curvature graph is a line of slope -1: ρ = 1 / s, and ρ ds/dρ = -s.
    // The slope of the curvature is that of the third derivatives, which the fit has to some parts in a thousand.
    assert!(profile.log_log().iter().all(|[x, y]| (x + y).abs() < 0.02));
    let total = (end * end - start * start) / 2.0;
    let found = fit.total_curvature(1e-9).expect("bounds");
    assert!((found.low - total).abs() < 1e-4 && found.high - found.low < 1e-9);
}
