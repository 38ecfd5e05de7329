//! Laws of fine tuning: `D' = α C'`, exactly.

use crate::strategies::{ANY, CLAMPED, Kind, cases, curve, curve_and_function, function, number};
use nalgebra::SVector;
use proptest::prelude::*;
use symspline::{Analyse, Curve, Error, FineTuner, Function, Hold, Q, Scalar, Scale, SplineSpace};

/// Curves that have a derivative.
const CURVE: Kind = ANY.of_degree(1, 4).smooth(1);
/// Scale functions, jumps and rings included.
const SCALE: Kind = ANY.of_degree(0, 3);

fn constant(c: &Curve<Q, 2>, degree: usize, level: Q) -> symspline::Result<Function<Q>> {
    let (a, b) = c.domain();
    Function::constant(SplineSpace::bezier(degree, a.clone(), b.clone())?, level)
}

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn the_derivative_is_scaled((c, alpha) in curve_and_function::<3>(CURVE, SCALE)) {
        let tuned = c.fine_tuned(Scale::Signed(&alpha))?;
        prop_assert!(tuned.derivative()?.same_function(&c.derivative()?.times(&alpha)?)?);
        prop_assert_eq!(tuned.at(c.domain().0)?, c.at(c.domain().0)?);
        prop_assert!(tuned.space().is_clamped());
    }

    #[test]
    fn the_table_tunes_as_the_operator_does((c, alpha) in curve_and_function::<3>(CURVE, SCALE), at in number()) {
        let tuning = FineTuner::free(&c, alpha.space())?.signed();
        let tuned = c.fine_tuned(Scale::Signed(&alpha))?;
        prop_assert_eq!(tuning.space(), tuned.space());
        // Whatever the places held before.
        let mut points = vec![SVector::from_element(at); tuned.coeffs().len()];
        tuning.tune_into(alpha.coeffs(), &mut points)?;
        prop_assert_eq!(&points[..], tuned.coeffs());
        prop_assert_eq!(tuning.tuned(alpha.coeffs())?, tuned);
        let before = points.clone();
        prop_assert!(tuning.tune_into(&alpha.coeffs()[1..], &mut points).is_err());
        prop_assert!(tuning.tune_into(alpha.coeffs(), &mut points[1..]).is_err());
        prop_assert_eq!(points, before);
    }

    #[test]
    fn scales_are_proved_positive((c, alpha) in curve_and_function::<2>(CURVE, SCALE), lift in number()) {
        let alpha = alpha.translated(&lift)?;
        match alpha.positive_bound() {
            Ok(bound) => {
                prop_assert!(bound > Q::int(0));
                prop_assert!(bound <= alpha.range(&Q::frac(1, 1000))?.least.value);
                prop_assert_eq!(c.fine_tuned(&alpha)?, c.fine_tuned(Scale::Signed(&alpha))?);
                let tuner = FineTuner::free(&c, alpha.space())?;
                prop_assert_eq!(tuner.tuned(alpha.coeffs())?, c.fine_tuned(&alpha)?);
            }
            Err(Error::NotPositive { parameter, value }) => {
                let [x, value]: [Q; 2] = [parameter.parse()?, value.parse()?];
                prop_assert!(value <= Q::int(0) && (alpha.at(&x)? == value || alpha.at_left(&x)? == value));
                prop_assert!(c.fine_tuned(&alpha).is_err());
                prop_assert!(FineTuner::free(&c, alpha.space())?.tuned(alpha.coeffs()).is_err());
            }
            Err(error) => prop_assert_eq!(error, Error::Undecided),
        }
    }

    #[test]
    fn a_curvature_ratio_is_met_within_the_bound(
        ratio in function(ANY.of_degree(0, 2)), lift in 1_i64..5, degree in 0_usize..4, at in 0_i64..=20,
    ) {
        let (low, _) = ratio.coefficient_range();
        let ratio = ratio.translated(&(Q::int(lift) - low))?;
        let (a, b) = ratio.domain();
        let space = SplineSpace::bezier(degree, a.clone(), b.clone())?.union(ratio.space())?.bisected()?;
        let Ok(alpha) = space.scale_for_curvature_ratio(&ratio) else { return Ok(()) };
        let x = a.clone() + (b.clone() - a) * Q::frac(at, 20);
        let [alpha_x, wanted] = [alpha.spline.at(&x)?, ratio.at(&x)?];
        let reached = Q::int(1) / &alpha_x;
        prop_assert!(alpha_x > Q::int(0));
        prop_assert!((reached - &wanted).magnitude() <= alpha.bound * wanted);
        let constant = Function::constant(ratio.space().clone(), Q::int(lift))?;
        prop_assert_eq!(space.scale_for_curvature_ratio(&constant)?.bound, Q::int(0));
    }

    #[test]
    fn a_scale_of_one_changes_nothing(c in curve::<2>(CURVE), q in 0_usize..4) {
        prop_assert!(c.fine_tuned(&constant(&c, q, Q::int(1))?)?.same_function(&c)?);
    }

    #[test]
    fn a_constant_scale_is_a_similarity(c in curve::<2>(CURVE), q in 0_usize..3, factor in number()) {
        let start = c.at(c.domain().0)?;
        let expected = c.translated(&-start.clone())?.scaled(&factor)?.translated(&start)?;
        prop_assert!(c.fine_tuned(Scale::Signed(&constant(&c, q, factor)?))?.same_function(&expected)?);
    }

    #[test]
    fn curvature_is_divided_as_polynomials_say(
        (c, alpha) in curve_and_function::<2>(ANY.of_degree(2, 4).smooth(2), ANY.of_degree(1, 2).smooth(1)),
    ) {
        // κ = (C' × C'') / |C'|³: the cross product gains α² and the squared speed α², so that κ loses |α|.
        let tuned = c.fine_tuned(Scale::Signed(&alpha))?;
        let square = &alpha * &alpha;
        let (dc, ddc) = (c.derivative()?, c.nth_derivative(2)?);
        let (dd, ddd) = (tuned.derivative()?, tuned.nth_derivative(2)?);
        prop_assert!(dd.cross(&ddd)?.same_function(&(&square * &dc.cross(&ddc)?))?);
        prop_assert!(dd.dot(&dd)?.same_function(&(&square * &dc.dot(&dc)?))?);
        // Tangents keep their direction.
        prop_assert!(dd.cross(&dc)?.coeffs().iter().all(|s| *s == Q::int(0)));
    }

    #[test]
    fn fine_tuning_is_affine_in_the_scale(
        (c, alpha) in curve_and_function::<2>(CURVE, SCALE),
        s in number(),
    ) {
        let one = constant(&c, 0, Q::int(1))?;
        let moved = one.plus_scaled(&s, &alpha)?;
        let start = c.at(c.domain().0)?;
        // D(1 + s α) = C + s (D(α) - C(a)).
        let change = c.fine_tuned(Scale::Signed(&alpha))?.translated(&-start)?;
        prop_assert!(c.fine_tuned(Scale::Signed(&moved))?.same_function(&c.plus_scaled(&s, &change)?)?);
    }

    #[test]
    fn fine_tuning_twice_multiplies_the_scales(
        (c, alpha) in curve_and_function::<2>(CLAMPED.of_degree(1, 3).smooth(1), ANY.of_degree(0, 2)),
        level in number(),
    ) {
        let beta = alpha.translated(&level)?;
        let twice = c.fine_tuned(Scale::Signed(&alpha))?.fine_tuned(Scale::Signed(&beta))?;
        prop_assert!(twice.same_function(&c.fine_tuned(Scale::Signed(&(&alpha * &beta)))?)?);
    }

    #[test]
    fn fine_tuning_ignores_where_the_curve_is(
        (c, alpha) in curve_and_function::<2>(CURVE, SCALE),
        by in crate::strategies::point::<2>(),
    ) {
        prop_assert_eq!(c.translated(&by)?.fine_tuned(Scale::Signed(&alpha))?, c.fine_tuned(Scale::Signed(&alpha))?.translated(&by)?);
    }

    #[test]
    fn knots_get_the_copies_their_smoothness_takes((c, alpha) in curve_and_function::<2>(CURVE, SCALE)) {
        let (n, q, tuned) = (c.degree(), alpha.degree(), c.fine_tuned(Scale::Signed(&alpha))?);
        prop_assert_eq!(tuned.degree(), n + q);
        let copies = |space: &SplineSpace<Q>, t: &Q| {
            space.breaks().iter().find(|(s, _)| s == t).map_or(0, |(_, m)| *m)
        };
        let breaks = tuned.space().breaks();
        for (t, found) in &breaks[1..breaks.len() - 1] {
            let (m, l) = (copies(c.space(), t), copies(alpha.space(), t));
            prop_assert_eq!(*found, if m > 0 { q + m } else { 0 }.max(if l > 0 { n - 1 + l } else { 0 }));
        }
        for space in [c.space(), alpha.space()] {
            prop_assert!(space.breaks().iter().all(|(t, _)| copies(tuned.space(), t) > 0));
        }
    }

    #[test]
    fn the_same_knots_hold_the_untuned_curve((c, alpha) in curve_and_function::<2>(CURVE, SCALE)) {
        prop_assert!(c.fine_tuned(Scale::Signed(&alpha))?.space().contains(c.space()));
    }

    #[test]
    fn controls_of_the_scale_span_the_deformations(
        (c, alpha) in curve_and_function::<2>(CLAMPED.of_degree(1, 3).smooth(1), CLAMPED.of_degree(0, 2)),
    ) {
        // D = C(a) + Σ a_j G_j with G_j the curve tuned by one basis function.
        let start = c.at(c.domain().0)?;
        let mut sum = Curve::constant(c.fine_tuned(Scale::Signed(&alpha))?.space().clone(), start.clone())?;
        for (j, a) in alpha.coeffs().iter().enumerate() {
            let part = c.fine_tuned(Scale::Signed(&crate::oracle::unit(alpha.space(), j)))?.translated(&-start.clone())?;
            sum = sum.plus_scaled(a, &part)?;
        }
        prop_assert_eq!(sum, c.fine_tuned(Scale::Signed(&alpha))?);
    }
}

#[test]
fn a_standing_point_stays_where_it_is() -> symspline::Result<()> {
    let still = Curve::constant(
        SplineSpace::bezier(2, Q::int(0), Q::int(1))?,
        SVector::from([Q::int(3), Q::int(4)]),
    )?;
    let tuned = still.fine_tuned(Scale::Signed(&Function::monomial(2, Q::int(0), Q::int(1))?))?;
    assert!(tuned.same_function(&still)?);
    Ok(())
}

/// A curve of no length stays what it is, and has no ends that could be held.
#[test]
fn a_curve_without_length_has_nothing_to_tune() -> symspline::Result<()> {
    let space = SplineSpace::uniform(3, 4, Q::int(0), Q::int(1))?;
    let still = Curve::constant(space.clone(), SVector::from([Q::int(2), Q::int(3)]))?;
    let alpha = Function::constant(space.derivative_space()?, Q::int(2))?;
    assert!(still.fine_tuned(&alpha)?.same_function(&still)?);
    for hold in [Hold::Points, Hold::Tangents, Hold::Curvatures] {
        assert_eq!(still.fine_tuned_holding(&alpha, hold).unwrap_err(), Error::NoChord);
        assert_eq!(FineTuner::prepare(&still, alpha.space(), hold).unwrap_err(), Error::NoChord);
    }
    let other = Function::monomial(1, Q::int(0), Q::int(2))?.translated(&Q::int(1))?;
    assert!(matches!(still.fine_tuned(&other), Err(Error::DomainMismatch { .. })));
    assert!(matches!(FineTuner::free(&still, other.space()), Err(Error::DomainMismatch { .. })));
    Ok(())
}

proptest! {
    #![proptest_config(cases(16))]

    #[test]
    fn curvature_is_divided_in_floats_too(
        (c, alpha) in curve_and_function::<3>(ANY.of_degree(2, 4).smooth(2), ANY.of_degree(1, 2).smooth(1)), lift in 1_i64..4,
    ) {
        let (low, _) = alpha.coefficient_range();
        let alpha = alpha.translated(&(Q::int(lift) - low))?;
        let (Ok(curve), Ok(scale)) = (c.to_f64(), alpha.to_f64()) else { return Ok(()) };
        let Ok(tuned) = curve.fine_tuned(&scale) else { return Ok(()) };
        let (a, b) = (*curve.domain().0, *curve.domain().1);
        for x in (0..20).map(|i| a + (b - a) * (f64::from(i) + 0.3) / 20.0) {
            let [d, e] = [curve.derivatives_at(&x, 2)?, tuned.derivatives_at(&x, 2)?];
            // Where both derivatives keep some digits.
            let keeps = |d: &[SVector<f64, 3>], f: &Curve<f64, 3>| {
                let size = |k: usize| f.nth_derivative(k).and_then(|derivative| derivative.size_bound());
                (1..3).all(|k| size(k).is_ok_and(|size| d[k].norm() > 1e-3 * size))
            };
            let across = d[1].cross(&d[2]).norm() > 1e-3 * d[1].norm() * d[2].norm();
            if across && keeps(&d, &curve) && keeps(&e, &tuned) {
                let ratio = tuned.curvature_at(&x)? * scale.at(&x)? / curve.curvature_at(&x)?;
                prop_assert!((ratio - 1.0).abs() < 1e-8, "{ratio} at {x}");
            }
        }
    }
}
