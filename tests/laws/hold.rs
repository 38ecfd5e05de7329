//! Laws of held ends after fine tuning: exact in the plane, with bounds in space.

use crate::strategies::{ANY, CLAMPED, Kind, RING, cases, curve, curve_and_function, number};
use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{Curve, Error, FineTuner, Function, Held, Hold, Q, Scalar, Scale, SplineSpace};

const CURVE: Kind = ANY.of_degree(1, 4).smooth(1);
const SCALE: Kind = ANY.of_degree(0, 3);
const HOLDS: [(usize, Hold); 3] = [(0, Hold::Points), (1, Hold::Tangents), (2, Hold::Curvatures)];

/// Free and held result, or the reason that there is none, which must be a good one.
fn held(
    c: &Curve<Q, 2>,
    alpha: &Function<Q>,
    (j, hold): (usize, Hold),
) -> Result<Option<[Curve<Q, 2>; 2]>, TestCaseError> {
    let free = c.fine_tuned(Scale::Signed(alpha))?;
    let invariant = c.clamped_ends()?.embedded(free.space())?;
    let (q, i) = (free.coeffs(), invariant.coeffs());
    let chord =
        |points: &[SVector<Q, 2>]| points.len() >= 2 * j + 2 && points[j] != points[points.len() - 1 - j];
    match c.fine_tuned_holding(Scale::Signed(alpha), hold) {
        Ok(held) => {
            prop_assert!(chord(q) && chord(i));
            Ok(Some([free, held.curve]))
        }
        Err(Error::NoChord) => {
            prop_assert!(q.len() >= 2 * j + 2 && !(chord(q) && chord(i)));
            Ok(None)
        }
        Err(error) => {
            prop_assert!(q.len() < 2 * j + 2);
            prop_assert_eq!(error, Error::CoefficientCount { expected: 2 * j + 2, found: q.len() });
            Ok(None)
        }
    }
}

fn times(z: &SVector<Q, 2>, v: &SVector<Q, 2>) -> SVector<Q, 2> {
    let product = |a: &Q, b: &Q| a.clone() * b;
    vector![product(&z[0], &v[0]) - product(&z[1], &v[1]), product(&z[0], &v[1]) + product(&z[1], &v[0])]
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn the_report_says_what_holding_did((c, alpha) in curve_and_function::<2>(CURVE, SCALE)) {
        for (j, hold) in HOLDS {
            let Ok(held) = c.fine_tuned_holding(Scale::Signed(&alpha), hold) else { continue };
            let free = c.fine_tuned(Scale::Signed(&alpha))?;
            // The image is the free curve under one similarity, of the scale that is told.
            let [speed, image] = [&free, &held.image].map(|f| f.derivative().and_then(|d| d.dot(&d)));
            prop_assert!(image?.same_function(&speed?.scaled(&held.squared_scale)?)?);
            let Some((start, end)) = &held.similar else { continue };
            prop_assert!(held.curve.restricted(start, end)?.same_function(&held.image.restricted(start, end)?)?);
            let deviation = held.deviation()?;
            prop_assert!(j > 0 || deviation == Q::int(0));
            for x in [c.domain().0, c.domain().1] {
                let gap = held.curve.at(x)? - held.image.at(x)?;
                prop_assert!(gap[0].clone() * &gap[0] + gap[1].clone() * &gap[1] <= deviation.clone() * &deviation);
            }
        }
    }

    #[test]
    fn a_held_tuner_tunes_as_the_operator_does((c, alpha) in curve_and_function::<2>(CURVE, SCALE), at in number()) {
        for hold in HOLDS.map(|(_, hold)| hold).into_iter().chain([Hold::Start]) {
            let held = c.fine_tuned_holding(Scale::Signed(&alpha), hold);
            let tuner = match FineTuner::prepare(&c, alpha.space(), hold) {
                Ok(tuner) => tuner.signed(),
                Err(error) => {
                    prop_assert_eq!(error, held.unwrap_err());
                    continue;
                }
            };
            let before = vec![SVector::from_element(at.clone()); tuner.space().dim()];
            let mut points = before.clone();
            match (tuner.tune_into(alpha.coeffs(), &mut points), held) {
                (Ok(()), Ok(held)) => prop_assert_eq!(&points[..], held.curve.coeffs()),
                (Err(error), held) => {
                    prop_assert_eq!(error, held.unwrap_err());
                    prop_assert_eq!(points, before);
                }
                (Ok(()), Err(error)) => prop_assert!(false, "{error}"),
            }
        }
    }

    #[test]
    fn derivatives_at_the_ends_are_held((c, alpha) in curve_and_function::<2>(CURVE, SCALE)) {
        let clamped = c.clamped_ends()?;
        let (a, b) = c.domain();
        for (j, hold) in HOLDS {
            let Some([_, held]) = held(&c, &alpha, (j, hold))? else { continue };
            prop_assert_eq!(held.derivatives_at(a, j)?, clamped.derivatives_at(a, j)?);
            prop_assert_eq!(held.derivatives_at(b, j)?, clamped.derivatives_at(b, j)?);
        }
    }

    #[test]
    fn the_middle_is_one_similarity_of_the_free_result((c, alpha) in curve_and_function::<2>(CURVE, SCALE)) {
        for (j, hold) in HOLDS {
            let Some([free, held]) = held(&c, &alpha, (j, hold))? else { continue };
            prop_assert_eq!(free.space(), held.space());
            let last = held.coeffs().len() - 1 - j;
            let chord = |d: &Curve<Q, 2>| d.coeffs()[last].clone() - &d.coeffs()[j];
            let (from, to) = (chord(&free), chord(&held));
            for k in j..last {
                // z = to / from, without the division.
                let leg = |d: &Curve<Q, 2>| d.coeffs()[k + 1].clone() - &d.coeffs()[k];
                prop_assert_eq!(times(&to, &leg(&free)), times(&from, &leg(&held)));
            }
        }
    }

    #[test]
    fn a_constant_scale_gives_the_curve_back(c in curve::<2>(CURVE), q in 0_usize..3, level in number()) {
        let (a, b) = c.domain();
        let alpha = Function::constant(SplineSpace::bezier(q, a.clone(), b.clone())?, level)?;
        for (j, hold) in HOLDS {
            if let Some([_, held]) = held(&c, &alpha, (j, hold))? {
                prop_assert!(held.same_function(&c)?);
            }
        }
    }

    #[test]
    fn closed_curves_have_no_chord(c in curve::<2>(CLAMPED.of_degree(1, 4).smooth(1)), alpha in number()) {
        let mut points = c.coeffs().to_vec();
        let last = points.len() - 1;
        points[last] = points[0].clone();
        let closed = Curve::new(c.space().clone(), points)?;
        let (a, b) = c.domain();
        let space = SplineSpace::bezier(1, a.clone(), b.clone())?;
        let alpha = Function::new(space, vec![alpha.clone(), alpha + Q::int(1)])?;
        prop_assert_eq!(closed.fine_tuned_holding(Scale::Signed(&alpha), Hold::Points).unwrap_err(), Error::NoChord);
    }

    #[test]
    fn rings_have_no_chord((c, alpha) in curve_and_function::<2>(RING.of_degree(1, 3).smooth(1), SCALE)) {
        prop_assert_eq!(c.fine_tuned_holding(Scale::Signed(&alpha), Hold::Points).unwrap_err(), Error::NoChord);
    }
}

/// A curve in space and a positive scale, over `f64`.
fn in_space() -> impl Strategy<Value = (Curve<f64, 3>, Function<f64>)> {
    (vec(vec(-8_i32..=8, 3), 6), vec(0.5_f64..2.0, 5)).prop_map(|(points, levels)| {
        let points = points.iter().map(|x| SVector::from_fn(|i, _| f64::from(x[i]))).collect();
        let space = SplineSpace::clamped(3, [0.0, 1.0, 1.5, 4.0]).expect("a clamped space");
        let scale = SplineSpace::clamped(2, [0.0, 1.0, 2.5, 4.0]).expect("a clamped space");
        let curve = Curve::new(space, points).expect("six control points");
        (curve, Function::new(scale, levels).expect("five levels"))
    })
}

/// How far off a held point may be, relative to the control points and the factor that stretches the chord.
const ACCURACY: f64 = 1e-13;

proptest! {
    #![proptest_config(cases(128))]

    #[test]
    fn ends_in_space_are_held((c, alpha) in in_space()) {
        let (a, b) = c.domain();
        for (j, hold) in HOLDS {
            let Ok(Held { curve: held, .. }) = c.fine_tuned_holding(Scale::Signed(&alpha), hold) else { continue };
            let size = c.coeffs().iter().map(|point| point.norm()).fold(1.0, f64::max);
            // The end knots are one apart at least, so that derivatives are at most (2 · 5)^j controls.
            for x in [a, b] {
                for (new, old) in held.derivatives_at(x, j)?.iter().zip(&c.derivatives_at(x, j)?) {
                    prop_assert!((new - old).norm() <= ACCURACY * 100.0 * size);
                }
            }
        }
    }

    #[test]
    fn lengths_and_angles_in_space_scale_alike((c, alpha) in in_space()) {
        let free = c.fine_tuned(Scale::Signed(&alpha))?;
        let Ok(Held { curve: held, .. }) = c.fine_tuned_holding(Scale::Signed(&alpha), Hold::Points) else { return Ok(()) };
        let last = free.coeffs().len() - 1;
        let legs = |d: &Curve<f64, 3>| -> Vec<SVector<f64, 3>> {
            d.coeffs().windows(2).map(|pair| pair[1] - pair[0]).collect()
        };
        let chord = |d: &Curve<f64, 3>| (d.coeffs()[last] - d.coeffs()[0]).norm();
        prop_assume!(chord(&free) > 0.1);
        let scale = chord(&held) / chord(&free);
        let size = free.coeffs().iter().map(|point| point.norm()).fold(1.0, f64::max);
        let (q, h) = (legs(&free), legs(&held));
        for k in 0..last {
            for l in 0..last {
                let error = h[k].dot(&h[l]) - scale * scale * q[k].dot(&q[l]);
                prop_assert!(error.abs() <= ACCURACY * 100.0 * (1.0 + scale * size).powi(2) * (1.0 + size));
            }
        }
    }

    #[test]
    fn in_a_plane_of_space_it_is_what_it_is_in_the_plane((c, alpha) in in_space()) {
        let flat = c.coeffs().iter().map(|point| vector![point[0], point[1]]).collect();
        let flat = Curve::new(c.space().clone(), flat)?;
        let lifted = flat.coeffs().iter().map(|point| vector![point[0], point[1], 0.0]).collect();
        let lifted = Curve::new(c.space().clone(), lifted)?;
        let free = flat.fine_tuned(Scale::Signed(&alpha))?;
        for (j, hold) in HOLDS {
            let Ok(Held { curve: plane, .. }) = flat.fine_tuned_holding(Scale::Signed(&alpha), hold) else { continue };
            let space = lifted.fine_tuned_holding(Scale::Signed(&alpha), hold)?.curve;
            let chord = |d: &Curve<f64, 2>| d.coeffs()[d.coeffs().len() - 1 - j] - d.coeffs()[j];
            let (from, to) = (chord(&free), chord(&plane));
            // Short chords magnify rounding, half turns have many axes.
            prop_assume!(from.norm() > 0.1 && from.dot(&to) > -0.99 * from.norm() * to.norm());
            let size = free.coeffs().iter().map(|point| point.norm()).fold(1.0, f64::max);
            let size = size * (1.0 + to.norm() / from.norm());
            for (one, other) in plane.coeffs().iter().zip(space.coeffs()) {
                prop_assert!((vector![one[0], one[1], 0.0] - other).norm() <= ACCURACY * 1e3 * size);
            }
        }
    }
}

#[test]
fn small_scales_and_large_coordinates_keep_their_digits() -> symspline::Result<()> {
    let space = SplineSpace::uniform(3, 2, 0.0, 1.0)?;
    let points = [[100.0, 50.0], [101.0, 52.0], [102.0, 49.0], [104.0, 51.0], [105.0, 50.0]];
    let points: Vec<_> = points.iter().map(|p| nalgebra::vector![p[0], p[1]]).collect();
    let curve = Curve::new(space, points)?;
    let scales = SplineSpace::bezier(1, 0.0, 1.0)?;
    let held = |curve: &Curve<f64, 2>, size: f64| {
        let alpha = Function::new(scales.clone(), vec![size, 2.0 * size])?;
        curve.fine_tuned_holding(&alpha, Hold::Points)
    };
    let expected = held(&curve, 1.0)?;
    for size in [1e-300, 1e-15, 1e-8, 1e8, 1e300] {
        assert!(held(&curve, size)?.curve.distance_bound(&expected.curve)? < 1e-10, "{size}");
        let large = Curve::new(curve.space().clone(), curve.coeffs().iter().map(|p| p * size).collect())?;
        let ratio = held(&large, 1.0)?.squared_scale / expected.squared_scale;
        assert!((ratio - 1.0).abs() < 1e-12, "{size} {ratio}");
    }
    Ok(())
}
