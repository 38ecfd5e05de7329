//! Functions of two parameters and surfaces.

use crate::arguments::forced;
use crate::error::{Failure, Result};
use crate::numbers::{Array, Num};
use crate::space::Space;
use pyo3::prelude::*;
use symspline::Direction::{U, V};
use symspline_dynamic::{AnySpace, AnySurface, Coords, Field, both, each, together};

/// A spline of two parameters: a function of them, or a surface in two or three dimensions.
///
/// `Surface(u, v, coeffs)` takes coefficients of shape `(u.dim, v.dim)` for a function or `(u.dim, v.dim, d)` for a surface,
/// `d` = 2 or 3. It is exact if all are; `exact=True` takes floats exactly, `exact=False` rounds.
///
/// >>> from symspline import Space, Surface
/// >>> line = Space.bezier(1)
/// >>> Surface(line, line, [[0, 0], [0, 4]])(0.5, 0.5)
/// 1.0
#[pyclass(frozen, eq, module = "symspline", from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct Surface(pub AnySurface);

/// The numbers of points along the axes of an array fit the spaces.
pub fn check_rows(shape: &[usize], u: &AnySpace, v: &AnySpace) -> Result<()> {
    let expected = [u, v].map(|s| both!(s, s => s.dim()));
    match shape.get(..2) {
        Some(found) if found == expected => Ok(()),
        _ => Err(Failure::new(
            "Shape",
            format!("points of {expected:?} are needed, they have shape {shape:?}"),
        )),
    }
}

#[pymethods]
impl Surface {
    #[new]
    #[pyo3(signature = (u, v, coeffs, *, exact=None))]
    fn new(u: &Space, v: &Space, coeffs: Array, exact: Option<bool>) -> Result<Self> {
        let dim = coeffs.dim(2)?;
        check_rows(&coeffs.shape, &u.0, &v.0)?;
        let [u, v] = [u, v].map(|s| forced(s.0.clone(), exact, AnySpace::to_exact));
        let (u, v, c) = (&u?, &v?, &forced(coeffs.numbers, exact, Coords::to_exact)?);
        together!(u, v, c);
        Ok(Self(AnySurface::new(u.into_owned(), v.into_owned(), dim, c.into_owned())?))
    }

    /// The spline of two spaces with one value everywhere.
    #[staticmethod]
    fn constant(u: &Space, v: &Space, value: Array) -> Result<Self> {
        let value = value.point()?;
        let (u, v, value) = (&u.0, &v.0, &value);
        together!(u, v, value);
        let [m, n] = [&*u, &*v].map(|s| both!(s, s => s.dim()));
        let count = m.saturating_mul(n);
        if count > symspline::limits::MAX_DIM {
            return Err(symspline::Error::TooLarge { count, limit: symspline::limits::MAX_DIM }.into());
        }
        let coords = both!(&*value, T, p => {
            T::coords(std::iter::repeat_n(p, count).flatten().cloned().collect())
        });
        Ok(Self(AnySurface::new(u.into_owned(), v.into_owned(), value.len(), coords)?))
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

    /// The coefficients, of shape `(u.dim, v.dim)` or `(u.dim, v.dim, d)`.
    #[getter]
    fn coeffs(&self) -> Result<Array> {
        let shape = each!(&self.0, s => vec![s.u().dim(), s.v().dim()]);
        Ok(Array::points(shape, self.0.dim(), self.0.coords()?))
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

    /// The same spaces with other coefficients.
    fn with_coeffs(&self, coeffs: Array) -> Result<Self> {
        Self::new(&self.u(), &self.v(), coeffs, None)
    }

    /// The constructor and its arguments: nothing is lost.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> Result<(Bound<'py, PyAny>, (Space, Space, Array))> {
        let this = slf.get();
        Ok((slf.get_type().into_any(), (this.u(), this.v(), this.coeffs()?)))
    }
}
