//! Lines and arcs as splines.

use nalgebra::{SVector, Vector2, Vector3};
use symspline::{NurbsCurve, Spline, SplineSpace};
use symspline_dynamic::{AnySpline, Value};

pub(crate) type Made<T> = Result<T, symspline::Error>;

/// The curve of the plane after an affine map.
pub(crate) fn placed<const N: usize>(
    curve: &NurbsCurve<f64, 2>,
    map: impl Fn(&Vector2<f64>) -> SVector<f64, N>,
) -> Made<NurbsCurve<f64, N>> {
    let points = curve.points()?.iter().map(map).collect();
    NurbsCurve::new(curve.space().clone(), points, curve.weights().copied().collect())
}

/// The curve of degree 1 through points, one unit of the parameter an edge.
pub(crate) fn polyline<const N: usize>(points: Vec<SVector<f64, N>>) -> Made<Spline<f64, SVector<f64, N>>> {
    Spline::new(SplineSpace::clamped(1, (0..points.len()).map(|i| i as f64))?, points)
}

/// The segment between two points, in the plane if both are there.
pub(crate) fn segment(a: Vector3<f64>, b: Vector3<f64>) -> Made<Value> {
    Ok(match a.z == 0.0 && b.z == 0.0 {
        true => AnySpline::from(polyline(vec![a.xy(), b.xy()])?),
        false => AnySpline::from(polyline(vec![a, b])?),
    }
    .into())
}
