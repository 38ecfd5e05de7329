//! Subdivision surfaces and polygons.

use crate::error::{Failure, Result};
use crate::numbers::Array;
use crate::spline::Spline;
use crate::tools::mesh::Mesh;
use crate::tools::values::{Point, Points, Rounded as _, over, record, word};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use symspline::{Boundary, Descend, MeshSprings};
use symspline_dynamic::tools::subdivision::{self, AnyCatmullClark, AnyDooSabin, Polygon as Polygons};
use symspline_dynamic::{Coords, Over, both};

const BOUNDARIES: [(&str, Boundary); 3] =
    [("open", Boundary::Open), ("smooth", Boundary::Smooth), ("corners", Boundary::Corners)];

fn each(points: Vec<Option<Coords>>) -> Vec<Option<Point>> {
    points.into_iter().map(|p| p.map(Point)).collect()
}

/// A Catmull-Clark surface: a control mesh, the knot interval of each edge in the order of `mesh.edges` (all equal otherwise), and
/// what becomes of the boundary: "open", "smooth" or "corners".
#[pyclass(frozen, eq, module = "symspline", from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct CatmullClark(pub AnyCatmullClark);

#[pymethods]
impl CatmullClark {
    #[new]
    #[pyo3(signature = (mesh, intervals=None, *, boundary="smooth"))]
    fn new(mesh: Mesh, intervals: Option<Array>, boundary: &str) -> Result<Self> {
        let boundary = word("boundary", boundary, &BOUNDARIES)?;
        let intervals = intervals.map(|all| all.numbers);
        let mesh = match intervals.as_ref().is_none_or(Over::is_exact) {
            true => mesh.0,
            false => mesh.0.to_float()?,
        };
        Ok(Self(AnyCatmullClark::new(&mesh, intervals.as_ref(), boundary)?))
    }

    /// The control mesh.
    #[getter]
    fn mesh(&self) -> Mesh {
        Mesh(self.0.mesh())
    }

    /// The knot interval of each edge, none if all are equal.
    #[getter]
    fn intervals(&self) -> Option<Array> {
        self.0.intervals().map(|all| Array::new(vec![all.len()], all))
    }

    /// The same surface over the mesh after steps of subdivision.
    #[pyo3(signature = (depth=1))]
    fn refined(&self, py: Python<'_>, depth: usize) -> Result<Self> {
        Ok(Self(py.detach(|| self.0.refined(depth))?))
    }

    /// The points of the surface at the vertices, none at an open boundary.
    fn limit_points(&self, py: Python<'_>) -> Result<Vec<Option<Point>>> {
        Ok(each(py.detach(|| self.0.limit_points())?))
    }

    /// The unit normals at the vertices, of a surface over floats.
    fn limit_normals(&self, py: Python<'_>) -> Result<Vec<Option<Point>>> {
        Ok(each(py.detach(|| self.0.limit_normals())?))
    }

    /// The mesh with its vertices on the surface.
    fn limit_mesh(&self, py: Python<'_>) -> Result<Mesh> {
        Ok(Mesh(py.detach(|| self.0.limit_mesh())?))
    }
}

/// A Doo-Sabin surface: a control mesh, two knot intervals an edge (shape `(edges, 2)`; all equal otherwise), and what becomes of
/// the boundary: "open", "smooth" or "corners".
#[pyclass(frozen, eq, module = "symspline", from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct DooSabin(pub AnyDooSabin);

record! {
    /// A surface whose control mesh is a net of springs at rest.
    RelaxedMesh {
        /// The surface.
        surface: CatmullClark,
        /// The surface before: the one tuned with values of 1.
        invariant: CatmullClark,
        /// The energy where the springs were released.
        energy_before: f64,
        /// The energy.
        energy: f64,
        /// Its three sums: of lengths, of angles in loops, of angles between neighbours.
        terms: (f64, f64, f64),
        /// The steps it took.
        iterations: usize,
        /// What is left of the gradient.
        gradient: f64,
        /// Whether that is within the tolerance.
        converged: bool,
        /// The largest deviation of a length, relative.
        length_deviation: f64,
        /// The largest deviation of an angle in a loop, in radians.
        angle_deviation: f64,
    }
}

#[pymethods]
impl DooSabin {
    #[new]
    #[pyo3(signature = (mesh, intervals=None, *, boundary="smooth"))]
    fn new(mesh: Mesh, intervals: Option<Array>, boundary: &str) -> Result<Self> {
        let boundary = word("boundary", boundary, &BOUNDARIES)?;
        let intervals = intervals.map(|all| all.numbers);
        let mesh = match intervals.as_ref().is_none_or(Over::is_exact) {
            true => mesh.0,
            false => mesh.0.to_float()?,
        };
        Ok(Self(AnyDooSabin::new(&mesh, intervals.as_ref(), boundary)?))
    }

    /// The control mesh.
    #[getter]
    fn mesh(&self) -> Mesh {
        Mesh(self.0.mesh())
    }

    /// The knot intervals of each edge, of shape `(edges, 2)`, none if all are equal.
    #[getter]
    fn intervals(&self) -> Option<Array> {
        self.0.intervals().map(|all| Array::new(vec![all.len() / 2, 2], all))
    }

    /// The same surface over the mesh after steps of subdivision.
    #[pyo3(signature = (depth=1))]
    fn refined(&self, py: Python<'_>, depth: usize) -> Result<Self> {
        Ok(Self(py.detach(|| self.0.refined(depth))?))
    }

    /// The points of the surface that the faces shrink to, of shape `(faces, 3)`.
    fn limit_points(&self, py: Python<'_>) -> Result<Points> {
        Ok(Points { dim: 3, coords: py.detach(|| self.0.limit_points())? })
    }

    /// The unit normals there, of a surface over floats.
    fn limit_normals(&self, py: Python<'_>) -> Result<Vec<Option<Point>>> {
        Ok(each(py.detach(|| self.0.limit_normals())?))
    }

    /// The mesh of the limit points.
    fn limit_mesh(&self, py: Python<'_>) -> Result<Mesh> {
        Ok(Mesh(py.detach(|| self.0.limit_mesh())?))
    }

    /// The same surface, or nearly, as a Catmull-Clark surface with knot intervals 0 and 1.
    fn converted(&self, py: Python<'_>) -> Result<CatmullClark> {
        Ok(CatmullClark(py.detach(|| self.0.converted())?))
    }

    /// The surface with the steps along each edge multiplied by a value, as nearly as it holds together: springs come to rest.
    /// Keywords are `stretch`, `bend`, `shape`, `uniform`, `fixed`, `fixed_corners`, `moving`, `descend` ("conjugate_gradients",
    /// "gauss_newton"), `iterations`, `tolerance`. Exact meshes are rounded to floats.
    #[pyo3(signature = (alpha, **springs))]
    fn fine_tuned(
        &self,
        py: Python<'_>,
        alpha: Array,
        springs: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<RelaxedMesh> {
        let mut how = MeshSprings::default();
        for (key, value) in springs.into_iter().flatten() {
            match key.extract::<String>()?.as_str() {
                "stretch" => how.stretch = value.extract()?,
                "bend" => how.bend = value.extract()?,
                "shape" => how.shape = value.extract()?,
                "uniform" => how.uniform = value.extract()?,
                "fixed" => how.fixed = value.extract()?,
                "fixed_corners" => how.fixed_corners = value.extract()?,
                "moving" => how.moving = value.extract()?,
                "descend" => {
                    let all = [
                        ("conjugate_gradients", Descend::ConjugateGradients),
                        ("gauss_newton", Descend::GaussNewton),
                    ];
                    how.descend = word("descend", &value.extract::<String>()?, &all)?;
                }
                "iterations" => how.iterations = value.extract()?,
                "tolerance" => how.tolerance = value.extract()?,
                other => return Err(Failure::new("Word", format!("springs have no \"{other}\"")).into()),
            }
        }
        let surface = match &self.0 {
            Over::Float(_) => self.0.clone(),
            Over::Exact(s) => {
                let intervals =
                    self.0.intervals().map(|all| all.to_float()).transpose().map_err(Failure::from)?;
                let mesh = self.0.mesh().to_float().map_err(Failure::from)?;
                AnyDooSabin::new(&mesh, intervals.as_ref(), s.boundary()).map_err(Failure::from)?
            }
        };
        let Over::Float(alpha) = alpha.numbers.to_float().map_err(Failure::from)? else {
            return Err(Failure::new("Fields", "values of edges are floats").into());
        };
        let found = py.detach(|| surface.fine_tuned(&alpha, &how)).map_err(Failure::from)?;
        Ok(RelaxedMesh {
            surface: CatmullClark(Over::Float(found.surface)),
            invariant: CatmullClark(Over::Float(found.invariant)),
            energy_before: found.energy_before,
            energy: found.energy,
            terms: found.terms.into(),
            iterations: found.iterations,
            gradient: found.gradient,
            converged: found.converged,
            length_deviation: found.length_deviation,
            angle_deviation: found.angle_deviation,
        })
    }
}

/// A polygon that controls a curve of degree 2 (Chaikin's) or 3, with points of shape `(n, d)`: closed, or with a boundary that is
/// "open" or "smooth". Knot intervals are those of vertices if the degree is 2, of legs if it is 3; all equal otherwise.
#[pyclass(frozen, module = "symspline")]
#[derive(Debug)]
pub struct ControlPolygon(Box<dyn Polygons>);

#[pymethods]
impl ControlPolygon {
    #[new]
    #[pyo3(signature = (points, degree=2, *, intervals=None, boundary=None))]
    fn new(points: Array, degree: usize, intervals: Option<Array>, boundary: Option<&str>) -> Result<Self> {
        let dim = points.dim(1)?;
        let intervals = intervals.map(|all| all.numbers);
        let boundary = boundary.map(|name| word("boundary", name, &BOUNDARIES)).transpose()?;
        let coords = over(points.numbers, intervals.as_ref().is_none_or(|all| all.exact()))?;
        Ok(Self(subdivision::polygon(degree, dim, &coords, intervals.as_ref(), boundary)?))
    }

    /// The degree of the curve.
    #[getter]
    fn degree(&self) -> usize {
        self.0.degree()
    }

    /// The vertices, of shape `(n, d)`.
    #[getter]
    fn points(&self) -> Points {
        Points { dim: self.0.dim(), coords: self.0.points() }
    }

    /// The knot intervals.
    #[getter]
    fn intervals(&self) -> Point {
        Point(self.0.intervals())
    }

    /// Whether a leg joins the last vertex with the first.
    #[getter]
    fn is_closed(&self) -> bool {
        self.0.is_closed()
    }

    /// The polygon of the same curve after steps of subdivision: corners cut.
    #[pyo3(signature = (depth=1))]
    fn refined(&self, depth: usize) -> Result<Self> {
        Ok(Self(self.0.refined(depth)?))
    }

    /// The points where segments of the curve meet.
    fn joints(&self) -> Points {
        Points { dim: self.0.dim(), coords: self.0.joints() }
    }

    /// The polygon of degree 3 of the same curve.
    fn converted(&self) -> Result<Self> {
        Ok(Self(self.0.converted()?))
    }

    /// The curve.
    fn curve(&self) -> Result<Spline> {
        Ok(Spline(self.0.curve()?))
    }
}

/// The lengths of the loops of opposite edges of a mesh of quadrilaterals.
#[pyfunction]
fn loop_lengths(mesh: Mesh) -> Result<Vec<usize>> {
    both!(&mesh.0, m => {
        let loops = symspline::EdgeLoops::new(m.topology())?;
        Ok((0..loops.count()).map(|i| loops.edges(i).len()).collect())
    })
}

/// The mesh of an OBJ file's text.
#[pyfunction]
fn mesh_from_obj(py: Python<'_>, text: String) -> Result<Mesh> {
    Ok(Mesh(py.detach(|| symspline::io::obj::read(text.as_bytes()))?.into()))
}

/// A mesh as the text of an OBJ file; exact coordinates are rounded to floats.
#[pyfunction]
fn mesh_to_obj(py: Python<'_>, mesh: Mesh) -> Result<String> {
    let Over::Float(mesh) = mesh.0.to_float()? else {
        return Err(Failure::new("Fields", "OBJ files hold floats"));
    };
    let mut bytes = Vec::new();
    py.detach(|| symspline::io::obj::write(&mesh, &mut bytes))?;
    String::from_utf8(bytes).map_err(|error| Failure::new("Obj", error.to_string()))
}

/// Adds the functions and classes to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<CatmullClark>()?;
    module.add_class::<DooSabin>()?;
    module.add_class::<RelaxedMesh>()?;
    module.add_class::<ControlPolygon>()?;
    module.add_function(wrap_pyfunction!(loop_lengths, module)?)?;
    module.add_function(wrap_pyfunction!(mesh_from_obj, module)?)?;
    module.add_function(wrap_pyfunction!(mesh_to_obj, module)?)
}
