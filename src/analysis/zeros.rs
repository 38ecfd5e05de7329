//! Where a scalar spline is zero or changes its sign, proved.
//!
//! Each piece is solved by sign variations of its Bernstein coefficients (see [`roots`](crate::roots)); what happens at
//! a knot is told from both sides. Nothing is sampled: no zero is missed, none is found twice.

use crate::analysis::certify::condition::{Condition, What};
use crate::analysis::certify::{Certified, Course};
use crate::analysis::lifted::Lifted;
use crate::error::Result;
use crate::exact::Q;
use crate::rational::spline::RationalFunction;
use crate::roots::{Polynomial, Root, RootValue};
use crate::scalar::Scalar;
use crate::spline::Function;
use nalgebra::SVector;
use std::cmp::Ordering;

/// Where something happens.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place<T> {
    /// At one parameter, which is known or enclosed.
    At(RootValue<T>),
    /// On a whole interval, from knot to knot.
    Along(T, T),
}

impl<T> Place<T> {
    /// Lower and upper bound of the parameters.
    ///
    /// # Examples
    /// ```
    /// use symspline::Place;
    /// use symspline::roots::RootValue;
    /// assert_eq!(Place::At(RootValue::Enclosed(1, 2)).bounds(), (&1, &2));
    /// assert_eq!(Place::Along(1, 5).bounds(), (&1, &5));
    /// ```
    pub fn bounds(&self) -> (&T, &T) {
        match self {
            Self::At(value) => value.bounds(),
            Self::Along(start, end) => (start, end),
        }
    }
}

/// A zero of a function, or a knot where it jumps from one side of zero to the other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Zero<T> {
    /// Where it is.
    pub place: Place<T>,
    /// How often it counts; on an interval not at all. At a knot it is the smaller number of both sides: 0 where the
    /// function jumps and one limit at least is not zero.
    pub multiplicity: usize,
    /// The sign before it, unless it is at the start of an open domain.
    pub before: Option<Ordering>,
    /// The sign after it, unless it is at the end of an open domain.
    pub after: Option<Ordering>,
}

impl<T> Zero<T> {
    /// Whether the function has different signs before and after.
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// let [square, cube] = [2, 3].map(|power| Function::monomial(power, -1.0, 1.0));
    /// assert!(!square?.zeros()?[0].changes_sign());
    /// assert!(cube?.zeros()?[0].changes_sign());
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn changes_sign(&self) -> bool {
        matches!((self.before, self.after), (Some(before), Some(after)) if before != after)
    }
}

impl<T: Certified> Function<T> {
    /// The zeros, ascending, each proved to be one and none left out; zero intervals are given as such.
    ///
    /// Over [`Q`] rational zeros are exact, and others enclosed about as closely as floats would (see
    /// [`narrowed`](Self::narrowed) for more). Over `f64` the coefficients and knots are taken as the exact numbers
    /// they are, and zeros lie between floats that are neighbours or close. The seam of a ring is given once, at its
    /// start.
    ///
    /// # Errors
    /// [`Error::TooLarge`](crate::Error::TooLarge).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Place, Q, Scalar, SplineSpace};
    /// use symspline::roots::RootValue;
    /// // Down to zero at 1, zero up to 2, up to 3 at 3.
    /// let space = SplineSpace::clamped(1, [0, 1, 2, 3].map(Q::int))?;
    /// let valley = Function::new(space, [1, 0, 0, 3].map(Q::int).to_vec())?;
    /// let zeros = valley.zeros()?;
    /// assert_eq!(zeros.len(), 1);
    /// assert_eq!(zeros[0].place, Place::Along(Q::int(1), Q::int(2)));
    /// let line = &valley - &Function::constant(valley.space().clone(), Q::int(1))?;
    /// assert_eq!(line.zeros()?[1].place, Place::At(RootValue::Exact(Q::frac(7, 3))));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn zeros(&self) -> Result<Vec<Zero<T>>> {
        let what = What::Above { normal: SVector::from([T::one()]), offset: T::zero() };
        zeros(&Condition {
            curve: Lifted::polynomial(&self.map_coeffs(|c| SVector::from([c.clone()]))?),
            what,
        })
    }
}

impl Function<Q> {
    /// A zero of this function enclosed more closely, in an interval no longer than `width`, or found exactly on the
    /// way.
    ///
    /// # Errors
    /// [`Error::BadTolerance`](crate::Error::BadTolerance) unless `width` is positive;
    /// [`Error::OutsideDomain`](crate::Error::OutsideDomain).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, Scalar, SplineSpace};
    /// // x² - 2 on [0, 2], its root to fifty digits.
    /// let f = Function::new(SplineSpace::bezier(2, Q::int(0), Q::int(2))?, [-2, -2, 2].map(Q::int).to_vec())?;
    /// let width = (0..50).fold(Q::int(1), |width, _| width / Q::int(10));
    /// let zero = f.narrowed(&f.zeros()?[0], &width)?;
    /// let (low, high) = zero.place.bounds();
    /// assert!(low * low < Q::int(2) && Q::int(2) < high * high && high - low <= width);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn narrowed(&self, zero: &Zero<Q>, width: &Q) -> Result<Zero<Q>> {
        let Place::At(value @ RootValue::Enclosed(low, high)) = &zero.place else { return Ok(zero.clone()) };
        // The enclosure may start at a knot, but not cross one.
        let k = self.space().locate(&(low.clone() + (high.clone() - low) * Q::frac(1, 2)))?;
        let knots = self.space().knots();
        let ends = [knots[k].clone(), knots[k + 1].clone()];
        let piece = Polynomial::new(ends[0].clone(), ends[1].clone(), self.bernstein(&ends)?)?;
        let root = Root { value: value.clone(), multiplicity: zero.multiplicity };
        Ok(Zero { place: Place::At(root.narrowed(&piece, width)?.value), ..zero.clone() })
    }
}

impl<T: Certified> RationalFunction<T> {
    /// The zeros, those of the numerator; see [`Function::zeros`].
    ///
    /// # Errors
    /// As [`Function::zeros`].
    pub fn zeros(&self) -> Result<Vec<Zero<T>>> {
        self.numerator()?.zeros()
    }
}

/// The zeros of a function of a curve.
pub(crate) fn zeros<T: Certified, const N: usize>(condition: &Condition<T, N>) -> Result<Vec<Zero<T>>> {
    let space = condition.curve.space();
    Ok(joined(&space.ends(), &T::courses(condition)?, space.is_periodic()))
}

/// The zeros of a function from the courses of its pieces between `ends`.
pub(crate) fn joined<T: Clone>(ends: &[T], courses: &[Course<T>], closed: bool) -> Vec<Zero<T>> {
    let count = courses.len();
    let vanishes = |i: usize| courses[i].signs[0] == Ordering::Equal;
    // The next piece from here on, and the last one before, that is not zero, round a ring if there is one.
    let next = |i: usize| (i..count).chain(0..if closed { i } else { 0 }).find(|i| !vanishes(*i));
    let previous =
        |i: usize| (0..i).rev().chain((if closed { i } else { count }..count).rev()).find(|i| !vanishes(*i));
    let mut zeros = Vec::new();
    for i in 0..=count {
        if i == count && closed {
            break;
        }
        let right = (i < count).then_some(i);
        let left = if i == 0 && closed { Some(count - 1) } else { i.checked_sub(1) };
        let before = previous(i).map(|left| courses[left].signs[1]);
        match (left.filter(|left| vanishes(*left)), right.filter(|right| vanishes(*right))) {
            (left, Some(_)) if left.is_none() || i == 0 => {
                let end = (i..count).find(|i| !vanishes(*i)).unwrap_or(count);
                let place = Place::Along(ends[i].clone(), ends[end].clone());
                let after = next(end).map(|right| courses[right].signs[0]);
                zeros.push(Zero { place, multiplicity: 0, before, after });
            }
            (None, None) => {
                let after = right.map(|right| courses[right].signs[0]);
                let before = left.map(|left| courses[left].signs[1]);
                let counts =
                    [left.map(|left| courses[left].at_ends[1]), right.map(|right| courses[right].at_ends[0])];
                let least = counts.iter().flatten().min().copied().unwrap_or(0);
                let touches = counts.iter().flatten().any(|count| *count > 0);
                let zero = Zero {
                    place: Place::At(RootValue::Exact(ends[i].clone())),
                    multiplicity: least,
                    before,
                    after,
                };
                zeros.extend((touches || zero.changes_sign()).then_some(zero));
            }
            _ => {}
        }
        let Some(course) = right.map(|right| &courses[right]) else { break };
        let mut sign = course.signs[0];
        zeros.extend(course.inside.iter().map(|(value, multiplicity)| {
            let before = sign;
            sign = if multiplicity % 2 == 1 { sign.reverse() } else { sign };
            let place = Place::At(value.clone());
            Zero { place, multiplicity: *multiplicity, before: Some(before), after: Some(sign) }
        }));
    }
    zeros
}
