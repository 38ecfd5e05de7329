//! Spaces of splines.

use crate::arguments::{Smooth, forced};
use crate::error::Result;
use crate::numbers::{Array, Num};
use pyo3::prelude::*;
use symspline::{KnotVector, SplineSpace, approximation_space, interpolation_space};
use symspline_dynamic::{AnySpace, Coords, Field, Number, both, together};

/// A space of splines: a degree, knots, and how the ends meet.
///
/// `Space(degree, knots)` is open over a full knot vector, with `len(knots) - degree - 1` coefficients. With `end` it is periodic:
/// `knots` run once round and the first comes again at `end`. Whole numbers and fractions are kept exactly; `exact=True` takes
/// floats exactly too, `exact=False` rounds.
///
/// >>> from symspline import Space
/// >>> Space(2, [0, 0, 0, 1, 1, 1]).dim
/// 3
#[pyclass(frozen, eq, module = "symspline", from_py_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct Space(pub AnySpace);

/// One text over the field of the numbers.
macro_rules! over {
    ($numbers:expr, $T:ident, $x:ident => $body:expr) => {
        both!($numbers, $T, $x => Ok(Self($body?.into())))
    };
}

#[pymethods]
impl Space {
    #[new]
    #[pyo3(signature = (degree, knots, end=None, *, exact=None))]
    fn new(degree: usize, knots: Array, end: Option<Num>, exact: Option<bool>) -> Result<Self> {
        let knots = forced(knots.list()?, exact, Coords::to_exact)?;
        let Some(Num(end)) = end else {
            return over!(knots, T, knots => SplineSpace::<T>::new(degree, knots));
        };
        let (knots, end) = (&knots, &forced(end, exact, Number::to_exact)?);
        together!(knots, end);
        over!(&*knots, T, knots => SplineSpace::periodic_up_to(degree, knots.iter().cloned(), T::of(&end)?))
    }

    /// The open space with clamped ends over `breaks`, of shape `(n,)`: the two ends once, the knots inside as often as they count.
    #[staticmethod]
    fn clamped(degree: usize, breaks: Array) -> Result<Self> {
        over!(breaks.list()?, T, breaks => SplineSpace::<T>::clamped(degree, breaks))
    }

    /// The polynomials of a degree on `[a, b]`: one span, clamped.
    #[staticmethod]
    #[pyo3(signature = (degree, a=Num::int(0), b=Num::int(1)))]
    fn bezier(degree: usize, a: Num, b: Num) -> Result<Self> {
        over!(pair(&a, &b)?, T, ab => SplineSpace::<T>::bezier(degree, ab[0].clone(), ab[1].clone()))
    }

    /// The clamped space over so many spans of one length on `[a, b]`.
    #[staticmethod]
    #[pyo3(signature = (degree, spans, a=Num::int(0), b=Num::int(1)))]
    fn uniform(degree: usize, spans: usize, a: Num, b: Num) -> Result<Self> {
        over!(pair(&a, &b)?, T, ab => SplineSpace::<T>::uniform(degree, spans, ab[0].clone(), ab[1].clone()))
    }

    /// The periodic space over so many spans of one length on `[a, b]`.
    #[staticmethod]
    #[pyo3(signature = (degree, spans, a=Num::int(0), b=Num::int(1)))]
    fn uniform_periodic(degree: usize, spans: usize, a: Num, b: Num) -> Result<Self> {
        over!(pair(&a, &b)?, T, ab =>
            SplineSpace::<T>::uniform_periodic(degree, spans, ab[0].clone(), ab[1].clone()))
    }

    /// The open space over knots of which those closer together than `tolerance` become copies of one.
    #[staticmethod]
    fn snapped(degree: usize, knots: Array, tolerance: Num) -> Result<Self> {
        over!(knots.list()?, T, knots =>
            KnotVector::new(knots)?.snapped(&T::of(&tolerance.0)?).and_then(|t| SplineSpace::<T>::over(degree, t)))
    }

    /// The space for interpolation at `parameters`, of shape `(n,)`: knots are their averages.
    #[staticmethod]
    fn for_interpolation(degree: usize, parameters: Array) -> Result<Self> {
        over!(parameters.list()?, T, x => { let _: Option<T>; interpolation_space(degree, &x) })
    }

    /// The space with `dim` coefficients for least squares at `parameters`, of shape `(n,)`.
    #[staticmethod]
    fn for_approximation(degree: usize, parameters: Array, dim: usize) -> Result<Self> {
        over!(parameters.list()?, T, x => { let _: Option<T>; approximation_space(degree, &x, dim) })
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
        both!(&self.0, s => Array::row(s.knots().as_slice().to_vec()))
    }

    /// The knots once round a periodic space, from the seam; None for an open one.
    #[getter]
    fn knots_round(&self) -> Option<Array> {
        both!(&self.0, s => s.knots_round().map(|round| Array::row(round.to_vec())))
    }

    /// Start and end of the domain.
    #[getter]
    fn domain(&self) -> (Num, Num) {
        both!(&self.0, s => (Num(s.domain().0.clone().number()), Num(s.domain().1.clone().number())))
    }

    /// The distinct knots of the domain, of shape `(n,)`.
    #[getter]
    fn breaks(&self) -> Array {
        both!(&self.0, s => Array::row(s.breaks().into_iter().map(|(t, _)| t).collect()))
    }

    /// How many copies there are of each of the breaks.
    #[getter]
    fn multiplicities(&self) -> Vec<usize> {
        both!(&self.0, s => s.breaks().into_iter().map(|(_, m)| m).collect())
    }

    /// The parameters that belong to the coefficients, averages of knots, of shape `(dim,)`.
    #[getter]
    fn greville(&self) -> Array {
        both!(&self.0, s => Array::row(s.greville()))
    }

    /// Whether the ends are joined.
    #[getter]
    fn is_periodic(&self) -> bool {
        both!(&self.0, s => s.is_periodic())
    }

    /// Whether both ends carry `degree + 1` knots, so that the first and last coefficient are the end values.
    #[getter]
    fn is_clamped(&self) -> bool {
        both!(&self.0, s => s.is_clamped())
    }

    /// Whether numbers are fractions.
    #[getter]
    fn is_exact(&self) -> bool {
        self.0.is_exact()
    }

    /// The same over fractions, without loss.
    fn to_exact(&self) -> Result<Self> {
        Ok(Self(self.0.to_exact()?))
    }

    /// The same rounded to floats.
    fn to_float(&self) -> Result<Self> {
        Ok(Self(self.0.to_float()?))
    }

    /// The space with more knots, of shape `(n,)`.
    fn refined(&self, knots: Array) -> Result<Self> {
        let (s, knots) = (&self.0, &knots.list()?);
        together!(s, knots);
        over!(&*s, T, s => s.refined(&T::all_of(&knots)?))
    }

    /// The space with a knot in the middle of every span.
    fn bisected(&self) -> Result<Self> {
        over!(&self.0, T, s => { let _: Option<T>; s.bisected() })
    }

    /// The space of the same splines as splines of a higher degree.
    #[pyo3(signature = (by=1))]
    fn elevate(&self, by: usize) -> Result<Self> {
        over!(&self.0, T, s => { let _: Option<T>; s.elevated(by) })
    }

    /// The space of a lower degree whose elevation holds the splines of that degree; `continuity` is "kept", "breaks" (no knot
    /// vanishes) or how many derivatives are continuous at most.
    #[pyo3(signature = (by=1, continuity=Smooth::default()))]
    fn reduced(&self, by: usize, continuity: Smooth) -> Result<Self> {
        over!(&self.0, T, s => { let _: Option<T>; s.reduced_with(by, continuity.0) })
    }

    /// The open space with clamped ends on the same domain, with the same knots inside.
    fn clamped_ends(&self) -> Result<Self> {
        over!(&self.0, T, s => { let _: Option<T>; s.clamped_ends() })
    }

    /// The space with single outer knots; of a ring the open space of all splines with its knots.
    fn unclamped_ends(&self) -> Result<Self> {
        over!(&self.0, T, s => { let _: Option<T>; s.unclamped_ends() })
    }

    /// The open space with these outer knots, `degree` at each end.
    fn with_outer_knots(&self, before: Array, after: Array) -> Result<Self> {
        let (s, before, after) = (&self.0, &before.list()?, &after.list()?);
        together!(s, before, after);
        over!(&*s, T, s => s.with_outer_knots(&T::all_of(&before)?, &T::all_of(&after)?))
    }

    /// The space of all splines of a degree with the same breaks, without smoothness.
    fn pieces(&self, degree: usize) -> Result<Self> {
        over!(&self.0, T, s => { let _: Option<T>; s.pieces(degree) })
    }

    /// The same over another interval.
    fn reparametrised(&self, start: Num, end: Num) -> Result<Self> {
        let (s, start, end) = (&self.0, &start.0, &end.0);
        together!(s, start, end);
        over!(&*s, T, s => s.reparametrised(&T::of(&start)?, &T::of(&end)?))
    }

    /// The space of the splines run through backwards.
    fn reversed(&self) -> Result<Self> {
        over!(&self.0, T, s => { let _: Option<T>; s.reversed() })
    }

    /// The space of the derivatives.
    fn derivative_space(&self) -> Result<Self> {
        over!(&self.0, T, s => { let _: Option<T>; s.derivative_space() })
    }

    /// The space of the antiderivatives.
    fn antiderivative_space(&self) -> Result<Self> {
        over!(&self.0, T, s => { let _: Option<T>; s.antiderivative_space() })
    }

    /// The smallest space that contains both.
    fn union(&self, other: &Self) -> Result<Self> {
        let (s, t) = (&self.0, &other.0);
        together!(s, t);
        both_alike!(&*s, &*t, s, t => Ok(Self(s.union(t)?.into())))
    }

    /// The smallest clamped space that contains the products of splines of both.
    fn product_space(&self, other: &Self) -> Result<Self> {
        let (s, t) = (&self.0, &other.0);
        together!(s, t);
        both_alike!(&*s, &*t, s, t => Ok(Self(s.product_space(t)?.into())))
    }

    /// Whether every spline of the other space is one of this.
    fn contains(&self, other: &Self) -> Result<bool> {
        let (s, t) = (&self.0, &other.0);
        together!(s, t);
        both_alike!(&*s, &*t, s, t => Ok(s.contains(t)))
    }

    fn __hash__(&self, py: Python<'_>) -> PyResult<isize> {
        let knots = self.knots().into_pyobject(py)?.call_method0("tolist")?;
        let knots = pyo3::types::PyTuple::new(py, knots.try_iter()?.collect::<PyResult<Vec<_>>>()?)?;
        (self.degree(), self.is_exact(), self.is_periodic(), knots).into_pyobject(py)?.hash()
    }

    fn __repr__(&self) -> String {
        let periodic = if self.is_periodic() { "periodic " } else { "" };
        let (degree, dim) = (self.degree(), self.dim());
        let (a, b) = self.domain();
        format!(
            "<Space: {} {periodic}degree {degree}, {dim} coefficients on [{}, {}]>",
            self.0.field(),
            a.0,
            b.0
        )
    }

    /// The constructor and its arguments: nothing is lost.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> (Bound<'py, PyAny>, (usize, Array, Option<Num>)) {
        let this = slf.get();
        let end = this.is_periodic().then(|| this.domain().1);
        let knots = this.knots_round().unwrap_or_else(|| this.knots());
        (slf.get_type().into_any(), (this.degree(), knots, end))
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }
}

/// Two numbers over one field.
fn pair(a: &Num, b: &Num) -> Result<Coords> {
    let (a, b) = (&a.0, &b.0);
    together!(a, b);
    Ok(both!(&*a, T, x => T::coords(vec![x.clone(), T::of(&b)?])))
}
