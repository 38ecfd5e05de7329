//! Operators from splines to splines: knots and coefficients.

use crate::check::{Answer, Golden, check, in_dimension};
use crate::data::{Case, Field};
use nalgebra::SVector;
use symspline::{Q, Result};

struct Hodograph;

impl Golden for Hodograph {
    const CATEGORY: &'static str = "hodograph";
    const CASES: usize = 3;
    const FACTOR: f64 = 4.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        fn derivative<T: Field, const N: usize>(case: Case) -> Result<Answer<T>> {
            let curve = case.curve::<T, N>("p")?;
            let (derivative, map) = (curve.derivative()?, curve.space().differentiation()?);
            if T::EXACT {
                assert_eq!(map.apply(curve.coeffs())?, derivative.coeffs(), "the map of {}", case.id());
            }
            Ok(Answer::spline(&derivative))
        }
        in_dimension!(derivative::<T>(case))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::expected_spline(case, "p_out", "U_out", "P_out")
    }
}

struct Insertion;

impl Golden for Insertion {
    const CATEGORY: &'static str = "knot_insertion";
    const CASES: usize = 8;
    const FACTOR: f64 = 4.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        fn insertion<T: Field, const N: usize>(case: Case) -> Result<Answer<T>> {
            let curve = case.curve::<T, N>("p")?;
            Ok(Answer::spline(&curve.inserted(&case.get("insert").numbers::<T>())?))
        }
        in_dimension!(insertion::<T>(case))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::expected_spline(case, "p", "U_out", "P_out")
    }
}

struct Elevation;

impl Golden for Elevation {
    const CATEGORY: &'static str = "degree_elevation";
    const CASES: usize = 6;
    const FACTOR: f64 = 4.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        fn elevation<T: Field, const N: usize>(case: Case) -> Result<Answer<T>> {
            Ok(Answer::spline(&case.curve::<T, N>("p")?.elevated(case.get("t").integer())?))
        }
        in_dimension!(elevation::<T>(case))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::expected_spline(case, "p_out", "U_out", "P_out")
    }
}

struct Product;

impl Golden for Product {
    const CATEGORY: &'static str = "product";
    const CASES: usize = 7;
    const FACTOR: f64 = 8.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        fn product<T: Field, const N: usize>(case: Case) -> Result<Answer<T>> {
            let (curve, factor) = (case.curve::<T, N>("p")?, case.function("a")?);
            let product = curve.times(&factor)?;
            if T::EXACT {
                let map = factor.space().multiplication(curve.space())?;
                assert_eq!(
                    map.apply(factor.coeffs(), curve.coeffs())?,
                    product.coeffs(),
                    "the map of {}",
                    case.id()
                );
                assert_eq!(&factor * &curve, product, "the sign of {}", case.id());
            }
            Ok(Answer::spline(&product))
        }
        in_dimension!(product::<T>(case))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::expected_spline(case, "degree", "W", "Q")
    }
}

struct Antiderivative;

impl Golden for Antiderivative {
    const CATEGORY: &'static str = "antiderivative";
    const CASES: usize = 5;
    const FACTOR: f64 = 4.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        fn antiderivative<T: Field, const N: usize>(case: Case) -> Result<Answer<T>> {
            let curve = case.curve::<T, N>("p")?;
            let start = SVector::from_vec(case.get("start").numbers());
            Ok(Answer::spline(&curve.antiderivative()?.translated(&start)?))
        }
        in_dimension!(antiderivative::<T>(case))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::expected_spline(case, "p_out", "U_out", "P_out")
    }
}

#[test]
fn hodograph() {
    check::<Hodograph>();
}

#[test]
fn knot_insertion() {
    check::<Insertion>();
}

#[test]
fn degree_elevation() {
    check::<Elevation>();
}

#[test]
fn product() {
    check::<Product>();
}

#[test]
fn antiderivative() {
    check::<Antiderivative>();
}
