//! Where curves and surfaces meet, and curvatures at a point.

use crate::Any;
use crate::error::Result;
use crate::number::{Field, Number};
use crate::over::{Coords, Over};
use crate::tools::shape::point;
use crate::value::Value;
use symspline::{Intersections, LineMeetings, PrincipalCurvatures, Q};

/// Where two plane curves over floats meet; see [`Curve::intersections`](symspline::Curve::intersections).
///
/// # Errors
/// [`NoSuch`](crate::Error::NoSuch), and those of the library.
pub fn intersections(first: &Value, second: &Value, tolerance: f64) -> Result<Intersections> {
    macro_rules! with {
        ($first:expr) => {
            match second {
                Value::Spline(Any::F2(d)) => Ok($first.intersections(d, &tolerance)?),
                Value::Rational(Any::F2(d)) => Ok($first.intersections(d, &tolerance)?),
                other => Err(other.none_of("meetings of plane curves over floats")),
            }
        };
    }
    match first {
        Value::Spline(Any::F2(c)) => with!(c),
        Value::Rational(Any::F2(c)) => with!(c),
        other => Err(other.none_of("meetings of plane curves over floats")),
    }
}

/// Where a line meets a surface over floats; see [`Surface::meet_line`](symspline::Surface::meet_line).
///
/// # Errors
/// [`NoSuch`](crate::Error::NoSuch), and those of the library.
pub fn line_meetings(
    surface: &Value,
    origin: &Coords,
    direction: &Coords,
    tolerance: f64,
) -> Result<LineMeetings> {
    let (origin, direction) = (point::<f64, _>(origin)?, point::<f64, _>(direction)?);
    match surface {
        Value::Surface(Any::F3(s)) => Ok(s.meet_line(&origin, &direction, &tolerance)?),
        Value::RationalSurface(Any::F3(s)) => Ok(s.meet_line(&origin, &direction, &tolerance)?),
        other => Err(other.none_of("meetings of a line over floats")),
    }
}

/// The Gaussian curvature of a surface at a point; see
/// [`Surface::gaussian_curvature_at`](symspline::Surface::gaussian_curvature_at).
///
/// # Errors
/// [`NoSuch`](crate::Error::NoSuch), and those of the library.
pub fn gaussian_curvature(surface: &Value, u: &Number, v: &Number) -> Result<Number> {
    match surface {
        Value::Surface(Any::F3(s)) => Ok(Over::Float(s.gaussian_curvature_at(&f64::of(u)?, &f64::of(v)?)?)),
        Value::Surface(Any::Q3(s)) => Ok(Over::Exact(s.gaussian_curvature_at(&Q::of(u)?, &Q::of(v)?)?)),
        Value::RationalSurface(Any::F3(s)) => {
            Ok(Over::Float(s.gaussian_curvature_at(&f64::of(u)?, &f64::of(v)?)?))
        }
        Value::RationalSurface(Any::Q3(s)) => {
            Ok(Over::Exact(s.gaussian_curvature_at(&Q::of(u)?, &Q::of(v)?)?))
        }
        other => Err(other.none_of("Gaussian curvature")),
    }
}

/// The mean curvature and the principal curvatures of a surface over floats at a point.
///
/// # Errors
/// [`NoSuch`](crate::Error::NoSuch), and those of the library.
pub fn principal_curvatures(surface: &Value, u: f64, v: f64) -> Result<(f64, PrincipalCurvatures<f64>)> {
    match surface {
        Value::Surface(Any::F3(s)) => Ok((s.mean_curvature_at(&u, &v)?, s.principal_curvatures_at(&u, &v)?)),
        Value::RationalSurface(Any::F3(s)) => {
            Ok((s.mean_curvature_at(&u, &v)?, s.principal_curvatures_at(&u, &v)?))
        }
        other => Err(other.none_of("principal curvatures over floats")),
    }
}
