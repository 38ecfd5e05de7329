//! Arrays of coefficients, themselves coefficients: the derivatives along one direction ride along the other.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::scalar::{Scalar, larger_size};

/// Entry by entry, as a [`Row`](crate::Row) of a length that the compiler knows.
impl<T: Scalar, C: Coeff<T>, const N: usize> Coeff<T> for [C; N] {
    type Over<U: Scalar> = [<C as Coeff<T>>::Over<U>; N];

    #[inline]
    fn zero_like(&self) -> Self {
        std::array::from_fn(|i| self[i].zero_like())
    }

    #[inline]
    fn add_scaled(&mut self, weight: &T, other: &Self) {
        self.iter_mut().zip(other).for_each(|(c, d)| c.add_scaled(weight, d));
    }

    #[inline]
    fn scale(&mut self, weight: &T) {
        self.iter_mut().for_each(|c| c.scale(weight));
    }

    fn components(&self) -> impl Iterator<Item = &T> {
        self.iter().flat_map(C::components)
    }

    fn try_map<U: Scalar>(&self, mut f: impl FnMut(&T) -> Result<U>) -> Result<Self::Over<U>> {
        let mapped = self.iter().map(|c| c.try_map(&mut f)).collect::<Result<Vec<_>>>()?;
        Ok(mapped.try_into().expect("as many as before"))
    }

    fn squared_size(&self) -> T {
        self.iter().map(C::squared_size).fold(T::zero(), larger_size)
    }

    fn same_shape(&self, other: &Self) -> bool {
        self.iter().zip(other).all(|(c, d)| c.same_shape(d))
    }
}
