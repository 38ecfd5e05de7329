//! Functions and curves.

use crate::arguments::forced;
use crate::error::Result;
use crate::numbers::{Array, Num};
use crate::space::Space;
use pyo3::prelude::*;
use symspline_dynamic::{AnySpline, Coords, each, together};

/// A spline of one parameter: a function, or a curve in two or three dimensions.
///
/// `Spline(space, coeffs)` takes coefficients of shape `(space.dim,)` for a function or `(space.dim, d)` for a curve, `d` = 2 or 3.
/// It is exact if both are; `exact=True` takes floats exactly, `exact=False` rounds.
///
/// >>> from symspline import Space, Spline
/// >>> Spline(Space.bezier(2), [[0, 0], [1, 2], [2, 0]])(0.5)
/// array([1., 1.])
#[pyclass(frozen, eq, module = "symspline", from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct Spline(pub AnySpline);

#[pymethods]
impl Spline {
    #[new]
    #[pyo3(signature = (space, coeffs, *, exact=None))]
    fn new(space: &Space, coeffs: Array, exact: Option<bool>) -> Result<Self> {
        let dim = coeffs.dim(1)?;
        let space = forced(space.0.clone(), exact, symspline_dynamic::AnySpace::to_exact)?;
        let coeffs = forced(coeffs.numbers, exact, Coords::to_exact)?;
        let (s, c) = (&space, &coeffs);
        together!(s, c);
        Ok(Self(AnySpline::new(s.into_owned(), dim, c.into_owned())?))
    }

    /// The spline of `space` with one value everywhere.
    #[staticmethod]
    fn constant(space: &Space, value: Array) -> Result<Self> {
        let (value, count) = (value.point()?, symspline_dynamic::both!(&space.0, s => s.dim()));
        let (s, value) = (&space.0, &value);
        together!(s, value);
        let dim = value.len();
        let coords = symspline_dynamic::both!(&*value, T, p => {
            <T as symspline_dynamic::Field>::coords(std::iter::repeat_n(p, count).flatten().cloned().collect())
        });
        Ok(Self(AnySpline::new(s.into_owned(), dim, coords)?))
    }

    /// The space.
    #[getter]
    fn space(&self) -> Space {
        Space(self.0.space())
    }

    /// The coefficients, of shape `(space.dim,)` or `(space.dim, d)`.
    #[getter]
    fn coeffs(&self) -> Result<Array> {
        Ok(Array::points(vec![each!(&self.0, s => s.space().dim())], self.0.dim(), self.0.coords()?))
    }

    /// The degree.
    #[getter]
    fn degree(&self) -> usize {
        each!(&self.0, s => s.degree())
    }

    /// Start and end of the domain.
    #[getter]
    fn domain(&self) -> (Num, Num) {
        let (a, b) = self.0.domain();
        (Num(a), Num(b))
    }

    /// The same space with other coefficients.
    fn with_coeffs(&self, coeffs: Array) -> Result<Self> {
        Self::new(&self.space(), coeffs, None)
    }

    /// The constructor and its arguments: nothing is lost.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> Result<(Bound<'py, PyAny>, (Space, Array))> {
        Ok((slf.get_type().into_any(), (slf.get().space(), slf.get().coeffs()?)))
    }
}
