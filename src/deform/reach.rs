//! How far a grip reaches, wherever a shape is grabbed.

use crate::deform::breadth::Breadth;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::shape::region::Refinement;
use crate::space::SplineSpace;

/// Which coefficients move where a shape is grabbed, along one direction: a [`Breadth`] that goes with the place.
///
/// # Examples
/// ```
/// use symspline::{Reach, SplineSpace};
/// let ring = SplineSpace::periodic(1, [0.0, 1.0, 2.0, 3.0, 4.0], 5.0)?;
/// assert_eq!(Reach::Nearest(3).breadth(&ring, &3.0)?.coeffs(&ring)?, [2, 3, 4]);
/// assert_eq!(Reach::Within(2.0).breadth(&ring, &0.0)?.coeffs(&ring)?, [0, 1, 4]);
/// assert_eq!(Reach::All.breadth(&ring, &0.0)?.coeffs(&ring)?, [0, 1, 2, 3, 4]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub enum Reach<T> {
    /// All but the first and the last; in a ring all.
    #[default]
    All,
    /// The same ones everywhere.
    Fixed(Breadth<T>),
    /// So many, all if there are not more: those whose nodes lie next to the place.
    Nearest(usize),
    /// Those without influence farther away than this, a distance of parameters.
    Within(T),
}

impl<T> From<Breadth<T>> for Reach<T> {
    fn from(breadth: Breadth<T>) -> Self {
        Self::Fixed(breadth)
    }
}

impl<T: Scalar> Reach<T> {
    /// The coefficients of `space` that move where it is grabbed at `at`.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    pub fn breadth(&self, space: &SplineSpace<T>, at: &T) -> Result<Breadth<T>> {
        space.locate(at)?;
        Ok(match self {
            Self::All if space.is_periodic() => Breadth::Whole,
            Self::All => Breadth::BetweenEnds(1),
            Self::Fixed(breadth) => breadth.clone(),
            Self::Nearest(count) => Breadth::Around(at.clone(), *count),
            Self::Within(distance) => Breadth::Listed(coeffs_within(space, at, distance)?),
        })
    }
}

/// The coefficients without influence farther from `at` than `distance`; around a ring it goes on past the seam.
pub(crate) fn coeffs_within<T: Scalar>(space: &SplineSpace<T>, at: &T, distance: &T) -> Result<Vec<usize>> {
    let (p, n, t) = (space.degree() as i64, space.dim() as i64, space.knots());
    let k = space.locate(at)? as i64;
    let (from, to) = (at.clone() - distance, at.clone() + distance);
    let (start, end) = space.domain();
    if space.is_periodic() && to.clone() - &from >= space.length() {
        return Ok((0..space.dim()).collect());
    }
    let count = t.len() as i64;
    let inside = |i: i64| space.is_periodic() || (0..count).contains(&i);
    let knot = |i: i64| {
        if (0..count).contains(&i) {
            return t[i as usize].clone();
        }
        let (turns, i) = ((i - p).div_euclid(n), (i - p).rem_euclid(n) + p);
        t[i as usize].clone() + space.length() * T::int(turns)
    };
    // What is beyond the ends of the domain does not count.
    let (open, mut first, mut past) = (!space.is_periodic(), k + 1, k + 1);
    while inside(first - 1) && ((open && from <= *start) || knot(first - 1) >= from) {
        first -= 1;
    }
    while inside(past) && ((open && to >= *end) || knot(past) <= to) {
        past += 1;
    }
    Ok((first..past - p - 1).take(n as usize).map(|i| i.rem_euclid(n) as usize).collect())
}

/// Knots, if any are needed, after which `count` coefficients at least have no influence farther from `at` than `distance`.
///
/// The ends of the interval become knots, then the middles of its longest spans; across the seam of a ring, half of them on each
/// side.
///
/// # Errors
/// [`Error::OutsideDomain`]; [`Error::EmptyDomain`] unless the distance is positive and finite, and in floating point no rounding; those of
/// [`Refinement::knots`] and [`SplineSpace::refined`].
pub(crate) fn knots_within<T: Scalar>(
    space: &SplineSpace<T>,
    at: &T,
    distance: &T,
    count: usize,
) -> Result<Vec<T>> {
    let (start, end) = space.domain();
    space.locate(at)?;
    let (from, to) = (at.clone() - distance, at.clone() + distance);
    if !(from < to && distance.is_finite()) {
        return Err(Error::EmptyDomain { start: from.to_string(), end: to.to_string() });
    }
    let length = space.length();
    let mut parts = if (from >= *start && to <= *end) || !space.is_periodic() {
        let inner = |x: T| {
            if x < *start {
                start.clone()
            } else if x > *end {
                end.clone()
            } else {
                x
            }
        };
        vec![(inner(from), inner(to))]
    } else if to.clone() - &from >= length {
        vec![(start.clone(), end.clone())]
    } else if from < *start {
        vec![(start.clone(), to), (from + &length, end.clone())]
    } else {
        vec![(start.clone(), to - &length), (from, end.clone())]
    };
    // Rounding may leave nothing on one side of the seam, or of the end.
    parts.retain(|(from, to)| from < to);
    if parts.is_empty() {
        return Err(Error::EmptyDomain { start: at.to_string(), end: at.to_string() });
    }
    if coeffs_within(space, at, distance)?.len() >= count {
        return Ok(Vec::new());
    }
    let mut asked = 0_usize;
    loop {
        let mut knots = Vec::new();
        for (k, (from, to)) in parts.iter().enumerate() {
            let share = Refinement::Count((asked + k) / parts.len());
            knots.extend(share.knots(space, from, to)?);
        }
        let found = coeffs_within(&space.refined(&knots)?, at, distance)?.len();
        if found >= count {
            return Ok(knots);
        }
        asked = asked.saturating_add(count - found);
    }
}
