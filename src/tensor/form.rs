//! Quadratic forms of the parameter plane.

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
