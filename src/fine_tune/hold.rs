//! Ends put back after fine tuning, by one similarity.
//!
//! With `Q_0 ... Q_N` the control points of the tuned curve and `I_0 ... I_N` those of the invariant curve (`α = 1`)
//! over the same knots,
//!
//! ```text
//! Q'_k = I_k                        k < j or k > N - j
//! Q'_k = I_j + Z (Q_k - Q_j)        j <= k <= N - j
//! ```
//! where `Z` is the rotation and scaling that takes `Q_{N-j} - Q_j` to `I_{N-j} - I_j`; `j` is 0 to hold the end
//! points, 1 to hold the tangents too, 2 to hold the curvatures too [Miura, 2.1]. In the plane `Z` is a complex
//! factor, hence rational; in space it is the rotation by the least angle, which needs square roots.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::scalar::{Real, Scalar, larger};
use crate::spline::{Curve, Function, Spline};
use crate::vector::{cross3, dot, unit};
use nalgebra::{SVector, vector};

/// What stays in place at both ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Hold {
    /// The end points.
    Points,
    /// End points and first derivatives.
    Tangents,
    /// End points, first and second derivatives.
    Curvatures,
}

impl Hold {
    /// The index `j` of the control points that are matched.
    fn depth(self) -> usize {
        match self {
            Self::Points => 0,
            Self::Tangents => 1,
            Self::Curvatures => 2,
        }
    }
}

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
fn across<T: Real>(v: &SVector<T, 3>) -> SVector<T, 3> {
    let least = if v[0].magnitude() <= v[1].magnitude() && v[0].magnitude() <= v[2].magnitude() {
        vector![T::one(), T::zero(), T::zero()]
    } else if v[1].magnitude() <= v[2].magnitude() {
        vector![T::zero(), T::one(), T::zero()]
    } else {
        vector![T::zero(), T::zero(), T::one()]
    };
    unit(&cross3(v, &least)).expect("an axis that `v` leans to least is not parallel to it").0
}

impl<T: Scalar, const N: usize> Curve<T, N>
where
    SVector<T, N>: Turnable<T>,
{
    /// The curve with its derivative multiplied by `alpha`, then rotated and scaled so that its ends are held.
    ///
    /// With [`Hold::Points`] the result is similar to [`fine_tuned`](Curve::fine_tuned), so its curvature is that one's
    /// times one constant. The other holds change the first and last span besides. Plane curves are exact over any
    /// field, space curves need a [`Real`].
    ///
    /// # Errors
    /// [`Error::NoChord`] if the matched points of the curve coincide at both ends, as in a closed curve: no scaling
    /// puts them in place. [`Error::CoefficientCount`] if the result has fewer than `2 j + 2` control points. Those of
    /// [`fine_tuned`](Curve::fine_tuned).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, Function, Hold, Q, Scalar, SplineSpace};
    /// let q = |x: i64, y: i64| vector![Q::int(x), Q::int(y)];
    /// let curve = Curve::new(SplineSpace::bezier(2, Q::int(0), Q::int(1))?, vec![q(0, 0), q(1, 2), q(2, 0)])?;
    /// let alpha = Function::new(SplineSpace::bezier(1, Q::int(0), Q::int(1))?, vec![Q::int(1), Q::int(2)])?;
    /// let tuned = curve.fine_tuned_holding(&alpha, Hold::Points)?;
    /// assert_eq!(tuned.at(&Q::int(1))?, q(2, 0));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn fine_tuned_holding(&self, alpha: &Function<T>, hold: Hold) -> Result<Self> {
        let tuned = self.fine_tuned(alpha)?;
        let invariant = self.clamped_ends()?.embedded(tuned.space())?;
        held(&tuned, &invariant, hold)
    }
}

/// `tuned` with its end control points put where those of `invariant` are, both over the same knots.
fn held<T: Scalar, const N: usize>(
    tuned: &Curve<T, N>,
    invariant: &Curve<T, N>,
    hold: Hold,
) -> Result<Curve<T, N>>
where
    SVector<T, N>: Turnable<T>,
{
    let (q, i, j) = (tuned.coeffs(), invariant.coeffs(), hold.depth());
    if q.len() < 2 * j + 2 {
        return Err(Error::CoefficientCount { expected: 2 * j + 2, found: q.len() });
    }
    let far = q.len() - 1 - j;
    let chord = |points: &[SVector<T, N>]| points[far].minus(&points[j]);
    let (source, target) = (chord(q), chord(i));
    let turn = SVector::turn(&source, &target).filter(|_| !target.vanishes()).ok_or(Error::NoChord)?;
    let place = |k: usize| match k {
        // The matched points themselves, without rounding.
        k if k <= j || k >= far => i[k].clone(),
        k => {
            let mut point = turn(&q[k].minus(&q[j]));
            point.add_scaled(&T::one(), &i[j]);
            point
        }
    };
    Spline::new(tuned.space().clone(), (0..q.len()).map(place).collect())
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
