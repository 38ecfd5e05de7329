//! Points of the control polygon made control points: inverse knot insertion.

use crate::coeff::Coeff;
use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::ops::bound::{check_tolerance, epsilon};
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::tensor::along::Direction;
use crate::vector::{extent, fraction_near};

/// A point of a leg of the control polygon, of a surface of an edge of its control net: `(1 - θ) P + θ P'`, from one
/// control point `P` to the next one `P'` along a direction.
///
/// A knot inserted at `t_{k+1} + α (t_{k+p+1} - t_{k+1})`, with `α = w θ / (w θ + w' (1 - θ))`, makes it a control point
/// [NURBS, (5.19) to (5.21), of surfaces (11.15) and (11.16)]. On a surface only this row gets its point exactly where it
/// was asked for.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Curve, Direction, LegPoint, Q, Scalar, SplineSpace};
/// let points = [[0, 0], [1, 2], [3, 2], [4, 0]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
/// let curve = Curve::new(SplineSpace::clamped(2, [0, 1, 2].map(Q::int))?, points.to_vec())?;
/// let target = vector![Q::frac(3, 2), Q::int(2)];
/// let leg = LegPoint::at(&curve, Direction::U, 1, &target, &Q::int(0))?;
/// assert_eq!((leg.fraction(), leg.knot(&curve)?), (&Q::frac(1, 4), Q::frac(1, 2)));
/// let (finer, index) = leg.inserted(&curve)?;
/// assert_eq!(finer.coeffs()[index], target);
/// # Ok::<(), symspline::Error>(())
/// ```
#[doc(alias = "inverse knot insertion")]
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct LegPoint<T> {
    direction: Direction,
    /// The places of `P` and `P'` in the list of control points.
    ends: (usize, usize),
    /// The unrolled index of `P` along the direction.
    k: usize,
    fraction: T,
}

impl<T: Scalar> LegPoint<T> {
    /// The point a fraction of the way from control point `index` to the next one along `direction`.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`] if one of them is none; [`ShapeError::NotOnLeg`] unless `0 < fraction < 1`.
    pub fn new<S: Controlled<T>>(
        shape: &S,
        direction: Direction,
        index: S::Index,
        fraction: T,
    ) -> Result<Self> {
        let leg = Self::leg(shape, direction, index)?;
        if T::zero() < fraction && fraction < T::one() {
            return Ok(Self { fraction, ..leg });
        }
        Err(ShapeError::NotOnLeg { fraction: fraction.to_string() }.into())
    }

    /// The point `target` of the leg from control point `index` to the next one along `direction`.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`Error::BadTolerance`]; [`Error::TooFar`] if `target` is farther than `tolerance` from the
    /// line, in floating point but for rounding; [`Error::ZeroLeg`]; [`Error::NotFinite`] on overflow.
    pub fn at<S: Controlled<T>>(
        shape: &S,
        direction: Direction,
        index: S::Index,
        target: &S::Point,
        tolerance: &T,
    ) -> Result<Self> {
        check_tolerance(tolerance)?;
        let leg = Self::leg(shape, direction, index)?;
        let (start, end) = (shape.control_point(leg.ends.0)?, shape.control_point(leg.ends.1)?);
        let mut ways = [target.minus(&start), end.minus(&start)];
        let size = extent(&ways);
        if !size.is_finite() {
            return Err(Error::NotFinite { what: "distance of points", index: 0 });
        }
        if ways[1].vanishes() {
            return Err(Error::ZeroLeg { index: leg.ends.0 });
        }
        let fraction = fraction_near(&ways[1], &ways[0]);
        if !fraction.is_finite() {
            return Self::new(shape, direction, index, fraction);
        }
        // In proportion to the largest, so that no square overflows.
        ways.iter_mut().for_each(|way| way.divide(&size));
        let noise = if T::EXACT { T::zero() } else { epsilon::<T>() * T::int(8) };
        let allowed = (tolerance.clone() + noise * extent([&start, &end, target])) / &size;
        let off = ways[0].plus_scaled(&-fraction.clone(), &ways[1]).squared_size();
        if off > allowed.clone() * allowed {
            let distance = (off.root_above() * size).to_string();
            return Err(Error::TooFar { distance, tolerance: tolerance.to_string() });
        }
        Self::new(shape, direction, index, fraction)
    }

    /// The leg, its start picked.
    fn leg<S: Controlled<T>>(shape: &S, direction: Direction, index: S::Index) -> Result<Self> {
        let start = shape.flat(index)?;
        let space = shape.space_along(direction);
        // Along the last direction neighbours stand side by side, along others a row apart.
        let along = S::DIRECTIONS.iter().position(|d| *d == direction).unwrap_or(0);
        let stride: usize = S::DIRECTIONS[along + 1..].iter().map(|d| shape.space_along(*d).dim()).product();
        let (k, length) = (start / stride % space.dim(), space.dim());
        if k + 1 == length && !space.is_periodic() {
            return Err(Error::IndexOutOfRange { index: length, length });
        }
        let end = start - k * stride + space.slot(k + 1) * stride;
        Ok(Self { direction, ends: (start, end), k, fraction: T::zero() })
    }

    /// How far along the leg it is.
    pub fn fraction(&self) -> &T {
        &self.fraction
    }

    /// The knot that makes it a control point.
    ///
    /// # Errors
    /// [`Error::DegreeTooLow`] for degree zero; [`Error::Weight`] if a weight of an end is not positive;
    /// [`Error::IndexOutOfRange`] for another shape than it was made for.
    pub fn knot<S: Controlled<T>>(&self, shape: &S) -> Result<T> {
        let space = shape.space_along(self.direction);
        let (p, t) = (space.degree(), space.knots());
        if p == 0 {
            return Err(Error::DegreeTooLow { degree: 0, needed: 1 });
        }
        let weight = |index: usize| match shape.control_weight(index)? {
            weight if weight > T::zero() => Ok(weight),
            weight => Err(Error::Weight { index, weight: weight.to_string() }),
        };
        let from = weight(self.ends.0)? * &self.fraction;
        let to = weight(self.ends.1)? * (T::one() - &self.fraction);
        let past = Error::IndexOutOfRange { index: self.k + p + 1, length: t.len() };
        let (start, end) = (&t[self.k + 1], t.get(self.k + p + 1).ok_or(past)?);
        let alpha = from.clone() / (from + to);
        Ok(start.clone() + alpha * (end.clone() - start))
    }

    /// Whether that is a knot already, in floating point but for rounding: one more copy lets the shape lose a derivative there
    /// as soon as the new control point moves.
    ///
    /// # Errors
    /// As [`knot`](Self::knot); [`Error::TooFewKnots`] for a ring of fewer than `p` coefficients.
    pub fn is_knot<S: Controlled<T>>(&self, shape: &S) -> Result<bool> {
        Ok(shape.space_along(self.direction).placed(self.knot(shape)?)?.1)
    }

    /// The shape with that knot, and the place of the new control point along the direction.
    ///
    /// # Errors
    /// As [`knot`](Self::knot); [`Error::TooFewKnots`] for a ring of fewer than `p` coefficients; those of the insertion, as
    /// [`Error::Multiplicity`] for a knot with all copies there can be.
    pub fn inserted<S: Controlled<T>>(&self, shape: &S) -> Result<(S, usize)> {
        let space = shape.space_along(self.direction);
        let knot = self.knot(shape)?;
        let (p, t) = (space.degree(), space.knots());
        let rises = t[self.k + 2..=self.k + p].iter().fold(T::zero(), |sum, t| sum + (t.clone() - &knot));
        let node = knot.clone() + rises / T::int(p as i64);
        let finer = shape.inserted_along(self.direction, &[space.placed(knot)?.0])?;
        let place = finer.space_along(self.direction).coeff_at_node(&node);
        Ok((finer, place))
    }
}
