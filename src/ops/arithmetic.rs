//! Sums, differences and multiples.
//!
//! Two splines of different spaces are first written in the union of the spaces; there coefficients add.

use crate::coeff::{Coeff, check_pair};
use crate::error::Result;
use crate::ops::signs::signs;
use crate::scalar::Scalar;
use crate::spline::Spline;

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The sum `self + other`, in the [union](crate::SplineSpace::union) of the spaces.
    ///
    /// # Errors
    /// [`DomainMismatch`](crate::Error::DomainMismatch); [`Ragged`](crate::Error::Ragged) if coefficients are rows of another
    /// length; [`NotFinite`](crate::Error::NotFinite) on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let line = Function::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![0.0, 2.0])?;
    /// let step = Function::new(SplineSpace::clamped(0, [0.0, 0.5, 1.0])?, vec![0.0, 1.0])?;
    /// let sum = line.sum(&step)?;
    /// assert_eq!((sum.at_left(&0.5)?, sum.at(&0.5)?), (1.0, 2.0));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn sum(&self, other: &Self) -> Result<Self> {
        self.plus_scaled(&T::one(), other)
    }

    /// The difference `self - other`.
    ///
    /// # Errors
    /// As [`sum`](Self::sum).
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// let [f, g] = [Function::monomial(1, 0.0, 1.0)?, Function::monomial(2, 0.0, 1.0)?];
    /// assert_eq!(f.difference(&g)?.coeffs(), [0.0, 0.5, 0.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn difference(&self, other: &Self) -> Result<Self> {
        self.plus_scaled(&-T::one(), other)
    }

    /// The combination `self + weight * other`.
    ///
    /// # Errors
    /// As [`sum`](Self::sum).
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// let [f, g] = [Function::monomial(1, 0.0, 1.0)?, Function::monomial(2, 0.0, 1.0)?];
    /// assert_eq!(f.plus_scaled(&3.0, &g)?.at(&1.0)?, 4.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn plus_scaled(&self, weight: &T, other: &Self) -> Result<Self> {
        check_pair(&self.coeffs()[0], &other.coeffs()[0])?;
        self.paired_by(other, |c, d| c.plus_scaled(weight, d))
    }

    /// Coefficients paired in the union of the spaces.
    pub(crate) fn paired_by<A: Coeff<T>, B: Coeff<T>>(
        &self,
        other: &Spline<T, A>,
        pair: impl Fn(&C, &A) -> B,
    ) -> Result<Spline<T, B>> {
        let space = self.space().union(other.space())?;
        let (f, g) = (self.embedded(&space)?, other.embedded(&space)?);
        Spline::new(space, f.coeffs().iter().zip(g.coeffs()).map(|(c, d)| pair(c, d)).collect())
    }

    /// The multiple `factor * self`.
    ///
    /// # Errors
    /// [`NotFinite`](crate::Error::NotFinite) if the factor is not finite or a coefficient overflows.
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// assert_eq!(Function::monomial(1, 0.0, 1.0)?.scaled(&3.0)?.coeffs(), [0.0, 3.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn scaled(&self, factor: &T) -> Result<Self> {
        self.map_coeffs(|c| c.scaled(factor))
    }

    /// The spline plus a constant.
    ///
    /// # Errors
    /// [`NotFinite`](crate::Error::NotFinite) as for [`scaled`](Self::scaled); [`Ragged`](crate::Error::Ragged) as for
    /// [`sum`](Self::sum).
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// assert_eq!(Function::monomial(1, 0.0, 1.0)?.translated(&5.0)?.coeffs(), [5.0, 6.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn translated(&self, by: &C) -> Result<Self> {
        check_pair(&self.coeffs()[0], by)?;
        self.map_coeffs(|c| c.plus_scaled(&T::one(), by))
    }

    /// Whether both describe the same function, in whatever spaces.
    ///
    /// Over `f64` rounding usually makes this false where it would be true exactly.
    ///
    /// # Errors
    /// As [`sum`](Self::sum).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, Scalar, SplineSpace};
    /// let line = Function::new(SplineSpace::bezier(1, Q::int(0), Q::int(1))?, vec![Q::int(0), Q::frac(1, 3)])?;
    /// assert_ne!(line, line.elevated(1)?);
    /// assert!(line.same_function(&line.elevated(1)?)?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn same_function(&self, other: &Self) -> Result<bool> {
        Ok(self.difference(other)?.coeffs().iter().all(C::vanishes))
    }
}

signs!([T: Scalar, C: Coeff<T>] Spline<T, C>, T);

#[cfg(test)]
mod tests {
    use crate::spline::Function;

    #[test]
    fn signs_take_values_and_references() {
        let f = Function::monomial(1, 0.0, 1.0).unwrap();
        let g = Function::monomial(2, 0.0, 1.0).unwrap();
        let (sum, difference) = (&f + &g, &f - &g);
        assert_eq!((f.clone() + g.clone(), f.clone() + &g, &f + g.clone()), (sum.clone(), sum.clone(), sum));
        assert_eq!(f.clone() - g.clone(), difference);
        assert_eq!(-(f.clone() - &g), &g - f.clone());
        assert_eq!(f.clone() * 2.0, &f + &f);
    }

    #[test]
    #[should_panic(expected = "the domains [0, 1] and [0, 2] differ")]
    fn signs_panic_with_the_text_of_the_error() {
        let [f, g] = [1.0, 2.0].map(|b| Function::monomial(1, 0.0, b).unwrap());
        let _ = f + g;
    }
}
