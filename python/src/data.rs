//! Splines from data: interpolation, least squares, conics.

use crate::arguments::{ENDS, word};
use crate::called::Called;
use crate::error::{Failure, Result};
use crate::numbers::{Array, Num};
use crate::rational::Rational;
use crate::space::Space;
use crate::spline::Spline;
use nalgebra::SVector;
use pyo3::prelude::*;
use symspline::{Error, Spline as SplineOf, chord_length};
use symspline_dynamic::operators::coefficient;
use symspline_dynamic::tools::shape::all_points;
use symspline_dynamic::{AnySpline, Coords, Field, Over, Spaced, both, each, together, with_points};

/// One text for data at parameters in a space: `$x` parameters, `$p` points.
macro_rules! fitted {
    ($py:ident, $space:ident, $parameters:ident, $data:ident, $T:ident, $s:ident, $x:ident, $p:ident => $body:expr) => {{
        let dim = $data.dim(1)?;
        let (space, parameters, data) = (&$space.0, &$parameters.list()?, &$data.numbers);
        together!(space, parameters, data);
        $py.detach(|| {
            with_points!(&*data, dim, $T, $p => {
                let ($s, $x) = (<$T as Spaced>::space(&space)?, $T::all_of(&parameters)?);
                Ok(Self($body?.into()))
            })
        })
    }};
}

#[pymethods]
impl Spline {
    /// The segment from a point to another, over `[0, 1]`.
    #[staticmethod]
    fn segment(start: Array, end: Array) -> Result<Self> {
        let (a, b) = (&start.point()?, &end.point()?);
        together!(a, b);
        both!(&*a, T, a => {
            let space = symspline::SplineSpace::<T>::bezier(1, T::of(&Num::int(0).0)?, T::of(&Num::int(1).0)?)?;
            if a.len() != b.len() {
                return Err(symspline_dynamic::Error::Dimensions { left: a.len(), right: b.len() }.into());
            }
            let ends = T::coords(a.iter().cloned().chain(T::all_of(&b)?).collect());
            Ok(Self(AnySpline::new(space.into(), a.len(), ends)?))
        })
    }

    /// The ring of a degree with these control points, of shape `(n,)` or `(n, d)`, over `[0, 1]`.
    #[staticmethod]
    fn closed(degree: usize, vertices: Array) -> Result<Self> {
        let dim = vertices.dim(1)?;
        with_points!(&vertices.numbers, dim, T, p => Ok(Self(SplineOf::<T, _>::closed(degree, p)?.into())))
    }

    /// The spline of `space` with the values `data`, of shape `(n,)` or `(n, d)`, at `parameters`, of shape `(n,)`: as many as
    /// coefficients.
    #[staticmethod]
    fn interpolating(py: Python<'_>, space: &Space, parameters: Array, data: Array) -> Result<Self> {
        fitted!(py, space, parameters, data, T, s, x, p => SplineOf::interpolating(s, &x, &p))
    }

    /// Parameters from 0 to 1 that advance like the lengths of the legs between points, of shape `(n, d)`: an array of shape `(n,)`,
    /// over floats.
    #[staticmethod]
    fn chord_length(points: Array) -> Result<Array> {
        let (dim, floats) = (points.dim(1)?, points.numbers.to_float()?);
        let found = match (&floats, dim) {
            (Over::Float(_), 2) => chord_length(&all_points::<f64, SVector<f64, 2>>(&floats)?)?,
            (Over::Float(_), 3) => chord_length(&all_points::<f64, SVector<f64, 3>>(&floats)?)?,
            (_, found) => return Err(symspline_dynamic::Error::Dimension { found, least: 2 }.into()),
        };
        Ok(Array::row(found))
    }

    /// As `interpolating`; a parameter that is repeated asks for derivatives.
    #[staticmethod]
    fn osculating(py: Python<'_>, space: &Space, parameters: Array, data: Array) -> Result<Self> {
        fitted!(py, space, parameters, data, T, s, x, p => SplineOf::osculating(s, &x, &p))
    }

    /// The spline of `space` with the least sum of squared distances from `data`, of shape `(n,)` or `(n, d)`, at `parameters`; with
    /// `ends="held"` it starts and ends at the first and last point.
    #[staticmethod]
    #[pyo3(signature = (space, parameters, data, ends="free"))]
    fn least_squares(
        py: Python<'_>,
        space: &Space,
        parameters: Array,
        data: Array,
        ends: &str,
    ) -> Result<Self> {
        let ends = word("ends", ends, &ENDS)?;
        fitted!(py, space, parameters, data, T, s, x, p => SplineOf::least_squares(s, &x, &p, ends))
    }

    /// The largest squared distance of `data` from the values at `parameters`.
    fn largest_squared_residual(&self, py: Python<'_>, parameters: Array, data: Array) -> Result<Num> {
        let found = data.dim(1)?;
        if found != self.0.dim() {
            return Err(symspline_dynamic::Error::Dimensions { left: self.0.dim(), right: found }.into());
        }
        let (s, x, data) = (&self.0, &parameters.list()?, &data.numbers);
        together!(s, x, data);
        py.detach(|| {
            each!(&*s, T, s => {
                let points = symspline_dynamic::number::points::<T, _>(&T::all_of(&data)?)?;
                Ok(Num(s.largest_squared_residual(&T::all_of(&x)?, &points)?.number()))
            })
        })
    }

    /// The quasi-interpolant of a Python function in `space`: `sample(x)` gives a number or a point.
    #[staticmethod]
    fn quasi_interpolant(space: &Space, sample: &Bound<'_, PyAny>) -> PyResult<Self> {
        // The first call tells the dimension, and whether the values are exact.
        let ask = |x: Num| -> PyResult<Coords> { Ok(sample.call1((x,))?.extract::<Array>()?.point()?) };
        let first = ask(Num(both!(&space.0, s => s.domain().0.clone().number())))?;
        let s = &space.0;
        let values = &first;
        let called = Called::default();
        let found = (|| -> Result<Self> {
            together!(s, values);
            with_points!(&*values, first.len(), T, p => {
                let mut point = p.into_iter().next().ok_or_else(|| Failure::new("Shape", "no value"))?;
                let found = <T as Spaced>::space(&s)?.quasi_interpolant(|x| {
                    let value = called.call(|_| {
                        Ok(coefficient::<T, _>(&ask(Num(x.clone().number()))?).map_err(Failure::from)?)
                    });
                    point = value.map_err(|_| Error::NotFinite { what: "sample", index: 0 })?;
                    Ok(point.clone())
                });
                Ok(Self(found?.into()))
            })
        })();
        called.out(found)
    }
}

/// A point in the plane.
fn plane<T: Field>(point: &Coords) -> Result<SVector<T, 2>> {
    Ok(coefficient(point)?)
}

#[pymethods]
impl Rational {
    /// The circle around a point of the plane, over `[0, 1]`, in four pieces of degree 2.
    #[staticmethod]
    fn circle(centre: Array, radius: Num) -> Result<Self> {
        let (c, r) = (&centre.point()?, &radius.0);
        together!(c, r);
        both!(&*r, T, r => Ok(Self(symspline::circle::<T>(&plane(&c)?, r)?.into())))
    }

    /// The ellipse with a centre and two half axes, points of the plane or of space.
    #[staticmethod]
    fn ellipse(centre: Array, a: Array, b: Array) -> Result<Self> {
        let (c, a, b) = (&centre.point()?, &a.point()?, &b.point()?);
        together!(c, a, b);
        both!(&*c, T, _c => match c.len() {
            2 => Ok(Self(symspline::ellipse::<T, 2>(&plane(&c)?, &plane(&a)?, &plane(&b)?)?.into())),
            3 => Ok(Self(symspline::ellipse::<T, 3>(&coefficient(&c)?, &coefficient(&a)?, &coefficient(&b)?)?.into())),
            found => Err(symspline_dynamic::Error::Dimension { found, least: 2 }.into()),
        })
    }

    /// The arc around a point of the plane from a point to another, counter-clockwise.
    #[staticmethod]
    fn arc(centre: Array, start: Array, end: Array) -> Result<Self> {
        let (c, a, b) = (&centre.point()?, &start.point()?, &end.point()?);
        together!(c, a, b);
        both!(&*c, T, _c => Ok(Self(symspline::arc::<T>(&plane(&c)?, &plane(&a)?, &plane(&b)?)?.into())))
    }

    /// The arc around a point of the plane that starts at an angle and turns by another, in radians, in floats.
    #[staticmethod]
    fn arc_by_angles(centre: Array, radius: Num, start: Num, sweep: Num) -> Result<Self> {
        let [radius, start, sweep] = [f64::of(&radius.0)?, f64::of(&start.0)?, f64::of(&sweep.0)?];
        Ok(Self(symspline::arc_by_angles(&plane(&centre.point()?)?, &radius, &start, &sweep)?.into()))
    }

    /// The conic with three control points, of shape `(3, d)`, and three weights.
    #[staticmethod]
    fn conic(points: Array, weights: Array) -> Result<Self> {
        let zero_one = Space(symspline_dynamic::AnySpace::from(symspline::SplineSpace::bezier(
            2,
            symspline::Q::from(0_i64),
            symspline::Q::from(1_i64),
        )?));
        let dim = points.dim(1)?;
        let (s, c, w) = (&zero_one.0, &points.numbers, &weights.list()?);
        together!(s, c, w);
        Ok(Self(symspline_dynamic::AnyRational::new(s.into_owned(), dim, c.into_owned(), w.into_owned())?))
    }
}
