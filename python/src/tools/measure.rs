//! Lengths, frames, nearest points.

use crate::error::Result;
use crate::numbers::{Array, Point};
use crate::record::record;
use crate::tools::curvature::{floats, out};
use crate::value::Thing;
use pyo3::prelude::*;
use symspline_dynamic::tools::measure::{self, AllFeet, AnyFoot, Lengths, Nears};
use symspline_dynamic::{Coords, Over};

/// The arc length of a curve, prepared, to a relative `accuracy`.
#[pyclass(frozen, module = "symspline.analysis")]
#[derive(Debug)]
pub struct ArcLength(Box<dyn Lengths>);

#[pymethods]
impl ArcLength {
    #[new]
    #[pyo3(signature = (curve, accuracy=1e-12))]
    fn new(py: Python<'_>, curve: Thing, accuracy: f64) -> Result<Self> {
        let curve = curve.0.to_float()?;
        Ok(Self(py.detach(|| measure::arc_length(&curve, accuracy))?))
    }

    /// The length of the whole curve.
    #[getter]
    fn total(&self) -> f64 {
        self.0.total().0
    }

    /// How far that is off at most.
    #[getter]
    fn bound(&self) -> f64 {
        self.0.total().1
    }

    /// The lengths from the start to parameters, an array of their shape.
    fn at(&self, py: Python<'_>, parameters: Array) -> Result<Array> {
        let (shape, all) = floats(parameters)?;
        Ok(out(shape, py.detach(|| self.0.at(&all))?))
    }

    /// The parameters at lengths from the start.
    fn parameter_at(&self, py: Python<'_>, lengths: Array) -> Result<Array> {
        let (shape, all) = floats(lengths)?;
        Ok(out(shape, py.detach(|| self.0.parameters_at(&all))?))
    }

    /// The parameters that divide the curve into parts of equal length, both ends included.
    fn evenly(&self, py: Python<'_>, count: usize) -> Result<Array> {
        let all = py.detach(|| self.0.evenly(count))?;
        Ok(out(vec![all.len()], all))
    }
}

/// Frames of a curve at parameters: points of shape `(n, d)` and axes of shape `(n, d, d)`, the tangent first.
fn split(all: Vec<f64>, count: usize, d: usize) -> (Array, Array) {
    let (mut points, mut axes) = (Vec::new(), Vec::new());
    for one in all.chunks_exact(d * (d + 1)) {
        points.extend_from_slice(&one[..d]);
        axes.extend_from_slice(&one[d..]);
    }
    (out(vec![count, d], points), out(vec![count, d, d], axes))
}

/// The Frenet frames of a curve at parameters: points of shape `(n, d)` and axes of shape `(n, d, d)`, in each the tangent, the normal, and
/// in space the binormal.
#[pyfunction]
fn frames(py: Python<'_>, curve: Thing, parameters: Array) -> Result<(Array, Array)> {
    let (curve, (_, at)) = (curve.0.to_float()?, floats(parameters)?);
    let all = py.detach(|| measure::frames(&curve, &at))?;
    Ok(split(all, at.len(), curve.dim()))
}

/// Frames of a curve in space that do not turn about the tangent from one parameter to the next, as `frames`.
#[pyfunction]
#[pyo3(signature = (curve, parameters, start=None))]
fn rotation_minimising_frames(
    py: Python<'_>,
    curve: Thing,
    parameters: Array,
    start: Option<Point>,
) -> Result<(Array, Array)> {
    let (curve, (_, at)) = (curve.0.to_float()?, floats(parameters)?);
    let start: Option<Coords> = start.map(|v| v.0);
    let all = py.detach(|| measure::still_frames(&curve, &at, start.as_ref()))?;
    Ok(split(all, at.len(), 3))
}

record! {
    "symspline.analysis"
    /// A point of a curve or surface with its distance from a given point.
    Foot {
        /// The parameter, of surfaces a pair.
        parameter: Point,
        /// The point there.
        point: Point,
        /// How far it is.
        distance: f64,
    }
}

record! {
    "symspline.analysis"
    /// All points that are nearest, within an accuracy.
    Nearest {
        /// The feet, nearest first.
        feet: Vec<Foot>,
        /// Intervals of parameters, of surfaces rectangles, in which feet could not be told from each other.
        along: Vec<(Point, Point)>,
        /// No point is nearer than this.
        bound: f64,
    }
}

/// A point of floats.
pub fn float_point(all: Vec<f64>) -> Point {
    Point(Over::Float(all))
}

fn foot((parameter, point, distance): AnyFoot) -> Foot {
    Foot { parameter: float_point(parameter), point: float_point(point), distance }
}

/// A curve or surface prepared for the nearest points of many points, over floats.
#[pyclass(frozen, module = "symspline.analysis")]
#[derive(Debug)]
pub struct Projector(Box<dyn Nears>);

#[pymethods]
impl Projector {
    #[new]
    fn new(py: Python<'_>, shape: Thing) -> Result<Self> {
        let shape = shape.0.to_float()?;
        Ok(Self(py.detach(|| measure::projector(&shape))?))
    }

    /// A foot of each point: parameters of shape `(n,)` (of surfaces `(n, 2)`), points, distances.
    fn feet(&self, py: Python<'_>, points: Array) -> Result<(Array, Array, Array)> {
        let (shape, all) = floats(points)?;
        let found = py.detach(|| self.0.feet(&Over::Float(all)))?;
        let count = found.len();
        let width = found.first().map_or(1, |f| f.0.len());
        let (mut at, mut points, mut distances) = (Vec::new(), Vec::new(), Vec::new());
        for (parameter, point, distance) in found {
            at.extend(parameter);
            points.extend(point);
            distances.push(distance);
        }
        let at = out(if width > 1 { vec![count, width] } else { vec![count] }, at);
        Ok((at, out(shape, points), out(vec![count], distances)))
    }

    /// All feet of a point within `accuracy` of the least distance, and a bound of that.
    #[pyo3(signature = (point, accuracy=1e-9))]
    fn nearest(&self, py: Python<'_>, point: Point, accuracy: f64) -> Result<Nearest> {
        let AllFeet { feet, along, bound } = py.detach(|| self.0.nearest(&point.0, accuracy))?;
        let along = along.into_iter().map(|[a, b]| (float_point(a), float_point(b))).collect();
        Ok(Nearest { feet: feet.into_iter().map(foot).collect(), along, bound })
    }

    /// The parameters at which the shape passes within `tolerance` of a point.
    #[pyo3(signature = (point, tolerance=1e-9))]
    fn parameters_of(&self, py: Python<'_>, point: Point, tolerance: f64) -> Result<Vec<Point>> {
        let all = py.detach(|| self.0.parameters_of(&point.0, tolerance))?;
        Ok(all.into_iter().map(float_point).collect())
    }
}

/// Adds the functions and classes to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<ArcLength>()?;
    module.add_class::<Foot>()?;
    module.add_class::<Nearest>()?;
    module.add_class::<Projector>()?;
    module.add_function(wrap_pyfunction!(frames, module)?)?;
    module.add_function(wrap_pyfunction!(rotation_minimising_frames, module)?)
}
