//! Parts of the parameter plane: gravity fields, and regions bounded by polygons.

use crate::any::Any;
use crate::error::{Error, Result};
use crate::family::AnySpline;
use crate::number::{Field, Number};
use crate::over::{Coords, Over};
use crate::tools::shape::{At, place};
use crate::{both, value::Value};
use symspline::{Curve, CurveGravity, Gravity, GravityPull, Polygons, Q};

/// The field of some polylines; see [`Gravity`].
pub type AnyGravity = Over<Gravity<f64>, Gravity<Q>>;

/// A region bounded by polygons; see [`Polygons`].
pub type AnyPolygons = Over<Polygons<f64>, Polygons<Q>>;

/// What pulls at a point; see [`GravityPull`].
#[derive(Clone, Debug, PartialEq)]
pub struct AnyPull {
    /// The squared distance.
    pub squared_distance: Number,
    /// Which of the lines.
    pub line: usize,
    /// The place on it.
    pub place: Number,
    /// The foot.
    pub foot: Coords,
}

fn pull_of<T: Field>(found: GravityPull<T>) -> AnyPull {
    let (u, v) = found.foot;
    AnyPull {
        squared_distance: found.squared_distance.number(),
        line: found.line,
        place: found.place.number(),
        foot: T::coords(vec![u, v]),
    }
}

/// Lines of points of the plane.
fn lines<T: Field>(lines: &[Coords]) -> Result<Vec<Vec<(T, T)>>> {
    let line = |coords: &Coords| match coords.len() % 2 {
        0 => T::all_of(coords)?.chunks_exact(2).map(<(T, T)>::at).collect(),
        _ => Err(Error::Torn { count: coords.len(), dim: 2 }),
    };
    lines.iter().map(line).collect()
}

/// The field around polylines, which are over one field with the radius.
///
/// # Errors
/// [`Error::Torn`], and those of [`Gravity::new`].
pub fn gravity(polylines: &[Coords], radius: &Number) -> Result<AnyGravity> {
    Ok(match radius {
        Over::Float(radius) => Over::Float(Gravity::new(lines(polylines)?, *radius)?),
        Over::Exact(radius) => Over::Exact(Gravity::new(lines(polylines)?, radius.clone())?),
    })
}

/// What pulls at a point, if anything does.
///
/// # Errors
/// [`Error::Dimensions`].
pub fn pull(gravity: &AnyGravity, point: &Coords) -> Result<Option<AnyPull>> {
    both!(gravity, T, g => Ok(g.pull(&place::<T, (T, T)>(point)?).map(pull_of)))
}

/// The field around plane curves over floats; see [`CurveGravity`].
///
/// # Errors
/// [`Error::NoSuch`] for other curves, and those of [`CurveGravity::new`].
pub fn curve_gravity(curves: &[AnySpline], radius: f64) -> Result<CurveGravity> {
    let plane = |curve: &AnySpline| match curve {
        Any::F2(curve) => Ok(curve.clone()),
        other => Err(Value::from(other.clone()).none_of("gravity field, in the plane over floats,")),
    };
    let curves: Vec<Curve<f64, 2>> = curves.iter().map(plane).collect::<Result<_>>()?;
    Ok(CurveGravity::new(&curves, radius)?)
}

/// What pulls at a point of the field around curves, if anything does.
///
/// # Errors
/// [`Error::Dimensions`], and those of [`CurveGravity::pull`].
pub fn curve_pull(gravity: &CurveGravity, point: &Coords) -> Result<Option<AnyPull>> {
    Ok(gravity.pull(&place::<f64, (f64, f64)>(point)?)?.map(pull_of))
}

/// The region bounded by polygons, over fractions if all are.
///
/// # Errors
/// [`Error::Torn`], and those of [`Polygons::new`].
pub fn polygons(polygons: &[Coords]) -> Result<AnyPolygons> {
    Ok(match polygons.iter().all(Over::is_exact) {
        true => Over::Exact(Polygons::new(lines(polygons)?)?),
        false => Over::Float(Polygons::new(lines(polygons)?)?),
    })
}

/// Whether a point is in the region.
///
/// # Errors
/// [`Error::Dimensions`].
pub fn contains(polygons: &AnyPolygons, point: &Coords) -> Result<bool> {
    both!(polygons, T, p => Ok(p.contains(&place::<T, (T, T)>(point)?)))
}
