//! Curves and surfaces as elastic bodies.

use crate::arguments::word;
use crate::error::{Failure, Result};
use crate::numbers::{Array, Num, Point, unite};
use crate::space::Space;
use crate::tools::shape::{Wish, alike, wishes};
use crate::tools::values::{Name, OneOrMore};
use crate::value::Thing;
use pyo3::prelude::*;
use pyo3::types::{PyString, PyTuple};
use symspline::Spread;
use symspline_dynamic::tools::elastic::{self, Anchors, AnyBreadth, AnyElastic, Load, Pulls};
use symspline_dynamic::{Coords, Meeting as _, Over, Value};

/// Which coefficients may move: "whole", "all" (but the ends), ("ends", n), ("range", a, b), ("around", x, n), ("within", a, b), a
/// list of indices; of a sculptor also ("nearest", n) and ("distance", d).
#[derive(Debug)]
pub struct Breadth(AnyBreadth, bool);

impl<'py> FromPyObject<'_, 'py> for Breadth {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let wrong = || Failure::new("Word", format!("{} tells of no breadth", &*object));
        if let Ok(word) = object.cast::<PyString>() {
            return match word.to_string().as_str() {
                "whole" => Ok(Self(AnyBreadth::Whole, true)),
                "all" => Ok(Self(AnyBreadth::All, true)),
                _ => Err(wrong().into()),
            };
        }
        let tuple = match object.cast::<PyTuple>() {
            Ok(tuple) => tuple,
            Err(_) => return Ok(Self(AnyBreadth::Listed(object.extract()?), true)),
        };
        let items: Vec<Bound<'_, PyAny>> = tuple.iter().collect();
        let Some((Ok(word), items)) = items.split_first().map(|(w, rest)| (w.extract::<String>(), rest))
        else {
            return Ok(Self(AnyBreadth::Listed(object.extract()?), true));
        };
        let number = |x: &Bound<'_, PyAny>| x.extract::<Num>().map(|x| x.0);
        Ok(match (word.as_str(), items) {
            ("ends", [n]) => Self(AnyBreadth::BetweenEnds(n.extract()?), true),
            ("range", [a, b]) => Self(AnyBreadth::Range(a.extract()?, b.extract()?), true),
            ("nearest", [n]) => Self(AnyBreadth::Nearest(n.extract()?), true),
            ("around", [x, n]) => {
                let x = number(x)?;
                let exact = x.is_exact();
                Self(AnyBreadth::Around(x, n.extract()?), exact)
            }
            ("within", [a, b]) => {
                let (a, b) = (number(a)?, number(b)?);
                let exact = a.is_exact() && b.is_exact();
                Self(AnyBreadth::Within(a, b), exact)
            }
            ("distance", [d]) => {
                let d = number(d)?;
                let exact = d.is_exact();
                Self(AnyBreadth::Distance(d), exact)
            }
            _ => return Err(wrong().into()),
        })
    }
}

/// Breadths, and whether their numbers are exact.
pub fn breadths(all: Vec<Breadth>) -> (Vec<AnyBreadth>, bool) {
    let exact = all.iter().all(|b| b.1);
    (all.into_iter().map(|b| b.0).collect(), exact)
}

/// A reach as it is given: one breadth for a curve, a list of two for a surface.
#[derive(Debug)]
pub struct Breadths(pub Vec<Breadth>);

impl<'py> FromPyObject<'_, 'py> for Breadths {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        match object.extract::<Breadth>() {
            Ok(one) => Ok(Self(vec![one])),
            Err(_) => object.extract::<Vec<Breadth>>().map(Self),
        }
    }
}

/// How forces are spread, by words.
pub const SPREADS: [(&str, Spread); 2] = [("hat", Spread::Hat), ("point", Spread::Point)];

/// An elastic material: what the derivatives of a deformation cost, `Material(stretching, bending, hardness=0)`.
#[pyclass(frozen, eq, module = "symspline.deform", from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct Material(Coords);

#[pymethods]
impl Material {
    #[new]
    #[pyo3(signature = (stretching, bending, hardness=Num::int(0)))]
    fn new(stretching: Num, bending: Num, hardness: Num) -> Result<Self> {
        Self::checked(unite(vec![hardness.0, stretching.0, bending.0]))
    }

    /// The material with weights for the derivatives of order 0, 1, 2 and so on.
    #[staticmethod]
    fn of_orders(weights: Point) -> Result<Self> {
        Self::checked(weights.0)
    }

    /// The weights of the derivatives of order 0, 1, 2 and so on.
    #[getter]
    fn weights(&self) -> Array {
        Array::new(vec![self.0.len()], self.0.clone())
    }

    /// What the shape costs, a function, curve or surface: a sum of squares.
    fn energy(&self, py: Python<'_>, shape: Thing) -> Result<Num> {
        let shape = shape.0.among(self.0.is_exact())?;
        Ok(Num(py.detach(|| elastic::energy(&shape, std::slice::from_ref(&self.0)))?))
    }

    /// The stiffness matrix on the coefficients of a space.
    fn matrix(&self, py: Python<'_>, space: Space) -> Result<Array> {
        let space = space.0.among(self.0.is_exact())?;
        let dim = symspline_dynamic::both!(&*space, s => s.dim());
        Ok(Array::new(vec![dim, dim], py.detach(|| elastic::stiffness(&space, &self.0))?))
    }

    fn __repr__(&self) -> String {
        format!("<Material: weights {}>", Value::from(self.0.clone()))
    }

    /// What makes it again, and with what.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, (Array,))> {
        Ok((slf.get_type().getattr("of_orders")?, (slf.get().weights(),)))
    }
}

impl Material {
    fn checked(weights: Coords) -> Result<Self> {
        match &weights {
            Over::Float(_) => elastic::material::<f64>(&weights).map(drop)?,
            Over::Exact(_) => elastic::material::<symspline::Q>(&weights).map(drop)?,
        }
        Ok(Self(weights))
    }
}

/// Materials, and whether their numbers are exact.
pub fn materials(all: OneOrMore<Material>) -> (Vec<Coords>, bool) {
    let all: Vec<Coords> = all.list().into_iter().map(|m| m.0).collect();
    let exact = all.iter().all(Over::is_exact);
    (all, exact)
}

/// Forces: pairs of a place and a force, forces at all breaks, and one that varies.
pub fn load(forces: Vec<(Point, Point)>, at_breaks: Option<Array>, density: Option<Thing>) -> Load {
    Load {
        single: forces.into_iter().map(|(at, force)| (at.0, force.0)).collect(),
        at_breaks: at_breaks.map(|all| all.numbers),
        density: density.map(|d| d.0),
    }
}

/// A curve or surface as an elastic body of a material (of surfaces one, or one for each direction). `breadth` says which control
/// points may move, one for each direction: "whole", "all" (but the ends), ("ends", n), ("range", a, b), ("around", x, n), ("within",
/// a, b), or indices. Forces are spread by "hat" functions of the breaks or by the basis functions at the "point". Numbers that come
/// later are taken into the field of the body.
#[pyclass(frozen, module = "symspline.deform")]
#[derive(Debug)]
pub struct Elastic(pub AnyElastic);

#[pymethods]
impl Elastic {
    #[new]
    #[pyo3(signature = (shape, material, breadth, *, spread="hat"))]
    fn new(
        py: Python<'_>,
        shape: Thing,
        material: OneOrMore<Material>,
        breadth: Breadths,
        spread: &str,
    ) -> Result<Self> {
        let (spread, (materials, exact), (all, sure)) =
            (word("spread", spread, &SPREADS)?, materials(material), breadths(breadth.0));
        let shape = shape.0.among(exact && sure)?;
        Ok(Self(py.detach(|| AnyElastic::of_shape(&shape, &materials, &all, spread))?))
    }

    /// The coefficients that may move, along each direction.
    #[getter]
    fn moving(&self) -> Vec<Vec<usize>> {
        self.0.moving()
    }

    /// For each direction how its coefficients answer a unit force that hats spread at a place.
    fn responses(&self, at: Point) -> Result<Vec<Point>> {
        Ok(self.0.responses(&at.0)?.into_iter().map(Point).collect())
    }

    /// A force on the shape at a place, prepared.
    fn pull(&self, shape: Thing, at: Point) -> Result<Pull> {
        let shape = alike(shape.0, self.0.is_exact())?;
        Ok(Pull(self.0.pull_at(&shape, &at.0)?, self.0.is_exact()))
    }

    /// The shape under further forces: pairs of a place and a force; forces at all breaks, linear in between; a `density` that varies over
    /// a polynomial shape, a shape of its kind and field over its domain, per unit of the parameter.
    #[pyo3(signature = (shape, forces=Vec::new(), *, at_breaks=None, density=None))]
    fn pushed(
        &self,
        py: Python<'_>,
        shape: Thing,
        forces: Vec<(Point, Point)>,
        at_breaks: Option<Array>,
        density: Option<Thing>,
    ) -> Result<Thing> {
        let (shape, load) = (alike(shape.0, self.0.is_exact())?, load(forces, at_breaks, density));
        Ok(Thing(py.detach(|| self.0.pushed(&shape, &load))?))
    }

    /// The control points that move under forces, as places in the list, and their displacements.
    #[pyo3(signature = (shape, forces=Vec::new(), *, at_breaks=None, density=None))]
    fn displacements(
        &self,
        py: Python<'_>,
        shape: Thing,
        forces: Vec<(Point, Point)>,
        at_breaks: Option<Array>,
        density: Option<Thing>,
    ) -> Result<(Vec<usize>, Array)> {
        let (shape, load) = (alike(shape.0, self.0.is_exact())?, load(forces, at_breaks, density));
        let (places, coords) = py.detach(|| self.0.displacements(&shape, &load))?;
        Ok((places, Array::of_points(shape.dim(), coords)))
    }

    /// Constraints to be met with the least energy, as those of `Constraints`.
    #[pyo3(signature = (shape, constraints, *, holding=None))]
    fn anchored(
        &self,
        py: Python<'_>,
        shape: Thing,
        constraints: Vec<Wish>,
        holding: Option<Vec<Name>>,
    ) -> Result<Anchored> {
        let (wishes, _) = wishes(constraints, holding, None, None, false);
        let shape = alike(shape.0, self.0.is_exact())?;
        Ok(Anchored(py.detach(|| self.0.anchored_by(&shape, &wishes))?, self.0.is_exact()))
    }
}

/// A force at one place of a shape, ready to be changed.
#[pyclass(frozen, module = "symspline.deform")]
#[derive(Debug)]
pub struct Pull(Box<dyn Pulls>, bool);

#[pymethods]
impl Pull {
    /// How far the point moves under a unit force.
    #[getter]
    fn give(&self) -> Num {
        Num(self.0.give())
    }

    /// The control points that move, and how far each does under a unit force.
    #[getter]
    fn response(&self) -> (Vec<usize>, Array) {
        use symspline_dynamic::{Field, both};
        both!(&self.0.response(), d => {
            let all: Vec<_> = d.rows().flatten().cloned().collect();
            (d.indices().to_vec(), Array::new(vec![all.len()], Field::coords(all)))
        })
    }

    /// The force that moves the point by a vector.
    fn force_for(&self, change: Point) -> Result<Point> {
        Ok(Point(self.0.force_for(&change.0)?))
    }

    /// The shape under a further force.
    fn pushed(&self, shape: Thing, force: Point) -> Result<Thing> {
        Ok(self.0.pushed(&alike(shape.0, self.1)?, &force.0)?.into())
    }

    /// The shape with the point at a target, and the force that this took.
    fn moved_to(&self, shape: Thing, target: Point) -> Result<(Thing, Point)> {
        let (shape, force) = self.0.moved_to(&alike(shape.0, self.1)?, &target.0)?;
        Ok((shape.into(), Point(force)))
    }
}

/// Constraints on an elastic shape, ready to be changed. All methods give the shape and the forces, a row for each constraint.
#[pyclass(frozen, module = "symspline.deform")]
#[derive(Debug)]
pub struct Anchored(Box<dyn Anchors>, bool);

impl Anchored {
    fn out((shape, coords): elastic::Moved) -> (Thing, Array) {
        let dim = shape.dim();
        (shape.into(), Array::of_points(dim, coords))
    }
}

#[pymethods]
impl Anchored {
    /// The shape with the constrained values changed.
    fn dragged(&self, py: Python<'_>, shape: Thing, changes: Array) -> Result<(Thing, Array)> {
        let shape = alike(shape.0, self.1)?;
        Ok(Self::out(py.detach(|| self.0.dragged(&shape, &changes.numbers))?))
    }

    /// The shape with these constrained values.
    fn met(&self, py: Python<'_>, shape: Thing, targets: Array) -> Result<(Thing, Array)> {
        let shape = alike(shape.0, self.1)?;
        Ok(Self::out(py.detach(|| self.0.met(&shape, &targets.numbers))?))
    }

    /// The shape under further forces while the constrained values stay.
    #[pyo3(signature = (shape, forces=Vec::new(), *, at_breaks=None, density=None))]
    fn pushed(
        &self,
        py: Python<'_>,
        shape: Thing,
        forces: Vec<(Point, Point)>,
        at_breaks: Option<Array>,
        density: Option<Thing>,
    ) -> Result<(Thing, Array)> {
        let (shape, load) = (alike(shape.0, self.1)?, load(forces, at_breaks, density));
        Ok(Self::out(py.detach(|| self.0.pushed(&shape, &load))?))
    }

    /// The shape without any other forces.
    fn relaxed(&self, py: Python<'_>, shape: Thing) -> Result<(Thing, Array)> {
        let shape = alike(shape.0, self.1)?;
        Ok(Self::out(py.detach(|| self.0.relaxed(&shape))?))
    }
}

/// Adds the classes to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Material>()?;
    module.add_class::<Elastic>()?;
    module.add_class::<Pull>()?;
    module.add_class::<Anchored>()
}
