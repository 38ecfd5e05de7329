//! Where curves and surfaces meet, and curvatures of surfaces.

use crate::error::{Failure, Result};
use crate::numbers::{Num, Point};
use crate::record::record;
use crate::tools::curvature::zeros_out;
use crate::tools::measure::float_point;
use crate::value::Thing;
use pyo3::prelude::*;
use symspline::{Certainty, Passage};
use symspline_dynamic::tools::{meet, places};
use symspline_dynamic::{Meeting as _, Value};

record! {
    "symspline.analysis"
    /// A place where two plane curves, or a line and a surface, meet.
    Meeting {
        /// The parameters on both curves; of a line and a surface those of the surface.
        parameters: (f64, f64),
        /// From where to where the parameters of the exact solution lie.
        ranges: ((f64, f64), (f64, f64)),
        /// The point.
        point: Point,
        /// Whether it is proved that there is exactly one solution in the ranges.
        is_proved: bool,
        /// "crosses", "touches", "ends" or "unknown"; nothing for a line and a surface.
        passage: Option<String>,
        /// The parameter on the line, if one is met.
        along: Option<f64>,
    }
}

record! {
    "symspline.analysis"
    /// All places where two things meet.
    Meetings {
        /// Single places.
        meetings: Vec<Meeting>,
        /// Stretches: from where to where on the first, or on the line; and on the second, or on the surface.
        overlaps: Vec<((f64, f64), (Point, Point))>,
    }
}

/// Where two plane curves meet, polynomial or rational, over floats, with proofs.
#[pyfunction]
#[pyo3(signature = (first, second, tolerance=1e-9))]
fn intersections(py: Python<'_>, first: Thing, second: Thing, tolerance: f64) -> Result<Meetings> {
    let (first, second) = (first.0.to_float()?, second.0.to_float()?);
    let found = py.detach(|| meet::intersections(&first, &second, tolerance))?;
    let one = |m: &symspline::Meeting| Meeting {
        parameters: m.parameters.into(),
        ranges: m.ranges.into(),
        point: float_point(m.point.iter().copied().collect()),
        is_proved: m.certainty == Certainty::Proved,
        passage: Some(String::from(match m.passage {
            Passage::Crosses => "crosses",
            Passage::Touches => "touches",
            Passage::Ends => "ends",
            Passage::Unknown => "unknown",
        })),
        along: None,
    };
    let overlap =
        |o: &symspline::Overlap| (o.first, (float_point(vec![o.second.0]), float_point(vec![o.second.1])));
    Ok(Meetings {
        meetings: found.meetings.iter().map(one).collect(),
        overlaps: found.overlaps.iter().map(overlap).collect(),
    })
}

/// Where the line through `origin` in a direction meets a shape: a plane curve (zeros, exact of exact curves), or a surface over floats
/// (`Meetings`).
#[pyfunction]
#[pyo3(signature = (shape, origin, direction, tolerance=1e-9))]
fn meet_line<'py>(
    py: Python<'py>,
    shape: Thing,
    origin: Point,
    direction: Point,
    tolerance: f64,
) -> PyResult<Bound<'py, PyAny>> {
    if matches!(shape.0, Value::Spline(_) | Value::Rational(_)) {
        let exact = origin.0.is_exact() && direction.0.is_exact();
        let curve = shape.0.among(exact).map_err(Failure::from)?;
        let found =
            py.detach(|| places::line_crossings(&curve, &origin.0, &direction.0)).map_err(Failure::from)?;
        return zeros_out(found).into_pyobject(py);
    }
    let surface = shape.0.to_float().map_err(Failure::from)?;
    let found = py
        .detach(|| meet::line_meetings(&surface, &origin.0, &direction.0, tolerance))
        .map_err(Failure::from)?;
    let one = |m: &symspline::LineMeeting| Meeting {
        parameters: m.parameters.into(),
        ranges: m.ranges.into(),
        point: float_point(m.point.iter().copied().collect()),
        is_proved: m.certainty == Certainty::Proved,
        passage: None,
        along: Some(m.along),
    };
    let overlap = |o: &symspline::LineOverlap| {
        (o.along, (float_point(o.parameters[0].to_vec()), float_point(o.parameters[1].to_vec())))
    };
    let meetings = Meetings {
        meetings: found.meetings.iter().map(one).collect(),
        overlaps: found.overlaps.iter().map(overlap).collect(),
    };
    Ok(meetings.into_pyobject(py)?.into_any())
}

/// The Gaussian curvature of a surface at a point, exact of exact surfaces.
#[pyfunction]
fn gaussian_curvature(surface: Thing, u: Num, v: Num) -> Result<Num> {
    let surface = surface.0.among(u.0.is_exact() && v.0.is_exact())?;
    Ok(Num(meet::gaussian_curvature(&surface, &u.0, &v.0)?))
}

record! {
    "symspline.analysis"
    /// The curvatures of a surface at a point.
    SurfaceCurvatures {
        /// The mean curvature.
        mean: f64,
        /// The greatest curvature of a normal section.
        greatest: f64,
        /// The least one.
        least: f64,
        /// The unit vectors of both in space; none at an umbilic.
        directions: Option<(Point, Point)>,
    }
}

/// Mean and principal curvatures of a surface at a point, over floats.
#[pyfunction]
fn surface_curvatures(surface: Thing, u: f64, v: f64) -> Result<SurfaceCurvatures> {
    let (mean, found) = meet::principal_curvatures(&surface.0.to_float()?, u, v)?;
    let directions = found.directions.map(|[a, b]| {
        let vector = |d: symspline::PrincipalDirection<f64>| float_point(d.space.iter().copied().collect());
        (vector(a), vector(b))
    });
    Ok(SurfaceCurvatures { mean, greatest: found.greatest, least: found.least, directions })
}

/// Adds the functions and classes to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Meeting>()?;
    module.add_class::<Meetings>()?;
    module.add_class::<SurfaceCurvatures>()?;
    module.add_function(wrap_pyfunction!(intersections, module)?)?;
    module.add_function(wrap_pyfunction!(meet_line, module)?)?;
    module.add_function(wrap_pyfunction!(gaussian_curvature, module)?)?;
    module.add_function(wrap_pyfunction!(surface_curvatures, module)?)
}
