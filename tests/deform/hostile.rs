//! What is refused, and how.

use nalgebra::{SVector, vector};
use symspline::{
    Breadth, Constraints, Curve, DeformError, Elastic, Error, Excess, Forces, Function, Interval, Material,
    Q, Rational, Restorable, Result, Scalar, Sculptor, SplineSpace, Stiffness, TensorSpline, Weighted,
};

fn deform(error: Error) -> DeformError {
    match error {
        Error::Deform(error) => error,
        other => panic!("{other}"),
    }
}

#[test]
fn materials_are_checked() -> Result<()> {
    for (order, weights) in [(0, [f64::NAN, 1.0]), (1, [1.0, -1.0]), (1, [0.0, f64::INFINITY])] {
        let found = deform(Material::of_orders(weights).unwrap_err());
        assert_eq!(found, DeformError::Material { order, weight: weights[order].to_string() });
    }
    assert!(matches!(Material::of_orders(vec![1.0; 1000]), Err(Error::DegreeTooHigh { .. })));
    let space = SplineSpace::uniform(3, 4, 0.0, 1.0)?;
    let nothing = Material::new(0.0, 0.0)?;
    let found = deform(Stiffness::new(&space, &nothing, &Breadth::BetweenEnds(1)).unwrap_err());
    assert!(matches!(found, DeformError::NullSpace { order: None, dimension: 5, .. }));
    Ok(())
}

/// What costs nothing is named: translations, linear functions, hinges and parts that nothing joins.
#[test]
fn null_spaces_are_named() -> Result<()> {
    let smooth = SplineSpace::uniform(3, 4, 0.0, 1.0)?;
    let hinged = SplineSpace::clamped(3, [0.0, 1.0, 1.0, 1.0, 2.0])?;
    let torn = SplineSpace::clamped(3, [0.0, 1.0, 1.0, 1.0, 1.0, 2.0])?;
    let ring = SplineSpace::uniform_periodic(3, 6, 0.0, 1.0)?;
    let [stretching, bending] = [Material::new(1.0, 0.0)?, Material::new(0.0, 1.0)?];
    let both = Material::new(1.0, 1.0)?;
    let whole = Breadth::Whole;
    for (space, material, breadth, expected) in [
        (&smooth, &stretching, &whole, (1, 1)),
        (&smooth, &both, &whole, (1, 1)),
        (&smooth, &bending, &whole, (2, 2)),
        (&smooth, &bending, &Breadth::Range(1..7), (2, 1)),
        (&hinged, &bending, &whole, (2, 3)),
        (&hinged, &bending, &Breadth::BetweenEnds(1), (2, 1)),
        (&hinged, &stretching, &whole, (1, 1)),
        (&torn, &stretching, &whole, (1, 2)),
        (&torn, &bending, &whole, (2, 4)),
        (&ring, &bending, &whole, (2, 1)),
        (&ring, &stretching, &whole, (1, 1)),
    ] {
        match deform(Stiffness::new(space, material, breadth).unwrap_err()) {
            DeformError::NullSpace { order, dimension, .. } => {
                assert_eq!((order, dimension), (Some(expected.0), expected.1), "{material:?} {breadth:?}");
            }
            other => panic!("{other}"),
        }
    }
    let text = Stiffness::new(&smooth, &bending, &whole).unwrap_err().to_string();
    assert!(text.contains("dimension 2") && text.contains("linear functions"), "{text}");
    let soft = Material::of_orders([1e-40, 0.0, 1.0])?;
    let text = Stiffness::new(&smooth, &soft, &whole).unwrap_err().to_string();
    assert!(text.contains("the hardness is rounding"), "{text}");
    Ok(())
}

#[test]
fn breadths_are_checked() -> Result<()> {
    let space = SplineSpace::uniform(3, 4, 0.0, 1.0)?;
    let ring = SplineSpace::uniform_periodic(3, 6, 0.0, 1.0)?;
    assert_eq!(deform(Breadth::Range(3..3).coeffs(&space).unwrap_err()), DeformError::NothingMoves);
    assert_eq!(deform(Breadth::Around(0.5, 0).coeffs(&space).unwrap_err()), DeformError::NothingMoves);
    assert_eq!(
        deform(Breadth::BetweenEnds(usize::MAX).coeffs(&space).unwrap_err()),
        DeformError::NothingMoves
    );
    assert_eq!(deform(Breadth::BetweenEnds(1).coeffs(&ring).unwrap_err()), DeformError::NoEnds);
    for breadth in
        [Breadth::Range(0..8), Breadth::Range(usize::MAX - 1..usize::MAX), Breadth::Listed(vec![9])]
    {
        assert!(matches!(breadth.coeffs(&space), Err(Error::IndexOutOfRange { .. })), "{breadth:?}");
    }
    assert!(matches!(Breadth::Range(2..9).coeffs(&ring), Err(Error::IndexOutOfRange { .. })));
    assert!(matches!(Breadth::Around(f64::NAN, 2).coeffs(&space), Err(Error::OutsideDomain { .. })));
    Ok(())
}

#[test]
fn shapes_and_forces_are_checked() -> Result<()> {
    let space = SplineSpace::uniform(3, 4, 0.0, 1.0)?;
    let mut curve = Curve::constant(space, vector![1.0, 2.0])?;
    let before = curve.clone();
    let material = Material::new(1.0, 1.0)?;
    let elastic = Elastic::of(&curve, &material, &[Breadth::Range(3..5)])?;
    let other = Curve::constant(SplineSpace::uniform(3, 5, 0.0, 1.0)?, vector![1.0, 2.0])?;
    assert!(matches!(deform(elastic.pull(&other, &0.5).unwrap_err()), DeformError::OtherSpace { .. }));
    assert!(matches!(deform(elastic.pull(&curve, &0.0).unwrap_err()), DeformError::NoHold { .. }));
    assert!(matches!(elastic.pull(&curve, &1.5), Err(Error::OutsideDomain { .. })));
    assert!(matches!(
        Elastic::of(&curve, &material, &[]),
        Err(Error::CoefficientCount { expected: 1, found: 0 })
    ));
    let pull = elastic.pull(&curve, &0.5)?;
    for target in [vector![f64::NAN, 0.0], vector![f64::INFINITY, 0.0], vector![1.7e308, -1.7e308]] {
        if pull.move_to(&mut curve, &target).is_err() {
            assert_eq!(curve, before);
        }
    }
    let mut forces = Forces::new(&elastic, &before)?;
    assert!(forces.at(&2.0, vector![0.0, 0.0]).is_err());
    assert!(matches!(forces.at_breaks(&[]), Err(Error::CoefficientCount { expected: 5, found: 0 })));
    assert!(matches!(forces.at(&0.5, vector![f64::NAN, 0.0]), Err(Error::NotFinite { .. })));
    let held = |constraints: &Constraints<'_, f64, Curve<f64, 2>>| {
        deform(elastic.anchored(constraints).unwrap_err())
    };
    for constraints in [
        Constraints::on(&before).point(&0.5)?.holding(&[0])?,
        Constraints::on(&before).point(&0.5)?.weighing(3, 2.0)?,
        Constraints::on(&before).point(&0.5)?.with_excess(Excess::LeastSquares),
    ] {
        assert!(matches!(held(&constraints), DeformError::Meaningless { .. }));
    }
    Ok(())
}

/// Lengths and weights at the ends of the range give numbers or errors.
#[test]
fn extreme_sizes_are_numbers_or_errors() -> Result<()> {
    for size in [1e-200, 1e-100, 1e-9, 1e9, 1e100, 1e200] {
        for weight in [1e-300, 1e-100, 1.0, 1e100, 1e300] {
            let space = SplineSpace::uniform(3, 5, 0.0, size)?;
            let Ok(stiffness) =
                Stiffness::new(&space, &Material::new(weight, weight)?, &Breadth::BetweenEnds(1))
            else {
                continue;
            };
            let mut f = Function::constant(space, 1.0)?;
            let elastic = Elastic::curve(stiffness);
            let Ok(pull) = elastic.pull(&f, &(0.5 * size)) else { continue };
            if pull.move_to(&mut f, &2.0).is_ok() {
                assert!((f.at(&(0.5 * size))? - 2.0).abs() < 1e-9, "{size:e} {weight:e}");
            }
        }
    }
    Ok(())
}

/// What is left of an interval by rounding is nothing, or too little for knots: no endless search for room.
#[test]
fn no_room_is_made_where_floats_have_none() {
    for space in [SplineSpace::uniform(3, 5, 1.0, 2.0), SplineSpace::uniform_periodic(3, 8, 1.0, 2.0)] {
        let rod = Function::constant(space.unwrap(), 0.0).unwrap();
        let mut sculptor = Sculptor::new(rod, Material::new(1.0, 1.0).unwrap());
        for (at, distance) in [(1.0, 1e-16), (2.0, 1.5e-16), (1.5, 1e-16), (1.0, 1e-300), (2.0, 2.3e-16)] {
            let refused = sculptor.refine(&at, &[distance], &[5]).unwrap_err();
            assert!(
                matches!(refused, Error::EmptyDomain { .. } | Error::SpanOutOfRange { .. }),
                "{refused:?}"
            );
        }
    }
}

/// Control points that are put back bring no other weights, and no other number of directions.
#[test]
fn denominators_stay_positive() {
    type Arc = Rational<Interval, Q, SVector<Q, 1>>;
    let (space, one) = (SplineSpace::bezier(1, Q::int(0), Q::int(1)).unwrap(), Q::int(1));
    let points = [0, 1].map(|x| vector![Q::int(x)]).to_vec();
    let mut arc = Arc::new(space.clone(), points, vec![one.clone(), one]).unwrap();
    let before = arc.clone();
    let negative = Weighted { point: vector![Q::int(1)], weight: Q::int(-1) };
    let refused = arc.put(vec![(0, negative.clone())]).unwrap_err();
    assert!(matches!(refused, Error::Deform(DeformError::OtherWeight { point: 0, .. })));
    assert_eq!(arc, before);
    let mut mixed = arc.stored().to_vec();
    mixed[0] = negative;
    assert_eq!(Arc::rebuilt(std::slice::from_ref(&space), mixed), Err(Error::Pole));
    let numbers = || [0, 1].map(Q::int).to_vec();
    assert!(matches!(Function::rebuilt(&[], numbers()), Err(Error::CoefficientCount { .. })));
    assert!(matches!(TensorSpline::rebuilt(&[space], numbers()), Err(Error::CoefficientCount { .. })));
}
