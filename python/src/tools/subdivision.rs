//! Subdivision surfaces and polygons.

use crate::arguments::word;
use crate::called::Called;
use crate::error::{Failure, Result};
use crate::mesh::Mesh;
use crate::numbers::{Array, Num, Point};
use crate::record::record;
use crate::spline::Spline;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::ops::ControlFlow;
use symspline::{Boundary, Descend, MeshSprings, Progress};
use symspline_dynamic::tools::subdivision::{self, AnyCatmullClark, AnyDooSabin, Polygon as Polygons};
use symspline_dynamic::{Coords, Meeting as _, Over, both};

const BOUNDARIES: [(&str, Boundary); 3] =
    [("open", Boundary::Open), ("smooth", Boundary::Smooth), ("corners", Boundary::Corners)];

fn each(points: Vec<Option<Coords>>) -> Vec<Option<Point>> {
    points.into_iter().map(|p| p.map(Point)).collect()
}

/// A Catmull-Clark surface: a control mesh, the knot interval of each edge in the order of `mesh.edges` (all equal otherwise), and
/// what becomes of the boundary: "open", "smooth" or "corners".
#[pyclass(frozen, eq, module = "symspline.mesh", from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct CatmullClark(pub AnyCatmullClark);

/// What both kinds of surfaces have: `$each` knot intervals an edge.
macro_rules! surface {
    ($class:ident, $any:ident, $each:literal) => {
        #[pymethods]
        impl $class {
            #[new]
            #[pyo3(signature = (mesh, intervals=None, boundary="smooth"))]
            fn new(mesh: Mesh, intervals: Option<Array>, boundary: &str) -> Result<Self> {
                let boundary = word("boundary", boundary, &BOUNDARIES)?;
                let intervals = intervals.map(|all| all.numbers);
                let mesh = mesh.0.among(intervals.as_ref().is_none_or(Over::is_exact))?;
                Ok(Self($any::new(&mesh, intervals.as_ref(), boundary)?))
            }

            /// The control mesh.
            #[getter]
            fn mesh(&self) -> Mesh {
                Mesh(self.0.mesh())
            }

            /// The knot intervals of the edges, none if all are equal.
            #[getter]
            fn intervals(&self) -> Option<Array> {
                self.0.intervals().map(|all| Array::of_points($each, all))
            }

            /// What becomes of the boundary: "open", "smooth" or "corners".
            #[getter]
            fn boundary(&self) -> &'static str {
                let boundary = both!(&self.0, s => s.boundary());
                BOUNDARIES.iter().find(|(_, one)| *one == boundary).map_or("", |(name, _)| name)
            }

            /// The same surface over the mesh after steps of subdivision.
            #[pyo3(signature = (depth=1))]
            fn refined(&self, py: Python<'_>, depth: usize) -> Result<Self> {
                Ok(Self(py.detach(|| self.0.refined(depth))?))
            }

            /// The unit normals at the limit points, of a surface over floats; none where there is no point.
            fn limit_normals(&self, py: Python<'_>) -> Result<Vec<Option<Point>>> {
                Ok(each(py.detach(|| self.0.limit_normals())?))
            }

            /// The mesh of the limit points.
            fn limit_mesh(&self, py: Python<'_>) -> Result<Mesh> {
                Ok(Mesh(py.detach(|| self.0.limit_mesh())?))
            }

            fn __repr__(&self) -> String {
                let mesh = symspline_dynamic::Value::from(self.0.mesh());
                format!("<{}: {mesh}, boundary {}>", stringify!($class), self.boundary())
            }

            /// The constructor and its arguments: nothing is lost.
            #[allow(clippy::type_complexity, reason = "it is the tuple that pickle asks for")]
            fn __reduce__<'py>(
                slf: &Bound<'py, Self>,
            ) -> (Bound<'py, PyAny>, (Mesh, Option<Array>, &'static str)) {
                let this = slf.get();
                (slf.get_type().into_any(), (this.mesh(), this.intervals(), this.boundary()))
            }
        }
    };
}

surface!(CatmullClark, AnyCatmullClark, 1);
surface!(DooSabin, AnyDooSabin, 2);

#[pymethods]
impl CatmullClark {
    /// The surface with all knot intervals at least as long as `least`, to look at: intervals of 0, as converted surfaces have, hide
    /// faces. One with equal intervals stays as it is.
    fn with_least_interval(&self, least: Num) -> Result<Self> {
        Ok(Self(self.0.with_least_interval(&least.0)?))
    }

    /// The points of the surface at the vertices, none at an open boundary.
    fn limit_points(&self, py: Python<'_>) -> Result<Vec<Option<Point>>> {
        Ok(each(py.detach(|| self.0.limit_points())?))
    }
}

/// A Doo-Sabin surface: a control mesh, two knot intervals an edge (shape `(edges, 2)`; all equal otherwise), and what becomes of
/// the boundary: "open", "smooth" or "corners".
#[pyclass(frozen, eq, module = "symspline.mesh", from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct DooSabin(pub AnyDooSabin);

record! {
    "symspline.mesh"
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
    /// The points of the surface that the faces shrink to, of shape `(faces, 3)`.
    fn limit_points(&self, py: Python<'_>) -> Result<Array> {
        Ok(Array::of_points(3, py.detach(|| self.0.limit_points())?))
    }

    /// The same surface, or nearly, as a Catmull-Clark surface with knot intervals 0 and 1.
    fn converted(&self, py: Python<'_>) -> Result<CatmullClark> {
        Ok(CatmullClark(py.detach(|| self.0.converted())?))
    }

    /// The surface with the steps along each edge multiplied by a value, as nearly as it holds together: springs come to rest.
    /// Keywords are `stretch`, `bend`, `shape`, `uniform`, `fixed`, `fixed_corners`, `moving`, `descend` ("conjugate_gradients",
    /// "gauss_newton"), `iterations`, `tolerance`. Exact meshes are rounded to floats. Before each step `watch(iteration, energy, gradient)`
    /// is called, if it is given: a true result stops the springs there, and an exception comes out as it is.
    #[pyo3(signature = (alpha, *, watch=None, **springs))]
    fn fine_tuned(
        &self,
        py: Python<'_>,
        alpha: Array,
        watch: Option<Py<PyAny>>,
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
        let called = Called::default();
        let told = |progress: &Progress| {
            let Some(watch) = &watch else { return ControlFlow::Continue(()) };
            let stops = called.call(|py| {
                watch.call1(py, (progress.iteration, progress.energy, progress.gradient))?.is_truthy(py)
            });
            // An exception stops it, too.
            if stops.unwrap_or(true) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let found = py.detach(|| surface.fine_tuned_watched(&alpha, &how, told));
        let found = called.out(found.map_err(Failure::from))?;
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
#[pyclass(frozen, module = "symspline.mesh")]
#[derive(Debug)]
pub struct ControlPolygon {
    polygon: Box<dyn Polygons>,
    boundary: Option<String>,
}

#[pymethods]
impl ControlPolygon {
    #[new]
    #[pyo3(signature = (points, degree=2, intervals=None, boundary=None))]
    fn new(points: Array, degree: usize, intervals: Option<Array>, boundary: Option<String>) -> Result<Self> {
        let dim = points.dim(1)?;
        let intervals = intervals.map(|all| all.numbers);
        let of = boundary.as_deref().map(|name| word("boundary", name, &BOUNDARIES)).transpose()?;
        let coords = points.numbers.among(intervals.as_ref().is_none_or(|all| all.is_exact()))?;
        let polygon = subdivision::polygon(degree, dim, &coords, intervals.as_ref(), of)?;
        Ok(Self { polygon, boundary })
    }

    /// The degree of the curve.
    #[getter]
    fn degree(&self) -> usize {
        self.polygon.degree()
    }

    /// The vertices, of shape `(n, d)`.
    #[getter]
    fn points(&self) -> Array {
        Array::of_points(self.polygon.dim(), self.polygon.points())
    }

    /// The knot intervals.
    #[getter]
    fn intervals(&self) -> Point {
        Point(self.polygon.intervals())
    }

    /// Whether a leg joins the last vertex with the first.
    #[getter]
    fn is_closed(&self) -> bool {
        self.polygon.is_closed()
    }

    /// The polygon of the same curve after steps of subdivision: corners cut.
    #[pyo3(signature = (depth=1))]
    fn refined(&self, depth: usize) -> Result<Self> {
        Ok(Self { polygon: self.polygon.refined(depth)?, boundary: self.boundary.clone() })
    }

    /// The points where segments of the curve meet.
    fn joints(&self) -> Array {
        Array::of_points(self.polygon.dim(), self.polygon.joints())
    }

    /// The polygon of degree 3 of the same curve.
    fn converted(&self) -> Result<Self> {
        Ok(Self { polygon: self.polygon.converted()?, boundary: self.boundary.clone() })
    }

    /// The curve.
    fn curve(&self) -> Result<Spline> {
        Ok(Spline(self.polygon.curve()?))
    }

    /// The constructor and its arguments: nothing is lost.
    #[allow(clippy::type_complexity, reason = "it is the tuple that pickle asks for")]
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> (Bound<'py, PyAny>, (Array, usize, Point, Option<String>)) {
        let this = slf.get();
        let arguments = (this.points(), this.degree(), this.intervals(), this.boundary.clone());
        (slf.get_type().into_any(), arguments)
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
