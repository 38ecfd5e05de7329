//! Fine tuning of one curve by many scale functions, while a value of `α` is dragged: the map `α ↦ D` prepared.
//!
//! Tuning takes a short sum for each control point. To hold the ends it takes the chord of `D` as well, one row over the
//! values of `α`, and a rotation for each control point; to meet conditions, one small matrix on the values of `α` first.

use crate::coeff::Coeff;
use crate::constrain::norm::Norm;
use crate::error::{Error, Result};
use crate::fine_tune::condition::Condition;
use crate::fine_tune::ends::Ends;
use crate::fine_tune::hold::Hold;
use crate::fine_tune::nearest_scale::NearestScale;
use crate::fine_tune::scale_space::check_values;
use crate::fine_tune::table::Table;
use crate::fine_tune::turn::Turnable;
use crate::functional::weigh;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Curve;
use nalgebra::SVector;

/// A curve prepared for fine tuning by scale functions of one space.
///
/// # Examples
/// ```
/// use nalgebra::{SVector, vector};
/// use symspline::{Curve, FineTuner, Function, Hold, SplineSpace};
/// let points = vec![vector![0.0, 0.0], vector![1.0, 2.0], vector![2.0, 0.0]];
/// let curve = Curve::new(SplineSpace::bezier(2, 0.0, 1.0)?, points)?;
/// let scales = SplineSpace::bezier(1, 0.0, 1.0)?;
/// let tuner = FineTuner::prepare(&curve, &scales, Hold::Start)?;
/// let mut places = vec![SVector::zeros(); tuner.space().dim()];
/// for last in [1.0, 1.5, 2.0] {
///     tuner.tune_into(&[1.0, last], &mut places)?;
/// }
/// let alpha = Function::new(scales, vec![1.0, 2.0])?;
/// assert_eq!(places, curve.fine_tuned(&alpha)?.coeffs());
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct FineTuner<T: Scalar, const N: usize> {
    table: Table<T, N>,
    held: Option<HeldEnds<T, N>>,
    nearest: Option<NearestScale<T>>,
    /// Whether scale functions may have any sign.
    signed: bool,
}

/// What it takes to put the ends back.
#[derive(Clone, Debug)]
struct HeldEnds<T: Scalar, const N: usize> {
    ends: Ends<T, N>,
    /// Control points before this one and after its mirror image are matched.
    depth: usize,
    /// The chord between the matched points, from the values of `α`.
    chord: Vec<SVector<T, N>>,
    /// [`FineTuner::tune_held`], known where the vectors are known to turn.
    tune: TuneHeld<T, N>,
}

type TuneHeld<T, const N: usize> =
    fn(&FineTuner<T, N>, &HeldEnds<T, N>, alpha: &[T], points: &mut [SVector<T, N>]) -> Result<()>;

impl<T: Scalar, const N: usize> FineTuner<T, N> {
    /// The map from scale functions in `scales` to [fine-tuned](Curve::fine_tuned) curves, with the start held.
    ///
    /// # Errors
    /// [`DomainMismatch`](Error::DomainMismatch), [`Discontinuous`](Error::Discontinuous),
    /// [`NotFinite`](Error::NotFinite) as [`fine_tuned`](Curve::fine_tuned) has them; [`TooLarge`](Error::TooLarge).
    pub fn free(curve: &Curve<T, N>, scales: &SplineSpace<T>) -> Result<Self> {
        Ok(Self { table: Table::open(curve, scales)?, held: None, nearest: None, signed: false })
    }

    /// As [`free`](Self::free), by the [nearest](NearestScale) scale functions with which the curve meets `conditions`.
    ///
    /// A periodic curve tuned by periodic scale functions under [`Condition::End`] comes back periodic.
    ///
    /// # Errors
    /// Those of [`free`](Self::free) and [`NearestScale::prepare`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Condition, Curve, FineTuner, Norm, Q, Scalar, SplineSpace};
    /// let polygon = [(0, 0), (4, 0), (5, 3), (1, 4)].map(|(x, y)| vector![Q::int(x), Q::int(y)]);
    /// let space = SplineSpace::uniform_periodic(2, 4, Q::int(0), Q::int(1))?;
    /// let curve = Curve::new(space.clone(), polygon.to_vec())?;
    /// let scales = space.derivative_space()?;
    /// let tuner = FineTuner::constrained(&curve, &scales, &[Condition::End], Norm::Coefficients)?;
    /// let tuned = tuner.tuned(&[2, 4, 3, 2].map(|a| Q::frac(a, 2)))?;
    /// assert!(tuned.space().is_periodic());
    /// assert_eq!(tuned.at(&Q::int(0))?, curve.at(&Q::int(0))?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn constrained(
        curve: &Curve<T, N>,
        scales: &SplineSpace<T>,
        conditions: &[Condition<T, N>],
        norm: Norm,
    ) -> Result<Self> {
        let closes = conditions.contains(&Condition::End);
        let table = if closes && curve.space().is_periodic() && scales.is_periodic() {
            Table::ring(curve, scales)?
        } else {
            Table::open(curve, scales)?
        };
        let nearest = Some(NearestScale::prepare(curve, scales, conditions, norm)?);
        Ok(Self { table, held: None, nearest, signed: false })
    }

    /// As [`free`](Self::free), with the ends put back as `hold` says.
    ///
    /// # Errors
    /// Those of [`free`](Self::free); [`NoChord`](Error::NoChord) if the curve itself is closed;
    /// [`CoefficientCount`](Error::CoefficientCount) if the result has too few control points for `hold`.
    pub fn prepare(curve: &Curve<T, N>, scales: &SplineSpace<T>, hold: Hold) -> Result<Self>
    where
        SVector<T, N>: Turnable<T>,
    {
        let mut tuner = Self::free(curve, scales)?;
        if let Some(depth) = hold.depth() {
            let invariant = curve.clamped_ends()?.embedded(tuner.space())?;
            let ends = Ends::of(invariant.coeffs(), [depth, depth])?;
            // A closed curve has no chord either way.
            drop(ends.turn(&SVector::repeat(T::one()))?);
            let chord = tuner.table.moments(depth..invariant.coeffs().len() - 1 - depth);
            tuner.held = Some(HeldEnds { ends, depth, chord, tune: Self::tune_held });
        }
        Ok(tuner)
    }

    /// The same without asking for positive scale functions, as [`Scale::Signed`](crate::Scale::Signed).
    pub fn signed(self) -> Self {
        Self { signed: true, ..self }
    }

    /// The space of the tuned curves.
    pub fn space(&self) -> &SplineSpace<T> {
        &self.table.space
    }

    /// The space of the scale functions.
    pub fn scales(&self) -> &SplineSpace<T> {
        &self.table.scales
    }

    /// The curve tuned by the scale function with these coefficients.
    ///
    /// # Errors
    /// Those of [`tune_into`](Self::tune_into); [`NotFinite`](Error::NotFinite) on overflow.
    pub fn tuned(&self, alpha: &[T]) -> Result<Curve<T, N>> {
        let mut points = vec![SVector::zeros(); self.space().dim()];
        self.tune_into(alpha, &mut points)?;
        Curve::new(self.space().clone(), points)
    }

    /// Writes the control points of the [tuned](Self::tuned) curve to `points`. While the values of `alpha` are positive
    /// nothing is searched; other scale functions are first proved to be positive. Under conditions `alpha` is what is wanted,
    /// and a nearest scale function that is not positive takes a quadratic program.
    ///
    /// # Errors
    /// Those of [`NearestScale::to`] under conditions;
    /// [`CoefficientCount`](Error::CoefficientCount) unless `alpha` has as many values as its space and `points` as many
    /// places as [`space`](Self::space); [`NotFinite`](Error::NotFinite) if a value of `alpha` is not finite (overflow on the
    /// way to `points` is not looked for, but by [`tuned`](Self::tuned)); [`NotPositive`](Error::NotPositive) and [`Undecided`](Error::Undecided) as
    /// [`fine_tuned`](Curve::fine_tuned); [`NoChord`](Error::NoChord) if the tuned curve is closed but its ends are to be
    /// held. Then `points` is as it was.
    pub fn tune_into(&self, alpha: &[T], points: &mut [SVector<T, N>]) -> Result<()> {
        if points.len() != self.space().dim() {
            return Err(Error::CoefficientCount { expected: self.space().dim(), found: points.len() });
        }
        check_values(self.scales(), alpha, self.signed || self.nearest.is_some())?;
        if let Some(nearest) = &self.nearest {
            let nearest = nearest.near(alpha.to_vec(), self.signed)?;
            self.table.tune_into(&nearest, points);
            return Ok(());
        }
        match &self.held {
            Some(held) => (held.tune)(self, held, alpha, points)?,
            None => self.table.tune_into(alpha, points),
        }
        Ok(())
    }

    fn tune_held(&self, held: &HeldEnds<T, N>, alpha: &[T], points: &mut [SVector<T, N>]) -> Result<()>
    where
        SVector<T, N>: Turnable<T>,
    {
        let HeldEnds { ends, depth, chord, .. } = held;
        let turn = ends.turn(&weigh(0, alpha, chord))?;
        let put = |place: &SVector<T, N>| turn(place).plus_scaled(&T::one(), ends.foot());
        self.table.walk(SVector::zeros(), alpha, *depth, points, put);
        for (k, point) in points.iter_mut().enumerate() {
            if let Some(held) = ends.held(k) {
                point.clone_from(held);
            }
        }
        Ok(())
    }
}
