//! Rational splines by homogeneous coordinates: weight times point, then the weight. Nothing is divided, so nothing is lost.

use crate::any::Any;
use crate::build::of_dim;
use crate::error::{Error, Result};
use crate::family::{AnyRational, AnyRationalSurface};
use crate::number::{Flat, flat};
use crate::over::{AnySpace, Coords, Over};
use crate::{each, number::Field};
use symspline::{Interval, Q, Rational, Rectangle, Spline, TensorSpline, Weighted};

/// Coordinates put together to weighted points.
fn weighted<T: Field, C: Flat<T>>(coords: &[T]) -> Result<Vec<Weighted<T, C>>> {
    let torn = Error::Torn { count: coords.len(), dim: C::DIM + 1 };
    if !coords.len().is_multiple_of(C::DIM + 1) {
        return Err(torn);
    }
    let one = |all: &[T]| {
        let (weight, point) = all.split_last().ok_or(torn.clone())?;
        Ok(Weighted { point: C::from_coords(point)?, weight: weight.clone() })
    };
    coords.chunks_exact(C::DIM + 1).map(one).collect()
}

macro_rules! homogeneous {
    ($any:ty, $domain:ty, $polynomial:ident, ($($space:ident),+)) => {
        impl $any {
            /// The rational spline with these homogeneous coordinates, `dim + 1` a control point, its weight the last.
            ///
            /// # Errors
            /// [`Error::Fields`], [`Error::Dimension`], [`Error::Torn`], and those of [`Rational::from_lifted`].
            pub fn from_homogeneous($($space: AnySpace,)+ dim: usize, coords: Coords) -> Result<Self> {
                match (($($space,)+), coords) {
                    (($(Over::Float($space),)+), Over::Float(c)) => of_dim!(dim, f64, C =>
                        Rational::<$domain, f64, C>::from_lifted($polynomial::new($($space,)+ weighted::<f64, C>(&c)?)?)),
                    (($(Over::Exact($space),)+), Over::Exact(c)) => of_dim!(dim, Q, C =>
                        Rational::<$domain, Q, C>::from_lifted($polynomial::new($($space,)+ weighted::<Q, C>(&c)?)?)),
                    (spaces, coords) => {
                        let ($($space,)+) = spaces;
                        let odd = [$($space),+].into_iter().find(|s| s.is_exact() != coords.is_exact());
                        Err(odd.map_or(Error::Fields { left: coords.field(), right: coords.field() }, |s| s.unlike(&coords)))
                    }
                }
            }

            /// The homogeneous coordinates of its control points, one after the other, the weight the last of each.
            pub fn homogeneous(&self) -> Coords {
                each!(self, s => flat(s.lifted().coeffs()))
            }
        }
    };
}

homogeneous!(AnyRational, Interval, Spline, (space));
homogeneous!(AnyRationalSurface, Rectangle, TensorSpline, (u, v));
