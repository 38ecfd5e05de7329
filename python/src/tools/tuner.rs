//! Conditions, nearest scale functions, and prepared tuners.

use crate::arguments::Along;
use crate::error::{Failure, Result};
use crate::numbers::{Num, Point};
use crate::space::Space;
use crate::tools::values::Spaces;
use crate::tools::words::{Fits, edge, edges, hold, norm, path};
use crate::value::Thing;
use numpy::{PyReadonlyArray1, PyReadwriteArrayDyn, PyUntypedArrayMethods as _};
use pyo3::prelude::*;
use pyo3::types::{PyString, PyTuple};
use symspline_dynamic::tools::condition::{AnyCondition, AnyNearest, AnySurfaceCondition, AnySurfaceNearest};
use symspline_dynamic::tools::tuner::{self, Keeping, Tuner};
use symspline_dynamic::{AnySpace, AnySpline, AnySurface, Coords, Meeting, Number, Value};

fn wrong(what: &str, found: &Bound<'_, PyAny>) -> PyErr {
    Failure::new("Condition", format!("{found} is no condition of a {what}")).into()
}

/// The word of a condition and what follows it.
fn parts<'py>(object: &Bound<'py, PyAny>) -> PyResult<(String, Vec<Bound<'py, PyAny>>)> {
    if let Ok(word) = object.cast::<PyString>() {
        return Ok((word.to_string(), Vec::new()));
    }
    let tuple = object.cast::<PyTuple>()?;
    let mut items = tuple.iter();
    let word = items.next().ok_or_else(|| wrong("curve or surface", object))?.extract()?;
    Ok((word, items.collect()))
}

/// Remembers whether all numbers that were read are exact.
struct Reader(bool);

impl Reader {
    fn number(&mut self, object: &Bound<'_, PyAny>) -> PyResult<Number> {
        let x = object.extract::<Num>()?.0;
        self.0 &= x.is_exact();
        Ok(x)
    }

    fn point(&mut self, object: &Bound<'_, PyAny>) -> PyResult<Coords> {
        let p = object.extract::<Point>()?.0;
        self.0 &= p.is_exact();
        Ok(p)
    }

    fn place(&mut self, object: &Bound<'_, PyAny>) -> PyResult<(Number, Number)> {
        let (u, v): (Bound<'_, PyAny>, Bound<'_, PyAny>) = object.extract()?;
        Ok((self.number(&u)?, self.number(&v)?))
    }

    fn of_curve(&mut self, object: &Bound<'_, PyAny>) -> PyResult<AnyCondition> {
        let (word, items) = parts(object)?;
        Ok(match (word.as_str(), &items[..]) {
            ("end", []) => AnyCondition::End,
            ("area", []) => AnyCondition::Area,
            ("point", [x, p]) => AnyCondition::Point { parameter: self.number(x)?, point: self.point(p)? },
            ("chord", [a, b, v]) => {
                AnyCondition::Chord { from: self.number(a)?, to: self.number(b)?, chord: self.point(v)? }
            }
            ("derivatives", [x, count]) => {
                AnyCondition::Derivatives { parameter: self.number(x)?, count: count.extract()? }
            }
            ("scale", [x, value]) => {
                AnyCondition::Scale { parameter: self.number(x)?, value: self.number(value)? }
            }
            ("coefficient", [i, value]) => {
                AnyCondition::Coefficient { index: i.extract()?, value: self.number(value)? }
            }
            _ => return Err(wrong("curve", object)),
        })
    }

    fn of_surface(&mut self, object: &Bound<'_, PyAny>) -> PyResult<AnySurfaceCondition> {
        let (word, items) = parts(object)?;
        Ok(match (word.as_str(), &items[..]) {
            ("edge", [name]) => {
                AnySurfaceCondition::Edge { edge: edge(&name.extract::<String>()?)?, order: 0 }
            }
            ("edge", [name, order]) => {
                AnySurfaceCondition::Edge { edge: edge(&name.extract::<String>()?)?, order: order.extract()? }
            }
            ("closed", [name]) => AnySurfaceCondition::Closed { direction: name.extract::<Along>()?.0 },
            ("derivative", [at, order, value]) => AnySurfaceCondition::Derivative {
                at: self.place(at)?,
                order: order.extract()?,
                value: self.point(value)?,
            },
            ("scale", [at, value]) => {
                AnySurfaceCondition::Scale { at: self.place(at)?, value: self.number(value)? }
            }
            ("coefficient", [index, value]) => {
                AnySurfaceCondition::Coefficient { index: index.extract()?, value: self.number(value)? }
            }
            _ => return Err(wrong("surface", object)),
        })
    }
}

/// A shape with spaces of scale functions and conditions, all over one field.
enum Wanted {
    Curve(AnySpline, AnySpace, Vec<AnyCondition>),
    Surface(AnySurface, [AnySpace; 2], Vec<AnySurfaceCondition>),
}

/// As it is if all is exact, else over floats.
fn taken<M: Meeting>(of: &M, exact: bool) -> Result<M> {
    Ok(of.among(exact)?.into_owned())
}

fn wanted(shape: Thing, scales: Spaces, conditions: &[Bound<'_, PyAny>]) -> PyResult<Wanted> {
    let mut reader = Reader(true);
    match (shape.0, scales) {
        (Value::Spline(c), Spaces::One(Space(s))) => {
            let all = conditions.iter().map(|x| reader.of_curve(x)).collect::<PyResult<_>>()?;
            let exact = reader.0 && c.is_exact() && s.is_exact();
            Ok(Wanted::Curve(taken(&c, exact)?, taken(&s, exact)?, all))
        }
        (Value::Surface(s), Spaces::Two(Space(u), Space(v))) => {
            let all = conditions.iter().map(|x| reader.of_surface(x)).collect::<PyResult<_>>()?;
            let exact = reader.0 && s.is_exact() && u.is_exact() && v.is_exact();
            Ok(Wanted::Surface(taken(&s, exact)?, [taken(&u, exact)?, taken(&v, exact)?], all))
        }
        (shape, _) => Err(Failure::new(
            "NoSuch",
            format!("a Spline needs one space of scale functions, a Surface two; this is {shape}"),
        )
        .into()),
    }
}

#[derive(Debug)]
enum Nearest {
    Curve(AnyNearest),
    Surface(AnySurfaceNearest),
}

/// Conditions on a fine-tuned curve or surface, prepared for finding the nearest scale functions that meet them.
///
/// Conditions of a curve are "end" (it stays, so a closed curve stays closed), "area", or tuples: ("point", x, p), ("chord", a, b,
/// vector), ("derivatives", x, count), ("scale", x, value), ("coefficient", i, value). Of a surface: ("edge", "u_start", order),
/// ("closed", "u"), ("derivative", (u, v), (k, l), value), ("scale", (u, v), value), ("coefficient", (i, j), value). `scales` is a
/// space, of a surface a pair of them; `norm` says what near means, "l2" or "coefficients".
#[pyclass(frozen, module = "symspline.fine_tune")]
#[derive(Debug)]
pub struct NearestScale(Nearest);

#[pymethods]
impl NearestScale {
    #[new]
    #[pyo3(signature = (shape, scales, conditions, norm="l2", *, path="both"))]
    fn new(
        py: Python<'_>,
        shape: Thing,
        scales: Spaces,
        conditions: Vec<Bound<'_, PyAny>>,
        norm: &str,
        path: &str,
    ) -> PyResult<Self> {
        let (norm, path) = (self::norm(norm)?, self::path(path)?);
        let found = match wanted(shape, scales, &conditions)? {
            Wanted::Curve(c, s, all) => {
                py.detach(|| AnyNearest::prepare(&c, &s, &all, norm)).map(Nearest::Curve)
            }
            Wanted::Surface(s, pair, all) => {
                py.detach(|| AnySurfaceNearest::prepare(&s, &pair, path, &all, norm)).map(Nearest::Surface)
            }
        };
        Ok(Self(found.map_err(Failure::from)?))
    }

    /// The positive scale function nearest to `wanted` that meets the conditions; of any sign if `signed`. Numbers are taken into the
    /// field of the conditions.
    #[pyo3(signature = (wanted, *, signed=false))]
    fn to(&self, py: Python<'_>, wanted: Thing, signed: bool) -> Result<Thing> {
        let wanted = wanted.0;
        let exact = match &self.0 {
            Nearest::Curve(n) => n.is_exact(),
            Nearest::Surface(n) => n.is_exact(),
        };
        let wanted = if exact { wanted.to_exact()? } else { wanted.to_float()? };
        Ok(py.detach(|| match (&self.0, &wanted) {
            (Nearest::Curve(n), Value::Spline(a)) => n.to(a, signed).map(Thing::from),
            (Nearest::Surface(n), Value::Surface(a)) => n.to(a, signed).map(Thing::from),
            (_, other) => Err(other.none_of("nearest scale function")),
        })?)
    }
}

/// Values of a scale function: its coefficients, or the function.
#[derive(FromPyObject)]
enum Values {
    Shape(crate::spline::Spline),
    Surface(crate::surface::Surface),
    Numbers(crate::numbers::Array),
}

/// A curve or surface prepared for fine tuning by scale functions with coefficients in `scales`: once made, each tuned shape is a
/// short sum for each control point.
///
/// With `hold` (of a surface `edges`) the ends are put back; with `conditions` the nearest scale functions are taken that meet them,
/// see `NearestScale`. Numbers are taken into the field of what it was made from.
#[pyclass(frozen, module = "symspline.fine_tune")]
#[derive(Debug)]
pub struct FineTuner {
    tuner: Box<dyn Tuner>,
    dim: usize,
}

#[pymethods]
impl FineTuner {
    #[new]
    #[pyo3(signature = (shape, scales, *, hold=None, conditions=None, norm="l2", path="both", edges=None, signed=false))]
    #[allow(clippy::too_many_arguments, reason = "Python names them")]
    fn new(
        py: Python<'_>,
        shape: Thing,
        scales: Spaces,
        hold: Option<&str>,
        conditions: Option<Vec<Bound<'_, PyAny>>>,
        norm: &str,
        path: &str,
        edges: Option<Fits>,
        signed: bool,
    ) -> PyResult<Self> {
        let (norm, path) = (self::norm(norm)?, self::path(path)?);
        let dim = shape.0.dim();
        let is_near = conditions.is_some();
        if is_near && (hold.is_some() || edges.is_some()) {
            return Err(Failure::new("Word", "either ends are held or conditions are met, not both").into());
        }
        let tuner = match wanted(shape, scales, &conditions.unwrap_or_default())? {
            Wanted::Curve(c, s, all) => {
                let keeping = match hold {
                    _ if is_near => Keeping::Nearest(all, norm),
                    Some(name) => Keeping::Holding(self::hold(name)?),
                    None => Keeping::Free,
                };
                py.detach(|| tuner::curve_tuner(&c, &s, &keeping, signed))
            }
            Wanted::Surface(s, pair, all) => {
                let keeping = match edges {
                    _ if is_near => Keeping::Nearest(all, norm),
                    None => Keeping::Free,
                    fits => Keeping::Holding(self::edges(fits)?),
                };
                py.detach(|| tuner::surface_tuner(&s, &pair, path, &keeping, signed))
            }
        };
        Ok(Self { tuner: tuner.map_err(Failure::from)?, dim })
    }

    /// The space of the tuned curves, or the spaces of the tuned surfaces.
    #[getter]
    fn spaces(&self) -> Vec<Space> {
        self.tuner.spaces().into_iter().map(Space).collect()
    }

    /// The shape tuned by a scale function: its coefficients, of shape `scales.dim` or `(u.dim, v.dim)`, or the function itself.
    fn tuned(&self, py: Python<'_>, alpha: Values) -> Result<Thing> {
        let coeffs = match alpha {
            Values::Shape(f) => tuner::scale_coeffs(&f.0.into())?,
            Values::Surface(f) => tuner::scale_coeffs(&f.0.into())?,
            Values::Numbers(array) => array.numbers,
        };
        Ok(Thing(py.detach(|| self.tuner.tuned(&coeffs))?))
    }

    /// Writes the control points of the tuned shape into an array of floats of their shape; `alpha` is an array of floats.
    fn tune_into(
        &self,
        py: Python<'_>,
        alpha: PyReadonlyArray1<'_, f64>,
        mut out: PyReadwriteArrayDyn<'_, f64>,
    ) -> PyResult<()> {
        let torn = || Failure::new("Shape", "a contiguous array of control points is needed");
        let alpha = alpha.as_slice().map_err(|_| torn())?;
        if out.shape().last() != Some(&self.dim) {
            return Err(torn().into());
        }
        let out = out.as_slice_mut().map_err(|_| torn())?;
        Ok(py.detach(|| self.tuner.tune_into(alpha, out)).map_err(Failure::from)?)
    }
}

/// Adds the classes to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<NearestScale>()?;
    module.add_class::<FineTuner>()
}
