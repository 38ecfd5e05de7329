//! Laws of intersections of plane curves, over `f64`: both curves pass each meeting, and the number of meetings is that
//! of an independent count.

use crate::strategies::cases;
use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{
    Certainty, Curve, Error, Function, Intersections, Meeting, NurbsCurve, Passage, Q, Result, Spline,
    SplineSpace, circle, segment,
};

const TOLERANCE: f64 = 1e-9;

/// Points of curves of unit size lie nearer to each other than this.
const CLOSE: f64 = 1e-12;

type Point = SVector<f64, 2>;

fn bezier(points: Vec<Point>) -> Curve<f64, 2> {
    Curve::new(SplineSpace::bezier(points.len() - 1, 0.0, 1.0).expect("a valid spline"), points)
        .expect("a valid spline")
}

/// The graph `(x, f(x))`.
fn graph(f: &Function<f64>) -> Curve<f64, 2> {
    let points = f.space().greville().iter().zip(f.coeffs()).map(|(x, y)| vector![*x, *y]).collect();
    Curve::new(f.space().clone(), points).expect("a valid spline")
}

fn coordinate() -> impl Strategy<Value = f64> {
    (-64_i32..=64).prop_map(|n| f64::from(n) / 64.0)
}

fn point() -> impl Strategy<Value = Point> {
    [coordinate(), coordinate()].prop_map(|[x, y]| vector![x, y])
}

/// Clamped, unclamped and periodic curves of degree 1 to 5.
fn curve() -> impl Strategy<Value = Curve<f64, 2>> {
    (1_usize..=5, 1_usize..=4, 0..3, vec(point(), 16)).prop_map(|(p, spans, shape, points)| {
        let space = match shape {
            0 => SplineSpace::uniform(p, spans, 0.0, 2.0),
            1 => SplineSpace::new(p, (0..2 * p + 1 + spans).map(|i| i as f64)),
            _ => SplineSpace::uniform_periodic(p, spans + 2, -1.0, 1.0),
        };
        let space = space.expect("a valid spline");
        let dim = space.dim();
        Curve::new(space, points[..dim].to_vec()).expect("a valid spline")
    })
}

fn rational() -> impl Strategy<Value = NurbsCurve<f64, 2>> {
    (curve(), vec(0.25..4.0, 16)).prop_map(|(curve, weights)| {
        let dim = curve.coeffs().len();
        NurbsCurve::new(curve.space().clone(), curve.coeffs().to_vec(), weights[..dim].to_vec())
            .expect("a valid spline")
    })
}

/// Checks what holds for every answer; `at` and `other` give points of the two curves.
fn is_sound(
    found: &Intersections,
    at: impl Fn(f64) -> Result<Point>,
    other: impl Fn(f64) -> Result<Point>,
) -> std::result::Result<(), TestCaseError> {
    for m in &found.meetings {
        let [s, t] = m.parameters;
        let bound = if m.certainty == Certainty::Proved { CLOSE } else { 4.0 * TOLERANCE };
        prop_assert!((at(s)? - m.point).norm() <= bound, "{m:?} is not on the first");
        prop_assert!((other(t)? - m.point).norm() <= bound, "{m:?} is not on the second");
        if m.certainty == Certainty::Proved {
            prop_assert!((0..2).all(|k| m.ranges[k].1 - m.ranges[k].0 < 1e-6), "{m:?}");
        }
    }
    for overlap in &found.overlaps {
        for (s, t) in [(overlap.first.0, overlap.second.0), (overlap.first.1, overlap.second.1)] {
            prop_assert!((at(s)? - other(t)?).norm() <= 1e-8, "{overlap:?}");
        }
    }
    Ok(())
}

/// Where chords of two curves cross, each of `n` equal steps over the window given.
fn sampled(
    (one, other): (&Curve<f64, 2>, &Curve<f64, 2>),
    windows: [(f64, f64); 2],
    n: usize,
) -> Vec<(f64, f64)> {
    let samples = |c: &Curve<f64, 2>, (a, b): (f64, f64)| -> Vec<(f64, Point)> {
        let parameters = (0..=n).map(|i| (a + (b - a) * i as f64 / n as f64).clamp(a, b));
        parameters.map(|x| (x, c.at(&x).expect("a valid spline"))).collect()
    };
    let (p, q) = (samples(one, windows[0]), samples(other, windows[1]));
    let side = |a: &Point, b: &Point, c: &Point| (b - a).perp(&(c - a));
    let mut found = Vec::new();
    for a in p.windows(2) {
        for b in q.windows(2) {
            let crosses = |a: &[(f64, Point)], b: &[(f64, Point)]| {
                side(&a[0].1, &a[1].1, &b[0].1) * side(&a[0].1, &a[1].1, &b[1].1) < 0.0
            };
            if crosses(a, b) && crosses(b, a) {
                found.push(((a[0].0 + a[1].0) / 2.0, (b[0].0 + b[1].0) / 2.0));
            }
        }
    }
    found
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn meetings_lie_on_both(f in curve(), g in curve(), r in rational(), s in rational()) {
        is_sound(&f.intersections(&g, &TOLERANCE)?, |x| f.at(&x), |x| g.at(&x))?;
        is_sound(&f.intersections(&r, &TOLERANCE)?, |x| f.at(&x), |x| r.at(&x))?;
        is_sound(&r.intersections(&f, &TOLERANCE)?, |x| r.at(&x), |x| f.at(&x))?;
        is_sound(&r.intersections(&s, &TOLERANCE)?, |x| r.at(&x), |x| s.at(&x))?;
    }

    #[test]
    fn no_crossing_is_dropped(f in curve(), g in curve()) {
        let found = f.intersections(&g, &TOLERANCE)?;
        prop_assume!(found.is_proved());
        // Chords may cross where the curves do not: look closer.
        let chords = sampled((&f, &g), [f.domain(), g.domain()].map(|(a, b)| (*a, *b)), 80);
        let closer = |(s, t): (f64, f64)| {
            let around = |c: &Curve<f64, 2>, x: f64| {
                let (a, b) = (*c.domain().0, *c.domain().1);
                let step = (b - a) / 80.0;
                ((x - step).max(a), (x + step).min(b))
            };
            let windows = [around(&f, s), around(&g, t)];
            !sampled((&f, &g), windows, 400).is_empty()
        };
        for (s, t) in chords.into_iter().filter(|place| closer(*place)) {
            let near = |m: &&Meeting| {
                (m.point - f.at(&s).expect("a valid spline")).norm() < 0.25 && (m.point - g.at(&t).expect("a valid spline")).norm() < 0.25
            };
            prop_assert!(found.meetings.iter().any(|m| near(&m)), "none near {s}, {t} in {found:?}");
        }
    }

    #[test]
    fn the_arguments_are_symmetric(f in curve(), g in rational()) {
        let (one, other) = (f.intersections(&g, &TOLERANCE)?, g.intersections(&f, &TOLERANCE)?);
        prop_assert_eq!(one.meetings.len(), other.meetings.len());
        prop_assert_eq!(one.overlaps.len(), other.overlaps.len());
        for m in &one.meetings {
            let same = |n: &&Meeting| (m.point - n.point).norm() < 4.0 * TOLERANCE && m.certainty == n.certainty;
            prop_assert!(other.meetings.iter().any(|n| same(&n)), "{m:?}");
        }
    }

    #[test]
    fn other_forms_meet_at_the_same_points(f in curve(), g in curve(), x in 0.1..0.9_f64) {
        let found = f.intersections(&g, &TOLERANCE)?;
        prop_assume!(found.is_proved());
        let (a, b) = (*f.domain().0, *f.domain().1);
        let forms = [f.reversed()?, f.inserted(&[a + x * (b - a)])?, f.elevated(1)?];
        for form in forms {
            let other = form.intersections(&g, &TOLERANCE)?;
            prop_assert_eq!(found.meetings.len(), other.meetings.len());
            for m in &found.meetings {
                prop_assert!(other.meetings.iter().any(|n| (m.point - n.point).norm() < 1e-11), "{m:?}");
            }
        }
        let exact = NurbsCurve::from_polynomial(&f)?.intersections(&g, &TOLERANCE)?;
        prop_assert_eq!(found.meetings.len(), exact.meetings.len());
    }

    #[test]
    fn affine_maps_move_the_meetings(f in curve(), g in curve(), angle in 0.0..6.0_f64, by in point()) {
        let found = f.intersections(&g, &TOLERANCE)?;
        prop_assume!(found.is_proved());
        let map = |c: &Point| {
            let (sin, cos) = angle.sin_cos();
            vector![cos * c[0] - sin * c[1], 2.0 * sin * c[0] + 2.0 * cos * c[1]] + by
        };
        let mapped = |c: &Curve<f64, 2>| {
            Curve::new(c.space().clone(), c.coeffs().iter().map(map).collect())
        };
        let other = mapped(&f)?.intersections(&mapped(&g)?, &TOLERANCE)?;
        prop_assert_eq!(found.meetings.len(), other.meetings.len());
        for m in &found.meetings {
            let image = map(&m.point);
            prop_assert!(other.meetings.iter().any(|n| (image - n.point).norm() < 1e-11), "{m:?}");
        }
    }

    #[test]
    fn graphs_meet_at_the_roots_of_their_difference(
        roots in vec(1_i64..=31, 1..=5), base in vec(-4_i64..=4, 6), scale in 1_i64..=4,
    ) {
        // f - g is a product of linear factors with known roots, made exactly.
        let mut roots = roots;
        roots.sort_unstable();
        roots.dedup();
        let q = |n: i64, d: i64| Q::try_from(n as f64 / d as f64).expect("a valid spline");
        let space = SplineSpace::bezier(1, q(0, 1), q(1, 1))?;
        let factor = |n: &i64| Function::new(space.clone(), vec![q(-n, 32), q(32 - n, 32)]).expect("a valid spline");
        let product = roots.iter().map(factor).reduce(|f, g| &f * &g).expect("a valid spline").scaled(&q(8 * scale, 1))?;
        let p = product.degree();
        let f = Spline::new(SplineSpace::bezier(p, q(0, 1), q(1, 1))?, base[..=p].iter().map(|n| q(*n, 4)).collect())?;
        let g = f.difference(&product)?;
        let (f, g) = (graph(&f.to_f64()?), graph(&g.to_f64()?));
        let found = f.intersections(&g, &TOLERANCE)?;
        prop_assert!(found.overlaps.is_empty());
        prop_assert_eq!(found.meetings.len(), roots.len(), "{:?} {:?}", roots, found);
        for (m, root) in found.meetings.iter().zip(&roots) {
            let x = *root as f64 / 32.0;
            prop_assert_eq!(m.certainty, Certainty::Proved);
            prop_assert!(m.ranges.iter().all(|r| r.0 <= x && x <= r.1), "{m:?} does not enclose {x}");
            prop_assert!((m.point[0] - x).abs() < 1e-11);
        }
    }

    #[test]
    fn nearly_double_roots_are_told_apart(middle in 0.2..0.8_f64, exponent in -5.5..-1.0_f64, up in coordinate()) {
        // y = (x - middle)² - gap² and a line, both moved up.
        let gap = 10.0_f64.powf(exponent);
        let square = [middle * middle, middle * middle - middle, (1.0 - middle).powi(2)];
        let parabola = bezier((0..3).map(|i| vector![i as f64 / 2.0, square[i] - gap * gap + up]).collect());
        let line = bezier(vec![vector![-0.5, up], vector![1.5, up]]);
        let found = parabola.intersections(&line, &TOLERANCE)?;
        let roots = [middle - gap, middle + gap];
        let inside = roots.iter().filter(|x| (0.0..=1.0).contains(*x)).count();
        prop_assert_eq!(found.meetings.len(), inside, "{:?}", found);
        prop_assert!(found.is_proved());
        for m in &found.meetings {
            prop_assert!(roots.iter().any(|x| (m.parameters[0] - x).abs() < 1e-13 / gap), "{m:?}");
        }
    }

    #[test]
    fn tangent_contacts_are_found_once(middle in 0.0..=1.0_f64, order in 2_usize..=4, turn in 0.0..6.0_f64) {
        // y = (x - middle)^order, turned, and its tangent.
        let line = |a: f64, b: f64| Function::new(SplineSpace::bezier(1, 0.0, 1.0).expect("a valid spline"), vec![a, b]).expect("a valid spline");
        let factor = line(-middle, 1.0 - middle);
        let power = (1..order).fold(factor.clone(), |f, _| &f * &factor);
        let (sin, cos) = turn.sin_cos();
        let turned = |c: &Point| vector![cos * c[0] - sin * c[1], sin * c[0] + cos * c[1]];
        let curve = bezier(graph(&power).coeffs().iter().map(turned).collect());
        let tangent = bezier(vec![turned(&vector![-1.0, 0.0]), turned(&vector![2.0, 0.0])]);
        let found = curve.intersections(&tangent, &TOLERANCE)?;
        prop_assert_eq!(found.meetings.len(), 1, "{:?}", found);
        let m = &found.meetings[0];
        prop_assert!(m.certainty == Certainty::Contact);
        prop_assert!(m.ranges[0].0 <= middle + 1e-12 && middle - 1e-12 <= m.ranges[0].1, "{m:?}");
        prop_assert!((m.parameters[0] - middle).abs() < 1e-3, "{m:?}");
    }

    #[test]
    fn circles_meet_where_they_should(x in -3.0..3.0_f64, y in -3.0..3.0_f64, radius in 0.2..2.0_f64) {
        let one = circle(&vector![0.0, 0.0], &1.0)?;
        let other = circle(&vector![x, y], &radius)?;
        let d = x.hypot(y);
        prop_assume!((d - (1.0 + radius)).abs() > 1e-6 && (d - (1.0 - radius).abs()).abs() > 1e-6);
        let meets = d < 1.0 + radius && d > (1.0 - radius).abs();
        let found = one.intersections(&other, &TOLERANCE)?;
        prop_assert!(found.is_proved());
        prop_assert_eq!(found.meetings.len(), if meets { 2 } else { 0 }, "{:?}", found);
        for m in &found.meetings {
            prop_assert!((m.point.norm() - 1.0).abs() < 1e-12);
            prop_assert!(((m.point - vector![x, y]).norm() - radius).abs() < 1e-12);
            prop_assert_eq!(m.passage, Passage::Crosses);
        }
    }

    #[test]
    fn curves_through_a_knot_meet_there_once(f in curve(), angle in 0.0..3.0_f64, which in 0_usize..5) {
        // A segment through a point at a knot: no matter on which side rounding puts it.
        let breaks = f.space().breaks();
        let x = breaks[which % breaks.len()].0;
        let c = f.at(&x)?;
        let arm = vector![angle.cos(), angle.sin()] * 0.05;
        let found = f.intersections(&segment(&(c - arm), &(c + arm))?, &TOLERANCE)?;
        let here = |m: &&Meeting| (m.point - c).norm() < 1e-7;
        let ways = found.meetings.iter().filter(here).count();
        let overlaps = found.overlaps.len();
        prop_assert!(ways > 0 || overlaps > 0, "{found:?}");
        // Another part of the curve may pass there, too, but at another parameter.
        for m in found.meetings.iter().filter(here) {
            for n in found.meetings.iter().filter(here) {
                prop_assert!(m == n || (m.parameters[0] - n.parameters[0]).abs() > 1e-6, "{found:?}");
            }
        }
    }

    #[test]
    fn parts_of_one_curve_overlap(
        f in curve(), ends in [0.0..1.0_f64, 0.0..1.0, 0.0..1.0, 0.0..1.0], elevate in 0_usize..2, turn in any::<bool>(),
    ) {
        let (a, b) = (*f.domain().0, *f.domain().1);
        let mut ends = ends.map(|x| a + (b - a) * (x * 32.0).round() / 32.0);
        ends[..2].sort_by(f64::total_cmp);
        ends[2..].sort_by(f64::total_cmp);
        prop_assume!(ends[0] < ends[1] && ends[2] < ends[3]);
        let one = f.restricted(&ends[0], &ends[1])?;
        let other = f.restricted(&ends[2], &ends[3])?.elevated(elevate)?;
        let other = if turn { other.reversed()? } else { other };
        let found = one.intersections(&other, &TOLERANCE)?;
        let common = (ends[0].max(ends[2]), ends[1].min(ends[3]));
        // The stretch on the diagonal.
        let image = |x: f64| if turn { ends[2] + ends[3] - x } else { x };
        let size = one.control_box().1 - one.control_box().0;
        prop_assume!(size.norm() > 1e-3);
        // Where the curve runs over itself there are more.
        let covered = |x: f64| found.overlaps.iter().any(|o| {
            let along = (o.first.1 - o.first.0).abs();
            let at = |x: f64| o.second.0 + (o.second.1 - o.second.0) * (x - o.first.0) / along;
            o.first.0 <= x + 1e-7 && x - 1e-7 <= o.first.1 && (at(x) - image(x)).abs() < 1e-6
        });
        if common.0 < common.1 {
            let stands = |x: f64| (f.derivative_at(&x, 1).expect("a valid spline")).norm() < 1e-2;
            let samples = (0..=16).map(|i| common.0 + (common.1 - common.0) * f64::from(i) / 16.0);
            for x in samples {
                prop_assert!(stands(x) || covered(x), "{x} of {common:?} is not in {found:?}");
            }
        }
    }
}

#[test]
fn bad_tolerances_are_refused() {
    let line = bezier(vec![vector![0.0, 0.0], vector![1.0, 1.0]]);
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(line.intersections(&line, &tolerance), Err(Error::BadTolerance { .. })));
    }
}

#[test]
fn sizes_do_not_matter() {
    let wave = [[0.0, 0.0], [0.5, 10.0 / 3.0], [0.5, -7.0 / 3.0], [1.0, 1.0]];
    for size in [1e-300, 1e-150, 1e150, 1e300] {
        let one = bezier(wave.iter().map(|c| vector![c[0], c[1]] * size).collect());
        let other = bezier(wave.iter().map(|c| vector![c[1], c[0]] * size).collect());
        let found = one.intersections(&other, &(1e-9 * size)).expect("a valid spline");
        assert_eq!((found.meetings.len(), found.is_proved()), (9, true), "{size:e}");
    }
}

#[test]
fn hostile_curves_end_soon() {
    let random = |i: usize| ((i as f64 * 12.9898).sin() * 43_758.547).fract();
    let wild = |p: usize, spans: usize, seed: usize| {
        let space = SplineSpace::uniform(p, spans, 0.0, 1.0).expect("a space");
        let points =
            (0..space.dim()).map(|i| vector![random(2 * i + seed), random(2 * i + 1 + seed)]).collect();
        Curve::new(space, points).expect("a curve")
    };
    let line = |a: f64, b: f64| bezier(vec![vector![a, 0.0], vector![b, 0.0]]);
    let shifted = |c: &Curve<f64, 2>| c.translated(&vector![0.0, 1e-8]).expect("a curve");
    let zigzag = bezier((0..40).map(|i| vector![f64::from(i % 2), 0.0]).collect());
    let (high, scribble) = (wild(12, 1, 0), wild(3, 8, 7));
    for (one, other) in [
        (wild(0, 50, 0), wild(0, 50, 0)),
        (high.clone(), wild(12, 1, 999)),
        (high.clone(), shifted(&high)),
        (scribble.clone(), wild(3, 8, 555)),
        (scribble.clone(), shifted(&scribble)),
        (zigzag.clone(), line(0.0, 1.0)),
        (zigzag.clone(), zigzag),
    ] {
        for tolerance in [1e-9, 1e300] {
            match one.intersections(&other, &tolerance) {
                Ok(found) => assert!(found.meetings.iter().all(|m| m.point.iter().all(|x| x.is_finite()))),
                Err(error) => assert!(matches!(error, Error::TooLarge { .. }), "{error}"),
            }
        }
    }
}

#[test]
fn lines_on_lines() {
    let line = |a: f64, b: f64| bezier(vec![vector![a, 2.0 * a], vector![b, 2.0 * b]]);
    let count = |one: &Curve<f64, 2>, other: &Curve<f64, 2>| {
        let found = one.intersections(other, &TOLERANCE).expect("an answer");
        (found.meetings.len(), found.overlaps)
    };
    let (meetings, overlaps) = count(&line(0.0, 2.0), &line(3.0, 1.0));
    assert_eq!((meetings, overlaps.len()), (0, 1));
    assert!((overlaps[0].first.0 - 0.5).abs() < 1e-14 && overlaps[0].first.1 == 1.0);
    assert!(overlaps[0].second.0 == 1.0 && (overlaps[0].second.1 - 0.5).abs() < 1e-14);
    assert_eq!(count(&line(0.0, 1.0), &line(1.0, 2.0)).0, 1);
    assert_eq!(count(&line(0.0, 1.0), &line(1.1, 2.0)), (0, vec![]));
    // A line that turns back covers another twice, and a point lies on it or not.
    let back = bezier(vec![vector![0.0, 0.0], vector![2.0, 4.0], vector![0.0, 0.0]]);
    assert_eq!(count(&line(-1.0, 3.0), &back).1.len(), 2);
    assert_eq!(count(&line(-1.0, 3.0), &line(0.5, 0.5)).0, 1);
    assert_eq!(count(&line(0.0, 1.0), &line(1.5, 1.5)).0, 0);
}

#[test]
fn corners_touch_or_are_crossed() {
    let space = SplineSpace::clamped(1, [0.0, 1.0, 2.0]).expect("a space");
    let corner =
        Curve::new(space, vec![vector![-1.0, 1.0], vector![0.0, 0.0], vector![1.0, 1.0]]).expect("a curve");
    let passages = |a: [f64; 2], b: [f64; 2]| -> Vec<Passage> {
        let found = corner.intersections(&bezier(vec![a.into(), b.into()]), &TOLERANCE).expect("an answer");
        found.meetings.iter().map(|m| m.passage).collect()
    };
    assert_eq!(passages([-1.0, 0.0], [1.0, 0.0]), [Passage::Touches]);
    assert_eq!(passages([0.0, -1.0], [0.0, 1.0]), [Passage::Crosses]);
    assert_eq!(passages([0.0, 0.0], [0.0, 1.0]), [Passage::Ends]);
}

#[test]
fn a_loop_meets_itself_at_its_node() {
    let knot = bezier(vec![vector![0.0, 0.0], vector![2.0, 1.0], vector![-1.0, 1.0], vector![1.0, 0.0]]);
    let found = knot.intersections(&knot, &TOLERANCE).expect("an answer");
    assert_eq!((found.meetings.len(), found.overlaps.len()), (2, 1), "{found:?}");
    let [one, other] = [0, 1].map(|i| found.meetings[i].parameters);
    assert!((one[0] - other[1]).abs() < 1e-12 && (one[1] - other[0]).abs() < 1e-12 && one[0] < one[1] - 0.1);
}

#[test]
fn ends_of_overlaps_are_no_meetings() {
    let space = SplineSpace::uniform(3, 4, 0.0, 4.0).expect("a space");
    let points = (0..7).map(|i| vector![f64::from(i), f64::from(i * i % 5)]).collect();
    let curve = Curve::new(space, points).expect("a curve");
    for (a, b) in [(0.0, 4.0), (0.0, 2.5), (0.75, 4.0), (1.0, 3.0), (1.25, 2.75)] {
        let part = curve.restricted(&a, &b).expect("a part");
        let found = curve.intersections(&part, &TOLERANCE).expect("an answer");
        assert_eq!((found.meetings.len(), found.overlaps.len()), (0, 1), "{found:?}");
        let overlap = &found.overlaps[0];
        assert!((overlap.first.0 - a).abs() < 1e-12 && (overlap.first.1 - b).abs() < 1e-12);
        assert!((overlap.second.0 - a).abs() < 1e-12 && (overlap.second.1 - b).abs() < 1e-12);
    }
}

#[test]
fn what_rounding_hides_is_not_proved() {
    // y = (x - 1/2)² - h and y = 0: the roots are nearer than the coefficients can tell.
    for h in [1e-17, 1e-15, -1e-16] {
        let parabola = bezier(vec![vector![0.0, 0.25 - h], vector![0.5, -0.25 - h], vector![1.0, 0.25 - h]]);
        let axis = bezier(vec![vector![-1.0, 0.0], vector![2.0, 0.0]]);
        let found = parabola.intersections(&axis, &TOLERANCE).expect("an answer");
        let contacts: Vec<_> = found.meetings.iter().map(|m| m.certainty).collect();
        assert_eq!(contacts, [Certainty::Contact], "{h:e}");
    }
}
