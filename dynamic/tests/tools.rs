//! What tools over values refuse, and that errors of callers come out as they are.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use symspline::{Direction, Norm, Q, Scalar, SplineSpace, Spread};
use symspline_dynamic::tools::bend::{About, AnyBend, Centre, Ratio, bent};
use symspline_dynamic::tools::constraints::{Asked, Wishes, constrained};
use symspline_dynamic::tools::coupled::{Tie, coupled};
use symspline_dynamic::tools::edit::{AnyDrag, Grip};
use symspline_dynamic::tools::elastic::{AnyBreadth, AnyElastic};
use symspline_dynamic::tools::forces::{Along, Load};
use symspline_dynamic::tools::tuner::{Keeping, curve_tuner};
use symspline_dynamic::tools::warp::{AnyRegion, Assignment, warped};
use symspline_dynamic::{AnySpace, AnySpline, AnySurface, Coords, Error, Number, Over, Result, Value};

fn exact(numbers: &[i64]) -> Coords {
    Over::Exact(numbers.iter().map(|x| Q::int(*x)).collect())
}

fn exact_number(x: i64) -> Number {
    Over::Exact(Q::int(x))
}

fn line(degree: usize) -> Result<AnySpace> {
    Ok(AnySpace::Exact(SplineSpace::bezier(degree, Q::int(0), Q::int(1))?))
}

fn curve() -> Result<Value> {
    Ok(AnySpline::new(line(2)?, 2, exact(&[0, 0, 1, 2, 2, 0]))?.into())
}

fn surface() -> Result<Value> {
    Ok(AnySurface::new(line(1)?, line(1)?, 2, exact(&[0, 0, 0, 1, 1, 0, 1, 1]))?.into())
}

#[test]
fn a_prepared_tool_is_for_one_kind_and_one_field() -> Result<()> {
    let wishes = Wishes { asked: vec![Asked::Derivative(exact(&[1]), vec![0])], ..Wishes::default() };
    let held = constrained(&curve()?, &wishes)?;
    assert_eq!(held.dragged(&curve()?, &exact(&[0, 0]))?, curve()?);
    assert!(matches!(held.dragged(&surface()?, &exact(&[0, 0])), Err(Error::NoSuch { .. })));
    assert!(matches!(held.dragged(&curve()?.to_float()?, &exact(&[0, 0])), Err(Error::NoSuch { .. })));
    assert!(matches!(held.dragged(&curve()?, &exact(&[0])), Err(Error::Torn { .. })));
    let drag = AnyDrag::of_point(&curve()?, &exact(&[0]), &Grip::Nearest)?;
    assert!(matches!(drag.applied(&curve()?.to_float()?, &exact(&[0, 1])), Err(Error::Fields { .. })));
    Ok(())
}

#[test]
fn places_and_names_have_as_many_numbers_as_there_are_parameters() -> Result<()> {
    let place = |shape: &Value, at: &[i64]| AnyDrag::of_point(shape, &exact(at), &Grip::Nearest).map(drop);
    assert_eq!(place(&curve()?, &[0, 1]), Err(Error::Dimensions { left: 1, right: 2 }));
    assert_eq!(place(&surface()?, &[0]), Err(Error::Dimensions { left: 2, right: 1 }));
    let named = AnyDrag::of_point(&surface()?, &exact(&[0, 0]), &Grip::One(vec![0]));
    assert_eq!(named, Err(Error::Dimensions { left: 2, right: 1 }));
    let number = Value::from(Over::Exact(Q::int(1)));
    assert!(matches!(place(&number, &[0]), Err(Error::NoSuch { .. })));
    Ok(())
}

#[test]
fn coupled_constraints_are_for_one_kind_and_one_field() -> Result<()> {
    let ties = [Tie::Along(exact(&[1]), vec![1], exact(&[0, 1])), Tie::Area];
    let held = coupled(&curve()?, &Wishes::default(), &ties)?;
    assert_eq!(held.dragged(&curve()?, &exact(&[]), &exact(&[0, 0]))?, curve()?);
    for other in [surface()?, curve()?.to_float()?] {
        let refused = held.dragged(&other, &exact(&[]), &exact(&[0, 0]));
        assert!(matches!(refused, Err(Error::NoSuch { .. })));
    }
    let area = |shape: &Value| coupled(shape, &Wishes::default(), &[Tie::Area]).map(drop);
    assert!(matches!(area(&surface()?), Err(Error::NoSuch { .. })));
    let isocurve =
        Wishes { asked: vec![Asked::Isocurve(Direction::U, exact_number(1))], ..Wishes::default() };
    assert!(matches!(constrained(&curve()?, &isocurve).map(drop), Err(Error::NoSuch { .. })));
    assert_eq!(constrained(&surface()?, &isocurve)?.rows().len(), 2);
    Ok(())
}

#[test]
fn errors_of_a_share_come_out_as_they_are() -> Result<()> {
    let bend = |about| AnyBend {
        centre: Centre::Point(exact(&[0, -1])),
        about,
        ratio: Ratio::Constant(exact_number(1)),
        direction: Direction::U,
        interval: None,
        refine: None,
        tails: true,
    };
    let refuse = |_: &Coords, _: &Coords| Err(Error::DivisionByZero);
    assert_eq!(bent(&curve()?, &bend(About::Share(&refuse))), Err(Error::DivisionByZero));
    let stay = |_: &Coords, _: &Coords| Ok(Some(exact_number(1)));
    assert_eq!(bent(&curve()?, &bend(About::Share(&stay)))?, curve()?);
    let other = bent(&curve()?, &bend(About::Shape(curve()?.to_float()?)));
    assert!(matches!(other, Err(Error::NoSuch { .. })));
    Ok(())
}

#[test]
fn errors_of_a_displacement_come_out_as_they_are() -> Result<()> {
    let region = AnyRegion { from: exact(&[0]), to: exact(&[1]), refine: [None, None], thinned: None };
    let refuse = |_: &Coords, _: &Coords| Err(Error::DivisionByZero);
    assert_eq!(warped(&curve()?, &region, &Assignment::Nodes, &refuse), Err(Error::DivisionByZero));
    let stay = |_: &Coords, _: &Coords| Ok(None);
    assert_eq!(warped(&curve()?, &region, &Assignment::Nodes, &stay)?.shape, curve()?);
    let far = |_: &Coords, _: &Coords| Ok(Some(exact(&[1, 2, 3])));
    let wrong = warped(&curve()?, &region, &Assignment::Nodes, &far);
    assert_eq!(wrong, Err(Error::Dimensions { left: 2, right: 3 }));
    assert!(matches!(
        warped(&curve()?, &region, &Assignment::Chords, &stay),
        Err(Error::NoSuch { operation: "lengths of chords", .. })
    ));
    Ok(())
}

#[test]
fn forces_over_rational_shapes_are_refused() -> Result<()> {
    let Value::Spline(polynomial) = curve()? else { panic!("a curve") };
    let rational = Value::from(symspline_dynamic::AnyRational::from_polynomial(&polynomial)?);
    let load = Load { density: Some(curve()?), ..Load::default() };
    let body =
        |shape: &Value| AnyElastic::of_shape(shape, &[exact(&[1, 1])], &[AnyBreadth::All], Spread::Point);
    assert_ne!(body(&curve()?)?.pushed(&curve()?, &load)?, curve()?);
    assert!(matches!(body(&rational)?.pushed(&rational, &load), Err(Error::NoSuch { .. })));
    Ok(())
}

#[test]
fn forces_along_a_path_are_of_the_field_of_the_surface() -> Result<()> {
    let sheet = surface()?;
    let breadths = [AnyBreadth::Whole, AnyBreadth::Whole];
    let body = AnyElastic::of_shape(&sheet, &[exact(&[1, 1])], &breadths, Spread::Point)?;
    let path: Value = AnySpline::new(line(1)?, 2, exact(&[0, 0, 1, 1]))?.into();
    let along = |path: Value, samples| Load {
        along: vec![Along { path, force: Value::Point(exact(&[4, 0])), samples }],
        ..Load::default()
    };
    let quarters = body.load(&sheet, &along(path.clone(), Some(1)))?;
    assert_eq!(quarters, exact(&[1, 0, 1, 0, 1, 0, 1, 0]));
    let float = along(path.to_float()?, Some(1));
    assert!(matches!(body.load(&sheet, &float), Err(Error::NoSuch { .. })));
    assert_eq!(body.load(&sheet, &float.to_exact()?)?, quarters);
    assert!(matches!(
        body.load(&sheet, &along(path, None)),
        Err(Error::NoSuch { operation: "integral", .. })
    ));
    Ok(())
}

#[test]
fn a_tuner_over_floats_writes_floats() -> Result<()> {
    let Value::Spline(curve) = curve()?.to_float()? else { panic!("a curve") };
    let scales = line(1)?.to_float()?;
    let tuner = curve_tuner(&curve, &scales, &Keeping::Nearest(Vec::new(), Norm::L2), false)?;
    let mut coords = vec![0.0; 8];
    tuner.tune_into(&[1.0, 2.0], &mut coords)?;
    let Value::Spline(tuned) = tuner.tuned(&Over::Float(vec![1.0, 2.0]))? else { panic!("a curve") };
    assert_eq!(tuned.coords()?, Over::Float(coords));
    assert!(matches!(tuner.tune_into(&[1.0, 2.0], &mut [0.0; 7]), Err(Error::Torn { .. })));
    assert!(matches!(
        curve_tuner(&curve, &line(1)?, &Keeping::Free, false),
        Err(Error::Fields { left: "float", right: "exact" })
    ));
    Ok(())
}
