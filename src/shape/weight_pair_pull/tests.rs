use super::*;
use crate::rational::spline::{NurbsCurve, NurbsSurface};
use crate::space::SplineSpace;
use nalgebra::{SVector, vector};

fn arch<const N: usize>(points: [[f64; N]; 4]) -> NurbsCurve<f64, N> {
    let points = points.map(SVector::from).to_vec();
    NurbsCurve::new(SplineSpace::bezier(3, 0.0, 1.0).unwrap(), points, vec![1.0, 2.0, 0.5, 1.0]).unwrap()
}

#[test]
fn refusals_say_why() {
    let curve = arch([[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0]]);
    let new = |at, picks| WeightPairPull::new(&curve, &at, picks).unwrap_err();
    assert_eq!(new(0.5, [1, 1]), ShapeError::PickedTwice { index: 1 }.into());
    assert_eq!(new(0.5, [1, 4]), Error::IndexOutOfRange { index: 4, length: 4 });
    assert_eq!(new(0.0, [0, 1]), ShapeError::NoInfluence { parameter: "0.0".into() }.into());
    assert!(matches!(new(2.0, [0, 1]), Error::OutsideDomain { .. }));
    assert!(matches!(WeightPairPull::on_leg(&curve, &0.5, 3), Err(Error::IndexOutOfRange { index: 4, .. })));
    assert!(WeightPairPull::on_leg(&curve, &0.5, usize::MAX).is_err());

    let pull = WeightPairPull::new(&curve, &0.5, [1, 2]).unwrap();
    let outside = |target: SVector<f64, 2>| match pull.weights_for(&target, &0.0) {
        Err(Error::Shape(ShapeError::OutsideTriangle { corner, .. })) => corner,
        other => panic!("{other:?}"),
    };
    assert_eq!(outside(vector![2.0, 5.0]), "the base");
    assert_eq!(outside(vector![4.0, 2.0]), "the first control point");
    assert_eq!(outside(vector![0.0, 2.0]), "the second control point");
    let target = vector![2.0, 3.9];
    let narrow = WeightRange::new(0.5, 3.0).unwrap();
    let error = pull.clone().within(narrow).weights_for(&target, &0.0);
    assert!(matches!(error, Err(Error::Shape(ShapeError::WeightOutOfRange { .. }))));
    let bad = Err(Error::BadTolerance { tolerance: "-1".into() });
    assert_eq!(pull.coordinates(&target, &-1.0), bad);
    assert!(pull.coordinates(&vector![f64::NAN, 0.0], &0.0).is_err());
    let mut longer = curve.inserted(&[0.5]).unwrap();
    let before = longer.clone();
    assert!(pull.apply_to(&mut longer, &target, &0.0).is_err());
    assert!(pull.apply_along(&mut longer, &0.5).is_err());
    assert_eq!(longer, before);
}

#[test]
fn a_target_off_the_plane_is_measured() {
    let mut curve = arch([[0.0, 0.0, 0.0], [0.0, 4.0, 0.0], [4.0, 4.0, 0.0], [4.0, 0.0, 0.0]]);
    let pull = WeightPairPull::new(&curve, &0.5, [1, 2]).unwrap();
    let (target, on) = (vector![2.0, 3.0, 0.1], vector![2.0, 3.0, 0.0]);
    match pull.weights_for(&target, &0.01) {
        Err(Error::Shape(ShapeError::OffPlane { distance, .. })) => {
            assert!((distance.parse::<f64>().unwrap() - 0.1).abs() < 1e-12);
        }
        other => panic!("{other:?}"),
    }
    pull.apply_to(&mut curve, &target, &0.2).unwrap();
    assert!((curve.at(&0.5).unwrap() - on).norm() < 1e-14);
}

#[test]
fn points_of_a_line_move_along_it_only() {
    let curve = arch([[0.0, 0.0], [1.0, 2.0], [3.0, 6.0], [10.0, 20.0]]);
    let pull = WeightPairPull::new(&curve, &0.5, [1, 2]).unwrap();
    assert_eq!(pull.coordinates(&vector![2.0, 4.0], &0.0), Err(ShapeError::FlatTriangle.into()));
    let mut moved = curve.clone();
    pull.apply_along(&mut moved, &0.25).unwrap();
    let target = curve.at(&0.5).unwrap() * 0.75 + pull.goal() * 0.25;
    assert!((moved.at(&0.5).unwrap() - target).norm() < 1e-14);
    // The base is on the leg.
    let still = arch([[0.0, 0.0], [0.0, 0.0], [0.0, 0.0], [0.0, 0.0]]);
    let pull = WeightPairPull::new(&still, &0.5, [1, 2]).unwrap();
    assert_eq!(pull.weights_along(&0.5), Err(ShapeError::Fixed.into()));
    assert_eq!(pull.coordinates(&vector![0.0, 0.0], &0.0), Err(ShapeError::FlatTriangle.into()));
}

#[test]
fn sizes_do_not_matter() {
    for size in [1e-300, 1e-150, 1.0, 1e150, 1e300] {
        let mut curve = arch([[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0]].map(|p| p.map(|x| x * size)));
        let pull = WeightPairPull::new(&curve, &0.5, [1, 2]).unwrap();
        let target = vector![2.0, 3.5] * size;
        pull.apply_to(&mut curve, &target, &0.0).unwrap();
        assert!(((curve.at(&0.5).unwrap() - target) / size).norm() < 1e-13, "{size}");
        assert!((pull.fraction_of(&pull.distance()) - 1.0).abs() < 1e-15);
    }
}

#[test]
fn any_two_of_a_surface_will_do() {
    let space = SplineSpace::bezier(2, 0.0, 1.0).unwrap();
    let points = (0..9).map(|i| vector![f64::from(i / 3), f64::from(i % 3), f64::from(i * i % 5)]);
    let mut surface = NurbsSurface::new(space.clone(), space, points.collect(), vec![1.0; 9]).unwrap();
    let pull = WeightPairPull::new(&surface, &(0.4, 0.6), [(0, 1), (2, 2)]).unwrap();
    let [p, q] = pull.control_points();
    let target = pull.base() * 0.5 + p * 0.3 + q * 0.2;
    pull.apply_to(&mut surface, &target, &0.0).unwrap();
    assert!((surface.at(&0.4, &0.6).unwrap() - target).norm() < 1e-14);
}
