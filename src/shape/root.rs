//! Square roots where the field has them.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::error::shape::ShapeError;
use crate::ops::bound::epsilon;
use crate::scalar::{Scalar, larger};
use crate::vector::dot;
use nalgebra::SVector;

/// The square root: over `f64` to about a rounding, over an exact field if it is there.
///
/// # Errors
/// [`ShapeError::NoRoot`].
pub(crate) fn root<T: Scalar>(square: &T) -> Result<T> {
    let above = square.root_above();
    if above.clone() * &above == *square {
        return Ok(above);
    }
    if T::EXACT || *square < T::zero() || !square.is_finite() {
        return Err(ShapeError::NoRoot { square: square.to_string() }.into());
    }
    Ok((square.clone() / &above + above) / T::int(2))
}

/// A positive number by which a vector is brought to the order of one where squares may overflow or vanish.
pub(crate) fn size<T: Scalar, const N: usize>(v: &SVector<T, N>) -> T {
    let largest = v.iter().map(T::magnitude).fold(T::zero(), larger);
    if T::EXACT || largest.is_zero() || !largest.is_finite() { T::one() } else { largest }
}

/// A vector divided by a number.
pub(crate) fn divided<T: Scalar, const N: usize>(v: &SVector<T, N>, by: &T) -> SVector<T, N> {
    let mut v = v.clone();
    Coeff::divide(&mut v, by);
    v
}

/// The product of two vectors; over inexact fields zero where it is no more than their rounding.
pub(crate) fn sure_dot<T: Scalar, const N: usize>(v: &SVector<T, N>, w: &SVector<T, N>) -> T {
    let product = dot(v, w);
    if T::EXACT {
        return product;
    }
    let terms = v.iter().zip(w.iter()).fold(T::zero(), |sum, (x, y)| sum + (x.clone() * y).magnitude());
    let noise = terms * epsilon::<T>() * T::int(N as i64 + 2);
    if product.magnitude() <= noise { T::zero() } else { product }
}

/// The length of a vector.
///
/// # Errors
/// [`ShapeError::NoRoot`].
pub(crate) fn distance<T: Scalar, const N: usize>(v: &SVector<T, N>) -> Result<T> {
    let size = size(v);
    Ok(root(&divided(v, &size).squared_size())? * size)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;
    use nalgebra::vector;

    #[test]
    fn roots_are_in_the_field_or_refused() {
        assert_eq!(root(&Q::frac(49, 81)).unwrap(), Q::frac(7, 9));
        assert!(root(&Q::int(2)).is_err() && root(&Q::int(-1)).is_err());
        assert!((root(&2.0).unwrap() - 2.0_f64.sqrt()).abs() < 1e-15);
        assert!(root(&-1.0).is_err() && root(&f64::NAN).is_err());
        assert_eq!((root(&0.0).unwrap(), root(&4.0).unwrap()), (0.0, 2.0));
        for size in [1e-300, 1.0, 1e300] {
            let length = distance(&vector![3.0 * size, 4.0 * size]).unwrap();
            assert!((length / size - 5.0).abs() < 1e-14);
        }
    }
}
