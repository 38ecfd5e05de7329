//! Shapes on which a shape operator can work: those that can also lose knots again.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::ops::bound::Approximation;
use crate::rational::domain::Domain;
use crate::rational::spline::Rational;
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::spline::Spline;
use crate::tensor::along::Direction;
use crate::tensor::spline::TensorSpline;
use crate::weighted::Weighted;

/// A [`Controlled`] shape that can be thinned out in a region.
pub trait Workable<T: Scalar>: Controlled<T> {
    /// The place with the given coordinate along each direction.
    fn place(coordinate: impl Fn(Direction) -> T) -> Self::Parameter;

    /// The shape without the knots between `from` and `to` that it can do without up to `tolerance`, a distance between
    /// points, and as it is outside.
    ///
    /// # Errors
    /// As [`Spline::without_spare_knots_on`]; [`Error::Weight`](crate::Error::Weight) if a weight is not positive.
    fn thinned(
        &self,
        from: &Self::Parameter,
        to: &Self::Parameter,
        tolerance: &T,
    ) -> Result<Approximation<Self, T>>;
}

impl<T: Scalar, C: Coeff<T>> Workable<T> for Spline<T, C> {
    fn place(coordinate: impl Fn(Direction) -> T) -> T {
        coordinate(Direction::U)
    }

    fn thinned(&self, from: &T, to: &T, tolerance: &T) -> Result<Approximation<Self, T>> {
        self.without_spare_knots_on(from, to, tolerance)
    }
}

impl<T: Scalar, C: Coeff<T>> Workable<T> for TensorSpline<T, C> {
    fn place(coordinate: impl Fn(Direction) -> T) -> (T, T) {
        (coordinate(Direction::U), coordinate(Direction::V))
    }

    fn thinned(&self, from: &(T, T), to: &(T, T), tolerance: &T) -> Result<Approximation<Self, T>> {
        self.without_spare_knots_on(from, to, tolerance)
    }
}

impl<D: Domain<T>, T: Scalar, C: Coeff<T>> Workable<T> for Rational<D, T, C>
where
    D::Spline<Weighted<T, C>>: Workable<T, Point = Weighted<T, C>>,
{
    fn place(coordinate: impl Fn(Direction) -> T) -> Self::Parameter {
        D::Spline::<Weighted<T, C>>::place(coordinate)
    }

    fn thinned(
        &self,
        from: &Self::Parameter,
        to: &Self::Parameter,
        tolerance: &T,
    ) -> Result<Approximation<Self, T>> {
        self.approximated(tolerance, |lifted, tolerance| lifted.thinned(from, to, tolerance))
    }
}
