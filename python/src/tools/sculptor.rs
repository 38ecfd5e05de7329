//! Shapes in the hands of a sculptor.

use crate::arguments::word;
use crate::error::Result;
use crate::numbers::{Array, Point};
use crate::tools::breadth::{Breadths, breadths};
use crate::tools::deform::{Elastic, Pull, SPREADS};
use crate::tools::load::Forces;
use crate::tools::material::{Material, materials};
use crate::tools::values::{Name, OneOrMore};
use crate::value::Thing;
use pyo3::prelude::*;
use std::sync::{Mutex, PoisonError};
use symspline_dynamic::Meeting as _;
use symspline_dynamic::tools::sculpt::{self, Sculpts};

/// A shape in the hands of a sculptor: grab, drag, commit, undo. `reach` says how far grips reach, as the breadths of `Elastic`, or
/// ("nearest", n), ("distance", d).
#[pyclass(frozen, module = "symspline.deform")]
#[derive(Debug)]
pub struct Sculptor(Mutex<Box<dyn Sculpts>>);

impl Sculptor {
    fn with<R>(&self, act: impl FnOnce(&mut Box<dyn Sculpts>) -> R) -> R {
        // An error leaves a sculptor as it was, so one that panicked elsewhere can still be used.
        act(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

#[pymethods]
impl Sculptor {
    #[new]
    #[pyo3(signature = (shape, material, *, reach=None, spread="hat", limit=None))]
    fn new(
        shape: Thing,
        material: OneOrMore<Material>,
        reach: Option<Breadths>,
        spread: &str,
        limit: Option<usize>,
    ) -> Result<Self> {
        let (spread, (materials, exact)) = (word("spread", spread, &SPREADS)?, materials(material));
        let (reach, sure) = reach.map_or((None, true), |r| {
            let (all, sure) = breadths(r.0);
            (Some(all), sure)
        });
        let shape = shape.0.among(exact && sure)?;
        Ok(Self(Mutex::new(sculpt::sculptor(&shape, &materials, reach.as_deref(), spread, limit)?)))
    }

    /// The shape as it is shown.
    #[getter]
    fn shape(&self) -> Thing {
        self.with(|s| s.shape()).into()
    }

    /// Holds the shape at a place.
    #[pyo3(signature = (at, reach=None))]
    fn grab(&self, py: Python<'_>, at: Point, reach: Option<Breadths>) -> Result<()> {
        let reach = reach.map(|r| breadths(r.0).0);
        Ok(py.detach(|| self.with(|s| s.grab(&at.0, reach.as_deref())))?)
    }

    /// Shows the shape with the place that is held at a target: the force that this takes.
    fn drag_to(&self, py: Python<'_>, target: Point) -> Result<Point> {
        Ok(Point(py.detach(|| self.with(|s| s.drag_to(&target.0)))?))
    }

    /// Shows the shape under a force at the place that is held.
    fn push(&self, force: Point) -> Result<()> {
        Ok(self.with(|s| s.push(&force.0))?)
    }

    /// Adds forces on a body, as those of `Elastic.pushed`.
    #[pyo3(signature = (body, forces=Forces::default(), *, at_breaks=None, density=None))]
    fn push_all(
        &self,
        py: Python<'_>,
        body: &Elastic,
        forces: Forces,
        at_breaks: Option<Array>,
        density: Option<Thing>,
    ) -> Result<()> {
        let load = forces.on(body.0.is_exact(), at_breaks, density)?;
        Ok(py.detach(|| self.with(|s| s.push_all(&body.0, &load)))?)
    }

    /// The body that a grip at a place would have.
    fn elastic(&self, py: Python<'_>, at: Point) -> Result<Elastic> {
        Ok(Elastic(py.detach(|| self.with(|s| s.elastic(&at.0)))?))
    }

    /// The force at the place that is held, prepared; none if nothing is held.
    #[getter]
    fn pull(&self) -> Option<Pull> {
        self.with(|s| Some(Pull(s.pull()?, s.shape().is_exact())))
    }

    /// Where the place that is held was when it was grabbed; none if nothing is held.
    #[getter]
    fn start(&self) -> Option<Point> {
        self.with(|s| s.held()).map(|(start, _)| Point(start))
    }

    /// The force under which the shape is shown; none if nothing is held.
    #[getter]
    fn force(&self) -> Option<Point> {
        self.with(|s| s.held()).map(|(_, force)| Point(force))
    }

    /// Lets go and keeps what is shown; whether there was anything.
    fn commit(&self) -> bool {
        self.with(|s| s.commit())
    }

    /// Lets go, and the shape is as it was.
    fn cancel(&self) -> bool {
        self.with(|s| s.cancel())
    }

    /// Takes back the last edit.
    fn undo(&self) -> bool {
        self.with(|s| s.undo())
    }

    /// Does the last edit again that was undone.
    fn redo(&self) -> bool {
        self.with(|s| s.redo())
    }

    /// How many edits can be undone, and how many done again.
    #[getter]
    fn edits(&self) -> (usize, usize) {
        self.with(|s| s.edits())
    }

    /// How many control points along each direction a grip here would move.
    fn resolution(&self, at: Point) -> Result<Vec<usize>> {
        Ok(self.with(|s| s.resolution(&at.0))?)
    }

    /// Inserts knots until along each direction so many control points have no influence farther away: how many it took.
    fn refine(&self, at: Point, distances: Point, counts: Name) -> Result<usize> {
        Ok(self.with(|s| s.refine(&at.0, &distances.0, &counts.0))?)
    }

    /// Moves control points, as places in the list, each by a vector.
    fn move_points(&self, indices: Vec<usize>, by: Array) -> Result<()> {
        Ok(self.with(|s| s.move_points(&indices, &by.numbers))?)
    }

    /// Takes other materials, another reach or another spread from the next grip on.
    #[pyo3(name = "set", signature = (*, material=None, reach=None, spread=None))]
    fn change(
        &self,
        material: Option<OneOrMore<Material>>,
        reach: Option<Breadths>,
        spread: Option<&str>,
    ) -> Result<()> {
        let material = material.map(|m| materials(m).0);
        let reach = reach.map(|r| breadths(r.0).0);
        let spread = spread.map(|name| word("spread", name, &SPREADS)).transpose()?;
        Ok(self.with(|s| s.set(material.as_deref(), reach.as_deref(), spread))?)
    }
}

/// Adds the class to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Sculptor>()
}
