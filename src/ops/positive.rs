//! A proof that a function is positive, by a number below all its values.
//!
//! Values are not below the least coefficient. Where that does not decide, Bezier pieces are halved, least coefficients
//! first closing in on values from below, until every piece is decided or a value that is not positive is met.

use crate::error::{Error, Result};
use crate::ops::patch::Patch;
use crate::scalar::Scalar;
use crate::spline::Function;

/// How often a piece is halved one after the other: near a zero no halving decides.
const DEPTH: usize = 60;

/// How many halvings there are at most.
const HALVINGS: usize = 20_000;

impl<T: Scalar> Function<T> {
    /// A positive number that no value is below, limits at jumps included: a proof that the function is positive.
    ///
    /// It is the least coefficient if that is positive, else a bound on halved pieces, which may be far below the least
    /// value.
    ///
    /// Over `f64` a function so near zero that rounding could hide its sign counts as not positive.
    ///
    /// # Errors
    /// [`Error::NotPositive`] with a place where it is not; [`Error::Undecided`] where halving does not tell.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, Function, Q, Scalar, SplineSpace};
    /// let parabola = |middle: i64| {
    ///     Function::new(SplineSpace::bezier(2, Q::int(0), Q::int(1))?, [2, middle, 2].map(Q::int).to_vec())
    /// };
    /// assert_eq!(parabola(1)?.positive_bound()?, Q::int(1));
    /// assert_eq!(parabola(-1)?.positive_bound()?, Q::frac(1, 2));
    /// let touching = parabola(-2)?.positive_bound().unwrap_err();
    /// assert_eq!(touching, Error::NotPositive { parameter: "1/2".into(), value: "0".into() });
    /// # Ok::<(), Error>(())
    /// ```
    pub fn positive_bound(&self) -> Result<T> {
        positive_bound_of(self.coeffs(), || self.patches(), |halvings| self.allowance(self, halvings))
    }
}

/// A positive number that no value of the function with these coefficients and `patches` is below; `noise` is what rounding
/// may do to coefficients after a number of halvings.
///
/// # Errors
/// [`Error::NotPositive`], [`Error::Undecided`], those of `patches`.
pub(crate) fn positive_bound_of<T: Scalar, const D: usize>(
    coeffs: &[T],
    patches: impl FnOnce() -> Result<Vec<Patch<T, D>>>,
    noise: impl Fn(usize) -> T,
) -> Result<T> {
    if let Some(least) = least(coeffs).filter(|least| **least > T::zero()) {
        return Ok(least.clone());
    }
    let mut open: Vec<_> = patches()?.into_iter().map(|patch| (patch, 0)).collect();
    let mut bound: Option<T> = None;
    let mut halvings = 0;
    let mut noises: Vec<T> = Vec::new();
    while let Some((patch, depth)) = open.pop() {
        while noises.len() <= depth {
            noises.push(noise(noises.len()));
        }
        let noise = &noises[depth];
        let corner = patch.lowest_corner();
        if corner.value <= *noise {
            return Err(not_positive(&corner.parameter, &corner.value));
        }
        match least(&patch.coeffs).map(|least| least.clone() - noise).filter(|least| *least > T::zero()) {
            Some(least) => {
                if bound.as_ref().is_none_or(|bound| least < *bound) {
                    bound = Some(least);
                }
            }
            None if depth == D * DEPTH || halvings == HALVINGS => return Err(Error::Undecided),
            None => {
                halvings += 1;
                open.extend(patch.halves(depth).map(|half| (half, depth + 1)));
            }
        }
    }
    bound.ok_or(Error::Undecided)
}

/// [`Error::NotPositive`] at a parameter, or a pair of them.
fn not_positive<T: Scalar>(parameter: &[T], value: &T) -> Error {
    let parameters: Vec<String> = parameter.iter().map(T::to_string).collect();
    let parameter = match parameters.as_slice() {
        [parameter] => parameter.clone(),
        several => format!("({})", several.join(", ")),
    };
    Error::NotPositive { parameter, value: value.to_string() }
}

/// The least of some numbers.
fn least<T: PartialOrd>(numbers: &[T]) -> Option<&T> {
    numbers.iter().reduce(|low, x| if x < low { x } else { low })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;
    use crate::space::SplineSpace;

    #[test]
    fn dips_between_positive_values_are_found() {
        // 3 (x - 2/3)² - 1/100 on [0, 1], positive at both ends and in the middle.
        let dip = [Q::frac(4, 3), Q::frac(-2, 3), Q::frac(1, 3)].map(|c| c - Q::frac(1, 100));
        let dip = Function::new(SplineSpace::bezier(2, Q::int(0), Q::int(1)).unwrap(), dip.to_vec()).unwrap();
        assert!(matches!(dip.positive_bound(), Err(Error::NotPositive { .. })));
        assert!(dip.translated(&Q::frac(1, 50)).unwrap().positive_bound().unwrap() > Q::int(0));
        let dip = dip.to_f64().unwrap();
        assert!(matches!(dip.positive_bound(), Err(Error::NotPositive { .. })));
        assert!(dip.translated(&0.02).unwrap().positive_bound().unwrap() > 0.0);
    }

    #[test]
    fn irrational_double_zeros_are_undecided_soon() {
        // (x² - 2)² on [1, 2].
        let coeffs = [3, 0, -2, 0, 12].map(|c| Q::frac(c, 3));
        let touching = Function::new(SplineSpace::bezier(4, Q::int(1), Q::int(2)).unwrap(), coeffs.to_vec());
        let touching = touching.unwrap();
        assert_eq!(touching.positive_bound(), Err(Error::Undecided));
        assert!(matches!(touching.to_f64().unwrap().positive_bound(), Err(Error::NotPositive { .. })));
    }

    #[test]
    fn jumps_count_from_both_sides() {
        let steps = SplineSpace::clamped(0, [0.0, 1.0, 2.0]).unwrap();
        let jump = Function::new(steps, vec![1.0, -1.0]).unwrap();
        assert!(matches!(jump.positive_bound(), Err(Error::NotPositive { .. })));
    }
}
