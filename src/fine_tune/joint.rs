//! The angle at a joint of two legs, and its gradient.
//!
//! ```text
//! θ = atan2(n·(u × v), u·v),    ∂θ/∂u = -(n × u) / u·u,    ∂θ/∂v = (n × v) / v·v
//! ```
//! In the plane `n` points up: angles to the left are positive. In space `n` has the direction of `u × v`: angles have no
//! sign, `0 <= θ <= π`.

use crate::fine_tune::turn::{Turnable, across};
use crate::vector::{cross2, cross3};
use nalgebra::{SVector, vector};
use std::f64::consts::{PI, TAU};

/// The least share of its stiffness that a joint of space has against being turned out of its plane.
const SOFT: f64 = 1e-3;

/// An angle from one unit vector to another, and how the vectors would turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn<V> {
    /// The angle in radians.
    pub angle: f64,
    /// The unit vectors `n × u`, `n × v` along which a turn of either moves it.
    pub across: [V; 2],
}

/// Vectors that meet in joints: of the plane, where angles are signed, and of space, where they are not.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::Jointed;
/// use std::f64::consts::FRAC_PI_2;
/// let (east, south) = (vector![1.0, 0.0], vector![0.0, -1.0]);
/// assert_eq!(Jointed::turn_to(&east, &south).angle, -FRAC_PI_2);
/// let (east, south) = (vector![1.0, 0.0, 0.0], vector![0.0, -1.0, 0.0]);
/// assert_eq!(Jointed::turn_to(&east, &south).angle, FRAC_PI_2);
/// ```
pub trait Jointed: Turnable<f64> + Copy {
    /// The angle between the unit vectors `self` and `next`.
    fn turn_to(&self, next: &Self) -> Turn<Self>;

    /// How a joint that should have the angle `wanted` resists: for each plane it may turn in a vector across `self` and one
    /// across `next`, by whose products with the turns of both it is turned. Their size says how stiff it is.
    ///
    /// The angle in space does not change to first order if one vector leaves the plane of both. By second derivatives the
    /// joint resists that by the share `(θ - wanted) / tan θ`, all of it if it is straight and should be.
    fn hinges(&self, next: &Self, wanted: f64) -> impl Iterator<Item = [Self; 2]>;

    /// By how much the angle `wanted` exceeds `found`; in the plane up to whole turns, in `(-π, π]`.
    fn excess(wanted: f64, found: f64) -> f64;
}

impl Jointed for SVector<f64, 2> {
    fn turn_to(&self, next: &Self) -> Turn<Self> {
        let left = |v: &Self| vector![-v[1], v[0]];
        Turn { angle: cross2(self, next).atan2(self.dot(next)), across: [left(self), left(next)] }
    }

    fn hinges(&self, next: &Self, _: f64) -> impl Iterator<Item = [Self; 2]> {
        std::iter::once(self.turn_to(next).across)
    }

    fn excess(wanted: f64, found: f64) -> f64 {
        match wanted - found {
            excess if excess > PI => excess - TAU,
            excess if excess <= -PI => excess + TAU,
            excess => excess,
        }
    }
}

impl Jointed for SVector<f64, 3> {
    /// Vectors along one line, the same way or opposite, have no `n`. Then `across` is zero, the mean of all ways to leave
    /// the line: the gradient of `(θ - θ_0)²` if `θ_0` is the angle found, else a rest that the least deviation ends.
    fn turn_to(&self, next: &Self) -> Turn<Self> {
        let normal = cross3(self, next);
        let sine = normal.norm();
        let normal = if sine > 0.0 { normal / sine } else { normal };
        Turn { angle: sine.atan2(self.dot(next)), across: [cross3(&normal, self), cross3(&normal, next)] }
    }

    fn hinges(&self, next: &Self, wanted: f64) -> impl Iterator<Item = [Self; 2]> {
        let normal = cross3(self, next);
        let sine = normal.norm();
        let normal = if sine > 0.0 { normal / sine } else { across(self) };
        let found = sine.atan2(self.dot(next));
        let weight = if sine > 0.0 { ((found - wanted) / found.tan()).abs() } else { 1.0 };
        let over = normal * weight.clamp(SOFT, 1.0).sqrt();
        [[cross3(&normal, self), cross3(&normal, next)], [over, over]].into_iter()
    }

    fn excess(wanted: f64, found: f64) -> f64 {
        wanted - found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_of_signed_angles_are_short() {
        type V = SVector<f64, 2>;
        assert!((V::excess(3.0, -3.0) - (6.0 - TAU)).abs() < 1e-15);
        assert!((V::excess(-3.0, 3.0) - (TAU - 6.0)).abs() < 1e-15);
        assert_eq!((V::excess(PI, 0.0), V::excess(-PI, 0.0), V::excess(1.0, 0.5)), (PI, PI, 0.5));
    }

    #[test]
    fn unsigned_angles_are_accurate_at_both_ends() {
        let u: SVector<f64, 3> = vector![1.0, 0.0, 0.0];
        for e in [1e-150, 1e-17, 1e-8, 1e-3] {
            let near = vector![1.0, e, 0.0].normalize();
            assert!((u.turn_to(&near).angle / f64::atan(e) - 1.0).abs() < 4e-16);
            assert!((PI - u.turn_to(&-near).angle - e).abs() < 1e-9);
            assert!((u.turn_to(&near).across[0] - vector![0.0, 1.0, 0.0]).norm() < 1e-15);
        }
        let still = SVector::zeros();
        assert_eq!(u.turn_to(&u), Turn { angle: 0.0, across: [still; 2] });
        assert_eq!(u.turn_to(&-u), Turn { angle: PI, across: [still; 2] });
    }
}
