//! [Miura] (1), its consequence for the ends: the moments `g_j = ∫ M_j C'` of a curve.
//!
//! For a fixed curve `D = C(a) + Σ a_j G_j` is affine in the control values `a_j` of the scale function, with
//! `G_j = ∫ M_j C'` for its basis `M_j`. The `G_j` add up to `C - C(a)`, their end values, the moments `g_j`, to
//! `C(b) - C(a)`; and `D` ends where `C` does if and only if `Σ (a_j - 1) g_j = 0`.

use crate::point;
use nalgebra::SVector;
use symspline::{Curve, Function, Q, Result, Scalar, Scale, SplineSpace};

type Point = SVector<Q, 2>;

fn curve() -> Result<Curve<Q, 2>> {
    let space = SplineSpace::clamped(3, [0, 1, 2, 2, 5].map(Q::int))?;
    let points = [[1, 2], [0, 5], [4, 4], [6, -1], [3, -3], [8, 0], [9, 7]];
    Curve::new(space, points.map(point).to_vec())
}

fn closed_curve() -> Result<Curve<Q, 2>> {
    let space = SplineSpace::periodic(3, [0, 1, 2, 4, 5].map(Q::int), Q::int(6))?;
    Curve::new(space, [[1, 2], [0, 5], [4, 4], [6, -1], [3, -3]].map(point).to_vec())
}

fn scales() -> Result<SplineSpace<Q>> {
    SplineSpace::clamped(2, [0, 2, 3, 5].map(Q::int))
}

/// Basis function `j` of a space.
fn basis_function(space: &SplineSpace<Q>, j: usize) -> Result<Function<Q>> {
    let unit = |i: usize| Q::int(i64::from(i == j));
    Function::new(space.clone(), (0..space.dim()).map(unit).collect())
}

/// The moments, by integration.
fn moments(curve: &Curve<Q, 2>, scales: &SplineSpace<Q>) -> Result<Vec<Point>> {
    let derivative = curve.derivative()?;
    let moment = |j: usize| derivative.weighted_integral(&basis_function(scales, j)?);
    (0..scales.dim()).map(moment).collect()
}

/// The distance between the ends of a curve.
fn chord(curve: &Curve<Q, 2>) -> Result<Point> {
    let (a, b) = curve.domain();
    Ok(curve.at_left(b)? - curve.at(a)?)
}

fn weighted(values: &[Q], points: &[Point]) -> Point {
    values.iter().zip(points).fold(Point::zeros(), |sum, (a, g)| sum + g.map(|x| x * a))
}

fn values(dim: usize) -> Vec<Q> {
    (0..dim as i64).map(|i| Q::frac(2 * i * i - 3 * i + 4, 5)).collect()
}

#[test]
fn moments_add_up_to_the_chord() -> Result<()> {
    let curve = curve()?;
    let sum = moments(&curve, &scales()?)?.into_iter().fold(Point::zeros(), |sum, g| sum + g);
    assert_eq!(sum, chord(&curve)?);
    Ok(())
}

#[test]
fn moments_are_rows_of_the_mixed_gram_matrix() -> Result<()> {
    let curve = curve()?;
    let gram = scales()?.gram(curve.space(), 0, 1)?;
    assert_eq!(gram.apply(curve.coeffs())?, moments(&curve, &scales()?)?);
    Ok(())
}

#[test]
fn tuned_curve_is_affine_in_the_control_values() -> Result<()> {
    let (curve, scales) = (curve()?, scales()?);
    let start = curve.at(curve.domain().0)?;
    let values = values(scales.dim());
    let tuned = curve.fine_tuned(&Function::new(scales.clone(), values.clone())?)?;
    let mut sum = Curve::constant(tuned.space().clone(), start.clone())?;
    for (j, a) in values.iter().enumerate() {
        let one =
            curve.fine_tuned(Scale::Signed(&basis_function(&scales, j)?))?.translated(&-start.clone())?;
        sum = sum.plus_scaled(a, &one)?;
    }
    assert_eq!(tuned, sum);
    assert_eq!(chord(&tuned)?, weighted(&values, &moments(&curve, &scales)?));
    Ok(())
}

#[test]
fn ends_are_kept_when_the_changes_balance() -> Result<()> {
    let (curve, scales) = (curve()?, scales()?);
    let g = moments(&curve, &scales)?;
    // In the plane any three moments are dependent: solve x_0 g_0 + x_1 g_1 + g_2 = 0.
    let cross = |p: &Point, q: &Point| p[0].clone() * &q[1] - p[1].clone() * &q[0];
    let whole = cross(&g[0], &g[1]);
    let changes = [-cross(&g[2], &g[1]) / &whole, -cross(&g[0], &g[2]) / &whole, Q::int(1)];
    let mut values = vec![Q::int(1); scales.dim()];
    values.iter_mut().zip(&changes).for_each(|(a, x)| *a += x);
    let tuned = curve.fine_tuned(&Function::new(scales.clone(), values.clone())?)?;
    let end = curve.domain().1;
    assert_eq!(tuned.at(end)?, curve.at(end)?);
    values[0] += Q::int(1);
    let off = curve.fine_tuned(&Function::new(scales, values)?)?;
    assert_eq!(off.at(end)? - curve.at(end)?, g[0], "one unit more moves the end by its moment");
    Ok(())
}

/// A closed curve and a periodic scale function: the moments add up to zero, and the drift is `Σ a_j g_j`.
#[test]
fn moments_of_a_closed_curve_add_up_to_zero() -> Result<()> {
    let curve = closed_curve()?;
    let scales = SplineSpace::periodic(2, [0, 2, 5].map(Q::int), Q::int(6))?;
    let g = moments(&curve, &scales)?;
    assert_eq!(g.iter().fold(Point::zeros(), |sum, g| sum + g), Point::zeros());
    let values = values(scales.dim());
    let tuned = curve.fine_tuned(&Function::new(scales, values.clone())?)?;
    assert_ne!(chord(&tuned)?, Point::zeros());
    assert_eq!(chord(&tuned)?, weighted(&values, &g));
    Ok(())
}
