//! The scale function nearest to a wanted one with which the curve meets conditions exactly.
//!
//! ```text
//! |a - a0|_W least,   R a = t:      a = a0 + W^-1 R^T (R W^-1 R^T)^-1 (t - R a0)
//! ```
//! with the conditions of [`Condition`] as rows. Where that is not positive the program is solved again with the control
//! values of `α` at or above a floor, then with those of finer spaces, which come ever nearer to its values. If already the
//! values of `α` at a few parameters cannot all be at or above the floor, there is no scale function that is.

use crate::constrain::above::{Above, nearest_above};
use crate::constrain::change::LeastChange;
use crate::constrain::independent::independent;
use crate::constrain::norm::Norm;
use crate::error::tune::TuneError;
use crate::error::{Error, Result};
use crate::fine_tune::area::AreaForm;
use crate::fine_tune::condition::{Condition, Rows};
use crate::fine_tune::scale::ScaleFunction;
use crate::fine_tune::scale_space::ScaleSpace;
use crate::functional::Functional;
use crate::limits::check_entries;
use crate::map::LinearMap;
use crate::scalar::{Scalar, larger};
use crate::space::SplineSpace;
use crate::spline::Curve;

/// How often the space is bisected whose control values keep above the floor.
const REFINEMENTS: usize = 3;

/// How many steps with the linear part of an area there are at most, and over an exact field, where numbers grow with each.
const STEPS: usize = 100;
const EXACT_STEPS: usize = 2;

/// How many of them are made in full.
const FULL_STEPS: usize = 20;

/// Conditions on a fine-tuned curve, prepared for finding scale functions that meet them.
///
/// # Examples
/// A closed curve that stays closed, exactly:
/// ```
/// use nalgebra::vector;
/// use symspline::{Condition, Curve, Function, NearestScale, Norm, Q, Scalar, SplineSpace};
/// let polygon = [(0, 0), (4, 0), (5, 3), (1, 4)].map(|(x, y)| vector![Q::int(x), Q::int(y)]);
/// let space = SplineSpace::uniform_periodic(2, 4, Q::int(0), Q::int(1))?;
/// let curve = Curve::new(space.clone(), polygon.to_vec())?;
/// let scales = space.derivative_space()?;
/// let nearest = NearestScale::prepare(&curve, &scales, &[Condition::End], Norm::Coefficients)?;
/// let wanted = Function::new(scales, [2, 4, 3, 2].map(|a| Q::frac(a, 2)).to_vec())?;
/// let alpha = nearest.to(&wanted)?;
/// let tuned = curve.fine_tuned(&alpha)?;
/// assert_eq!(tuned.at(&Q::int(1))?, tuned.at(&Q::int(0))?);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct NearestScale<T: Scalar, S = SplineSpace<T>> {
    change: LeastChange<T, S>,
    /// The area that is to stay, and the condition that says so.
    area: Option<(AreaForm<T>, usize)>,
    norm: Norm,
    targets: Vec<T>,
    sources: Vec<usize>,
    /// What follows from the other conditions, but for rounding, if these do not contradict each other.
    implied: Vec<Implied<T>>,
    floor: T,
}

/// A condition that follows from others, its weights at most about one.
#[derive(Clone, Debug)]
struct Implied<T> {
    row: Functional<T>,
    target: T,
    source: usize,
}

impl<T: Scalar> NearestScale<T> {
    /// The conditions on fine-tuned versions of `curve` by scale functions in `scales`, nearness measured by `norm`.
    ///
    /// # Errors
    /// [`Error::DomainMismatch`]; [`Error::OutsideDomain`] for a parameter of a condition; [`Error::IndexOutOfRange`];
    /// [`Error::NotFinite`]; [`Error::Discontinuous`] if the curve may jump; [`Error::TooLarge`].
    pub fn prepare<const N: usize>(
        curve: &Curve<T, N>,
        scales: &SplineSpace<T>,
        conditions: &[Condition<T, N>],
        norm: Norm,
    ) -> Result<Self> {
        let Rows { rows, targets, sources, area } = Rows::of(curve, scales, conditions)?;
        let area = area.map(|source| AreaForm::of(curve, scales).map(|form| (form, source))).transpose()?;
        Ok(Self { area, ..Self::of_rows(scales, &rows, targets, sources, norm)? })
    }
}

impl<T: Scalar, S: ScaleSpace<T>> NearestScale<T, S> {
    /// The conditions that `rows` have the values `targets`, each row of the condition that `sources` says.
    pub(crate) fn of_rows(
        scales: &S,
        rows: &[Functional<T>],
        targets: Vec<T>,
        sources: Vec<usize>,
        norm: Norm,
    ) -> Result<Self> {
        let change = LeastChange::new(scales, rows, norm)?;
        Ok(Self { change, area: None, norm, targets, sources, implied: Vec::new(), floor: T::frac(1, 100) })
    }

    /// As [`of_rows`](Self::of_rows) for rows of one scale of which many follow from few; in floating point only those are taken
    /// that say more than rounding.
    pub(crate) fn of_independent_rows(
        scales: &S,
        rows: &[Functional<T>],
        targets: &[T],
        sources: &[usize],
        norm: Norm,
    ) -> Result<Self> {
        check_entries(rows.len(), scales.dim())?;
        let taken = independent(rows, scales.dim());
        let chosen = |i: &usize| (rows[*i].clone(), (targets[*i].clone(), sources[*i]));
        let (own, (values, from)): (Vec<_>, (Vec<_>, Vec<_>)) = taken.iter().map(chosen).unzip();
        let others = (0..rows.len()).filter(|i| taken.len() < rows.len() && !taken.contains(i));
        let implied =
            others.map(|i| Implied { row: rows[i].clone(), target: targets[i].clone(), source: sources[i] });
        Ok(Self { implied: implied.collect(), ..Self::of_rows(scales, &own, values, from, norm)? })
    }

    /// The same with another floor, which the control values keep above where the nearest scale function would not be
    /// positive; 1/100 at first.
    ///
    /// # Errors
    /// [`Error::NotPositive`] if it is not positive.
    pub fn above(self, floor: T) -> Result<Self> {
        if floor.is_finite() && floor > T::zero() {
            return Ok(Self { floor, ..self });
        }
        Err(Error::NotPositive { parameter: "of all".into(), value: floor.to_string() })
    }

    /// The space of the scale functions.
    pub fn scales(&self) -> &S {
        self.change.space()
    }

    /// How many conditions there are on the coefficients, those left out that follow from others.
    pub fn rank(&self) -> usize {
        self.change.rank()
    }

    /// The positive scale function nearest to `wanted` that meets the conditions.
    ///
    /// Where the nearest of all is not positive, it is the nearest with control values at or above the
    /// [floor](Self::above), in its own space or, if there is none, in a finer one.
    ///
    /// # Errors
    /// [`Error::Clash`] if the conditions contradict each other; [`TuneError::NoPositiveScale`] if no scale function with values at or
    /// above the [floor](Self::above) meets them, or none was found; [`Error::DomainMismatch`], [`Error::TooSmooth`] unless
    /// `wanted` is in the space; [`Error::Undecided`] if in floating point the search does not end, or rounding is larger than
    /// the floor; [`Error::TooLarge`], [`Error::NotFinite`]. With [`Condition::Area`] over an exact field [`TuneError::AreaElsewhere`]
    /// unless the curve itself meets the other conditions, [`Error::Undecided`] where no step along the line has the area.
    pub fn to(&self, wanted: &S::Function) -> Result<S::Function> {
        self.nearest(wanted, false)
    }

    /// As [`to`](Self::to), whatever the sign of the result is.
    ///
    /// # Errors
    /// As [`to`](Self::to), but for positivity.
    pub fn to_signed(&self, wanted: &S::Function) -> Result<S::Function> {
        self.nearest(wanted, true)
    }

    fn nearest(&self, wanted: &S::Function, signed: bool) -> Result<S::Function> {
        let scales = self.scales();
        scales.function(self.near(scales.coeffs_of(wanted)?, signed)?)
    }

    /// The coefficients of the nearest scale function.
    pub(crate) fn near(&self, wanted: Vec<T>, signed: bool) -> Result<Vec<T>> {
        match &self.area {
            Some((form, source)) => self.near_with_area(&wanted, signed, form, *source),
            None => self.near_linear(wanted, signed),
        }
    }

    /// The same under linear conditions alone.
    fn near_linear(&self, wanted: Vec<T>, signed: bool) -> Result<Vec<T>> {
        let mut values = wanted.clone();
        // Once more where the first edit is rounded by the size of what was wanted.
        for _ in 0..if T::EXACT { 1 } else { 2 } {
            self.change.edit(&mut values, &self.targets).map_err(|error| match error {
                Error::Clash { condition } => Error::Clash { condition: self.sources[condition] },
                Error::NotFinite { what, index } => Error::NotFinite { what, index: self.sources[index] },
                other => other,
            })?;
        }
        for Implied { row, target, source } in &self.implied {
            let size = match row.weights().iter().all(T::is_zero) {
                // No value has a say, and targets are of the order of one.
                true => T::one(),
                false => values.iter().map(T::magnitude).fold(target.magnitude(), larger),
            };
            if (row.apply(&values) - target).magnitude() > size * T::frac(1, 1 << 32) {
                return Err(Error::Clash { condition: *source });
            }
        }
        if signed || self.is_positive(&values)? { Ok(values) } else { self.nearest_positive(&wanted) }
    }

    /// Whether the scale function with these coefficients is positive, proved.
    fn is_positive(&self, values: &[T]) -> Result<bool> {
        let positive = values.iter().all(|value| *value > T::zero());
        Ok(positive || self.scales().function(values.to_vec())?.check_positive().is_ok())
    }

    /// The same with the area as one more condition, linear around what was found last.
    fn near_with_area(
        &self,
        wanted: &[T],
        signed: bool,
        form: &AreaForm<T>,
        source: usize,
    ) -> Result<Vec<T>> {
        let one = vec![T::one(); wanted.len()];
        let area = form.value(&one);
        let mut values = self.near_linear(wanted.to_vec(), signed)?;
        for step in 0..if T::EXACT { EXACT_STEPS } else { STEPS } {
            // aᵀ M a + 2 aᵀ M (a' - a) = A
            let gradient = form.half_gradient(&values);
            let target = (T::dot(gradient.iter().zip(&values)) + &area) / T::int(2);
            let before = values;
            values = self.with(gradient, target, source)?.near_linear(wanted.to_vec(), signed)?;
            if settled(&before, &values) {
                break;
            }
            if step >= FULL_STEPS {
                // Half the way: full steps go back and forth where the area bends more than the distance does.
                let half = T::frac(1, 2);
                values.iter_mut().zip(&before).for_each(|(x, y)| *x = (x.clone() + y) * &half);
            }
        }
        let misses = |values: &[T]| {
            let size = larger(area.magnitude(), form.size(values));
            (form.value(values) - &area).magnitude() > size * T::frac(1, 1 << 40)
        };
        if T::EXACT {
            if !self.is_met_by(&one) {
                return Err(TuneError::AreaElsewhere.into());
            }
            values = form.opposite(&values).ok_or(Error::Undecided)?;
        } else {
            if misses(&values) && self.is_met_by(&one) {
                // Steps may go back and forth between sets of values at the floor.
                values = form.opposite(&values).ok_or(Error::Undecided)?;
            }
            if misses(&values) {
                return Err(Error::Undecided);
            }
        }
        if !signed && !self.is_positive(&values)? {
            return Err(TuneError::NoPositiveScale { proved: false }.into());
        }
        Ok(values)
    }

    /// Whether the linear conditions are met by scale functions with these coefficients, elsewhere than over an exact field up
    /// to rounding.
    fn is_met_by(&self, values: &[T]) -> bool {
        self.change.rows().iter().zip(&self.targets).all(|(row, target)| {
            let terms = row.weights().iter().fold(target.magnitude(), |sum, w| sum + w.magnitude());
            let noise = if T::EXACT { T::zero() } else { terms * T::frac(1, 1 << 40) };
            (row.apply(values) - target).magnitude() <= noise
        })
    }

    /// The linear conditions with one more.
    fn with(&self, row: Vec<T>, target: T, source: usize) -> Result<Self> {
        let rows: Vec<Functional<T>> =
            self.change.rows().iter().cloned().chain([Functional::new(0, row)]).collect();
        let targets = self.targets.iter().cloned().chain([target]).collect();
        let sources = self.sources.iter().copied().chain([source]).collect();
        Self::of_rows(self.scales(), &rows, targets, sources, self.norm)?.above(self.floor.clone())
    }

    /// The nearest coefficients that are certainly those of a positive function.
    fn nearest_positive(&self, wanted: &[T]) -> Result<Vec<T>> {
        let scales = self.scales();
        let mut finer = scales.clone();
        for refinement in 0..=REFINEMENTS {
            if let Above::Nearest(values) = self.above_floor(wanted, &scales.embedding(&finer)?)? {
                // Where rounding is larger than the floor, it may not be.
                return if self.is_positive(&values)? { Ok(values) } else { Err(Error::Undecided) };
            }
            if refinement == 0 && self.none_is_positive(wanted)? {
                return Err(TuneError::NoPositiveScale { proved: true }.into());
            }
            finer = finer.bisected()?;
        }
        Err(TuneError::NoPositiveScale { proved: false }.into())
    }

    /// Whether already the values at some parameters cannot all be at or above the floor.
    fn none_is_positive(&self, wanted: &[T]) -> Result<bool> {
        Ok(self.above_floor(wanted, &self.scales().sampling()?)? == Above::None)
    }

    /// The nearest coefficients on which all of `rows` are at or above the floor.
    fn above_floor(&self, wanted: &[T], rows: &LinearMap<T>) -> Result<Above<T>> {
        nearest_above(&self.change, &self.targets, wanted, (rows, &self.floor), self.norm)
    }
}

/// Whether steps have come to rest, up to rounding.
fn settled<T: Scalar>(before: &[T], after: &[T]) -> bool {
    let largest = after.iter().map(T::magnitude).fold(T::zero(), larger);
    let noise = if T::EXACT { T::zero() } else { largest * T::frac(1, 1 << 46) };
    before.iter().zip(after).all(|(x, y)| (x.clone() - y).magnitude() <= noise)
}
