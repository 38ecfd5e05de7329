//! Numbers of either field, and the two fields.

use crate::both;
use crate::error::{Error, Result};
use crate::over::{Coords, Over};
use nalgebra::SVector;
use std::fmt;
use symspline::{Certified, Coeff, Q, Scalar};

/// A number of either field.
pub type Number = Over<f64, Q>;

/// One of the two fields: `f64`, or the rationals `Q`.
pub trait Field: Certified + Flat<Self> + fmt::Display {
    /// How messages call the field.
    const NAME: &'static str;

    /// The number of this field that `number` is: to fractions without loss, to floats rounded to nearest.
    ///
    /// # Errors
    /// [`symspline::Error::NotFinite`] for a float without a fraction.
    fn of(number: &Number) -> Result<Self>;

    /// As a number of either field.
    fn number(self) -> Number;

    /// The numbers of this field that those of `coords` are.
    ///
    /// # Errors
    /// As [`of`](Self::of).
    fn all_of(coords: &Coords) -> Result<Vec<Self>>;

    /// As coordinates of either field.
    fn coords(numbers: Vec<Self>) -> Coords;
}

impl Field for f64 {
    const NAME: &'static str = "float";

    fn of(number: &Number) -> Result<Self> {
        Ok(match number {
            Over::Float(x) => *x,
            Over::Exact(x) => x.to_f64(),
        })
    }

    fn number(self) -> Number {
        Over::Float(self)
    }

    fn all_of(coords: &Coords) -> Result<Vec<Self>> {
        Ok(match coords {
            Over::Float(all) => all.clone(),
            Over::Exact(all) => all.iter().map(Q::to_f64).collect(),
        })
    }

    fn coords(numbers: Vec<Self>) -> Coords {
        Over::Float(numbers)
    }
}

impl Field for Q {
    const NAME: &'static str = "exact";

    fn of(number: &Number) -> Result<Self> {
        Ok(match number {
            Over::Float(x) => Self::try_from(*x)?,
            Over::Exact(x) => x.clone(),
        })
    }

    fn number(self) -> Number {
        Over::Exact(self)
    }

    fn all_of(coords: &Coords) -> Result<Vec<Self>> {
        Ok(match coords {
            Over::Float(all) => all.iter().map(|x| Self::try_from(*x)).collect::<symspline::Result<_>>()?,
            Over::Exact(all) => all.clone(),
        })
    }

    fn coords(numbers: Vec<Self>) -> Coords {
        Over::Exact(numbers)
    }
}

/// A coefficient with a fixed number of coordinates: a number, or a point.
pub trait Flat<T: Scalar>: Coeff<T> {
    /// How many coordinates.
    const DIM: usize;

    /// The coefficient with these coordinates.
    ///
    /// # Errors
    /// [`Error::Dimensions`] unless there are [`DIM`](Self::DIM).
    fn from_coords(coords: &[T]) -> Result<Self>;

    /// The coordinates.
    fn to_coords(&self) -> Vec<T> {
        self.components().cloned().collect()
    }
}

impl<T: Scalar> Flat<T> for T {
    const DIM: usize = 1;

    fn from_coords(coords: &[T]) -> Result<Self> {
        match coords {
            [x] => Ok(x.clone()),
            _ => Err(Error::Dimensions { left: 1, right: coords.len() }),
        }
    }
}

impl<T: Scalar, const N: usize> Flat<T> for SVector<T, N> {
    const DIM: usize = N;

    fn from_coords(coords: &[T]) -> Result<Self> {
        match coords.len() == N {
            true => Ok(Self::from_fn(|i, _| coords[i].clone())),
            false => Err(Error::Dimensions { left: N, right: coords.len() }),
        }
    }
}

/// Coordinates put together to points.
///
/// # Errors
/// [`Error::Torn`] if some are left.
pub fn points<T: Scalar, C: Flat<T>>(coords: &[T]) -> Result<Vec<C>> {
    match coords.len() % C::DIM {
        0 => coords.chunks_exact(C::DIM).map(C::from_coords).collect(),
        _ => Err(Error::Torn { count: coords.len(), dim: C::DIM }),
    }
}

/// The coordinates of points, one after the other.
pub fn flat<T: Field, C: Coeff<T>>(points: &[C]) -> Coords {
    T::coords(points.iter().flat_map(C::components).cloned().collect())
}

impl Number {
    /// The number, exactly.
    ///
    /// # Errors
    /// [`symspline::Error::NotFinite`].
    pub fn to_exact(&self) -> Result<Self> {
        Ok(Self::Exact(Q::of(self)?))
    }

    /// The nearest float.
    ///
    /// # Errors
    /// None; it is a result for symmetry.
    pub fn to_float(&self) -> Result<Self> {
        Ok(Self::Float(f64::of(self)?))
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        both!(self, x => x.fmt(f))
    }
}
