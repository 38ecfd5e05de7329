//! Roots of a polynomial in Bernstein form, isolated with certainty and, where the field holds them, found exactly.
//!
//! The number of roots inside an interval, each with its multiplicity, is the number of sign changes of the
//! Bernstein coefficients there less an even number (Descartes' rule of signs). So no change means no root and one change
//! one simple root; intervals with more are bisected. Multiple roots would be bisected for ever: where bisection goes deep,
//! an exact field goes over to the square-free part.
//!
//! Coefficients are taken as the numbers they are. Over `f64` too the isolation is exact, and each root is the float
//! nearest to it.

mod polynomial;
mod square_free;
mod isolate;
mod rational;
mod twofold;
pub(crate) mod float;

use crate::error::{Error, Result};
use crate::scalar::Scalar;
pub use polynomial::Polynomial;
use std::cmp::Ordering;

/// All roots of a polynomial in its interval, the ends included.
///
/// # Examples
/// ```
/// use symspline::roots::{Polynomial, Root, RootValue, Roots};
/// use symspline::{Q, Scalar};
/// // (x - 1)² (x - 3) on [0, 3].
/// let p = Polynomial::new(Q::int(0), Q::int(3), [-3, 4, -4, 0].map(Q::int).to_vec())?;
/// let root = |x: i64, multiplicity| Root { value: RootValue::Exact(Q::int(x)), multiplicity };
/// assert_eq!(p.roots(), Roots::At(vec![root(1, 2), root(3, 1)]));
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Roots<T> {
    /// The polynomial is zero.
    Everywhere,
    /// The roots, ascending.
    At(Vec<Root<T>>),
}

/// A root with its multiplicity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Root<T> {
    /// Where it is.
    pub value: RootValue<T>,
    /// How often it counts.
    pub multiplicity: usize,
}

/// Where a root is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RootValue<T> {
    /// At this number; over `f64` at the nearest to it.
    Exact(T),
    /// Strictly between these numbers, and no other root is.
    Enclosed(T, T),
}

/// A field over which polynomials can be solved.
///
/// All methods are provided, so that `impl Solvable for` any field is enough: they isolate roots over any ordered field, and give the roots of linear polynomials exactly.
/// Over an inexact field roots that are not told apart before an interval has no middle left are one root with the sum of
/// their multiplicities, or none.
pub trait Solvable: Scalar {
    /// The roots of a polynomial in its interval.
    fn roots(polynomial: &Polynomial<Self>) -> Roots<Self> {
        let Some(found) = isolate::isolation(polynomial) else { return Roots::Everywhere };
        let isolate::Isolation { factor, roots } = found;
        let root = |(start, end, multiplicity): (Self, Self, usize)| {
            let value = if start == end { RootValue::Exact(start) } else { Self::root(&factor, start, end) };
            Root { value, multiplicity }
        };
        Roots::At(roots.into_iter().map(root).collect())
    }

    /// The one root of `polynomial` between `start` and `end`, which is simple: exactly if it is known to be in the field.
    ///
    /// The ends lie in the interval of the polynomial and are no roots.
    fn root(polynomial: &Polynomial<Self>, start: Self, end: Self) -> RootValue<Self> {
        polynomial.linear_root().map_or(RootValue::Enclosed(start, end), RootValue::Exact)
    }

    /// Whether the polynomial with these coefficients of powers, the lowest first, is known to have simple roots only: a quick
    /// answer that saves the search for multiple ones.
    fn has_simple_roots(powers: &[Self]) -> bool {
        let _ = powers;
        false
    }

    /// Multiplies by a common positive factor that makes the numbers small.
    fn tidy(numbers: &mut [Self]) {
        let _ = numbers;
    }
}

impl<T> RootValue<T> {
    /// A lower and an upper bound, equal where the root is known.
    ///
    /// # Examples
    /// ```
    /// use symspline::roots::RootValue;
    /// assert_eq!(RootValue::Exact(1).bounds(), (&1, &1));
    /// assert_eq!(RootValue::Enclosed(1, 2).bounds(), (&1, &2));
    /// ```
    pub fn bounds(&self) -> (&T, &T) {
        match self {
            Self::Exact(x) => (x, x),
            Self::Enclosed(start, end) => (start, end),
        }
    }
}

impl<T: Solvable> Polynomial<T> {
    /// The roots in the interval.
    ///
    /// Exact fields isolate every root and tell multiplicities. Over `f64` each root is the float nearest to a root of the
    /// polynomial with just these coefficients, so that roots closer than rounding may be the same float twice. Over [`Q`](crate::Q)
    /// rational roots are exact, and only irrational ones are enclosed.
    ///
    /// # Examples
    /// ```
    /// use symspline::roots::{Polynomial, Root, RootValue, Roots};
    /// // x² - 2 on [0, 2].
    /// let p = Polynomial::new(0.0, 2.0, vec![-2.0, -2.0, 2.0])?;
    /// let root = Root { value: RootValue::Exact(2.0_f64.sqrt()), multiplicity: 1 };
    /// assert_eq!(p.roots(), Roots::At(vec![root]));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn roots(&self) -> Roots<T> {
        T::roots(self)
    }

    /// A place where the polynomial is negative, if there is one.
    ///
    /// Over `f64` it is one where the value that is computed is negative; there need not be one if the polynomial is
    /// negative by no more than rounding.
    pub(crate) fn negative_at(&self) -> Option<T> {
        let ((a, b), c) = (self.domain(), self.coeffs());
        let negative = |c: &T| *c < T::zero();
        if !c.iter().any(negative) {
            return None;
        }
        if let Some((_, end)) = [(&c[0], a), (&c[c.len() - 1], b)].into_iter().find(|(c, _)| negative(c)) {
            return Some(end.clone());
        }
        let Roots::At(roots) = self.roots() else { return None };
        // Between two roots the sign stays the same.
        let lower = [a].into_iter().chain(roots.iter().map(|root| root.value.bounds().1));
        let upper = roots.iter().map(|root| root.value.bounds().0).chain([b]);
        let middle = |(l, u): (&T, &T)| l.clone() + (u.clone() - l) * T::frac(1, 2);
        lower.zip(upper).map(middle).find(|x| negative(&self.at(x)))
    }
}

impl<T: Solvable> Root<T> {
    /// The same root of `polynomial` enclosed more closely, in an interval no longer than `width`.
    ///
    /// Bisects, so that the root may turn out to be exact. Over an inexact field it ends where an interval has no middle.
    ///
    /// # Errors
    /// [`Error::BadTolerance`] unless `width` is positive.
    ///
    /// # Examples
    /// ```
    /// use symspline::roots::{Polynomial, Roots};
    /// use symspline::{Q, Scalar};
    /// let p = Polynomial::new(Q::int(0), Q::int(2), [-2, -2, 2].map(Q::int).to_vec())?;
    /// let Roots::At(roots) = p.roots() else { panic!("not zero") };
    /// let root = roots[0].narrowed(&p, &Q::frac(1, 1000))?;
    /// let (low, high) = root.value.bounds();
    /// assert!(low * low < Q::int(2) && Q::int(2) < high * high && high - low <= Q::frac(1, 1000));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn narrowed(&self, polynomial: &Polynomial<T>, width: &T) -> Result<Self> {
        if !width.is_finite() || *width <= T::zero() {
            return Err(Error::BadTolerance { tolerance: width.to_string() });
        }
        let RootValue::Enclosed(start, end) = &self.value else { return Ok(self.clone()) };
        let (mut start, mut end) = (start.clone(), end.clone());
        let crosses = polynomial.sign_at(&start) == polynomial.sign_at(&end).reverse();
        let factor = if crosses && polynomial.sign_at(&start) != Ordering::Equal || !T::EXACT {
            polynomial.clone()
        } else {
            square_free::square_free_parts(&polynomial.without_end_roots()).swap_remove(0)
        };
        let before = factor.sign_at(&start);
        while end.clone() - &start > *width {
            let middle = start.clone() + (end.clone() - &start) * T::frac(1, 2);
            if middle <= start || end <= middle {
                break;
            }
            match factor.sign_at(&middle) {
                Ordering::Equal => return Ok(Self { value: RootValue::Exact(middle), ..*self }),
                sign if sign == before => start = middle,
                _ => end = middle,
            }
        }
        Ok(Self { value: RootValue::Enclosed(start, end), ..*self })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;

    #[test]
    fn negative_places_are_found_between_roots() {
        let polynomial = |c: &[i64]| {
            let c = c.iter().copied().map(Q::int).collect();
            Polynomial::new(Q::int(0), Q::int(1), c).unwrap()
        };
        // (2x - 1)² touches zero; less 1/4 it is negative in the middle; x - 1 and x everywhere but at an end.
        assert_eq!(polynomial(&[1, -1, 1]).negative_at(), None);
        assert_eq!(polynomial(&[3, -5, 3]).negative_at(), Some(Q::frac(1, 2)));
        assert_eq!(polynomial(&[-1, 0]).negative_at(), Some(Q::int(0)));
        assert_eq!(polynomial(&[0, -1]).negative_at(), Some(Q::int(1)));
        assert_eq!(polynomial(&[0, -1, 0]).negative_at(), Some(Q::frac(1, 2)));
        assert_eq!(polynomial(&[0, 0]).negative_at(), None);
    }

    #[test]
    fn a_long_search_for_a_rational_root_ends() {
        // A root with a denominator of 120 bits beside an irrational one.
        let big = Q::frac(1 << 60, (1 << 60) + 1);
        let root = big * Q::frac(1 << 59, (1 << 59) - 55);
        let square = [Q::int(-2), Q::int(-2), Q::int(2)];
        let factor = [-root.clone(), Q::int(2) - &root];
        let product = [
            square[0].clone() * &factor[0],
            (square[0].clone() * &factor[1] + Q::int(2) * &square[1] * &factor[0]) / Q::int(3),
            (square[2].clone() * &factor[0] + Q::int(2) * &square[1] * &factor[1]) / Q::int(3),
            square[2].clone() * &factor[1],
        ];
        let polynomial = Polynomial::new(Q::int(0), Q::int(2), product.to_vec()).unwrap();
        let Roots::At(roots) = polynomial.roots() else { panic!("not zero") };
        assert_eq!(roots[0].value, RootValue::Exact(root));
        assert!(matches!(roots[1].value, RootValue::Enclosed(..)) && roots.len() == 2);
    }
}
