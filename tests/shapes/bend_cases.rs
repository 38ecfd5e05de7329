//! Bends about curves, surfaces and axes, refusals, and extreme sizes: single cases, most over floats with bounds.

use nalgebra::{SVector, vector};
use symspline::{
    Axis, Bend, BendCentre, Bendable, Controlled, CrossRatio, Curve, Direction, Error, Flat, OffsetAxis, Q,
    Refinement, Round, Scalar, ShapeError, Sphere, SplineSpace, Surface, TensorSpline, circle,
};

type Point<const N: usize> = SVector<Q, N>;

fn q2(x: i64, y: i64) -> Point<2> {
    vector![Q::int(x), Q::int(y)]
}

/// Over both fields a bend about a curve is one about the circle or line that it is.
#[test]
fn curves_stand_for_what_they_are() {
    let ring = circle(&q2(0, 0), &Q::int(5)).unwrap();
    let round =
        |o: &Point<2>, p: &Point<2>| Sphere { centre: q2(0, 0), radius: Q::int(5) }.share(o, p).unwrap();
    for (o, p) in [
        (q2(0, 0), q2(6, 8)),
        (q2(4, 2), q2(6, -2)),
        (q2(0, 20), q2(0, 30)),
        (q2(0, 20), q2(0, 0)),
        (q2(9, 9), q2(9, 19)),
    ] {
        assert_eq!(ring.share(&o, &p).unwrap(), round(&o, &p), "{o} {p}");
    }
    // At 45° the circle has no rational point.
    let error = ring.share(&q2(0, 0), &q2(1, 1)).unwrap_err();
    assert!(matches!(error, Error::Shape(ShapeError::NoRoot { .. })));
    let ring = circle(&vector![0.0, 0.0], &5.0).unwrap();
    for i in 0..50 {
        let (o, p) = (vector![(i as f64).sin(), (i as f64).cos()], vector![7.0, f64::from(i) - 20.0]);
        let exact = Sphere { centre: vector![0.0, 0.0], radius: 5.0 }.share(&o, &p).unwrap().unwrap();
        assert!((ring.share(&o, &p).unwrap().unwrap() - exact).abs() < 1e-14);
    }
    let points = [[-2, 4], [0, -4], [2, 4]].map(|c| c.map(Q::int).into()).to_vec();
    let parabola = Curve::new(SplineSpace::bezier(2, Q::int(-2), Q::int(2)).unwrap(), points).unwrap();
    // y = x² and y = 2x: at (0, 0) and at (2, 4), where the curve ends.
    assert_eq!(parabola.share(&q2(-1, -2), &q2(3, 6)).unwrap(), Some(Q::frac(3, 4)));
    assert_eq!(parabola.share(&q2(-1, -2), &q2(-1, 0)).unwrap(), Some(Q::frac(3, 2)));
    assert_eq!(parabola.share(&q2(0, 5), &q2(1, 5)).unwrap(), None);
}

/// Refusals name the control point.
#[test]
fn what_cannot_be_bent_is_refused() {
    let space = SplineSpace::clamped(2, (0..7).map(Q::int)).unwrap();
    let line = Curve::new(space, (0..8).map(|i| q2(i, 3)).collect()).unwrap();
    let on = |bend: Bend<Q, Point<2>, Round<Q>>| {
        bend.on(Q::int(1), Q::int(5)).without_tails().apply(&line).unwrap_err()
    };
    let bend = |o: Point<2>, ratio: i64| Bend::new(o, Round(Q::int(1)), Q::int(ratio));
    assert_eq!(on(bend(q2(4, 3), 1)), ShapeError::AtCentre { index: 4 }.into());
    assert!(matches!(on(bend(q2(4, 0), 1)), Error::Shape(ShapeError::NoRoot { .. })));
    let beyond = ShapeError::BeyondInfinity { index: 3, ratio: "-1".into(), share: "1/8".into() };
    assert_eq!(on(bend(q2(-5, 3), -1)), beyond.into());
    let flat = Flat { origin: q2(0, 0), normal: q2(0, 1) };
    let above = Bend::new(q2(0, 1), flat, Q::int(1)).on(Q::int(1), Q::int(5)).apply(&line);
    assert_eq!(above.unwrap_err(), ShapeError::NoBendPoint { index: 3 }.into());
    let narrow = bend(q2(0, 0), 1).on(Q::int(1), Q::int(2)).apply(&line).unwrap_err();
    assert_eq!(narrow, ShapeError::NothingLocal { start: "1".into(), end: "2".into() }.into());
    let between = bend(q2(0, 0), 1).on(Q::frac(1, 2), Q::int(5)).apply(&line).unwrap_err();
    assert_eq!(between, ShapeError::NoKnot { value: "1/2".into() }.into());
    let across = bend(q2(0, 0), 1).along(Direction::V).apply(&line).unwrap_err();
    assert_eq!(across, ShapeError::OtherParameters.into());
    let constant = TensorSpline::constant(
        SplineSpace::bezier(0, Q::int(0), Q::int(6)).unwrap(),
        SplineSpace::bezier(0, Q::int(0), Q::int(6)).unwrap(),
        Q::int(1),
    );
    let over =
        Bend::new(q2(0, 0), Round(Q::int(1)), CrossRatio::Over(constant.unwrap())).apply(&line).unwrap_err();
    assert_eq!(over, ShapeError::OtherParameters.into());
}

/// A gently curved sheet over [0, 4] x [0, 3].
fn sheet() -> Surface<f64, 3> {
    let space = |spans: usize, end: f64| SplineSpace::uniform(3, spans, 0.0, end).expect("a space");
    let (u, v) = (space(8, 4.0), space(5, 3.0));
    let point = |x: f64, y: f64| vector![x, y, 0.2 * (x + 0.5 * y).sin()];
    let points =
        u.greville().iter().flat_map(|x| v.greville().into_iter().map(move |y| point(*x, y))).collect();
    Surface::new(u, v, points).expect("a sheet")
}

#[test]
fn offset_axes_are_right() {
    let sheet = sheet();
    for (direction, at) in [(Direction::U, 1.7), (Direction::V, 1.1)] {
        let curve = sheet.isocurve(direction, &at).unwrap();
        let projector = curve.projector().unwrap();
        let plain = OffsetAxis::new(&sheet, direction, at, 0.0).unwrap();
        let off = OffsetAxis::new(&sheet, direction, at, 0.5).unwrap();
        for p in sheet.coeffs() {
            // Without an offset it is the isocurve.
            let foot = projector.foot(p).unwrap();
            assert!(((plain.centre_of(p).unwrap() - p).norm() - foot.distance).abs() < 1e-10);
            // No place of the axis is nearer, and it is at the distance from the isocurve.
            let centre = off.centre_of(p).unwrap();
            let end = curve.domain().1;
            for i in 0..=1000 {
                let other = off.point(end * f64::from(i) / 1000.0).unwrap();
                assert!((centre - p).norm() <= (other - p).norm() + 1e-12);
            }
            assert!(projector.foot(&centre).unwrap().distance <= 0.5 + 1e-12);
        }
    }
    // Of a plane sheet it is a straight line.
    let flattened = sheet.coeffs().iter().map(|c| vector![c[0], c[1], 0.0]).collect();
    let flat = Surface::new(sheet.u().clone(), sheet.v().clone(), flattened).unwrap();
    let offset = OffsetAxis::new(&flat, Direction::U, 2.0, -0.75).unwrap();
    let line = Axis::new(vector![2.0, 0.0, -0.75], vector![0.0, 1.0, 0.0]).unwrap();
    for p in flat.coeffs() {
        assert!((offset.centre_of(p).unwrap() - line.centre_of(p).unwrap()).norm() < 1e-13);
    }
}

/// Over floats: rows of a bent sheet come to lie on the cylinder, and their tails keep all distances.
#[test]
fn cylinder_bends_of_floats() {
    let sheet = sheet();
    for direction in [Direction::U, Direction::V] {
        let axis = OffsetAxis::new(&sheet, direction, 1.5, -1.0).unwrap();
        let bend = Bend::new(axis.clone(), Round(1.0), 1.0)
            .along(direction)
            .on(0.9, 2.1)
            .refined(Refinement::Count(9));
        let bent = bend.apply(&sheet).unwrap();
        let fine = Refinement::Count(9).of(&sheet, direction, &0.9, &2.1).unwrap();
        let local = fine.space_along(direction).local_coeffs(&0.9, &2.1).unwrap();
        let (length, columns) = (fine.space_along(direction).dim(), fine.v().dim());
        let rows = fine.coeffs().len() / length;
        let flat =
            |i: usize, j: usize| if direction == Direction::U { i * columns + j } else { j * columns + i };
        for j in 0..rows {
            for i in local.clone() {
                let (p, image) = (fine.coeffs()[flat(i, j)], bent.coeffs()[flat(i, j)]);
                assert!(((image - axis.centre_of(&p).unwrap()).norm() - 1.0).abs() < 1e-12);
            }
            for tail in [(0..=local.start).collect::<Vec<_>>(), (local.end - 1..length).collect()] {
                for (a, b) in tail.iter().flat_map(|a| tail.iter().map(move |b| (flat(*a, j), flat(*b, j)))) {
                    let [d, e] = [&fine, &bent].map(|s| (s.coeffs()[a] - s.coeffs()[b]).norm());
                    assert!((d - e).abs() < 1e-13);
                }
            }
        }
    }
}

/// A spherical bend, and one about the surface that this sphere bounds.
#[test]
fn bends_about_surfaces() {
    let sheet = sheet();
    let centre = vector![2.0, 1.5, -5.0];
    let plain = Bend::new(centre, Round(4.5), 2.0).apply(&sheet).unwrap();
    let same = Bend::new(centre, Sphere { centre, radius: 4.5 }, 2.0).apply(&sheet).unwrap();
    let line = SplineSpace::bezier(1, 0.0, 1.0).unwrap();
    let corners =
        [[-9.0, -9.0], [-9.0, 9.0], [9.0, -9.0], [9.0, 9.0]].map(|[x, y]| vector![x, y, -1.0]).to_vec();
    let table = Surface::new(line.clone(), line, corners).unwrap();
    let about = Bend::new(centre, table, 2.0).apply(&sheet).unwrap();
    let flat =
        Bend::new(centre, Flat { origin: vector![0.0, 0.0, -1.0], normal: vector![0.0, 0.0, 3.0] }, 2.0);
    let flat = flat.apply(&sheet).unwrap();
    for (a, b) in [(&plain, &same), (&about, &flat)] {
        assert!(a.coeffs().iter().zip(b.coeffs()).all(|(p, q)| (p - q).norm() < 1e-12));
    }
}

#[test]
fn extreme_sizes_give_values_or_refusals() {
    for size in [1e-300, 1e-160, 1.0, 1e155, 1e300] {
        let space = SplineSpace::uniform(2, 8, 0.0, 1.0).unwrap();
        let line =
            Curve::new(space, (0..10).map(|i| vector![size * f64::from(i), 0.5 * size]).collect()).unwrap();
        let centre = vector![4.5 * size, -0.5 * size];
        for about in [Sphere { centre, radius: size }, Sphere { centre: centre * 0.5, radius: 1.0 }] {
            if let Ok(bent) = Bend::new(centre, about, 2.0).on(0.125, 0.875).apply(&line) {
                assert!(bent.coeffs().iter().all(|c| c.iter().all(|x| x.is_finite())));
            }
        }
        let bent = Bend::new(centre, Round(size), 1.0).on(0.125, 0.875).apply(&line).unwrap();
        assert!(bent.coeffs()[3..6].iter().all(|c| (((c - centre) / size).norm() - 1.0).abs() < 1e-14));
        let flat = Flat { origin: centre * 0.5, normal: vector![0.0, size] };
        assert!(Bend::new(centre, flat, 1.0).on(0.125, 0.875).apply(&line).is_ok());
    }
}

/// On a closed surface the axis goes on over the seam.
#[test]
fn closed_axes_have_no_ends() {
    let (u, v) = (
        SplineSpace::bezier(1, 0.0, 1.0).unwrap(),
        SplineSpace::periodic(3, (0..8).map(f64::from), 8.0).unwrap(),
    );
    let round = |z: f64| {
        (0..8)
            .map(move |j| (f64::from(j) * std::f64::consts::FRAC_PI_4).sin_cos())
            .map(move |(y, x)| vector![x, y, z])
    };
    let tube = Surface::new(u, v, round(0.0).chain(round(1.0)).collect()).unwrap();
    let axis = OffsetAxis::new(&tube, Direction::U, 0.5, 0.1).unwrap();
    for i in 0..100 {
        let (y, x) = (0.02 + f64::from(i) / 100.0 * std::f64::consts::TAU).sin_cos();
        let point = vector![3.0 * x, 3.0 * y, 0.7];
        let off = (axis.centre_of(&point).unwrap() - point).norm();
        let places = (0..=8000).map(|k| (axis.point(f64::from(k) / 1000.0).unwrap() - point).norm());
        assert!(off <= places.fold(f64::INFINITY, f64::min) + 1e-12, "{i}");
    }
    assert!(matches!(OffsetAxis::new(&tube, Direction::U, 0.5, f64::NAN), Err(Error::NotFinite { .. })));
}

/// A bend curve along the ray holds the point, if it goes beyond it.
#[test]
fn points_on_what_is_bent_about_stay() {
    let edge =
        Curve::new(SplineSpace::bezier(1, Q::int(0), Q::int(1)).unwrap(), vec![q2(1, 0), q2(5, 0)]).unwrap();
    for (x, share) in [(3, Q::int(1)), (-3, Q::int(-1)), (10, Q::frac(1, 2)), (1, Q::int(1))] {
        let found = edge.share(&q2(0, 0), &q2(x, 0)).unwrap();
        assert_eq!(found, (share > Q::int(0)).then_some(share), "{x}");
    }
}

/// Far from the sphere, and along a plane.
#[test]
fn shares_lose_little_to_rounding() {
    let ball = Sphere { centre: vector![1e6, 0.3], radius: 0.5 };
    for (x, met) in [(1e6 - 1.0, -0.4), (1e6 + 1.0, 0.4)] {
        let share = ball.share(&vector![0.0, 0.0], &vector![x, 0.0]).unwrap().unwrap();
        assert!((share * x - 1e6 - met).abs() < 1e-9, "{x}");
    }
    let wall = Flat { origin: vector![0.0, 1.0], normal: vector![-0.3, 0.1] };
    assert_eq!(wall.share(&vector![0.0, 0.0], &vector![0.1 * 0.7, 0.3 * 0.7]).unwrap(), None);
}

/// The whole of a ring has no ends to carry along, and none to miss.
#[test]
fn whole_rings_are_bent() {
    let space = SplineSpace::periodic(2, (0..6).map(Q::int), Q::int(6)).unwrap();
    let points = [[9, 0], [6, 6], [-6, 6], [-9, 0], [-6, -6], [6, -6]].map(|c| c.map(Q::int).into());
    let ring = Curve::new(space, points.to_vec()).unwrap();
    let bend = Bend::new(q2(0, 0), Flat { origin: q2(20, 0), normal: q2(1, 0) }, Q::int(1));
    assert!(matches!(bend.apply(&ring), Err(Error::Shape(ShapeError::NoBendPoint { index: 2 }))));
    let bend = Bend::new(q2(0, -50), Flat { origin: q2(0, 0), normal: q2(0, 1) }, Q::int(1));
    let all = bend.apply(&ring).unwrap();
    assert!(all.coeffs().iter().all(|c| c[1] == Q::int(0)));
    assert_eq!(bend.clone().on(Q::int(0), Q::int(6)).apply(&ring).unwrap(), all);
    assert_eq!(bend.on(Q::int(0), Q::int(5)).apply(&ring).unwrap_err(), ShapeError::NoEnds.into());
}
