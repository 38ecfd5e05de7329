//! Values at many parameters.
//!
//! Parameters that follow each other in one span share the search for it, and long runs share its Bernstein
//! coefficients as well: then a value costs one division. All weights are positive, so that it is as accurate as a
//! value by itself.

use crate::bernstein::binomials;
use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::functional::weigh;
use crate::polar::blossom;
use crate::scalar::Scalar;
use crate::spline::Spline;
use std::hint::select_unpredictable;

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The values at many parameters in any order; runs of parameters in one span share its preparation, so
    /// sorted parameters are fastest.
    ///
    /// In `f64` a value in a long run may differ from [`at`](Self::at) by a few roundings of the largest coefficient
    /// under the span. Nothing is allocated for a value.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let identity = Function::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![0.0, 1.0])?;
    /// assert_eq!(identity.eval(&[0.0, 0.25, 1.0])?, [0.0, 0.25, 1.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn eval(&self, parameters: &[T]) -> Result<Vec<C>> {
        let mut values = Vec::with_capacity(parameters.len());
        self.for_each_value(parameters, |value| values.push(value))?;
        Ok(values)
    }

    /// As [`eval`](Self::eval), into memory at hand. On an error `values` may be partly overwritten.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::CoefficientCount`] if the lengths differ.
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// let mut values = [0.0; 2];
    /// Function::monomial(2, 0.0, 4.0)?.eval_into(&[1.0, 3.0], &mut values)?;
    /// assert_eq!(values, [1.0, 9.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn eval_into(&self, parameters: &[T], values: &mut [C]) -> Result<()> {
        if parameters.len() != values.len() {
            return Err(Error::CoefficientCount { expected: parameters.len(), found: values.len() });
        }
        let mut places = values.iter_mut();
        self.for_each_value(parameters, |value| *places.next().expect("one place a parameter") = value)
    }

    /// Calls `take` with the value at each parameter in turn.
    fn for_each_value(&self, parameters: &[T], mut take: impl FnMut(C)) -> Result<()> {
        let t = self.space().knots();
        let (mut k, mut rest) = (self.degree(), parameters);
        while let Some((x, others)) = rest.split_first() {
            k = self.space().locate_near(x, k)?;
            // Which of the comparisons fails is a coin toss for random parameters: no branch between them.
            let stays = |x: &&T| **x < *select_unpredictable(t[k] <= **x, &t[k + 1], *x);
            let (run, after) = rest.split_at(1 + others.iter().take_while(stays).count());
            rest = after;
            match self.degree() {
                p if T::EXACT || run.len() <= 3 * p => run.iter().for_each(|x| take(self.on_span(k, x))),
                1 => self.on_run_of_order::<2>(k, run, &mut take),
                2 => self.on_run_of_order::<3>(k, run, &mut take),
                3 => self.on_run_of_order::<4>(k, run, &mut take),
                4 => self.on_run_of_order::<5>(k, run, &mut take),
                5 => self.on_run_of_order::<6>(k, run, &mut take),
                _ => run.iter().for_each(|x| take(self.on_span(k, x))),
            }
        }
        Ok(())
    }

    /// The values at many parameters of span `k`, by its `ORDER = p + 1` Bernstein coefficients.
    fn on_run_of_order<const ORDER: usize>(&self, k: usize, run: &[T], take: &mut impl FnMut(C)) {
        let (p, t) = (ORDER - 1, self.space().knots());
        let (a, b) = (&t[k], &t[k + 1]);
        let width = b.clone() - a;
        let bernstein: [C; ORDER] = std::array::from_fn(|i| {
            let mut weights: [T; ORDER] = std::array::from_fn(|_| T::zero());
            blossom(t, k, k, |r| if r < i { b } else { a }, &mut weights);
            weigh(k - p, &weights, self.coeffs())
        });
        let binomials = binomials::<T>(p);
        for x in run {
            let u = (x.clone() - a) / &width;
            let v = (b.clone() - x) / &width;
            let mut weights: [T; ORDER] = std::array::from_fn(|i| binomials[i].clone());
            let (mut us, mut vs) = (T::one(), T::one());
            for i in 1..ORDER {
                us *= &u;
                vs *= &v;
                weights[i] *= &us;
                weights[p - i] *= &vs;
            }
            take(weigh(0, &weights, &bernstein));
        }
    }
}
