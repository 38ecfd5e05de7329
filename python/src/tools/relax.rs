//! Curves on their way to where their energy is least.

use crate::error::Result;
use crate::numbers::{Array, Num};
use crate::space::Space;
use crate::tools::breadth::Breadth;
use crate::tools::deform::Elastic;
use crate::tools::material::Material;
use crate::tools::shape::alike;
use crate::value::Thing;
use pyo3::prelude::*;
use symspline_dynamic::Meeting as _;
use symspline_dynamic::tools::relax::AnyRelaxation;

/// Steps in time of curves over a space that follow the forces of their energy through a viscous medium: with the stiffness matrix `K`
/// of the material and `K0` of the value alone, `(K0 + step K) (c' - c) = step (load - K c)` for the coefficients that may move by
/// `breadth`, as of `Elastic`.
///
/// Each step lowers the energy, however long it is. Numbers that come later are taken into the field of these.
#[pyclass(frozen, module = "symspline.deform")]
#[derive(Debug)]
pub struct Relaxation(AnyRelaxation);

#[pymethods]
impl Relaxation {
    #[new]
    fn new(py: Python<'_>, space: Space, material: Material, breadth: Breadth, step: Num) -> Result<Self> {
        let (breadth, sure) = breadth.parts();
        let space = space.0.among(sure && material.coords().is_exact() && step.0.is_exact())?;
        Ok(Self(py.detach(|| AnyRelaxation::new(&space, material.coords(), &breadth, &step.0))?))
    }

    /// The length of a step.
    #[getter]
    fn length(&self) -> Num {
        Num(self.0.length())
    }

    /// The body whose stiffness is that of one step; its `load` is the load of forces on a curve.
    #[getter]
    fn body(&self) -> Elastic {
        Elastic(self.0.body())
    }

    /// A curve after one step, under a load of each control point if there is one.
    #[pyo3(signature = (curve, load=None))]
    fn stepped(&self, py: Python<'_>, curve: Thing, load: Option<Array>) -> Result<Thing> {
        let curve = alike(curve.0, self.0.is_exact())?;
        if let Some(load) = &load {
            let (left, right) = (curve.dim(), load.dim(1)?);
            if left != right {
                return Err(symspline_dynamic::Error::Dimensions { left, right }.into());
            }
        }
        Ok(Thing(py.detach(|| self.0.stepped(&curve, load.as_ref().map(|load| &load.numbers)))?))
    }
}

/// Adds the class to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Relaxation>()
}
