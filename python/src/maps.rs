//! Basis functions and maps of spaces, as numbers and matrices.

use crate::error::Result;
use crate::numbers::{Array, Num};
use crate::space::Space;
use crate::spline::Spline;
use pyo3::prelude::*;
use symspline::limits::MAX_ENTRIES;
use symspline::{Error, Functional, LinearMap};
use symspline_dynamic::{Any, Field, Number, Over, both, together};

/// A row of weights: the index of the first, and the weights.
type Weights = (usize, Array);

fn weights<T: Field>(row: &Functional<T>) -> Weights {
    (row.first(), Array::new(vec![row.weights().len()], T::coords(row.weights().to_vec())))
}

/// The matrix of a map, of shape `(target, source)`.
fn matrix<T: Field>(map: symspline::Result<LinearMap<T>>) -> Result<Array> {
    let matrix = map?.to_matrix()?;
    // Columns are stored one after the other.
    let numbers = matrix.transpose().iter().cloned().collect();
    Ok(Array::new(vec![matrix.nrows(), matrix.ncols()], T::coords(numbers)))
}

/// That a matrix, or `layers` of them, is not too large: asked before it is made.
fn checked(rows: usize, columns: usize, layers: usize) -> Result<()> {
    match rows.saturating_mul(columns).saturating_mul(layers) {
        0..=MAX_ENTRIES => Ok(()),
        count => Err(Error::TooLarge { count, limit: MAX_ENTRIES }.into()),
    }
}

#[pymethods]
impl Space {
    /// The basis functions at a parameter that are not zero there: the index of the first, and their values, of shape
    /// `(degree + 1,)`. Indices of a periodic space are unrolled: coefficient `i` is stored at `i % dim`.
    fn basis(&self, x: Num) -> Result<Weights> {
        let (s, x) = (&self.0, &x.0);
        together!(s, x);
        both!(&*s, T, s => Ok(weights(&s.basis(&T::of(&x)?)?)))
    }

    /// As `basis`, for the values and all derivatives up to an order: a list of pairs.
    fn basis_derivatives(&self, x: Num, order: usize) -> Result<Vec<Weights>> {
        let (s, x) = (&self.0, &x.0);
        together!(s, x);
        both!(&*s, T, s => Ok(s.basis_derivatives(&T::of(&x)?, order)?.iter().map(weights).collect()))
    }

    /// The span that holds a parameter: the index of the knot at its start.
    fn locate(&self, x: Num) -> Result<usize> {
        both!(&self.0, T, s => Ok(s.locate(&T::of(&x.0)?)?))
    }

    /// Where coefficient `i` of the unrolled space is stored.
    fn slot(&self, i: usize) -> usize {
        both!(&self.0, s => s.slot(i))
    }

    /// The weights of the polar form of the span after knot `span` at `degree` arguments: as `basis`.
    fn polar(&self, span: usize, arguments: Array) -> Result<Weights> {
        let (s, arguments) = (&self.0, &arguments.list()?);
        together!(s, arguments);
        both!(&*s, T, s => Ok(weights(&s.polar(span, &T::all_of(&arguments)?)?)))
    }

    /// The values of all basis functions at many parameters, of shape `(n,)`: a matrix of shape `(n, dim)`. Applied to coefficients
    /// it gives values.
    fn evaluation(&self, py: Python<'_>, parameters: Array) -> Result<Array> {
        let (s, x) = (&self.0, &parameters.list()?);
        together!(s, x);
        checked(x.len(), both!(&*s, s => s.dim()), 1)?;
        py.detach(|| both!(&*s, T, s => matrix(s.evaluation(&T::all_of(&x)?))))
    }

    /// The matrix of the derivative, from coefficients here to coefficients in `derivative_space()`.
    fn differentiation(&self, py: Python<'_>) -> Result<Array> {
        py.detach(|| both!(&self.0, T, s => matrix::<T>(s.differentiation())))
    }

    /// The matrix of the antiderivative that vanishes at the start of the domain.
    fn antidifferentiation(&self, py: Python<'_>) -> Result<Array> {
        py.detach(|| both!(&self.0, T, s => matrix::<T>(s.antidifferentiation())))
    }

    /// The matrix that takes coefficients here to coefficients in a space that holds this one.
    fn embedding(&self, py: Python<'_>, target: &Self) -> Result<Array> {
        let (s, t) = (&self.0, &target.0);
        together!(s, t);
        py.detach(|| both_alike!(&*s, &*t, s, t => matrix(s.embedding(t))))
    }

    /// The open space with clamped ends of the splines here, restricted to `[a, b]`.
    fn restricted_space(&self, a: Num, b: Num) -> Result<Self> {
        let (s, a, b) = (&self.0, &a.0, &b.0);
        together!(s, a, b);
        both!(&*s, T, s => Ok(Self(s.restricted_space(&T::of(&a)?, &T::of(&b)?)?.into())))
    }

    /// The matrix of the restriction to `[a, b]`, from coefficients here to coefficients in `restricted_space(a, b)`.
    fn restriction(&self, py: Python<'_>, a: Num, b: Num) -> Result<Array> {
        let (s, a, b) = (&self.0, &a.0, &b.0);
        together!(s, a, b);
        py.detach(|| both!(&*s, T, s => matrix(s.restriction(&T::of(&a)?, &T::of(&b)?))))
    }

    /// The matrix of the reversal, from coefficients here to coefficients in `reversed()`: a permutation.
    fn reversal(&self, py: Python<'_>) -> Result<Array> {
        py.detach(|| both!(&self.0, T, s => matrix::<T>(Ok(s.reversal()))))
    }

    /// The matrix that takes Bernstein coefficients on the spans, those of `pieces(degree)`, to coefficients here, of splines that lie
    /// here.
    fn recomposition(&self, py: Python<'_>) -> Result<Array> {
        py.detach(|| both!(&self.0, T, s => matrix::<T>(s.recomposition())))
    }

    /// The composition with an inner function: the space of the results, and the matrix from coefficients here to those there.
    fn composition(&self, py: Python<'_>, inner: &Spline) -> Result<(Self, Array)> {
        let (s, inner) = (&self.0, &inner.0);
        together!(s, inner);
        py.detach(|| match (&*s, &*inner) {
            (Over::Float(s), Any::F1(inner)) => {
                let (space, map) = s.composition(inner)?;
                Ok((Self(space.into()), matrix(Ok(map))?))
            }
            (Over::Exact(s), Any::Q1(inner)) => {
                let (space, map) = s.composition(inner)?;
                Ok((Self(space.into()), matrix(Ok(map))?))
            }
            (_, inner) => Err(symspline_dynamic::Error::Dimensions { left: 1, right: inner.dim() }.into()),
        })
    }

    /// From where to where basis function `i` of the unrolled space has influence.
    fn support(&self, i: usize) -> Result<(Num, Num)> {
        both!(&self.0, s => {
            let (a, b) = s.support(i)?;
            Ok((Num(a.clone().number()), Num(b.clone().number())))
        })
    }

    /// So many parameters at equal distances from the start to the end of the domain, of shape `(count,)`; of a ring the end is left
    /// out.
    fn even_parameters(&self, count: usize) -> Result<Array> {
        both!(&self.0, s => Ok(Array::row(s.even_parameters(count)?)))
    }

    /// The inner products of the `k`-th derivatives of the basis functions here with the `l`-th of those of the other space, between
    /// `a` and `b` or over the domain: a matrix of shape `(dim, other.dim)`.
    #[pyo3(signature = (other=None, k=0, l=0, *, a=None, b=None))]
    fn gram(
        &self,
        py: Python<'_>,
        other: Option<&Self>,
        k: usize,
        l: usize,
        a: Option<Num>,
        b: Option<Num>,
    ) -> Result<Array> {
        let (s, t) = (&self.0, &other.unwrap_or(self).0);
        let (start, end): (Number, Number) =
            both!(s, s => (s.domain().0.clone().number(), s.domain().1.clone().number()));
        let (a, b) = (&a.map_or(start, |a| a.0), &b.map_or(end, |b| b.0));
        together!(s, t, a, b);
        py.detach(
            || both_alike!(&*s, &*t, T, s, t => matrix(s.gram_between(t, k, l, &T::of(&a)?, &T::of(&b)?))),
        )
    }

    /// The products of the basis functions in `product_space(other)`: an array of shape `(product.dim, dim, other.dim)`.
    fn multiplication(&self, py: Python<'_>, other: &Self) -> Result<Array> {
        let (s, t) = (&self.0, &other.0);
        together!(s, t);
        py.detach(|| {
            both_alike!(&*s, &*t, T, s, t => {
                let map = s.multiplication(t)?;
                let ((m, n), count) = (map.source_dims(), map.target_dim());
                checked(m, n, count)?;
                let mut all: Vec<T> = Vec::with_capacity(m * n * count);
                for i in 0..count {
                    let layer = map.to_matrix(i)?;
                    all.extend(layer.row_iter().flat_map(|row| row.iter().cloned().collect::<Vec<T>>()));
                }
                Ok(Array::new(vec![count, m, n], T::coords(all)))
            })
        })
    }

    /// The integrals of the basis functions from `a` to `b`: as `basis`.
    fn integral_between(&self, a: Num, b: Num) -> Result<Weights> {
        let (s, a, b) = (&self.0, &a.0, &b.0);
        together!(s, a, b);
        both!(&*s, T, s => Ok(weights(&s.integral_between(&T::of(&a)?, &T::of(&b)?)?)))
    }

    /// The integrals of the basis functions times a power of the parameter: as `basis`.
    fn moment(&self, power: usize) -> Result<Weights> {
        both!(&self.0, s => Ok(weights(&s.moment(power)?)))
    }

    /// The coefficients of the power `x**k`, of shape `(dim,)`.
    fn monomial_coeffs(&self, k: usize) -> Result<Array> {
        both!(&self.0, T, s => Ok(Array::row::<T>(s.monomial_coeffs(k)?)))
    }

    /// The coefficients of `(y - x)**degree` as a function of `x` (Marsden), of shape `(dim,)`.
    fn marsden_coeffs(&self, y: Num) -> Result<Array> {
        let (s, y) = (&self.0, &y.0);
        together!(s, y);
        both!(&*s, T, s => Ok(Array::row::<T>(s.marsden_coeffs(&T::of(&y)?)?)))
    }

    /// The functional that gives coefficient `i` of a spline from its derivatives at one point: the point, whether the derivatives
    /// are limits from the left, and the weights of the derivatives, of shape `(degree + 1,)`.
    fn dual_functional(&self, i: usize) -> Result<(Num, bool, Array)> {
        both!(&self.0, T, s => {
            let dual = s.dual_functional(i)?;
            let point = Num(T::number(dual.point().clone()));
            Ok((point, dual.from_left(), Array::row::<T>(dual.weights().to_vec())))
        })
    }
}
