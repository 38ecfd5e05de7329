//! Rows of coefficients, themselves coefficients: how surfaces ride through the operators of curves.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::scalar::{Scalar, larger_size};
use std::ops::{Deref, DerefMut};

/// A row of coefficients as one coefficient, added and scaled entry by entry.
///
/// A surface is a spline in `u` whose coefficients are rows: the coefficients in `v`.
///
/// # Examples
/// ```
/// use symspline::{Row, Spline, SplineSpace};
/// let two = Spline::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![Row(vec![0.0, 4.0]), Row(vec![2.0, 8.0])])?;
/// assert_eq!(two.at(&0.5)?, Row(vec![1.0, 6.0]));
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Row<C>(pub Vec<C>);

impl<C> Deref for Row<C> {
    type Target = [C];

    fn deref(&self) -> &[C] {
        &self.0
    }
}

impl<C> DerefMut for Row<C> {
    fn deref_mut(&mut self) -> &mut [C] {
        &mut self.0
    }
}

impl<T: Scalar, C: Coeff<T>> Coeff<T> for Row<C> {
    type Over<U: Scalar> = Row<<C as Coeff<T>>::Over<U>>;

    fn zero_like(&self) -> Self {
        Self(self.iter().map(C::zero_like).collect())
    }

    fn add_scaled(&mut self, weight: &T, other: &Self) {
        self.iter_mut().zip(other.iter()).for_each(|(c, d)| c.add_scaled(weight, d));
    }

    fn scale(&mut self, weight: &T) {
        self.iter_mut().for_each(|c| c.scale(weight));
    }

    fn divide(&mut self, divisor: &T) {
        self.iter_mut().for_each(|c| c.divide(divisor));
    }

    fn components(&self) -> impl Iterator<Item = &T> {
        self.iter().flat_map(C::components)
    }

    fn try_map<U: Scalar>(&self, mut f: impl FnMut(&T) -> Result<U>) -> Result<Self::Over<U>> {
        Ok(Row(self.iter().map(|c| c.try_map(&mut f)).collect::<Result<_>>()?))
    }

    fn combine<'a>(terms: impl Iterator<Item = (&'a T, &'a Self)> + Clone) -> Option<Self> {
        let (_, first) = terms.clone().next()?;
        let entry = |i: usize| C::combine(terms.clone().map(|(w, row)| (w, &row[i])));
        (0..first.len()).map(entry).collect::<Option<_>>().map(Self)
    }

    fn squared_size(&self) -> T {
        self.iter().map(C::squared_size).fold(T::zero(), larger_size)
    }

    fn same_shape(&self, other: &Self) -> bool {
        self.len() == other.len() && self.iter().zip(other.iter()).all(|(c, d)| c.same_shape(d))
    }
}
