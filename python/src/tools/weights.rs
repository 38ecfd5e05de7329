//! Weights moved.

use crate::error::Result;
use crate::numbers::{Num, Point};
use crate::tools::shape::alike;
use crate::tools::values::Name;
use crate::value::Thing;
use pyo3::prelude::*;
use symspline_dynamic::tools::weight_pairs::{self, PairPuller};
use symspline_dynamic::tools::weights::{self, Puller};
use symspline_dynamic::{Meeting as _, Number};

/// Ends of a range of weights.
type Ends = Option<(Num, Num)>;

fn ends(within: Ends) -> (Option<(Number, Number)>, bool) {
    let exact = within.as_ref().is_none_or(|(a, b)| a.0.is_exact() && b.0.is_exact());
    (within.map(|(a, b)| (a.0, b.0)), exact)
}

/// The pull of a point of a rational shape toward a control point by its weight, prepared. `within` is a range of weights. Numbers
/// are taken into the field of the shape.
#[pyclass(frozen, module = "symspline.shape")]
#[derive(Debug)]
pub struct WeightPull(Box<dyn Puller>, bool);

#[pymethods]
impl WeightPull {
    #[new]
    #[pyo3(signature = (shape, at, index, *, within=None))]
    fn new(shape: Thing, at: Point, index: Name, within: Ends) -> Result<Self> {
        let (within, exact) = ends(within);
        let shape = shape.0.among(exact && at.0.is_exact())?;
        Ok(Self(weights::pull(&shape, &at.0, &index.0, within.as_ref())?, shape.is_exact()))
    }

    /// The pull toward a control point that the shape does not have yet, because its weight is zero: `point` becomes it.
    #[staticmethod]
    #[pyo3(signature = (shape, at, index, point, *, within=None))]
    fn from_zero(shape: Thing, at: Point, index: Name, point: Point, within: Ends) -> Result<Self> {
        let (within, exact) = ends(within);
        let shape = shape.0.among(exact && at.0.is_exact() && point.0.is_exact())?;
        let found = weights::pull_from_zero(&shape, &at.0, &index.0, &point.0, within.as_ref())?;
        Ok(Self(found, shape.is_exact()))
    }

    /// The weight as it was.
    #[getter]
    fn weight(&self) -> Num {
        Num(self.0.weight_and_share().0)
    }

    /// The share of the control point in the point, as it was.
    #[getter]
    fn share(&self) -> Num {
        Num(self.0.weight_and_share().1)
    }

    /// The point as it was.
    #[getter]
    fn point(&self) -> Point {
        Point(self.0.points().0)
    }

    /// The control point.
    #[getter]
    fn control_point(&self) -> Point {
        Point(self.0.points().1)
    }

    /// The least and the largest fraction of the way to the control point.
    #[getter]
    fn limits(&self) -> (Option<Num>, Option<Num>) {
        let (push, pull) = self.0.limits();
        (push.map(Num), pull.map(Num))
    }

    /// The weight that takes the point a fraction of the way.
    fn weight_for(&self, fraction: Num) -> Result<Num> {
        Ok(Num(self.0.weight_for(&fraction.0)?))
    }

    /// The fraction of the way that a weight takes the point.
    fn fraction_for(&self, weight: Num) -> Result<Num> {
        Ok(Num(self.0.fraction_for(&weight.0)?))
    }

    /// The fraction at which the point is nearest to a target.
    fn fraction_near(&self, target: Point) -> Result<Num> {
        Ok(Num(self.0.fraction_near(&target.0)?))
    }

    /// The point after a move by a fraction of the way.
    fn point_at(&self, fraction: Num) -> Result<Point> {
        Ok(Point(self.0.point_at(&fraction.0)?))
    }

    /// The point when the weight becomes another, which may be zero.
    fn point_at_weight(&self, weight: Num) -> Result<Point> {
        Ok(Point(self.0.point_at_weight(&weight.0)?))
    }

    /// The distance from the point to the control point, over floats.
    #[getter]
    fn distance(&self) -> Result<Num> {
        Ok(Num(self.0.distance()?))
    }

    /// The fraction of the way that a distance is, over floats: pulls are positive, pushes negative.
    fn fraction_of(&self, distance: Num) -> Result<Num> {
        Ok(Num(self.0.fraction_of(&distance.0)?))
    }

    /// The weight that moves the point by a distance toward the control point, over floats.
    fn weight_for_distance(&self, distance: Num) -> Result<Num> {
        Ok(Num(self.0.weight_for_distance(&distance.0)?))
    }

    /// The shape with its point a fraction of the way from where it was.
    fn applied(&self, shape: Thing, fraction: Num) -> Result<Thing> {
        Ok(self.0.applied(&alike(shape.0, self.1)?, &fraction.0)?.into())
    }
}

/// The moves of a point of a rational shape by the weights of two control points, prepared.
#[pyclass(frozen, module = "symspline.shape")]
#[derive(Debug)]
pub struct WeightPairPull(Box<dyn PairPuller>, bool);

#[pymethods]
impl WeightPairPull {
    #[new]
    #[pyo3(signature = (shape, at, first, second, *, within=None))]
    fn new(shape: Thing, at: Point, first: Name, second: Name, within: Ends) -> Result<Self> {
        let (within, exact) = ends(within);
        let shape = shape.0.among(exact && at.0.is_exact())?;
        let found = weight_pairs::pull(&shape, &at.0, [&first.0, &second.0], within.as_ref())?;
        Ok(Self(found, shape.is_exact()))
    }

    /// The moves by the weights at the ends of leg `k` of the control polygon of a curve, from control point `k` to the next; in a ring
    /// `k` is an unrolled index.
    #[staticmethod]
    #[pyo3(signature = (curve, x, k, *, within=None))]
    fn on_leg(curve: Thing, x: Num, k: usize, within: Ends) -> Result<Self> {
        let (within, exact) = ends(within);
        let curve = curve.0.among(exact && x.0.is_exact())?;
        Ok(Self(weight_pairs::pull_on_leg(&curve, &x.0, k, within.as_ref())?, curve.is_exact()))
    }

    /// The weights as they were.
    #[getter]
    fn weights(&self) -> (Num, Num) {
        let [[a, b], _] = self.0.weights_and_shares();
        (Num(a), Num(b))
    }

    /// The shares of the control points in the point, as they were.
    #[getter]
    fn shares(&self) -> (Num, Num) {
        let [_, [a, b]] = self.0.weights_and_shares();
        (Num(a), Num(b))
    }

    /// The point where both weights are zero.
    #[getter]
    fn base(&self) -> Point {
        let [_, base, _] = self.0.points();
        Point(base)
    }

    /// The point as it was.
    #[getter]
    fn point(&self) -> Point {
        let [point, ..] = self.0.points();
        Point(point)
    }

    /// The point of the leg where the line from the base through the point ends.
    #[getter]
    fn goal(&self) -> Point {
        let [.., goal] = self.0.points();
        Point(goal)
    }

    /// The least and the largest fraction of the way to the leg.
    #[getter]
    fn limits(&self) -> (Num, Num) {
        let (push, pull) = self.0.limits();
        (Num(push), Num(pull))
    }

    /// The weights that move the point a fraction of the way to the leg, along the line from the base; their ratio stays.
    fn weights_along(&self, fraction: Num) -> Result<(Num, Num)> {
        let [a, b] = self.0.weights_along(&fraction.0)?;
        Ok((Num(a), Num(b)))
    }

    /// The distance from the point to the leg along the line from the base, over floats.
    #[getter]
    fn distance(&self) -> Result<Num> {
        Ok(Num(self.0.distance()?))
    }

    /// The fraction of the way to the leg that a distance is, over floats: pulls are positive, pushes negative.
    fn fraction_of(&self, distance: Num) -> Result<Num> {
        Ok(Num(self.0.fraction_of(&distance.0)?))
    }

    /// The barycentric coordinates of a target at the two control points.
    #[pyo3(signature = (target, tolerance=Num::int(0)))]
    fn coordinates(&self, target: Point, tolerance: Num) -> Result<(Num, Num)> {
        let [a, b] = self.0.coordinates(&target.0, &tolerance.0)?;
        Ok((Num(a), Num(b)))
    }

    /// The weights that move the point to a target inside the triangle of the base and the control points.
    #[pyo3(signature = (target, tolerance=Num::int(0)))]
    fn weights_for(&self, target: Point, tolerance: Num) -> Result<(Num, Num)> {
        let [a, b] = self.0.weights_for(&target.0, &tolerance.0)?;
        Ok((Num(a), Num(b)))
    }

    /// The shape with its point at a target.
    #[pyo3(signature = (shape, target, tolerance=Num::int(0)))]
    fn moved_to(&self, shape: Thing, target: Point, tolerance: Num) -> Result<Thing> {
        Ok(self.0.moved_to(&alike(shape.0, self.1)?, &target.0, &tolerance.0)?.into())
    }

    /// The shape with its point a fraction of the way to the leg, along the line from the base.
    fn moved_along(&self, shape: Thing, fraction: Num) -> Result<Thing> {
        Ok(self.0.moved_along(&alike(shape.0, self.1)?, &fraction.0)?.into())
    }
}

/// The derivatives of the point at `at` by the weight of a control point, of order 0 to `order`: one row each.
#[pyfunction]
fn weight_derivatives(shape: Thing, at: Point, index: Name, order: usize) -> Result<Vec<Point>> {
    let shape = shape.0.among(at.0.is_exact())?;
    Ok(weights::derivatives(&shape, &at.0, &index.0, order)?.into_iter().map(Point).collect())
}

/// The rational shape with other weights, pairs of an index and a weight; control points stay.
#[pyfunction]
fn with_weights(shape: Thing, weights: Vec<(Name, Num)>) -> Result<Thing> {
    let shape = shape.0.among(weights.iter().all(|(_, w)| w.0.is_exact()))?;
    let weights: Vec<_> = weights.into_iter().map(|(name, w)| (name.0, w.0)).collect();
    Ok(weights::set(&shape, &weights)?.into())
}

/// Adds the functions and classes to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<WeightPull>()?;
    module.add_class::<WeightPairPull>()?;
    module.add_function(wrap_pyfunction!(weight_derivatives, module)?)?;
    module.add_function(wrap_pyfunction!(with_weights, module)?)
}
