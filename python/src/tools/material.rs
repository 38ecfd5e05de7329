//! What elastic bodies are made of.

use crate::error::Result;
use crate::numbers::{Array, Num, Point, unite};
use crate::space::Space;
use crate::tools::breadth::Breadth;
use crate::tools::values::OneOrMore;
use crate::value::Thing;
use pyo3::prelude::*;
use symspline_dynamic::tools::{elastic, stiffness};
use symspline_dynamic::{Coords, Meeting as _, Over, Value};

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
        Ok(Array::new(vec![dim, dim], py.detach(|| stiffness::matrix(&space, &self.0))?))
    }

    /// The stiffness matrix over floats by Gauss rules: of so many nodes for all orders of derivatives, or of the least number
    /// that suffices for each.
    #[pyo3(signature = (space, nodes=None))]
    fn matrix_by_quadrature(&self, py: Python<'_>, space: Space, nodes: Option<usize>) -> Result<Array> {
        let space = space.0.to_float()?;
        let dim = symspline_dynamic::both!(&space, s => s.dim());
        let matrix = py.detach(|| stiffness::matrix_by_rule(&space, &self.0, nodes))?;
        Ok(Array::new(vec![dim, dim], matrix))
    }

    /// A basis of the motions of the coefficients of a space that cost nothing, a row each; `breadth` says which may move, as for
    /// `Elastic`.
    #[pyo3(signature = (space, breadth=Breadth::whole()))]
    fn null_space(&self, py: Python<'_>, space: Space, breadth: Breadth) -> Result<Array> {
        let (breadth, sure) = breadth.parts();
        let space = space.0.among(sure && self.0.is_exact())?;
        let dim = symspline_dynamic::both!(&*space, s => s.dim());
        let motions = py.detach(|| stiffness::null_space(&space, &self.0, &breadth))?;
        Ok(Array::new(vec![motions.len() / dim.max(1), dim], motions))
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
    /// The weights of the derivatives.
    pub fn coords(&self) -> &Coords {
        &self.0
    }

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

/// Adds the class to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Material>()
}
