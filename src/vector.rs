//! Lengths and cross products of points of the plane and of space, over any field.

use crate::coeff::Coeff;
use crate::scalar::{Real, Scalar, larger, larger_size};
use nalgebra::{SVector, vector};

/// The dot product of two points.
pub(crate) fn dot<T: Scalar, const N: usize>(c: &SVector<T, N>, d: &SVector<T, N>) -> T {
    T::dot(c.iter().zip(d.iter()))
}

/// Points with a cross product: of the plane, where it is a number, and of space.
pub trait Crossed<T: Scalar>: Coeff<T> {
    /// What the cross product is.
    type Product: Coeff<T>;

    /// The cross product.
    fn crossed(&self, other: &Self) -> Self::Product;
}

impl<T: Scalar> Crossed<T> for SVector<T, 2> {
    type Product = T;

    fn crossed(&self, other: &Self) -> T {
        cross2(self, other)
    }
}

impl<T: Scalar> Crossed<T> for SVector<T, 3> {
    type Product = Self;

    fn crossed(&self, other: &Self) -> Self {
        cross3(self, other)
    }
}

/// The cross product `x_1 y_2 - y_1 x_2` of two plane vectors.
pub(crate) fn cross2<T: Scalar>(c: &SVector<T, 2>, d: &SVector<T, 2>) -> T {
    c[0].clone() * &d[1] - c[1].clone() * &d[0]
}

/// The cross product of two space vectors.
pub(crate) fn cross3<T: Scalar>(c: &SVector<T, 3>, d: &SVector<T, 3>) -> SVector<T, 3> {
    let minor = |i: usize, j: usize| c[i].clone() * &d[j] - c[j].clone() * &d[i];
    vector![minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// The largest component of points.
pub(crate) fn extent<'a, T: Scalar, C: Coeff<T>>(points: impl IntoIterator<Item = &'a C>) -> T {
    points.into_iter().flat_map(C::components).map(T::magnitude).fold(T::zero(), larger_size)
}

/// `(way · target) / (way · way)` for a way that is not zero, where no square overflows.
pub(crate) fn fraction_near<T: Scalar, C: Coeff<T>>(way: &C, target: &C) -> T {
    let size = extent([way]);
    let [mut way, mut target] = [way.clone(), target.clone()];
    way.divide(&size);
    target.divide(&size);
    T::dot(way.components().zip(target.components())) / way.squared_size()
}

/// The Euclidean length of a vector, without overflow or underflow on the way.
pub(crate) fn length<T: Real, const N: usize>(vector: &SVector<T, N>) -> T {
    let largest = vector.iter().map(T::magnitude).reduce(larger);
    match largest {
        Some(size) if !size.is_zero() && size.is_finite() => {
            let share = |x: &T| x.clone() / &size;
            let squares = vector.iter().fold(T::zero(), |sum, x| sum + share(x) * share(x));
            squares.sqrt() * size
        }
        size => size.unwrap_or_else(T::zero),
    }
}

/// Direction and length of a vector, if it has a direction.
pub(crate) fn unit<T: Real, const N: usize>(vector: &SVector<T, N>) -> Option<(SVector<T, N>, T)> {
    let size = length(vector);
    let usable = !size.is_zero() && size.is_finite();
    usable.then(|| (vector.map(|x| x / &size), size))
}

/// The direction across two vectors. Each is brought to unit length first, so that no product overflows or vanishes by
/// rounding.
pub(crate) fn unit_cross<T: Real>(c: &SVector<T, 3>, d: &SVector<T, 3>) -> Option<SVector<T, 3>> {
    let ((c, _), (d, _)) = (unit(c)?, unit(d)?);
    unit(&cross3(&c, &d)).map(|(direction, _)| direction)
}
