//! Splines of `scipy.interpolate` and back. It is imported when it is asked for.

use crate::error::{Failure, Result};
use crate::numbers::Array;
use crate::space::Space;
use crate::spline::Spline;
use crate::surface::Surface;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use symspline::SplineSpace;
use symspline_dynamic::{AnySpace, AnySpline, Coords, Field, both, each};

/// How far apart, in periods, knots may be that a periodic spline of scipy should have a period apart: they are rounded sums.
const SLACK: f64 = 1e-12;

/// The knots and the coefficients of a spline, unrolled if it is periodic, as arrays.
fn unrolled(s: &AnySpline) -> (Array, Array) {
    each!(s, T, f => {
        let (space, dim) = (f.space(), s.dim());
        let knots = space.knots().as_slice();
        let count = knots.len() - space.degree() - 1;
        let coeffs: Vec<_> = (0..count).map(|i| f.coeffs()[space.slot(i)].clone()).collect();
        let coeffs = symspline_dynamic::number::flat::<T, _>(&coeffs);
        (Array::row::<T>(knots.to_vec()), Array::points(vec![count], dim, coeffs))
    })
}

fn not_periodic(why: &str) -> Failure {
    Failure::new(
        "NotPeriodic",
        format!("the spline says it is periodic, but {why}; periodic=False takes it as open"),
    )
}

/// The periodic space whose unrolled knots are `knots`.
fn periodic<T: Field>(degree: usize, knots: &[T]) -> Result<SplineSpace<T>> {
    let wrong = |why: &str| not_periodic(why);
    let count = (knots.len() >= 2 * degree + 2).then(|| knots.len() - 2 * degree - 1);
    let count = count.ok_or_else(|| wrong("there are too few knots"))?;
    // Once round, from the first copy of the seam.
    let copies = knots[..=degree].iter().rev().take_while(|t| **t == knots[degree]).count();
    let first = degree + 1 - copies;
    let round = knots[first..first + count].to_vec();
    let end = knots[degree + count].clone();
    let apart = |a: &T, b: &T| -> Result<f64> {
        Ok((f64::of(&a.clone().number())? - f64::of(&b.clone().number())?).abs())
    };
    let slack = SLACK * apart(&knots[degree], &end)?;
    let space = SplineSpace::periodic_up_to(degree, round, end)?;
    for (a, b) in knots.iter().zip(space.knots().as_slice()) {
        let apart = apart(a, b)?;
        if apart.is_nan() || apart > slack {
            return Err(wrong("its knots do not repeat"));
        }
    }
    Ok(space)
}

#[pymethods]
impl Spline {
    /// The `scipy.interpolate.BSpline` with the same values, in floats. That of a periodic spline is periodic; others are NaN outside
    /// the domain.
    fn to_scipy<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let float = self.0.to_float().map_err(Failure::from)?;
        let (knots, coeffs) = unrolled(&float);
        let (degree, ring) = each!(&float, s => (s.degree(), s.space().is_periodic()));
        let keywords = PyDict::new(py);
        match ring {
            true => keywords.set_item("extrapolate", "periodic")?,
            false => keywords.set_item("extrapolate", false)?,
        }
        let class = py.import("scipy.interpolate")?.getattr("BSpline")?;
        class.call((knots, coeffs, degree), Some(&keywords))
    }

    /// The spline with the knots and coefficients of a `scipy.interpolate.BSpline`. Periodic is one with `extrapolate="periodic"`, or
    /// as `periodic` says.
    #[staticmethod]
    #[pyo3(signature = (bspline, *, periodic=None))]
    fn from_scipy(bspline: &Bound<'_, PyAny>, periodic: Option<bool>) -> PyResult<Self> {
        let degree: usize = bspline.getattr("k")?.extract()?;
        let knots = bspline.getattr("t")?.extract::<Array>()?.list()?;
        let coeffs: Array = bspline.getattr("c")?.extract()?;
        let says = bspline.getattr("extrapolate")?;
        let ring = periodic.unwrap_or_else(|| says.extract::<String>().is_ok_and(|word| word == "periodic"));
        Ok(from_parts(degree, &knots, coeffs, ring)?)
    }
}

fn from_parts(degree: usize, knots: &Coords, coeffs: Array, ring: bool) -> Result<Spline> {
    let dim = coeffs.dim(1)?;
    // Scipy lets arrays end in coefficients that nothing uses.
    let used = knots.len().saturating_sub(degree + 1);
    if coeffs.shape[0] < used {
        return Err(symspline::Error::CoefficientCount { expected: used, found: coeffs.shape[0] }.into());
    }
    let space: AnySpace = match ring {
        false => both!(knots, T, t => SplineSpace::<T>::new(degree, t.iter().cloned())?.into()),
        true => both!(knots, T, t => periodic::<T>(degree, t)?.into()),
    };
    let kept = both!(&space, s => s.dim());
    both!(&coeffs.numbers, T, c => {
        let again = (kept..used).all(|i| c[i * dim..(i + 1) * dim] == c[(i - kept) * dim..(i - kept + 1) * dim]);
        if !again {
            return Err(not_periodic("its first coefficients do not come again as the last"));
        }
        let coeffs = T::coords(c[..kept * dim].to_vec());
        let (s, c) = (&space, &coeffs);
        symspline_dynamic::together!(s, c);
        Ok(Spline(AnySpline::new(s.into_owned(), dim, c.into_owned())?))
    })
}

#[pymethods]
impl Surface {
    /// The `scipy.interpolate.NdBSpline` with the same values, in floats; it needs scipy 1.12. Periodic directions are unrolled.
    fn to_scipy<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let float = self.0.to_float().map_err(Failure::from)?;
        let (knots, degrees, coeffs) = each!(&float, T, s => {
            let [m, n] = [s.u(), s.v()].map(|s| s.knots().len() - s.degree() - 1);
            let slots = (0..m).flat_map(|i| (0..n).map(move |j| (i, j)));
            let at = |(i, j): (usize, usize)| s.coeffs()[s.u().slot(i) * s.v().dim() + s.v().slot(j)].clone();
            let coeffs: Vec<_> = slots.map(at).collect();
            let knots = [s.u(), s.v()].map(|s| Array::row::<T>(s.knots().as_slice().to_vec()));
            let coeffs = symspline_dynamic::number::flat::<T, _>(&coeffs);
            (knots, (s.u().degree(), s.v().degree()), Array::points(vec![m, n], float.dim(), coeffs))
        });
        let [u, v] = knots;
        let keywords = PyDict::new(py);
        keywords.set_item("extrapolate", false)?;
        py.import("scipy.interpolate")?.getattr("NdBSpline")?.call(((u, v), coeffs, degrees), Some(&keywords))
    }

    /// The surface with the knots and coefficients of a `scipy.interpolate.NdBSpline` of two variables.
    #[staticmethod]
    fn from_scipy(bspline: &Bound<'_, PyAny>) -> PyResult<Self> {
        let (k, l): (usize, usize) = bspline.getattr("k")?.extract()?;
        let (s, t): (Array, Array) = bspline.getattr("t")?.extract()?;
        let coeffs: Array = bspline.getattr("c")?.extract()?;
        let space = |degree: usize, knots: Array| -> Result<Space> {
            both!(knots.list()?, T, t => Ok(Space(SplineSpace::<T>::new(degree, t)?.into())))
        };
        bspline
            .py()
            .get_type::<Self>()
            .call1((space(k, s)?, space(l, t)?, coeffs))?
            .extract()
            .map_err(PyErr::from)
    }
}
