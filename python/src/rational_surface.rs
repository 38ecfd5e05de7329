//! Rational functions of two parameters and surfaces.

use crate::arguments::forced;
use crate::error::Result;
use crate::numbers::{Array, Num};
use crate::rational::Controls;
use crate::space::Space;
use crate::surface::{Surface, check_rows};
use pyo3::prelude::*;
use symspline::Direction::{U, V};
use symspline_dynamic::{AnyRationalSurface, AnySpace, Field, each, together};

/// A rational spline of two parameters (NURBS): a function of them, or a surface in two or three dimensions.
///
/// `RationalSurface(u, v, points, weights)` takes control points of shape `(u.dim, v.dim)` or `(u.dim, v.dim, d)` and weights of shape
/// `(u.dim, v.dim)`; `RationalSurface(u, v, homogeneous=...)` takes homogeneous coordinates of shape `(u.dim, v.dim, d + 1)`. It is
/// exact if all are; `exact=True` takes floats exactly, `exact=False` rounds.
#[pyclass(frozen, eq, module = "symspline", from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct RationalSurface(pub AnyRationalSurface);

#[pymethods]
impl RationalSurface {
    #[new]
    #[pyo3(signature = (u, v, points=None, weights=None, homogeneous=None, *, exact=None))]
    fn new(
        u: &Space,
        v: &Space,
        points: Option<Array>,
        weights: Option<Array>,
        homogeneous: Option<Array>,
        exact: Option<bool>,
    ) -> Result<Self> {
        let check = |shape: &[usize]| check_rows(shape, &u.0, &v.0);
        let controls = Controls::new(2, points, weights, homogeneous, exact, check)?;
        let [u, v] = [u, v].map(|s| forced(s.0.clone(), exact, AnySpace::to_exact));
        let (u, v) = (&u?, &v?);
        Ok(Self(match controls {
            Controls::Points(dim, c, w) => {
                let (c, w) = (&c, &w);
                together!(u, v, c, w);
                AnyRationalSurface::new(u.into_owned(), v.into_owned(), dim, c.into_owned(), w.into_owned())?
            }
            Controls::Homogeneous(dim, c) => {
                let c = &c;
                together!(u, v, c);
                AnyRationalSurface::from_homogeneous(u.into_owned(), v.into_owned(), dim, c.into_owned())?
            }
        }))
    }

    /// A polynomial surface as a rational one, all weights one.
    #[staticmethod]
    fn from_polynomial(surface: &Surface) -> Result<Self> {
        Ok(Self(AnyRationalSurface::from_polynomial(&surface.0)?))
    }

    /// The quotient of a polynomial surface and a polynomial function.
    #[staticmethod]
    fn from_quotient(py: Python<'_>, numerator: &Surface, denominator: &Surface) -> Result<Self> {
        let (s, t) = (&numerator.0, &denominator.0);
        together!(s, t);
        py.detach(|| Ok(Self(AnyRationalSurface::quotient(&s, &t)?)))
    }

    /// The space of the first parameter.
    #[getter]
    fn u(&self) -> Space {
        Space(self.0.space(U))
    }

    /// The space of the second parameter.
    #[getter]
    fn v(&self) -> Space {
        Space(self.0.space(V))
    }

    /// The control points, of shape `(u.dim, v.dim)` or `(u.dim, v.dim, d)`.
    #[getter]
    fn points(&self) -> Result<Array> {
        Ok(Array::points(self.counts(), self.0.dim(), self.0.coords()?))
    }

    /// The weights, of shape `(u.dim, v.dim)`.
    #[getter]
    fn weights(&self) -> Array {
        Array::new(self.counts(), each!(&self.0, s => Field::coords(s.weights().cloned().collect())))
    }

    /// The homogeneous coordinates, of shape `(u.dim, v.dim, d + 1)`: weight times point, and the weight last.
    #[getter]
    fn homogeneous(&self) -> Array {
        Array::points(self.counts(), self.0.dim() + 1, self.0.homogeneous())
    }

    /// The polynomial surface that is weight times value.
    #[getter]
    fn numerator(&self) -> Result<Surface> {
        each!(&self.0, s => Ok(Surface(s.numerator()?.into())))
    }

    /// The polynomial function that is the weight.
    #[getter]
    fn denominator(&self) -> Result<Surface> {
        each!(&self.0, s => Ok(Surface(s.denominator()?.into())))
    }

    /// Start and end of the domain of each parameter.
    #[getter]
    fn domain(&self) -> ((Num, Num), (Num, Num)) {
        each!(&self.0, s => {
            let [u, v] = [s.u(), s.v()].map(|s| {
                let (a, b) = s.domain();
                (Num(a.clone().number()), Num(b.clone().number()))
            });
            (u, v)
        })
    }

    /// The constructor and its arguments: nothing is lost.
    #[allow(clippy::type_complexity, reason = "it is the tuple that pickle asks for")]
    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> (Bound<'py, PyAny>, (Space, Space, Option<Array>, Option<Array>, Array)) {
        let this = slf.get();
        (slf.get_type().into_any(), (this.u(), this.v(), None, None, this.homogeneous()))
    }
}

impl RationalSurface {
    fn counts(&self) -> Vec<usize> {
        each!(&self.0, s => vec![s.u().dim(), s.v().dim()])
    }
}
