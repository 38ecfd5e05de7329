//! What a spline may have as coefficients: vectors over the field of its knots.

use crate::error::{Error, Result};
use crate::scalar::Scalar;
use nalgebra::SVector;
use std::borrow::Cow;

/// A vector over `T`: scalars themselves, points, or rows of either.
///
/// Operators of the library never look inside a coefficient; they form sums of weighted coefficients. So whatever
/// has a zero and can take a scaled other rides through every one of them.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::Coeff;
/// let (w, points) = ([0.25, 0.75], [vector![0.0, 4.0], vector![8.0, 0.0]]);
/// assert_eq!(Coeff::combine(w.iter().zip(&points)), Some(vector![6.0, 1.0]));
/// ```
pub trait Coeff<T: Scalar>: Clone + PartialEq + std::fmt::Debug + Send + Sync + 'static {
    /// The same kind of vector over another field.
    type Over<U: Scalar>: Coeff<U>;

    /// The zero of the shape of `self`.
    fn zero_like(&self) -> Self;

    /// Adds `weight * other`.
    fn add_scaled(&mut self, weight: &T, other: &Self);

    /// Multiplies by `weight`.
    fn scale(&mut self, weight: &T);

    /// Divides by `divisor`.
    fn divide(&mut self, divisor: &T) {
        self.scale(&(T::one() / divisor));
    }

    /// The scalars it is made of.
    fn components(&self) -> impl Iterator<Item = &T>;

    /// The same vector with every scalar replaced.
    ///
    /// # Errors
    /// The first error of `f`.
    fn try_map<U: Scalar>(&self, f: impl FnMut(&T) -> Result<U>) -> Result<Self::Over<U>>;

    /// The sum `Σ w c`, or nothing if there are no terms to take the shape from.
    ///
    /// Over an exact field a row is put over one denominator by [`Scalar::dot`] where the shape allows.
    fn combine<'a>(mut terms: impl Iterator<Item = (&'a T, &'a Self)> + Clone) -> Option<Self> {
        let (weight, first) = terms.next()?;
        let mut sum = first.clone();
        sum.scale(weight);
        terms.for_each(|(w, c)| sum.add_scaled(w, c));
        Some(sum)
    }

    /// The sum `self + weight * other`.
    fn plus_scaled(&self, weight: &T, other: &Self) -> Self {
        let mut sum = self.clone();
        sum.add_scaled(weight, other);
        sum
    }

    /// The difference `self - other`.
    fn minus(&self, other: &Self) -> Self {
        self.plus_scaled(&-T::one(), other)
    }

    /// The multiple `weight * self`.
    fn scaled(&self, weight: &T) -> Self {
        let mut multiple = self.clone();
        multiple.scale(weight);
        multiple
    }

    /// Whether every component is a finite number.
    fn all_finite(&self) -> bool {
        self.components().fold(true, |all, x| all & x.is_finite())
    }

    /// The squared size in which errors are measured, convex in `self`: of a number or a point the squared length, of a
    /// row of them the largest.
    fn squared_size(&self) -> T {
        T::dot(self.components().zip(self.components()))
    }

    /// Whether `other` can be added: rows must be of the same length.
    fn same_shape(&self, other: &Self) -> bool {
        let _ = other;
        true
    }

    /// Whether every component is zero.
    fn vanishes(&self) -> bool {
        self.components().all(T::is_zero)
    }
}

/// Refuses rows of different lengths.
pub(crate) fn check_shapes<T: Scalar, C: Coeff<T>>(coeffs: &[C]) -> Result<()> {
    match coeffs.iter().position(|c| !c.same_shape(&coeffs[0])) {
        Some(index) => Err(Error::Ragged { index }),
        None => Ok(()),
    }
}

/// Puts new coefficients in the place of others, or none of them if one does not fit.
pub(crate) fn replace<T: Scalar, C: Coeff<T>>(coeffs: &mut [C], new: Vec<(usize, C)>) -> Result<()> {
    for (index, c) in &new {
        let length = coeffs.len();
        let old = coeffs.get(*index).ok_or(Error::IndexOutOfRange { index: *index, length })?;
        check_pair(old, c)?;
        if !c.all_finite() {
            return Err(Error::NotFinite { what: "coefficient", index: *index });
        }
    }
    new.into_iter().for_each(|(index, c)| coeffs[index] = c);
    Ok(())
}

/// Refuses to add a row to one of another length.
pub(crate) fn check_pair<T: Scalar, C: Coeff<T>>(c: &C, d: &C) -> Result<()> {
    if c.same_shape(d) { Ok(()) } else { Err(Error::Ragged { index: 0 }) }
}

/// The multiples of `coeffs` by the number that [`Scalar::clear`] finds for their components, and that number.
pub(crate) fn cleared<T: Scalar, C: Coeff<T>>(coeffs: &[C]) -> (Cow<'_, [C]>, T) {
    match T::clear(coeffs.iter().flat_map(C::components)) {
        Some(factor) => (coeffs.iter().map(|c| c.scaled(&factor)).collect(), factor),
        None => (Cow::Borrowed(coeffs), T::one()),
    }
}

impl<T: Scalar> Coeff<T> for T {
    type Over<U: Scalar> = U;

    #[inline]
    fn zero_like(&self) -> Self {
        T::zero()
    }

    #[inline]
    fn add_scaled(&mut self, weight: &T, other: &Self) {
        *self += weight.clone() * other;
    }

    #[inline]
    fn scale(&mut self, weight: &T) {
        *self *= weight;
    }

    #[inline]
    fn divide(&mut self, divisor: &T) {
        *self /= divisor;
    }

    fn components(&self) -> impl Iterator<Item = &T> {
        std::iter::once(self)
    }

    fn try_map<U: Scalar>(&self, mut f: impl FnMut(&T) -> Result<U>) -> Result<U> {
        f(self)
    }

    #[inline]
    fn combine<'a>(terms: impl Iterator<Item = (&'a T, &'a Self)> + Clone) -> Option<Self> {
        Some(T::dot(terms))
    }
}

impl<T: Scalar, const N: usize> Coeff<T> for SVector<T, N> {
    type Over<U: Scalar> = SVector<U, N>;

    #[inline]
    fn zero_like(&self) -> Self {
        Self::zeros()
    }

    #[inline]
    fn add_scaled(&mut self, weight: &T, other: &Self) {
        for i in 0..N {
            self[i] += weight.clone() * &other[i];
        }
    }

    #[inline]
    fn scale(&mut self, weight: &T) {
        for i in 0..N {
            self[i] *= weight;
        }
    }

    #[inline]
    fn divide(&mut self, divisor: &T) {
        T::divide(self.as_mut_slice(), divisor);
    }

    fn components(&self) -> impl Iterator<Item = &T> {
        self.as_slice().iter()
    }

    fn try_map<U: Scalar>(&self, mut f: impl FnMut(&T) -> Result<U>) -> Result<SVector<U, N>> {
        let mut mapped = SVector::<U, N>::zeros();
        for (to, from) in mapped.iter_mut().zip(self.iter()) {
            *to = f(from)?;
        }
        Ok(mapped)
    }

    #[inline]
    fn combine<'a>(terms: impl Iterator<Item = (&'a T, &'a Self)> + Clone) -> Option<Self> {
        if T::EXACT {
            return Some(Self::from_fn(|i, _| T::dot(terms.clone().map(|(w, c)| (w, &c[i])))));
        }
        let mut sum = Self::zeros();
        terms.for_each(|(w, c)| sum.add_scaled(w, c));
        Some(sum)
    }
}
