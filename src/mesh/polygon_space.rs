//! Spline spaces from knot intervals, as polygons carry them.
//!
//! Interval `j` of a polygon of degree `p` is the length of the span `[t_{j+p-1}, t_{j+p}]` if the polygon is closed, and of
//! `[t_{j+1}, t_{j+2}]` if it is open: all knots but the first and the last, which change nothing.

use crate::coeff::Coeff;
use crate::error::mesh::MeshError;
use crate::error::{Error, Result};
use crate::limits::check_dim;
use crate::mesh::catmull_clark::check_intervals;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::{Curve, Spline};
use nalgebra::SVector;

/// Refuses polygons that have no curve: points and intervals.
pub(super) fn check<T: Scalar, const N: usize>(
    degree: usize,
    closed: bool,
    points: &[SVector<T, N>],
    intervals: &[T],
) -> Result<()> {
    let (count, few) = (points.len(), if closed { 3 } else { degree + 1 });
    if count < few {
        return Err(Error::TooFewPoints { expected: few, found: count });
    }
    check_dim(count)?;
    if let Some(index) = points.iter().position(|point| !point.all_finite()) {
        return Err(Error::NotFinite { what: "point", index });
    }
    let expected = if closed { count } else { count + degree - 2 };
    if intervals.len() != expected {
        return Err(Error::CoefficientCount { expected, found: intervals.len() });
    }
    check_intervals(intervals)?;
    // Knots are sums of intervals, and the weights of the rules have sums of three of them in a row, doubled.
    let mut whole = T::zero();
    if let Some(index) = intervals.iter().position(|interval| {
        whole += interval;
        !(T::int(4) * &whole).is_finite()
    }) {
        return Err(Error::NotFinite { what: "sum of knot intervals", index });
    }
    if !closed && intervals[degree - 1] == T::zero() {
        return Err(Error::UnusedCoefficient { index: 0 });
    }
    if !closed && intervals[expected - degree] == T::zero() {
        return Err(Error::UnusedCoefficient { index: count - 1 });
    }
    let round = if closed { degree - 1 } else { 0 };
    let mut zeros = 0;
    for (index, interval) in intervals.iter().chain(&intervals[..round]).enumerate() {
        zeros = if *interval == T::zero() { zeros + 1 } else { 0 };
        if zeros == degree {
            return Err(MeshError::Torn { index: (index + 1 - degree) % expected, count: degree }.into());
        }
    }
    Ok(())
}

/// Refuses to halve intervals so often that there are too many: those that vanish are not halved.
pub(super) fn check_depth<T: Scalar>(intervals: &[T], depth: usize) -> Result<()> {
    let whole = intervals.iter().filter(|interval| **interval != T::zero()).count();
    let parts = u32::try_from(depth).ok().and_then(|depth| 1_usize.checked_shl(depth)).unwrap_or(usize::MAX);
    check_dim(whole.saturating_mul(parts).saturating_add(intervals.len()))
}

/// The spline over the knots that the intervals tell. That of a closed polygon begins where interval 1 does, or the next one
/// that is not zero.
pub(super) fn curve<T: Scalar, const N: usize>(
    degree: usize,
    closed: bool,
    points: &[SVector<T, N>],
    intervals: &[T],
) -> Result<Curve<T, N>> {
    if !closed {
        return Spline::new(open_space(degree, intervals)?, points.to_vec());
    }
    let count = points.len();
    let first = (1..=count).find(|j| intervals[j % count] != T::zero()).unwrap_or(1);
    // All knots once round; those before zero intervals at the end are at the seam.
    let seam = (1..count).take_while(|back| intervals[(first + count - back) % count] == T::zero()).count();
    let mut knots = vec![T::zero(); seam + 1];
    for j in first..first + count - seam - 1 {
        let knot = knots[knots.len() - 1].clone() + &intervals[j % count];
        knots.push(knot);
    }
    let period = knots[count - 1].clone() + &intervals[(first + count - seam - 1) % count];
    let vertices = (0..count).map(|j| points[(first + count - 1 + j) % count].clone()).collect();
    Spline::new(SplineSpace::periodic(degree, knots, period)?, vertices)
}

/// The space whose domain begins at 0.
fn open_space<T: Scalar>(degree: usize, intervals: &[T]) -> Result<SplineSpace<T>> {
    let (before, after) = intervals.split_at(degree - 1);
    let back = before.iter().rev().chain(before.first()).scan(T::zero(), |t, interval| {
        *t -= interval;
        Some(t.clone())
    });
    let mut knots: Vec<T> = back.collect();
    knots.reverse();
    knots.push(T::zero());
    for interval in after.iter().chain(after.last()) {
        knots.push(knots[knots.len() - 1].clone() + interval);
    }
    SplineSpace::new(degree, knots)
}
