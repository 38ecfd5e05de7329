//! Lengths and boxes: computed over floats, certified by the library.

use symspline::ArcLength;
use symspline_dynamic::{Any, Value};

/// Relative accuracy of lengths and boxes.
const ACCURACY: f64 = 1e-12;

/// A length, and how far it is off at most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Length {
    /// The length.
    pub total: f64,
    /// The bound of its error.
    pub bound: f64,
}

impl<const N: usize> From<ArcLength<N>> for Length {
    fn from(length: ArcLength<N>) -> Self {
        Self { total: length.total(), bound: length.bound() }
    }
}

/// The length of a curve, if it is one; of an exact curve that of the rounded one.
pub fn length(value: &Value) -> Option<symspline_dynamic::Result<Length>> {
    let measure = || -> symspline_dynamic::Result<Option<Length>> {
        Ok(Some(match value.to_float()? {
            Value::Spline(Any::F2(s)) => s.arc_length(&ACCURACY)?.into(),
            Value::Spline(Any::F3(s)) => s.arc_length(&ACCURACY)?.into(),
            Value::Rational(Any::F2(s)) => s.arc_length(&ACCURACY)?.into(),
            Value::Rational(Any::F3(s)) => s.arc_length(&ACCURACY)?.into(),
            _ => return Ok(None),
        }))
    };
    measure().transpose()
}

/// The least and greatest value of each coordinate, from outside; none of numbers and points.
pub fn bounding_box(value: &Value) -> symspline_dynamic::Result<Option<Vec<[f64; 2]>>> {
    let float = value.to_float()?;
    let axes = 0..value.dim();
    /// The range of each coordinate, to a part of the size of coefficients.
    macro_rules! ranges {
        ($s:expr) => {{
            let range = |axis| {
                let coordinate = $s.coordinate(axis)?;
                // Control points may lie at infinity, where weights are zero.
                let size = match coordinate.coords() {
                    Ok(symspline_dynamic::Over::Float(all)) => {
                        all.iter().fold(f64::MIN_POSITIVE, |m, x| m.max(x.abs()))
                    }
                    _ => 1.0,
                };
                match coordinate {
                    Any::F1(f) => {
                        let range = f.range(&(size * ACCURACY))?;
                        Ok([range.least.bound, range.greatest.bound])
                    }
                    other => Err(symspline_dynamic::Error::Dimension { found: other.dim(), least: 1 }),
                }
            };
            axes.map(range).collect::<symspline_dynamic::Result<Vec<_>>>()?
        }};
    }
    Ok(Some(match &float {
        Value::Spline(s) => ranges!(s),
        Value::Surface(s) => ranges!(s),
        Value::Rational(s) => ranges!(s),
        Value::RationalSurface(s) => ranges!(s),
        Value::Mesh(symspline_dynamic::Over::Float(mesh)) => {
            let range = |axis: usize| {
                let all = mesh.points().iter().map(|p| p[axis]);
                [all.clone().fold(f64::INFINITY, f64::min), all.fold(f64::NEG_INFINITY, f64::max)]
            };
            (0..3).map(range).collect()
        }
        _ => return Ok(None),
    }))
}
