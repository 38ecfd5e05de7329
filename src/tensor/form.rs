//! Quadratic forms of the parameter plane.

use crate::scalar::{Real, Scalar};
use crate::vector::{dot, unit_cross};
use nalgebra::SVector;

/// A quadratic form `uu du² + 2 uv du dv + vv dv²`, of numbers at a point or of scalar surfaces.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct QuadraticForm<X> {
    /// The factor of `du²`.
    pub uu: X,
    /// Half the factor of `du dv`.
    pub uv: X,
    /// The factor of `dv²`.
    pub vv: X,
}

/// The first fundamental form of two tangents.
pub(crate) fn first_form<T: Scalar, const N: usize>(
    along_u: &SVector<T, N>,
    along_v: &SVector<T, N>,
) -> QuadraticForm<T> {
    QuadraticForm { uu: dot(along_u, along_u), uv: dot(along_u, along_v), vv: dot(along_v, along_v) }
}

/// The second fundamental form from the partial derivatives `[k][l]`, if there is a normal.
pub(crate) fn second_form<T: Real>(partials: &[Vec<SVector<T, 3>>]) -> Option<QuadraticForm<T>> {
    let normal = unit_cross(&partials[1][0], &partials[0][1])?;
    Some(QuadraticForm {
        uu: dot(&partials[2][0], &normal),
        uv: dot(&partials[1][1], &normal),
        vv: dot(&partials[0][2], &normal),
    })
}
