//! Rational splines.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::ops::sign::Sign;
use crate::rational::domain::{Domain, Interval, Rectangle};
use crate::scalar::Scalar;
use crate::weighted::Weighted;
use nalgebra::SVector;

/// A rational spline: the quotient of a spline and a scalar spline, `R = Σ w_i P_i N_i / Σ w_i N_i`.
///
/// It is kept as a spline of [`Weighted`] points, of one parameter or two. The denominator is positive on the whole
/// domain; that is proved when the value is made, from its coefficients or after bisections.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{NurbsCurve, Q, Scalar, SplineSpace};
/// // A quarter of the unit circle, exactly.
/// let points = [[1, 0], [1, 1], [0, 1]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
/// let space = SplineSpace::bezier(2, Q::int(0), Q::int(1))?;
/// let quarter = NurbsCurve::new(space, points.to_vec(), [1, 1, 2].map(Q::int).to_vec())?;
/// assert_eq!(quarter.at(&Q::frac(1, 2))?, vector![Q::frac(3, 5), Q::frac(4, 5)]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Rational<D: Domain<T>, T: Scalar, C: Coeff<T> = T> {
    lifted: D::Spline<Weighted<T, C>>,
}

/// A rational function of one parameter.
pub type RationalFunction<T> = Rational<Interval, T>;

/// A rational spline curve in `N` dimensions.
///
/// What takes polynomial curves only, fine tuning above all, takes the approximation that
/// [`polynomial_within`](Rational::polynomial_within) gives.
pub type NurbsCurve<T, const N: usize> = Rational<Interval, T, SVector<T, N>>;

/// A rational spline surface in `N` dimensions.
///
/// What takes polynomial surfaces only, fine tuning above all, takes the approximation that
/// [`polynomial_within`](Rational::polynomial_within) gives.
pub type NurbsSurface<T, const N: usize> = Rational<Rectangle, T, SVector<T, N>>;

impl<D: Domain<T>, T: Scalar, C: Coeff<T>> Rational<D, T, C> {
    /// The rational spline that `lifted` is in homogeneous coordinates.
    ///
    /// If the denominator is negative everywhere, the signs of numerator and denominator are changed. Coefficients of the
    /// denominator need not be positive as long as its values are.
    ///
    /// # Errors
    /// [`Error::Pole`] if the denominator vanishes or changes its sign; [`Error::Undecided`] if bisection does not tell
    /// (the denominator is very close to zero somewhere).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, RationalFunction, Spline, SplineSpace, Weighted};
    /// let space = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let ends = vec![Weighted { point: 1.0, weight: 1.0 }, Weighted { point: 1.0, weight: -1.0 }];
    /// assert_eq!(RationalFunction::from_lifted(Spline::new(space, ends)?).unwrap_err(), Error::Pole);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn from_lifted(lifted: D::Spline<Weighted<T, C>>) -> Result<Self> {
        let positive = D::coeffs(&lifted).iter().all(|c| c.weight > T::zero());
        if positive {
            return Ok(Self { lifted });
        }
        match D::sign(&denominator::<D, T, C>(&lifted)?)? {
            Sign::Positive => Ok(Self { lifted }),
            Sign::Negative => Ok(Self { lifted: D::map_coeffs(&lifted, |c| c.scaled(&-T::one()))? }),
        }
    }

    /// The quotient of two splines.
    ///
    /// # Errors
    /// As [`from_lifted`](Self::from_lifted); [`Error::DomainMismatch`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, RationalFunction};
    /// let (one, x) = (Function::monomial(0, 1.0, 2.0)?, Function::monomial(1, 1.0, 2.0)?);
    /// assert_eq!(RationalFunction::from_quotient(&one, &x)?.at(&2.0)?, 0.5);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn from_quotient(numerator: &D::Spline<C>, denominator: &D::Spline<T>) -> Result<Self> {
        let pair = |point: &C, weight: &T| Weighted { point: point.clone(), weight: weight.clone() };
        Self::from_lifted(D::paired(numerator, denominator, pair)?)
    }

    /// A spline as a rational one: all weights are one.
    ///
    /// # Errors
    /// None for a valid spline.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, RationalFunction};
    /// let x = RationalFunction::from_polynomial(&Function::monomial(1, 0.0, 1.0)?)?;
    /// assert_eq!(x.at(&0.25)?, 0.25);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn from_polynomial(spline: &D::Spline<C>) -> Result<Self> {
        let lift = |point: &C| Weighted { point: point.clone(), weight: T::one() };
        Ok(Self { lifted: D::map_coeffs(spline, lift)? })
    }

    /// The rational spline that `lifted` is, whose denominator is positive for a reason; over floating point that is seen to,
    /// since it may vanish by rounding.
    pub(crate) fn known(lifted: D::Spline<Weighted<T, C>>) -> Result<Self> {
        if T::EXACT { Ok(Self { lifted }) } else { Self::from_lifted(lifted) }
    }

    /// The rational spline that is `lifted`, if all weights are positive.
    pub(crate) fn weighing(lifted: D::Spline<Weighted<T, C>>) -> Result<Self> {
        let weighed = Self { lifted };
        weighed.check_weights().map(|()| weighed)
    }

    /// Checks that all weights are positive, not only the denominator.
    pub(crate) fn check_weights(&self) -> Result<()> {
        match self.weights().enumerate().find(|(_, weight)| **weight <= T::zero()) {
            Some((index, weight)) => Err(Error::Weight { index, weight: weight.to_string() }),
            None => Ok(()),
        }
    }

    /// The spline of weighted points.
    #[inline]
    pub fn lifted(&self) -> &D::Spline<Weighted<T, C>> {
        &self.lifted
    }

    /// Puts weighted points in the place of others. That the denominator stays positive is for the caller to see to.
    pub(crate) fn replace_points(&mut self, new: Vec<(usize, Weighted<T, C>)>) -> Result<()> {
        D::replace_coeffs(&mut self.lifted, new)
    }

    /// The spline of weighted points, moved out.
    pub fn into_lifted(self) -> D::Spline<Weighted<T, C>> {
        self.lifted
    }

    /// The rational spline after `operator`, any linear operator of polynomial splines.
    ///
    /// # Errors
    /// Those of `operator`, and of [`from_lifted`](Self::from_lifted).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, RationalFunction, Scalar};
    /// let [one, x] = [0, 1].map(|power| Function::monomial(power, Q::int(1), Q::int(2)));
    /// let inverse = RationalFunction::from_quotient(&one?, &x?)?;
    /// let raised = inverse.through(|lifted| lifted.elevated(2))?;
    /// assert_eq!(raised.at(&Q::frac(3, 2))?, Q::frac(2, 3));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn through(
        &self,
        operator: impl FnOnce(&D::Spline<Weighted<T, C>>) -> Result<D::Spline<Weighted<T, C>>>,
    ) -> Result<Self> {
        Self::from_lifted(operator(&self.lifted)?)
    }

    /// The numerator.
    ///
    /// # Errors
    /// None for a valid spline.
    pub fn numerator(&self) -> Result<D::Spline<C>> {
        D::map_coeffs(&self.lifted, |c| c.point.clone())
    }

    /// The denominator, a positive scalar spline whose coefficients are the weights.
    ///
    /// # Errors
    /// None for a valid spline.
    pub fn denominator(&self) -> Result<D::Spline<T>> {
        denominator::<D, T, C>(&self.lifted)
    }

    /// The weights.
    pub fn weights(&self) -> impl ExactSizeIterator<Item = &T> {
        D::coeffs(&self.lifted).iter().map(|c| &c.weight)
    }

    /// The control points.
    ///
    /// Over `f64` they are quotients rounded to nearest. If the weighted points were made of control points, those that come
    /// back give the same weighted points, bit by bit, unless the numbers are at the ends of the range.
    ///
    /// # Errors
    /// [`Error::Weight`] if a weight is not positive, so that its point is at infinity or beyond. That happens to
    /// results of operators only.
    ///
    /// # Examples
    /// ```
    /// use symspline::{RationalFunction, SplineSpace};
    /// let f = RationalFunction::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![3.0, 5.0], vec![1.0, 2.0])?;
    /// assert_eq!(f.points()?, [3.0, 5.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn points(&self) -> Result<Vec<C>> {
        self.check_weights()?;
        // Not times the inverse of the weight, which is rounded once more.
        let divided = |c: &Weighted<T, C>| {
            let mut point = c.point.clone();
            point.divide(&c.weight);
            point
        };
        Ok(D::coeffs(&self.lifted).iter().map(divided).collect())
    }
}

fn denominator<D: Domain<T>, T: Scalar, C: Coeff<T>>(
    lifted: &D::Spline<Weighted<T, C>>,
) -> Result<D::Spline<T>> {
    D::map_coeffs(lifted, |c| c.weight.clone())
}

/// Weighted points of as many points and weights.
pub(crate) fn weigh_points<T: Scalar, C: Coeff<T>>(
    points: &[C],
    weights: Vec<T>,
) -> Result<Vec<Weighted<T, C>>> {
    if points.len() != weights.len() {
        return Err(Error::CoefficientCount { expected: points.len(), found: weights.len() });
    }
    Ok(points.iter().zip(weights).map(|(point, weight)| Weighted::new(point, weight)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::SplineSpace;

    #[test]
    fn control_points_give_the_same_weighted_points_again() {
        let space = SplineSpace::bezier(99, 0.0, 1.0).unwrap();
        let part = |i: usize, step: f64| 1.0 + (i as f64 * step).fract();
        let points = (0..100).map(|i| part(i, 0.618_033_988_749_894_9)).collect();
        let weights: Vec<f64> = (0..100).map(|i| part(i, 0.414_213_562_373_095_1)).collect();
        let once = Rational::<Interval, f64>::new(space.clone(), points, weights.clone()).unwrap();
        let again = Rational::<Interval, f64>::new(space, once.points().unwrap(), weights).unwrap();
        assert_eq!(again, once);
    }
}
