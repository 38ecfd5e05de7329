//! Two weights: a point of a curve or surface moved in the triangle of two control points and the point where it would be
//! without them.
//!
//! With `a_r` and `a_s` the shares of the control points and `R` the point where both weights are zero [NURBS, (11.26) to
//! (11.31)],
//!
//! ```text
//! P = (1 - a_r - a_s) R + a_r P_r + a_s P_s,   ŵ_i = w_i (â_i / a_i) (1 - a_r - a_s) / (1 - â_r - â_s),
//! ```
//!
//! where `â` are the barycentric coordinates of the target. Along the line from `R` through `P` to the leg `P_r P_s`, at `Q`,
//! both weights change by one factor: `1 + λ / (τ (1 - λ))` with `τ = a_r + a_s` and `λ` the fraction of the way from `P` to `Q`.

use crate::coeff::Coeff;
use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::scalar::{Real, Scalar};
use crate::shape::weigh::{Weighed, is_among_positive};
use crate::shape::weight_pull::{check_count, check_finite, coincide, length, odds, push_too_far};
use crate::shape::weight_range::WeightRange;
use crate::tensor::along::Direction;
use crate::vector::{extent, fraction_near};

/// A move of the point at a parameter by the weights of two control points, prepared: it works again and again from the shape as
/// it was.
///
/// Any two control points with influence will do; neighbours give the more pleasing changes.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{NurbsCurve, WeightPairPull, Q, Scalar, SplineSpace};
/// let point = |[x, y]: [i64; 2]| vector![Q::int(x), Q::int(y)];
/// let points = [[0, 0], [0, 4], [4, 4], [4, 0]].map(point).to_vec();
/// let space = SplineSpace::bezier(3, Q::int(0), Q::int(1))?;
/// let mut arch = NurbsCurve::new(space, points, vec![Q::int(1); 4])?;
/// let at = Q::frac(1, 2);
/// let pull = WeightPairPull::new(&arch, &at, [1, 2])?;
/// pull.apply_to(&mut arch, &vector![Q::frac(3, 2), Q::int(3)], &Q::int(0))?;
/// assert_eq!(arch.at(&at)?, vector![Q::frac(3, 2), Q::int(3)]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct WeightPairPull<T, C> {
    /// The number of control points of the shapes it is for.
    count: usize,
    indices: [usize; 2],
    controls: [C; 2],
    point: C,
    weights: [T; 2],
    shares: [T; 2],
    /// The share `1 - a_r - a_s` of all others.
    rest: T,
    base: C,
    range: Option<WeightRange<T>>,
}

impl<T: Scalar, C: Coeff<T>> WeightPairPull<T, C> {
    /// The moves of the point at `at` by the weights of two control points.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`Error::IndexOutOfRange`], [`ShapeError::PickedTwice`]; [`Error::Weight`] unless the weights
    /// are positive; [`ShapeError::NoInfluence`] if one of the two has none there (then take a [`WeightPull`](crate::WeightPull) for the
    /// other); [`ShapeError::NoBase`] if nothing else has, or so many others of negative weight that nothing would be left of the
    /// denominator without the two.
    ///
    /// # Examples
    /// ```
    /// use symspline::{WeightPairPull, RationalFunction, ShapeError, SplineSpace};
    /// let f = RationalFunction::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![0.0, 1.0], vec![1.0; 2])?;
    /// let refused = ShapeError::NoBase { parameter: "0.5".into() };
    /// assert_eq!(WeightPairPull::new(&f, &0.5, [0, 1]), Err(refused.into()));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn new<S: Weighed<T, Point = C>>(shape: &S, at: &S::Parameter, picks: [S::Index; 2]) -> Result<Self> {
        let [r, s] = picks.map(|pick| shape.flat(pick));
        let indices @ [r, s] = [r?, s?];
        if r == s {
            return Err(ShapeError::PickedTwice { index: r }.into());
        }
        let row = shape.influence(at, S::VALUE)?;
        let parameter = || format!("{at:?}");
        let corner = |i: usize| {
            let control = shape.control_point(i)?;
            let share = row.weight(i).ok_or_else(|| ShapeError::NoInfluence { parameter: parameter() })?;
            Ok::<_, Error>((control, share.clone(), shape.weight(i)?.clone()))
        };
        let ((p_r, a_r, w_r), (p_s, a_s, w_s)) = (corner(r)?, corner(s)?);
        // Not one less the shares of the two: that would amplify rounding where the others have little.
        let others = || row.terms().iter().filter(|(i, _)| !indices.contains(i));
        let rest = others().fold(T::zero(), |sum, (_, share)| sum + share);
        let point = shape.derivative_of(at, S::VALUE)?;
        if rest <= T::zero() {
            return Err(ShapeError::NoBase { parameter: parameter() }.into());
        }
        let mut base = if is_among_positive(shape, r) {
            let points = others().map(|(i, _)| shape.control_point(*i)).collect::<Result<Vec<C>>>()?;
            C::combine(others().map(|(_, share)| share).zip(&points)).expect("there are others")
        } else {
            // Some are at infinity or beyond.
            point.plus_scaled(&-a_r.clone(), &p_r).plus_scaled(&-a_s.clone(), &p_s)
        };
        base.divide(&rest);
        Ok(Self {
            count: shape.control_count(),
            indices,
            controls: [p_r, p_s],
            point,
            weights: [w_r, w_s],
            shares: [a_r, a_s],
            rest,
            base,
            range: None,
        })
    }

    /// The moves of the point of a curve at `at` by the weights at the ends of leg `k` of the control polygon, from control
    /// point `k` to the next; in a ring `k` is an unrolled index.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    ///
    /// # Examples
    /// Of the leg between the nodes around a parameter:
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{NurbsCurve, WeightPairPull, SplineSpace};
    /// let points = vec![vector![0.0, 0.0], vector![0.0, 4.0], vector![4.0, 4.0], vector![4.0, 0.0]];
    /// let mut arch = NurbsCurve::new(SplineSpace::bezier(3, 0.0, 1.0)?, points, vec![1.0; 4])?;
    /// let leg = arch.space().node_before(&0.5)?;
    /// WeightPairPull::on_leg(&arch, &0.5, leg)?.apply_along(&mut arch, &0.5)?;
    /// assert!(leg == 1 && (arch.at(&0.5)? - vector![2.0, 3.5]).norm() < 1e-14);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn on_leg<S>(curve: &S, at: &T, k: usize) -> Result<Self>
    where
        S: Weighed<T, Point = C, Parameter = T, Index = usize>,
    {
        let space = curve.space_along(Direction::U);
        let length = space.unrolled_dim();
        match k.checked_add(1) {
            Some(next) if next < length => Self::new(curve, at, [k, next].map(|i| space.slot(i))),
            _ => Err(Error::IndexOutOfRange { index: k.saturating_add(1), length }),
        }
    }

    /// The same with weights in `range` only.
    pub fn within(self, range: WeightRange<T>) -> Self {
        Self { range: Some(range), ..self }
    }

    /// The places of the control points in the list of all.
    pub fn indices(&self) -> [usize; 2] {
        self.indices
    }

    /// The two control points.
    pub fn control_points(&self) -> &[C; 2] {
        &self.controls
    }

    /// The point of the shape as it was.
    pub fn point(&self) -> &C {
        &self.point
    }

    /// The weights as they were.
    pub fn weights(&self) -> &[T; 2] {
        &self.weights
    }

    /// The shares `a_r, a_s` of the control points in the point, as they were.
    pub fn shares(&self) -> &[T; 2] {
        &self.shares
    }

    /// The point `R` where both weights are zero.
    pub fn base(&self) -> &C {
        &self.base
    }

    /// The point `Q` of the leg where the line from the base through the point ends.
    pub fn goal(&self) -> C {
        let [a_r, a_s] = &self.shares;
        let part = a_s.clone() / (a_r.clone() + a_s);
        let [p_r, p_s] = &self.controls;
        p_r.plus_scaled(&part, &p_s.minus(p_r))
    }

    /// The barycentric coordinates of `target` at the two control points.
    ///
    /// `tolerance` is how far from the plane of the triangle it may be: zero over an exact field. Over floating point a
    /// rounding is allowed besides, and of a target near the plane the nearest point of the plane is taken.
    ///
    /// # Errors
    /// [`ShapeError::FlatTriangle`], [`ShapeError::OffPlane`]; [`Error::BadTolerance`], [`Error::NotFinite`].
    pub fn coordinates(&self, target: &C, tolerance: &T) -> Result<[T; 2]> {
        if !(*tolerance >= T::zero() && tolerance.is_finite()) {
            return Err(Error::BadTolerance { tolerance: tolerance.to_string() });
        }
        let [p_r, p_s] = &self.controls;
        let mut ways = [p_r, p_s, target].map(|point| point.minus(&self.base));
        let size = extent(&ways);
        if !size.is_finite() {
            return Err(Error::NotFinite { what: "distance of points", index: 0 });
        }
        // In proportion to the largest, so that no square overflows.
        if !size.is_zero() {
            ways.iter_mut().for_each(|way| way.divide(&size));
        }
        let [to_r, to_s, to_target] = &ways;
        if to_r.squared_size().is_zero() || to_s.squared_size().is_zero() {
            return Err(ShapeError::FlatTriangle.into());
        }
        let skew = fraction_near(to_r, to_s);
        let across = to_s.plus_scaled(&-skew.clone(), to_r);
        let noise = if T::EXACT { T::zero() } else { T::frac(1, 1 << 40) };
        if across.squared_size() <= noise.clone() * &noise * to_s.squared_size() {
            return Err(ShapeError::FlatTriangle.into());
        }
        let s = fraction_near(&across, to_target);
        let r = fraction_near(to_r, to_target) - skew * &s;
        let off = to_target.plus_scaled(&-r.clone(), to_r).plus_scaled(&-s.clone(), to_s).squared_size();
        let allowed = tolerance.clone() / &size + noise;
        if off > allowed.clone() * allowed {
            let (distance, tolerance) = ((off.root_above() * size).to_string(), tolerance.to_string());
            return Err(ShapeError::OffPlane { distance, tolerance }.into());
        }
        Ok([r, s])
    }

    /// The weights that move the point to `target`, inside the triangle of the base and the two control points.
    ///
    /// # Errors
    /// As [`coordinates`](Self::coordinates); [`ShapeError::OutsideTriangle`], also on its border;
    /// [`ShapeError::WeightOutOfRange`].
    pub fn weights_for(&self, target: &C, tolerance: &T) -> Result<[T; 2]> {
        let [r, s] = &self.coordinates(target, tolerance)?;
        let rest = T::one() - r - s;
        let corners = [("the base", &rest), ("the first control point", r), ("the second control point", s)];
        for (corner, coordinate) in corners {
            if *coordinate <= T::zero() {
                return Err(ShapeError::OutsideTriangle { corner, coordinate: coordinate.to_string() }.into());
            }
        }
        let growth = self.rest.clone() / rest;
        let factor = |i: usize, to: &T| to.clone() / &self.shares[i] * &growth;
        let weights = self.times([factor(0, r), factor(1, s)])?;
        for (index, weight) in self.indices.into_iter().zip(&weights) {
            self.range.as_ref().map_or(Ok(()), |range| range.check(index, weight))?;
        }
        Ok(weights)
    }

    /// The weights that move the point by `fraction` of the way to the leg, along the line from the base; their ratio stays.
    ///
    /// # Errors
    /// [`ShapeError::PullTooFar`] unless `fraction < 1`, [`ShapeError::PushTooFar`] where the weights would not be positive,
    /// [`ShapeError::WeightOutOfRange`]; [`ShapeError::Fixed`] if the point is on the leg; [`Error::NotFinite`].
    pub fn weights_along(&self, fraction: &T) -> Result<[T; 2]> {
        if coincide(&self.point, &self.goal()) {
            return Err(ShapeError::Fixed.into());
        }
        let factor = T::one() + odds(fraction)? / self.total();
        if factor <= T::zero() {
            return Err(push_too_far(fraction, &self.fraction_for(&T::zero())));
        }
        let weights = self.times([factor.clone(), factor])?;
        let Some(range) = &self.range else { return Ok(weights) };
        // As of a pull: the limits themselves are inside.
        if self.push_limit() <= *fraction && *fraction <= self.pull_limit() {
            return Ok(weights.map(|weight| range.nearest(weight)));
        }
        let outside = usize::from(range.check(self.indices[0], &weights[0]).is_ok());
        Err(range.refusal(self.indices[outside], &weights[outside]))
    }

    /// The largest pull along the line: a fraction of the way to the leg. Without a range of weights it is one, which no
    /// weights reach.
    pub fn pull_limit(&self) -> T {
        match self.factors(WeightRange::most) {
            Some([x, y]) => self.fraction_for(if x < y { &x } else { &y }),
            None => T::one(),
        }
    }

    /// The largest push along the line: a fraction of the way, mostly negative. Without a range of weights it is the one where
    /// they would be zero, `-τ / (1 - τ)`, which is not reached either.
    pub fn push_limit(&self) -> T {
        match self.factors(WeightRange::least) {
            Some([x, y]) => self.fraction_for(if x < y { &y } else { &x }),
            None => self.fraction_for(&T::zero()),
        }
    }

    /// Moves the point of `shape` to `target`.
    ///
    /// `shape` is the one for which this was prepared, with any weights of the two control points.
    ///
    /// # Errors
    /// As [`weights_for`](Self::weights_for); [`Error::CoefficientCount`] unless it has as many control points; those of
    /// [`Weighed::place_weighted`]. Then `shape` stays as it is.
    pub fn apply_to<S>(&self, shape: &mut S, target: &C, tolerance: &T) -> Result<()>
    where
        S: Weighed<T, Point = C>,
    {
        check_count(self.count, shape)?;
        self.place(shape, self.weights_for(target, tolerance)?)
    }

    /// Moves the point of `shape` to where it was, and from there by `fraction` of the way to the leg.
    ///
    /// # Errors
    /// As [`weights_along`](Self::weights_along), and as [`apply_to`](Self::apply_to).
    pub fn apply_along<S: Weighed<T, Point = C>>(&self, shape: &mut S, fraction: &T) -> Result<()> {
        check_count(self.count, shape)?;
        self.place(shape, self.weights_along(fraction)?)
    }

    fn place<S: Weighed<T, Point = C>>(&self, shape: &mut S, [w_r, w_s]: [T; 2]) -> Result<()> {
        let ([r, s], [p_r, p_s]) = (self.indices, &self.controls);
        shape.place_weighted(&[(r, p_r.clone(), w_r), (s, p_s.clone(), w_s)])
    }

    /// The share `τ` of both control points.
    fn total(&self) -> T {
        self.shares[0].clone() + &self.shares[1]
    }

    /// The fraction of the way to the leg that one factor of both weights makes.
    fn fraction_for(&self, factor: &T) -> T {
        let growth = (factor.clone() - T::one()) * self.total();
        growth.clone() / (T::one() + growth)
    }

    /// What an end of the range is to the weights.
    fn factors(&self, end: impl Fn(&WeightRange<T>) -> &T) -> Option<[T; 2]> {
        let end = end(self.range.as_ref()?);
        Some([0, 1].map(|i| end.clone() / &self.weights[i]))
    }

    /// The weights times `factors`.
    fn times(&self, [x, y]: [T; 2]) -> Result<[T; 2]> {
        let weights = [x * &self.weights[0], y * &self.weights[1]];
        for (index, weight) in self.indices.into_iter().zip(&weights) {
            check_finite(index, weight)?;
        }
        Ok(weights)
    }
}

impl<T: Real, C: Coeff<T>> WeightPairPull<T, C> {
    /// The distance from the point to the leg, along the line from the base.
    pub fn distance(&self) -> T {
        length(&self.goal().minus(&self.point))
    }

    /// The fraction of the way that a distance is, for [`apply_along`](Self::apply_along): pulls are positive, pushes negative.
    pub fn fraction_of(&self, distance: &T) -> T {
        distance.clone() / self.distance()
    }
}

#[cfg(test)]
mod tests;
