//! The same spline run through backwards.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::map::LinearMap;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;

impl<T: Scalar> SplineSpace<T> {
    /// The space of the splines `x -> f(a + b - x)` on the same domain `[a, b]`.
    ///
    /// In `f64` the knots inside are rounded, so that reversing twice may not give the very same knots.
    ///
    /// # Errors
    /// Those of [`new`](Self::new) if rounding makes distinct knots coincide.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let space = SplineSpace::clamped(1, [0.0, 1.0, 4.0])?;
    /// assert_eq!(space.reversed()?, SplineSpace::clamped(1, [0.0, 3.0, 4.0])?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn reversed(&self) -> Result<Self> {
        let (a, b) = self.domain();
        // The ends change places without rounding.
        let mirror = |t: &T| {
            if t == a {
                b.clone()
            } else if t == b {
                a.clone()
            } else {
                a.clone() + b - t
            }
        };
        if self.is_periodic() {
            let mut round: Vec<(T, usize)> =
                self.breaks()[1..].iter().map(|(t, m)| (mirror(t), *m)).collect();
            round.reverse();
            return Self::from_round(self.degree(), &round, self.domain().1);
        }
        Self::new(self.degree(), self.knots().iter().rev().map(mirror))
    }

    /// The reversal as a map to the [`reversed`](Self::reversed) space: a permutation.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let space = SplineSpace::clamped(1, [0.0, 1.0, 4.0])?;
    /// assert_eq!(space.reversal().apply(&[1.0, 2.0, 3.0])?, [3.0, 2.0, 1.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn reversal(&self) -> LinearMap<T> {
        // The last unrolled coefficient that reaches into the domain; in an open space the last.
        let last = self.last_span();
        let mut map = LinearMap::empty(self.dim(), self.dim());
        (0..self.dim())
            .for_each(|i| map.push(self.slot(last + self.dim() - i), |weights| weights.push(T::one())));
        map
    }
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The spline `x -> f(a + b - x)` on the same domain `[a, b]`; coefficients in reverse order.
    ///
    /// # Errors
    /// As [`SplineSpace::reversed`].
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// let line = Function::monomial(1, 0.0, 2.0)?;
    /// assert_eq!(line.reversed()?.coeffs(), [2.0, 0.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn reversed(&self) -> Result<Self> {
        let coeffs = self.space().reversal().apply(self.coeffs())?;
        Spline::new(self.space().reversed()?, coeffs)
    }
}
