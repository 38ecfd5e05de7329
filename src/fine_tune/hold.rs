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
use crate::error::Result;
use crate::fine_tune::ends::Ends;
use crate::fine_tune::scale::Scale;
use crate::fine_tune::turn::Turnable;
use crate::scalar::{Real, Scalar, larger};
use crate::spline::{Curve, Function, Spline};
use crate::vector::dot;
use nalgebra::SVector;

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
    /// [`Error::NotFinite`](crate::Error::NotFinite) on overflow.
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
    /// [`Error::Stationary`](crate::Error::Stationary) where a curve stands still.
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
    /// [`Error::NoChord`](crate::Error::NoChord) if the matched points of the curve coincide at both ends, as in a closed curve: no scaling
    /// puts them in place. [`Error::CoefficientCount`](crate::Error::CoefficientCount) if the result has fewer than `2 j + 2` control points. Those of
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
    pub fn fine_tuned_holding<'a>(
        &self,
        alpha: impl Into<Scale<'a, Function<T>>>,
        hold: Hold,
    ) -> Result<Held<T, N>> {
        let Some(j) = hold.depth() else {
            return Ok(Held::free(self.fine_tuned(alpha)?));
        };
        // Where it starts does not matter, and far from the origin a small scale would be lost in rounding.
        let free = self.fine_tuned_from_origin(alpha)?;
        let invariant = self.clamped_ends()?.embedded(free.space())?;
        let ends = Ends::of(invariant.coeffs(), [j, j])?;
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
