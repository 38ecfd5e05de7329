//! Laws of curvature, over `f64`: bounds are multiples of `|C''| / |C'|²`, the size of a curvature before cancellation.

use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{Analyse, Curve, Error, Function, SplineSpace};

/// How far off a curvature may be, in units of `|C''| / |C'|²`.
const ACCURACY: f64 = 1e-13;

/// A curve of degree 2 to 5 with control points of moderate size on equal spans.
fn curve<const N: usize>() -> impl Strategy<Value = Curve<f64, N>> {
    (2_usize..=5, 1_usize..=3).prop_flat_map(|(p, spans)| {
        vec(vec(-8_i32..=8, N), p + spans).prop_map(move |points| {
            let points = points.iter().map(|x| SVector::from_fn(|i, _| f64::from(x[i])));
            let space = SplineSpace::uniform(p, spans, 0.0, spans as f64).expect("a clamped space");
            Curve::new(space, points.collect()).expect("as many points as coefficients")
        })
    })
}

/// `|C''| / |C'|²` at `x`, if the curve moves on there.
fn size<const N: usize>(c: &Curve<f64, N>, x: f64) -> Option<f64> {
    let d = c.derivatives_at(&x, 2).expect("inside the domain");
    // Near a cusp nothing is known of the direction.
    (d[1].norm() > 0.1)
        .then(|| 20.0 * (1.0 + d[2].norm()) / d[1].norm_squared().min(d[1].norm_squared().powi(2)))
}

fn inside() -> impl Strategy<Value = f64> {
    0.0_f64..1.0
}

proptest! {
    #![proptest_config(crate::strategies::cases(128))]

    #[test]
    fn the_parabola_has_its_curvature(x in -3.0_f64..3.0) {
        let points = vec![vector![-3.0, 9.0], vector![0.0, -9.0], vector![3.0, 9.0]];
        let parabola = Curve::new(SplineSpace::bezier(2, -3.0, 3.0)?, points)?;
        let expected = 2.0 / (1.0 + 4.0 * x * x).powf(1.5);
        prop_assert!((parabola.curvature_at(&x)? - expected).abs() <= ACCURACY * 2.0);
    }

    #[test]
    fn the_cubic_has_its_curvature(x in -2.0_f64..2.0) {
        let (t, cube) = (Function::monomial(1, -2.0, 2.0)?.elevated(2)?, Function::monomial(3, -2.0, 2.0)?);
        let points = t.coeffs().iter().zip(cube.coeffs()).map(|(x, y)| vector![*x, *y]).collect();
        let cubic = Curve::new(cube.space().clone(), points)?;
        let expected = 6.0 * x / (1.0 + 9.0 * x.powi(4)).powf(1.5);
        prop_assert!((cubic.curvature_at(&x)? - expected).abs() <= ACCURACY * 12.0);
    }

    #[test]
    fn the_curvature_is_its_formula(c in curve::<2>(), s in inside()) {
        let x = s * c.domain().1;
        let Some(size) = size(&c, x) else { return Ok(()) };
        let d = c.derivatives_at(&x, 2)?;
        let expected = (d[1][0] * d[2][1] - d[1][1] * d[2][0]) / d[1].norm().powi(3);
        prop_assert!((c.curvature_at(&x)? - expected).abs() <= ACCURACY * size);
    }

    #[test]
    fn a_plane_in_space_has_the_curvature_without_sign(
        c in curve::<2>(),
        s in inside(),
        turn in 0.0_f64..6.0,
    ) {
        let x = s * c.domain().1;
        let Some(size) = size(&c, x) else { return Ok(()) };
        let (sin, cos) = turn.sin_cos();
        // A plane turned about the first axis.
        let lift = |point: &SVector<f64, 2>| vector![point[0], cos * point[1], sin * point[1]];
        let lifted = c.coeffs().iter().map(lift).collect();
        let lifted = Curve::new(c.space().clone(), lifted)?;
        let expected = c.curvature_at(&x)?.abs();
        prop_assert!((lifted.curvature_at(&x)? - expected).abs() <= ACCURACY * size);
    }

    #[test]
    fn reversal_flips_the_sign(c in curve::<2>(), s in 0.01_f64..0.99) {
        let x = s * c.domain().1;
        // At a knot of a quadratic the curvature jumps.
        prop_assume!((x - x.round()).abs() > 1e-6);
        let Some(size) = size(&c, x) else { return Ok(()) };
        let reversed = c.reversed()?.curvature_at(&(c.domain().1 - x))?;
        // The parameter is rounded: a third derivative of moderate size turns that into a few units more.
        prop_assert!((reversed + c.curvature_at(&x)?).abs() <= 1e3 * ACCURACY * size);
    }

    #[test]
    fn scaling_divides(c in curve::<3>(), s in inside(), factor in 0.01_f64..100.0) {
        let x = s * c.domain().1;
        let Some(size) = size(&c, x) else { return Ok(()) };
        let scaled = c.scaled(&factor)?.curvature_at(&x)?;
        prop_assert!((scaled * factor - c.curvature_at(&x)?).abs() <= ACCURACY * size);
    }

    #[test]
    fn the_parameter_does_not_matter(c in curve::<2>(), s in inside(), length in 0.1_f64..10.0) {
        let x = s * c.domain().1;
        prop_assume!((x - x.round()).abs() > 1e-6);
        let Some(size) = size(&c, x) else { return Ok(()) };
        let other = c.reparametrised(&0.0, &length)?.curvature_at(&(s * length))?;
        prop_assert!((other - c.curvature_at(&x)?).abs() <= 1e3 * ACCURACY * size);
    }

    #[test]
    fn teeth_of_the_comb_are_as_long_as_the_curvature(
        c in curve::<3>(),
        s in inside(),
        scale in 0.01_f64..10.0,
    ) {
        let x = s * c.domain().1;
        let Some(size) = size(&c, x) else { return Ok(()) };
        let (foot, tip) = c.curvature_comb(&[x], &scale)?[0];
        let (d, tooth) = (c.derivatives_at(&x, 2)?, tip - foot);
        let bound = ACCURACY * (scale * size + foot.norm());
        prop_assert_eq!(foot, c.at(&x)?);
        prop_assert!((tooth.norm() - scale * c.curvature_at(&x)?).abs() <= bound);
        // Across the curve, on the outer side.
        prop_assert!(tooth.dot(&d[1].normalize()).abs() <= bound);
        prop_assert!(tooth.dot(&d[2]) <= bound * (1.0 + d[2].norm()));
    }

    #[test]
    fn the_profile_is_the_single_curvatures(c in curve::<2>(), s in inside()) {
        let parameters = [0.0, s * c.domain().1, *c.domain().1];
        let single: Result<Vec<f64>, Error> = parameters.iter().map(|x| c.curvature_at(x)).collect();
        prop_assert_eq!(c.curvature_profile(&parameters), single);
    }

    #[test]
    fn where_a_curve_stands_still_there_is_none(p in 1_usize..5, x in 0_i32..=8) {
        // At eighths nothing is rounded, so that the derivative is zero and not only near it.
        let x = f64::from(x) / 8.0;
        let still = Curve::constant(SplineSpace::bezier(p, 0.0, 1.0)?, vector![1.0, 2.0])?;
        let expected = Error::Stationary { parameter: x.to_string() };
        prop_assert_eq!(&still.curvature_at(&x).unwrap_err(), &expected);
        prop_assert_eq!(still.curvature_comb(&[x], &1.0).unwrap_err(), expected);
    }
}
