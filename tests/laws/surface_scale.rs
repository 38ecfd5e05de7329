//! Laws of the nearest scale functions of surfaces, exact: what is asked for is met, by the least change.

use crate::strategies::{
    ANY, CLAMPED, Kind, RING, cases, coeffs, number, point, probes, surface, surface_and_field,
};
use nalgebra::SVector;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select, subsequence};
use symspline::Direction::{self, U, V};
use symspline::{
    Contact, Edge, Error, NearestScale, Norm, Path, Q, Result, Scalar, Scale, SplineSpace, Surface,
    SurfaceCondition, SurfaceTuner, TensorSpline, TuneError,
};

const SHAPE: Kind = CLAMPED.of_degree(1, 2).smooth(1).few(1);
const PATHS: [Path; 3] = [Path::UThenV, Path::VThenU, Path::Both];
const NORMS: [Norm; 2] = [Norm::Coefficients, Norm::L2];

fn scales(s: &Surface<Q, 2>, degree: usize, spans: usize) -> Result<(SplineSpace<Q>, SplineSpace<Q>)> {
    let one = |d: Direction| {
        let (a, b) = s.space(d).domain();
        if s.space(d).is_periodic() {
            SplineSpace::uniform_periodic(degree, spans, a.clone(), b.clone())
        } else {
            SplineSpace::uniform(degree, spans, a.clone(), b.clone())
        }
    };
    Ok((one(U)?, one(V)?))
}

fn filled(scales: &(SplineSpace<Q>, SplineSpace<Q>), pool: &[Q]) -> Result<TensorSpline<Q>> {
    let count = scales.0.dim() * scales.1.dim();
    let values = (0..count).map(|i| pool[(5 * i + i * i) % pool.len()].clone()).collect();
    TensorSpline::new(scales.0.clone(), scales.1.clone(), values)
}

/// `|α - β|²` by a norm.
fn distance(one: &TensorSpline<Q>, other: &TensorSpline<Q>, norm: Norm) -> Result<Q> {
    let gap = one.difference(other)?;
    Ok(match norm {
        Norm::Coefficients => Q::dot(gap.coeffs().iter().zip(gap.coeffs())),
        Norm::L2 => gap.times(&gap)?.integral()?,
    })
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn edges_are_kept_exactly(
        s in surface::<2>(SHAPE, SHAPE),
        edges in subsequence(Edge::ALL.to_vec(), 1..=4),
        order in 0_usize..2,
        pool in coeffs(number().boxed()),
        path in select(&PATHS[..]),
        norm in select(&NORMS[..]),
    ) {
        let pair = scales(&s, 2, 2)?;
        let conditions: Vec<_> = edges.iter().map(|edge| SurfaceCondition::Edge { edge: *edge, order }).collect();
        let wanted = filled(&pair, &pool)?;
        let nearest = NearestScale::on_surface(&s, (&pair.0, &pair.1), path, &conditions, norm)?;
        let alpha = nearest.to_signed(&wanted)?;
        let tuned = s.fine_tuned(Scale::Signed(&alpha), path)?;
        for edge in &edges {
            let (a, b) = s.space(edge.direction()).domain();
            let end = if edge.is_end() { b } else { a };
            for x in probes(s.space(edge.direction().other())) {
                let (u, v) = if edge.direction() == U { (end, &x) } else { (&x, end) };
                let [found, was] = [&tuned, &s].map(|s| s.derivatives_at(u, v, order));
                let (found, was) = (found?, was?);
                for k in 0..=order {
                    let across = |all: &[Vec<SVector<Q, 2>>]| if edge.direction() == U { all[k][0].clone() } else { all[0][k].clone() };
                    prop_assert_eq!(across(&found), across(&was), "{} {}", edge, k);
                }
            }
        }
        // One is a scale that does so too: none is farther than that, and asking again changes nothing.
        let one = TensorSpline::constant(pair.0.clone(), pair.1.clone(), Q::int(1))?;
        prop_assert!(distance(&alpha, &wanted, norm)? <= distance(&one, &wanted, norm)?);
        prop_assert_eq!(&nearest.to_signed(&alpha)?, &alpha);
        prop_assert_eq!(nearest.to(&one)?, one);
        // The change is across all changes that keep the conditions: α to one is one of them.
        let square = distance(&alpha, &wanted, norm)? + distance(&alpha, &one_like(&pair)?, norm)?;
        prop_assert_eq!(square, distance(&one_like(&pair)?, &wanted, norm)?);
        let tuner = SurfaceTuner::constrained(&s, (&pair.0, &pair.1), path, &conditions, norm)?.signed();
        prop_assert_eq!(tuner.tuned(wanted.coeffs())?, tuned);
    }

    #[test]
    fn floats_keep_edges(
        s in surface::<2>(SHAPE, SHAPE),
        edges in subsequence(Edge::ALL.to_vec(), 1..=4),
        pool in coeffs(number().boxed()),
        path in select(&PATHS[..]),
    ) {
        let (s, wanted) = (s.to_f64()?, filled(&scales(&s, 2, 4)?, &pool)?.to_f64()?);
        let conditions: Vec<_> = edges.iter().map(|edge| SurfaceCondition::Edge { edge: *edge, order: 0 }).collect();
        let scales = (wanted.u(), wanted.v());
        let nearest = NearestScale::on_surface(&s, scales, path, &conditions, Norm::Coefficients)?;
        let alpha = nearest.to_signed(&wanted)?;
        let tuned = s.fine_tuned(Scale::Signed(&alpha), path)?;
        let most = |c: &[f64]| c.iter().fold(1.0, |m: f64, x| m.max(x.abs()));
        let coordinates: Vec<f64> = s.coeffs().iter().flat_map(|c| c.iter().copied()).collect();
        let size = most(&coordinates) * most(wanted.coeffs());
        for edge in &edges {
            let (a, b) = s.space(edge.direction()).domain();
            let end = if edge.is_end() { b } else { a };
            let [found, was] = [&tuned, &s].map(|s| s.isocurve(edge.direction(), end));
            prop_assert!(found?.distance_bound(&was?)? <= 1e-9 * size, "{}", edge);
        }
    }

    #[test]
    fn rings_close(
        s in surface::<2>(RING.of_degree(1, 2).smooth(1).few(2), ANY.of_degree(1, 2).smooth(1).few(1)),
        pool in coeffs(number().boxed()),
        path in select(&PATHS[..]),
    ) {
        let pair = scales(&s, 2, 3)?;
        let closed = [SurfaceCondition::Closed { direction: U }];
        let nearest = NearestScale::on_surface(&s, (&pair.0, &pair.1), path, &closed, Norm::Coefficients)?;
        let tuned = s.fine_tuned(Scale::Signed(&nearest.to_signed(&filled(&pair, &pool)?)?), path)?;
        let (a, b) = s.u().domain();
        prop_assert_eq!(tuned.isocurve(U, a)?, tuned.isocurve(U, b)?);
        // Nor is there a kink, where the surface has none.
        let smooth = s.u().breaks().iter().all(|(t, n)| (t != a && t != b) || *n < s.u().degree());
        if smooth && s.v().breaks().iter().all(|(_, n)| *n <= s.v().degree()) {
            for v in probes(s.v()) {
                prop_assert_eq!(tuned.derivative_at(a, &v, 1, 0)?, tuned.derivative_at(b, &v, 1, 0)?);
            }
            // So it is periodic again.
            let ring = s.u().product_space(&pair.0)?;
            let periodic = tuned.along(U, |rows| Ok(rows.projected(&ring, Contact::FREE)?.spline))?;
            prop_assert!(periodic.clamped_ends()?.same_function(&tuned)?);
        }
    }

    #[test]
    fn points_derivatives_and_values_are_met(
        (s, other) in surface_and_field::<2>([SHAPE; 2], [SHAPE; 2]),
        places in vec(any::<Index>(), 4),
        order in (0_usize..2, 0_usize..2),
        (to, value) in (point::<2>(), number()),
        path in select(&PATHS[..]),
        norm in select(&NORMS[..]),
    ) {
        let pair = scales(&s, 2, 2)?;
        let at = |i: usize| {
            let (us, vs) = (probes(s.u()), probes(s.v()));
            (places[i].get(&us).clone(), places[i + 1].get(&vs).clone())
        };
        let conditions = [
            SurfaceCondition::Derivative { at: at(0), order, value: to.clone() },
            SurfaceCondition::Scale { at: at(2), value: value.clone() },
            SurfaceCondition::Coefficient { index: (1, 2), value: Q::int(2) },
        ];
        let nearest = NearestScale::on_surface(&s, (&pair.0, &pair.1), path, &conditions, norm)?;
        match nearest.to_signed(&filled(&pair, other.coeffs())?) {
            Ok(alpha) => {
                let tuned = s.fine_tuned(Scale::Signed(&alpha), path)?;
                let (u, v) = at(0);
                prop_assert_eq!(tuned.derivative_at(&u, &v, order.0, order.1)?, to);
                let (u, v) = at(2);
                prop_assert_eq!(alpha.at(&u, &v)?, value);
                prop_assert_eq!(alpha.coeff(1, 2), Some(&Q::int(2)));
            }
            Err(error) => {
                let clash = matches!(error, Error::Clash { .. });
                prop_assert!(clash, "{error:?}");
            }
        }
    }

    #[test]
    fn positive_scales_are_found_or_refused(
        s in surface::<2>(CLAMPED.of_degree(1, 1).few(0), CLAMPED.of_degree(1, 1).few(0)),
        values in vec(-3_i64..12, 23),
        path in select(&PATHS[..]),
    ) {
        let pair = scales(&s, 1, 3)?;
        let wanted = filled(&pair, &values.iter().map(|n| Q::frac(*n, 4)).collect::<Vec<_>>())?;
        let edges = [Edge::VStart, Edge::VEnd].map(|edge| SurfaceCondition::Edge { edge, order: 0 });
        let nearest = NearestScale::on_surface(&s, (&pair.0, &pair.1), path, &edges, Norm::Coefficients)?;
        match nearest.to(&wanted) {
            Ok(alpha) => {
                prop_assert!(alpha.positive_bound()? > Q::int(0));
                let tuned = s.fine_tuned(&alpha, path)?;
                for edge in [Edge::VStart, Edge::VEnd] {
                    let (a, b) = s.v().domain();
                    let end = if edge.is_end() { b } else { a };
                    prop_assert!(tuned.isocurve(V, end)?.same_function(&s.isocurve(V, end)?)?);
                }
                let free = nearest.to_signed(&wanted)?;
                prop_assert!(distance(&free, &wanted, Norm::Coefficients)? <= distance(&alpha, &wanted, Norm::Coefficients)?);
            }
            Err(error) => {
                let refused = matches!(error, Error::Tune(TuneError::NoPositiveScale { .. }));
                prop_assert!(refused, "{error:?}");
            }
        }
    }
}

fn one_like(pair: &(SplineSpace<Q>, SplineSpace<Q>)) -> Result<TensorSpline<Q>> {
    TensorSpline::constant(pair.0.clone(), pair.1.clone(), Q::int(1))
}

#[test]
fn bad_conditions_are_refused() {
    let line = SplineSpace::bezier(1, 0.0, 1.0).expect("a line");
    let ring = SplineSpace::uniform_periodic(2, 4, 0.0, 1.0).expect("a ring");
    let points = (0..8).map(|i| SVector::<f64, 2>::new(f64::from(i % 3), f64::from(i))).collect();
    let tube = Surface::new(ring, line.clone(), points).expect("a tube");
    let refusal = |condition: SurfaceCondition<f64, 2>| {
        let scales = (&line, &line);
        NearestScale::on_surface(&tube, scales, Path::Both, &[condition], Norm::L2).expect_err("refused")
    };
    let edge = SurfaceCondition::Edge { edge: Edge::UStart, order: 0 };
    assert_eq!(refusal(edge), TuneError::NoEdge { direction: "u".into() }.into());
    let edge = SurfaceCondition::Edge { edge: Edge::VEnd, order: usize::MAX };
    assert!(matches!(refusal(edge), Error::CoefficientCount { .. }));
    let outside = SurfaceCondition::Scale { at: (0.5, 1.5), value: 1.0 };
    assert!(matches!(refusal(outside), Error::OutsideDomain { .. }));
    let derivative = |v: f64, value: f64| SurfaceCondition::Derivative {
        at: (0.5, v),
        order: (0, 0),
        value: SVector::repeat(value),
    };
    assert!(matches!(refusal(derivative(2.0, 0.0)), Error::OutsideDomain { .. }));
    assert_eq!(refusal(derivative(0.5, f64::NAN)), Error::NotFinite { what: "condition", index: 0 });
    let missing = SurfaceCondition::Coefficient { index: (0, 2), value: 1.0 };
    assert_eq!(refusal(missing), Error::IndexOutOfRange { index: 2, length: 2 });
}

#[test]
fn floats_find_the_freedom_that_fractions_have() {
    let scales = SplineSpace::uniform(1, 5, Q::int(0), Q::int(1)).expect("a space");
    let shape = SplineSpace::bezier(2, Q::int(0), Q::int(1)).expect("a space");
    let points =
        (0..9).map(|i| SVector::<Q, 2>::new(Q::int(i / 3 + i * i % 2), Q::int(i % 3 + i * i % 5))).collect();
    let s = Surface::new(shape.clone(), shape, points).expect("a surface");
    let one = TensorSpline::constant(scales.clone(), scales, Q::int(1)).expect("a scale");
    let (near, rounded) = (s.to_f64().expect("finite"), one.to_f64().expect("finite"));
    for path in PATHS {
        for count in 1..=4 {
            let edges = &Edge::ALL[..count];
            let exact: Vec<_> =
                edges.iter().map(|edge| SurfaceCondition::Edge { edge: *edge, order: 0 }).collect();
            let floats: Vec<_> =
                edges.iter().map(|edge| SurfaceCondition::Edge { edge: *edge, order: 0 }).collect();
            let norm = Norm::Coefficients;
            let exact = NearestScale::on_surface(&s, (one.u(), one.v()), path, &exact, norm).expect("rows");
            let found = NearestScale::on_surface(&near, (rounded.u(), rounded.v()), path, &floats, norm);
            assert_eq!(found.expect("rows").rank(), exact.rank(), "{path:?} {count}");
            assert!(exact.rank() < 36);
        }
    }
}

#[test]
fn floats_tell_rounding_from_contradictions() -> Result<()> {
    let line = SplineSpace::bezier(2, 0.0, 1.0)?;
    let scales = SplineSpace::uniform(2, 3, 0.0, 1.0)?;
    let wanted = TensorSpline::constant(scales.clone(), scales.clone(), 2.0)?;
    for size in [1e-300, 1e-12, 1.0, 1e150] {
        let points = (0..9)
            .map(|i| SVector::<f64, 2>::new(f64::from(i / 3 + i % 2) / 7.0, f64::from(i % 3) / 3.0) * size);
        let s = Surface::new(line.clone(), line.clone(), points.collect())?;
        let all = Edge::ALL.map(|edge| SurfaceCondition::Edge { edge, order: 0 });
        for path in PATHS {
            let with = |at: (f64, f64), by: f64| {
                let value = s.at(&at.0, &at.1)? + SVector::repeat(by * size);
                let conditions =
                    [&all[..], &[SurfaceCondition::Derivative { at, order: (0, 0), value }]].concat();
                NearestScale::on_surface(&s, (&scales, &scales), path, &conditions, Norm::L2)?
                    .to_signed(&wanted)
            };
            // Near the corner nothing depends on the scale, and on an edge the edge tells.
            for at in
                [(0.0, 0.0), (1e-13, 1e-14), (1e-9, 1e-9), (1e-7, 0.0), (1.0, 1e-8), (0.0, 0.3), (1.0, 1.0)]
            {
                assert!(with(at, 0.0).is_ok(), "{size} {path:?} {at:?}: {:?}", with(at, 0.0));
                assert!(
                    matches!(with(at, 1e-6), Err(Error::Clash { condition: 4 })),
                    "{size} {path:?} {at:?}"
                );
            }
        }
    }
    Ok(())
}

#[test]
fn derivatives_over_long_domains_are_met() -> Result<()> {
    // Weights of the order of 1e-20 are no rounding here.
    let [shape, scales] = [1, 3].map(|spans| SplineSpace::uniform(2, spans, 0.0, 1e5));
    let (shape, scales) = (shape?, scales?);
    let points = (0..9).map(|i| SVector::<f64, 2>::new(f64::from(i * i % 5), f64::from(7 * i % 4)));
    let s = Surface::new(shape.clone(), shape, points.collect())?;
    let at = (3e4, 7e4);
    let value = SVector::<f64, 2>::new(1e-20, -2e-20);
    let condition = SurfaceCondition::Derivative { at, order: (2, 2), value };
    let nearest = NearestScale::on_surface(&s, (&scales, &scales), Path::Both, &[condition], Norm::L2)?;
    let wanted = TensorSpline::constant(scales.clone(), scales, 1.0)?;
    let tuned = s.fine_tuned(Scale::Signed(&nearest.to_signed(&wanted)?), Path::Both)?;
    assert!((tuned.derivative_at(&at.0, &at.1, 2, 2)? - value).norm() < 1e-30);
    Ok(())
}
