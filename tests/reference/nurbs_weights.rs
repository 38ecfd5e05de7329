//! [NURBS] section 11.3: the weights printed with figures 11.11 and 11.13.
//!
//! The curve is not given, but five pulls of one point are: from weight 0.2 by 0.022, 0.044, 0.066 and 0.088 to the weights 0.4,
//! 0.77, 1.63 and 6.11, and by 0.075 to 2.45. All follow from one share of the control point, 0.2838, and one distance to it, 0.0985.

use nalgebra::vector;
use symspline::{NurbsCurve, Q, Result, Scalar, SplineSpace, WeightPull, cross_ratio};

/// The distances and the weights printed, in hundredths, but for the first with as many digits.
const PULLS: [(i64, i64); 5] = [(22, 40), (44, 77), (66, 163), (88, 611), (75, 245)];

/// A parabola whose middle has the share and the distance.
fn curve() -> Result<NurbsCurve<Q, 2>> {
    let (weight, share, distance) = (Q::frac(1, 5), Q::frac(2838, 10_000), Q::frac(985, 10_000));
    // (w / 2) / (v / 2 + w / 2) is the share in the middle of weights v, w, v.
    let outer = weight.clone() / &share - &weight;
    // The middle point is at the height `share h`.
    let height = distance / (Q::int(1) - share);
    let points =
        vec![vector![Q::int(-1), Q::int(0)], vector![Q::int(0), height], vector![Q::int(1), Q::int(0)]];
    NurbsCurve::new(SplineSpace::bezier(2, Q::int(0), Q::int(1))?, points, vec![outer.clone(), weight, outer])
}

#[test]
fn printed_weights_of_incremental_pulls() -> Result<()> {
    let (mut curve, middle) = (curve()?, Q::frac(1, 2));
    let pull = WeightPull::new(&curve, &middle, 1)?;
    assert_eq!(pull.share(), Q::frac(2838, 10_000));
    let start = curve.at(&middle)?;
    assert_eq!(pull.control_point()[1].clone() - &start[1], Q::frac(985, 10_000));
    for (thousandths, printed) in PULLS {
        let by = Q::frac(thousandths, 1000);
        pull.apply(&mut curve, &(by.clone() / Q::frac(985, 10_000)))?;
        let weight = curve.weights().nth(1).expect("three weights").to_f64();
        let half_a_digit = if printed == 40 { 0.05 } else { 0.005 };
        assert!((weight - printed as f64 / 100.0).abs() <= half_a_digit, "{weight} by {by}");
        assert_eq!(curve.at(&middle)?[1], start[1].clone() + by);
    }
    Ok(())
}

#[test]
fn printed_weights_by_distance() -> Result<()> {
    let curve = curve()?;
    let points = curve.points()?.into_iter().map(|p| p.map(|x| x.to_f64())).collect();
    let weights = curve.weights().map(Q::to_f64).collect();
    let rounded = NurbsCurve::new(SplineSpace::bezier(2, 0.0, 1.0)?, points, weights)?;
    let pull = WeightPull::new(&rounded, &0.5, 1)?;
    for (thousandths, printed) in PULLS.into_iter().skip(1) {
        let weight = pull.weight_for_distance(&(thousandths as f64 / 1000.0))?;
        assert!((weight - printed as f64 / 100.0).abs() <= 0.005, "{weight} by {thousandths}");
    }
    Ok(())
}

/// (11.24): the weight is a cross ratio.
#[test]
fn the_weight_as_a_cross_ratio() -> Result<()> {
    let curve = curve()?;
    let pull = WeightPull::new(&curve, &Q::frac(1, 2), 1)?;
    let [r, m] = [0, 1].map(|weight| pull.point_at_weight(&Q::int(weight)));
    let ratio = cross_ratio([pull.control_point(), &r?, &m?, pull.point()], &Q::int(0))?;
    assert_eq!(ratio, Q::frac(1, 5));
    Ok(())
}
