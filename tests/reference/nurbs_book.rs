//! [NURBS] example 11.1 and equation 11.6: a basis row of the uniform cubic, and a knot that makes a point a control.

use nalgebra::vector;
use symspline::{Curve, Functional, Q, Result, Scalar, SplineSpace};

/// The row of basis functions of the uniform cubic in the middle of a span.
fn middle_row() -> Result<Functional<Q>> {
    let space = SplineSpace::new(3, (0..10).map(Q::int))?;
    space.basis(&Q::frac(9, 2))
}

#[test]
fn basis_row_in_the_middle_of_a_span() -> Result<()> {
    let row = middle_row()?;
    assert_eq!((row.first(), row.weights()), (1, &[1, 23, 23, 1].map(|w| Q::frac(w, 48))[..]));
    Ok(())
}

/// The least change of control points that moves the point of the middle by one: the row over its squared length.
#[test]
fn least_change_of_the_control_points() -> Result<()> {
    let change = |row: &[Q]| -> Vec<Q> {
        let square = Q::dot(row.iter().zip(row));
        row.iter().map(|w| w.clone() / &square).collect()
    };
    let row = middle_row()?;
    let weights = row.weights();
    assert_eq!(change(weights), [12, 276, 276, 12].map(|x| Q::frac(x, 265)), "all four move");
    assert_eq!(change(&weights[1..3]), [24, 24].map(|x| Q::frac(x, 23)), "the middle two move");
    assert_eq!(change(&weights[1..2]), [Q::frac(48, 23)], "one moves");
    Ok(())
}

/// The quadratic over `0, 0, 0, 1/4, 1/2, 3/4, 1, 1, 1`: inserting `1/2` makes node 3 equal to `1/2`, and with it
/// control point 3 the point of the curve there.
#[test]
fn insertion_makes_a_point_of_the_curve_a_control_point() -> Result<()> {
    let space = SplineSpace::clamped(2, (0..=4).map(|i| Q::frac(i, 4)))?;
    let points = [[0, 0], [1, 3], [4, 5], [6, 2], [7, 7], [9, 1]];
    let curve = Curve::new(space, points.map(|[x, y]| vector![Q::int(x), Q::int(y)]).to_vec())?;
    let half = Q::frac(1, 2);
    let refined = curve.inserted(std::slice::from_ref(&half))?;
    assert_eq!(refined.space().greville()[3], half);
    assert_eq!(refined.coeffs()[3], curve.at(&half)?);
    Ok(())
}

/// Inserting a knot of the simple interior kind places the node wanted, [NURBS] 11.6: with `t_k <= u < t_{k+1}` the
/// knot `p u - (u_{k+2} + ... + u_{k+p})` makes node `k + 1` equal to `u`.
#[test]
fn knots_that_place_nodes() -> Result<()> {
    let (p, space) = (3, SplineSpace::clamped(3, [0, 1, 3, 4, 7].map(Q::int))?);
    let (nodes, knots) = (space.greville(), space.knots());
    for k in 0..space.dim() - 1 {
        let u = (nodes[k].clone() * Q::int(2) + &nodes[k + 1]) / Q::int(3);
        let others: Q = knots[k + 2..=k + p].iter().sum();
        let refined = space.refined(&[Q::int(p as i64) * &u - others])?;
        assert_eq!(refined.greville()[k + 1], u, "between the nodes {k} and {}", k + 1);
    }
    Ok(())
}
