//! A bump with one weight: the function that pulls a warp out or pushes it in.
//!
//! `N = N_{3,3}` on `{0, 0, 0, 0, 1/4, 1/2, 3/4, 1, 1, 1, 1}` is the uniform cubic B-spline over `[0, 1]`, with maximum 2/3.
//! All weights but the middle one being 1, the rational basis function over its maximum is
//!
//! ```text
//! f = R / R_max = (N / m) (1 + (w - 1) m) / (1 + (w - 1) N)        m = 2/3     [NURBS, (11.43)-(11.45)]
//! ```
//! and with `N = N(s) N(t)`, `m = 4/9` for surfaces [NURBS, (11.50)].

use crate::error::{Error, Result};
use crate::scalar::Scalar;

/// A smooth function that rises from 0 at 0 to 1 at 1/2 and falls to 0 at 1, symmetrically. The greater the weight, the
/// steeper its sides and the flatter its top.
///
/// # Examples
/// ```
/// use symspline::{Bump, Q, Scalar};
/// let bump = Bump::new(Q::frac(1, 5))?;
/// assert_eq!((bump.at(&Q::frac(1, 2)), bump.at(&Q::frac(3, 10))), (Q::int(1), Q::frac(371, 1451)));
/// assert_eq!(bump.at_pair(&(Q::frac(1, 2), Q::frac(1, 2))), Q::int(1));
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Bump<T> {
    weight: T,
}

impl<T: Scalar> Bump<T> {
    /// The bump with a weight.
    ///
    /// # Errors
    /// [`Error::Weight`] unless the weight is positive and finite.
    pub fn new(weight: T) -> Result<Self> {
        if weight > T::zero() && weight.is_finite() {
            return Ok(Self { weight });
        }
        Err(Error::Weight { index: 3, weight: weight.to_string() })
    }

    /// The value at `t`; zero outside `[0, 1]`.
    pub fn at(&self, t: &T) -> T {
        self.over_top(hill(t), T::frac(2, 3))
    }

    /// The value of the bump over the unit square at `(s, t)`; zero outside.
    pub fn at_pair(&self, (s, t): &(T, T)) -> T {
        self.over_top(hill(s) * hill(t), T::frac(4, 9))
    }

    /// `R / R_max` from `N` and its maximum. Numerator and denominator are divided by a great weight, so that nothing
    /// overflows.
    fn over_top(&self, n: T, top: T) -> T {
        let one = T::one();
        let (own, rest) =
            if self.weight > one { (one.clone(), one / &self.weight) } else { (self.weight.clone(), one) };
        let weighted = |n: &T| n.clone() * &own + (T::one() - n) * &rest;
        weighted(&top) / weighted(&n) * (n / top)
    }
}

/// The uniform cubic B-spline over `[0, 1]`.
fn hill<T: Scalar>(t: &T) -> T {
    let mirrored = T::one() - t;
    let x = if *t < mirrored { t.clone() } else { mirrored } * T::int(4);
    if x <= T::zero() {
        T::zero()
    } else if x <= T::one() {
        x.clone() * &x * x / T::int(6)
    } else {
        let y = x - T::one();
        // 1 + 3 y + 3 y² - 3 y³
        (T::one() + (T::one() + (T::one() - &y) * &y) * &y * T::int(3)) / T::int(6)
    }
}
