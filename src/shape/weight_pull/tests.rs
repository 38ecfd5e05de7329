use super::*;
use crate::rational::spline::NurbsCurve;
use crate::space::SplineSpace;
use nalgebra::vector;

fn arc(size: f64, weight: f64) -> NurbsCurve<f64, 2> {
    let points = vec![vector![0.0, 0.0], vector![size, 2.0 * size], vector![2.0 * size, 0.0]];
    NurbsCurve::new(SplineSpace::bezier(2, 0.0, 1.0).unwrap(), points, vec![weight; 3]).unwrap()
}

#[test]
fn sizes_do_not_matter() {
    for size in [1e-150, 1.0, 1e150, 1e300] {
        for weight in [1e-5, 1.0, 1e5] {
            let curve = arc(size, weight);
            let pull = WeightPull::new(&curve, &0.5, 1).unwrap();
            let moved = pull.applied(&curve, &pull.fraction_of(&(0.5 * size))).unwrap();
            let target = vector![size, 1.5 * size];
            assert!(((moved.at(&0.5).unwrap() - target) / size).norm() < 1e-14);
            assert!((pull.fraction_near(&target) - 0.5).abs() < 1e-14);
        }
    }
    let curve = arc(1e300, 1e5);
    let pull = WeightPull::new(&curve, &0.5, 1).unwrap();
    let far = pull.applied(&curve, &(1.0 - f64::EPSILON));
    assert_eq!(far, Err(Error::NotFinite { what: "coefficient", index: 1 }));
    for fraction in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(pull.weight_for(&fraction), Err(Error::NotFinite { what: "fraction", index: 0 }));
    }
}

#[test]
fn the_end_of_a_clamped_curve_stays() {
    let curve = NurbsCurve::new(
        SplineSpace::bezier(2, 0.0, 1.0).unwrap(),
        vec![vector![0.1, 0.7], vector![0.3, 0.9], vector![0.7, 0.1]],
        vec![0.3, 0.7, 1.9],
    );
    let curve = curve.unwrap();
    for (x, k) in [(0.0, 0), (1.0, 2)] {
        assert_eq!(WeightPull::new(&curve, &x, k), Err(ShapeError::Fixed.into()));
        let none = ShapeError::NoInfluence { parameter: format!("{x:?}") };
        assert_eq!(WeightPull::new(&curve, &x, 1), Err(none.into()));
    }
    assert!(matches!(WeightPull::new(&curve, &1.5, 1), Err(Error::OutsideDomain { .. })));
    assert_eq!(WeightPull::new(&curve, &0.5, 3), Err(Error::IndexOutOfRange { index: 3, length: 3 }));
}

#[test]
fn limits_offered_are_taken() {
    for (least, most) in [(0.02, 20.0), (1e-9, 1e9), (0.3, 0.3), (1e-100, 1e100)] {
        let range = WeightRange::new(least, most).unwrap();
        for weight in [0.2, 0.3, 1.7] {
            let pull = WeightPull::new(&arc(1.0, weight), &0.3, 1).unwrap().within(range.clone());
            for limit in [pull.push_limit().unwrap(), pull.pull_limit().unwrap()] {
                match pull.weight_for(&limit) {
                    Ok(weight) => assert!(least <= weight && weight <= most),
                    // In floating point the limit is one.
                    Err(error) => assert!(most > 1e17, "{error}"),
                }
            }
        }
    }
}

#[test]
fn another_shape_is_refused() {
    let pull = WeightPull::new(&arc(1.0, 1.0), &0.5, 1).unwrap();
    let mut longer = arc(1.0, 1.0).inserted(&[0.5]).unwrap();
    let count = Error::CoefficientCount { expected: 3, found: 4 };
    assert_eq!(pull.apply(&mut longer, &0.5), Err(count));
}

#[test]
fn only_a_weight_of_zero_is_started_from() {
    let refused = WeightPull::from_zero(&arc(1.0, 2.0), &0.5, 1, vector![1.0, 1.0]);
    assert_eq!(refused, Err(Error::Weight { index: 1, weight: "2".into() }));
}
