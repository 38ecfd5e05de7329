//! Laws of meetings of a line and a surface, over `f64`.

use crate::strategies::cases;
use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{
    Certainty, Direction, Error, LineMeetings, NurbsCurve, NurbsSurface, Result, SplineSpace, Surface,
    arc_by_angles, circle,
};

const TOLERANCE: f64 = 1e-9;

type Point = SVector<f64, 3>;

fn coordinate() -> impl Strategy<Value = f64> {
    (-64_i32..=64).prop_map(|n| f64::from(n) / 64.0)
}

fn point() -> impl Strategy<Value = Point> {
    [coordinate(), coordinate(), coordinate()].prop_map(Into::into)
}

fn space() -> impl Strategy<Value = SplineSpace<f64>> {
    (1_usize..=3, 1_usize..=3, 0..3).prop_map(|(p, spans, shape)| {
        match shape {
            0 => SplineSpace::uniform(p, spans, 0.0, 2.0),
            1 => SplineSpace::new(p, (0..2 * p + 1 + spans).map(|i| i as f64)),
            _ => SplineSpace::uniform_periodic(p, spans + 2, -1.0, 1.0),
        }
        .expect("a valid spline")
    })
}

fn surface() -> impl Strategy<Value = Surface<f64, 3>> {
    (space(), space(), vec(point(), 36)).prop_map(|(u, v, points)| {
        let count = u.dim() * v.dim();
        Surface::new(u, v, points[..count].to_vec()).expect("a valid spline")
    })
}

/// A point inside of the domain.
fn place(s: &Surface<f64, 3>, x: [f64; 2]) -> [f64; 2] {
    [(s.u(), x[0]), (s.v(), x[1])]
        .map(|(space, x)| space.domain().0 + x * (space.domain().1 - space.domain().0))
}

fn is_sound(
    found: &LineMeetings,
    (origin, direction): (&Point, &Point),
    at: impl Fn([f64; 2]) -> Result<Point>,
) -> std::result::Result<(), TestCaseError> {
    for m in &found.meetings {
        let bound = if m.certainty == Certainty::Proved { 1e-12 } else { 10.0 * TOLERANCE };
        prop_assert!((at(m.parameters)? - m.point).norm() <= bound, "{m:?} is not on the surface");
        prop_assert!((origin + direction * m.along - m.point).norm() <= bound, "{m:?} is not on the line");
    }
    for o in &found.overlaps {
        for (along, parameters) in [(o.along.0, o.parameters[0]), (o.along.1, o.parameters[1])] {
            prop_assert!((origin + direction * along - at(parameters)?).norm() <= 1e-9, "{o:?}");
        }
    }
    prop_assert!(found.meetings.windows(2).all(|pair| pair[0].along <= pair[1].along));
    Ok(())
}

/// The unit sphere, made by turning half a circle.
fn sphere() -> NurbsSurface<f64, 3> {
    let full = circle(&vector![0.0, 0.0], &1.0).expect("a valid spline");
    let half = arc_by_angles(&vector![0.0, 0.0], &1.0, &-std::f64::consts::FRAC_PI_2, &std::f64::consts::PI)
        .expect("a valid spline");
    let parts = |c: &NurbsCurve<f64, 2>| -> Vec<_> {
        c.points().expect("a valid spline").into_iter().zip(c.weights().copied()).collect()
    };
    let (mut points, mut weights) = (Vec::new(), Vec::new());
    for (c, w) in parts(&full) {
        for (d, v) in parts(&half) {
            points.push(vector![c[0] * d[0], c[1] * d[0], d[1]]);
            weights.push(w * v);
        }
    }
    NurbsSurface::new(full.space().clone(), half.space().clone(), points, weights).expect("a valid spline")
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn a_line_through_a_point_of_the_surface_finds_it(
        s in surface(), x in [0.0..=1.0, 0.0..=1.0], direction in point(), weights in vec(0.25..4.0, 36),
    ) {
        prop_assume!(direction.norm() > 0.1);
        let [u, v] = place(&s, x);
        let origin = s.at(&u, &v)? - 2.0 * direction;
        let found = s.meet_line(&origin, &direction, &TOLERANCE)?;
        is_sound(&found, (&origin, &direction), |[u, v]| s.at(&u, &v))?;
        let here = |along: f64| (along - 2.0).abs() * direction.norm() < 1e-6;
        let single = found.meetings.iter().any(|m| here(m.along));
        prop_assert!(single || found.overlaps.iter().any(|o| o.along.0 < 2.0 + 1e-6 && o.along.1 > 2.0 - 1e-6), "{found:?}");
        let count = s.coeffs().len();
        let r = NurbsSurface::new(s.u().clone(), s.v().clone(), s.coeffs().to_vec(), weights[..count].to_vec())?;
        let origin = r.at(&u, &v)? - 2.0 * direction;
        let found = r.meet_line(&origin, &direction, &TOLERANCE)?;
        is_sound(&found, (&origin, &direction), |[u, v]| r.at(&u, &v))?;
        prop_assert!(found.meetings.iter().any(|m| here(m.along)) || !found.overlaps.is_empty(), "{found:?}");
    }

    #[test]
    fn other_forms_are_met_at_the_same_points(s in surface(), origin in point(), direction in point()) {
        prop_assume!(direction.norm() > 0.1);
        let found = s.meet_line(&origin, &direction, &TOLERANCE)?;
        let proved = |found: &LineMeetings| {
            found.overlaps.is_empty() && found.meetings.iter().all(|m| m.certainty == Certainty::Proved)
        };
        prop_assume!(proved(&found));
        let (a, b) = (*s.u().domain().0, *s.u().domain().1);
        let middle = a + 0.37 * (b - a);
        let forms = [
            s.transposed(), s.reversed(Direction::U)?, s.elevated(Direction::V, 1)?, s.inserted(Direction::U, &[middle])?,
        ];
        for form in forms {
            let other = form.meet_line(&origin, &(direction * -3.0), &TOLERANCE)?;
            prop_assert_eq!(found.meetings.len(), other.meetings.len());
            for (m, n) in found.meetings.iter().zip(other.meetings.iter().rev()) {
                prop_assert!((m.point - n.point).norm() < 1e-11 && (m.along + 3.0 * n.along).abs() < 1e-10);
            }
        }
    }

    #[test]
    fn a_sphere_is_met_twice(origin in point(), direction in point()) {
        prop_assume!(direction.norm() > 0.1);
        // The quadratic equation of |origin + x direction| = 1.
        let (a, b, c) = (direction.norm_squared(), origin.dot(&direction), origin.norm_squared() - 1.0);
        let root = b * b - a * c;
        prop_assume!(root.abs() > 1e-9);
        let found = sphere().meet_line(&origin, &direction, &TOLERANCE)?;
        is_sound(&found, (&origin, &direction), |[u, v]| sphere().at(&u, &v))?;
        prop_assert_eq!(found.meetings.len(), if root > 0.0 { 2 } else { 0 }, "{:?}", found);
        for (m, sign) in found.meetings.iter().zip([-1.0, 1.0]) {
            prop_assert!((m.along - (sign * root.sqrt() - b) / a).abs() < 1e-10, "{m:?}");
        }
    }

    #[test]
    fn tangents_of_a_sphere_touch_it_once(angles in [0.0..6.2_f64, -1.5..1.5_f64, 0.0..3.1_f64]) {
        let [a, b, c] = angles;
        let touched = vector![a.cos() * b.cos(), a.sin() * b.cos(), b.sin()];
        let east = vector![-a.sin(), a.cos(), 0.0];
        let north = touched.cross(&east);
        let direction = east * c.cos() + north * c.sin();
        let found = sphere().meet_line(&(touched - direction * 2.0), &direction, &TOLERANCE)?;
        prop_assert!(found.meetings.len() <= 2 && !found.meetings.is_empty(), "{found:?}");
        prop_assert!(found.meetings.iter().all(|m| (m.point - touched).norm() < 1e-6), "{found:?}");
    }

    #[test]
    fn lines_in_a_ruled_surface_are_overlaps(
        u in space(), ends in vec(point(), 12), x in 0_u8..=8, raise in 0_usize..=2, knots in 0_usize..=2,
    ) {
        // Linear from one curve to another.
        let points = (0..u.dim()).flat_map(|i| [ends[i], ends[6 + i % 6]]).collect();
        let inner = (1..=knots).map(|i| i as f64 / (knots + 1) as f64).collect::<Vec<_>>();
        let ruled = Surface::new(u, SplineSpace::bezier(1, 0.0, 1.0)?, points)?;
        let ruled = ruled.inserted(Direction::V, &inner)?.elevated(Direction::V, raise)?;
        let (a, b) = (*ruled.u().domain().0, *ruled.u().domain().1);
        let x = a + (b - a) * f64::from(x) / 8.0;
        let [start, end] = [ruled.at(&x, &0.0)?, ruled.at(&x, &1.0)?];
        let direction = end - start;
        let partials = ruled.tangents_at(&x, &0.5)?;
        prop_assume!(direction.norm() > 0.05 && partials[1].cross(&partials[2]).norm() > 1e-3);
        let found = ruled.meet_line(&start, &direction, &TOLERANCE)?;
        is_sound(&found, (&start, &direction), |[u, v]| ruled.at(&u, &v))?;
        prop_assert!(
            found.overlaps.iter().any(|o| o.along.0 < 1e-7 && o.along.1 > 1.0 - 1e-7), "{start:?} {direction:?} {found:?}",
        );
    }

    #[test]
    fn lines_in_a_plane_are_one_overlap(
        u in (1_usize..=3, 1_usize..=5), v in (1_usize..=3, 1_usize..=5), x in [0.0..1.0, 0.0..1.0], angle in 0_u8..16,
    ) {
        let [u, v] = [u, v].map(|(p, spans)| SplineSpace::uniform(p, spans, 0.0, 1.0).expect("a valid spline"));
        let points = u.greville().iter().flat_map(|x| v.greville().into_iter().map(move |y| vector![*x, y, 0.25])).collect();
        let plane = Surface::new(u, v, points)?;
        let angle = f64::from(angle) * std::f64::consts::PI / 16.0;
        let origin = vector![x[0], x[1], 0.25];
        let direction = vector![angle.cos(), angle.sin(), 0.0];
        let found = plane.meet_line(&origin, &direction, &TOLERANCE)?;
        is_sound(&found, (&origin, &direction), |[u, v]| plane.at(&u, &v))?;
        prop_assert_eq!((found.meetings.len(), found.overlaps.len()), (0, 1), "{:?}", found);
        let along = found.overlaps[0].along;
        let border = |x: f64| {
            let end = origin + direction * x;
            [end[0], end[1]].iter().any(|x| x.abs() < 1e-9 || (x - 1.0).abs() < 1e-9)
        };
        prop_assert!(border(along.0) && border(along.1) && along.1 - along.0 > 1e-3, "{found:?}");
        let above = plane.meet_line(&(origin + vector![0.0, 0.0, 1e-8]), &direction, &TOLERANCE)?;
        prop_assert!(above.meetings.is_empty() && above.overlaps.is_empty());
    }
}

#[test]
fn poles_are_met_once() {
    let axis = vector![0.0, 0.0, 1.0];
    let found = sphere().meet_line(&Point::zeros(), &axis, &TOLERANCE).expect("a valid spline");
    let along: Vec<f64> = found.meetings.iter().map(|m| m.along).collect();
    assert_eq!((along.len(), found.overlaps.len()), (2, 0));
    assert!((along[0] + 1.0).abs() < 1e-15 && (along[1] - 1.0).abs() < 1e-15);
}

#[test]
fn bad_lines_are_refused() {
    let ball = sphere();
    let (o, x) = (Point::zeros(), vector![1.0, 0.0, 0.0]);
    assert_eq!(ball.meet_line(&o, &o, &TOLERANCE), Err(Error::NoLength));
    assert!(matches!(ball.meet_line(&o, &x, &0.0), Err(Error::BadTolerance { .. })));
    let nan = vector![0.0, f64::NAN, 0.0];
    assert_eq!(ball.meet_line(&nan, &x, &TOLERANCE), Err(Error::NotFinite { what: "origin", index: 1 }));
    assert_eq!(ball.meet_line(&o, &nan, &TOLERANCE), Err(Error::NotFinite { what: "direction", index: 1 }));
    assert!(matches!(ball.meet_line(&(x * 1e20), &x, &TOLERANCE), Err(Error::OutOfTolerance { .. })));
}

#[test]
fn sizes_do_not_matter() {
    let ball = sphere();
    for size in [1e-300, 1e-150, 1e150, 1e300] {
        let points = ball.points().expect("a valid spline").iter().map(|c| c * size).collect();
        let scaled =
            NurbsSurface::new(ball.u().clone(), ball.v().clone(), points, ball.weights().copied().collect())
                .expect("a valid spline");
        let origin = vector![0.1, 0.2, 0.3] * size;
        for length in [1e-300, 1.0, 1e300] {
            let found = scaled.meet_line(&origin, &(vector![0.6, 0.0, -0.8] * length), &(1e-9 * size));
            match found {
                Ok(found) => assert_eq!(found.meetings.len(), 2, "{size:e} {length:e}"),
                Err(error) => assert!(matches!(error, Error::NotFinite { .. }), "{error}"),
            }
        }
    }
}
