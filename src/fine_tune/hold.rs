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

use crate::analysis::analyse::Analyse;
use crate::analysis::curvature::Curved;
use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::fine_tune::scale::Scale;
use crate::scalar::{Real, Scalar, larger};
use crate::spline::{Curve, Spline};
use crate::vector::{cross3, dot, unit};
use nalgebra::{SVector, vector};

/// What stays in place at both ends.
///
/// Derivatives are those with respect to the parameter: a curve with held tangents, put in the place of the original in a
/// longer one, meets its neighbours with `C1`, one with held curvatures with `C2`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Hold {
    /// The start alone.
    Start,
    /// The end points.
    Points,
    /// End points and first derivatives.
    Tangents,
    /// End points, first and second derivatives.
    Curvatures,
}

impl Hold {
    /// The index `j` of the control points that are matched, if any are.
    pub(crate) fn depth(self) -> Option<usize> {
        match self {
            Self::Start => None,
            Self::Points => Some(0),
            Self::Tangents => Some(1),
            Self::Curvatures => Some(2),
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

/// A fine-tuned curve whose ends were put back, and what that did to it.
///
/// Between the parameters [`similar`](Self::similar) it is the image of the freely tuned curve under one similarity of
/// scale `s`, so its curvature there is `κ / (|α| s)`. Outside, the control points near the ends were put elsewhere than
/// that image has them: [`image`](Self::image) tells by how much.
#[derive(Clone, Debug, PartialEq)]
pub struct Held<T: Scalar, const N: usize> {
    /// The curve with its ends held.
    pub curve: Curve<T, N>,
    /// The whole freely tuned curve under the same similarity, over the same knots.
    pub image: Curve<T, N>,
    /// `s²`, the square of the scale of the similarity.
    pub squared_scale: T,
    /// From where to where the curve is its image; nothing if each span has a control point that was put elsewhere.
    pub similar: Option<(T, T)>,
}

impl<T: Scalar, const N: usize> Held<T, N> {
    /// A curve that no similarity was applied to.
    pub(crate) fn free(curve: Curve<T, N>) -> Self {
        let (a, b) = curve.domain();
        let similar = Some((a.clone(), b.clone()));
        Self { image: curve.clone(), curve, squared_scale: T::one(), similar }
    }

    /// At least the largest distance of the curve from its image: what holding more than the end points took.
    ///
    /// # Errors
    /// [`Error::NotFinite`] on overflow.
    pub fn deviation(&self) -> Result<T> {
        self.curve.distance_bound(&self.image)
    }
}

impl<T: Real, const N: usize> Held<T, N> {
    /// The factor `s` of the similarity: on [`similar`](Self::similar) the curvature was divided by it.
    pub fn scale(&self) -> T {
        self.squared_scale.sqrt()
    }
}

impl<T: Real, const N: usize> Held<T, N>
where
    SVector<T, N>: Curved<T>,
{
    /// The largest difference of curvature between the curve and its image, at `per_span` parameters inside each span:
    /// sampled, not proved.
    ///
    /// # Errors
    /// [`Error::Stationary`] where a curve stands still.
    pub fn curvature_deviation(&self, per_span: usize) -> Result<T> {
        let mut largest = T::zero();
        for span in self.curve.space().breaks().windows(2) {
            let (a, width) = (&span[0].0, span[1].0.clone() - &span[0].0);
            for i in 0..per_span {
                let x = a.clone() + width.clone() * T::frac(2 * i as i64 + 1, 2 * per_span as i64);
                let change = self.curve.curvature_at(&x)? - self.image.curvature_at(&x)?;
                largest = larger(largest, change.magnitude());
            }
        }
        Ok(largest)
    }
}

impl<T: Scalar, const N: usize> Curve<T, N>
where
    SVector<T, N>: Turnable<T>,
{
    /// The curve with its derivative multiplied by `alpha`, then rotated and scaled so that its ends are held.
    ///
    /// With [`Hold::Points`] the result is similar to [`fine_tuned`](Curve::fine_tuned), so its curvature is that one's
    /// times one constant. [`Hold::Tangents`] and [`Hold::Curvatures`] change the first and last span besides. Plane
    /// curves are exact over any field, space curves need a [`Real`].
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
    /// let held = curve.fine_tuned_holding(&alpha, Hold::Points)?;
    /// assert_eq!(held.curve.at(&Q::int(1))?, q(2, 0));
    /// // The freely tuned curve ends at (3, -2/3): from that chord back to one of length 2.
    /// assert_eq!(held.squared_scale, Q::frac(36, 85));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn fine_tuned_holding<'a>(&self, alpha: impl Into<Scale<'a, T>>, hold: Hold) -> Result<Held<T, N>> {
        let Some(j) = hold.depth() else {
            return Ok(Held::free(self.fine_tuned(alpha)?));
        };
        // Where it starts does not matter, and far from the origin a small scale would be lost in rounding.
        let free = self.fine_tuned_from_origin(alpha)?;
        let invariant = self.clamped_ends()?.embedded(free.space())?;
        let ends = Ends::of(invariant.coeffs(), j)?;
        let q = free.coeffs();
        let far = q.len() - 1 - j;
        let chord = q[far].minus(&q[j]);
        let turn = ends.turn(&chord)?;
        let moved = |point: &SVector<T, N>| turn(&point.minus(&q[j])).plus_scaled(&T::one(), ends.foot());
        let image: Vec<_> = q.iter().map(moved).collect();
        let held = (0..q.len()).map(|k| ends.held(k).unwrap_or(&image[k]).clone()).collect();
        let knots = free.space().knots();
        let similar = (knots[free.degree() + j].clone(), knots[q.len() - j].clone());
        Ok(Held {
            curve: Spline::new(free.space().clone(), held)?,
            image: Spline::new(free.space().clone(), image)?,
            squared_scale: squared_ratio(ends.chord(), chord),
            similar: Some(similar).filter(|(start, end)| start < end),
        })
    }
}

/// `|to|² / |from|²`, where the squares themselves may overflow or vanish.
fn squared_ratio<T: Scalar, const N: usize>(mut to: SVector<T, N>, mut from: SVector<T, N>) -> T {
    let mut ratio = T::one();
    if !T::EXACT {
        for (v, up) in [(&mut to, true), (&mut from, false)] {
            let size = v.iter().map(T::magnitude).fold(T::zero(), larger);
            Coeff::divide(v, &size);
            ratio = if up { ratio * size } else { ratio / size };
        }
    }
    dot(&to, &to) / dot(&from, &from) * &ratio * ratio
}

/// The control points near the ends of the invariant curve, to which those of a tuned curve are put back.
#[derive(Clone, Debug)]
pub(crate) struct Ends<T, const N: usize> {
    /// `I_0 ... I_j`.
    start: Vec<SVector<T, N>>,
    /// `I_{N-j} ... I_N`.
    end: Vec<SVector<T, N>>,
    /// `N - j`.
    far: usize,
}

impl<T: Scalar, const N: usize> Ends<T, N> {
    /// The ends of the control points `i`, `j + 1` of them on both sides.
    pub(crate) fn of(i: &[SVector<T, N>], j: usize) -> Result<Self> {
        if i.len() < 2 * j + 2 {
            return Err(Error::CoefficientCount { expected: 2 * j + 2, found: i.len() });
        }
        let far = i.len() - 1 - j;
        Ok(Self { start: i[..=j].to_vec(), end: i[far..].to_vec(), far })
    }

    /// `I_j`.
    pub(crate) fn foot(&self) -> &SVector<T, N> {
        &self.start[self.start.len() - 1]
    }

    /// `I_{N-j} - I_j`.
    fn chord(&self) -> SVector<T, N> {
        self.end[0].minus(self.foot())
    }

    /// Control point `k` if it is one of those that are matched, which come without rounding.
    pub(crate) fn held(&self, k: usize) -> Option<&SVector<T, N>> {
        self.start.get(k).or_else(|| self.end.get(k.checked_sub(self.far)?))
    }

    /// The similarity that takes the chord of the tuned curve to this one.
    pub(crate) fn turn(
        &self,
        tuned: &SVector<T, N>,
    ) -> Result<impl Fn(&SVector<T, N>) -> SVector<T, N> + use<T, N>>
    where
        SVector<T, N>: Turnable<T>,
    {
        let chord = self.chord();
        SVector::turn(tuned, &chord).filter(|_| !chord.vanishes()).ok_or(Error::NoChord)
    }
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
