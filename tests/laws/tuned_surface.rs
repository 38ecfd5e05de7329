//! Laws of surfaces with scaled derivatives along one path or two, exact.

use crate::strategies::{ANY, Kind, RING, cases, number, point, probe_pairs, surface_and_field};
use nalgebra::SVector;
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::Direction::{self, U, V};
use symspline::{
    Approximation, Edge, Error, Path, Q, Result, Scalar, Scale, SplineSpace, Surface, SurfaceTuner,
    TensorSpline,
};

const SHAPE: Kind = ANY.of_degree(1, 3).smooth(1).few(2);
const SCALE: Kind = ANY.of_degree(0, 2).few(2);
const PATHS: [Path; 3] = [Path::UThenV, Path::VThenU, Path::Both];

fn drawn() -> impl Strategy<Value = (Surface<Q, 2>, TensorSpline<Q>)> {
    surface_and_field([SHAPE, SHAPE], [SCALE, SCALE])
}

/// The same function of open spaces.
fn opened<const N: usize>(s: &Surface<Q, N>) -> Result<Surface<Q, N>> {
    s.clamped_ends()
}

fn same<const N: usize>(s: &Surface<Q, N>, t: &Surface<Q, N>) -> Result<bool> {
    opened(s)?.same_function(&opened(t)?)
}

fn one_like(alpha: &TensorSpline<Q>) -> Result<TensorSpline<Q>> {
    TensorSpline::constant(alpha.u().clone(), alpha.v().clone(), Q::int(1))
}

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn a_scale_of_one_gives_the_surface_back((s, alpha) in drawn()) {
        let one = one_like(&alpha)?;
        for path in PATHS {
            prop_assert!(same(&s.fine_tuned(&one, path)?, &s)?);
        }
        for edge in Edge::ALL {
            prop_assert!(same(&s.fine_tuned_from(&one, edge)?, &s)?);
        }
    }

    #[test]
    fn along_the_path_the_derivative_is_scaled((s, alpha) in drawn()) {
        for (path, last) in [(Path::UThenV, V), (Path::VThenU, U)] {
            let scaled = s.derivative(last)?.times(&alpha)?;
            let tuned = s.fine_tuned(Scale::Signed(&alpha), path)?;
            prop_assert!(same(&tuned.derivative(last)?, &scaled)?);
            // The edge where it starts is tuned along itself.
            let start = s.space(last).domain().0;
            let edge = s.isocurve(last, start)?.fine_tuned(Scale::Signed(&alpha.isocurve(last, start)?))?;
            prop_assert!(tuned.isocurve(last, start)?.same_function(&edge)?);
        }
    }

    #[test]
    fn two_paths_are_the_mean((s, alpha) in drawn()) {
        let [uv, vu, both] = PATHS.map(|path| s.fine_tuned(Scale::Signed(&alpha), path));
        prop_assert_eq!(uv?.sum(&vu?)?.scaled(&Q::frac(1, 2))?, both?);
    }

    #[test]
    fn from_an_edge_the_derivative_away_is_scaled((s, alpha) in drawn()) {
        for edge in Edge::ALL {
            let (last, (a, b)) = (edge.direction(), s.space(edge.direction()).domain());
            let tuned = s.fine_tuned_from(Scale::Signed(&alpha), edge)?;
            prop_assert!(same(&tuned.derivative(last)?, &s.derivative(last)?.times(&alpha)?)?);
            // The isocurve at the end of a ring is the one at its start.
            let at = if edge.is_end() { b } else { a };
            let [kept, was] = [&tuned, &s].map(|s| s.isocurve(last, at).and_then(|curve| curve.clamped_ends()));
            prop_assert!(kept?.same_function(&was?)?);
            let ring = s.space(last.other()).is_periodic() && alpha.space(last.other()).is_periodic();
            prop_assert_eq!(tuned.space(last.other()).is_periodic(), ring);
        }
    }

    #[test]
    fn tuning_is_linear_in_the_scale((s, alpha) in drawn(), weight in number()) {
        let one = one_like(&alpha)?;
        let mixed = alpha.plus_scaled(&weight, &one)?;
        for path in PATHS {
            let [plain, mixed] = [&alpha, &mixed].map(|a| s.fine_tuned(Scale::Signed(a), path));
            let (a, c) = (s.u().domain().0, s.v().domain().0);
            let from_corner = opened(&s)?.translated(&-s.at(a, c)?)?;
            prop_assert!(same(&plain?.plus_scaled(&weight, &from_corner)?, &mixed?)?);
        }
    }

    #[test]
    fn exchanging_the_parameters_exchanges_the_paths((s, alpha) in drawn()) {
        let turned = s.transposed().fine_tuned(Scale::Signed(&alpha.transposed()), Path::VThenU)?;
        prop_assert_eq!(turned.transposed(), s.fine_tuned(Scale::Signed(&alpha), Path::UThenV)?);
        let both = s.transposed().fine_tuned(Scale::Signed(&alpha.transposed()), Path::Both)?;
        prop_assert_eq!(both.transposed(), s.fine_tuned(Scale::Signed(&alpha), Path::Both)?);
    }

    #[test]
    fn the_gap_between_the_paths_is_what_the_derivatives_say((s, alpha) in drawn()) {
        let gap = s.path_gap(&alpha)?;
        let bound = gap.bound.clone() * &gap.bound;
        for (u, v) in probe_pairs(&gap.difference) {
            let d = gap.difference.at(&u, &v)?;
            prop_assert!(d[0].clone() * &d[0] + d[1].clone() * &d[1] <= bound);
        }
        // α has derivatives where it may not jump.
        if let (Ok(along_u), Ok(along_v)) = (alpha.derivative(U), alpha.derivative(V)) {
            let twist = s.derivative(V)?.times(&along_u)?.difference(&s.derivative(U)?.times(&along_v)?)?;
            let [du, dv] = [U, V].map(|d| gap.difference.along(d, |rows| rows.derivative()));
            prop_assert!(same(&du?.derivative(V)?, &twist)?);
            prop_assert!(dv.is_ok());
            prop_assert_eq!(gap.bound == Q::int(0), twist.coeffs().iter().all(|c| c.iter().all(|x| *x == Q::int(0))));
        }
    }

    #[test]
    fn a_tuner_tunes_as_the_operator_does((s, alpha) in drawn()) {
        for path in PATHS {
            let tuner = SurfaceTuner::free(&s, (alpha.u(), alpha.v()), path)?.signed();
            prop_assert_eq!(tuner.tuned(alpha.coeffs())?, s.fine_tuned(Scale::Signed(&alpha), path)?);
        }
    }

    #[test]
    fn scales_are_proved_positive((s, alpha) in drawn()) {
        let tuner = SurfaceTuner::free(&s, (alpha.u(), alpha.v()), Path::UThenV)?;
        let lowest = alpha.range(&Q::frac(1, 100))?.least;
        match s.fine_tuned(&alpha, Path::UThenV) {
            Ok(tuned) => {
                prop_assert!(lowest.value > Q::int(0));
                prop_assert_eq!(tuner.tuned(alpha.coeffs())?, tuned);
            }
            Err(error) => {
                let refused = matches!(error, Error::NotPositive { .. } | Error::Undecided);
                prop_assert!(refused && lowest.bound <= Q::int(0));
                prop_assert_eq!(tuner.tuned(alpha.coeffs()).unwrap_err(), error);
            }
        }
    }

    #[test]
    fn what_is_near_stays_near(
        (s, alpha) in surface_and_field::<2>([SHAPE.of_degree(1, 2); 2], [SCALE; 2]), shift in vec(point::<2>(), 7),
    ) {
        let by = |k: usize| shift[k * k % 7].map(|x| x / Q::int(100));
        let moved = s.coeffs().iter().enumerate().map(|(k, c)| c + by(k)).collect();
        let near = Surface::new(s.u().clone(), s.v().clone(), moved)?;
        let difference = near.difference(&s)?;
        let size = |c: &SVector<Q, 2>| c[0].magnitude() + c[1].magnitude();
        let bound = difference.coeffs().iter().map(size).max().expect("coefficients");
        let near = Approximation { spline: near, bound };
        for path in PATHS {
            let tuned = near.fine_tuned(Scale::Signed(&alpha), path)?;
            let gap = tuned.spline.difference(&s.fine_tuned(Scale::Signed(&alpha), path)?)?;
            let square = tuned.bound.clone() * &tuned.bound;
            for (u, v) in probe_pairs(&gap) {
                let d = gap.at(&u, &v)?;
                prop_assert!(d[0].clone() * &d[0] + d[1].clone() * &d[1] <= square);
            }
        }
    }

    #[test]
    fn floats_stay_near((s, alpha) in drawn()) {
        let (near, scale) = (s.to_f64()?, alpha.to_f64()?);
        for path in PATHS {
            let exact = near.to_exact()?.fine_tuned(Scale::Signed(&scale.to_exact()?), path)?;
            let tuner = SurfaceTuner::free(&near, (scale.u(), scale.v()), path)?.signed();
            for tuned in [near.fine_tuned(Scale::Signed(&scale), path)?, tuner.tuned(scale.coeffs())?] {
                let most = |c: &[SVector<f64, 2>]| c.iter().flat_map(|c| c.iter()).fold(0.0, |m: f64, x| m.max(x.abs()));
                let lengths: f64 = [U, V].map(|d| length(&near, d)).iter().sum();
                let size = most(near.coeffs()) + lengths * scale.coeffs().iter().fold(0.0, |m: f64, x| m.max(x.abs()));
                for (c, e) in tuned.coeffs().iter().zip(exact.coeffs()) {
                    let off = (0..2).map(|i| (c[i] - e[i].to_f64()).abs()).fold(0.0, f64::max);
                    prop_assert!(off <= 1e-12 * size, "{off} of {size}");
                }
            }
        }
    }
}

/// The largest coefficient of a derivative times the length of the domain.
fn length(s: &Surface<f64, 2>, direction: Direction) -> f64 {
    let (a, b) = s.space(direction).domain();
    let speeds = s.derivative(direction).expect("no jumps").into_coeffs();
    speeds.iter().flat_map(|c| c.iter()).fold(0.0, |m: f64, x| m.max(x.abs())) * (b - a)
}

#[test]
fn a_tube_from_its_edge_stays_a_tube() {
    use proptest::strategy::ValueTree;
    use proptest::test_runner::TestRunner;
    let rings =
        surface_and_field::<3>([RING.of_degree(2, 3).smooth(1), SHAPE], [RING.of_degree(1, 2), SCALE]);
    let (s, alpha) = rings.new_tree(&mut TestRunner::deterministic()).expect("a surface").current();
    let edge = if s.v().is_periodic() { return } else { Edge::VStart };
    let tuned = s.fine_tuned_from(Scale::Signed(&alpha), edge).expect("no jumps");
    assert!(tuned.u().is_periodic());
}

#[test]
fn the_gap_of_floats_counts_rounding_before_the_domain() -> Result<()> {
    // The corner is a mean of control points far outside, none of which the speed inside tells of.
    let space = |end: f64| SplineSpace::new(3, [-3.0, -2.0, -1.0, 0.0, end, end + 1.0, end + 2.0, end + 3.0]);
    let points = (0..16).map(|i: i32| {
        if i == 0 {
            SVector::zeros()
        } else {
            SVector::<f64, 2>::new(f64::from(7 * i % 11) / 3.0, f64::from(i * i % 7) / 7.0)
        }
    });
    for end in [1e-3, 1e-6] {
        let s = Surface::new(space(end)?, space(end)?, points.clone().collect())?;
        let flat = SplineSpace::bezier(1, 0.0, end)?;
        let alpha = TensorSpline::new(flat.clone(), flat, [1.0, -1.0, 2.0, 3.0].map(|a| a * 1e-9).to_vec())?;
        let gap = s.path_gap(&alpha)?;
        let exact = s.to_exact()?.path_gap(&alpha.to_exact()?)?.difference;
        let off = exact.difference(&gap.difference.to_exact()?)?.to_f64()?;
        let most = |s: &Surface<f64, 2>| s.coeffs().iter().map(|c| c.norm()).fold(0.0, f64::max);
        assert!(most(&off) > 0.0 && most(&off) <= gap.bound - most(&gap.difference), "{end}");
    }
    Ok(())
}
