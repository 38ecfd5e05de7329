//! Zeros and curvature of curves.

use crate::error::{Failure, Result};
use crate::numbers::{Array, Num, Point};
use crate::record::record;
use crate::value::Thing;
use pyo3::prelude::*;
use symspline::Bounds;
use symspline_dynamic::tools::curvature::{self as bend, AnyEvent, Profile};
use symspline_dynamic::tools::places::{self, AnyZero, Spot};
use symspline_dynamic::{Meeting as _, Over};

/// The shape of an array, and its numbers as floats.
pub fn floats(array: Array) -> Result<(Vec<usize>, Vec<f64>)> {
    match array.numbers.to_float()? {
        Over::Float(all) => Ok((array.shape, all)),
        Over::Exact(_) => Err(Failure::new("Fields", "floats are needed")),
    }
}

/// Floats as an array of a shape.
pub fn out(shape: Vec<usize>, all: Vec<f64>) -> Array {
    Array::new(shape, Over::Float(all))
}

record! {
    "symspline.analysis"
    /// A zero, a crossing or a foot: a parameter that is known or enclosed, or a whole interval.
    Zero {
        /// The lower bound of the parameter, or the start.
        low: Num,
        /// The upper bound, equal where the parameter is known; or the end.
        high: Num,
        /// Whether it is the whole interval.
        along: bool,
        /// How often it counts.
        multiplicity: usize,
        /// The sign before, -1, 0 or 1; none at an open start.
        before: Option<i8>,
        /// The sign after.
        after: Option<i8>,
    }
}

#[pymethods]
impl Zero {
    /// Whether the signs before and after are known and differ.
    #[getter]
    fn changes_sign(&self) -> bool {
        matches!((self.before, self.after), (Some(before), Some(after)) if before != after)
    }
}

/// Zeros on their way out.
pub fn zeros_out(zeros: Vec<AnyZero>) -> Vec<Zero> {
    let one = |zero: AnyZero| {
        let Spot { low, high, along } = zero.spot;
        let [before, after] = zero.signs;
        Zero { low: Num(low), high: Num(high), along, multiplicity: zero.multiplicity, before, after }
    };
    zeros.into_iter().map(one).collect()
}

record! {
    "symspline.analysis"
    /// An event of a curvature.
    Event {
        /// "inflection", "maximum", "minimum", "jump", "stationary", "cusp", "corner" or "gap".
        kind: String,
        /// The lower bound of its parameter, or where it starts.
        low: Num,
        /// The upper bound, or where it ends.
        high: Num,
        /// Whether it goes on from one to the other.
        along: bool,
        /// Bounds of the curvature just before.
        curvature_before: (f64, f64),
        /// Bounds of the curvature just after.
        curvature_after: (f64, f64),
        /// By which angle the direction turns, of corners and cusps.
        turn: f64,
    }
}

fn bounds(b: Bounds) -> (f64, f64) {
    (b.low, b.high)
}

/// The curvatures at parameters, an array of their shape, over floats: signed in the plane.
#[pyfunction]
fn curvature(py: Python<'_>, curve: Thing, parameters: Array) -> Result<Array> {
    let (curve, (shape, at)) = (curve.0.to_float()?, floats(parameters)?);
    Ok(out(shape, py.detach(|| bend::curvatures(&curve, &at))?))
}

/// The tips of the teeth of a curvature comb at parameters, of shape `(n, d)`.
#[pyfunction]
fn curvature_comb(py: Python<'_>, curve: Thing, parameters: Array, scale: f64) -> Result<Array> {
    let (curve, (_, at)) = (curve.0.to_float()?, floats(parameters)?);
    let tips = py.detach(|| bend::comb(&curve, &at, scale))?;
    Ok(out(vec![at.len(), curve.dim()], tips))
}

/// The squared curvature, a rational function, exact of exact curves.
#[pyfunction]
fn curvature_squared(py: Python<'_>, curve: Thing) -> Result<Thing> {
    Ok(py.detach(|| bend::curvature_squared(&curve.0))?.into())
}

/// The torsion, a rational function.
#[pyfunction]
fn torsion(py: Python<'_>, curve: Thing) -> Result<Thing> {
    Ok(py.detach(|| bend::torsion(&curve.0))?.into())
}

/// The torsion of a curve in space at a parameter.
#[pyfunction]
fn torsion_at(curve: Thing, x: Num) -> Result<Num> {
    Ok(Num(bend::torsion_at(&*curve.0.among(x.0.is_exact())?, &x.0)?))
}

/// A function with the sign of the curvature of a plane curve; with `slope` one with the sign of its slope.
#[pyfunction]
#[pyo3(signature = (curve, *, slope=false))]
fn bend_condition(py: Python<'_>, curve: Thing, slope: bool) -> Result<Thing> {
    Ok(py.detach(|| bend::condition(&curve.0, slope))?.into())
}

/// The curvature of a curve along its parameter: all events, proved, and samples to draw. Of exact curves it is exact. With
/// `tolerance`, corners that turn by no more and jumps that are no larger, relatively, are passed over.
#[pyclass(frozen, module = "symspline.analysis")]
#[derive(Debug)]
pub struct CurvatureProfile(Box<dyn Profile>);

#[pymethods]
impl CurvatureProfile {
    #[new]
    #[pyo3(signature = (curve, tolerance=None))]
    fn new(py: Python<'_>, curve: Thing, tolerance: Option<f64>) -> Result<Self> {
        Ok(Self(py.detach(|| bend::profile(&curve.0, tolerance))?))
    }

    /// All events in order.
    #[getter]
    fn events(&self) -> Vec<Event> {
        let one =
            |AnyEvent { kind, spot: Spot { low, high, along }, curvature: [before, after], turn }| Event {
                kind,
                low: Num(low),
                high: Num(high),
                along,
                curvature_before: bounds(before),
                curvature_after: bounds(after),
                turn,
            };
        self.0.events().into_iter().map(one).collect()
    }

    /// How many events of a kind there are.
    fn count(&self, kind: &str) -> usize {
        self.0.events().iter().filter(|event| event.kind == kind).count()
    }

    /// Parameters, curvatures and slopes of the curvature by arc length, to draw: three arrays.
    #[getter]
    fn samples(&self) -> (Array, Array, Array) {
        let [a, b, c] = self.0.samples().map(|all| out(vec![all.len()], all));
        (a, b, c)
    }

    /// The stretches between events: start, end, and 1, -1 or 0 where the curvature rises, falls or stays.
    #[getter]
    fn runs(&self) -> Vec<(Num, Num, i8)> {
        self.0.runs().into_iter().map(|(a, b, trend)| (Num(a), Num(b), trend)).collect()
    }

    /// 1 if the curvature is proved never to fall between two parameters, -1 if never to rise, 0 if it stays; else none.
    fn trend_on(&self, a: Num, b: Num) -> Result<Option<i8>> {
        Ok(self.0.trend_on(&a.0, &b.0)?)
    }

    /// The scale of a comb nine of ten of whose teeth are no longer than `length`.
    fn comb_scale(&self, length: f64) -> f64 {
        self.0.comb_scale(length)
    }

    /// Where the events of this and another profile first differ in kind, as an index of either; none if they are the same.
    fn differs_at(&self, other: &Self) -> Option<usize> {
        self.0.differs_at(&*other.0)
    }

    /// The logarithmic curvature graph, of shape `(n, 2)`.
    fn log_log(&self) -> Array {
        let all = self.0.log_log();
        out(vec![all.len(), 2], all.concat())
    }
}

/// Bounds of the total curvature, in radians, no further apart than `accuracy`.
#[pyfunction]
#[pyo3(signature = (curve, accuracy=1e-9))]
fn total_curvature(py: Python<'_>, curve: Thing, accuracy: f64) -> Result<(f64, f64)> {
    Ok(bounds(py.detach(|| bend::total_curvature(&curve.0, accuracy))?))
}

/// Bounds of the angle by which the direction of a plane curve turns.
#[pyfunction]
fn turning_angle(py: Python<'_>, curve: Thing) -> Result<(f64, f64)> {
    Ok(bounds(py.detach(|| bend::turning_angle(&curve.0))?))
}

/// The zeros of a function, each proved to be one and none left out.
#[pyfunction]
fn zeros(py: Python<'_>, function: Thing) -> Result<Vec<Zero>> {
    Ok(zeros_out(py.detach(|| places::zeros(&function.0))?))
}

/// Where a curve crosses the line or plane `normal · x = offset`, each place proved.
#[pyfunction]
fn crossings(py: Python<'_>, curve: Thing, normal: Point, offset: Num) -> Result<Vec<Zero>> {
    let curve = curve.0.among(normal.0.is_exact() && offset.0.is_exact())?;
    Ok(zeros_out(py.detach(|| places::crossings(&curve, &normal.0, &offset.0))?))
}

/// The feet of the perpendiculars from a point on a curve, each proved.
#[pyfunction]
fn feet(py: Python<'_>, curve: Thing, point: Point) -> Result<Vec<Zero>> {
    let curve = curve.0.among(point.0.is_exact())?;
    Ok(zeros_out(py.detach(|| places::feet(&curve, &point.0))?))
}

/// Adds the functions and classes to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Zero>()?;
    module.add_class::<Event>()?;
    module.add_class::<CurvatureProfile>()?;
    module.add_function(wrap_pyfunction!(curvature, module)?)?;
    module.add_function(wrap_pyfunction!(curvature_comb, module)?)?;
    module.add_function(wrap_pyfunction!(curvature_squared, module)?)?;
    module.add_function(wrap_pyfunction!(torsion, module)?)?;
    module.add_function(wrap_pyfunction!(torsion_at, module)?)?;
    module.add_function(wrap_pyfunction!(bend_condition, module)?)?;
    module.add_function(wrap_pyfunction!(total_curvature, module)?)?;
    module.add_function(wrap_pyfunction!(turning_angle, module)?)?;
    module.add_function(wrap_pyfunction!(zeros, module)?)?;
    module.add_function(wrap_pyfunction!(crossings, module)?)?;
    module.add_function(wrap_pyfunction!(feet, module)?)
}
