//! Splines as formats of floats hold them: open knots, and control points in flat lists.

use crate::error::Problem;
use symspline::{Coeff, Direction, Interval, Rational, Rectangle, Spline, SplineSpace, TensorSpline};
use symspline_dynamic::{Any, Value};

/// The parts of a curve or surface over floats.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Rounded {
    /// The space of each parameter, open.
    pub spaces: Vec<SplineSpace<f64>>,
    /// How many coordinates points have.
    pub dim: usize,
    /// The coordinates of the control points, one after the other; of a rational spline homogeneous ones, the weight last.
    pub coords: Vec<f64>,
    /// Whether it is rational.
    pub is_rational: bool,
}

/// The parts of a curve or surface: exact numbers rounded to nearest, periodic spaces opened with their knots unrolled, which
/// changes no value.
///
/// # Errors
/// [`Problem::NoRoom`] for a number, a point or a mesh in this format; [`Problem::Value`] where rounding makes knots fall together.
pub(crate) fn rounded(value: &Value, format: &'static str) -> Result<Rounded, Problem> {
    /// One text for the three dimensions.
    macro_rules! of_floats {
        ($any:expr, $s:ident => $body:expr) => {
            match $any.to_float()? {
                Any::F1($s) => $body,
                Any::F2($s) => $body,
                Any::F3($s) => $body,
                Any::Q1(_) | Any::Q2(_) | Any::Q3(_) => unreachable!("it was rounded to floats"),
            }
        };
    }
    let (dim, is_rational) = (value.dim(), matches!(value, Value::Rational(_) | Value::RationalSurface(_)));
    let (spaces, coords) = match value {
        Value::Spline(any) => of_floats!(any, s => of_curve(s))?,
        Value::Rational(any) => of_floats!(any, s => of_curve(Rational::<Interval, _, _>::into_lifted(s)))?,
        Value::Surface(any) => of_floats!(any, s => of_surface(s))?,
        Value::RationalSurface(any) => {
            of_floats!(any, s => of_surface(Rational::<Rectangle, _, _>::into_lifted(s)))?
        }
        other => return Err(Problem::NoRoom { format, value: other.kind().into() }),
    };
    Ok(Rounded { spaces, dim, coords, is_rational })
}

type Parts = Result<(Vec<SplineSpace<f64>>, Vec<f64>), Problem>;

fn of_curve<C: Coeff<f64>>(spline: Spline<f64, C>) -> Parts {
    let open = if spline.space().is_periodic() { spline.unclamped_ends()? } else { spline };
    Ok((vec![open.space().clone()], flat(open.coeffs())))
}

fn of_surface<C: Coeff<f64>>(surface: TensorSpline<f64, C>) -> Parts {
    let mut open = surface;
    for direction in [Direction::U, Direction::V] {
        if open.space(direction).is_periodic() {
            let [u, v] = [open.u(), open.v()].map(Clone::clone);
            let (u, v) = match direction {
                Direction::U => (u.unclamped_ends()?, v),
                Direction::V => (u, v.unclamped_ends()?),
            };
            open = open.embedded(&u, &v)?;
        }
    }
    Ok((vec![open.u().clone(), open.v().clone()], flat(open.coeffs())))
}

fn flat<C: Coeff<f64>>(coeffs: &[C]) -> Vec<f64> {
    coeffs.iter().flat_map(C::components).copied().collect()
}

/// The dimension of points, and their coordinates one after the other.
///
/// # Errors
/// [`symspline::Error::Ragged`].
pub(crate) fn points_of(points: &[Vec<f64>]) -> Result<(usize, Vec<f64>), Problem> {
    let dim = points.first().map_or(1, Vec::len);
    match points.iter().position(|point| point.len() != dim) {
        Some(index) => Err(symspline::Error::Ragged { index }.into()),
        None => Ok((dim, points.concat())),
    }
}
