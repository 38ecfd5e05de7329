//! Dual numbers differentiate splines: by the parameter, by coefficients, by knots, and through fine tuning.

use crate::dual::Dual;
use crate::fraction::Fraction;
use nalgebra::SVector;
use symspline::{Curve, Function, Q, Result, Scalar, Scale, SplineSpace};

/// A cubic plane curve with simple and double knots, over any field.
fn curve<T: Scalar>() -> Result<Curve<T, 2>> {
    let space = SplineSpace::clamped(3, [0, 1, 3, 3, 4].map(T::int))?;
    let points = [[0, 0], [1, 3], [2, -1], [4, 4], [5, 0], [6, 1], [7, -2]];
    Curve::new(space, points.map(|point| SVector::from(point.map(T::int))).to_vec())
}

/// The factor with its knot `2` and its middle coefficient `5` replaced.
fn alpha<T: Scalar>(knot: T, value: T) -> Result<Function<T>> {
    let space = SplineSpace::clamped(2, [T::int(0), knot, T::int(4)])?;
    Function::new(space, vec![T::int(1), value, T::int(2), T::frac(1, 3)])
}

fn parameters() -> impl Iterator<Item = Q> {
    (0..=12).map(|i| Q::frac(i, 3))
}

#[test]
fn the_slope_at_a_moving_parameter_is_the_derivative() -> Result<()> {
    let (curve, dual) = (curve::<Q>()?, curve::<Dual>()?);
    let slope = curve.derivative()?;
    // At the end of the domain it would move outside.
    for x in parameters().take(12) {
        let moving = dual.at(&Dual::variable(x.clone()))?;
        assert_eq!(moving.map(|c| c.value), curve.at(&x)?);
        assert_eq!(moving.map(|c| c.slope), slope.at(&x)?);
    }
    Ok(())
}

#[test]
fn fine_tuning_is_differentiated_by_a_coefficient() -> Result<()> {
    let tuned = curve::<Dual>()?.fine_tuned(&alpha(Dual::int(2), Dual::variable(Q::int(5)))?)?;
    // It is affine in α: the derivative is what the unit coefficient alone gives, without the starting point.
    let unit =
        Function::new(alpha(Q::int(2), Q::int(5))?.space().clone(), [0, 1, 0, 0].map(Q::int).to_vec())?;
    let curve = curve::<Q>()?;
    let direction = curve.fine_tuned(Scale::Signed(&unit))?.translated(&-curve.at(&Q::int(0))?)?;
    let slopes: Vec<_> = tuned.coeffs().iter().map(|c| c.map(|c| c.slope)).collect();
    assert_eq!(slopes, direction.coeffs());
    let values: Vec<_> = tuned.coeffs().iter().map(|c| c.map(|c| c.value)).collect();
    assert_eq!(values, curve.fine_tuned(&alpha(Q::int(2), Q::int(5))?)?.coeffs());
    Ok(())
}

#[test]
fn fine_tuning_is_differentiated_by_a_knot() -> Result<()> {
    let dual = curve::<Dual>()?.fine_tuned(&alpha(Dual::variable(Q::int(2)), Dual::int(5))?)?;
    // The same with the knot 2 + x for a symbol x, differentiated by x as a fraction of polynomials.
    let knot = Fraction::int(2) + Fraction::symbol();
    let symbolic = curve::<Fraction>()?.fine_tuned(&alpha(knot, Fraction::int(5))?)?;
    let at_zero = |c: &Fraction| c.at(&Q::int(0)).expect("no control point has a pole at zero");
    assert_eq!(dual.coeffs().len(), symbolic.coeffs().len());
    for (c, d) in dual.coeffs().iter().zip(symbolic.coeffs()) {
        assert_eq!(c.map(|c| c.value), d.map(|d| at_zero(&d)));
        assert_eq!(c.map(|c| c.slope), d.map(|d| at_zero(&d.derivative())));
    }
    for x in parameters().filter(|x| *x != Q::int(2)) {
        let (c, d) = (dual.at(&Dual::constant(x.clone()))?, symbolic.at(&Fraction::constant(x))?);
        assert_eq!(c.map(|c| c.slope), d.map(|d| at_zero(&d.derivative())));
    }
    // The knot does move the curve.
    assert!(dual.coeffs().iter().any(|c| c[0].slope != Q::int(0)));
    Ok(())
}

#[test]
fn values_are_differentiated_by_a_knot() -> Result<()> {
    // The hat over 0, s, 2 at 1/2 is 1 / (2 s): its derivative by s at s = 1 is -1/2.
    let hat = |s: Dual| {
        Function::new(
            SplineSpace::clamped(1, [Dual::int(0), s, Dual::int(2)])?,
            [0, 1, 0].map(Dual::int).to_vec(),
        )
    };
    let value = hat(Dual::variable(Q::int(1)))?.at(&Dual::frac(1, 2))?;
    assert_eq!(value, Dual { value: Q::frac(1, 2), slope: Q::frac(-1, 2) });
    Ok(())
}
