//! Curves and surfaces as elastic bodies.

use crate::arguments::word;
use crate::error::Result;
use crate::numbers::{Array, Num, Point};
use crate::tools::breadth::{Breadths, breadths};
use crate::tools::load::Forces;
use crate::tools::material::{Material, materials};
use crate::tools::shape::{Wish, alike, wishes};
use crate::tools::values::{Name, OneOrMore};
use crate::value::Thing;
use pyo3::prelude::*;
use symspline::Spread;
use symspline_dynamic::tools::elastic::{self, Anchors, AnyElastic, Pulls};
use symspline_dynamic::{Coords, Field, Meeting as _, both};

/// How forces are spread, by words.
pub const SPREADS: [(&str, Spread); 2] = [("hat", Spread::Hat), ("point", Spread::Point)];

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

    /// For each direction the integrals of the basis functions times the hat functions of the breaks: a row for each break.
    fn forcing(&self, py: Python<'_>) -> Result<Vec<Array>> {
        let dims: Vec<usize> = both!(&self.0, e => e.stiffnesses().iter().map(|s| s.space().dim()).collect());
        let all = py.detach(|| self.0.forcing())?;
        let shaped = |(all, n): (Coords, usize)| Array::new(vec![all.len() / n.max(1), n], all);
        Ok(all.into_iter().zip(dims).map(shaped).collect())
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

    /// The shape under further forces: pairs of a place and a force, or a `Load`; forces at all breaks, linear in between; a `density`
    /// that varies over a polynomial shape, a shape of its kind over its domain, per unit of the parameter.
    #[pyo3(signature = (shape, forces=Forces::default(), *, at_breaks=None, density=None))]
    fn pushed(
        &self,
        py: Python<'_>,
        shape: Thing,
        forces: Forces,
        at_breaks: Option<Array>,
        density: Option<Thing>,
    ) -> Result<Thing> {
        let exact = self.0.is_exact();
        let (shape, load) = (alike(shape.0, exact)?, forces.on(exact, at_breaks, density)?);
        Ok(Thing(py.detach(|| self.0.pushed(&shape, &load))?))
    }

    /// The control points that move under forces, as places in the list, and their displacements.
    #[pyo3(signature = (shape, forces=Forces::default(), *, at_breaks=None, density=None))]
    fn displacements(
        &self,
        py: Python<'_>,
        shape: Thing,
        forces: Forces,
        at_breaks: Option<Array>,
        density: Option<Thing>,
    ) -> Result<(Vec<usize>, Array)> {
        let exact = self.0.is_exact();
        let (shape, load) = (alike(shape.0, exact)?, forces.on(exact, at_breaks, density)?);
        let (places, coords) = py.detach(|| self.0.displacements(&shape, &load))?;
        Ok((places, Array::of_points(shape.dim(), coords)))
    }

    /// The load of each control point that forces are, as a list: the right-hand side of the system.
    #[pyo3(signature = (shape, forces=Forces::default(), *, at_breaks=None, density=None))]
    fn load(
        &self,
        py: Python<'_>,
        shape: Thing,
        forces: Forces,
        at_breaks: Option<Array>,
        density: Option<Thing>,
    ) -> Result<Array> {
        let exact = self.0.is_exact();
        let (shape, load) = (alike(shape.0, exact)?, forces.on(exact, at_breaks, density)?);
        Ok(Array::of_points(shape.dim(), py.detach(|| self.0.load(&shape, &load))?))
    }

    /// The displacements of the control points under a load of each, zero where they are held.
    fn solved(&self, py: Python<'_>, load: Array) -> Result<Array> {
        let dim = load.dim(1)?;
        let moved = py.detach(|| self.0.solved(&load.numbers, dim))?;
        Ok(Array::new(load.shape, moved))
    }

    /// Half of the gradient of the energy at a list of control points: the load that keeps them where they are.
    fn gradient(&self, py: Python<'_>, points: Array) -> Result<Array> {
        let dim = points.dim(1)?;
        let gradient = py.detach(|| self.0.gradient(&points.numbers, dim))?;
        Ok(Array::new(points.shape, gradient))
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
pub struct Pull(pub Box<dyn Pulls>, pub bool);

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

    /// The shape with constrained points on a curve, at parameters at equal distances from the start to the end of its domain (of a
    /// ring without the end): points of a surface that lie so on a path are moved onto a curve in space.
    fn met_curve(&self, py: Python<'_>, shape: Thing, target: Thing) -> Result<(Thing, Array)> {
        let (shape, target) = (alike(shape.0, self.1)?, alike(target.0, self.1)?);
        Ok(Self::out(py.detach(|| self.0.met_curve(&shape, &target))?))
    }

    /// The shape under further forces while the constrained values stay.
    #[pyo3(signature = (shape, forces=Forces::default(), *, at_breaks=None, density=None))]
    fn pushed(
        &self,
        py: Python<'_>,
        shape: Thing,
        forces: Forces,
        at_breaks: Option<Array>,
        density: Option<Thing>,
    ) -> Result<(Thing, Array)> {
        let (shape, load) = (alike(shape.0, self.1)?, forces.on(self.1, at_breaks, density)?);
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
    module.add_class::<Elastic>()?;
    module.add_class::<Pull>()?;
    module.add_class::<Anchored>()
}
