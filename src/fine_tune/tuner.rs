//! Fine tuning of one curve by many scale functions: the map `α ↦ D` prepared.
//!
//! `D` is linear in `α` but for its start, and the differences of its control points depend on few values of `α` each:
//!
//! ```text
//! d_0 = C(a),   d_{i+1} = d_i + Σ_j α_j l_ij          l_ij: control point i of φ_j C', times (τ_{i+m+1} - τ_i) / (m + 1)
//! ```
//!
//! with `φ_j` the basis of the scale functions, `m` and `τ` degree and knots of `φ_j C'`. So tuning takes a short sum for
//! each control point, while a value of `α` is dragged. To hold the ends it takes the chord of `D` as well, one row over
//! the values of `α`, and a rotation for each control point.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::fine_tune::hold::{Ends, Hold, Turnable};
use crate::functional::weigh;
use crate::limits::check_entries;
use crate::map::LinearMap;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::{Curve, Function};
use nalgebra::SVector;
use std::ops::Range;

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
pub struct FineTuner<T, const N: usize> {
    start: SVector<T, N>,
    space: SplineSpace<T>,
    scales: SplineSpace<T>,
    /// For each axis the differences of control points as rows over the values of `α`.
    legs: Vec<LinearMap<T>>,
    held: Option<HeldEnds<T, N>>,
    /// Whether scale functions may have any sign.
    signed: bool,
}

/// What it takes to put the ends back.
#[derive(Clone, Debug)]
struct HeldEnds<T, const N: usize> {
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
        let speed = curve.derivative()?.clamped_ends()?;
        let opened = scales.clamped_ends()?;
        let opening = scales.embedding(&opened)?;
        let product = speed.space().multiplication(&opened)?;
        let scaled = speed.space().product_space(&opened)?;
        check_entries(scaled.dim(), N * (scales.degree() + 1))?;
        let legs = |axis: usize| {
            let speeds: Vec<T> = speed.coeffs().iter().map(|c| c[axis].clone()).collect();
            let table = product.fix_left(&speeds)?.after(&opening)?;
            let mut legs = LinearMap::empty(table.source_dim(), table.target_dim());
            for (i, (first, weights)) in table.rows().enumerate() {
                let mass = scaled.mass(i);
                legs.push(first, |row| row.extend(weights.iter().map(|w| mass.clone() * w)));
            }
            Ok(legs)
        };
        Ok(Self {
            start: curve.at(curve.domain().0)?,
            space: scaled.antiderivative_space()?,
            scales: scales.clone(),
            legs: (0..N).map(legs).collect::<Result<_>>()?,
            held: None,
            signed: false,
        })
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
            let invariant = curve.clamped_ends()?.embedded(&tuner.space)?;
            let ends = Ends::of(invariant.coeffs(), depth)?;
            // A closed curve has no chord either way.
            drop(ends.turn(&SVector::repeat(T::one()))?);
            let chord = tuner.moments(depth..invariant.coeffs().len() - 1 - depth);
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
        &self.space
    }

    /// The space of the scale functions.
    pub fn scales(&self) -> &SplineSpace<T> {
        &self.scales
    }

    /// The curve tuned by the scale function with these coefficients.
    ///
    /// # Errors
    /// Those of [`tune_into`](Self::tune_into); [`NotFinite`](Error::NotFinite) on overflow.
    pub fn tuned(&self, alpha: &[T]) -> Result<Curve<T, N>> {
        let mut points = vec![SVector::zeros(); self.space.dim()];
        self.tune_into(alpha, &mut points)?;
        Curve::new(self.space.clone(), points)
    }

    /// Writes the control points of the [tuned](Self::tuned) curve to `points`. While the values of `alpha` are positive
    /// nothing is allocated and nothing searched; other scale functions are first proved to be positive.
    ///
    /// # Errors
    /// [`CoefficientCount`](Error::CoefficientCount) unless `alpha` has as many values as its space and `points` as many
    /// places as [`space`](Self::space); [`NotPositive`](Error::NotPositive) and [`Undecided`](Error::Undecided) as
    /// [`fine_tuned`](Curve::fine_tuned); [`NoChord`](Error::NoChord) if the tuned curve is closed but its ends are to be
    /// held. Then `points` is as it was.
    pub fn tune_into(&self, alpha: &[T], points: &mut [SVector<T, N>]) -> Result<()> {
        let lengths = [(self.scales.dim(), alpha.len()), (self.space.dim(), points.len())];
        if let Some(&(expected, found)) = lengths.iter().find(|(expected, found)| expected != found) {
            return Err(Error::CoefficientCount { expected, found });
        }
        if !self.signed && !alpha.iter().all(|value| *value > T::zero()) {
            Function::new(self.scales.clone(), alpha.to_vec())?.positive_bound()?;
        }
        match &self.held {
            Some(held) => (held.tune)(self, held, alpha, points),
            None => {
                self.walk(self.start.clone(), alpha, 0, points, SVector::clone);
                Ok(())
            }
        }
    }

    fn tune_held(&self, held: &HeldEnds<T, N>, alpha: &[T], points: &mut [SVector<T, N>]) -> Result<()>
    where
        SVector<T, N>: Turnable<T>,
    {
        let HeldEnds { ends, depth, chord, .. } = held;
        let turn = ends.turn(&weigh(0, alpha, chord))?;
        let put = |place: &SVector<T, N>| turn(place).plus_scaled(&T::one(), ends.foot());
        self.walk(SVector::zeros(), alpha, *depth, points, put);
        for (k, point) in points.iter_mut().enumerate() {
            if let Some(held) = ends.held(k) {
                point.clone_from(held);
            }
        }
        Ok(())
    }

    /// Writes the control points from the one with index `from`, which is at `place`, each as `put` makes it.
    fn walk(
        &self,
        mut place: SVector<T, N>,
        alpha: &[T],
        from: usize,
        points: &mut [SVector<T, N>],
        put: impl Fn(&SVector<T, N>) -> SVector<T, N>,
    ) {
        let (last, others) = points.split_last_mut().expect("a space has a coefficient");
        for (i, point) in others.iter_mut().enumerate().skip(from) {
            *point = put(&place);
            for (x, legs) in place.iter_mut().zip(&self.legs) {
                let (first, weights) = legs.row(i);
                *x += weigh(first, weights, alpha);
            }
        }
        *last = put(&place);
    }

    /// The sum of some legs as points to be weighed with the values of `α`.
    fn moments(&self, legs: Range<usize>) -> Vec<SVector<T, N>> {
        let mut moments = vec![SVector::zeros(); self.scales.dim()];
        for (axis, map) in self.legs.iter().enumerate() {
            for (first, weights) in legs.clone().map(|i| map.row(i)) {
                for (k, weight) in weights.iter().enumerate() {
                    let j = (first + k) % self.scales.dim();
                    moments[j][axis] += weight;
                }
            }
        }
        moments
    }
}
