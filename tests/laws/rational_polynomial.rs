//! Polynomial splines near rational ones: the bound holds at every parameter, over `Q` and of `f64` against the exact answer.

use crate::strategies::{ANY, CLAMPED, Kind, OPEN, RING, cases, function, space};
use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{
    Approximation, Coeff, Error, Function, NurbsCurve, NurbsSurface, Q, Rational, RationalFunction, Scalar,
    Spline, SplineSpace, TensorSpline, Weighted, circle,
};

/// A rational curve with moderate numbers: what is far from polynomial takes long over `Q`.
fn nurbs<const N: usize>(kind: Kind) -> impl Strategy<Value = NurbsCurve<Q, N>> {
    let (points, weights) = (vec(-9_i64..10, 48 * N), vec(1_i64..10, 48));
    (space(kind), points, weights).prop_map(|(space, points, weights)| {
        let points = points.chunks(N).map(|x| SVector::from_fn(|i, _| Q::int(x[i]))).take(space.dim());
        let (points, weights) =
            (points.collect(), weights.into_iter().map(Q::int).take(space.dim()).collect());
        NurbsCurve::new(space, points, weights).expect("valid input")
    })
}

fn nurbs_surface(kind: Kind) -> impl Strategy<Value = NurbsSurface<Q, 2>> {
    let (points, weights) = (vec(-9_i64..10, 2 * 400), vec(1_i64..4, 400));
    (space(kind), space(kind), points, weights).prop_map(|(u, v, points, weights)| {
        let dim = u.dim() * v.dim();
        let points = points.chunks(2).map(|x| SVector::from_fn(|i, _| Q::int(x[i]))).take(dim).collect();
        NurbsSurface::new(u, v, points, weights.into_iter().map(Q::int).take(dim).collect())
            .expect("valid input")
    })
}

/// Parameters with those of the knots among them.
fn parameters(space: &SplineSpace<Q>, a_span: i64) -> Vec<Q> {
    let breaks = space.breaks();
    let between = |ends: &[(Q, usize)]| {
        let [a, b] = [0, 1].map(|i: usize| ends[i].0.clone());
        (0..=a_span).map(|i| a.clone() + (b.clone() - &a) * Q::frac(i, a_span)).collect::<Vec<_>>()
    };
    breaks.windows(2).flat_map(between).collect()
}

fn is_within<C: Coeff<Q>>(left: &C, right: &C, bound: &Q) -> bool {
    left.minus(right).squared_size() <= bound.clone() * bound
}

/// A tolerance in proportion to the values.
fn tolerance<C: Coeff<Q>>(values: impl IntoIterator<Item = C>, share: &Q) -> Q {
    let most = values.into_iter().map(|c| c.squared_size()).max().expect("a value");
    if most == Q::int(0) { share.clone() } else { most.root_above() * share }
}

/// The same ends, and copies of the old knots for the same smoothness.
fn is_like(near: &SplineSpace<Q>, space: &SplineSpace<Q>) -> bool {
    let raise = near.degree() - space.degree();
    let copies = |t: &Q| near.breaks().into_iter().find(|(s, _)| s == t).map(|(_, m)| m);
    let inner = space.breaks();
    near.is_periodic() == space.is_periodic()
        && near.is_clamped() == space.is_clamped()
        && near.domain() == space.domain()
        && inner[1..inner.len() - 1].iter().all(|(t, m)| copies(t) == Some(m + raise))
}

fn check_curve<const N: usize>(curve: &NurbsCurve<Q, N>, share: &Q) -> Result<(), TestCaseError> {
    let places = parameters(curve.space(), 3);
    let tolerance = tolerance(curve.eval(&places).expect("valid input"), share);
    let Approximation { spline, bound } = curve.polynomial_within(&tolerance).expect("valid input");
    prop_assert!(bound <= tolerance);
    prop_assert!(is_like(spline.space(), curve.space()));
    for x in parameters(spline.space(), 5) {
        prop_assert!(is_within(
            &spline.at(&x).expect("valid input"),
            &curve.at(&x).expect("valid input"),
            &bound
        ));
        prop_assert!(is_within(
            &spline.at_left(&x).expect("valid input"),
            &curve.at_left(&x).expect("valid input"),
            &bound
        ));
    }
    if curve.space().is_clamped() {
        let (a, b) = curve.domain();
        prop_assert_eq!(spline.at(a).expect("valid input"), curve.at(a).expect("valid input"));
        prop_assert_eq!(spline.at(b).expect("valid input"), curve.at(b).expect("valid input"));
    }
    Ok(())
}

fn check_surface(surface: &NurbsSurface<Q, 2>, share: &Q) -> Result<(), TestCaseError> {
    let (us, vs) = (parameters(surface.u(), 2), parameters(surface.v(), 2));
    let tolerance = tolerance(surface.eval_grid(&us, &vs).expect("valid input"), share);
    let Approximation { spline, bound } = surface.polynomial_within(&tolerance).expect("valid input");
    prop_assert!(bound <= tolerance);
    prop_assert!(is_like(spline.u(), surface.u()) && is_like(spline.v(), surface.v()));
    let (us, vs) = (parameters(spline.u(), 3), parameters(spline.v(), 3));
    let pairs = spline
        .eval_grid(&us, &vs)
        .expect("valid input")
        .into_iter()
        .zip(surface.eval_grid(&us, &vs).expect("valid input"));
    for (near, value) in pairs {
        prop_assert!(is_within(&near, &value, &bound));
    }
    if surface.u().is_clamped() && surface.v().is_clamped() {
        let (u, v) = (surface.u().domain(), surface.v().domain());
        for (u, v) in [(u.0, v.0), (u.0, v.1), (u.1, v.0), (u.1, v.1)] {
            prop_assert_eq!(spline.at(u, v).expect("valid input"), surface.at(u, v).expect("valid input"));
        }
    }
    Ok(())
}

fn is_refusal(error: &Error) -> bool {
    matches!(error, Error::OutOfTolerance { .. } | Error::Undecided)
}

/// The approximation of the rounded curve, looked at without rounding.
fn check_floats<const N: usize>(curve: &NurbsCurve<Q, N>, share: &Q) -> Result<(), TestCaseError> {
    let Ok(rounded) = curve.to_f64() else { return Ok(()) };
    let exact = rounded.to_exact().expect("valid input");
    let places = parameters(exact.space(), 3);
    let tolerance = tolerance(exact.eval(&places).expect("valid input"), share).to_f64();
    let near = match rounded.polynomial_within(&tolerance) {
        Ok(near) => near,
        Err(error) => {
            prop_assert!(is_refusal(&error));
            return Ok(());
        }
    };
    prop_assert!(near.bound <= tolerance);
    let (spline, bound) =
        (near.spline.to_exact().expect("valid input"), Q::try_from(near.bound).expect("valid input"));
    for x in parameters(spline.space(), 3) {
        prop_assert!(is_within(
            &spline.at(&x).expect("valid input"),
            &exact.at(&x).expect("valid input"),
            &bound
        ));
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(8))]

    #[test]
    fn the_bound_holds_for_curves(curve in nurbs::<2>(ANY.of_degree(0, 3).few(2))) {
        check_curve(&curve, &Q::frac(1, 10))?;
    }

    #[test]
    fn the_bound_holds_in_high_degree(curve in nurbs::<1>(ANY.of_degree(4, 4).few(0))) {
        check_curve(&curve, &Q::frac(1, 4))?;
    }

    #[test]
    fn rings_stay_rings(curve in nurbs::<3>(RING.of_degree(1, 3).few(2))) {
        check_curve(&curve, &Q::frac(1, 20))?;
    }

    #[test]
    fn the_bound_of_floats_holds(curve in nurbs::<2>(ANY.of_degree(0, 4).few(2)), digits in 1_u32..9) {
        check_floats(&curve, &Q::frac(1, 10_i64.pow(digits)))?;
    }

    #[test]
    fn polynomials_in_disguise_are_found(
        f in function(OPEN.of_degree(0, 3).few(2)),
        g in function(OPEN.of_degree(0, 2).few(1)),
        weight in (1_i64..9).prop_map(|w| Q::frac(w, 7)),
    ) {
        let lift = f.map_scalars(|x| Ok(x.clone())).unwrap();
        let points: Vec<_> = lift.coeffs().iter().map(|c| Weighted::new(c, weight.clone())).collect();
        let lifted = Spline::new(lift.space().clone(), points).unwrap();
        let near = RationalFunction::from_lifted(lifted).unwrap().polynomial_within(&Q::int(0)).unwrap();
        prop_assert_eq!((&near.spline, &near.bound), (&f, &Q::int(0)));
        // A factor above and below.
        let (a, b) = f.domain();
        let g = g.reparametrised(a, b).unwrap();
        let g = g.times(&g).unwrap().translated(&Q::int(1)).unwrap();
        let same = RationalFunction::from_quotient(&f.times(&g).unwrap(), &g).unwrap();
        let near = same.polynomial_within(&Q::int(0)).unwrap();
        prop_assert_eq!(&near.bound, &Q::int(0));
        prop_assert!(near.spline.same_function(&f).unwrap());
    }

    #[test]
    fn what_is_not_polynomial_is_refused_at_zero(f in nurbs::<1>(CLAMPED.of_degree(1, 3).few(2))) {
        match f.polynomial_within(&Q::int(0)) {
            Ok(near) => {
                let same = NurbsCurve::from_polynomial(&near.spline).unwrap();
                prop_assert!(f.same_function(&same).unwrap());
            }
            Err(error) => prop_assert!(is_refusal(&error)),
        }
    }
}

proptest! {
    #![proptest_config(cases(2))]

    #[test]
    fn the_bound_holds_for_surfaces(surface in nurbs_surface(ANY.of_degree(1, 2).few(1))) {
        check_surface(&surface, &Q::frac(1, 3))?;
    }

    #[test]
    fn the_tuned_curve_is_as_near_as_promised(
        weights in vec(1_i64..6, 5),
        values in vec(-5_i64..6, 4),
    ) {
        let space = SplineSpace::clamped(2, [0, 1, 2, 4].map(Q::int)).unwrap();
        let points = [[0, 0], [1, 3], [3, 1], [4, 4], [6, 0]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
        let weights: Vec<Q> = weights.into_iter().map(Q::int).collect();
        let curve = NurbsCurve::new(space, points.to_vec(), weights).unwrap();
        let alpha = SplineSpace::clamped(1, [0, 1, 3, 4].map(Q::int)).unwrap();
        let alpha = Function::new(alpha, values.into_iter().map(Q::int).collect()).unwrap();
        let [rough, fine] = [10, 10_000].map(|n| {
            let near = curve.polynomial_within(&Q::frac(1, n)).unwrap();
            near.fine_tuned(symspline::Scale::Signed(&alpha)).unwrap()
        });
        let bound = rough.bound + fine.bound;
        for x in parameters(rough.spline.space(), 4) {
            prop_assert!(is_within(&rough.spline.at(&x).unwrap(), &fine.spline.at(&x).unwrap(), &bound));
        }
    }
}

fn unit() -> NurbsCurve<f64, 2> {
    circle(&vector![0.0, 0.0], &1.0).expect("valid input")
}

/// The surface that a circle sweeps around an axis.
fn torus() -> NurbsSurface<f64, 3> {
    let (space, around) = (unit().space().clone(), unit().into_lifted().into_coeffs());
    let sweep = |a: &Weighted<f64, SVector<f64, 2>>, b: &Weighted<f64, SVector<f64, 2>>| {
        let far = 3.0 * b.weight + b.point[0];
        let point = vector![a.point[0] * far, a.point[1] * far, a.weight * b.point[1]];
        Weighted { point, weight: a.weight * b.weight }
    };
    let grid = around.iter().flat_map(|a| around.iter().map(move |b| sweep(a, b))).collect();
    Rational::from_lifted(TensorSpline::new(space.clone(), space, grid).expect("valid input"))
        .expect("valid input")
}

#[test]
fn a_circle_takes_as_many_knots_as_the_order_says() {
    let dim = |degree: usize, tolerance: f64| -> f64 {
        let near = unit().polynomial_of_degree_within(degree, &tolerance).unwrap();
        assert_eq!(near.spline.degree(), degree);
        near.spline.space().dim() as f64
    };
    // Eight decades in degree 3 are a factor of 100, less what halving takes too much at the start.
    let cubic = dim(3, 1e-11) / dim(3, 1e-3);
    assert!((50.0..200.0).contains(&cubic), "{cubic}");
    // Six decades in degree 5 are a factor of 10.
    let quintic = dim(5, 1e-10) / dim(5, 1e-4);
    assert!((3.0..20.0).contains(&quintic), "{quintic}");
}

#[test]
fn a_torus_is_met() {
    let (torus, places) = (torus(), (0..=60).map(|i| f64::from(i) / 60.0).collect::<Vec<_>>());
    let near = torus.polynomial_within(&1e-3).unwrap();
    assert!(near.bound <= 1e-3 && near.spline.coeffs().len() < 50 * 50);
    let (found, expected) = (near.spline.eval_grid(&places, &places), torus.eval_grid(&places, &places));
    let off = found.unwrap().iter().zip(&expected.unwrap()).map(|(s, r)| (s - r).norm()).fold(0.0, f64::max);
    assert!(off <= near.bound && off > near.bound / 4.0, "{off} {}", near.bound);
}

#[test]
fn only_lines_that_are_needed_are_added() {
    let (circle, line) = (unit(), SplineSpace::clamped(1, [0.0, 1.0, 5.0]).unwrap());
    let rise = |c: &Weighted<f64, SVector<f64, 2>>, z: f64| Weighted {
        point: vector![c.point[0], c.point[1], z * c.weight],
        weight: c.weight,
    };
    let grid = circle.lifted().coeffs().iter().flat_map(|c| [0.0, 1.0, 5.0].map(|z| rise(c, z))).collect();
    let cylinder = TensorSpline::new(circle.space().clone(), line.clone(), grid).unwrap();
    let near = Rational::<symspline::Rectangle, _, _>::from_lifted(cylinder).unwrap();
    let near = near.polynomial_within(&1e-6).unwrap();
    assert_eq!(*near.spline.v(), line.elevated(2).unwrap());
    assert!(near.spline.u().dim() > 60);
    // A part that bends hard gets the knots.
    let space = SplineSpace::clamped(2, [0.0, 1.0, 2.0, 3.0, 4.0]).unwrap();
    let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 1.0], [3.0, 0.0], [4.0, 0.0], [5.0, 1.0]];
    let weights = vec![1.0, 1.0, 1.0, 1.0, 20.0, 1.0];
    let curve = NurbsCurve::new(space, points.map(SVector::from).to_vec(), weights).unwrap();
    let near = curve.polynomial_within(&1e-6).unwrap();
    let count =
        |a: f64, b: f64| near.spline.space().breaks().iter().filter(|(t, _)| a < *t && *t < b).count();
    assert!(count(0.0, 1.0) * 4 < count(3.0, 4.0), "{} {}", count(0.0, 1.0), count(3.0, 4.0));
}

#[test]
fn steps_that_rounding_leaves_off_are_refused() {
    let space = SplineSpace::clamped(0, [0.0, 1.0, 2.0]).unwrap();
    let steps =
        NurbsCurve::new(space.clone(), vec![vector![0.1, 0.7], vector![0.3, 0.2]], vec![3.0, 7.0]).unwrap();
    let near = steps.polynomial_of_degree_within(0, &1e-12).unwrap();
    assert!(near.spline.space() == &space && near.bound <= 1e-12);
    assert!(matches!(steps.polynomial_of_degree_within(0, &1e-15), Err(Error::OutOfTolerance { .. })));
}

#[test]
fn spans_too_narrow_to_be_halved_end_the_search() {
    // A span of few digits, far from zero: where the error is, there is soon no room for knots, and elsewhere much.
    let knots = [-139732.3828029511, -139732.13142138592, -139732.13142138493];
    let space = SplineSpace::periodic(1, knots, 0.7423485243).unwrap();
    let points = [[-0.26, -0.48], [-0.39, -0.31], [-0.01, 0.14]].map(SVector::from).to_vec();
    let curve = NurbsCurve::new(space, points, vec![7e5, 7e-3, 2e-5]).unwrap();
    let start = std::time::Instant::now();
    let near = curve.polynomial_of_degree_within(4, &1e-8);
    assert!(matches!(near, Err(Error::OutOfTolerance { .. })), "{near:?}");
    assert!(start.elapsed().as_secs_f64() < 60.0, "{:?}", start.elapsed());
}

#[test]
fn hostile_input_gives_a_value_or_an_error() {
    let space = SplineSpace::clamped(2, [0.0, 1e-9, 1.0, 1.0 + 1e-9, 1e6]).unwrap();
    let weights = vec![1.0, 1e6, 1.0, 1e-6, 1.0, 1e6];
    for size in [1e-300, 1.0, 1e300] {
        let points = (0..6).map(|i| vector![size * f64::from(i % 3), size * f64::from(i % 2)]).collect();
        let curve = NurbsCurve::new(space.clone(), points, weights.clone());
        let Ok(curve) = curve else { continue };
        for share in [1e-1, 1e-4, 0.0] {
            let tolerance = size * share;
            match curve.polynomial_within(&tolerance) {
                Ok(near) => {
                    assert!(near.bound <= tolerance);
                    for x in [0.0, 5e-10, 1e-9, 0.3, 1.0 + 2e-10, 77.0, 9e5] {
                        let off = near.spline.at(&x).unwrap() / size - curve.at(&x).unwrap() / size;
                        assert!(off.norm() <= share + 1e-12, "{size} {share} {x}");
                    }
                }
                Err(error) => assert!(matches!(
                    error,
                    Error::OutOfTolerance { .. } | Error::NotFinite { .. } | Error::Undecided
                )),
            }
        }
    }
    for wrong in [f64::NAN, f64::INFINITY, -1.0] {
        assert!(matches!(unit().polynomial_within(&wrong), Err(Error::BadTolerance { .. })));
    }
    assert!(matches!(unit().polynomial_within(&1e-15), Err(Error::OutOfTolerance { .. })));
    assert!(matches!(unit().polynomial_of_degree_within(1000, &0.1), Err(Error::DegreeTooHigh { .. })));
    let exact = circle(&vector![Q::int(0), Q::int(0)], &Q::int(1)).unwrap();
    assert!(matches!(exact.polynomial_within(&Q::int(0)), Err(Error::OutOfTolerance { .. })));
}
