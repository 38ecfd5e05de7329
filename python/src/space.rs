//! Spaces of splines.

use crate::error::Result;
use crate::numbers::{Array, Num};
use pyo3::prelude::*;
use symspline::SplineSpace;
use symspline_dynamic::{AnySpace, Coords, Field, both};

/// A space of splines: a degree, knots, and how the ends meet.
///
/// `Space(degree, knots)` is open over a full knot vector, with `len(knots) - degree - 1` coefficients. With `end` it is periodic:
/// `knots` run once round and the first comes again at `end`. Whole numbers and fractions are kept exactly.
///
/// >>> from symspline import Space
/// >>> Space(2, [0, 0, 0, 1, 1, 1]).dim
/// 3
#[pyclass(frozen, eq, module = "symspline", from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct Space(pub AnySpace);

#[pymethods]
impl Space {
    #[new]
    #[pyo3(signature = (degree, knots, end=None))]
    fn new(degree: usize, knots: Array, end: Option<Num>) -> Result<Self> {
        fn of<T: Field>(degree: usize, knots: Vec<T>, end: Option<T>) -> Result<SplineSpace<T>> {
            Ok(match end {
                Some(end) => SplineSpace::periodic_up_to(degree, knots, end)?,
                None => SplineSpace::new(degree, knots)?,
            })
        }
        Ok(Self(match knots.numbers {
            Coords::Float(knots) => of(degree, knots, end.map(|x| f64::of(&x.0)).transpose()?)?.into(),
            Coords::Exact(knots) => {
                of(degree, knots, end.map(|x| symspline::Q::of(&x.0)).transpose()?)?.into()
            }
        }))
    }

    /// The degree.
    #[getter]
    fn degree(&self) -> usize {
        both!(&self.0, s => s.degree())
    }

    /// How many coefficients a spline has.
    #[getter]
    fn dim(&self) -> usize {
        both!(&self.0, s => s.dim())
    }

    /// The full knot vector, of shape `(n,)`; of a periodic space unrolled.
    #[getter]
    fn knots(&self) -> Array {
        both!(&self.0, s => Array::new(vec![s.knots().as_slice().len()], Field::coords(s.knots().as_slice().to_vec())))
    }

    /// What makes an open one again, for pickling.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> (Bound<'py, PyAny>, (usize, Array)) {
        (slf.get_type().into_any(), (slf.get().degree(), slf.get().knots()))
    }

    /// Whether numbers are fractions.
    #[getter]
    fn is_exact(&self) -> bool {
        self.0.is_exact()
    }
}
