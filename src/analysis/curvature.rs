//! Curvature of curves: signed in the plane, not negative in space.
//!
//! ```text
//! κ = C' × C'' / |C'|³        (in space |C' × C''|)          [Miura, (2)]
//! ```

use crate::coeff::Coeff;
use crate::scalar::Real;
use crate::vector::{cross2, cross3, dot, length, unit};
use nalgebra::SVector;

/// Points whose curves have a curvature: those of the plane and of space.
pub trait Curved<T: Real>: Coeff<T> {
    /// The curvature of a curve with these first and second derivatives, if the first does not vanish.
    fn curvature(first: &Self, second: &Self) -> Option<T>;
}

impl<T: Real> Curved<T> for SVector<T, 2> {
    fn curvature(first: &Self, second: &Self) -> Option<T> {
        let (tangent, speed) = unit(first)?;
        Some(cross2(&tangent, second) / &speed / speed)
    }
}

impl<T: Real> Curved<T> for SVector<T, 3> {
    fn curvature(first: &Self, second: &Self) -> Option<T> {
        let (tangent, speed) = unit(first)?;
        Some(length(&cross3(&tangent, second)) / &speed / speed)
    }
}

/// The tip of a tooth of a curvature comb, `scale * |κ|` off the point on the outer side, from value and two
/// derivatives.
pub(crate) fn tooth<T: Real, const N: usize>(
    derivatives: &[SVector<T, N>],
    scale: &T,
) -> Option<SVector<T, N>> {
    let (tangent, speed) = unit(&derivatives[1])?;
    // The part of C'' across the tangent, over the squared speed, points inwards with length κ.
    let across = derivatives[2].plus_scaled(&-dot(&tangent, &derivatives[2]), &tangent);
    Some(derivatives[0].plus_scaled(&-(scale.clone() / &speed / speed), &across))
}
