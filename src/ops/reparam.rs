//! Affine changes of the parameter.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;
use std::cmp::Ordering;

impl<T: Scalar> SplineSpace<T> {
    /// The space on the domain `[start, end]`, its knots moved by the affine map between the domains.
    ///
    /// # Errors
    /// [`Error::EmptyDomain`] unless `start < end`, [`Error::NotFinite`];
    /// [`Error::Multiplicity`] if rounding makes distinct knots coincide.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let space = SplineSpace::clamped(1, [0.0, 1.0, 4.0])?.reparametrised(&0.0, &1.0)?;
    /// assert_eq!(space, SplineSpace::clamped(1, [0.0, 0.25, 1.0])?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn reparametrised(&self, start: &T, end: &T) -> Result<Self> {
        if start.partial_cmp(end) != Some(Ordering::Less) {
            return Err(Error::EmptyDomain { start: start.to_string(), end: end.to_string() });
        }
        let (a, b) = self.domain();
        let (from, to) = (self.length(), end.clone() - start);
        // The ends go to the ends without rounding.
        let moved = |t: &T| {
            if t == a {
                start.clone()
            } else if t == b {
                end.clone()
            } else {
                start.clone() + (t.clone() - a) * &to / &from
            }
        };
        if self.is_periodic() {
            let round: Vec<(T, usize)> = self.round().iter().map(|(t, m)| (moved(t), *m)).collect();
            return Self::from_round(self.degree(), &round, end);
        }
        Self::new(self.degree(), self.knots().iter().map(moved))
    }
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The same spline over the domain `[start, end]`: derivatives of order `d` are divided by the `d`-th power of
    /// the ratio of lengths.
    ///
    /// # Errors
    /// As [`SplineSpace::reparametrised`].
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// let line = Function::monomial(1, 0.0, 2.0)?.reparametrised(&0.0, &1.0)?;
    /// assert_eq!(line.at(&0.5)?, 1.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn reparametrised(&self, start: &T, end: &T) -> Result<Self> {
        Spline::new(self.space().reparametrised(start, end)?, self.coeffs().to_vec())
    }
}
