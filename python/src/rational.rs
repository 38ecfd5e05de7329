//! Rational functions and curves.

use crate::arguments::forced;
use crate::error::{Failure, Result};
use crate::numbers::{Array, Num};
use crate::space::Space;
use crate::spline::Spline;
use pyo3::prelude::*;
use symspline_dynamic::{AnyRational, AnySpace, Coords, each, together};

/// A rational spline of one parameter (NURBS): a function, or a curve in two or three dimensions.
///
/// `Rational(space, points, weights)` takes control points of shape `(space.dim,)` or `(space.dim, d)` and weights of shape
/// `(space.dim,)`; `Rational(space, homogeneous=...)` takes homogeneous coordinates of shape `(space.dim, d + 1)`, weight times point
/// and the weight last. It is exact if all are; `exact=True` takes floats exactly, `exact=False` rounds.
///
/// >>> from symspline import Rational
/// >>> Rational.circle([0, 0], 1)(0.25)
/// array([0., 1.])
#[pyclass(frozen, eq, module = "symspline", from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct Rational(pub AnyRational);

/// What the two ways to give control points have in common: the dimension, and the points and weights or the weighted points.
pub enum Controls {
    Points(usize, Coords, Coords),
    Homogeneous(usize, Coords),
}

impl Controls {
    /// Control points along `axes` axes.
    pub fn new(
        axes: usize,
        points: Option<Array>,
        weights: Option<Array>,
        homogeneous: Option<Array>,
        exact: Option<bool>,
        check: impl Fn(&[usize]) -> Result<()>,
    ) -> Result<Self> {
        let coords = |array: Array| {
            check(&array.shape)?;
            forced(array.numbers, exact, Coords::to_exact)
        };
        match (points, weights, homogeneous) {
            (Some(points), Some(weights), None) => {
                let dim = points.dim(axes)?;
                if weights.shape.len() != axes {
                    return Err(Failure::new("Shape", format!("weights need {axes} axes")));
                }
                Ok(Self::Points(dim, coords(points)?, coords(weights)?))
            }
            (None, None, Some(all)) if all.shape.len() == axes + 1 && all.shape[axes] > 1 => {
                Ok(Self::Homogeneous(all.shape[axes] - 1, coords(all)?))
            }
            (None, None, Some(_)) => Err(Failure::new(
                "Shape",
                format!("homogeneous coordinates need {} axes, the last of 2 to 4", axes + 1),
            )),
            _ => Err(Failure::new(
                "Arguments",
                "points and weights are needed, or homogeneous coordinates alone",
            )),
        }
    }
}

/// The arguments of the constructor: no points, no weights, but homogeneous coordinates.
type Arguments = (Space, Option<Array>, Option<Array>, Array);

#[pymethods]
impl Rational {
    #[new]
    #[pyo3(signature = (space, points=None, weights=None, homogeneous=None, *, exact=None))]
    fn new(
        space: &Space,
        points: Option<Array>,
        weights: Option<Array>,
        homogeneous: Option<Array>,
        exact: Option<bool>,
    ) -> Result<Self> {
        let s = &forced(space.0.clone(), exact, AnySpace::to_exact)?;
        Ok(Self(match Controls::new(1, points, weights, homogeneous, exact, |_| Ok(()))? {
            Controls::Points(dim, c, w) => {
                let (c, w) = (&c, &w);
                together!(s, c, w);
                AnyRational::new(s.into_owned(), dim, c.into_owned(), w.into_owned())?
            }
            Controls::Homogeneous(dim, c) => {
                let c = &c;
                together!(s, c);
                AnyRational::from_homogeneous(s.into_owned(), dim, c.into_owned())?
            }
        }))
    }

    /// A polynomial spline as a rational one, all weights one.
    #[staticmethod]
    fn from_polynomial(spline: &Spline) -> Result<Self> {
        Ok(Self(AnyRational::from_polynomial(&spline.0)?))
    }

    /// The quotient of a polynomial spline and a polynomial function.
    #[staticmethod]
    fn from_quotient(py: Python<'_>, numerator: &Spline, denominator: &Spline) -> Result<Self> {
        let (s, t) = (&numerator.0, &denominator.0);
        together!(s, t);
        py.detach(|| Ok(Self(AnyRational::quotient(&s, &t)?)))
    }

    /// The space.
    #[getter]
    fn space(&self) -> Space {
        Space(self.0.space())
    }

    /// The control points, of shape `(space.dim,)` or `(space.dim, d)`.
    #[getter]
    fn points(&self) -> Result<Array> {
        Ok(Array::points(vec![self.count()], self.0.dim(), self.0.coords()?))
    }

    /// The weights, of shape `(space.dim,)`.
    #[getter]
    fn weights(&self) -> Array {
        each!(&self.0, s => Array::row(s.weights().cloned().collect()))
    }

    /// The homogeneous coordinates, of shape `(space.dim, d + 1)`: weight times point, and the weight last.
    #[getter]
    fn homogeneous(&self) -> Array {
        Array::new(vec![self.count(), self.0.dim() + 1], self.0.homogeneous())
    }

    /// The polynomial spline that is weight times value.
    #[getter]
    fn numerator(&self) -> Result<Spline> {
        each!(&self.0, s => Ok(Spline(s.numerator()?.into())))
    }

    /// The polynomial function that is the weight.
    #[getter]
    fn denominator(&self) -> Result<Spline> {
        each!(&self.0, s => Ok(Spline(s.denominator()?.into())))
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

    /// The constructor and its arguments: nothing is lost.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> (Bound<'py, PyAny>, Arguments) {
        (slf.get_type().into_any(), (slf.get().space(), None, None, slf.get().homogeneous()))
    }
}

impl Rational {
    fn count(&self) -> usize {
        each!(&self.0, s => s.space().dim())
    }
}
