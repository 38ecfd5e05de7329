//! Control points moved: drags, constraints, handles of curvature.

use crate::arguments::{Along, word};
use crate::error::{Failure, Result};
use crate::numbers::{Array, Num, Point};
use crate::spline::Spline;
use crate::tools::values::Name;
use crate::value::Thing;
use pyo3::prelude::*;
use std::collections::HashMap;
use symspline::{Direction, Relief};
use symspline_dynamic::tools::constraints::{self, Asked, Prepared, Rows, Wishes};
use symspline_dynamic::tools::edit::{self, AnyDrag, Grip};
use symspline_dynamic::tools::handle::{self, AnyHandle};
use symspline_dynamic::{Coords, Field, Meeting as _, Number, both};

/// A linear edit of control points, prepared: how they move when a point is dragged.
///
/// `Drag(shape, at, by="nearest")` takes the point at `at` (a parameter, of surfaces a pair) along by the control point with the
/// nearest node, by the "neighbours" around it (with `gamma` the share of the second, of surfaces a pair), by `index` alone, or by
/// `shares`, a list of pairs of an index and its share of the vector. Indices of surfaces are pairs.
#[pyclass(frozen, eq, module = "symspline.shape")]
#[derive(Debug, PartialEq)]
pub struct Drag(AnyDrag);

#[pymethods]
impl Drag {
    #[new]
    #[pyo3(signature = (shape, at, by="nearest", *, index=None, shares=None, gamma=None))]
    fn new(
        shape: Thing,
        at: Point,
        by: &str,
        index: Option<Name>,
        shares: Option<Vec<(Name, Num)>>,
        gamma: Option<Point>,
    ) -> Result<Self> {
        let mut exact = at.0.is_exact();
        let grip = match (index, shares, by) {
            (Some(Name(index)), None, _) => Grip::One(index),
            (None, Some(shares), _) => {
                exact &= shares.iter().all(|(_, x)| x.0.is_exact());
                Grip::Shares(shares.into_iter().map(|(Name(index), x)| (index, x.0)).collect())
            }
            (None, None, "nearest") => Grip::Nearest,
            (None, None, "neighbours") => {
                exact &= gamma.as_ref().is_none_or(|g| g.0.is_exact());
                Grip::Neighbours(gamma.map(|g| g.0))
            }
            _ => {
                return Err(Failure::new(
                    "Word",
                    "a point is dragged by \"nearest\", \"neighbours\", an index or shares",
                ));
            }
        };
        Ok(Self(AnyDrag::of_point(&*shape.0.among(exact)?, &at.0, &grip)?))
    }

    /// The places in the list of control points of those that move.
    #[getter]
    fn indices(&self) -> Vec<usize> {
        both!(&self.0, d => d.indices().to_vec())
    }

    /// The matrix: a row for each of `indices`, a column for each vector of an edit.
    #[getter]
    fn matrix(&self) -> Array {
        both!(&self.0, d => {
            let coords = d.rows().flatten().cloned().collect();
            Array::new(vec![d.indices().len(), d.columns()], Field::coords(coords))
        })
    }

    /// The shape after an edit by one vector, or by one vector for each column. Numbers are taken into the field of the drag.
    fn applied(&self, py: Python<'_>, shape: Thing, by: Array) -> Result<Thing> {
        let shape = alike(shape.0, self.0.is_exact())?;
        Ok(Thing(py.detach(|| self.0.applied(&shape, &by.numbers))?))
    }
}

/// A shape in the field of a prepared tool.
pub fn alike(shape: symspline_dynamic::Value, exact: bool) -> Result<symspline_dynamic::Value> {
    Ok(if exact { shape.to_exact()? } else { shape.to_float()? })
}

/// The shape with knots so that `x` is the node of a control point without influence outside the interval, and the place of that
/// control point along the direction.
#[pyfunction]
#[pyo3(signature = (shape, x, start, end, direction=Along(Direction::U)))]
fn confined(
    py: Python<'_>,
    shape: Thing,
    x: Num,
    start: Num,
    end: Num,
    direction: Along,
) -> Result<(Thing, usize)> {
    let shape = shape.0.among(x.0.is_exact() && start.0.is_exact() && end.0.is_exact())?;
    let (finer, k) = py.detach(|| edit::confined_to(&shape, direction.0, &x.0, (&start.0, &end.0)))?;
    Ok((finer.into(), k))
}

/// The point `target` of the leg from control point `index` to the next made a control point: the knot to insert, the shape with it,
/// and the place of the new control point along the direction.
#[pyfunction]
#[pyo3(signature = (shape, index, target, tolerance, direction=Along(Direction::U)))]
fn leg_point(
    shape: Thing,
    index: Name,
    target: Point,
    tolerance: Num,
    direction: Along,
) -> Result<(Num, Thing, usize)> {
    let shape = shape.0.among(target.0.is_exact() && tolerance.0.is_exact())?;
    let (knot, finer, place) = edit::leg_point(&shape, direction.0, &index.0, &target.0, &tolerance.0)?;
    Ok((Num(knot), finer.into(), place))
}

/// Constraints as they come from Python, and whether all their numbers are exact.
#[derive(FromPyObject)]
pub enum Wish {
    /// A point, or a derivative: the place and the order.
    Derivative(Point, Name),
    /// A linear functional: control points and their weights.
    Row(HashMap<usize, Num>),
    /// An isocurve of a surface: the word, the direction, the parameter.
    Isocurve(Said<0>, Along, Num),
    /// Points along a curve in the parameters of a surface: the word, the curve, how many.
    Along(Said<1>, Spline, usize),
}

/// One of the words of constraints.
const WORDS: [&str; 2] = ["isocurve", "along"];

/// The word with this place in the list.
pub struct Said<const K: usize>;

impl<'py, const K: usize> FromPyObject<'_, 'py> for Said<K> {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        word("constraint", &object.extract::<String>()?, &[(WORDS[K], ())])?;
        Ok(Self)
    }
}

/// Constraints with further wishes.
pub fn wishes(
    constraints: Vec<Wish>,
    holding: Option<Vec<Name>>,
    freeing: Option<Vec<Name>>,
    weights: Option<Vec<(Name, Num)>>,
    nearly: bool,
) -> (Wishes, bool) {
    let mut exact = true;
    let asked = constraints.into_iter().map(|wish| match wish {
        Wish::Derivative(at, Name(order)) => {
            exact &= at.0.is_exact();
            Asked::Derivative(at.0, order)
        }
        Wish::Row(row) => {
            exact &= row.values().all(|x| x.0.is_exact());
            let mut row: Vec<(usize, Number)> = row.into_iter().map(|(i, x)| (i, x.0)).collect();
            row.sort_by_key(|(i, _)| *i);
            Asked::Row(row)
        }
        Wish::Isocurve(_, direction, x) => {
            exact &= x.0.is_exact();
            Asked::Isocurve(direction.0, x.0)
        }
        Wish::Along(_, path, count) => {
            exact &= path.0.is_exact();
            Asked::Along(path.0, count)
        }
    });
    let asked = asked.collect();
    let names = |all: Vec<Name>| all.into_iter().map(|name| name.0).collect::<Vec<_>>();
    let weights: Vec<(Vec<usize>, Number)> =
        weights.unwrap_or_default().into_iter().map(|(name, x)| (name.0, x.0)).collect();
    exact &= weights.iter().all(|(_, x)| x.is_exact());
    let (holding, freeing) = (names(holding.unwrap_or_default()), freeing.map(names));
    (Wishes { asked, holding, freeing, weights, nearly }, exact)
}

/// Rows of weights as an array, a column for each control point.
pub fn matrix(rows: &Rows, count: usize, exact: bool) -> Result<Array> {
    fn fill<T: Field>(rows: &Rows, count: usize) -> Result<Coords> {
        let mut all = vec![T::zero(); rows.len() * count];
        for (r, row) in rows.iter().enumerate() {
            for (i, x) in row {
                all[r * count + i] = T::of(x)?;
            }
        }
        Ok(T::coords(all))
    }
    let coords = if exact { fill::<symspline::Q>(rows, count)? } else { fill::<f64>(rows, count)? };
    Ok(Array::new(vec![rows.len(), count], coords))
}

/// Constraints on a shape with their matrix, prepared once and then dragged: control points move as little as possible.
///
/// Each constraint is a pair of a place and an order of derivatives (0 the point; of surfaces both are pairs), or a dict from places
/// in the list of control points to weights: a linear functional. Of surfaces it may be `("isocurve", direction, x)`, as many constraints
/// as that isocurve has control points, or `("along", path, count)`, points along a curve in the parameter plane. `holding` are control points that stay, `freeing` the only ones
/// that may move, `weights` pairs of a control point and how much its movement counts, `nearly` meets what cannot be met together by
/// least squares. With `relief`, "knots" or "degree", the shape first gets more freedom where it needs it: see `shape`.
#[pyclass(frozen, module = "symspline.shape")]
#[derive(Debug)]
pub struct Constraints {
    held: Box<dyn Prepared>,
    shape: symspline_dynamic::Value,
}

#[pymethods]
impl Constraints {
    #[new]
    #[pyo3(signature = (shape, constraints, *, holding=None, freeing=None, weights=None, nearly=false, relief=None))]
    #[allow(clippy::too_many_arguments, reason = "Python names them")]
    fn new(
        py: Python<'_>,
        shape: Thing,
        constraints: Vec<Wish>,
        holding: Option<Vec<Name>>,
        freeing: Option<Vec<Name>>,
        weights: Option<Vec<(Name, Num)>>,
        nearly: bool,
        relief: Option<&str>,
    ) -> Result<Self> {
        let (wishes, exact) = wishes(constraints, holding, freeing, weights, nearly);
        let shape = shape.0.among(exact)?.into_owned();
        let relief = relief
            .map(|name| word("relief", name, &[("knots", Relief::Knots), ("degree", Relief::Degree)]))
            .transpose()?;
        py.detach(|| match relief {
            None => Ok(Self { held: constraints::constrained(&shape, &wishes)?, shape }),
            Some(relief) => {
                let (shape, held) = constraints::relieved(&shape, &wishes, relief)?;
                Ok(Self { held, shape })
            }
        })
    }

    /// The shape the constraints are prepared for; with `relief` it has more freedom than the one that was given.
    #[getter]
    fn shape(&self) -> Thing {
        self.shape.clone().into()
    }

    /// The rows of the constraints, a column for each control point.
    #[getter]
    fn rows(&self) -> Result<Array> {
        let coords = edit::control_points(&self.shape)?;
        matrix(&self.held.rows(), coords.len() / self.shape.dim(), self.shape.is_exact())
    }

    /// How control points move when a constrained value changes.
    #[getter]
    fn matrix(&self) -> Drag {
        Drag(self.held.matrix())
    }

    /// The shape with the constrained values changed by vectors, one each. Numbers are taken into the field of the constraints.
    fn dragged(&self, py: Python<'_>, shape: Thing, changes: Array) -> Result<Thing> {
        let shape = alike(shape.0, self.shape.is_exact())?;
        Ok(Thing(py.detach(|| self.held.dragged(&shape, &changes.numbers))?))
    }

    /// The shape with these constrained values.
    fn met(&self, py: Python<'_>, shape: Thing, targets: Array) -> Result<Thing> {
        let shape = alike(shape.0, self.shape.is_exact())?;
        Ok(Thing(py.detach(|| self.held.met(&shape, &targets.numbers))?))
    }
}

/// Point and first derivative of a curve held at `x`, ready to change the curvature there.
#[pyclass(frozen, module = "symspline.shape")]
#[derive(Debug)]
pub struct CurvatureHandle(AnyHandle);

#[pymethods]
impl CurvatureHandle {
    #[new]
    #[pyo3(signature = (curve, x, *, holding=None, weights=None))]
    fn new(
        curve: Thing,
        x: Num,
        holding: Option<Vec<Name>>,
        weights: Option<Vec<(Name, Num)>>,
    ) -> Result<Self> {
        let (wishes, exact) = wishes(Vec::new(), holding, None, weights, false);
        Ok(Self(AnyHandle::of_curve(&*curve.0.among(exact && x.0.is_exact())?, &x.0, &wishes)?))
    }

    /// The curve with a vector added to the second derivative.
    fn pushed(&self, curve: Thing, by: Point) -> Result<Thing> {
        Ok(self.0.pushed(&alike(curve.0, self.0.is_exact())?, &by.0)?.into())
    }

    /// The curve with a multiple of the first derivative added to the second: its curvature stays.
    fn slid(&self, curve: Thing, amount: Num) -> Result<Thing> {
        Ok(self.0.slid(&alike(curve.0, self.0.is_exact())?, &amount.0)?.into())
    }

    /// The curve with its curvature multiplied.
    fn scaled(&self, curve: Thing, factor: Num) -> Result<Thing> {
        Ok(self.0.scaled(&alike(curve.0, self.0.is_exact())?, &factor.0)?.into())
    }

    /// The curve with the curvature `kappa`, over floats.
    fn set(&self, curve: Thing, kappa: f64) -> Result<Thing> {
        Ok(self.0.set(&alike(curve.0, self.0.is_exact())?, kappa)?.into())
    }
}

/// The curve whose tangent at `x` has a direction, through the same point, with the least movement of control points.
#[pyfunction]
fn with_tangent(curve: Thing, x: Num, direction: Point) -> Result<Thing> {
    let curve = curve.0.among(x.0.is_exact() && direction.0.is_exact())?;
    Ok(handle::tangent_turned(&curve, &x.0, &direction.0)?.into())
}

/// All control points of a shape in one list, of a surface row by row: places in this list name them in `Drag.indices` and rows.
#[pyfunction]
fn control_points(shape: Thing) -> Result<Array> {
    Ok(Array::of_points(shape.0.dim(), edit::control_points(&shape.0)?))
}

/// The derivative of a shape at a place: `order` is a number, of surfaces a pair.
#[pyfunction]
fn derivative_at(shape: Thing, at: Point, order: Name) -> Result<Point> {
    let shape = shape.0.among(at.0.is_exact())?;
    Ok(Point(edit::derivative_of(&shape, &at.0, &order.0)?))
}

/// Adds the functions and classes to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Drag>()?;
    module.add_class::<Constraints>()?;
    module.add_class::<CurvatureHandle>()?;
    module.add_function(wrap_pyfunction!(confined, module)?)?;
    module.add_function(wrap_pyfunction!(leg_point, module)?)?;
    module.add_function(wrap_pyfunction!(with_tangent, module)?)?;
    module.add_function(wrap_pyfunction!(control_points, module)?)?;
    module.add_function(wrap_pyfunction!(derivative_at, module)?)
}
