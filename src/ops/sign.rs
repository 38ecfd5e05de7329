//! The sign of a function on its whole domain, proved.
//!
//! Values lie between Bernstein coefficients. Where those do not decide, a patch is halved until they do, or until a value
//! shows the other sign.

use crate::error::{Error, Result};
use crate::ops::patch::Patch;
use crate::scalar::Scalar;

/// The sign that all values have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// Above zero.
    Positive,
    /// Below zero.
    Negative,
}

/// How many halvings there are at most.
const HALVINGS: usize = 20_000;

/// The sign of the values of the function that consists of `patches`.
///
/// # Errors
/// [`Error::Pole`] if there is a zero, [`Error::Undecided`] if too many halvings would be needed.
pub(crate) fn sign_of<T: Scalar, const D: usize>(patches: Vec<Patch<T, D>>) -> Result<Sign> {
    let first = patches.first().map_or_else(T::zero, |patch| patch.coeffs[0].clone());
    let sign = if first > T::zero() { Sign::Positive } else { Sign::Negative };
    let has_it = |x: &T| match sign {
        Sign::Positive => *x > T::zero(),
        Sign::Negative => *x < T::zero(),
    };
    let mut open: Vec<(Patch<T, D>, usize)> = patches.into_iter().map(|patch| (patch, 0)).collect();
    let mut halvings = 0;
    while let Some((patch, depth)) = open.pop() {
        if !patch.corners().all(has_it) {
            return Err(Error::Pole);
        }
        if patch.coeffs.iter().all(has_it) {
            continue;
        }
        halvings += 1;
        if halvings > HALVINGS {
            return Err(Error::Undecided);
        }
        open.extend(patch.halves(depth).map(|half| (half, depth + 1)));
    }
    Ok(sign)
}
