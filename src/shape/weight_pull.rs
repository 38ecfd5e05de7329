//! One weight: a point of a curve or surface pulled toward a control point, or pushed away from it.
//!
//! When weight `w_k` changes, the point at a parameter moves along the line through it and the control point `P_k`
//! [NURBS, sections 11.3.1 and 11.3.3]. With `R` the share `R_k` of the control point and `W = Σ w_i N_i`, a move by the fraction
//! `λ` of the way from the point to `P_k` takes the weight
//!
//! ```text
//! w + (W / N_k) λ / (1 - λ) = w (1 + λ / (R (1 - λ))),   -R / (1 - R) < λ < 1,
//! ```
//!
//! which is (11.25) with `λ = d / |P_k - P|`, without the length. At the lower end the weight is zero, and the point where the
//! line begins; `λ = 1` would take an infinite weight.

use crate::coeff::Coeff;
use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::scalar::{Real, Scalar};
use crate::shape::controlled::Controlled;
use crate::shape::weigh::Weighed;
use crate::shape::weight_range::WeightRange;
use crate::vector::{extent, fraction_near};

/// A pull of the point at a parameter toward a control point, prepared: it works again and again from the shape as it was.
///
/// Moves are signed: a positive one pulls, a negative one pushes. Nothing is summed up over several moves, so each is as exact
/// as the first.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{NurbsCurve, WeightPull, Q, Scalar, SplineSpace};
/// let points = [[0, 0], [1, 2], [2, 0]].map(|p| vector![Q::int(p[0]), Q::int(p[1])]).to_vec();
/// let mut arc = NurbsCurve::new(SplineSpace::bezier(2, Q::int(0), Q::int(1))?, points, vec![Q::int(1); 3])?;
/// let (middle, one) = (Q::frac(1, 2), Q::int(1));
/// let pull = WeightPull::new(&arc, &middle, 1)?;
/// pull.apply(&mut arc, &Q::frac(1, 2))?;
/// assert_eq!(arc.at(&middle)?, vector![one.clone(), Q::frac(3, 2)]);
/// // A push from where the point was at first.
/// pull.apply(&mut arc, &Q::frac(-1, 2))?;
/// assert_eq!(arc.at(&middle)?, vector![one, Q::frac(1, 2)]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct WeightPull<T, C> {
    /// The number of control points of the shapes it is for.
    count: usize,
    index: usize,
    control: C,
    point: C,
    weight: T,
    /// By how much the weight grows to take the point half the way: `W / N_k`.
    halving: T,
    range: Option<WeightRange<T>>,
}

impl<T: Scalar, C: Coeff<T>> WeightPull<T, C> {
    /// The pull of the point at `at` toward control point `index`.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`Error::IndexOutOfRange`]; [`Error::Weight`] unless the weight is positive;
    /// [`ShapeError::NoInfluence`] if the control point has none there; [`ShapeError::Fixed`] if the point is the control
    /// point, over floating point up to rounding.
    ///
    /// # Examples
    /// ```
    /// use symspline::{WeightPull, RationalFunction, ShapeError, SplineSpace};
    /// let space = SplineSpace::clamped(1, [0.0, 1.0, 2.0])?;
    /// let f = RationalFunction::new(space, vec![0.0, 1.0, 5.0], vec![1.0; 3])?;
    /// let refused = ShapeError::NoInfluence { parameter: "0.5".into() };
    /// assert_eq!(WeightPull::new(&f, &0.5, 2), Err(refused.into()));
    /// assert_eq!(WeightPull::new(&f, &1.0, 1), Err(ShapeError::Fixed.into()));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn new<S: Weighed<T, Point = C>>(shape: &S, at: &S::Parameter, index: S::Index) -> Result<Self> {
        let index = shape.flat(index)?;
        let control = shape.control_point(index)?;
        let weight = shape.weight(index)?.clone();
        let row = shape.influence(at, S::VALUE)?;
        let halving = row.weight(index).map(|share| weight.clone() / share);
        let Some(halving) = halving.filter(T::is_finite) else {
            return Err(ShapeError::NoInfluence { parameter: format!("{at:?}") }.into());
        };
        Self::prepared(shape, at, index, control, weight, halving)
    }

    /// The pull toward a control point that the shape does not have yet, because its weight is zero: `point` becomes it.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`Error::Weight`] unless weight and weighted point are zero.
    ///
    /// # Examples
    /// ```
    /// use symspline::{WeightPull, RationalFunction, Spline, SplineSpace, Weighted};
    /// let ends = [(0.0, 1.0), (0.0, 0.0), (2.0, 1.0)].map(|(point, weight)| Weighted { point, weight });
    /// let mut f = RationalFunction::from_lifted(Spline::new(SplineSpace::bezier(2, 0.0, 1.0)?, ends.to_vec())?)?;
    /// WeightPull::from_zero(&f, &0.5, 1, 5.0)?.apply(&mut f, &0.25)?;
    /// assert_eq!(f.at(&0.5)?, 2.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn from_zero<S: Weighed<T, Point = C>>(
        shape: &S,
        at: &S::Parameter,
        index: S::Index,
        point: C,
    ) -> Result<Self> {
        let flat = shape.flat(index)?;
        let old = shape.weighted(flat)?;
        if !old.weight.is_zero() || !old.point.vanishes() {
            return Err(Error::Weight { index: flat, weight: old.weight.to_string() });
        }
        let mut shown = shape.clone();
        shown.place_weighted(&[(flat, point.clone(), T::one())])?;
        let row = shown.influence(at, S::VALUE)?;
        // By the shares of the others, not as one less the share of this one: that would amplify rounding where they have little.
        let others = row.terms().iter().filter(|(i, _)| *i != flat);
        let rest = others.fold(T::zero(), |sum, (_, share)| sum + share);
        let halving = row.weight(flat).map(|share| rest / share);
        let Some(halving) = halving.filter(T::is_finite) else {
            return Err(ShapeError::NoInfluence { parameter: format!("{at:?}") }.into());
        };
        Self::prepared(shape, at, flat, point, T::zero(), halving)
    }

    /// The pull with its numbers, unless the point is the control point.
    fn prepared<S: Weighed<T, Point = C>>(
        shape: &S,
        at: &S::Parameter,
        index: usize,
        control: C,
        weight: T,
        halving: T,
    ) -> Result<Self> {
        let point = shape.derivative_of(at, S::VALUE)?;
        if coincide(&point, &control) {
            return Err(ShapeError::Fixed.into());
        }
        Ok(Self { count: shape.control_count(), index, control, point, weight, halving, range: None })
    }

    /// The same with weights in `range` only.
    pub fn within(self, range: WeightRange<T>) -> Self {
        Self { range: Some(range), ..self }
    }

    /// The control point's place in the list of all.
    pub fn index(&self) -> usize {
        self.index
    }

    /// The control point `P_k`.
    pub fn control_point(&self) -> &C {
        &self.control
    }

    /// The point of the shape as it was.
    pub fn point(&self) -> &C {
        &self.point
    }

    /// The weight as it was.
    pub fn weight(&self) -> &T {
        &self.weight
    }

    /// The share `R_k` of the control point in the point, as it was.
    pub fn share(&self) -> T {
        self.weight.clone() / &self.halving
    }

    /// The fraction of the way to the control point that the point goes when the weight becomes `weight`, which may be zero.
    ///
    /// # Errors
    /// [`Error::Pole`] if the denominator would not be positive.
    pub fn fraction_for(&self, weight: &T) -> Result<T> {
        let growth = weight.clone() - &self.weight;
        let bottom = self.halving.clone() + &growth;
        if bottom > T::zero() { Ok(growth / bottom) } else { Err(Error::Pole) }
    }

    /// The point when the weight becomes `weight`, which may be zero.
    ///
    /// # Errors
    /// As [`fraction_for`](Self::fraction_for).
    ///
    /// # Examples
    /// The weight is the cross ratio of four points [NURBS, (11.24)]:
    /// ```
    /// use symspline::{WeightPull, Q, RationalFunction, Scalar, SplineSpace, cross_ratio};
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let f = RationalFunction::new(line, [0, 12].map(Q::int).to_vec(), [1, 5].map(Q::int).to_vec())?;
    /// let pull = WeightPull::new(&f, &Q::frac(1, 2), 1)?;
    /// let [r, m] = [0, 1].map(|weight| pull.point_at_weight(&Q::int(weight)));
    /// assert_eq!(cross_ratio([pull.control_point(), &r?, &m?, pull.point()], &Q::int(0))?, Q::int(5));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn point_at_weight(&self, weight: &T) -> Result<C> {
        Ok(self.point_at(&self.fraction_for(weight)?))
    }

    /// The point after a move by `fraction` of the way.
    pub fn point_at(&self, fraction: &T) -> C {
        self.point.plus_scaled(fraction, &self.way())
    }

    /// The fraction of the way at which the point is nearest to `target`.
    pub fn fraction_near(&self, target: &C) -> T {
        fraction_near(&self.way(), &target.minus(&self.point))
    }

    /// The largest pull: a fraction of the way. Without a range of weights it is one, which no weight reaches; none if no weight
    /// of the range is possible.
    pub fn pull_limit(&self) -> Option<T> {
        match &self.range {
            Some(range) => self.fraction_for(range.most()).ok(),
            None => Some(T::one()),
        }
    }

    /// The largest push: a fraction of the way, mostly negative. Without a range of weights it is the one where the weight
    /// would be zero, `-R / (1 - R)`, which is not reached either; none if there is no such weight, because the denominator
    /// would not be positive before.
    pub fn push_limit(&self) -> Option<T> {
        let zero = T::zero();
        self.fraction_for(self.range.as_ref().map_or(&zero, WeightRange::least)).ok()
    }

    /// The weight that moves the point by `fraction` of the way to the control point.
    ///
    /// # Errors
    /// [`ShapeError::PullTooFar`] unless `fraction < 1`, [`ShapeError::PushTooFar`] where the weight would not be positive,
    /// [`ShapeError::WeightOutOfRange`]; [`Error::NotFinite`].
    pub fn weight_for(&self, fraction: &T) -> Result<T> {
        let weight = self.weight.clone() + self.halving.clone() * odds(fraction)?;
        if weight <= T::zero() {
            let limit = self.fraction_for(&T::zero()).unwrap_or_else(|_| T::zero());
            return Err(push_too_far(fraction, &limit));
        }
        check_finite(self.index, &weight)?;
        let Some(range) = &self.range else { return Ok(weight) };
        // Fractions are compared, so that the limits themselves are inside however weights are rounded.
        let beyond = self.pull_limit().is_none_or(|limit| *fraction > limit);
        if beyond || self.push_limit().is_some_and(|limit| *fraction < limit) {
            return Err(range.refusal(self.index, &weight));
        }
        Ok(range.nearest(weight))
    }

    /// Moves the point of `shape` to where it was, and from there by `fraction` of the way to the control point.
    ///
    /// `shape` is the one for which this was prepared, with any weight of the control point.
    ///
    /// # Errors
    /// As [`weight_for`](Self::weight_for); [`Error::CoefficientCount`] unless it has as many control points; those of
    /// [`Weighed::place_weighted`]. Then `shape` stays as it is.
    pub fn apply<S: Weighed<T, Point = C>>(&self, shape: &mut S, fraction: &T) -> Result<()> {
        check_count(self.count, shape)?;
        let weight = self.weight_for(fraction)?;
        shape.place_weighted(&[(self.index, self.control.clone(), weight)])
    }

    /// The shape with its point moved.
    ///
    /// # Errors
    /// As [`apply`](Self::apply).
    pub fn applied<S: Weighed<T, Point = C>>(&self, shape: &S, fraction: &T) -> Result<S> {
        let mut pulled = shape.clone();
        self.apply(&mut pulled, fraction)?;
        Ok(pulled)
    }

    /// From the point to the control point.
    fn way(&self) -> C {
        self.control.minus(&self.point)
    }
}

impl<T: Real, C: Coeff<T>> WeightPull<T, C> {
    /// The distance from the point to the control point.
    pub fn distance(&self) -> T {
        length(&self.way())
    }

    /// The fraction of the way that a distance is, for [`apply`](Self::apply): pulls are positive, pushes negative.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{NurbsCurve, WeightPull, SplineSpace};
    /// let points = vec![vector![0.0, 0.0], vector![3.0, 4.0], vector![6.0, 0.0]];
    /// let arc = NurbsCurve::new(SplineSpace::bezier(2, 0.0, 1.0)?, points, vec![1.0; 3])?;
    /// let pull = WeightPull::new(&arc, &0.5, 1)?;
    /// assert_eq!(pull.distance(), 2.0);
    /// let pushed = pull.applied(&arc, &pull.fraction_of(&-1.0))?;
    /// assert!((pushed.at(&0.5)? - vector![3.0, 1.0]).norm() < 1e-14);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn fraction_of(&self, distance: &T) -> T {
        distance.clone() / self.distance()
    }

    /// The weight that moves the point by a distance toward the control point [NURBS, (11.25) and (11.39)].
    ///
    /// # Errors
    /// As [`weight_for`](Self::weight_for).
    pub fn weight_for_distance(&self, distance: &T) -> Result<T> {
        self.weight_for(&self.fraction_of(distance))
    }
}

/// `λ / (1 - λ)`.
pub(super) fn odds<T: Scalar>(fraction: &T) -> Result<T> {
    if !fraction.is_finite() {
        return Err(Error::NotFinite { what: "fraction", index: 0 });
    }
    if *fraction >= T::one() {
        return Err(ShapeError::PullTooFar { fraction: fraction.to_string() }.into());
    }
    Ok(fraction.clone() / (T::one() - fraction))
}

pub(super) fn push_too_far<T: Scalar>(fraction: &T, limit: &T) -> Error {
    ShapeError::PushTooFar { fraction: fraction.to_string(), limit: limit.to_string() }.into()
}

pub(super) fn check_finite<T: Scalar>(index: usize, weight: &T) -> Result<()> {
    if weight.is_finite() { Ok(()) } else { Err(Error::NotFinite { what: "weight", index }) }
}

/// Refuses a shape of another number of control points.
pub(super) fn check_count<T: Scalar, S: Controlled<T>>(expected: usize, shape: &S) -> Result<()> {
    let found = shape.control_count();
    if found == expected { Ok(()) } else { Err(Error::CoefficientCount { expected, found }) }
}

/// Whether two points are one, over floating point up to rounding.
pub(super) fn coincide<T: Scalar, C: Coeff<T>>(point: &C, other: &C) -> bool {
    let noise = if T::EXACT { T::zero() } else { extent([point, other]) * T::frac(1, 1 << 48) };
    extent([&point.minus(other)]) <= noise
}

/// The length of a vector, where no square overflows.
pub(super) fn length<T: Real, C: Coeff<T>>(vector: &C) -> T {
    let size = extent([vector]);
    if size.is_zero() || !size.is_finite() {
        return size;
    }
    let mut share = vector.clone();
    share.divide(&size);
    share.squared_size().sqrt() * size
}

#[cfg(test)]
mod tests;
