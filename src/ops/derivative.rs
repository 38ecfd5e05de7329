//! Derivatives as splines.
//!
//! ```text
//! c'_i = p (c_{i+1} - c_i) / (t_{i+p+1} - t_{i+1})          [NURBS, section 3.3]
//! ```
//! in degree `p - 1` over the knots without the first and the last. A knot of `p + 1` copies is a jump: a spline
//! there has no derivative among the splines, and the operator says so.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::map::LinearMap;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;

impl<T: Scalar> SplineSpace<T> {
    /// The space of the derivatives: one degree lower, the same knots inside.
    ///
    /// Of degree 0 and one open span, the space itself (its derivatives are zero).
    ///
    /// # Errors
    /// [`Error::Discontinuous`] at a knot of `p + 1` copies.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let cubic = SplineSpace::clamped(3, [0.0, 1.0, 2.0])?;
    /// assert_eq!(cubic.derivative_space()?, SplineSpace::clamped(2, [0.0, 1.0, 2.0])?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn derivative_space(&self) -> Result<Self> {
        let (p, t) = (self.degree(), self.knots());
        // Knots that count inside: in a ring all of a period.
        let inside = if self.is_periodic() { self.round_knots() } else { &t[p + 1..=self.last_span()] };
        if let Some(run) = inside.windows(p + 1).find(|run| run[0] == run[p]) {
            return Err(Error::Discontinuous { knot: run[0].to_string() });
        }
        if p == 0 {
            return Ok(self.clone());
        }
        if self.is_periodic() {
            return Self::from_round(p - 1, &self.round(), self.domain().1);
        }
        Self::new(p - 1, t[1..t.len() - 1].iter().cloned())
    }

    /// The derivative as a map from this space to its [`derivative_space`](Self::derivative_space).
    ///
    /// # Errors
    /// [`Error::Discontinuous`].
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let map = SplineSpace::clamped(1, [0.0, 1.0, 3.0])?.differentiation()?;
    /// assert_eq!(map.apply(&[0.0, 1.0, 5.0])?, [1.0, 2.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn differentiation(&self) -> Result<LinearMap<T>> {
        let (p, target) = (self.degree(), self.derivative_space()?);
        let mut map = LinearMap::empty(self.dim(), target.dim());
        for i in 0..target.dim() {
            if p == 0 {
                map.push(0, |weights| weights.push(T::zero()));
                continue;
            }
            let slope = self.slope(i);
            map.push(i, |weights| weights.extend([-slope.clone(), slope]));
        }
        Ok(map)
    }

    /// `p / (t_{i+p+1} - t_{i+1})`, by which leg `i` of the control polygon is stretched.
    fn slope(&self, i: usize) -> T {
        let (t, p) = (self.knots(), self.degree());
        T::int(p as i64) / (t[i + p + 1].clone() - &t[i + 1])
    }
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The derivative.
    ///
    /// # Errors
    /// [`Error::Discontinuous`] if a knot inside has `p + 1` copies, whether or not the values there agree;
    /// [`Error::NotFinite`] on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, Function, SplineSpace};
    /// let square = Function::new(SplineSpace::bezier(2, 0.0, 1.0)?, vec![0.0, 0.0, 1.0])?;
    /// assert_eq!(square.derivative()?.coeffs(), [0.0, 2.0]);
    /// let step = Function::new(SplineSpace::clamped(0, [0.0, 1.0, 2.0])?, vec![3.0, 5.0])?;
    /// assert_eq!(step.derivative().unwrap_err(), Error::Discontinuous { knot: "1".into() });
    /// # Ok::<(), Error>(())
    /// ```
    pub fn derivative(&self) -> Result<Self> {
        let (p, target) = (self.degree(), self.space().derivative_space()?);
        if p == 0 {
            return Spline::new(target, self.coeffs().iter().map(C::zero_like).collect());
        }
        let (t, degree) = (self.space().knots(), T::int(p as i64));
        // The last coefficient meets the first one in a ring, where the derivative has as many.
        let (first, last) = (&self.coeffs()[0], &self.coeffs()[self.coeffs().len() - 1]);
        let seam = [last.clone(), first.clone()];
        let legs = self.coeffs().windows(2).chain(seam.windows(2)).map(|ends| ends[1].minus(&ends[0]));
        let lengths = t[p + 1..].iter().zip(&t[1..]).map(|(end, start)| end.clone() - start);
        let mut coeffs = Vec::with_capacity(target.dim());
        coeffs.extend(legs.zip(lengths).take(target.dim()).map(|(mut leg, length)| {
            leg.scale(&(degree.clone() / length));
            leg
        }));
        Spline::new(target, coeffs)
    }

    /// The derivative of order `order`; of order 0 the spline itself.
    ///
    /// # Errors
    /// As [`derivative`](Self::derivative): beyond the degree only a spline of one open span has derivatives, which are
    /// zero. [`derivatives_at`](Self::derivatives_at) gives zeros in any case.
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// assert_eq!(Function::monomial(3, 0.0, 1.0)?.nth_derivative(3)?.coeffs(), [6.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn nth_derivative(&self, order: usize) -> Result<Self> {
        // Further ones are those of zero.
        (0..order.min(self.space().degree() + 1)).try_fold(self.clone(), |f, _| f.derivative())
    }
}
