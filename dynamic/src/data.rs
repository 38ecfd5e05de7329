//! Spaces and points of the field at hand.

use crate::error::{Error, Result};
use crate::number::Field;
use crate::over::{AnySpace, Over};
use symspline::{Q, SplineSpace};

/// A field whose spaces can be told from those of the other.
pub trait Spaced: Field {
    /// The space, if it is over this field.
    ///
    /// # Errors
    /// [`Error::Fields`].
    fn space(space: &AnySpace) -> Result<&SplineSpace<Self>>;
}

impl Spaced for f64 {
    fn space(space: &AnySpace) -> Result<&SplineSpace<Self>> {
        match space {
            Over::Float(space) => Ok(space),
            Over::Exact(_) => Err(Error::Fields { left: Self::NAME, right: Q::NAME }),
        }
    }
}

impl Spaced for Q {
    fn space(space: &AnySpace) -> Result<&SplineSpace<Self>> {
        match space {
            Over::Exact(space) => Ok(space),
            Over::Float(_) => Err(Error::Fields { left: Self::NAME, right: f64::NAME }),
        }
    }
}

/// One text for points of one, two or three coordinates: `with_points!(coords, dim, T, p => ...)` has `p` a vector of points and `T`
/// their field. Other dimensions are [`Error::Dimension`].
///
/// ```
/// use symspline::Spline;
/// use symspline_dynamic::{AnySpline, Coords, Result, with_points};
/// fn ring(degree: usize, dim: usize, vertices: &Coords) -> Result<AnySpline> {
///     with_points!(vertices, dim, T, p => Ok(Spline::<T, _>::closed(degree, p)?.into()))
/// }
/// assert_eq!(ring(2, 2, &Coords::Float(vec![0.0; 10]))?.dim(), 2);
/// # Ok::<(), symspline_dynamic::Error>(())
/// ```
#[macro_export]
macro_rules! with_points {
    ($coords:expr, $dim:expr, $T:ident, $p:ident => $body:expr) => {
        $crate::both!($coords, $T, coords => match $dim {
            1 => {
                let $p = $crate::number::points::<$T, $T>(coords)?;
                $body
            }
            2 => {
                let $p = $crate::number::points::<$T, ::nalgebra::SVector<$T, 2>>(coords)?;
                $body
            }
            3 => {
                let $p = $crate::number::points::<$T, ::nalgebra::SVector<$T, 3>>(coords)?;
                $body
            }
            found => Err($crate::Error::Dimension { found, least: 1 }.into()),
        })
    };
}
