//! Laws of conics: implicit equations as identities over `Q`.

use crate::strategies::{cases, number, point, probes};
use nalgebra::{SVector, vector};
use proptest::prelude::*;
use symspline::{
    Coeff, Error, Function, NurbsCurve, Q, RationalFunction, Scalar, Weighted, arc, arc_by_angles, circle,
    conic, ellipse, segment,
};

type Point = SVector<Q, 2>;

/// A number that is not zero.
fn length() -> impl Strategy<Value = Q> {
    number().prop_filter("not zero", |q| *q != Q::int(0))
}

fn dot<const N: usize>(c: &SVector<Q, N>, d: &SVector<Q, N>) -> Q {
    Q::dot(c.iter().zip(d.iter()))
}

fn cross(c: &Point, d: &Point) -> Q {
    c[0].clone() * &d[1] - c[1].clone() * &d[0]
}

/// `point` turned by the angle with tangent of a half `h` and then by quarters.
fn turned(point: &Point, h: &Q, quarters: usize) -> Point {
    let below = Q::int(1) + h.clone() * h;
    let (cos, sin) = ((Q::int(1) - h.clone() * h) / &below, Q::int(2) * h / below);
    let rotated =
        vector![cos.clone() * &point[0] - sin.clone() * &point[1], sin * &point[0] + cos * &point[1]];
    (0..quarters).fold(rotated, |p, _| vector![-p[1].clone(), p[0].clone()])
}

/// The tangent of half an angle from zero, inclusive, to a quarter, exclusive.
fn half_tangent() -> impl Strategy<Value = Q> {
    prop_oneof![
        2 => Just(Q::int(0)),
        8 => (0_i64..50, 50_i64..80).prop_map(|(p, q)| Q::frac(p, q)),
        1 => Just(Q::frac(1, 1_000_000_007)),
        1 => Just(Q::frac(999_999, 1_000_000)),
    ]
}

/// The curve keeps a squared distance from the centre, as an identity.
fn is_round<const N: usize>(
    curve: &NurbsCurve<Q, N>,
    centre: &SVector<Q, N>,
    square: &Q,
) -> Result<(), TestCaseError> {
    let moved = curve.translated(&-centre.clone())?;
    let squares = moved.dot(&moved)?;
    let level = Function::constant(squares.space().clone(), square.clone())?;
    prop_assert!(squares.same_function(&RationalFunction::from_polynomial(&level)?)?);
    for x in probes(curve.space()) {
        let c = curve.at(&x)? - centre;
        prop_assert_eq!(&dot(&c, &c), square);
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn a_circle_is_round_and_closed(centre in point::<2>(), radius in length()) {
        let round = circle(&centre, &radius)?;
        is_round(&round, &centre, &(radius.clone() * &radius))?;
        let ends = [Q::int(0), Q::int(1)].map(|x| round.at(&x).unwrap());
        prop_assert_eq!(&ends[0], &ends[1]);
        prop_assert_eq!(&ends[0], &(centre.clone() + vector![radius.clone(), Q::int(0)]));
        for (i, (x, y)) in [(1, 0), (0, 1), (-1, 0), (0, -1)].into_iter().enumerate() {
            let corner = vector![Q::int(x) * &radius, Q::int(y) * &radius];
            prop_assert_eq!(round.at(&Q::frac(i as i64, 4))?, &centre + corner);
        }
        for x in probes(round.space()) {
            let d = round.derivatives_at(&x, 1)?;
            prop_assert!(cross(&(d[0].clone() - &centre), &d[1]) > Q::int(0));
        }
    }

    #[test]
    fn an_ellipse_is_the_affine_image_of_the_unit_circle(
        centre in point::<3>(), a in point::<3>(), b in point::<3>(),
    ) {
        let image = ellipse(&centre, &a, &b)?;
        let unit = circle(&vector![Q::int(0), Q::int(0)], &Q::int(1))?;
        prop_assert_eq!(image.space(), unit.space());
        for x in probes(unit.space()) {
            let c = unit.at(&x)?;
            prop_assert_eq!(image.at(&x)?, &centre + a.scaled(&c[0]) + b.scaled(&c[1]));
        }
    }

    #[test]
    fn arcs_of_every_angle_are_round(
        centre in point::<2>(), arm in point::<2>(), half in half_tangent(), quarters in 0_usize..4,
    ) {
        prop_assume!(arm != vector![Q::int(0), Q::int(0)]);
        let end = turned(&arm, &half, quarters);
        let (from, to) = (&centre + &arm, &centre + &end);
        let arc = arc(&centre, &from, &to)?;
        is_round(&arc, &centre, &dot(&arm, &arm))?;
        prop_assert_eq!((arc.at(&Q::int(0))?, arc.at(&Q::int(1))?), (from, to));
        // Each begun quarter is one piece, nothing turned is the full circle.
        let whole = half == Q::int(0);
        let pieces = if whole && quarters == 0 { 4 } else { quarters + usize::from(!whole) };
        prop_assert_eq!(arc.space().spans().count(), pieces);
        prop_assert!(arc.weights().all(|w| *w > Q::int(0)));
        for x in probes(arc.space()) {
            let d = arc.derivatives_at(&x, 1)?;
            prop_assert!(cross(&(d[0].clone() - &centre), &d[1]) > Q::int(0), "clockwise at {}", x);
        }
        // All pieces but the last are quarters: so the sum of the angles is that of the ends.
        let at = |i: usize| arc.at(&Q::frac(i as i64, pieces as i64)).map(|c| c - &centre);
        for i in 1..pieces {
            prop_assert_eq!(at(i)?, turned(&arm, &Q::int(0), i));
        }
        let (before, last) = (at(pieces - 1)?, at(pieces)?);
        prop_assert!(cross(&before, &last) > Q::int(0) && dot(&before, &last) >= Q::int(0));
    }

    #[test]
    fn a_full_arc_is_the_circle(centre in point::<2>(), radius in (1_i64..99).prop_map(|n| Q::frac(n, 7))) {
        let right = &centre + vector![radius.clone(), Q::int(0)];
        prop_assert_eq!(arc(&centre, &right, &right)?, circle(&centre, &radius)?);
    }

    #[test]
    fn a_conic_has_its_implicit_equation(
        points in [point::<2>(), point::<2>(), point::<2>()], w in [1_i64..9, 1_i64..9, 1_i64..9],
    ) {
        let [p, q, r] = &points;
        let area = cross(&(q.clone() - p), &(r.clone() - p));
        prop_assume!(area != Q::int(0));
        let weights = w.map(Q::int);
        let curve = conic(&points, weights.clone())?;
        for x in (0..=12).map(|i| Q::frac(i, 12)) {
            let c = curve.at(&x)?;
            // Areas to the sides: barycentric coordinates.
            let a = cross(&(q.clone() - &c), &(r.clone() - &c)) / &area;
            let b = cross(&(r.clone() - &c), &(p.clone() - &c)) / &area;
            let d = cross(&(p.clone() - &c), &(q.clone() - &c)) / &area;
            let [w0, w1, w2] = &weights;
            prop_assert_eq!(b.clone() * &b * w0 * w2, Q::int(4) * a * d * w1 * w1);
        }
    }

    #[test]
    fn segments_run_evenly(from in point::<3>(), to in point::<3>(), n in 0_i64..=8) {
        let x = Q::frac(n, 8);
        let expected = from.scaled(&(Q::int(1) - &x)) + to.scaled(&x);
        prop_assert_eq!(segment(&from, &to)?.at(&x)?, expected);
    }

    #[test]
    fn points_at_other_distances_make_no_arc(centre in point::<2>(), arm in point::<2>(), more in length()) {
        let longer = arm.scaled(&(Q::int(1) + more.abs()));
        prop_assert_eq!(arc(&centre, &(&centre + &arm), &(&centre + longer)).unwrap_err(), Error::NotOnCircle);
    }
}

#[test]
fn an_arc_needs_a_radius() {
    let o = vector![Q::int(1), Q::int(2)];
    assert_eq!(arc(&o, &o, &o).unwrap_err(), Error::NotOnCircle);
    let o = vector![0.0, 0.0];
    for bad in [f64::NAN, f64::INFINITY, 1e200] {
        let found = [
            arc(&o, &vector![bad, 0.0], &vector![0.0, 1.0]),
            arc(&o, &vector![0.0, 1.0], &vector![0.0, bad]),
        ];
        for (index, found) in found.into_iter().enumerate() {
            assert_eq!(found.unwrap_err(), Error::NotFinite { what: "squared distance", index });
        }
    }
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(circle(&o, &bad).is_err() && conic(&[o, o, o], [1.0, bad, 1.0]).is_err());
    }
    assert!(matches!(conic(&[o, o, o], [1.0, 0.0, 1.0]), Err(Error::Weight { index: 1, .. })));
}

#[test]
fn the_ends_of_an_arc_are_those_given() {
    // So near the axis that the way to the centre and back is not exact.
    let (centre, end) = (vector![100.0, 0.0], vector![0.1, 0.0]);
    let full = arc(&centre, &end, &end).unwrap();
    let coeffs = full.lifted().coeffs();
    assert_eq!((&coeffs[0], &coeffs[8]), (&Weighted::new(&end, 1.0), &Weighted::new(&end, 1.0)));
}

/// How far the points are from the circle, in units of the last place of the numbers that go in.
fn eccentricity(curve: &NurbsCurve<f64, 2>, centre: &SVector<f64, 2>, radius: f64) -> f64 {
    let size = centre[0].abs().max(centre[1].abs()) + radius;
    let off = |i: i32| {
        let c = curve.at(&(f64::from(i) / 1000.0)).expect("inside the domain") - centre;
        (c[0].hypot(c[1]) - radius).abs() / (f64::EPSILON * size)
    };
    (0..=1000).map(off).fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn floating_circles_are_round_within_a_few_ulps(
        x in -100.0..100.0_f64, y in -100.0..100.0_f64, radius in 0.001..1000.0_f64,
    ) {
        let centre = vector![x, y];
        let found = eccentricity(&circle(&centre, &radius)?, &centre, radius);
        prop_assert!(found <= 8.0, "{}", found);
    }

    #[test]
    fn floating_arcs_are_round_within_a_few_ulps(
        x in -100.0..100.0_f64, y in -100.0..100.0_f64, radius in 0.001..1000.0_f64,
        start in 0.0..7.0_f64, angle in 0.01..6.2_f64,
    ) {
        let centre = vector![x, y];
        let at = |angle: f64| centre + vector![radius * angle.cos(), radius * angle.sin()];
        let (from, to) = (at(start), at(start + angle));
        // The ends are rounded: their distances are not quite the radius.
        prop_assume!(radius > 1.0);
        let curve = arc(&centre, &from, &to)?;
        // The ends are not rounded.
        let ends = [&curve.lifted().coeffs()[0], &curve.lifted().coeffs()[curve.space().dim() - 1]];
        prop_assert_eq!(ends[0], &Weighted::new(&from, 1.0));
        prop_assert_eq!(ends[1], &Weighted::new(&to, ends[1].weight));
        let found = eccentricity(&curve, &centre, radius);
        prop_assert!(found <= 16.0, "{}", found);
    }

    #[test]
    fn arcs_by_angles_are_round_and_turn_all_the_way(
        x in -100.0..100.0_f64, radius in 1.0..1000.0_f64, start in -7.0..7.0_f64, sweep in -13.0..13.0_f64,
    ) {
        let centre = vector![x, -x];
        let curve = arc_by_angles(&centre, &radius, &start, &sweep)?;
        let found = eccentricity(&curve, &centre, radius);
        prop_assert!(found <= 16.0, "{}", found);
        let pieces = curve.space().spans().count();
        prop_assert_eq!(pieces, (sweep.abs() / std::f64::consts::FRAC_PI_2).ceil() as usize);
        // The middles of the pieces stand at their angles.
        for i in 0..2 * pieces + 1 {
            let s = i as f64 / (2 * pieces) as f64;
            let expected = centre + radius * vector![(start + sweep * s).cos(), (start + sweep * s).sin()];
            let off = (curve.at(&s)? - expected).norm() / (f64::EPSILON * (radius + x.abs()));
            prop_assert!(off <= 64.0, "{} at {}", off, s);
        }
    }

    #[test]
    fn floating_right_angles_have_no_spare_piece(radius in 0.1..10.0_f64, start in 0.0..7.0_f64, quarters in 1_usize..=3) {
        let o = vector![0.0, 0.0];
        let from = vector![radius * start.cos(), radius * start.sin()];
        let angle = start + quarters as f64 * std::f64::consts::FRAC_PI_2;
        let to = vector![radius * angle.cos(), radius * angle.sin()];
        prop_assert_eq!(arc(&o, &from, &to)?.space().spans().count(), quarters);
    }
}

#[test]
fn arcs_by_angles_refuse_what_is_none() {
    let o = vector![0.0, 0.0];
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(matches!(arc_by_angles(&o, &bad, &0.0, &1.0), Err(Error::NotFinite { index: 0, .. })));
        assert!(matches!(arc_by_angles(&o, &1.0, &bad, &1.0), Err(Error::NotFinite { index: 1, .. })));
        assert!(matches!(arc_by_angles(&o, &1.0, &0.0, &bad), Err(Error::NotFinite { index: 2, .. })));
    }
    assert_eq!(arc_by_angles(&o, &0.0, &0.0, &1.0).unwrap_err(), Error::NotOnCircle);
    assert!(matches!(arc_by_angles(&o, &1.0, &0.0, &1e300), Err(Error::TooLarge { .. })));
    let still = arc_by_angles(&o, &1.0, &0.0, &0.0).unwrap();
    assert_eq!(still.at(&0.5).unwrap(), vector![1.0, 0.0]);
    let turn = std::f64::consts::TAU;
    assert_eq!(arc_by_angles(&o, &1.0, &0.3, &turn).unwrap().space().spans().count(), 4);
}
