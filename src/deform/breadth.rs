//! How far a deformation reaches: which coefficients may move.

use crate::error::deform::DeformError;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use std::ops::Range;

/// Which coefficients of a space may move; the others are held, and with them the shape where only they have influence.
///
/// The fewer may move, the narrower a deformation is [Vassilev, section 2.3].
///
/// # Examples
/// ```
/// use symspline::{Breadth, SplineSpace};
/// let space = SplineSpace::clamped(3, [0.0, 1.0, 2.0, 3.0, 4.0])?;
/// assert_eq!(Breadth::BetweenEnds(1).coeffs(&space)?, [1, 2, 3, 4, 5]);
/// assert_eq!(Breadth::Around(2.0, 3).coeffs(&space)?, [2, 3, 4]);
/// let ring = SplineSpace::periodic(2, [0.0, 1.0, 2.0, 3.0], 4.0)?;
/// assert_eq!(Breadth::Range(3..5).coeffs(&ring)?, [0, 3]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub enum Breadth<T> {
    /// All of them.
    #[default]
    Whole,
    /// All but this many at each end: with one the end points of clamped curves stay, with two the tangents there too.
    BetweenEnds(usize),
    /// A run of coefficients; in a periodic space it may go on past the last.
    Range(Range<usize>),
    /// So many, all if there are not more: those whose nodes lie next to a parameter.
    Around(T, usize),
    /// Those without influence outside an interval, whose ends are knots [NURBS, (11.40)].
    Within(T, T),
    /// These ones.
    Listed(Vec<usize>),
}

impl<T: Scalar> Breadth<T> {
    /// The indices of the coefficients of `space` that may move, in ascending order.
    ///
    /// # Errors
    /// [`DeformError::NothingMoves`], [`DeformError::NoEnds`]; [`Error::IndexOutOfRange`]; [`Error::OutsideDomain`]; those of
    /// [`SplineSpace::local_coeffs`].
    pub fn coeffs(&self, space: &SplineSpace<T>) -> Result<Vec<usize>> {
        let n = space.dim();
        let mut found: Vec<usize> = match self {
            Self::Whole => (0..n).collect(),
            Self::BetweenEnds(_) if space.is_periodic() => return Err(DeformError::NoEnds.into()),
            Self::BetweenEnds(held) => (*held..n.saturating_sub(*held)).collect(),
            Self::Range(range) => {
                let length = if space.is_periodic() { range.start.saturating_add(n) } else { n };
                if range.end > length || (range.start >= n && !range.is_empty()) {
                    return Err(Error::IndexOutOfRange { index: range.end.max(range.start), length });
                }
                range.clone().map(|i| space.slot(i)).collect()
            }
            Self::Around(at, count) => around(space, at, *count)?,
            Self::Within(from, to) => space.local_coeffs(from, to)?.map(|i| space.slot(i)).collect(),
            Self::Listed(listed) => listed.clone(),
        };
        found.sort_unstable();
        found.dedup();
        match found.last() {
            None => Err(DeformError::NothingMoves.into()),
            Some(last) if *last >= n => Err(Error::IndexOutOfRange { index: *last, length: n }),
            Some(_) => Ok(found),
        }
    }
}

/// The `count` coefficients whose nodes are nearest to `at`.
fn around<T: Scalar>(space: &SplineSpace<T>, at: &T, count: usize) -> Result<Vec<usize>> {
    let (n, k) = (space.dim(), space.locate(at)?);
    if count >= n {
        return Ok((0..n).collect());
    }
    // In a ring the window lies anywhere among three rounds, counted from the second.
    let turn = |i: i64| {
        let period = space.length();
        let (turns, i) =
            if space.is_periodic() { (i.div_euclid(n as i64), i.rem_euclid(n as i64)) } else { (0, i) };
        space.mean_of_knots(i as usize) + period * T::int(turns)
    };
    let distance = |i: i64| (turn(i) - at).magnitude();
    let inside = |i: i64| space.is_periodic() || (0..n as i64).contains(&i);
    // One of the coefficients with influence has the nearest node.
    let influential = (k - space.degree()) as i64..=k as i64;
    let nearest = influential.reduce(|best, i| if distance(i) < distance(best) { i } else { best });
    let (mut first, mut past) = nearest.map_or((0, 0), |i| (i, i));
    for _ in 0..count {
        let (left, right) = (first - 1, past);
        let goes_left = inside(left) && (!inside(right) || distance(left) < distance(right));
        if goes_left { first = left } else { past = right + 1 }
    }
    Ok((first..past).map(|i| i.rem_euclid(n as i64) as usize).collect())
}
