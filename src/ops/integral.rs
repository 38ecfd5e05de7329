//! Antiderivatives and definite integrals.
//!
//! ```text
//! d_0 = 0,   d_{i+1} = d_i + c_i (t_{i+p+1} - t_i) / (p + 1)          [deBoor, p. 128]
//! ```
//! in degree `p + 1` over the knots with the first and the last repeated, then shifted to be zero at the start of
//! the domain. As a map this is dense; the method runs the sum instead.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::functional::Functional;
use crate::limits::check_degree;
use crate::limits::check_entries;
use crate::map::LinearMap;
use crate::polar::blossom;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;

impl<T: Scalar> SplineSpace<T> {
    /// The space of the antiderivatives: one degree higher, the same knots inside, so one order smoother.
    ///
    /// # Errors
    /// [`Error::DegreeTooHigh`].
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let steps = SplineSpace::clamped(0, [0.0, 1.0, 2.0])?;
    /// assert_eq!(steps.antiderivative_space()?, SplineSpace::clamped(1, [0.0, 1.0, 2.0])?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn antiderivative_space(&self) -> Result<Self> {
        check_degree(self.degree() + 1)?;
        if self.is_periodic() {
            return Self::from_round(self.degree() + 1, &self.round(), self.domain().1);
        }
        let t = self.knots();
        let (first, last) = (t[0].clone(), t[t.len() - 1].clone());
        Self::new(self.degree() + 1, [first].into_iter().chain(t.iter().cloned()).chain([last]))
    }

    /// The antiderivative as a map. Its rows are dense, `dim` squared weights in all: meant for spaces of few
    /// coefficients; [`Spline::antiderivative`] is linear.
    ///
    /// # Errors
    /// [`Error::NotPeriodic`] for a periodic space, which has no such map; [`Error::DegreeTooHigh`],
    /// [`Error::TooLarge`].
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let map = SplineSpace::bezier(1, 0.0, 2.0)?.antidifferentiation()?;
    /// assert_eq!(map.apply(&[0.0, 2.0])?, [0.0, 0.0, 2.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn antidifferentiation(&self) -> Result<LinearMap<T>> {
        if self.is_periodic() {
            return Err(Error::NotPeriodic);
        }
        let target = self.antiderivative_space()?;
        check_entries(target.dim(), self.dim())?;
        let mut sums = LinearMap::empty(self.dim(), target.dim());
        let before = self.integral_up_to(self.degree(), self.domain().0);
        for j in 0..target.dim() {
            let mass = |i: usize| if i < j { self.mass(i) } else { T::zero() };
            sums.push(0, |weights| weights.extend((0..self.dim()).map(|i| mass(i) - &before[i])));
        }
        Ok(sums)
    }

    /// The integral of unrolled basis function `i` over its whole support.
    pub(crate) fn mass(&self, i: usize) -> T {
        let (t, p) = (self.knots(), self.degree());
        (t[i + p + 1].clone() - &t[i]) / T::int(p as i64 + 1)
    }

    /// The integrals of the unrolled basis functions up to `x` in span `k`, from the start of their supports.
    ///
    /// With `M_j` the basis of degree `p + 1` over the same knots, `∫ N_i = mass(i) Σ_{j >= i} M_j(x)`.
    fn integral_up_to(&self, k: usize, x: &T) -> Vec<T> {
        let p = self.degree();
        let mut tails = vec![T::zero(); p + 2];
        blossom(self.knots(), k, k, |_| x, &mut tails);
        (0..=p).rev().for_each(|j| tails[j] = tails[j].clone() + &tails[j + 1]);
        // tails[l] = Σ_{j >= k-p-1+l} M_j(x), which is 1 for l = 0.
        let share = |i: usize| match (i + p + 1).checked_sub(k) {
            None | Some(0) => T::one(),
            Some(l) => tails.get(l).cloned().unwrap_or_else(T::zero),
        };
        (0..self.unrolled_dim()).map(|i| self.mass(i) * share(i)).collect()
    }

    /// The integral from `x` to `y` as a functional; negative if `y < x`.
    ///
    /// The coefficients on `[x, y]`, times what their basis functions weigh there: nothing cancels however short the
    /// interval is.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; in `f64` [`Error::SpanOutOfRange`] if `x` and `y` are hardly distinct.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let space = SplineSpace::clamped(1, [0.0, 1.0, 2.0])?;
    /// assert_eq!(space.integral_between(&0.0, &2.0)?.to_dense(3), [0.5, 1.0, 0.5]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn integral_between(&self, x: &T, y: &T) -> Result<Functional<T>> {
        self.locate(x)?;
        self.locate(y)?;
        if x == y {
            return Ok(Functional::new(0, []));
        }
        let (from, to, sign) = if x < y { (x, y, T::one()) } else { (y, x, -T::one()) };
        let part = self.restricted_space(from, to)?;
        let masses: Vec<T> = (0..part.dim()).map(|i| part.mass(i) * &sign).collect();
        if part == *self {
            return Ok(Functional::new(0, masses));
        }
        Ok(self.insertion_rows(&part).pull_back(&Functional::new(0, masses)))
    }
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The antiderivative `F(x) = ∫_a^x f`, zero at the start of the domain.
    ///
    /// Linear in the number of coefficients. Jumps of `f` become kinks of `F`.
    ///
    /// # Errors
    /// [`Error::NonZeroMean`] for a periodic spline whose integral over the period is not exactly zero: open it
    /// first with [`unclamped_ends`](Self::unclamped_ends), which over `f64` is nearly always needed.
    /// [`Error::NotFinite`] on overflow, [`Error::DegreeTooHigh`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let line = Function::new(SplineSpace::bezier(1, 0.0, 2.0)?, vec![0.0, 2.0])?;
    /// assert_eq!(line.antiderivative()?.coeffs(), [0.0, 0.0, 2.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn antiderivative(&self) -> Result<Self> {
        let (space, target) = (self.space(), self.space().antiderivative_space()?);
        let mut coeffs = Vec::with_capacity(target.dim() + 1);
        let (t, order) = (space.knots(), space.degree() + 1);
        let share = T::int(order as i64);
        let mut sum = self.coeffs()[0].zero_like();
        for (c, (before, after)) in self.coeffs().iter().zip(t.iter().zip(&t[order..])) {
            coeffs.push(sum.clone());
            sum.add_scaled(&((after.clone() - before) / &share), c);
        }
        if !space.is_periodic() {
            coeffs.push(sum);
        } else if !sum.vanishes() {
            let parts: Vec<String> = sum.components().map(T::to_string).collect();
            return Err(Error::NonZeroMean { integral: parts.join(", ") });
        }
        let raw = Spline::new(target, coeffs)?;
        if space.knots()[0] == *space.domain().0 && !space.is_periodic() {
            return Ok(raw);
        }
        let start = raw.at(raw.domain().0)?;
        raw.translated(&start.scaled(&-T::one()))
    }

    /// The integral over the domain.
    ///
    /// # Errors
    /// [`Error::NotFinite`] on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let hat = Function::new(SplineSpace::clamped(1, [0.0, 1.0, 2.0])?, vec![0.0, 1.0, 0.0])?;
    /// assert_eq!(hat.integral()?, 1.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn integral(&self) -> Result<C> {
        let (a, b) = self.domain();
        self.integral_between(a, b)
    }

    /// The integral from `x` to `y`; negative if `y < x`.
    ///
    /// # Errors
    /// As [`SplineSpace::integral_between`]; [`Error::NotFinite`] on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// let line = Function::monomial(1, 0.0, 2.0)?;
    /// assert_eq!((line.integral_between(&1.0, &2.0)?, line.integral_between(&2.0, &1.0)?), (1.5, -1.5));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn integral_between(&self, x: &T, y: &T) -> Result<C> {
        let integral = self.space().integral_between(x, y)?.apply(self.coeffs());
        if integral.all_finite() {
            Ok(integral)
        } else {
            Err(Error::NotFinite { what: "integral", index: 0 })
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::space::SplineSpace;
    use crate::spline::{Function, Spline};

    #[test]
    fn short_intervals_lose_no_digits() {
        let space = SplineSpace::clamped(3, [0.0, 1e6, 1e6 + 1e-3, 2e6]).unwrap();
        let one = Function::constant(space, 1.0).unwrap();
        for (x, y) in [(1e6, 1e6 + 1e-3), (5e5, 5e5 + 1e-10), (3.0, 1.5e6)] {
            assert!((one.integral_between(&x, &y).unwrap() / (y - x) - 1.0).abs() < 1e-15);
            assert!((one.integral_between(&y, &x).unwrap() / (y - x) + 1.0).abs() < 1e-15);
        }
        assert_eq!(one.integral_between(&7.0, &7.0).unwrap(), 0.0);
    }

    #[test]
    fn overflow_is_an_error() {
        let large = Spline::constant(SplineSpace::bezier(1, 0.0, 9.0).unwrap(), 1.7e308).unwrap();
        assert!(large.integral().is_err());
    }
}
