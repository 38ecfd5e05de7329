//! Forces that act together.

use crate::error::{Failure, Result};
use crate::numbers::{Array, Num, Point};
use crate::value::Thing;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyString, PyTuple};
use symspline_dynamic::tools::area::{AnyArea, AnyCells};
use symspline_dynamic::tools::forces::{self, Along, Covering};
use symspline_dynamic::{Coords, Value};

/// An area: `(low, high)`, `("polygon", corners)`, a closed curve, or a list of these.
#[derive(Clone, Debug)]
struct Area(AnyArea);

/// An area that is no list.
fn single(object: &Bound<'_, PyAny>) -> PyResult<AnyArea> {
    let wrong = || {
        Failure::new(
            "Word",
            "an area is (low, high), (\"polygon\", corners), a closed curve or a list of these",
        )
    };
    let Ok(tuple) = object.cast::<PyTuple>() else {
        return match object.extract::<Thing>() {
            Ok(Thing(curve @ (Value::Spline(_) | Value::Rational(_)))) => Ok(AnyArea::Inside(curve)),
            _ => Err(wrong().into()),
        };
    };
    if tuple.len() != 2 {
        return Err(wrong().into());
    }
    let (first, second) = (tuple.get_item(0)?, tuple.get_item(1)?);
    let Ok(word) = first.cast::<PyString>() else {
        return Ok(AnyArea::Rectangle(first.extract::<Point>()?.0, second.extract::<Point>()?.0));
    };
    let corners: Array = second.extract()?;
    match (word.to_cow()?.as_ref(), &corners.shape[..]) {
        ("polygon", [_, 2]) => Ok(AnyArea::Polygon(corners.numbers)),
        ("polygon", _) => Err(Failure::new("Shape", "the corners of a polygon have the shape (n, 2)").into()),
        _ => Err(wrong().into()),
    }
}

impl<'py> FromPyObject<'_, 'py> for Area {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        match object.cast::<PyList>() {
            Ok(all) => Ok(Self(AnyArea::Odd(all.iter().map(|one| single(&one)).collect::<PyResult<_>>()?))),
            Err(_) => single(&object).map(Self),
        }
    }
}

impl<'py> IntoPyObject<'py> for Area {
    type Target = PyAny;
    type Output = Bound<'py, PyAny>;
    type Error = PyErr;

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        Ok(match self.0 {
            AnyArea::Rectangle(low, high) => (Point(low), Point(high)).into_pyobject(py)?.into_any(),
            AnyArea::Polygon(corners) => {
                ("polygon", Array::of_points(2, corners)).into_pyobject(py)?.into_any()
            }
            AnyArea::Inside(curve) => Thing(curve).into_pyobject(py)?,
            AnyArea::Odd(all) => {
                let all =
                    all.into_iter().map(|one| Self(one).into_pyobject(py)).collect::<PyResult<Vec<_>>>()?;
                PyList::new(py, all)?.into_any()
            }
        })
    }
}

/// Cells: so many along each direction, so many along `u` and `v`, or by their length.
#[derive(Clone, Debug)]
struct Cells(AnyCells);

impl<'py> FromPyObject<'_, 'py> for Cells {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(n) = object.extract::<usize>() {
            return Ok(Self(AnyCells::Counts(n, n)));
        }
        Ok(Self(match object.extract::<(usize, usize)>() {
            Ok((u, v)) => AnyCells::Counts(u, v),
            Err(_) => AnyCells::Spacing(object.extract::<Num>()?.0),
        }))
    }
}

impl<'py> IntoPyObject<'py> for Cells {
    type Target = PyAny;
    type Output = Bound<'py, PyAny>;
    type Error = PyErr;

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        match self.0 {
            AnyCells::Counts(u, v) => Ok((u, v).into_pyobject(py)?.into_any()),
            AnyCells::Spacing(length) => Num(length).into_pyobject(py),
        }
    }
}

/// Pairs of a place and a force.
type Single = Vec<(Point, Point)>;

/// A force along a path, at so many places.
type Sampled = (Thing, Thing, Option<usize>);

/// A force over an area, in cells.
type Covered = (Area, Thing, Cells);

fn covering(all: Vec<Covered>) -> Vec<Covering> {
    let one = |(area, force, cells): Covered| Covering { area: area.0, force: force.0, cells: cells.0 };
    all.into_iter().map(one).collect()
}

fn covered(all: &[Covering]) -> Vec<Covered> {
    let one = |one: &Covering| (Area(one.area.clone()), Thing(one.force.clone()), Cells(one.cells.clone()));
    all.iter().map(one).collect()
}

/// Forces that act together on a shape: `forces` are pairs of a place and a force; `at_breaks` are forces at all breaks, linear in
/// between; `density` is a shape over the same domain, a force per unit of the parameters.
///
/// On surfaces also, per unit of the parameter or of the parameter plane: `along`, tuples `(path, force, samples)` with a curve in the
/// plane and a force that is constant or a spline over its domain, taken at the middles of so many equal parts, or with `None`
/// integrated (over floats); and `over`, tuples `(area, force, cells)` with a force that is constant or a polynomial surface, taken in
/// the middles of the cells that lie in the area. `pressure` is as `over`, a number or a function of both parameters: a force along
/// the normals for each unit of area of a surface in space.
///
/// An area is `(low, high)`, the rectangle between two corners; `("polygon", corners)`; a closed curve (over floats); or a list of
/// these: what lies in an odd number of them. `cells` tells into how many the box around it is cut, an `int` for both directions or a
/// pair, or with any other number how long cells may be.
#[pyclass(frozen, eq, module = "symspline.deform", from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct Load {
    forces: forces::Load,
    /// Of the array of forces at breaks.
    shape: Vec<usize>,
}

#[pymethods]
impl Load {
    #[new]
    #[pyo3(signature = (forces=Vec::new(), *, at_breaks=None, density=None, along=Vec::new(), over=Vec::new(), pressure=Vec::new()))]
    fn new(
        forces: Single,
        at_breaks: Option<Array>,
        density: Option<Thing>,
        along: Vec<Sampled>,
        over: Vec<Covered>,
        pressure: Vec<Covered>,
    ) -> Self {
        let path = |(path, force, samples): Sampled| Along { path: path.0, force: force.0, samples };
        let shape = at_breaks.as_ref().map(|all| all.shape.clone()).unwrap_or_default();
        let forces = forces::Load {
            single: forces.into_iter().map(|(at, force)| (at.0, force.0)).collect(),
            at_breaks: at_breaks.map(|all| all.numbers),
            density: density.map(|d| d.0),
            along: along.into_iter().map(path).collect(),
            over: covering(over),
            pressure: covering(pressure),
        };
        Self { forces, shape }
    }

    /// Pairs of a place and a force.
    #[getter]
    fn forces(&self) -> Single {
        let pair = |(at, force): &(Coords, Coords)| (Point(at.clone()), Point(force.clone()));
        self.forces.single.iter().map(pair).collect()
    }

    /// Forces at all breaks.
    #[getter]
    fn at_breaks(&self) -> Option<Array> {
        let numbers = self.forces.at_breaks.as_ref()?;
        Some(Array::new(self.shape.clone(), numbers.clone()))
    }

    /// The force that varies over the shape.
    #[getter]
    fn density(&self) -> Option<Thing> {
        self.forces.density.clone().map(Thing)
    }

    /// Forces along curves: path, force, samples.
    #[getter]
    fn along(&self) -> Vec<Sampled> {
        let one = |one: &Along| (Thing(one.path.clone()), Thing(one.force.clone()), one.samples);
        self.forces.along.iter().map(one).collect()
    }

    /// Forces over areas: area, force, cells.
    #[getter]
    fn over(&self) -> Vec<Covered> {
        covered(&self.forces.over)
    }

    /// Pressures over areas: area, pressure, cells.
    #[getter]
    fn pressure(&self) -> Vec<Covered> {
        covered(&self.forces.pressure)
    }

    fn __repr__(&self) -> String {
        let forces = &self.forces;
        let counts = [
            (forces.single.len(), "single"),
            (usize::from(forces.at_breaks.is_some()), "at breaks"),
            (usize::from(forces.density.is_some()), "density"),
            (forces.along.len(), "along curves"),
            (forces.over.len(), "over areas"),
            (forces.pressure.len(), "pressure"),
        ];
        let some = counts.iter().filter(|(count, _)| *count > 0);
        let named: Vec<String> = some.map(|(count, name)| format!("{count} {name}")).collect();
        format!("<Load: {}>", if named.is_empty() { String::from("none") } else { named.join(", ") })
    }

    /// The arguments of the constructor, by place and by name: nothing is lost.
    fn __getnewargs_ex__<'py>(&self, py: Python<'py>) -> PyResult<((Single,), Bound<'py, PyDict>)> {
        let named = PyDict::new(py);
        named.set_item("at_breaks", self.at_breaks())?;
        named.set_item("density", self.density())?;
        named.set_item("along", self.along())?;
        named.set_item("over", self.over())?;
        named.set_item("pressure", self.pressure())?;
        Ok(((self.forces(),), named))
    }
}

/// Forces as methods take them: a `Load`, or pairs of a place and a force.
#[derive(Debug)]
pub struct Forces(Load);

impl Default for Forces {
    fn default() -> Self {
        Self(Load { forces: forces::Load::default(), shape: Vec::new() })
    }
}

impl<'py> FromPyObject<'_, 'py> for Forces {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(load) = object.cast::<Load>() {
            return Ok(Self(load.get().clone()));
        }
        let single: Single = object.extract()?;
        Ok(Self(Load::new(single, None, None, Vec::new(), Vec::new(), Vec::new())))
    }
}

impl Forces {
    /// All of them in the field of a body, with those of keywords.
    ///
    /// # Errors
    /// "Word" for two of one kind.
    pub fn on(self, exact: bool, at_breaks: Option<Array>, density: Option<Thing>) -> Result<forces::Load> {
        let mut load = self.0.forces;
        let twice = |name: &str| Failure::new("Word", format!("the load has a {name} already"));
        if let Some(all) = at_breaks
            && load.at_breaks.replace(all.numbers).is_some()
        {
            return Err(twice("force at breaks"));
        }
        if let Some(density) = density
            && load.density.replace(density.0).is_some()
        {
            return Err(twice("density"));
        }
        Ok(if exact { load.to_exact()? } else { load.to_float()? })
    }
}

/// Adds the class to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Load>()
}
