//! Values and derivatives at parameters.

use crate::error::{Failure, Result};
use crate::numbers::{Array, Num, Point};
use crate::rational::Rational;
use crate::rational_surface::RationalSurface;
use crate::spline::Spline;
use crate::surface::Surface;
use pyo3::prelude::*;
use symspline::Evaluate;
use symspline_dynamic::number::flat;
use symspline_dynamic::{Any, Coords, Field, Meeting as _, Over, each};

/// From how many float parameters on an evaluator is made and all cores work.
const MANY: usize = 1 << 14;

/// Values at very many parameters.
fn batch<E: Evaluate<Value: Clone>>(
    evaluator: &E,
    parameters: &[E::Parameter],
    zero: E::Value,
) -> symspline::Result<Vec<E::Value>> {
    let mut values = vec![zero; parameters.len()];
    evaluator.par_eval_into(parameters, &mut values)?;
    Ok(values)
}

/// Pairs of parameters.
fn pairs<T: Field>(u: &Coords, v: &Coords) -> symspline_dynamic::Result<Vec<(T, T)>> {
    Ok(T::all_of(u)?.into_iter().zip(T::all_of(v)?).collect())
}

/// Values over fractions at parameters that are floats are rounded.
fn met(values: Coords, exact: bool) -> Result<Coords> {
    Ok(values.among(exact)?.into_owned())
}

/// Values along the axes of the parameters: numbers and points for one parameter.
fn values<'py>(
    py: Python<'py>,
    shape: Vec<usize>,
    dim: usize,
    values: Coords,
) -> PyResult<Bound<'py, PyAny>> {
    if shape.is_empty() {
        Point(values).into_pyobject(py)
    } else {
        Array::points(shape, dim, values).into_pyobject(py)
    }
}

/// Two arrays of one shape.
fn broadcast(py: Python<'_>, u: &Bound<'_, PyAny>, v: &Bound<'_, PyAny>) -> PyResult<(Array, Array)> {
    let (us, vs) = (u.extract::<Array>()?, v.extract::<Array>()?);
    if us.shape == vs.shape {
        return Ok((us, vs));
    }
    let both = py.import("numpy")?.call_method1("broadcast_arrays", (us, vs))?;
    let both = both.try_iter()?.map(|array| array?.extract::<Array>()).collect::<PyResult<Vec<_>>>()?;
    let [us, vs] =
        <[Array; 2]>::try_from(both).map_err(|_| Failure::new("Shape", "two arrays are needed"))?;
    Ok((us, vs))
}

/// One number for each of several coordinates lists.
fn united(all: Vec<Coords>) -> Coords {
    let mut all = all.into_iter();
    let Some(mut first) = all.next() else { return Over::Float(Vec::new()) };
    for next in all {
        match (&mut first, next) {
            (Over::Float(first), Over::Float(next)) => first.extend(next),
            (Over::Exact(first), Over::Exact(next)) => first.extend(next),
            _ => {}
        }
    }
    first
}

macro_rules! of_one_parameter {
    ($class:ident) => {
        #[pymethods]
        impl $class {
            /// The value at a parameter, or the values at an array of parameters: an array of its shape, with an axis more for curves.
            /// Right limits, at the end of the domain left ones. In floats the values of a long array may differ from single ones by a
            /// few roundings. A float parameter of an exact spline: the exact value, rounded.
            fn __call__<'py>(&self, py: Python<'py>, x: Array) -> PyResult<Bound<'py, PyAny>> {
                let (exact, s, shape) = (x.numbers.is_exact(), &self.0, x.shape);
                let found = py.detach(|| -> Result<Coords> {
                    let many = x.numbers.len() >= MANY;
                    let found = match (s, &x.numbers) {
                        (Any::F1(s), Over::Float(x)) if many => flat(&batch(&s.evaluator()?, x, 0.0)?),
                        (Any::F2(s), Over::Float(x)) if many => flat(&batch(&s.evaluator()?, x, Default::default())?),
                        (Any::F3(s), Over::Float(x)) if many => flat(&batch(&s.evaluator()?, x, Default::default())?),
                        (s, x) => s.eval(x)?,
                    };
                    met(found, exact)
                })?;
                values(py, shape, self.0.dim(), found)
            }

            /// The limit of the values from the left at a parameter.
            fn at_left(&self, py: Python<'_>, x: Num) -> Result<Point> {
                py.detach(|| {
                    each!(&self.0, T, s => met(flat::<T, _>(&[s.at_left(&T::of(&x.0)?)?]), x.0.is_exact())).map(Point)
                })
            }

            /// The value and the derivatives up to an order at a parameter: shape `(order + 1,)` or `(order + 1, d)`; at an array of
            /// parameters the axes of the array come first.
            fn derivatives_at(&self, py: Python<'_>, x: Array, order: usize) -> Result<Array> {
                let (exact, dim, mut shape) = (x.numbers.is_exact(), self.0.dim(), x.shape);
                check_count(x.numbers.len(), order, dim)?;
                let all = py.detach(|| -> Result<Coords> {
                    let found = each!(&self.0, T, s => {
                        let mut found = Vec::new();
                        for x in T::all_of(&x.numbers)? {
                            found.extend(s.derivatives_at(&x, order)?);
                        }
                        flat::<T, _>(&found)
                    });
                    met(found, exact)
                })?;
                shape.push(order + 1);
                Ok(Array::points(shape, dim, all))
            }
        }
    };
}

/// That so many numbers may be made.
fn check_count(parameters: usize, order: usize, dim: usize) -> Result<()> {
    let limit = symspline::limits::MAX_DIM;
    match parameters.max(1).saturating_mul(order.saturating_add(1)).saturating_mul(dim) {
        count if count > limit => Err(symspline::Error::TooLarge { count, limit }.into()),
        _ => Ok(()),
    }
}

of_one_parameter!(Spline);
of_one_parameter!(Rational);

macro_rules! of_two_parameters {
    ($class:ident) => {
        #[pymethods]
        impl $class {
            /// The value at a pair of parameters, or the values at arrays of them, which are broadcast: an array of their shape, with
            /// an axis more for surfaces. A float parameter of an exact surface: the exact value, rounded.
            fn __call__<'py>(
                &self,
                py: Python<'py>,
                u: &Bound<'py, PyAny>,
                v: &Bound<'py, PyAny>,
            ) -> PyResult<Bound<'py, PyAny>> {
                let (u, v) = broadcast(py, u, v)?;
                let (exact, s) = (u.numbers.is_exact() && v.numbers.is_exact(), &self.0);
                let found = py.detach(|| -> Result<Coords> {
                    let many = u.numbers.len() >= MANY && !exact;
                    let found = match s {
                        Any::F1(s) if many => flat(&batch(&s.evaluator()?, &pairs(&u.numbers, &v.numbers)?, 0.0)?),
                        Any::F2(s) if many => {
                            flat(&batch(&s.evaluator()?, &pairs(&u.numbers, &v.numbers)?, Default::default())?)
                        }
                        Any::F3(s) if many => {
                            flat(&batch(&s.evaluator()?, &pairs(&u.numbers, &v.numbers)?, Default::default())?)
                        }
                        s => each!(s, T, s => flat::<T, _>(&s.eval(&pairs::<T>(&u.numbers, &v.numbers)?)?)),
                    };
                    met(found, exact)
                })?;
                values(py, u.shape, self.0.dim(), found)
            }

            /// The values on a grid: shape `(m, n)` or `(m, n, d)` for `m` parameters `us` and `n` parameters `vs`.
            fn grid(&self, py: Python<'_>, us: Array, vs: Array) -> Result<Array> {
                let (us, vs) = (us.list()?, vs.list()?);
                let (exact, shape) = (us.is_exact() && vs.is_exact(), vec![us.len(), vs.len()]);
                check_count(us.len().saturating_mul(vs.len()), 0, self.0.dim())?;
                let found = py.detach(|| met(self.0.eval_grid(&us, &vs)?, exact))?;
                Ok(Array::points(shape, self.0.dim(), found))
            }

            /// All mixed derivatives up to an order: shape `(order + 1, order + 1)` or with an axis more, `[k, l]` of `k` in `u` and
            /// `l` in `v`.
            fn derivatives_at(&self, py: Python<'_>, u: Num, v: Num, order: usize) -> Result<Array> {
                let exact = u.0.is_exact() && v.0.is_exact();
                check_count(order.saturating_add(1), order, self.0.dim())?;
                let found = py.detach(|| -> Result<Coords> {
                    let all = self.0.derivatives_at(&u.0, &v.0, order)?;
                    met(united(all.into_iter().flatten().collect()), exact)
                })?;
                Ok(Array::points(vec![order + 1, order + 1], self.0.dim(), found))
            }

            /// The value and the first derivatives in `u` and in `v`: shape `(3,)` or `(3, d)`.
            fn tangents_at(&self, u: Num, v: Num) -> Result<Array> {
                let exact = u.0.is_exact() && v.0.is_exact();
                let found = each!(&self.0, T, s => flat::<T, _>(&s.tangents_at(&T::of(&u.0)?, &T::of(&v.0)?)?));
                Ok(Array::points(vec![3], self.0.dim(), met(found, exact)?))
            }
        }
    };
}

of_two_parameters!(Surface);
of_two_parameters!(RationalSurface);
