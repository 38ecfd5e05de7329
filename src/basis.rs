//! Basis functions and other functionals of a space: values, derivatives and polar values as rows of weights.

use crate::error::{Error, Result};
use crate::functional::Functional;
use crate::limits::{check_degree, check_entries};
use crate::map::LinearMap;
use crate::polar::{blossom, differentiate, take_run};
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::window::{SMALL, small_weights};
use std::iter::repeat_n;

impl<T: Scalar> SplineSpace<T> {
    /// The value at `x` as a functional: the `p + 1` basis functions that do not vanish there, from the right.
    ///
    /// Computes what [NURBS, A2.2] does.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let space = SplineSpace::clamped(2, [0.0, 1.0, 2.0])?;
    /// let basis = space.basis(&1.0)?;
    /// assert_eq!((basis.first(), basis.weights()), (1, &[0.5, 0.5, 0.0][..]));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn basis(&self, x: &T) -> Result<Functional<T>> {
        Ok(self.basis_on(self.locate(x)?, x))
    }

    /// The values at `parameters` as a map: row `i` holds the basis functions at parameter `i`.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::TooLarge`] for more than [`MAX_ENTRIES`](crate::limits::MAX_ENTRIES) weights.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// assert_eq!(line.evaluation(&[0.0, 0.75])?.apply(&[4.0, 8.0])?, [4.0, 7.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn evaluation(&self, parameters: &[T]) -> Result<LinearMap<T>> {
        let p = self.degree();
        check_entries(parameters.len(), p + 1)?;
        let mut map = LinearMap::empty(self.dim(), parameters.len());
        let mut k = p;
        for x in parameters {
            k = self.locate_near(x, k)?;
            map.push(k - p, |weights| {
                let start = weights.len();
                weights.resize(start + p + 1, T::zero());
                blossom(self.knots(), k, k, |_| x, &mut weights[start..]);
            });
        }
        Ok(map)
    }

    /// The weights, in the first `p` places, of the legs `c_{i+1} - c_i` in the first derivative on span `k`, for a degree
    /// of 1 up to that of [`small_weights`].
    #[inline]
    pub(crate) fn leg_weights(&self, k: usize, x: &T) -> [T; SMALL] {
        let (p, t) = (self.degree(), self.knots());
        let mut weights = small_weights(t, k, p - 1, x);
        for (j, w) in weights[..p].iter_mut().enumerate() {
            *w *= T::int(p as i64) / (t[k + 1 + j].clone() - &t[k + 1 + j - p]);
        }
        weights
    }

    /// The weights of the value at `x` of the polynomial of span `k`.
    pub(crate) fn basis_on(&self, k: usize, x: &T) -> Functional<T> {
        let p = self.degree();
        let mut weights = vec![T::zero(); p + 1];
        blossom(self.knots(), k, k, |_| x, &mut weights);
        Functional::new(k - p, weights)
    }

    /// The derivatives of order `0 ..= order` at `x` as functionals, from the right; those beyond the degree are
    /// zero. At the end of the domain they are the left ones.
    ///
    /// Computes what [NURBS, A2.3] does.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::DegreeTooHigh`] for an order beyond [`MAX_DEGREE`](crate::limits::MAX_DEGREE).
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let parabola = SplineSpace::bezier(2, 0.0, 1.0)?;
    /// let rows = parabola.basis_derivatives(&0.0, 2)?;
    /// assert_eq!(rows[1].weights(), [-2.0, 2.0, 0.0]);
    /// assert_eq!(rows[2].weights(), [2.0, -4.0, 2.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn basis_derivatives(&self, x: &T, order: usize) -> Result<Vec<Functional<T>>> {
        check_degree(order)?;
        let k = self.locate(x)?;
        Ok((0..=order).map(|d| self.derivative_on(k, x, d)).collect())
    }

    /// The derivative of order `order` at `x` as a functional, as [`basis_derivatives`](Self::basis_derivatives).
    ///
    /// # Errors
    /// As [`basis_derivatives`](Self::basis_derivatives).
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let slope = SplineSpace::bezier(2, 0.0, 1.0)?.basis_derivative(&0.0, 1)?;
    /// assert_eq!(slope.weights(), [-2.0, 2.0, 0.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn basis_derivative(&self, x: &T, order: usize) -> Result<Functional<T>> {
        check_degree(order)?;
        Ok(self.derivative_on(self.locate(x)?, x, order))
    }

    /// The derivative of order `d` at `x` of the polynomial of span `k`: `p! / (p - d)!` times the polar value at
    /// `p - d` arguments `x` and `d` unit directions.
    pub(crate) fn derivative_on(&self, k: usize, x: &T, d: usize) -> Functional<T> {
        let p = self.degree();
        if d > p {
            return Functional::new(k - p, vec![T::zero(); p + 1]);
        }
        let mut weights = Vec::with_capacity(p + 1);
        weights.resize(p - d + 1, T::zero());
        blossom(self.knots(), k, k, |_| x, &mut weights);
        (0..d).for_each(|_| differentiate(self.knots(), k, k, &mut weights));
        let factor = (p - d + 1..=p).fold(T::one(), |product, i| product * T::int(i as i64));
        weights.iter_mut().for_each(|w| *w *= &factor);
        Functional::new(k - p, weights)
    }

    /// The polar value of span `k` at `args`: the symmetric `F` that is affine in each of its `p` arguments and has
    /// `F(x, ..., x)` equal to the spline at `x` on that span.
    ///
    /// The order of `args` does not matter, and they need not lie in the domain.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there are `p` arguments, [`Error::NotFinite`],
    /// [`Error::EmptySpan`] if `k` is not a non-empty span of the domain.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// // x² has the polar form F(s, t) = s t and the coefficients F(0, 0), F(0, 2), F(2, 2).
    /// let space = SplineSpace::bezier(2, 0.0, 2.0)?;
    /// assert_eq!(space.polar(2, &[1.0, 3.0])?.apply(&[0.0, 0.0, 4.0]), 3.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn polar(&self, k: usize, args: &[T]) -> Result<Functional<T>> {
        let p = self.degree();
        if args.len() != p {
            return Err(Error::CoefficientCount { expected: p, found: args.len() });
        }
        if let Some(index) = args.iter().position(|x| !x.is_finite()) {
            return Err(Error::NotFinite { what: "argument", index });
        }
        let t = self.knots();
        if !(p..self.unrolled_dim()).contains(&k) || t[k] == t[k + 1] {
            return Err(Error::EmptySpan { span: k });
        }
        let mut sorted: Vec<&T> = args.iter().collect();
        sorted.sort_by(|x, y| x.partial_cmp(y).expect("finite arguments are ordered"));
        let mut weights = Vec::new();
        let first = self.polar_into(k, &sorted, &mut Vec::new(), &mut weights);
        Ok(Functional::new(first, weights))
    }

    /// Hands out the Bernstein coefficients of span `k`, in order: each as the first index among the `p + 1` coefficients of the
    /// span that has a weight, and the weights.
    pub(crate) fn each_bernstein(&self, k: usize, mut coefficient: impl FnMut(usize, &[T])) {
        let (p, t) = (self.degree(), self.knots());
        let (mut args, mut free, mut weights) = (Vec::with_capacity(p), Vec::with_capacity(p), Vec::new());
        for j in 0..=p {
            args.clear();
            args.extend(repeat_n(&t[k], p - j).chain(repeat_n(&t[k + 1], j)));
            weights.clear();
            let first = self.polar_into(k, &args, &mut free, &mut weights);
            coefficient(first + p - k, &weights);
        }
    }

    /// Appends the weights of the polar value of span `k` at sorted `args`; returns the first index. `free` is
    /// scratch.
    pub(crate) fn polar_into<'a>(
        &self,
        k: usize,
        args: &[&'a T],
        free: &mut Vec<&'a T>,
        weights: &mut Vec<T>,
    ) -> usize {
        let (lo, hi) = take_run(self.knots(), k, args, free);
        let start = weights.len();
        weights.resize(start + free.len() + 1, T::zero());
        blossom(self.knots(), lo, hi, |r| free[r], &mut weights[start..]);
        hi - self.degree()
    }
}
