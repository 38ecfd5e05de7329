//! The energy of a surface with a weight for each derivative.

use crate::error::Result;
use crate::numbers::{Array, Num, Point};
use crate::space::Space;
use crate::tools::breadth::{Breadths, breadths};
use crate::tools::material::Material;
use crate::tools::shape::matrix;
use crate::value::Thing;
use pyo3::prelude::*;
use symspline::limits::MAX_ENTRIES;
use symspline_dynamic::tools::full_energy::AnyFullEnergy;
use symspline_dynamic::{Coords, Meeting as _, Over, both, together};

/// The energy of a surface with a weight for each derivative: `sum c[k][l] * integral |d^(k+l) S / du^k dv^l|^2 du dv`.
///
/// `FullEnergy(weights)` has in row `k` the weights of the derivatives of order `k` along `u`. Over fractions if all weights are.
#[pyclass(frozen, eq, module = "symspline.deform", from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct FullEnergy(AnyFullEnergy);

/// Weights in rows, over one field.
fn over_one(rows: Vec<Point>) -> Result<Vec<Coords>> {
    let exact = rows.iter().all(|row| row.0.is_exact());
    rows.into_iter().map(|row| Ok(row.0.among(exact)?.into_owned())).collect()
}

#[pymethods]
impl FullEnergy {
    #[new]
    fn new(weights: Vec<Point>) -> Result<Self> {
        Ok(Self(AnyFullEnergy::new(&over_one(weights)?)?))
    }

    /// The energy with the weights of `S_u`, `S_v`, `S_uu`, `S_uv`, `S_vv`, `S_uuv`, `S_uvv`, `S_uuvv`.
    #[staticmethod]
    fn of_eight(weights: Array) -> Result<Self> {
        Ok(Self(AnyFullEnergy::of_eight(&weights.list()?)?))
    }

    /// A membrane and a thin plate: `a (|S_u|^2 + |S_v|^2) + b (|S_uu|^2 + 2 |S_uv|^2 + |S_vv|^2)` under the integral.
    #[staticmethod]
    fn thin_plate(stretching: Num, bending: Num) -> Result<Self> {
        let (a, b) = (&stretching.0, &bending.0);
        together!(a, b);
        Ok(Self(AnyFullEnergy::thin_plate(&a, &b)?))
    }

    /// The energy of an elastic surface: each weight is the product of one along `u` and one along `v`.
    #[staticmethod]
    fn of_materials(u: Material, v: Material) -> Result<Self> {
        let (u, v) = (u.coords(), v.coords());
        together!(u, v);
        Ok(Self(AnyFullEnergy::of_materials(&u, &v)?))
    }

    /// The weights, a row for each order along `u`, down to the last row and column that are not all zero.
    #[getter]
    fn weights(&self) -> Array {
        let (rows, columns) = self.0.orders();
        Array::new(vec![rows, columns], self.0.weights().clone())
    }

    /// The weight of the derivative of order `k` along `u` and `l` along `v`.
    fn weight(&self, k: usize, l: usize) -> Result<Num> {
        Ok(Num(self.0.weight(k, l)?))
    }

    /// The same energy with another weight of the derivative of the orders `(k, l)`.
    fn with_weight(&self, order: (usize, usize), weight: Num) -> Result<Self> {
        let exact = self.0.weights().is_exact() && weight.0.is_exact();
        let weight = if exact { weight.0 } else { weight.0.to_float()? };
        Ok(Self(self.0.with_weight(order, &weight)?))
    }

    /// What a surface costs: a sum of squares.
    fn energy(&self, py: Python<'_>, surface: Thing) -> Result<Num> {
        let surface = surface.0.among(self.0.weights().is_exact())?;
        Ok(Num(py.detach(|| self.0.energy(&surface))?))
    }

    /// The load that keeps a surface as it is, half of the gradient of the energy: a vector for each control point, as a list.
    fn gradient(&self, py: Python<'_>, surface: Thing) -> Result<Array> {
        let surface = surface.0.among(self.0.weights().is_exact())?;
        Ok(Array::of_points(surface.dim(), py.detach(|| self.0.gradient(&surface))?))
    }

    /// The stiffness matrix on the list of coefficients of surfaces over two spaces.
    fn matrix(&self, py: Python<'_>, u: Space, v: Space) -> Result<Array> {
        let exact = self.0.weights().is_exact() && u.0.is_exact() && v.0.is_exact();
        let (u, v) = (u.0.among(exact)?, v.0.among(exact)?);
        let dim = both!(&*u, s => s.dim()).saturating_mul(both!(&*v, s => s.dim()));
        let count = dim.saturating_mul(dim);
        if count > MAX_ENTRIES {
            return Err(symspline::Error::TooLarge { count, limit: MAX_ENTRIES }.into());
        }
        py.detach(|| matrix(&self.0.matrix(&u, &v)?, dim, exact))
    }

    /// The displacements of the control points of surfaces over the spaces `(u, v)` under a load of each, as a list such as
    /// `Elastic.load` has. `breadth` says for each direction which may move, as for `Elastic`.
    fn solved(
        &self,
        py: Python<'_>,
        spaces: (Space, Space),
        load: Array,
        breadth: Breadths,
    ) -> Result<Array> {
        let dim = load.dim(1)?;
        let (breadths, sure) = breadths(breadth.0);
        let (u, v) = (spaces.0.0, spaces.1.0);
        let numbers = [self.0.weights(), &load.numbers].iter().all(|all| all.is_exact());
        let exact = sure && numbers && u.is_exact() && v.is_exact();
        let (u, v) = (u.among(exact)?, v.among(exact)?);
        let moved = py.detach(|| self.0.solved((&u, &v), (&load.numbers, dim), &breadths))?;
        Ok(Array::new(load.shape, moved))
    }

    fn __repr__(&self) -> String {
        let (rows, columns) = self.0.orders();
        let field = if matches!(self.0.weights(), Over::Exact(_)) { "exact" } else { "float" };
        format!("<FullEnergy: {field}, weights of {rows} orders along u and {columns} along v>")
    }

    /// The constructor and the weights.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> (Bound<'py, PyAny>, (Array,)) {
        (slf.get_type().into_any(), (slf.get().weights(),))
    }
}

/// Adds the class to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<FullEnergy>()
}
