//! Bends.

use crate::arguments::Along;
use crate::called::Called;
use crate::error::{Failure, Result};
use crate::numbers::{Array, Num, Point};
use crate::tools::form::{Finer, is_exact};
use crate::value::Thing;
use pyo3::prelude::*;
use symspline::shape::bend_ratio::bent_share;
use symspline::{Direction, bent_point, cross_ratio};
use symspline_dynamic::tools::bend::{self, About, AnyBend, AnyOffsetAxis, Centre, Ratio};
use symspline_dynamic::tools::shape::point;
use symspline_dynamic::{Coords, Field, Meeting as _, Number, Value, with_points};

/// The axis of a bend at a signed distance from an isocurve of a surface, over floats: the isocurve where the parameter in
/// `direction` is `at`, moved by `offset` along the unit normal.
#[pyclass(frozen, module = "symspline.shape", from_py_object)]
#[derive(Clone, Debug)]
pub struct OffsetAxis(AnyOffsetAxis);

#[pymethods]
impl OffsetAxis {
    #[new]
    #[pyo3(signature = (surface, at, offset, direction=Along(Direction::U)))]
    fn new(py: Python<'_>, surface: Thing, at: f64, offset: f64, direction: Along) -> Result<Self> {
        let surface = surface.0.to_float()?;
        Ok(Self(py.detach(|| AnyOffsetAxis::new(&surface, direction.0, at, offset))?))
    }

    /// The point of the axis at a parameter of the isocurve.
    fn point(&self, w: f64) -> Result<Point> {
        Ok(Point(self.0.point(w)?))
    }

    /// The point of the axis that is nearest to a point, as far as eight samples a span tell.
    fn centre_of(&self, point: Point) -> Result<Point> {
        Ok(Point(self.0.centre_of(&point.0)?))
    }
}

/// What a shape is bent towards.
#[derive(FromPyObject)]
enum Towards {
    /// An axis at a distance from a surface.
    Axis(OffsetAxis),
    /// A point.
    Point(Point),
}

/// The shape bent towards a centre, a point or with `axis` the line through it or an `OffsetAxis`, about something.
///
/// About a circle, sphere or cylinder of `radius` around the centre, or around the point `about`; with `normal` about the line or plane
/// through the point `about`; else `about` is a plane curve, a surface (over floats), or a callable from the centre and a control point to
/// the share of the way between them at which the bend curve is, or `None`, whose exceptions come out as they are. `ratio` is the cross
/// ratio, a number or a function of the parameters: 1 leaves shapes as they are at it, larger ones bend more. Between the knots of
/// `interval` alone, what is outside being carried along unless `tails` is false; `refine` inserts knots first. Over fractions, where
/// square roots may not be there, an error says so.
#[pyfunction]
#[pyo3(signature = (shape, centre, ratio, *, radius=None, about=None, normal=None, axis=None, direction=Along(Direction::U), interval=None, refine=None,
    tails=true))]
#[allow(clippy::too_many_arguments, reason = "Python names them")]
fn bent(
    py: Python<'_>,
    shape: Thing,
    centre: Towards,
    ratio: Thing,
    radius: Option<Num>,
    about: Option<Bound<'_, PyAny>>,
    normal: Option<Point>,
    axis: Option<Point>,
    direction: Along,
    interval: Option<(Num, Num)>,
    refine: Option<Finer>,
    tails: bool,
) -> PyResult<Thing> {
    let refine = refine.map(|r| r.0);
    let called = Called::default();
    let callable = about.as_ref().filter(|about| about.is_callable()).map(|about| about.clone().unbind());
    // Shapes can be called, too: they are shapes first.
    let thing = about.as_ref().map(|about| about.extract::<Thing>());
    let (thing, callable) = match (thing, callable) {
        (Some(Ok(thing)), _) => (Some(thing), None),
        (Some(Err(_)), Some(callable)) => (None, Some(callable)),
        (Some(Err(error)), None) => return Err(error),
        (None, _) => (None, None),
    };
    let mut exact = ratio.0.is_exact() && is_exact(&refine) && shape.0.is_exact();
    exact &= matches!(&centre, Towards::Point(centre) if centre.0.is_exact());
    for vector in [&normal, &axis].into_iter().flatten() {
        exact &= vector.0.is_exact();
    }
    // Where a ray meets a surface is known over floats alone.
    exact &= thing.as_ref().is_none_or(|about| {
        about.0.is_exact() && !matches!(about.0, Value::Surface(_) | Value::RationalSurface(_))
    });
    exact &= radius.as_ref().is_none_or(|r| r.0.is_exact());
    exact &= interval.as_ref().is_none_or(|(a, b)| a.0.is_exact() && b.0.is_exact());
    let ratio = match ratio.0.among(exact).map_err(Failure::from)?.into_owned() {
        Value::Number(x) => Ratio::Constant(x),
        Value::Spline(f) => Ratio::Along(f),
        Value::Surface(f) => Ratio::Over(f),
        other => return Err(Failure::new("NoSuch", format!("{other} is no cross ratio")).into()),
    };
    let share = |centre: &Coords, place: &Coords| {
        let Some(callable) = &callable else { return Ok(None) };
        called.call(|py| {
            let found = callable.bind(py).call1((Point(centre.clone()), Point(place.clone())))?;
            Ok(found.extract::<Option<Num>>()?.map(|s| s.0))
        })
    };
    let about = match (radius, thing.map(|about| about.0), normal) {
        (Some(r), None, None) if callable.is_none() => About::Round(r.0),
        (Some(r), Some(Value::Point(c)), None) => About::Sphere(c, r.0),
        (None, Some(Value::Point(p)), Some(n)) => About::Flat(p, n.0),
        (None, None, None) if callable.is_some() => About::Share(&share),
        (None, Some(shape), None) if !matches!(shape, Value::Point(_) | Value::Number(_)) => {
            About::Shape(shape.among(exact).map_err(Failure::from)?.into_owned())
        }
        _ => {
            return Err(Failure::new(
                "Word",
                "a bend is about a radius, about a centre with a radius, about a point with a normal, about a curve or surface, or by a callable",
            )
            .into());
        }
    };
    let centre = match (centre, axis) {
        (Towards::Point(centre), None) => Centre::Point(centre.0),
        (Towards::Point(centre), Some(axis)) => Centre::Axis(centre.0, axis.0),
        (Towards::Axis(axis), None) => Centre::Offset(axis.0),
        (Towards::Axis(_), Some(_)) => {
            return Err(Failure::new("Word", "the centre is an axis, or a point with one").into());
        }
    };
    let how = AnyBend {
        centre,
        about,
        ratio,
        direction: direction.0,
        interval: interval.map(|(a, b)| (a.0, b.0)),
        refine,
        tails,
    };
    let shape = shape.0.among(exact).map_err(Failure::from)?;
    let found = py.detach(|| bend::bent(&shape, &how));
    drop(how);
    called.out(found.map_err(Failure::from).map(Thing::from))
}

/// The bent point of `p`: from the centre `o`, the share `s` of the way at which the bend curve is, and the cross ratio; none at a
/// pole.
#[pyfunction]
#[pyo3(name = "bent_point")]
fn bent_point_of(o: Point, p: Point, s: Num, ratio: Num) -> Result<Option<Point>> {
    fn of<T: Field, const N: usize>(
        o: &Coords,
        p: &Coords,
        s: &Number,
        ratio: &Number,
    ) -> Result<Option<Point>> {
        let vector = |c: &Coords| point::<T, nalgebra::SVector<T, N>>(c);
        let bent = bent_point(&vector(o)?, &vector(p)?, &T::of(s)?, &T::of(ratio)?);
        Ok(bent.map(|p| Point(T::coords(p.iter().cloned().collect()))))
    }
    let exact = o.0.is_exact() && p.0.is_exact() && s.0.is_exact() && ratio.0.is_exact();
    match (o.0.len(), exact) {
        (2, true) => of::<symspline::Q, 2>(&o.0, &p.0, &s.0, &ratio.0),
        (2, false) => of::<f64, 2>(&o.0, &p.0, &s.0, &ratio.0),
        (3, true) => of::<symspline::Q, 3>(&o.0, &p.0, &s.0, &ratio.0),
        (3, false) => of::<f64, 3>(&o.0, &p.0, &s.0, &ratio.0),
        (n, _) => Err(symspline_dynamic::Error::Dimension { found: n, least: 2 }.into()),
    }
}

/// The share `t = r s / (1 + (r - 1) s)` of the way from the centre that a bent point is at, from the share `s` that the bend curve is
/// at and the cross ratio `r`; none at the pole and beyond it.
#[pyfunction]
#[pyo3(name = "bent_share")]
fn bent_share_of(s: Num, ratio: Num) -> Result<Option<Num>> {
    fn of<T: Field>(s: &Number, ratio: &Number) -> Result<Option<Num>> {
        Ok(bent_share(&T::of(s)?, &T::of(ratio)?).map(|t| Num(t.number())))
    }
    match s.0.is_exact() && ratio.0.is_exact() {
        true => of::<symspline::Q>(&s.0, &ratio.0),
        false => of::<f64>(&s.0, &ratio.0),
    }
}

/// The cross ratio `(AC / BC) / (AD / BD)` of four points `A`, `B`, `C`, `D` of a line, an array of shape `(4,)` or `(4, d)`, with signed
/// lengths. `C` and `D` may be `tolerance` away from the line through the others.
#[pyfunction]
#[pyo3(name = "cross_ratio", signature = (points, tolerance=Num::int(0)))]
fn cross_ratio_of(points: Array, tolerance: Num) -> Result<Num> {
    let dim = points.dim(1)?;
    if points.shape[0] != 4 {
        return Err(Failure::new("Shape", "a cross ratio is of four points"));
    }
    with_points!(&points.numbers, dim, T, p => {
        let [a, b, c, d] = &p[..] else {
            return Err(Failure::new("Shape", "a cross ratio is of four points"));
        };
        Ok(Num(cross_ratio([a, b, c, d], &T::of(&tolerance.0)?)?.number()))
    })
}

/// Points, of shape `(n, d)`, carried along by a rotation and a move: the direction from `before` to `pivot` becomes that from `after` to
/// `place`, and the pivot goes to the place.
#[pyfunction]
fn carried(points: Array, before: Point, pivot: Point, after: Point, place: Point) -> Result<Array> {
    let found = bend::carried(&points.numbers, [&before.0, &pivot.0, &after.0, &place.0])?;
    Ok(Array::new(points.shape, found))
}

/// Adds the functions and classes to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<OffsetAxis>()?;
    module.add_function(wrap_pyfunction!(bent, module)?)?;
    module.add_function(wrap_pyfunction!(bent_point_of, module)?)?;
    module.add_function(wrap_pyfunction!(bent_share_of, module)?)?;
    module.add_function(wrap_pyfunction!(cross_ratio_of, module)?)?;
    module.add_function(wrap_pyfunction!(carried, module)?)
}
