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

/// How often a patch is halved at most one after the other, for each direction. Near a double zero no halving decides, and
/// the numbers of an exact field grow with each.
const DEPTH: usize = 100;

/// How many halvings of one piece there are at most: fewer for high degrees, where each costs more.
fn most_halvings<const D: usize>(degrees: [usize; D]) -> usize {
    let coeffs: usize = degrees.iter().map(|p| p + 1).product();
    let steps = degrees.iter().sum::<usize>() + 1;
    (8_000_000 / coeffs.saturating_mul(steps)).clamp(512, 20_000)
}

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
    patches.into_iter().try_for_each(|patch| check_patch(patch, has_it))?;
    Ok(sign)
}

/// Checks that all values of a patch have the sign that `has_it` tells.
fn check_patch<T: Scalar, const D: usize>(patch: Patch<T, D>, has_it: impl Fn(&T) -> bool) -> Result<()> {
    let most = most_halvings(patch.degrees);
    let mut open = vec![(patch, 0)];
    let mut halvings = 0;
    while let Some((patch, depth)) = open.pop() {
        if !patch.corners().all(&has_it) {
            return Err(Error::Pole);
        }
        if patch.coeffs.iter().all(&has_it) {
            continue;
        }
        halvings += 1;
        if depth == D * DEPTH || halvings > most {
            return Err(Error::Undecided);
        }
        open.extend(patch.halves(depth).map(|half| (half, depth + 1)));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;

    #[test]
    fn an_irrational_double_zero_is_undecided_soon() {
        // (x² - 2)² on [1, 2].
        let coeffs = [3, 0, -2, 0, 12].map(|c| Q::frac(c, 3));
        let touching = Patch { degrees: [4], sides: [(Q::int(1), Q::int(2))], coeffs: coeffs.to_vec() };
        assert_eq!(sign_of(vec![touching]), Err(Error::Undecided));
    }
}
