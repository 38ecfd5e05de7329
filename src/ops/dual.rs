//! Dual functionals: coefficients of a spline from its derivatives at one point, and the coefficients of powers.
//!
//! Coefficient `i` is the polar value at `t_{i+1}, ..., t_{i+p}`. About a point `ξ` of the support the polar form of
//! `(x - ξ)^r` is the mean of the products of `r` of the differences `t_{i+j} - ξ`, so that
//!
//! ```text
//! c_i = Σ_r μ_r f^(r)(ξ) / r!      μ_r = mean of the products of r of the t_{i+j} - ξ      [deBoor, ch. IX]
//! x^k:  c_i = mean of the products of k of the t_{i+j}
//! (y - x)^p = Σ_i ψ_i(y) N_i(x)    ψ_i(y) = (y - t_{i+1}) ... (y - t_{i+p})                (Marsden)
//! ```
//!
//! The means grow knot by knot in convex combinations: `μ_r` of `n` numbers is `(1 - r / n)` times that of the first
//! `n - 1` plus `r / n` times the last number times their `μ_{r-1}`.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::functional::weigh;
use crate::scalar::{Scalar, larger};
use crate::space::SplineSpace;
use crate::spline::Spline;

/// A coefficient of a spline as a functional of its derivatives at one point, `f -> Σ_r w_r f^(r)(ξ)`.
///
/// Of a function that is no spline of the space it is one that agrees on polynomials up to the degree near `ξ`.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct DualFunctional<T> {
    point: T,
    from_left: bool,
    weights: Vec<T>,
}

impl<T: Scalar> DualFunctional<T> {
    /// The point `ξ`.
    pub fn point(&self) -> &T {
        &self.point
    }

    /// Whether the derivatives are those from the left of the point.
    pub fn from_left(&self) -> bool {
        self.from_left
    }

    /// The weights of the derivatives of order `0 ..= p`.
    pub fn weights(&self) -> &[T] {
        &self.weights
    }

    /// The value on a function with these `derivatives` of order `0 ..= p` at the point.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there are `p + 1` derivatives; [`Error::NotFinite`] if the sum overflows.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// // The middle coefficient of exp on [0, 2], by its derivatives at 1.
    /// let middle = SplineSpace::bezier(2, 0.0, 2.0)?.dual_functional(1)?;
    /// let e = 1.0_f64.exp();
    /// assert_eq!((middle.point(), middle.apply(&[e, e, e])?), (&1.0, e / 2.0));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn apply<C: Coeff<T>>(&self, derivatives: &[C]) -> Result<C> {
        if derivatives.len() != self.weights.len() {
            return Err(Error::CoefficientCount { expected: self.weights.len(), found: derivatives.len() });
        }
        let value = weigh(0, &self.weights, derivatives);
        if value.all_finite() { Ok(value) } else { Err(Error::NotFinite { what: "coefficient", index: 0 }) }
    }

    /// The value on a spline of any space.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`] if the point is not in the domain of `f`; [`Error::NotFinite`] on overflow of derivatives, as
    /// in very high degrees.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let cubics = SplineSpace::clamped(3, [0.0, 1.0, 2.0])?;
    /// let f = Function::new(cubics.clone(), vec![1.0, 2.0, 4.0, 0.0, 3.0])?;
    /// assert_eq!(cubics.dual_functional(2)?.of(&f)?, 4.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn of<C: Coeff<T>>(&self, f: &Spline<T, C>) -> Result<C> {
        let space = f.space();
        let k = if self.from_left { space.locate_left(&self.point)? } else { space.locate(&self.point)? };
        self.apply(&f.derivatives_on(k, &self.point, self.weights.len() - 1))
    }
}

impl<T: Scalar> SplineSpace<T> {
    /// Coefficient `i` as a functional of derivatives at one point: at the Greville abscissa, where the first derivative
    /// has no weight, or where that is outside at the nearest end of the domain.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`].
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let dual = SplineSpace::bezier(2, 0.0, 2.0)?.dual_functional(1)?;
    /// assert_eq!((dual.point(), dual.weights()), (&1.0, &[1.0, 0.0, -0.5][..]));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn dual_functional(&self, i: usize) -> Result<DualFunctional<T>> {
        if i >= self.dim() {
            return Err(Error::IndexOutOfRange { index: i, length: self.dim() });
        }
        let (t, p, (a, b)) = (self.knots(), self.degree(), self.domain());
        let inside = |x: &T| a <= x && x <= b;
        // In a ring the same coefficient comes again a period later.
        let turns = (i..self.unrolled_dim()).step_by(self.dim()).map(|j| (j, self.greville_of(j)));
        let first = (i, self.greville_of(i));
        let (j, mean) = turns.into_iter().find(|(_, x)| inside(x)).unwrap_or(first);
        let point = if inside(&mean) { mean } else { larger(a, if mean < *b { &mean } else { b }).clone() };
        let from_left = self.locate(&point)? > j + p;
        let differences: Vec<T> = t[j + 1..=j + p].iter().map(|t| t.clone() - &point).collect();
        let mut weights = symmetric_means(&differences, p);
        let mut factorial = T::one();
        for (r, w) in weights.iter_mut().enumerate().skip(1) {
            factorial *= T::int(r as i64);
            *w /= &factorial;
        }
        Ok(DualFunctional { point, from_left, weights })
    }

    /// The coefficients of `x^k`.
    ///
    /// # Errors
    /// [`Error::DegreeTooLow`] for `k > p`; [`Error::NotPeriodic`] for `k > 0` in a periodic space, which holds no
    /// polynomials but constants.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let space = SplineSpace::clamped(2, [0.0, 1.0, 3.0])?;
    /// assert_eq!(space.monomial_coeffs(1)?, space.greville());
    /// assert_eq!(space.monomial_coeffs(2)?, [0.0, 0.0, 3.0, 9.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn monomial_coeffs(&self, k: usize) -> Result<Vec<T>> {
        let (t, p) = (self.knots(), self.degree());
        if k > p {
            return Err(Error::DegreeTooLow { degree: p, needed: k });
        }
        if k > 0 && self.is_periodic() {
            return Err(Error::NotPeriodic);
        }
        let coeff = |i: usize| symmetric_means(&t[i + 1..=i + p], k).swap_remove(k);
        Ok((0..self.dim()).map(coeff).collect())
    }

    /// The coefficients `(y - t_{i+1}) ... (y - t_{i+p})` of the function `(y - x)^p` of `x` (Marsden's identity).
    ///
    /// # Errors
    /// [`Error::NotPeriodic`] for a periodic space of positive degree; [`Error::NotFinite`] if `y` is not a number.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// assert_eq!(SplineSpace::clamped(2, [0.0, 1.0, 3.0])?.marsden_coeffs(&3.0)?, [9.0, 6.0, 0.0, 0.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn marsden_coeffs(&self, y: &T) -> Result<Vec<T>> {
        let (t, p) = (self.knots(), self.degree());
        if !y.is_finite() {
            return Err(Error::NotFinite { what: "parameter", index: 0 });
        }
        if p > 0 && self.is_periodic() {
            return Err(Error::NotPeriodic);
        }
        let coeff = |i: usize| t[i + 1..=i + p].iter().fold(T::one(), |product, t| product * (y.clone() - t));
        Ok((0..self.dim()).map(coeff).collect())
    }

    /// The Greville abscissa of unrolled coefficient `j`.
    fn greville_of(&self, j: usize) -> T {
        let (t, p) = (self.knots(), self.degree());
        if p == 0 {
            return t[j].clone() + (t[j + 1].clone() - &t[j]) / T::int(2);
        }
        let rises = t[j + 1..=j + p].iter().fold(T::zero(), |sum, x| sum + (x.clone() - &t[j + 1]));
        t[j + 1].clone() + rises / T::int(p as i64)
    }
}

/// The means of the products of `0, ..., k` of the numbers, of which there are at least `k`.
fn symmetric_means<T: Scalar>(numbers: &[T], k: usize) -> Vec<T> {
    let mut means = vec![T::zero(); k + 1];
    means[0] = T::one();
    for (n, x) in (1..).zip(numbers) {
        for r in (1..=k.min(n)).rev() {
            let [kept, taken] = [n - r, r].map(|count| T::frac(count as i64, n as i64));
            means[r] = kept * &means[r] + taken * x * &means[r - 1];
        }
    }
    means
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;

    #[test]
    fn means_of_products() {
        let numbers = [2, 3, 5].map(Q::int);
        let expected = [Q::int(1), Q::frac(10, 3), Q::frac(31, 3), Q::int(30)];
        assert_eq!(symmetric_means(&numbers, 3), expected);
        assert_eq!(symmetric_means(&numbers, 1), expected[..2]);
    }

    #[test]
    fn a_jump_is_seen_from_its_own_side() {
        let space = SplineSpace::clamped(1, [0.0, 1.0, 1.0, 2.0]).unwrap();
        let torn = Spline::new(space.clone(), vec![0.0, 3.0, 5.0, 0.0]).unwrap();
        let [left, right] = [1, 2].map(|i| space.dual_functional(i).unwrap());
        assert_eq!((left.point(), right.point()), (&1.0, &1.0));
        assert_eq!((left.of(&torn).unwrap(), right.of(&torn).unwrap()), (3.0, 5.0));
    }

    #[test]
    fn derivatives_beyond_all_numbers_are_refused() {
        let space = SplineSpace::bezier(512, 0.0, 1.0).unwrap();
        let wild = Spline::new(space.clone(), (0..513).map(|i| f64::from(i % 7)).collect()).unwrap();
        let lost = space.dual_functional(200).unwrap().of(&wild);
        assert_eq!(lost, Err(Error::NotFinite { what: "coefficient", index: 0 }));
    }

    #[test]
    fn what_a_space_does_not_hold_is_refused() {
        let ring = SplineSpace::uniform_periodic(2, 4, 0.0, 1.0).unwrap();
        assert_eq!(ring.monomial_coeffs(0).unwrap(), [1.0; 4]);
        assert_eq!(ring.monomial_coeffs(1), Err(Error::NotPeriodic));
        assert_eq!(ring.marsden_coeffs(&0.0), Err(Error::NotPeriodic));
        assert_eq!(ring.monomial_coeffs(3), Err(Error::DegreeTooLow { degree: 2, needed: 3 }));
        assert_eq!(ring.dual_functional(4), Err(Error::IndexOutOfRange { index: 4, length: 4 }));
    }
}
