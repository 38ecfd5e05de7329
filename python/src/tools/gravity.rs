//! Parts of the parameter plane, for warps: gravity fields and polygons.

use crate::error::{Failure, Result};
use crate::numbers::{Array, Num, Point};
use crate::record::record;
use crate::spline::Spline;
use pyo3::prelude::*;
use symspline::CurveGravity as CurveField;
use symspline_dynamic::tools::gravity::{self, AnyGravity, AnyPolygons, AnyPull};
use symspline_dynamic::{AnySpline, Coords, Meeting as _, both};

record! {
    "symspline.shape"
    /// What pulls at a point: the nearest place of lines in the parameter plane.
    GravityPull {
        /// The squared distance to it.
        squared_distance: Num,
        /// Which of the lines.
        line: usize,
        /// The place on the line: of a polyline the index of the leg and the share of it, of a curve its parameter.
        place: Num,
        /// The place in the plane.
        foot: Point,
    }
}

fn out(found: Option<AnyPull>) -> Option<GravityPull> {
    found.map(|pull| GravityPull {
        squared_distance: Num(pull.squared_distance),
        line: pull.line,
        place: Num(pull.place),
        foot: Point(pull.foot),
    })
}

/// The points of each line, of shape `(n, 2)`.
fn plane(lines: Vec<Array>) -> Result<Vec<Coords>> {
    let of = |line: Array| match line.shape[..] {
        [_, 2] => Ok(line.numbers),
        _ => Err(Failure::new("Shape", "a line or polygon has points of shape (n, 2)")),
    };
    lines.into_iter().map(of).collect()
}

/// The gravity field of some polylines in the plane, each of shape `(n, 2)`: what is no farther away than `radius` is pulled. Exact if
/// all numbers are.
#[pyclass(frozen, eq, module = "symspline.shape")]
#[derive(Debug, PartialEq)]
pub struct Gravity(AnyGravity);

#[pymethods]
impl Gravity {
    #[new]
    fn new(py: Python<'_>, polylines: Vec<Array>, radius: Num) -> Result<Self> {
        let polylines = plane(polylines)?;
        let exact = radius.0.is_exact() && polylines.iter().all(Coords::is_exact);
        let radius = radius.0.among(exact)?;
        Ok(Self(py.detach(|| gravity::gravity(&polylines, &radius))?))
    }

    /// The square of the radius.
    #[getter]
    fn squared_radius(&self) -> Num {
        both!(&self.0, g => Num(symspline_dynamic::Field::number(g.squared_radius().clone())))
    }

    /// The nearest place of the polylines, none beyond the radius; of several the first. The point is taken into the field of the
    /// polylines.
    fn pull(&self, py: Python<'_>, point: Point) -> Result<Option<GravityPull>> {
        Ok(out(py.detach(|| gravity::pull(&self.0, &point.0))?))
    }
}

/// The gravity field of some plane curves, over floats: what is no farther away than `radius` is pulled.
#[pyclass(frozen, module = "symspline.shape")]
#[derive(Debug)]
pub struct CurveGravity(CurveField);

#[pymethods]
impl CurveGravity {
    #[new]
    fn new(py: Python<'_>, curves: Vec<Spline>, radius: f64) -> Result<Self> {
        let curves: Vec<AnySpline> = curves.iter().map(|c| Ok(c.0.to_float()?)).collect::<Result<_>>()?;
        Ok(Self(py.detach(|| gravity::curve_gravity(&curves, radius))?))
    }

    /// The nearest place of the curves, none beyond the radius; of several the first.
    fn pull(&self, py: Python<'_>, point: Point) -> Result<Option<GravityPull>> {
        Ok(out(py.detach(|| gravity::curve_pull(&self.0, &point.0))?))
    }
}

/// The region bounded by polygons, each of shape `(n, 2)` and closed, by the even-odd rule: one within another is a hole. Edges and
/// corners belong to it. Exact if all numbers are.
#[pyclass(frozen, eq, module = "symspline.shape")]
#[derive(Debug, PartialEq)]
pub struct Polygons(AnyPolygons);

#[pymethods]
impl Polygons {
    #[new]
    fn new(polygons: Vec<Array>) -> Result<Self> {
        Ok(Self(gravity::polygons(&plane(polygons)?)?))
    }

    /// Whether a point is in the region. It is taken into the field of the polygons.
    fn contains(&self, point: Point) -> Result<bool> {
        Ok(gravity::contains(&self.0, &point.0)?)
    }
}

/// Adds the classes to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<GravityPull>()?;
    module.add_class::<Gravity>()?;
    module.add_class::<CurveGravity>()?;
    module.add_class::<Polygons>()
}
