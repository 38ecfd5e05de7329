//! Fine tuning of a portion of a curve, while the rest stays what it is.
//!
//! The domain `[a, b]` of the scale function says which portion. The curve is cut there, by knot insertion, and the
//! middle is fine-tuned with its [ends held](crate::fine_tune::hold) [Miura, 2.2].
//!
//! To make one spline of the pieces again nothing is solved. With `I` the curve itself in the space `W` of the result, of
//! degree `p = n + q`, with `Q_k` and `I_k` the control points of the tuned portion and of the portion as it was over the
//! same clamped knots, and with `B_k` their basis functions,
//!
//! ```text
//! I + Σ_k (Q_k - I_k) B_k          j < k < N - j,  since the others are held: Q_k = I_k
//! ```
//! These `B_k` and their derivatives up to order `j` vanish at `a` and `b`. So they are basis functions of `W` as well if
//! it has `p - j` copies of `a` and `b`: there control points are copied, and everywhere else `I` stays.

use crate::constrain::norm::Norm;
use crate::error::{Error, Result};
use crate::fine_tune::condition::Condition;
use crate::fine_tune::hold::{Held, Hold};
use crate::fine_tune::nearest_scale::NearestScale;
use crate::fine_tune::place::{Inside, room_for};
use crate::fine_tune::scale::Scale;
use crate::fine_tune::turn::Turnable;
use crate::scalar::Scalar;
use crate::spline::{Curve, Function};
use nalgebra::SVector;

/// A curve with a portion of it fine-tuned, in up to three pieces.
///
/// The pieces before and after are the curve as it was. How the portion meets them is what the [`Hold`] says: with
/// [`Hold::Points`] the values agree (`C0`), while tangents are rotated with the portion; with [`Hold::Tangents`] first
/// derivatives agree too (`C1`, hence `G1`), with [`Hold::Curvatures`] second ones besides (`C2`, hence `G2`), all as far
/// as the curve itself was as smooth. With [`Hold::Start`], for a portion up to the end of the curve, the values agree
/// and, if the scale is positive there, the directions of the tangents (`G1`).
#[derive(Clone, Debug, PartialEq)]
pub struct LocallyTuned<T: Scalar, const N: usize> {
    original: Curve<T, N>,
    before: Option<Curve<T, N>>,
    tuned: Held<T, N>,
    after: Option<Curve<T, N>>,
    order: usize,
}

impl<T: Scalar, const N: usize> LocallyTuned<T, N> {
    /// The whole curve as it was.
    pub fn original(&self) -> &Curve<T, N> {
        &self.original
    }

    /// The piece before the portion, with clamped ends; none if the portion begins where the curve does.
    pub fn before(&self) -> Option<&Curve<T, N>> {
        self.before.as_ref()
    }

    /// The portion, tuned, with its ends held.
    pub fn tuned(&self) -> &Held<T, N> {
        &self.tuned
    }

    /// The piece after the portion, with clamped ends; none if the portion ends where the curve does.
    pub fn after(&self) -> Option<&Curve<T, N>> {
        self.after.as_ref()
    }

    /// The order of the derivatives that agree with those of the curve at both ends of the portion: 0 for the points alone, 1
    /// for tangents, 2 for curvatures.
    pub fn order(&self) -> usize {
        self.order
    }

    /// Start and end of the portion.
    pub fn portion(&self) -> (&T, &T) {
        self.tuned.curve.domain()
    }

    /// The curve with this in the place of a portion.
    fn around(original: &Curve<T, N>, tuned: Held<T, N>, order: usize) -> Result<Self> {
        let ((start, end), (a, b)) = (original.domain(), tuned.curve.domain());
        let piece = |a: &T, b: &T| (a != b).then(|| original.restricted(a, b)).transpose();
        let (before, after) = (piece(start, a)?, piece(b, end)?);
        Ok(Self { original: original.clone(), before, tuned, after, order })
    }

    /// The pieces as one spline, of degree `n + q` if the scale function has degree `q`.
    ///
    /// Inside the portion it has the knots of the tuned piece, outside those of the [elevated](Curve::elevated) curve. The
    /// ends of the portion get `n + q` copies for held points, `n + q - 1` for tangents, `n + q - 2` for curvatures; more
    /// only where the curve was rougher. A periodic curve stays periodic. An unclamped end of the domain becomes a clamped
    /// one if the portion reaches it.
    ///
    /// Exact over an exact field. Control points whose basis functions lie inside the portion are those of
    /// [`tuned`](Self::tuned), the others those of the elevated curve with these knots inserted, copied where no knot is
    /// new; in `f64` that holds to the bit, and the order of continuity at `a` and `b` is that of the space, not subject to
    /// rounding. In values it then differs from the pieces by the rounding of elevation and insertion.
    ///
    /// # Errors
    /// [`Error::DegreeTooHigh`], [`Error::TooLarge`]; [`Error::SpanOutOfRange`] if in `f64` knots are too near.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, Function, Hold, Q, Scalar, SplineSpace};
    /// let points = [(0, 0), (1, 2), (3, 2), (4, 0)].map(|(x, y)| vector![Q::int(x), Q::int(y)]).to_vec();
    /// let curve = Curve::new(SplineSpace::clamped(2, [0, 2, 4].map(Q::int))?, points)?;
    /// let alpha = Function::new(SplineSpace::bezier(1, Q::int(1), Q::int(3))?, vec![Q::int(1), Q::int(2)])?;
    /// let whole = curve.fine_tuned_on(&alpha, Hold::Tangents)?.joined()?;
    /// let breaks = [(0, 4), (1, 2), (2, 2), (3, 2), (4, 4)].map(|(t, copies)| (Q::int(t), copies));
    /// assert_eq!((whole.degree(), whole.space().breaks()), (3, breaks.to_vec()));
    /// assert_eq!(whole.at(&Q::frac(1, 2))?, curve.at(&Q::frac(1, 2))?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn joined(&self) -> Result<Curve<T, N>> {
        self.with_portion(&self.tuned.curve)
    }

    /// The whole curve with `portion` in the place of what it was there, and as smooth as what is held allows: `portion` is
    /// clamped, has the knots that the curve has inside, and its derivatives at the ends that are held.
    pub(crate) fn with_portion(&self, portion: &Curve<T, N>) -> Result<Curve<T, N>> {
        let space = room_for(self.original.space(), portion.space(), [self.order(); 2])?;
        let mut points = self.original.embedded(&space)?.into_coeffs();
        Inside::of(&space, portion.space()).copy(portion.coeffs(), &mut points);
        Curve::new(space, points)
    }
}

impl<T: Scalar, const N: usize> Curve<T, N>
where
    SVector<T, N>: Turnable<T>,
{
    /// The curve with the portion over the domain of `alpha` fine-tuned, and the rest as it is.
    ///
    /// The domain `[a, b]` of `alpha` lies inside that of the curve; its ends need not be knots. What `hold` says is held
    /// at both ends of the portion, at a free end of the curve too. A jump of the curve at `a` or `b` or outside the portion
    /// stays as it is. Of a periodic curve the portion may end at the seam but not go over it;
    /// [`with_seam_at`](Curve::with_seam_at) puts the seam elsewhere.
    ///
    /// A portion with few knots has few control points: with held tangents or curvatures there may be none left to move, so
    /// that the curve comes back, or too few to hold anything. Then give `alpha` knots.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`] unless `[a, b]` lies inside the domain; [`Error::Discontinuous`] if the curve may jump inside
    /// the portion; [`Error::NoChord`] if its matched points coincide; [`Error::EndsDoNotMeet`] with [`Hold::Start`], unless
    /// the portion ends where an open curve does, or happens to come out at the point where the rest begins. The others of
    /// [`fine_tuned_holding`](Self::fine_tuned_holding); [`Error::SpanOutOfRange`] if in `f64` knots are too near.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, Function, Hold, Q, Scalar, SplineSpace};
    /// let points = [(0, 0), (1, 2), (3, 2), (4, 0)].map(|(x, y)| vector![Q::int(x), Q::int(y)]).to_vec();
    /// let curve = Curve::new(SplineSpace::clamped(2, [0, 2, 4].map(Q::int))?, points)?;
    /// let alpha = Function::new(SplineSpace::bezier(1, Q::int(1), Q::int(3))?, vec![Q::int(1), Q::int(2)])?;
    /// let local = curve.fine_tuned_on(&alpha, Hold::Tangents)?;
    /// let end = local.before().map(|piece| piece.derivatives_at(&Q::int(1), 1)).transpose()?;
    /// assert_eq!(end, Some(local.tuned().curve.derivatives_at(&Q::int(1), 1)?));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "local fine tuning")]
    pub fn fine_tuned_on<'a>(
        &self,
        alpha: impl Into<Scale<'a, Function<T>>>,
        hold: Hold,
    ) -> Result<LocallyTuned<T, N>> {
        let alpha = alpha.into().function()?;
        let (end, (a, b)) = (self.domain().1, alpha.domain());
        let middle = self.restricted(a, b)?;
        let tuned = middle.fine_tuned_holding(Scale::Signed(alpha), hold)?;
        let goes_on = b != end || self.space().is_periodic();
        if hold == Hold::Start && goes_on {
            let last = |curve: &Self| curve.coeffs()[curve.coeffs().len() - 1].clone();
            let (left, right) = (last(&tuned.curve), last(&middle));
            if left != right {
                return Err(Error::EndsDoNotMeet { left: format!("{left:?}"), right: format!("{right:?}") });
            }
        }
        LocallyTuned::around(self, tuned, hold.depth().unwrap_or(0))
    }
}

impl<T: Scalar, const N: usize> Curve<T, N> {
    /// As [`fine_tuned_on`](Self::fine_tuned_on), by the [nearest](NearestScale) positive scale function with which the portion
    /// ends where it did, and derivatives up to `order` stay at both ends: no similarity turns the portion, so every tangent
    /// keeps its direction, and `κ_D = κ / α` holds inside it.
    ///
    /// Order 0 meets the rest with `C0` and `G1`, order 1 with `C1` and `G2`, since `α = 1` there keeps the curvature too, and
    /// order 2 with `C2`, all as far as the curve itself was as smooth.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`] unless the domain of `wanted` lies inside that of the curve; [`Error::Discontinuous`] if the curve
    /// may jump inside the portion; those of [`NearestScale::to`]; [`Error::SpanOutOfRange`] if in `f64` knots are too near.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, Function, Norm, Q, Scalar, SplineSpace};
    /// let points = [(0, 0), (1, 2), (3, 2), (4, 0)].map(|(x, y)| vector![Q::int(x), Q::int(y)]).to_vec();
    /// let curve = Curve::new(SplineSpace::clamped(2, [0, 2, 4].map(Q::int))?, points)?;
    /// let scales = SplineSpace::uniform(2, 6, Q::int(1), Q::int(3))?;
    /// let wanted = Function::constant(scales, Q::int(1))?.dragged(&Q::int(2), Q::int(3), Norm::Coefficients)?;
    /// let local = curve.fine_tuned_on_by_nearest(&wanted, 1, Norm::L2)?;
    /// let end = local.after().map(|piece| piece.derivatives_at(&Q::int(3), 1)).transpose()?;
    /// assert_eq!(end, Some(local.tuned().curve.derivatives_at(&Q::int(3), 1)?));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn fine_tuned_on_by_nearest(
        &self,
        wanted: &Function<T>,
        order: usize,
        norm: Norm,
    ) -> Result<LocallyTuned<T, N>> {
        let (a, b) = wanted.domain();
        let middle = self.restricted(a, b)?;
        let kept = |parameter: &T| Condition::Derivatives { parameter: parameter.clone(), count: order };
        let conditions = [Condition::End, kept(a), kept(b)];
        let alpha = NearestScale::prepare(&middle, wanted.space(), &conditions, norm)?.to(wanted)?;
        LocallyTuned::around(self, Held::free(middle.fine_tuned(&alpha)?), order)
    }
}
