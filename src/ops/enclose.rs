//! Extreme values of polynomial patches, by branch and bound.
//!
//! On a patch a value is a mean of the Bernstein coefficients, so the least of them is a bound from below; and the
//! coefficients at the corners are values. Halving a patch (de Casteljau) leaves convex combinations and takes the bounds
//! to a quarter of their distance from the function. So the least value is enclosed by halving, always the patch of the
//! lowest bound, until the lowest value met is near enough. No root is looked for, and any ordered field will do.
//!
//! Patches have any number of directions: curves have one, surfaces two.

use crate::error::{Error, Result};
use crate::limits::MAX_HALVED;
use crate::ops::patch::{Meeting, Ordinate, Patch};
use crate::scalar::{Scalar, larger};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// How often a patch is halved at most: an accuracy not reached by then is infinitely small beside the values.
const DEPTH: usize = 4096;

/// How many halvings there are in all at most.
const HALVINGS: usize = 1 << 16;

/// An extreme value between a bound and a value met.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Extremum<T, X = T> {
    /// The function nowhere goes beyond this.
    pub bound: T,
    /// The function goes that far: its value at `parameter`.
    pub value: T,
    /// Where `value` is met; at a jump it may be the limit there from the other side.
    pub parameter: X,
}

/// Both extreme values of a function: it stays within the bounds and reaches the values.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Enclosure<T, X = T> {
    /// `bound <= the least value <= value`.
    pub least: Extremum<T, X>,
    /// `value <= the greatest value <= bound`.
    pub greatest: Extremum<T, X>,
}

impl<T, X> Enclosure<T, X> {
    /// The same with other parameters.
    pub(crate) fn map_parameters<Y>(self, parameter: impl Fn(X) -> Y) -> Enclosure<T, Y> {
        let Self { least, greatest } = self;
        let map = |e: Extremum<T, X>| Extremum {
            bound: e.bound,
            value: e.value,
            parameter: parameter(e.parameter),
        };
        Enclosure { least: map(least), greatest: map(greatest) }
    }
}

/// The extreme values of the function that consists of `patches`, of which there is at least one, to `accuracy`.
///
/// # Errors
/// [`Error::BadTolerance`] unless `accuracy` is positive and finite, and not infinitely small; [`Error::TooLarge`] if the
/// extreme values are met in too many places to be separated.
pub(crate) fn enclose<T: Scalar, C: Ordinate<T>, const D: usize>(
    patches: Vec<Patch<T, D, C>>,
    accuracy: &T,
) -> Result<Enclosure<T, [T; D]>> {
    if !accuracy.is_finite() || *accuracy <= T::zero() {
        return Err(Error::BadTolerance { tolerance: accuracy.to_string() });
    }
    let negative = |patch: &Patch<T, D, C>| Patch {
        coeffs: patch.coeffs.iter().map(C::mirrored).collect(),
        ..patch.clone()
    };
    let mirrored = least(patches.iter().map(negative).collect(), accuracy)?;
    let greatest = Extremum { bound: -mirrored.bound, value: -mirrored.value, parameter: mirrored.parameter };
    Ok(Enclosure { least: least(patches, accuracy)?, greatest })
}

/// The least value of the function that consists of `patches`.
fn least<T: Scalar, C: Ordinate<T>, const D: usize>(
    patches: Vec<Patch<T, D, C>>,
    accuracy: &T,
) -> Result<Extremum<T, [T; D]>> {
    let accuracy = larger(accuracy.clone(), noise(&patches));
    let lowest = |one: Meeting<T, D>, other: Meeting<T, D>| if other.value < one.value { other } else { one };
    let most = HALVINGS.min(MAX_HALVED / patches.first().map_or(1, |patch| patch.coeffs.len()));
    let mut best = patches.iter().map(Patch::lowest_corner).reduce(lowest).expect("there is a patch");
    let mut open: BinaryHeap<Open<T, D, C>> = patches.into_iter().map(|patch| Open::new(patch, 0)).collect();
    for halvings in 0.. {
        let Open { bound, depth, patch } = open.pop().expect("halves are put back");
        if best.value.clone() - &bound <= accuracy {
            let Meeting { value, parameter } = best;
            let bound = if bound < value { bound } else { value.clone() };
            return Ok(Extremum { bound, value, parameter });
        }
        if depth == DEPTH {
            return Err(Error::BadTolerance { tolerance: accuracy.to_string() });
        }
        if halvings == most {
            break;
        }
        for half in patch.halves(depth) {
            best = lowest(best, half.lowest_corner());
            open.push(Open::new(half, depth + 1));
        }
    }
    Err(Error::TooLarge { count: most + 1, limit: most })
}

/// Differences below this are rounding.
fn noise<T: Scalar, C: Ordinate<T>, const D: usize>(patches: &[Patch<T, D, C>]) -> T {
    if T::EXACT {
        return T::zero();
    }
    let sizes = patches.iter().flat_map(|patch| &patch.coeffs).map(|c| c.ordinate().magnitude());
    let steps = patches.iter().map(|patch| patch.degrees.iter().sum::<usize>() + 1).max().unwrap_or(1);
    sizes.fold(T::zero(), larger) * T::frac(steps as i64, 1 << 50)
}

/// A patch that may hold the least value; the one of the lowest bound is the greatest of the heap.
struct Open<T, const D: usize, C> {
    bound: T,
    depth: usize,
    patch: Patch<T, D, C>,
}

impl<T: Scalar, const D: usize, C: Ordinate<T>> Open<T, D, C> {
    fn new(patch: Patch<T, D, C>, depth: usize) -> Self {
        let ordinates = patch.coeffs.iter().map(C::ordinate);
        let lowest = ordinates.reduce(|low, c| if c < low { c } else { low });
        let bound = lowest.expect("a patch has a coefficient");
        Self { bound, depth, patch }
    }
}

impl<T: Scalar, const D: usize, C> Ord for Open<T, D, C> {
    fn cmp(&self, other: &Self) -> Ordering {
        other.bound.partial_cmp(&self.bound).expect("finite coefficients are ordered")
    }
}

impl<T: Scalar, const D: usize, C> PartialOrd for Open<T, D, C> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<T: Scalar, const D: usize, C> PartialEq for Open<T, D, C> {
    fn eq(&self, other: &Self) -> bool {
        self.bound == other.bound
    }
}

impl<T: Scalar, const D: usize, C> Eq for Open<T, D, C> {}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;

    /// `x² y - x y + x / 3` on `[0, 1] × [0, 2]`, and its least value.
    fn saddle() -> Patch<Q, 2> {
        // Along x the coefficients of x² are 0, 0, 1 and of x are 0, 1/2, 1; along y those of y are 0, 2, of 1 are 1, 1.
        let (square, x) = ([0, 0, 1].map(Q::int), [Q::int(0), Q::frac(1, 2), Q::int(1)]);
        let entry = |i: usize, y: i64| (square[i].clone() - &x[i]) * Q::int(y) + x[i].clone() * Q::frac(1, 3);
        let coeffs = (0..3).flat_map(|i| [entry(i, 0), entry(i, 2)]).collect();
        Patch { degrees: [2, 1], sides: [1, 2].map(|end| (Q::int(0), Q::int(end))), coeffs }
    }

    impl Patch<Q, 2> {
        fn at(&self, x: &Q, y: &Q) -> Q {
            (x.clone() * x - x) * y + x.clone() / Q::int(3)
        }
    }

    #[test]
    fn a_surface_patch_is_enclosed() {
        let patch = saddle();
        let accuracy = Q::frac(1, 1000);
        let Enclosure { least, greatest } = enclose(vec![patch.clone()], &accuracy).unwrap();
        // At y = 2 it is 2 x² - 5/3 x, least at 5/12; the greatest value 1/3 is at the corners x = 1.
        let exact = Q::frac(-25, 72);
        assert!(least.bound <= exact && exact <= least.value);
        assert!(least.value.clone() - &least.bound <= accuracy);
        let [x, y] = &least.parameter;
        assert_eq!(patch.at(x, y), least.value);
        assert_eq!((greatest.bound, greatest.value), (Q::frac(1, 3), Q::frac(1, 3)));
    }

    #[test]
    fn the_lower_of_two_patches_counts() {
        let low = |by: i64| {
            let mut patch = saddle();
            patch.coeffs.iter_mut().for_each(|c| *c += Q::int(by));
            patch.sides.iter_mut().for_each(|s| *s = (s.0.clone() + Q::int(by), s.1.clone() + Q::int(by)));
            patch
        };
        let range = enclose(vec![low(0), low(-7), low(5)], &Q::frac(1, 10)).unwrap();
        assert!(range.least.bound <= Q::int(-7) - Q::frac(25, 72));
        assert!(range.least.parameter.iter().all(|x| *x <= Q::int(-5)));
        assert_eq!(range.greatest.value, Q::int(5) + Q::frac(1, 3));
    }

    #[test]
    fn constants_in_some_directions_are_decided() {
        let flat = |degrees: [usize; 2], coeffs: Vec<f64>| Patch { degrees, sides: [(0.0, 1.0); 2], coeffs };
        let range = enclose(vec![flat([0, 0], vec![4.0])], &1e-9).unwrap();
        assert_eq!((range.least.bound, range.greatest.bound), (4.0, 4.0));
        let range = enclose(vec![flat([0, 2], vec![1.0, 0.0, 1.0])], &1e-9).unwrap();
        assert_eq!((range.least.value, range.least.parameter), (0.5, [0.0, 0.5]));
        let range = enclose(vec![flat([2, 0], vec![1.0, 0.0, 1.0])], &1e-9).unwrap();
        assert_eq!((range.least.value, range.least.parameter), (0.5, [0.5, 0.0]));
    }

    #[test]
    fn valleys_along_a_diagonal_end_somewhere() {
        // (x - y)² is least all along x = y.
        let coeffs = vec![0.0, 0.0, 1.0, 0.0, -0.5, 0.0, 1.0, 0.0, 0.0];
        let valley = Patch { degrees: [2, 2], sides: [(0.0, 1.0); 2], coeffs };
        let range = enclose(vec![valley.clone()], &1e-6).unwrap();
        assert_eq!(range.least.value, 0.0);
        assert!(range.least.bound >= -1e-6);
        // Below the rounding no patch is halved any more.
        let fine = enclose(vec![valley], &1e-300);
        assert!(fine.is_ok() || matches!(fine, Err(Error::TooLarge { .. })));
    }
}
