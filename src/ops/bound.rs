//! Certified bounds of sizes and distances, and what every approximation returns.
//!
//! A spline is a convex combination of its coefficients, so that the largest of them bounds it; the difference of two
//! splines is a spline. On Bezier pieces, halved a few times, the bound closes in on the truth: its excess falls to a
//! quarter with every halving.
//!
//! Over an exact field these bounds hold as they stand. Elsewhere the difference is rounded, and an **allowance** for
//! that is part of the bound. Each of `s` steps (one a raised degree, one for the knots, one for the pieces, one a
//! halving) is a convex combination whose weights carry at most `6 p + 1` roundings and whose sum at most `p + 1`; so
//! with unit roundoff `ε / 2` the two splines together are off by at most
//!
//! ```text
//! 8 (p + 1) (s + 1) ε (|f| + |g|)        ε = 2^-52
//! ```
//!
//! where `|f|` is the largest coefficient and `p` the higher degree. Underflow is not accounted for.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::limits::check_dim;
use crate::scalar::{Scalar, larger, larger_size};
use crate::spline::Spline;

/// An approximation of a spline, a surface or a rational one, with a certified bound of the distance between the two.
///
/// The bound holds at every parameter, for limits from both sides, in the size in which errors are measured (the length
/// of the difference vector). How sharp it is depends on the operator.
///
/// # Examples
/// ```
/// use symspline::{Error, Function};
/// let near = Function::monomial(3, 0.0, 1.0)?.degree_lowered(1)?;
/// assert_eq!(near.spline.degree(), 2);
/// assert!(matches!(near.within(&1e-9), Err(Error::OutOfTolerance { .. })));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Approximation<S, T> {
    /// The approximation.
    pub spline: S,
    /// At least the largest distance from what it approximates.
    pub bound: T,
}

impl<S, T: Scalar> Approximation<S, T> {
    /// The spline, if it is certainly within `tolerance`, a distance between values.
    ///
    /// # Errors
    /// [`Error::OutOfTolerance`] if the bound is larger; [`Error::BadTolerance`] unless the tolerance is finite and not
    /// negative.
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// let line = Function::monomial(1, 0.0, 1.0)?;
    /// assert_eq!(line.elevated(1)?.degree_lowered(1)?.within(&1e-12)?, line);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn within(self, tolerance: &T) -> Result<S> {
        check_tolerance(tolerance)?;
        if self.bound <= *tolerance { Ok(self.spline) } else { Err(out_of_tolerance(&self.bound, tolerance)) }
    }
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// An upper bound of the size of the values `|f(x)|` over the domain: the size of the largest coefficient.
    ///
    /// # Errors
    /// [`Error::NotFinite`] on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, Scalar, SplineSpace};
    /// let f = Function::new(SplineSpace::bezier(2, Q::int(0), Q::int(1))?, [0, -4, 0].map(Q::int).to_vec())?;
    /// assert_eq!(f.size_bound()?, Q::int(4));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn size_bound(&self) -> Result<T> {
        finite(largest(self.coeffs()))
    }

    /// An upper bound of the distance `|f(x) - g(x)|` over the domain: the largest coefficient of the difference in the
    /// union of the spaces, and over inexact fields the allowance for rounding of the [module](crate::ops::bound).
    ///
    /// Over an exact field it is zero exactly if both are the same function.
    ///
    /// # Errors
    /// [`Error::DomainMismatch`]; [`Error::NotFinite`] on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, Scalar};
    /// let [f, g] = [1, 2].map(|power| Function::monomial(power, Q::int(0), Q::int(1)));
    /// assert_eq!(f?.distance_bound(&g?)?, Q::frac(1, 2));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn distance_bound(&self, other: &Self) -> Result<T> {
        let difference = self.difference(other)?;
        finite(largest(difference.coeffs()) + self.allowance(other, 0))
    }

    /// As [`distance_bound`](Self::distance_bound), sharpened: the difference is taken apart into Bezier pieces, and the
    /// pieces that may hold the maximum are halved up to `halvings` times.
    ///
    /// # Errors
    /// As [`distance_bound`](Self::distance_bound); [`Error::TooLarge`] if all halves together would be too many.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, Scalar};
    /// let [f, g] = [1, 2].map(|power| Function::monomial(power, Q::int(0), Q::int(1)));
    /// // x - x² is 1/4 at most.
    /// assert_eq!(f?.distance_bound_halved(&g?, 1)?, Q::frac(1, 4));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn distance_bound_halved(&self, other: &Self, halvings: usize) -> Result<T> {
        let bounds = self.difference(other)?.piece_bounds(halvings, None)?;
        finite(bounds.into_iter().fold(T::zero(), larger) + self.allowance(other, halvings))
    }

    /// An upper bound of the size on every span, without any allowance for rounding. Pieces whose bound is at most
    /// `enough` are not halved; without it those that cannot hold the maximum of all are not.
    pub(crate) fn piece_bounds(&self, halvings: usize, enough: Option<&T>) -> Result<Vec<T>> {
        let shift = u32::try_from(halvings).unwrap_or(u32::MAX);
        check_dim(self.coeffs().len().saturating_mul(1_usize.checked_shl(shift).unwrap_or(usize::MAX)))?;
        let p = self.degree();
        let pieces = self.bernstein(&self.space().ends())?;
        let mut reached = T::zero();
        let bound = |piece: &[C]| match enough {
            Some(enough) => halved_bound(piece.to_vec(), halvings, &mut enough.clone()),
            None => halved_bound(piece.to_vec(), halvings, &mut reached),
        };
        Ok(pieces.chunks(p + 1).map(bound).collect())
    }

    /// What rounding may add to the difference with `other`, in the union of the spaces or `halvings` below.
    pub(crate) fn allowance(&self, other: &Self, halvings: usize) -> T {
        let (this, other) = (largest(self.coeffs()), (other.degree(), largest(other.coeffs())));
        rounding(&this, self.degree(), other, halvings)
    }
}

/// An upper bound of the size of a polynomial with these Bernstein coefficients. `floor` is a size that need not be
/// undercut; it rises to the sizes of values that are met.
fn halved_bound<T: Scalar, C: Coeff<T>>(mut piece: Vec<C>, halvings: usize, floor: &mut T) -> T {
    let top = largest(&piece);
    let ends = larger(size(&piece[0]), size(&piece[piece.len() - 1]));
    if ends > *floor {
        *floor = ends;
    }
    if halvings == 0 || top <= *floor {
        return top;
    }
    // The algorithm of de Casteljau at the middle: the left half comes out at the front, the right one stays.
    let half = T::frac(1, 2);
    let mut left = Vec::with_capacity(piece.len());
    for rest in (1..=piece.len()).rev() {
        left.push(piece[0].clone());
        for i in 1..rest {
            let (before, after) = piece.split_at_mut(i);
            // Halved first, so that nothing overflows.
            let mean = &mut before[i - 1];
            mean.scale(&half);
            mean.add_scaled(&half, &after[0]);
        }
    }
    let left = halved_bound(left, halvings - 1, floor);
    larger(left, halved_bound(piece, halvings - 1, floor))
}

/// A number not below the size of the largest of some coefficients. Over inexact fields it has room for its own
/// rounding, and where squares could overflow or vanish the coefficients are scaled first; it is not finite if they are
/// not.
#[inline]
pub(crate) fn largest<'a, T: Scalar, C: Coeff<T>>(coeffs: impl IntoIterator<Item = &'a C> + Clone) -> T {
    let square = coeffs.clone().into_iter().map(C::squared_size).fold(T::zero(), larger_size);
    if T::EXACT {
        return square.root_above();
    }
    // This far from the ends of the range of floating point nothing overflows or gets lost.
    let tiny = (0..8).fold(T::one(), |tiny, _| tiny * epsilon::<T>());
    let count = coeffs.clone().into_iter().next().map_or(0, |c| c.components().count());
    let slack = T::one() + T::int(count as i64 + 8) * epsilon::<T>();
    if square > tiny && square < T::one() / tiny {
        return square.root_above() * slack;
    }
    let most =
        coeffs.clone().into_iter().flat_map(C::components).map(T::magnitude).fold(T::zero(), larger_size);
    let inverse = T::one() / &most;
    if most.is_zero() || !inverse.is_finite() {
        return most * T::int(count as i64);
    }
    let scaled = coeffs.into_iter().map(|c| c.scaled(&inverse).squared_size()).fold(T::zero(), larger_size);
    most * scaled.root_above() * slack
}

/// A number not below the size of a coefficient.
pub(crate) fn size<T: Scalar, C: Coeff<T>>(c: &C) -> T {
    largest([c])
}

/// A number not below the sum of two bounds.
pub(crate) fn sum_above<T: Scalar>(x: T, y: &T) -> T {
    if T::EXACT || x.is_zero() || y.is_zero() {
        return x + y;
    }
    (x + y) * (T::one() + T::int(2) * epsilon::<T>())
}

/// What rounding may add to the difference of two splines of these degrees and largest coefficients, in the union of their
/// spaces or `halvings` below.
pub(crate) fn rounding<T: Scalar>(size: &T, degree: usize, other: (usize, T), halvings: usize) -> T {
    if T::EXACT {
        return T::zero();
    }
    let (low, high) = (degree.min(other.0), degree.max(other.0));
    // Raises, knots, pieces, halvings, and one for the difference itself.
    let steps = (high - low + 2 + halvings + 1) as i64;
    let share = T::int(8 * (high as i64 + 1) * steps) * epsilon::<T>();
    size.clone() * &share + other.1 * share
}

/// What a tolerance leaves when `used` of it is gone: added to `used` it is certainly not more.
pub(crate) fn left_of<T: Scalar>(tolerance: &T, used: &T) -> T {
    let left = tolerance.clone() - used;
    if T::EXACT { left } else { left * (T::one() - T::int(8) * epsilon::<T>()) }
}

/// Twice the unit roundoff of inexact fields.
pub(crate) fn epsilon<T: Scalar>() -> T {
    T::frac(1, 1 << 52)
}

/// Refuses tolerances that are negative, NaN or infinite.
pub(crate) fn check_tolerance<T: Scalar>(tolerance: &T) -> Result<()> {
    if tolerance.is_finite() && *tolerance >= T::zero() {
        return Ok(());
    }
    Err(Error::BadTolerance { tolerance: tolerance.to_string() })
}

pub(crate) fn out_of_tolerance<T: Scalar>(bound: &T, tolerance: &T) -> Error {
    Error::OutOfTolerance { bound: bound.to_string(), tolerance: tolerance.to_string() }
}

/// A bound that did not overflow.
pub(crate) fn finite<T: Scalar>(bound: T) -> Result<T> {
    if bound.is_finite() { Ok(bound) } else { Err(Error::NotFinite { what: "bound", index: 0 }) }
}
