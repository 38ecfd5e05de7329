//! Between which values a spline runs, and in which box a curve lies.
//!
//! A value is a mean of coefficients, so these are a first bound. On the pieces the range is enclosed as closely as one
//! likes, see [`enclose`](crate::ops::enclose).

use crate::error::Result;
use crate::ops::enclose::{Enclosure, enclose};
use crate::scalar::Scalar;
use crate::spline::{Curve, Function};
use nalgebra::SVector;

impl<T: Scalar> Function<T> {
    /// The least and the greatest coefficient, between which all values lie.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let f = Function::new(SplineSpace::bezier(2, 0.0, 1.0)?, vec![0.0, 2.0, 1.0])?;
    /// assert_eq!(f.coefficient_range(), (0.0, 2.0));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn coefficient_range(&self) -> (T, T) {
        ends(self.coeffs().iter())
    }

    /// The least and the greatest value, each enclosed by a bound and a value met that differ by `accuracy` at most.
    ///
    /// At jumps the limits from both sides count. An extreme value at an end of a piece is decided at once if it is the
    /// extreme coefficient of the piece too: then bound and value are the same. In `f64` bounds hold up to a few
    /// roundings of the largest coefficient, and an accuracy finer than that counts as that.
    ///
    /// # Errors
    /// [`BadTolerance`](crate::Error::BadTolerance) unless `accuracy` is positive and finite, and where it is infinitely
    /// small, in fields that have such numbers.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, Scalar, SplineSpace};
    /// let wave = Function::new(SplineSpace::bezier(2, Q::int(0), Q::int(3))?, [0, -3, 3].map(Q::int).to_vec())?;
    /// let range = wave.range(&Q::frac(1, 100))?;
    /// // The least value is -1, at 1.
    /// assert!(range.least.bound <= Q::int(-1) && Q::int(-1) <= range.least.value);
    /// assert!(range.least.value.clone() - &range.least.bound <= Q::frac(1, 100));
    /// assert_eq!(wave.at(&range.least.parameter)?, range.least.value);
    /// // The greatest one is the last coefficient.
    /// assert_eq!((range.greatest.bound, range.greatest.parameter), (Q::int(3), Q::int(3)));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn range(&self, accuracy: &T) -> Result<Enclosure<T>> {
        Ok(enclose(self.patches()?, accuracy)?.map_parameters(|[x]| x))
    }
}

impl<T: Scalar, const N: usize> Curve<T, N> {
    /// The lowest and the highest corner of the box of the control points, in which the curve lies.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// let points = vec![vector![0.0, 0.0], vector![1.0, 4.0], vector![2.0, 0.0]];
    /// let arch = Curve::new(SplineSpace::bezier(2, 0.0, 1.0)?, points)?;
    /// assert_eq!(arch.control_box(), (vector![0.0, 0.0], vector![2.0, 4.0]));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn control_box(&self) -> (SVector<T, N>, SVector<T, N>) {
        box_of(self.coeffs())
    }

    /// The range of every coordinate, enclosed as by [`Function::range`]: the bounds are those of a box around the
    /// curve that is too large by `accuracy` at most on every side.
    ///
    /// # Errors
    /// As [`Function::range`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// let points = vec![vector![0.0, 0.0], vector![1.0, 4.0], vector![2.0, 0.0]];
    /// let arch = Curve::new(SplineSpace::bezier(2, 0.0, 1.0)?, points)?;
    /// let [x, y] = arch.bounding_box(&1e-9)?;
    /// assert_eq!((x.least.bound, x.greatest.bound, y.greatest.bound), (0.0, 2.0, 2.0));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn bounding_box(&self, accuracy: &T) -> Result<[Enclosure<T>; N]> {
        each_axis(|axis| self.coordinate(axis)?.range(accuracy))
    }
}

/// The lowest and the highest corner of the box of some points.
pub(crate) fn box_of<T: Scalar, const N: usize>(points: &[SVector<T, N>]) -> (SVector<T, N>, SVector<T, N>) {
    let side = |axis: usize| ends(points.iter().map(|point| &point[axis]));
    (SVector::from_fn(|axis, _| side(axis).0), SVector::from_fn(|axis, _| side(axis).1))
}

/// What `side` says of each axis.
pub(crate) fn each_axis<X: std::fmt::Debug, const N: usize>(
    side: impl FnMut(usize) -> Result<X>,
) -> Result<[X; N]> {
    let sides: Vec<X> = (0..N).map(side).collect::<Result<_>>()?;
    Ok(<[X; N]>::try_from(sides).expect("there is one for each axis"))
}

/// The least and the greatest of the components of a spline's coefficients.
pub(crate) fn ends<'a, T: Scalar>(numbers: impl Iterator<Item = &'a T> + Clone) -> (T, T) {
    let low = numbers.clone().reduce(|low, x| if x < low { x } else { low });
    let high = numbers.reduce(|high, x| if x > high { x } else { high });
    let end = |x: Option<&T>| x.expect("a spline has a coefficient").clone();
    (end(low), end(high))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Error;
    use crate::space::SplineSpace;

    #[test]
    fn no_tolerance_no_range() {
        let line = Function::monomial(1, 0.0, 1.0).unwrap();
        for accuracy in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(line.range(&accuracy), Err(Error::BadTolerance { .. })));
        }
    }

    #[test]
    fn steps_and_constants_are_decided_at_once() {
        let steps = Function::new(SplineSpace::clamped(0, [0.0, 1.0, 2.0]).unwrap(), vec![3.0, 5.0]).unwrap();
        let range = steps.range(&1e-300).unwrap();
        assert_eq!((range.least.bound, range.least.value), (3.0, 3.0));
        assert_eq!((range.greatest.bound, range.greatest.value), (5.0, 5.0));
        let one = Function::constant(SplineSpace::uniform_periodic(3, 4, 0.0, 1.0).unwrap(), 1.0).unwrap();
        let range = one.range(&1e-300).unwrap();
        assert!((range.greatest.bound - range.least.bound).abs() < 1e-14);
    }

    #[test]
    fn the_finest_accuracy_of_floats_ends() {
        let wild: Vec<f64> = (0..200).map(|i| (i as f64 * 1.7).sin() * 1e300).collect();
        let f = Function::new(SplineSpace::uniform(7, 193, 0.0, 1.0).unwrap(), wild).unwrap();
        let range = f.range(&f64::MIN_POSITIVE).unwrap();
        assert!(range.least.value - range.least.bound <= 1e300 * 1e-14);
    }
}
