//! Values: what goes together, what comes out, and what is refused.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use symspline::{Direction, Q, Scalar, SplineSpace};
use symspline_dynamic::{
    AnyMesh, AnyRational, AnyRationalSurface, AnySpline, AnySurface, Coords, Error, Number, Over, Value,
};

fn exact(numbers: &[i64]) -> Coords {
    Over::Exact(numbers.iter().map(|n| Q::int(*n)).collect())
}

fn line() -> SplineSpace<Q> {
    SplineSpace::bezier(1, Q::int(0), Q::int(1)).unwrap()
}

/// `2 x` and the curve `(x, 1 - x)`.
fn function() -> AnySpline {
    AnySpline::new(line().into(), 1, exact(&[0, 2])).unwrap()
}

fn curve() -> AnySpline {
    AnySpline::new(line().into(), 2, exact(&[0, 1, 1, 0])).unwrap()
}

fn number(p: i64, q: i64) -> Number {
    Over::Exact(Q::frac(p, q))
}

fn at(value: &Value, x: &Number) -> Coords {
    match value {
        Value::Spline(s) => s.at(x).unwrap(),
        Value::Rational(s) => s.at(x).unwrap(),
        other => panic!("{other} has no values at one parameter"),
    }
}

/// One of each kind, over the rationals.
fn kinds() -> Vec<Value> {
    let surface =
        AnySurface::new(line().into(), line().into(), 3, exact(&[0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1]))
            .unwrap();
    let rational = AnyRational::new(line().into(), 2, exact(&[0, 0, 1, 1]), exact(&[1, 2])).unwrap();
    let coords = exact(&[0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1]);
    let patch =
        AnyRationalSurface::new(line().into(), line().into(), 3, coords, exact(&[1, 1, 1, 2])).unwrap();
    let corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0]].map(|p| p.map(Q::int).into());
    let mesh = symspline::ControlMesh::new(corners.to_vec(), [[0, 1, 2]]).unwrap();
    vec![
        number(1, 3).into(),
        exact(&[1, 2]).into(),
        curve().into(),
        surface.into(),
        rational.into(),
        patch.into(),
        AnyMesh::from(mesh).into(),
    ]
}

#[test]
fn products_with_a_function_stand_on_either_side() {
    let (f, c) = (Value::from(function()), Value::from(curve()));
    let (left, right) = (f.product(&c).unwrap(), c.product(&f).unwrap());
    assert_eq!(left, right);
    // 2 x (x, 1 - x) at 1/4.
    assert_eq!(at(&left, &number(1, 4)), Over::Exact(vec![Q::frac(1, 8), Q::frac(3, 8)]));
    assert!(matches!(c.product(&c), Err(Error::NoSuch { operation: "product", .. })));
    // x² + (1 - x)² at 1/4.
    assert_eq!(at(&c.dot(&c).unwrap(), &number(1, 4)), Over::Exact(vec![Q::frac(5, 8)]));
}

#[test]
fn points_move_and_numbers_scale() {
    let moved = Value::from(exact(&[1, -1])).sum(&curve().into()).unwrap();
    assert_eq!(at(&moved, &number(0, 1)), exact(&[1, 0]));
    let scaled = Value::from(number(3, 1)).product(&curve().into()).unwrap();
    assert_eq!(at(&scaled, &number(0, 1)), exact(&[0, 3]));
    let back = scaled.quotient(&number(3, 1).into()).unwrap();
    assert_eq!(back, curve().into());
    assert_eq!(scaled.quotient(&number(0, 1).into()).unwrap_err(), Error::DivisionByZero);
    assert_eq!(moved.difference(&exact(&[1, -1]).into()).unwrap(), curve().into());
    assert_eq!(
        Value::from(exact(&[1])).sum(&curve().into()).unwrap_err(),
        Error::Dimensions { left: 2, right: 1 }
    );
}

#[test]
fn quotients_are_rational_and_mix_with_polynomials() {
    let one = Value::from(function()).sum(&number(1, 1).into()).unwrap();
    let quotient = Value::from(curve()).quotient(&one).unwrap();
    // (x, 1 - x) / (2 x + 1) at 1/2.
    assert_eq!(at(&quotient, &number(1, 2)), Over::Exact(vec![Q::frac(1, 4), Q::frac(1, 4)]));
    let sum = quotient.sum(&curve().into()).unwrap();
    assert_eq!(at(&sum, &number(1, 2)), Over::Exact(vec![Q::frac(3, 4), Q::frac(3, 4)]));
    let back = at(&quotient.product(&one).unwrap(), &number(1, 3));
    assert_eq!(back, curve().at(&number(1, 3)).unwrap());
    assert_eq!(quotient.quotient(&quotient).unwrap_err(), Error::Dimensions { left: 1, right: 2 });
}

#[test]
fn fields_do_not_mix_but_numbers_and_points_do() {
    let float = Value::from(curve()).to_float().unwrap();
    assert!(matches!(float.sum(&curve().into()), Err(Error::Fields { left: "float", right: "exact" })));
    // The float 0.1 is taken for the fraction that it is.
    let moved = Value::from(curve()).sum(&Coords::Float(vec![0.1, 0.0]).into()).unwrap();
    assert_eq!(at(&moved, &number(0, 1)), Over::Exact(vec![Q::try_from(0.1).unwrap(), Q::int(1)]));
    assert!(Value::from(curve()).sum(&Coords::Float(vec![f64::NAN, 0.0]).into()).is_err());
    let both = Value::from(number(1, 2)).sum(&Number::Float(0.25).into()).unwrap();
    assert_eq!(both, Number::Float(0.75).into());
}

#[test]
fn all_kinds_convert_without_loss_and_back() {
    for value in kinds() {
        let float = value.to_float().unwrap();
        assert!(!float.is_exact() && value.is_exact(), "{value}");
        if value.kind() != "number" {
            assert_eq!(float.to_exact().unwrap(), value);
        }
        assert_eq!((float.kind(), float.dim()), (value.kind(), value.dim()));
    }
}

#[test]
fn what_there_is_not_is_refused_by_name() {
    let mesh = kinds().pop().unwrap();
    for (operation, outcome) in [
        ("sum", mesh.sum(&mesh)),
        ("product", mesh.product(&mesh)),
        ("quotient", mesh.quotient(&mesh)),
        ("dot product", mesh.dot(&mesh)),
        ("cross product", mesh.cross(&mesh)),
    ] {
        let left = String::from("exact mesh");
        assert_eq!(outcome.unwrap_err(), Error::NoSuch { operation, right: left.clone(), left });
    }
    assert!(mesh.negated().is_err());
    assert!(Value::from(function()).cross(&function().into()).is_err());
}

#[test]
fn constructors_check_counts_and_fields() {
    assert_eq!(
        AnySpline::new(line().into(), 2, exact(&[0, 1, 2])).unwrap_err(),
        Error::Torn { count: 3, dim: 2 }
    );
    assert_eq!(
        AnySpline::new(line().into(), 4, exact(&[0; 8])).unwrap_err(),
        Error::Dimension { found: 4, least: 1 }
    );
    assert_eq!(
        AnySpline::new(line().into(), 0, exact(&[])).unwrap_err(),
        Error::Dimension { found: 0, least: 1 }
    );
    let floats = Coords::Float(vec![0.0, 1.0]);
    assert_eq!(
        AnySpline::new(line().into(), 1, floats.clone()).unwrap_err(),
        Error::Fields { left: "exact", right: "float" }
    );
    assert!(matches!(
        AnyRational::new(line().into(), 1, exact(&[0, 1]), floats),
        Err(Error::Fields { left: "exact", right: "float" })
    ));
}

#[test]
fn operators_are_those_of_the_library() {
    let (f, c) = (function(), curve());
    assert_eq!(f.derivative().unwrap().antiderivative().unwrap(), f);
    assert_eq!(f.integral().unwrap(), exact(&[1]));
    assert_eq!(f.inner(&f).unwrap(), number(4, 3));
    assert_eq!(f.integral_between(&number(0, 1), &number(1, 2)).unwrap(), Over::Exact(vec![Q::frac(1, 4)]));
    // The curve at 1 - x, by composition and reversed.
    let falling = AnySpline::new(line().into(), 1, exact(&[1, 0])).unwrap();
    assert!(c.composed(&falling).unwrap().same_function(&c.reversed().unwrap()).unwrap());
    let raised = c.elevated(2).unwrap().inserted(&exact(&[])).unwrap();
    assert_eq!(raised.simplified().unwrap(), c);
    let Value::Surface(s) = kinds().swap_remove(3) else { panic!("the fourth is a surface") };
    // (u, v, u v): the curve u = 1/2, and the derivative in v there.
    let iso = s.isocurve(Direction::U, &number(1, 2)).unwrap();
    assert_eq!(
        iso.at(&number(1, 3)).unwrap(),
        Over::Exact(vec![Q::frac(1, 2), Q::frac(1, 3), Q::frac(1, 6)])
    );
    assert_eq!(s.transposed().isocurve(Direction::V, &number(1, 2)).unwrap(), iso);
    let diagonal = AnySpline::new(line().into(), 2, exact(&[0, 0, 1, 1])).unwrap();
    assert_eq!(
        s.composed(&diagonal).unwrap().at(&number(1, 3)).unwrap(),
        Over::Exact(vec![Q::frac(1, 3), Q::frac(1, 3), Q::frac(1, 9)])
    );
    assert_eq!(s.composed(&c.coordinate(0).unwrap()).unwrap_err(), Error::Dimensions { left: 2, right: 1 });
    assert!(c.coordinate(2).is_err() && c.coordinate(1).is_ok());
}

#[test]
fn a_shear_of_a_curve_and_its_shadow() {
    let line = AnySpline::new(line().into(), 2, exact(&[1, 2, 3, 5])).unwrap();
    assert_eq!(line.transformed(&exact(&[1, 1, 0, 1])).unwrap().coords().unwrap(), exact(&[3, 2, 8, 5]));
    assert_eq!(line.transformed(&exact(&[0, 1])).unwrap(), line.coordinate(1).unwrap());
    assert_eq!(line.transformed(&exact(&[1, 2, 3])).unwrap_err(), Error::Torn { count: 3, dim: 2 });
}

#[test]
fn a_weight_of_zero_comes_back() {
    let space = SplineSpace::bezier(2, 0.0, 1.0).unwrap();
    let coords = Coords::Float(vec![1.0, 0.0, 1.0, 0.1, 0.1, 0.0, 0.0, 1.0, 1.0]);
    let half_circle = AnyRational::from_homogeneous(space.into(), 2, coords.clone()).unwrap();
    assert_eq!(half_circle.homogeneous(), coords);
}

#[test]
fn homogeneous_coordinates_make_whole_points_of_the_field_of_the_space() {
    let space = SplineSpace::bezier(1, 0.0, 1.0).unwrap();
    let short = AnyRational::from_homogeneous(space.clone().into(), 2, Coords::Float(vec![1.0; 5]));
    assert_eq!(short.unwrap_err(), Error::Torn { count: 5, dim: 3 });
    let other = AnyRational::from_homogeneous(space.into(), 2, exact(&[1; 6]));
    assert_eq!(other.unwrap_err(), Error::Fields { left: "float", right: "exact" });
}
