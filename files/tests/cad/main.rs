//! The formats of CAD: DXF, STEP and IGES.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod dxf;
mod iges;
mod round_trips;
mod step;

use symspline::SplineSpace;
use symspline_dynamic::{AnyRational, AnySpace, AnySpline, Coords, Over, Value};
use symspline_files::{Entry, Format, from_bytes};

/// The curve of the plane with these control points.
fn plane(space: SplineSpace<f64>, coords: &[f64]) -> Value {
    AnySpline::new(AnySpace::from(space), 2, Coords::Float(coords.to_vec())).unwrap().into()
}

/// What `format` reads, after `new` was put in the place of `old`, which must be there; the error as text.
fn after(text: &str, old: &str, new: &str, format: Format) -> Result<Vec<Entry>, String> {
    assert!(text.contains(old), "{old} is not in the text");
    from_bytes(text.replacen(old, new, 1).as_bytes(), format).map_err(|error| error.to_string())
}

/// The value of a rational curve.
fn at(value: &Value, x: f64) -> Vec<f64> {
    let point = match value {
        Value::Rational(s) => AnyRational::at(s, &Over::Float(x)),
        Value::Spline(s) => s.at(&Over::Float(x)),
        other => panic!("{other}"),
    };
    match point.unwrap() {
        Over::Float(point) => point,
        Over::Exact(_) => panic!("an exact value from a file of floats"),
    }
}

fn assert_near(left: &[f64], right: &[f64]) {
    let near = left.len() == right.len() && left.iter().zip(right).all(|(x, y)| (x - y).abs() <= 1e-14);
    assert!(near, "{left:?} is not near {right:?}");
}
