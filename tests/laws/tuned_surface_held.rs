//! Laws of surfaces fine-tuned with held edges, as a whole and in a rectangle: exact in the plane.

use crate::strategies::{ANY, CLAMPED, Kind, RING, cases, point, probes, surface, surface_and_field};
use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use symspline::Direction::{self, U, V};
use symspline::{
    Edge, Edges, Error, Fit, Path, Q, Result, Scalar, Scale, SplineSpace, Surface, SurfaceTuner,
    TensorSpline, TuneError,
};

const SHAPE: Kind = ANY.of_degree(1, 3).smooth(1).few(2);
const SCALE: Kind = ANY.of_degree(0, 2).few(2);
const PATHS: [Path; 3] = [Path::UThenV, Path::VThenU, Path::Both];
const FITS: [Fit; 4] = [Fit::Free, Fit::Position, Fit::Tangent, Fit::Curvature];

fn edges() -> impl Strategy<Value = Edges> {
    vec(select(&FITS[..]), 4).prop_map(|fits| {
        Edge::ALL.into_iter().zip(fits).fold(Edges::default(), |all, (edge, fit)| all.with(edge, fit))
    })
}

fn path() -> impl Strategy<Value = Path> {
    select(&PATHS[..])
}

/// Values and derivatives across an edge up to an order, at many places along it.
fn along_edge(s: &Surface<Q, 2>, edge: Edge, order: usize, places: &[Q]) -> Result<Vec<SVector<Q, 2>>> {
    let (a, b) = s.space(edge.direction()).domain();
    let end = if edge.is_end() { b } else { a };
    let jets = places.iter().map(|x| {
        let (u, v) = if edge.direction() == U { (end, x) } else { (x, end) };
        let all = s.derivatives_at(u, v, order)?;
        Ok((0..=order)
            .map(|k| if edge.direction() == U { all[k][0].clone() } else { all[0][k].clone() })
            .collect())
    });
    Ok(jets.collect::<Result<Vec<Vec<_>>>>()?.concat())
}

fn held_edges(edges: Edges) -> impl Iterator<Item = (Edge, usize)> {
    Edge::ALL.into_iter().filter_map(move |edge| Some((edge, edges.fit(edge).order()?)))
}

/// Whether holding was refused for a good reason.
fn is_refusal(error: &Error) -> bool {
    matches!(error, Error::Tune(TuneError::NoChord { .. }) | Error::CoefficientCount { .. })
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn held_edges_stay((s, alpha) in surface_and_field::<2>([SHAPE; 2], [SCALE; 2]), path in path(), edges in edges()) {
        let ring = |d: Direction| s.space(d).is_periodic();
        let held = match s.fine_tuned_holding(Scale::Signed(&alpha), path, edges) {
            Ok(held) => held,
            Err(Error::Tune(TuneError::NoEdge { direction })) => {
                let named = if direction == "u" { U } else { V };
                prop_assert!(ring(named) && held_edges(edges).any(|(edge, _)| edge.direction() == named));
                return Ok(());
            }
            Err(error) => {
                prop_assert!(is_refusal(&error), "{error:?}");
                return Ok(());
            }
        };
        for (edge, order) in held_edges(edges) {
            prop_assert!(!ring(edge.direction()));
            let places = probes(s.space(edge.direction().other()));
            let [tuned, was] = [&held.surface, &s].map(|s| along_edge(s, edge, order, &places));
            prop_assert_eq!(tuned?, was?, "{}", edge);
        }
        if edges == Edges::default() {
            prop_assert_eq!(&held.surface, &s.fine_tuned(Scale::Signed(&alpha), path)?);
            prop_assert_eq!(held.forced, Q::int(0));
        }
    }

    #[test]
    fn lines_along_the_path_are_similar_to_free_ones(
        (s, alpha) in surface_and_field::<2>([SHAPE, CLAMPED.of_degree(1, 3).smooth(1).few(2)], [SCALE; 2]),
        orders in (0_usize..3, 0_usize..3),
    ) {
        let edges = Edges::default().with(Edge::VStart, FITS[1 + orders.0]).with(Edge::VEnd, FITS[1 + orders.1]);
        let Ok(held) = s.fine_tuned_holding(Scale::Signed(&alpha), Path::UThenV, edges) else { return Ok(()) };
        let free = s.fine_tuned_from(Scale::Signed(&alpha), Edge::VStart)?;
        prop_assert_eq!((free.u(), free.v()), (held.surface.u(), held.surface.v()));
        let n = free.v().dim();
        for (line, kept) in free.rows().zip(held.surface.rows()) {
            let (from, to) = (&line[orders.0..n - orders.1], &kept[orders.0..n - orders.1]);
            let chord = |points: &[SVector<Q, 2>]| points[points.len() - 1].clone() - &points[0];
            let (d, c) = (chord(from), chord(to));
            for (p, q) in from.iter().zip(to) {
                let (p, q) = (p.clone() - &from[0], q.clone() - &to[0]);
                // q d = p c as complex numbers; a line that is one point is only moved.
                if d == c {
                    prop_assert_eq!(p, q);
                    continue;
                }
                prop_assert_eq!(times(&q, &d), times(&p, &c));
            }
        }
    }

    #[test]
    fn nothing_is_forced_where_the_scale_is_one(
        s in surface::<2>(CLAMPED.of_degree(1, 3).smooth(1).few(1), CLAMPED.of_degree(1, 3).smooth(1).few(1)),
        order in 0_usize..3,
        middle in vec(1_i64..20, 25),
        path in path(),
    ) {
        // As many lines of ones at the border as derivatives of α - 1 vanish there, and one more.
        let scales = |d: Direction| {
            let (a, b) = s.space(d).domain();
            SplineSpace::uniform(2, 5, a.clone(), b.clone())
        };
        let (u, v) = (scales(U)?, scales(V)?);
        let value = |i: usize, j: usize| {
            let inner = |i: usize| order < i && i + order + 1 < 7;
            if inner(i) && inner(j) { Q::frac(middle[(5 * i + j) % 25], 4) } else { Q::int(1) }
        };
        let values = (0..7).flat_map(|i| (0..7).map(move |j| (i, j))).map(|(i, j)| value(i, j)).collect();
        let alpha = TensorSpline::new(u, v, values)?;
        match s.fine_tuned_holding(&alpha, path, Edges::all(FITS[order + 1])) {
            Ok(held) if path == Path::Both => prop_assert_eq!(held.forced, Q::int(0)),
            Ok(held) => {
                // Along one path only its own lines are put back by it.
                let last = if path == Path::UThenV { V } else { U };
                let across = s.fine_tuned_holding(&alpha, path, Edges::across(last, FITS[order + 1]))?;
                prop_assert_eq!(across.forced, Q::int(0));
                prop_assert_eq!(held.forced, Q::int(0));
            }
            Err(error) => prop_assert!(is_refusal(&error), "{error:?}"),
        }
    }

    #[test]
    fn a_held_tuner_tunes_as_the_operator_does(
        (s, alpha) in surface_and_field::<2>([SHAPE; 2], [SCALE; 2]), path in path(), edges in edges(), at in point::<2>(),
    ) {
        let held = s.fine_tuned_holding(Scale::Signed(&alpha), path, edges);
        let tuner = match SurfaceTuner::prepare(&s, (alpha.u(), alpha.v()), path, edges) {
            Ok(tuner) => tuner.signed(),
            Err(error) => {
                // What no scale can hold, this one cannot.
                prop_assert!(held.is_err(), "{error:?}");
                return Ok(());
            }
        };
        let mut points = vec![at; tuner.u().dim() * tuner.v().dim()];
        let before = points.clone();
        match (tuner.tune_into(alpha.coeffs(), &mut points), held) {
            (Ok(()), Ok(held)) => {
                prop_assert_eq!(&points, held.surface.coeffs());
                prop_assert_eq!((tuner.u(), tuner.v()), (held.surface.u(), held.surface.v()));
            }
            (Err(error), Err(other)) => {
                prop_assert_eq!(error, other);
                prop_assert_eq!(points, before);
            }
            (found, expected) => prop_assert!(false, "{found:?} {expected:?}"),
        }
    }

    #[test]
    fn a_rectangle_fits_the_rest(
        s in surface::<2>(ANY.of_degree(1, 3).smooth(1).few(2), ANY.of_degree(1, 3).smooth(1).few(2)),
        ends in vec(any::<Index>(), 4),
        (alpha, degrees) in (vec(1_i64..20, 36), (0_usize..3, 0_usize..3)),
        path in path(),
        edges in edges(),
    ) {
        let side = |d: Direction, i: &Index, j: &Index, degree: usize| {
            let places = probes(s.space(d));
            let (i, j) = (i.index(places.len()), j.index(places.len() - 1));
            let j = if j >= i { j + 1 } else { j };
            SplineSpace::uniform(degree, 4, places[i.min(j)].clone(), places[i.max(j)].clone())
        };
        let (u, v) = (side(U, &ends[0], &ends[1], degrees.0)?, side(V, &ends[2], &ends[3], degrees.1)?);
        let count = u.dim() * v.dim();
        let alpha = TensorSpline::new(u, v, alpha[..count].iter().map(|a| Q::frac(*a, 4)).collect())?;
        let local = match s.fine_tuned_on(&alpha, path, edges) {
            Ok(local) => local,
            Err(Error::Tune(TuneError::FreeEdge { .. })) => {
                let inside = |edge: Edge| {
                    let ((a, b), (start, end)) = (alpha.space(edge.direction()).domain(), s.space(edge.direction()).domain());
                    s.space(edge.direction()).is_periodic() || if edge.is_end() { b != end } else { a != start }
                };
                prop_assert!(Edge::ALL.into_iter().any(|edge| edges.fit(edge) == Fit::Free && inside(edge)));
                return Ok(());
            }
            Err(error) => {
                prop_assert!(is_refusal(&error), "{error:?}");
                return Ok(());
            }
        };
        let whole = local.joined()?;
        prop_assert_eq!((whole.u().degree(), whole.v().degree()), (s.u().degree() + degrees.0, s.v().degree() + degrees.1));
        for d in [U, V] {
            prop_assert_eq!(whole.space(d).is_periodic(), s.space(d).is_periodic());
        }
        let inside = |d: Direction, x: &Q| {
            let (a, b) = alpha.space(d).domain();
            a <= x && x < b || x == b && b == s.space(d).domain().1 && !s.space(d).is_periodic()
        };
        for x in probes(whole.u()) {
            for y in probes(whole.v()).into_iter().step_by(2) {
                let expected = if inside(U, &x) && inside(V, &y) { local.tuned().surface.at(&x, &y)? } else { s.at(&x, &y)? };
                prop_assert_eq!(whole.at(&x, &y)?, expected, "({}, {})", x, y);
            }
        }
        // A boundary of the rectangle has no more copies than its fit needs, or than there were.
        for (edge, order) in held_edges(edges) {
            let d = edge.direction();
            let (a, b) = alpha.space(d).domain();
            let t = if edge.is_end() { b } else { a };
            let copies = |space: &SplineSpace<Q>| space.breaks().iter().find(|(s, _)| s == t).map_or(0, |(_, n)| *n);
            let p = whole.space(d).degree();
            let (start, end) = s.space(d).domain();
            if t != start && t != end {
                let raised = if copies(s.space(d)) > 0 { copies(s.space(d)) + p - s.space(d).degree() } else { 0 };
                prop_assert_eq!(copies(whole.space(d)), raised.max(p.saturating_sub(order)));
            }
        }
    }

    #[test]
    fn a_rectangle_may_go_around(
        s in surface::<2>(RING.of_degree(1, 3).smooth(1).few(2), CLAMPED.of_degree(1, 3).smooth(1).few(2)),
        values in vec(1_i64..20, 60),
    ) {
        let (a, b) = s.u().domain();
        let (c, d) = s.v().domain();
        let u = SplineSpace::uniform_periodic(1, 3, a.clone(), b.clone())?;
        let third = |n: i64| c.clone() + (d.clone() - c) * Q::frac(n, 3);
        let v = SplineSpace::uniform(2, 3, third(1), third(2))?;
        let count = u.dim() * v.dim();
        let alpha = TensorSpline::new(u, v, values[..count].iter().map(|a| Q::frac(*a, 4)).collect())?;
        let edges = Edges::across(V, Fit::Tangent);
        match s.fine_tuned_on(&alpha, Path::UThenV, edges) {
            Ok(local) => {
                let whole = local.joined()?;
                prop_assert!(whole.u().is_periodic());
                for x in probes(whole.u()) {
                    prop_assert_eq!(whole.at(&x, &third(0))?, s.at(&x, &third(0))?);
                    let half = (third(1) + third(2)) / Q::int(2);
                    prop_assert_eq!(whole.at(&x, &half)?, local.tuned().surface.at(&x, &half)?);
                }
            }
            Err(error) => prop_assert!(is_refusal(&error), "{error:?}"),
        }
        let open = s.fine_tuned_on(&alpha, Path::Both, edges);
        let refused = matches!(&open, Err(Error::Tune(TuneError::Open { .. })));
        prop_assert!(refused || open.is_err_and(|error| is_refusal(&error)));
    }
}

fn times(z: &SVector<Q, 2>, v: &SVector<Q, 2>) -> SVector<Q, 2> {
    let product = |a: &Q, b: &Q| a.clone() * b;
    vector![product(&z[0], &v[0]) - product(&z[1], &v[1]), product(&z[0], &v[1]) + product(&z[1], &v[0])]
}

#[test]
fn a_rectangle_from_seam_to_seam_has_two_fits() -> Result<()> {
    let ring = SplineSpace::uniform_periodic(3, 5, Q::int(0), Q::int(1))?;
    let line = SplineSpace::bezier(2, Q::int(0), Q::int(1))?;
    let points = (0..15).map(|i: i64| vector![Q::int(7 * i % 11), Q::int(i * i % 13)]).collect();
    let tube = Surface::<Q, 2>::new(ring, line.clone(), points)?;
    let u = SplineSpace::uniform(1, 5, Q::int(0), Q::int(1))?;
    let values = (0..18).map(|i| Q::frac(5 * i % 7 + 1, 3)).collect();
    let alpha = TensorSpline::new(u, line, values)?;
    for (start, end) in
        [(Fit::Curvature, Fit::Position), (Fit::Position, Fit::Tangent), (Fit::Tangent, Fit::Tangent)]
    {
        let edges = Edges::default().with(Edge::UStart, start).with(Edge::UEnd, end);
        let local = tube.fine_tuned_on(&alpha, Path::VThenU, edges)?;
        let whole = local.joined()?;
        for x in probes(whole.u()) {
            for y in probes(whole.v()) {
                assert_eq!(whole.at(&x, &y)?, local.tuned().surface.at(&x, &y)?, "{start:?} {end:?}");
            }
        }
        // No more copies at the seam than the fits need.
        let order = start.order().min(end.order()).unwrap_or_default();
        assert_eq!(whole.u().breaks()[0].1, whole.u().degree() - order);
    }
    Ok(())
}

#[test]
fn floats_hold_poles() -> Result<()> {
    // Coordinates that rounding moves, an edge of one point, knots inside: its lines are points up to rounding.
    let spaces = [SplineSpace::uniform(3, 4, 0.0, 1.0)?, SplineSpace::uniform(2, 3, 0.0, 1.0)?];
    let pole = vector![0.1, 0.7, 0.3];
    let [u, v] = spaces.each_ref().map(SplineSpace::dim);
    let height = |i: usize, j: usize| ((7 * i + 11 * j + i * j) % 13) as f64 / 13.0;
    let points = (0..u * v).map(|k| (k / v, k % v));
    let points =
        points.map(|(i, j)| if i == 0 { pole } else { vector![i as f64, j as f64 * 0.3, height(i, j)] });
    let cap = Surface::<f64, 3>::new(spaces[0].clone(), spaces[1].clone(), points.collect())?;
    let scales = (SplineSpace::uniform(2, 3, 0.0, 1.0)?, SplineSpace::uniform(2, 4, 0.0, 1.0)?);
    let values = (0..30).map(|i| 0.3 + f64::from(7 * i % 11) / 10.0).collect();
    let alpha = TensorSpline::new(scales.0.clone(), scales.1.clone(), values)?;
    for cap in [cap.clone(), cap.reversed(U)?, cap.transposed()] {
        for path in PATHS {
            for fit in [Fit::Position, Fit::Tangent] {
                let edges = Edges::all(fit);
                let held = cap.fine_tuned_holding(&alpha, path, edges)?.surface;
                let tuned = SurfaceTuner::prepare(&cap, (&scales.0, &scales.1), path, edges)?
                    .tuned(alpha.coeffs())?;
                for (p, q) in held.coeffs().iter().zip(tuned.coeffs()) {
                    assert!((p - q).amax() < 1e-13, "{path:?} {fit:?}");
                }
            }
        }
    }
    Ok(())
}
