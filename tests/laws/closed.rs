//! Laws of closed fine-tuned curves: springs at rest, with bounds, and Chaikin's rules, exactly.

use crate::strategies::{cases, number, point};
use nalgebra::{Rotation2, SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use symspline::{
    Curve, Error, Function, Jointed, Q, Relaxed, Result, Scalar, Scale, SplineSpace, Springs, TuneError,
};

/// A periodic space of period 12 over whole knots.
fn ring(degree: usize, knots: &[u32]) -> SplineSpace<f64> {
    let mut knots = [&[0], knots].concat();
    knots.sort_unstable();
    let runs = knots.chunk_by(u32::eq).flat_map(|run| run.iter().take(degree.max(1)));
    SplineSpace::periodic(degree, runs.map(|t| f64::from(*t)), 12.0).expect("a ring")
}

/// A curve round the origin, all its turns to one side or not, and a positive scale on other knots.
fn star() -> impl Strategy<Value = (Curve<f64, 3>, Function<f64>)> {
    let curve =
        (2_usize..=4, vec(select(vec![1_u32, 3, 4, 7, 10]), 0..4), vec((0.8_f64..1.2, -0.5_f64..0.5), 10));
    let scale = (0_usize..=2, vec(0_u32..12, 0..4), vec(0.6_f64..1.7, 5));
    (curve, scale).prop_map(|((p, knots, shape), (q, others, levels))| {
        // Five knots at least, so that it is a polygon.
        let space = ring(p, &[&[1, 3, 7, 10], &knots[..]].concat());
        let turn = std::f64::consts::TAU / space.dim() as f64;
        let place = |(i, (radius, height)): (usize, &(f64, f64))| {
            let (sin, cos) = (i as f64 * turn).sin_cos();
            vector![3.0 * radius * cos + 0.5, 2.0 * radius * sin, *height]
        };
        let points = shape[..space.dim()].iter().enumerate().map(place).collect();
        let scales = ring(q, &others);
        let levels = levels[..scales.dim()].to_vec();
        (Curve::new(space, points).expect("points"), Function::new(scales, levels).expect("levels"))
    })
}

fn flat(curve: &Curve<f64, 3>) -> Curve<f64, 2> {
    let points = curve.coeffs().iter().map(|p| vector![p[0], p[1]]).collect();
    Curve::new(curve.space().clone(), points).expect("as many points")
}

/// The relaxed curve, unless a leg has no length: knots may be so that a curve has a cusp.
fn relaxed<const N: usize>(
    curve: &Curve<f64, N>,
    alpha: &Function<f64>,
    springs: &Springs,
) -> Option<Relaxed<N>>
where
    SVector<f64, N>: Jointed,
{
    match curve.fine_tuned_closed(alpha, springs) {
        Ok(relaxed) => Some(relaxed),
        Err(Error::ZeroLeg { .. }) => None,
        Err(error) => panic!("{error}"),
    }
}

fn legs<const N: usize>(points: &[SVector<f64, N>]) -> Vec<SVector<f64, N>> {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(p, q)| q - p).collect()
}

/// The legs that the result would have if it were not closed, from the open result over the same knots.
fn wanted<const N: usize>(
    curve: &Curve<f64, N>,
    alpha: &Function<f64>,
    space: &SplineSpace<f64>,
) -> Result<Vec<SVector<f64, N>>> {
    let open = curve.fine_tuned(alpha)?.embedded(&space.unclamped_ends()?)?;
    Ok(open.coeffs().windows(2).map(|pair| pair[1] - pair[0]).take(space.dim()).collect())
}

/// The energy (13) as it is written, with lengths in units of `side`.
fn energy<const N: usize>(
    found: &[SVector<f64, N>],
    wanted: &[SVector<f64, N>],
    springs: &Springs,
    side: f64,
) -> f64
where
    SVector<f64, N>: Jointed,
{
    let angle = |legs: &[SVector<f64, N>], i: usize| {
        let before = legs[(i + legs.len() - 1) % legs.len()];
        before.normalize().turn_to(&legs[i].normalize()).angle
    };
    let mean = wanted.iter().map(SVector::norm).sum::<f64>() / wanted.len() as f64;
    let term = |i: usize| {
        let stretch = springs.stretch * if springs.uniform { mean / wanted[i].norm() } else { 1.0 };
        let missing = (wanted[i].norm() - found[i].norm()) / side;
        let excess = SVector::<f64, N>::excess(angle(wanted, i), angle(found, i));
        stretch * missing * missing + springs.bend * excess * excess
    };
    (0..found.len()).map(term).sum()
}

fn side<const N: usize>(curve: &Curve<f64, N>) -> f64 {
    let points = curve.coeffs();
    let sup = points.iter().fold(points[0], |box_end, p| box_end.sup(p));
    (sup - points.iter().fold(points[0], |box_start, p| box_start.inf(p))).max()
}

fn furthest<const N: usize>(p: &Curve<f64, N>, q: &Curve<f64, N>) -> f64 {
    assert_eq!(p.space(), q.space());
    p.coeffs().iter().zip(q.coeffs()).map(|(x, y)| (x - y).amax()).fold(0.0, f64::max)
}

/// The energies are those of (13), the result is periodic, and small moves of points that are not held take no energy away.
fn is_at_rest<const N: usize>(
    curve: &Curve<f64, N>,
    alpha: &Function<f64>,
    springs: &Springs,
) -> std::result::Result<(), TestCaseError>
where
    SVector<f64, N>: Jointed,
{
    let Some(found) = relaxed(curve, alpha, springs) else { return Ok(()) };
    let space = curve.derivative()?.space().product_space(alpha.space())?.antiderivative_space()?;
    prop_assert!(found.curve.space() == &space && space.is_periodic());
    // In space the last digits may take long; springs that are not uniform may press a leg to nothing.
    let pressed = found.length_deviation > 0.99 && !springs.uniform;
    prop_assert!(found.converged || N == 3 && found.gradient < 1e-2 || pressed, "{found:?}");
    prop_assert!(found.energy <= found.energy_before * (1.0 + 1e-14));
    let (wanted, side) = (wanted(curve, alpha, &space)?, side(curve));
    let at = |points: &[SVector<f64, N>]| energy(&legs(points), &wanted, springs, side);
    let (start, points) = (curve.embedded(&space)?, found.curve.coeffs());
    prop_assert!((at(start.coeffs()) - found.energy_before).abs() < 1e-11);
    prop_assert!(pressed || (at(points) - found.energy).abs() < 1e-11);
    for i in (0..points.len()).filter(|i| !springs.fixed.contains(i) && found.converged) {
        for axis in 0..N {
            let step = if N == 2 { 1e-4 } else { 1e-6 };
            let [up, down] = [step, -step].map(|step| {
                let mut moved = points.to_vec();
                moved[i][axis] += step;
                at(&moved)
            });
            // In space a curve may stay in a plane that it would rather leave.
            let (tilt, rise) = ((up - down).abs(), up + down - 2.0 * found.energy);
            let rests =
                if N == 2 { up.min(down) > found.energy - 1e-11 } else { tilt < 0.1 * rise.abs() + 1e-8 };
            prop_assert!(rests, "point {i}: {up} and {down} beside {}", found.energy);
        }
    }
    // No restriction but what keeps the chain from moving as a whole.
    let anchor = springs.fixed.first().copied().unwrap_or(0);
    if springs.fixed.iter().all(|&i| i == anchor) && !pressed {
        prop_assert!((points[anchor] - start.coeffs()[anchor]).norm() < 1e-14 * side);
        let direction = |points: &[SVector<f64, N>]| legs(points)[anchor].normalize();
        prop_assert!((direction(points) - direction(start.coeffs())).norm() < 1e-10);
    }
    for &i in &springs.fixed {
        prop_assert!((points[i] - start.coeffs()[i]).norm() < 1e-14 * side);
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn springs_come_to_rest((curve, alpha) in star(), bend in 0.1_f64..20.0, uniform in any::<bool>()) {
        let springs = Springs { bend, uniform, ..Springs::default() };
        is_at_rest(&flat(&curve), &alpha, &springs)?;
        is_at_rest(&curve, &alpha, &springs)?;
    }

    #[test]
    fn fixed_points_do_not_move((curve, alpha) in star(), stretch in 0.1_f64..10.0, fixed in vec(0_usize..7, 1..4)) {
        let count = curve.derivative()?.space().product_space(alpha.space())?.dim();
        let fixed = fixed.into_iter().map(|i| i % count).collect();
        let springs = Springs { stretch, fixed, uniform: true, ..Springs::default() };
        is_at_rest(&flat(&curve), &alpha, &springs)?;
        is_at_rest(&curve, &alpha, &springs)?;
    }

    #[test]
    fn scale_one_gives_the_curve_back((curve, alpha) in star()) {
        let one = Function::constant(alpha.space().clone(), 1.0)?;
        let Some(found) = relaxed(&curve, &one, &Springs::default()) else { return Ok(()) };
        prop_assert!(found.energy_before < 1e-24 && found.converged && found.iterations == 0, "{found:?}");
        prop_assert!(found.length_deviation < 1e-12 && found.angle_deviation < 1e-12);
        prop_assert!(furthest(&found.curve, &curve.embedded(found.curve.space())?) < 1e-13);
    }

    #[test]
    fn a_constant_scale_is_met((curve, alpha) in star(), factor in 0.3_f64..3.0) {
        let level = Function::constant(alpha.space().clone(), factor)?;
        let curve = flat(&curve);
        let Some(found) = relaxed(&curve, &level, &Springs::default()) else { return Ok(()) };
        prop_assert!(found.converged && found.energy < 1e-17, "{found:?}");
        prop_assert!(found.length_deviation < 1e-6 && found.angle_deviation < 1e-6, "{found:?}");
        let start = curve.embedded(found.curve.space())?;
        let first = start.coeffs()[0];
        let expected = start.translated(&-first)?.scaled(&factor)?.translated(&first)?;
        prop_assert!(furthest(&found.curve, &expected) < 1e-6);
    }

    #[test]
    fn motions_and_sizes_do_not_matter((curve, alpha) in star(), turn in -3.0_f64..3.0, size in -300_i32..300) {
        let springs = Springs { tolerance: 1e-11, uniform: true, ..Springs::default() };
        let size = 2.0_f64.powi(size);
        let plane = flat(&curve);
        let Some(found) = relaxed(&plane, &alpha, &springs) else { return Ok(()) };
        // A quarter turn keeps the longest side of the box, other turns need another prescale.
        let (quarter, shift) = (Rotation2::new(std::f64::consts::FRAC_PI_2), vector![7.0, -3.0]);
        let image = |c: &Curve<f64, 2>| {
            Curve::new(c.space().clone(), c.coeffs().iter().map(|p| (quarter * p + shift) * size).collect())
        };
        let Some(moved) = relaxed(&image(&plane)?, &alpha, &springs) else { return Ok(()) };
        prop_assert!((moved.energy - found.energy).abs() < 1e-12);
        prop_assert!(furthest(&moved.curve, &image(&found.curve)?) < 1e-6 * size);
        // Any turn, with the constant of the legs for the other side.
        let rotation = Rotation2::new(turn);
        let image = |c: &Curve<f64, 2>| {
            Curve::new(c.space().clone(), c.coeffs().iter().map(|p| rotation * p).collect())
        };
        let turned = image(&plane)?;
        let stretch = (side(&turned) / side(&plane)).powi(2);
        let Some(moved) = relaxed(&turned, &alpha, &Springs { stretch, ..springs.clone() }) else { return Ok(()) };
        prop_assert!((moved.energy - found.energy).abs() < 1e-12);
        prop_assert!(furthest(&moved.curve, &image(&found.curve)?) < 1e-6);
        // In space, where rounding may decide which of several curves it is, a power of two, which rounds nothing.
        let Some(found) = relaxed(&curve, &alpha, &springs) else { return Ok(()) };
        let moved = curve.scaled(&size)?.fine_tuned_closed(&alpha, &springs)?;
        prop_assert_eq!(&moved.curve, &found.curve.scaled(&size)?);
        prop_assert_eq!(moved, Relaxed { curve: found.curve.scaled(&size)?, ..found });
    }

    #[test]
    fn a_plane_in_space_is_a_plane((curve, alpha) in star()) {
        let (plane, alpha) = (flat(&curve), alpha.scaled(&0.2)?.translated(&0.8)?);
        let springs = Springs { uniform: true, ..Springs::default() };
        let Some(found) = relaxed(&plane, &alpha, &springs) else { return Ok(()) };
        // Where all turns are to one side signs make no difference.
        let one_side = |legs: &[SVector<f64, 2>]| {
            (0..legs.len()).all(|i| legs[i].perp(&legs[(i + 1) % legs.len()]) > 1e-3)
        };
        let start = plane.embedded(found.curve.space())?;
        let legs = [legs(start.coeffs()), legs(found.curve.coeffs()), wanted(&plane, &alpha, start.space())?];
        prop_assume!(legs.iter().all(|legs| one_side(legs)));
        let lifted = plane.coeffs().iter().map(|p| vector![p[0], 0.0, p[1]]).collect();
        let lifted = relaxed(&Curve::new(plane.space().clone(), lifted)?, &alpha, &springs).expect("no zero legs");
        prop_assert!((lifted.energy - found.energy).abs() < 1e-12);
        let off = |(p, q): (&SVector<f64, 3>, &SVector<f64, 2>)| (vector![p[0], p[2]] - q).norm() + p[1].abs();
        prop_assert!(lifted.curve.coeffs().iter().zip(found.curve.coeffs()).map(off).all(|d| d < 1e-6));
    }
}

fn polygon() -> impl Strategy<Value = Vec<SVector<Q, 2>>> {
    vec(point::<2>(), 1..7)
}

/// The coefficients `2 i`, `2 i + 1` that divide leg `i` in the ratio `near : far` and back.
fn divided(p: &[SVector<Q, 2>], near: &Q, far: &Q) -> Vec<SVector<Q, 2>> {
    let next = p.iter().cycle().skip(1);
    let mix = |a: &SVector<Q, 2>, b: &SVector<Q, 2>| a.map(|x| x * near) + b.map(|x| x * far);
    p.iter().zip(next).flat_map(|(a, b)| [mix(a, b), mix(b, a)]).collect()
}

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn bisection_is_the_rule_of_chaikin(p in polygon()) {
        let curve = Curve::closed(2, p.clone())?;
        let fine = curve.embedded(&curve.space().bisected()?)?;
        prop_assert_eq!(fine.coeffs(), divided(&p, &Q::frac(3, 4), &Q::frac(1, 4)));
        // Again and again.
        let finer = fine.embedded(&fine.space().bisected()?)?;
        prop_assert_eq!(finer.coeffs(), divided(fine.coeffs(), &Q::frac(3, 4), &Q::frac(1, 4)));
    }

    #[test]
    fn elevation_divides_legs_by_six(p in polygon()) {
        let cubic = Curve::closed(2, p.clone())?.elevated(1)?;
        prop_assert_eq!(cubic.coeffs(), divided(&p, &Q::frac(5, 6), &Q::frac(1, 6)));
    }

    #[test]
    fn values_of_the_scale_stand_in_the_middles_of_legs(p in polygon(), levels in vec(number(), 7)) {
        let m = p.len();
        let curve = Curve::closed(2, p.clone())?;
        let alpha = Function::closed(1, levels[..m].to_vec())?;
        for i in 0..m {
            let x = Q::frac(i as i64, m as i64);
            prop_assert_eq!(curve.at(&x)?, (p[i].clone() + &p[(i + 1) % m]).map(|c| c / Q::int(2)));
            prop_assert_eq!(alpha.at(&x)?, levels[i].clone());
        }
        // The legs of the tuned curve: 2/3 a_i d_i, and (a_i d_{i+1} + a_{i+1} d_i) / 6 round vertex i + 1.
        let ring = curve.space().elevated(1)?;
        let open = curve.fine_tuned(Scale::Signed(&alpha))?.embedded(&ring.unclamped_ends()?)?;
        let d = |i: usize| p[(i + 1) % m].clone() - &p[i % m];
        let times = |v: SVector<Q, 2>, a: &Q| v.map(|x| x * a);
        for i in 0..m {
            let (a, b) = (&levels[i], &levels[(i + 1) % m]);
            let leg = |k: usize| open.coeffs()[k + 1].clone() - &open.coeffs()[k];
            prop_assert_eq!(leg(2 * i), times(d(i), &(a.clone() * Q::frac(2, 3))));
            prop_assert_eq!(leg(2 * i + 1), (times(d(i + 1), a) + times(d(i), b)).map(|x| x / Q::int(6)));
        }
    }
}

/// What a square and a scale of degree 1 come to.
fn refused(points: Vec<SVector<f64, 2>>, levels: Vec<f64>, springs: &Springs) -> Error {
    let curve = Curve::closed(2, points).expect("points");
    curve.fine_tuned_closed(&Function::closed(1, levels).expect("levels"), springs).expect_err("refused")
}

#[test]
fn what_cannot_be_relaxed_is_refused() -> Result<()> {
    let square = vec![vector![0.0, 0.0], vector![1.0, 0.0], vector![1.0, 1.0], vector![0.0, 1.0]];
    let springs = Springs::default();
    let refuse = |levels: &[f64], springs: &Springs| refused(square.clone(), levels.to_vec(), springs);
    assert!(matches!(refuse(&[1.0, 0.0], &springs), Error::NotPositive { .. }));
    assert!(matches!(refuse(&[1.0, 2.0, -1.0], &springs), Error::NotPositive { .. }));
    let bent = Springs { bend: f64::NAN, ..Springs::default() };
    assert_eq!(refuse(&[1.0, 2.0], &bent), TuneError::SpringConstant { constant: "NaN".into() }.into());
    let nailed = Springs { fixed: vec![1, 8], ..Springs::default() };
    assert_eq!(refuse(&[1.0, 2.0, 1.0, 1.0], &nailed), Error::IndexOutOfRange { index: 8, length: 8 });
    assert_eq!(refused(vec![vector![3.0, 4.0]; 4], vec![1.0; 4], &springs), Error::NoLength);
    // A polygon with a vertex taken three times stands still there; one that goes back and forth has no leg in between.
    let mut still = square.clone();
    still.extend([square[3]; 2]);
    assert!(matches!(refused(still, vec![1.0; 6], &springs), Error::ZeroLeg { .. }));
    let folded = vec![vector![0.0, 0.0], vector![1.0, 0.0], vector![0.0, 0.0], vector![0.0, 1.0]];
    assert!(matches!(refused(folded, vec![1.0; 4], &springs), Error::ZeroLeg { .. }));
    assert!(matches!(refuse(&[1e308; 4], &springs), Error::NotFinite { .. }));

    let curve = Curve::closed(2, square)?;
    let alpha = Function::closed(1, vec![1.0; 4])?;
    let open = curve.embedded(&curve.space().clamped_ends()?)?;
    assert_eq!(open.fine_tuned_closed(&alpha, &springs).unwrap_err(), Error::NotPeriodic);
    let line = Function::constant(SplineSpace::bezier(1, 0.0, 1.0)?, 1.0)?;
    assert_eq!(curve.fine_tuned_closed(&line, &springs).unwrap_err(), Error::NotPeriodic);
    let longer = Function::constant(SplineSpace::uniform_periodic(1, 4, 0.0, 2.0)?, 1.0)?;
    assert!(matches!(curve.fine_tuned_closed(&longer, &springs), Err(Error::DomainMismatch { .. })));
    Ok(())
}

#[test]
fn strong_scales_and_few_vertices_end() -> Result<()> {
    let springs = Springs::default();
    for size in [1e-300, 1.0, 1e300] {
        for m in 2..6 {
            let vertex = |i: usize| vector![(i * i % 3) as f64, (i * 5 % 7) as f64] * size;
            for degree in 1..4 {
                let curve = Curve::closed(degree, (0..m).map(vertex).collect())?;
                for strong in [1e-12, 1e-3, 1e3, 1e12] {
                    for q in 0..3 {
                        let alpha =
                            Function::closed(q, (0..m).map(|i| if i == 1 { strong } else { 1.0 }).collect())?;
                        match curve.fine_tuned_closed(&alpha, &springs) {
                            Ok(found) => {
                                assert!(found.energy <= found.energy_before * (1.0 + 1e-12), "{found:?}");
                                assert!(found.iterations <= springs.iterations);
                            }
                            Err(Error::ZeroLeg { .. } | Error::NotFinite { .. }) => {}
                            Err(error) => panic!("{error}"),
                        }
                    }
                }
            }
        }
    }
    Ok(())
}

#[test]
fn legs_pressed_to_nothing_do_not_end_the_descent() -> Result<()> {
    // Legs become so short that the stiffness of their joints exceeds all digits of the rest.
    let polygon = [[0.0, 5.0], [2.0, 0.0], [2.0, 3.0], [0.0, 4.0]].map(|[x, y]| vector![x, y]);
    let curve = Curve::closed(2, polygon.to_vec())?;
    let alpha = Function::closed(1, vec![1.0, 2.0, 2.0, 0.5])?;
    let found = curve.fine_tuned_closed(&alpha, &Springs::default())?;
    assert!(found.gradient.is_finite() && found.energy < 0.05, "{found:?}");
    Ok(())
}

#[test]
fn no_steps_leave_the_curve_as_it_is() -> Result<()> {
    let curve = Curve::closed(2, vec![vector![0.0, 0.0], vector![4.0, 1.0], vector![1.0, 5.0]])?;
    let alpha = Function::closed(1, vec![1.0, 1.5, 1.0])?;
    let found = curve.fine_tuned_closed(&alpha, &Springs { iterations: 0, ..Springs::default() })?;
    assert!(!found.converged && found.iterations == 0 && found.energy == found.energy_before);
    assert!(furthest(&found.curve, &curve.elevated(1)?) < 1e-14);
    let mut last = found.energy_before;
    for iterations in 1..20 {
        let found = curve.fine_tuned_closed(&alpha, &Springs { iterations, ..Springs::default() })?;
        assert!(found.energy <= last);
        last = found.energy;
    }
    Ok(())
}
