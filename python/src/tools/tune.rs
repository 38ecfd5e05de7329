//! Fine tuning of curves and surfaces.

use crate::error::{Failure, Result};
use crate::numbers::{Array, Num, Point};
use crate::record::record;
use crate::space::Space;
use crate::spline::Spline;
use crate::surface::Surface;
use crate::tools::words::{self, Fits};
use crate::value::Thing;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use symspline::Springs;
use symspline_dynamic::tools::local::Local;
use symspline_dynamic::tools::tune;
use symspline_dynamic::{AnySpline, AnySurface, Meeting as _, Value, together};

/// A curve or a surface, with a scale function over the same field.
pub enum Scaled {
    /// A curve.
    Curve(AnySpline, AnySpline),
    /// A surface.
    Surface(AnySurface, AnySurface),
}

/// A shape and a scale function as they go together.
pub fn scaled(shape: Thing, alpha: Thing) -> Result<Scaled> {
    match (shape.0, alpha.0) {
        (Value::Spline(c), Value::Spline(a)) => {
            let (c, a) = (&c, &a);
            together!(c, a);
            Ok(Scaled::Curve(c.into_owned(), a.into_owned()))
        }
        (Value::Surface(s), Value::Surface(a)) => {
            let (s, a) = (&s, &a);
            together!(s, a);
            Ok(Scaled::Surface(s.into_owned(), a.into_owned()))
        }
        (shape, alpha) => Err(Failure::new(
            "NoSuch",
            format!(
                "fine tuning is for a Spline by a Spline or a Surface by a Surface, not {shape} by {alpha}"
            ),
        )),
    }
}

record! {
    "symspline.fine_tune"
    /// A curve with its ends put back.
    HeldCurve {
        /// The curve.
        curve: Thing,
        /// The freely tuned curve under the same similarity, over the same knots.
        image: Thing,
        /// The square of the scale of the similarity.
        squared_scale: Num,
        /// From where to where the curve is its image, if anywhere.
        similar: Option<(Num, Num)>,
    }
}

record! {
    "symspline.fine_tune"
    /// A surface with its edges put back.
    HeldSurface {
        /// The surface.
        surface: Thing,
        /// At least the largest distance by which control points were forced.
        forced: Num,
    }
}

record! {
    "symspline.fine_tune"
    /// A shape that stands for another, and how far it is off at most.
    Approximation {
        /// The shape.
        spline: Thing,
        /// The bound, proved.
        bound: Num,
    }
}

record! {
    "symspline.fine_tune"
    /// A closed curve whose control polygon is a chain of springs at rest.
    Relaxed {
        /// The curve.
        curve: Thing,
        /// The energy where the springs were released.
        energy_before: f64,
        /// The energy.
        energy: f64,
        /// The largest deviation of a leg's length, relative.
        length_deviation: f64,
        /// The largest deviation of an angle, in radians.
        angle_deviation: f64,
        /// The steps it took.
        iterations: usize,
        /// What is left of the gradient.
        gradient: f64,
        /// Whether that is within the tolerance.
        converged: bool,
    }
}

impl From<tune::HeldCurve> for HeldCurve {
    fn from(held: tune::HeldCurve) -> Self {
        Self {
            curve: held.curve.into(),
            image: held.image.into(),
            squared_scale: Num(held.squared_scale),
            similar: held.similar.map(|(a, b)| (Num(a), Num(b))),
        }
    }
}

impl HeldSurface {
    fn of((surface, forced): tune::HeldAnySurface) -> Self {
        Self { surface: surface.into(), forced: Num(forced) }
    }
}

impl Approximation {
    fn of((spline, bound): (AnySpline, symspline_dynamic::Number)) -> Self {
        Self { spline: spline.into(), bound: Num(bound) }
    }
}

/// The curve or surface with its derivative multiplied by `alpha`: `D = C(a) + ∫ alpha C'`, so that its curvature is that of `C` over
/// `alpha`. Of a surface along `path`, "uv", "vu" or the mean of "both". `alpha` must be positive unless `signed`.
#[pyfunction]
#[pyo3(signature = (shape, alpha, path="both", *, signed=false))]
fn fine_tuned(py: Python<'_>, shape: Thing, alpha: Thing, path: &str, signed: bool) -> Result<Thing> {
    let path = words::path(path)?;
    let scaled = scaled(shape, alpha)?;
    Ok(py.detach(|| match scaled {
        Scaled::Curve(c, a) => c.fine_tuned(&a, signed).map(Thing::from),
        Scaled::Surface(s, a) => s.fine_tuned(&a, signed, path).map(Thing::from),
    })?)
}

/// The surface that agrees with this one at an edge, "u_start" and so on, with the derivative that leads away from it multiplied.
#[pyfunction]
#[pyo3(signature = (surface, alpha, edge, *, signed=false))]
fn fine_tuned_from(
    py: Python<'_>,
    surface: Surface,
    alpha: Surface,
    edge: &str,
    signed: bool,
) -> Result<Thing> {
    let edge = words::edge(edge)?;
    let (s, a) = (&surface.0, &alpha.0);
    together!(s, a);
    Ok(py.detach(|| s.fine_tuned_from(&a, signed, edge))?.into())
}

/// The curve tuned, then rotated and scaled so that its ends are held: `hold` is "points", "tangents" or "curvatures"; a
/// `HeldCurve`. Of a surface the edges fit as `edges` says, one word for all or a dict of words: "free", "position", "tangent",
/// "curvature"; a `HeldSurface`.
#[pyfunction]
#[pyo3(signature = (shape, alpha, hold="points", *, path="both", edges=None, signed=false))]
fn fine_tuned_holding<'py>(
    py: Python<'py>,
    shape: Thing,
    alpha: Thing,
    hold: &str,
    path: &str,
    edges: Option<Fits>,
    signed: bool,
) -> PyResult<Bound<'py, PyAny>> {
    let (hold, path, edges) = (words::hold(hold)?, words::path(path)?, words::edges(edges)?);
    match scaled(shape, alpha)? {
        Scaled::Curve(c, a) => {
            let held = py.detach(|| c.fine_tuned_holding(&a, signed, hold)).map_err(Failure::from)?;
            Ok(HeldCurve::from(held).into_pyobject(py)?.into_any())
        }
        Scaled::Surface(s, a) => {
            let held = py.detach(|| s.fine_tuned_holding(&a, signed, path, edges)).map_err(Failure::from)?;
            Ok(HeldSurface::of(held).into_pyobject(py)?.into_any())
        }
    }
}

/// A curve with a portion of it fine-tuned.
#[pyclass(frozen, module = "symspline.fine_tune")]
#[derive(Debug)]
pub struct LocallyTuned(Box<dyn Local>);

#[pymethods]
impl LocallyTuned {
    /// The piece before the portion, if there is one.
    #[getter]
    fn before(&self) -> Option<Spline> {
        let [before, _] = self.0.rest();
        before.map(Spline)
    }

    /// The piece after the portion, if there is one.
    #[getter]
    fn after(&self) -> Option<Spline> {
        let [_, after] = self.0.rest();
        after.map(Spline)
    }

    /// The portion, tuned.
    #[getter]
    fn tuned(&self) -> HeldCurve {
        self.0.tuned().into()
    }

    /// The order of the derivatives that agree at the ends of the portion.
    #[getter]
    fn order(&self) -> usize {
        self.0.order()
    }

    /// Start and end of the portion.
    #[getter]
    fn portion(&self) -> (Num, Num) {
        let (start, end) = self.0.portion();
        (Num(start), Num(end))
    }

    /// All as one spline.
    fn joined(&self, py: Python<'_>) -> Result<Spline> {
        Ok(Spline(py.detach(|| self.0.joined())?))
    }

    /// One spline of the degree that the curve had, within a tolerance.
    fn reduced(&self, py: Python<'_>, tolerance: Num) -> Result<Approximation> {
        Ok(Approximation::of(py.detach(|| self.0.reduced(&tolerance.0))?))
    }

    /// The nearest one in the space that the curve had.
    fn in_original_space(&self, py: Python<'_>) -> Result<Approximation> {
        Ok(Approximation::of(py.detach(|| self.0.in_original_space())?))
    }
}

/// The curve with the portion over the domain of `alpha` tuned and its ends held, a `LocallyTuned`; the surface with a rectangle
/// tuned, a `HeldSurface` of the rectangle and the whole as one surface.
#[pyfunction]
#[pyo3(signature = (shape, alpha, hold="points", *, path="both", edges=None, signed=false))]
fn fine_tuned_on<'py>(
    py: Python<'py>,
    shape: Thing,
    alpha: Thing,
    hold: &str,
    path: &str,
    edges: Option<Fits>,
    signed: bool,
) -> PyResult<Bound<'py, PyAny>> {
    let (hold, path, edges) = (words::hold(hold)?, words::path(path)?, words::edges(edges)?);
    match scaled(shape, alpha)? {
        Scaled::Curve(c, a) => {
            let local = py.detach(|| c.fine_tuned_on(&a, signed, hold)).map_err(Failure::from)?;
            Ok(LocallyTuned(local).into_pyobject(py)?.into_any())
        }
        Scaled::Surface(s, a) => {
            let (held, joined) =
                py.detach(|| s.fine_tuned_on(&a, signed, path, edges)).map_err(Failure::from)?;
            Ok((HeldSurface::of(held), Surface(joined)).into_pyobject(py)?.into_any())
        }
    }
}

/// The curve with the portion over the domain of `wanted` tuned by the nearest scale function with which it fits, derivatives up to
/// `order` included; tangents keep their directions. `norm` is "l2" or "coefficients".
#[pyfunction]
#[pyo3(signature = (curve, wanted, order=1, norm="l2"))]
fn fine_tuned_on_by_nearest(
    py: Python<'_>,
    curve: Spline,
    wanted: Spline,
    order: usize,
    norm: &str,
) -> Result<LocallyTuned> {
    let norm = words::norm(norm)?;
    let (c, a) = (&curve.0, &wanted.0);
    together!(c, a);
    Ok(LocallyTuned(py.detach(|| c.fine_tuned_on_by_nearest(&a, order, norm))?))
}

/// The curve tuned over the domain of `alpha` with its degree kept, within a tolerance.
#[pyfunction]
#[pyo3(signature = (curve, alpha, tolerance, hold="points", *, signed=false))]
fn fine_tuned_within(
    py: Python<'_>,
    curve: Spline,
    alpha: Spline,
    tolerance: Num,
    hold: &str,
    signed: bool,
) -> Result<Approximation> {
    let hold = words::hold(hold)?;
    let (c, a, tolerance) = (&curve.0, &alpha.0, &tolerance.0);
    together!(c, a, tolerance);
    Ok(Approximation::of(py.detach(|| c.fine_tuned_within(&a, signed, hold, &tolerance))?))
}

/// The closed curve tuned as nearly as it stays closed: its control polygon becomes a chain of springs and comes to rest. Keywords
/// are `stretch`, `bend`, `uniform`, `fixed`, `iterations`, `tolerance`. Exact curves are rounded to floats.
#[pyfunction]
#[pyo3(signature = (curve, alpha, *, signed=false, **springs))]
fn fine_tuned_closed(
    py: Python<'_>,
    curve: Spline,
    alpha: Spline,
    signed: bool,
    springs: Option<&Bound<'_, PyDict>>,
) -> PyResult<Relaxed> {
    let mut how = Springs::default();
    for (key, value) in springs.into_iter().flatten() {
        match key.extract::<String>()?.as_str() {
            "stretch" => how.stretch = value.extract()?,
            "bend" => how.bend = value.extract()?,
            "uniform" => how.uniform = value.extract()?,
            "fixed" => how.fixed = value.extract()?,
            "iterations" => how.iterations = value.extract()?,
            "tolerance" => how.tolerance = value.extract()?,
            other => return Err(Failure::new("Word", format!("springs have no \"{other}\"")).into()),
        }
    }
    let found = py.detach(|| -> Result<_> {
        Ok(tune::closed(&curve.0.to_float()?, &alpha.0.to_float()?, signed, &how)?)
    })?;
    let ([energy_before, energy], [length_deviation, angle_deviation]) = (found.energies, found.deviations);
    Ok(Relaxed {
        curve: found.curve.into(),
        energy_before,
        energy,
        length_deviation,
        angle_deviation,
        iterations: found.iterations,
        gradient: found.gradient,
        converged: found.converged,
    })
}

/// A scale function of a space that multiplies the curvature by about `ratio`.
#[pyfunction]
fn scale_for_curvature_ratio(py: Python<'_>, scales: Space, ratio: Spline) -> Result<Approximation> {
    let (scales, ratio) = (&scales.0, &ratio.0);
    together!(scales, ratio);
    Ok(Approximation::of(py.detach(|| tune::scale_for_curvature_ratio(&scales, &ratio))?))
}

/// What each coefficient of a scale function in `scales` adds to the chord from `x` to `y`, of shape `(scales.dim, d)`.
#[pyfunction]
fn scale_moments(curve: Spline, scales: Space, x: Num, y: Num) -> Result<Array> {
    let (c, scales, x, y) = (&curve.0, &scales.0, &x.0, &y.0);
    together!(c, scales, x, y);
    Ok(Array::of_points(c.dim(), c.scale_moments(&scales, &x, &y)?))
}

/// The function or curve of the same space with the value `to` at `x`, by the least change: of "coefficients", or in "l2".
#[pyfunction]
#[pyo3(signature = (spline, x, to, norm="coefficients"))]
fn dragged(spline: Spline, x: Num, to: Point, norm: &str) -> Result<Spline> {
    let s = spline.0.among(x.0.is_exact() && to.0.is_exact())?;
    Ok(Spline(s.dragged_value(&x.0, &to.0, words::norm(norm)?)?))
}

/// The difference of the surfaces that `alpha` makes along both paths, and how far apart they are at most.
#[pyfunction]
fn path_gap(py: Python<'_>, surface: Surface, alpha: Surface) -> Result<Approximation> {
    let (s, a) = (&surface.0, &alpha.0);
    together!(s, a);
    let (difference, bound) = py.detach(|| s.path_gap(&a))?;
    Ok(Approximation { spline: difference.into(), bound: Num(bound) })
}

/// Adds the functions and classes to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<HeldCurve>()?;
    module.add_class::<HeldSurface>()?;
    module.add_class::<Approximation>()?;
    module.add_class::<Relaxed>()?;
    module.add_class::<LocallyTuned>()?;
    module.add_function(wrap_pyfunction!(fine_tuned, module)?)?;
    module.add_function(wrap_pyfunction!(fine_tuned_from, module)?)?;
    module.add_function(wrap_pyfunction!(fine_tuned_holding, module)?)?;
    module.add_function(wrap_pyfunction!(fine_tuned_on, module)?)?;
    module.add_function(wrap_pyfunction!(fine_tuned_on_by_nearest, module)?)?;
    module.add_function(wrap_pyfunction!(fine_tuned_within, module)?)?;
    module.add_function(wrap_pyfunction!(fine_tuned_closed, module)?)?;
    module.add_function(wrap_pyfunction!(scale_for_curvature_ratio, module)?)?;
    module.add_function(wrap_pyfunction!(scale_moments, module)?)?;
    module.add_function(wrap_pyfunction!(dragged, module)?)?;
    module.add_function(wrap_pyfunction!(path_gap, module)?)
}
