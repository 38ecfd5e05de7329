//! Rotations with scaling from one vector to another: a complex factor in the plane, in space the rotation by the least angle.

use crate::coeff::Coeff;
use crate::scalar::{Real, Scalar, larger};
use crate::vector::{cross3, dot, unit};
use nalgebra::{SVector, vector};

/// Vectors with a rotation and scaling from one to another.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Q, Scalar, Turnable};
/// let [from, to] = [vector![Q::int(1), Q::int(0)], vector![Q::int(0), Q::int(2)]];
/// let turn = Turnable::turn(&from, &to).expect("`from` is not zero");
/// assert_eq!(turn(&to), vector![Q::int(-4), Q::int(0)]);
/// ```
pub trait Turnable<T: Scalar>: Coeff<T> {
    /// The similarity, without reflection, that takes `from` to `to`; nothing if one of them has no direction.
    fn turn(from: &Self, to: &Self) -> Option<impl Fn(&Self) -> Self + use<Self, T>>;
}

impl<T: Scalar> Turnable<T> for SVector<T, 2> {
    /// Multiplication by the complex number `to / from`.
    fn turn(from: &Self, to: &Self) -> Option<impl Fn(&Self) -> Self + use<T>> {
        // Of the order of one, so that squares neither overflow nor vanish.
        let size = larger(from[0].magnitude(), from[1].magnitude());
        if size.is_zero() {
            return None;
        }
        let [from, to] = [from, to].map(|v| v.map(|x| x / &size));
        let square = dot(&from, &from);
        let re = dot(&to, &from) / &square;
        let im = (to[1].clone() * &from[0] - to[0].clone() * &from[1]) / square;
        Some(move |v: &Self| {
            let [x, y] = [&v[0], &v[1]];
            vector![re.clone() * x - im.clone() * y, im.clone() * x + re.clone() * y]
        })
    }
}

impl<T: Real> Turnable<T> for SVector<T, 3> {
    /// The rotation by the least angle, about `from × to`, and the scaling `|to| / |from|`.
    ///
    /// The rotation is two reflections: the first takes `from` to the other side of the plane across half the angle,
    /// the second turns it about. Both stay orthogonal however near the angle is to half a turn.
    fn turn(from: &Self, to: &Self) -> Option<impl Fn(&Self) -> Self + use<T>> {
        let ((start, from), (end, to)) = (unit(from)?, unit(to)?);
        let scale = to / from;
        let middle = unit(&(&start + &end));
        // Half a turn has no least axis: take one across `from`, near the coordinate axis it leans to least.
        let (first, second) = match middle {
            Some((middle, _)) => (middle, end),
            None => (start.clone(), cross3(&across(&start), &start)),
        };
        Some(move |v: &Self| reflected(&reflected(v, &first), &second).scaled(&scale))
    }
}

/// The mirror image of `v` in the plane through the origin across the unit vector `normal`.
fn reflected<T: Real>(v: &SVector<T, 3>, normal: &SVector<T, 3>) -> SVector<T, 3> {
    v.plus_scaled(&(T::int(-2) * dot(v, normal)), normal)
}

/// A unit vector across `v`.
pub(crate) fn across<T: Real>(v: &SVector<T, 3>) -> SVector<T, 3> {
    let least = if v[0].magnitude() <= v[1].magnitude() && v[0].magnitude() <= v[2].magnitude() {
        vector![T::one(), T::zero(), T::zero()]
    } else if v[1].magnitude() <= v[2].magnitude() {
        vector![T::zero(), T::one(), T::zero()]
    } else {
        vector![T::zero(), T::zero(), T::one()]
    };
    unit(&cross3(v, &least)).expect("an axis that `v` leans to least is not parallel to it").0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_near_half_a_turn_are_similarities() {
        let from = vector![1.0, 0.0, 0.0];
        for e in [0.0, 1e-300, 1e-12, 1e-8, 2e-8, 1e-7, 1e-6, 1e-3, 1.0] {
            let to = vector![-2.0, 2.0 * e, 0.0];
            let turn = Turnable::turn(&from, &to).unwrap();
            let scale = to.norm();
            assert!((turn(&from) - to).norm() <= 1e-7 * scale, "{e}");
            let images = [vector![1.0, 0.0, 0.0], vector![0.0, 1.0, 0.0], vector![0.0, 0.0, 1.0]]
                .map(|v| turn(&v) / scale);
            for (i, u) in images.iter().enumerate() {
                for (j, v) in images.iter().enumerate() {
                    let expected = if i == j { 1.0 } else { 0.0 };
                    assert!((u.dot(v) - expected).abs() < 1e-14, "{e}");
                }
            }
        }
    }

    #[test]
    fn small_and_large_chords_turn_alike() {
        for size in [1e-300, 1e-160, 1.0, 1e155, 1e300] {
            let turn =
                Turnable::turn(&vector![3.0 * size, 4.0 * size], &vector![-4.0 * size, 3.0 * size]).unwrap();
            assert!((turn(&vector![1.0, 0.0]) - vector![0.0, 1.0]).norm() < 1e-15, "{size}");
        }
    }

    #[test]
    fn no_direction_no_turn() {
        let zero = vector![0.0, 0.0];
        assert!(Turnable::turn(&zero, &vector![1.0, 0.0]).is_none());
    }
}
