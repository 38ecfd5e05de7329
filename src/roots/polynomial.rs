//! One polynomial in Bernstein form.

use crate::bernstein::binomials;
use crate::error::{Error, Result};
use crate::limits::check_degree;
use crate::roots::Solvable;
use crate::scalar::Scalar;
use std::cmp::Ordering;

/// The polynomial `Σ c_k C(n, k) u^k (1 - u)^(n-k)`, `u = (x - a) / (b - a)`, on the interval `[a, b]`.
///
/// # Examples
/// ```
/// use symspline::roots::Polynomial;
/// let square = Polynomial::new(0.0, 2.0, vec![0.0, 0.0, 4.0])?;
/// assert_eq!(square.at(&1.0), 1.0);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Polynomial<T> {
    a: T,
    b: T,
    c: Vec<T>,
}

impl<T: Scalar> Polynomial<T> {
    /// The polynomial with Bernstein coefficients `c` on `[a, b]`.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::EmptyDomain`] unless `a < b`; [`Error::CoefficientCount`] without coefficients;
    /// [`Error::DegreeTooHigh`].
    pub fn new(a: T, b: T, c: Vec<T>) -> Result<Self> {
        check_degree(c.len().saturating_sub(1))?;
        if c.is_empty() {
            return Err(Error::CoefficientCount { expected: 1, found: 0 });
        }
        if let Some(index) = [&a, &b].into_iter().position(|x| !x.is_finite()) {
            return Err(Error::NotFinite { what: "parameter", index });
        }
        if a >= b {
            return Err(Error::EmptyDomain { start: a.to_string(), end: b.to_string() });
        }
        match c.iter().position(|c| !c.is_finite()) {
            Some(index) => Err(Error::NotFinite { what: "coefficient", index }),
            None => Ok(Self { a, b, c }),
        }
    }

    /// Start and end of the interval.
    pub fn domain(&self) -> (&T, &T) {
        (&self.a, &self.b)
    }

    /// The Bernstein coefficients, one more than the degree.
    pub fn coeffs(&self) -> &[T] {
        &self.c
    }

    /// The Bernstein coefficients, moved out.
    pub(crate) fn into_coeffs(self) -> Vec<T> {
        self.c
    }

    /// The polynomial with every coefficient replaced.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub(crate) fn try_map(&self, f: impl Fn(&T) -> T) -> Result<Self> {
        Self::new(self.a.clone(), self.b.clone(), self.c.iter().map(f).collect())
    }

    /// The same interval with other coefficients.
    fn with_coeffs(&self, c: Vec<T>) -> Self {
        Self { a: self.a.clone(), b: self.b.clone(), c }
    }

    /// The value at `x`, which need not lie in the interval.
    pub fn at(&self, x: &T) -> T {
        let width = self.b.clone() - &self.a;
        self.homogeneous((x.clone() - &self.a) / &width, (self.b.clone() - x) / &width)
    }

    /// The sign at `x`: how the value compares with zero.
    pub(crate) fn sign_at(&self, x: &T) -> Ordering {
        let value = match T::EXACT {
            // The sign alone needs no division.
            true => self.homogeneous(x.clone() - &self.a, self.b.clone() - x),
            false => self.at(x),
        };
        value.partial_cmp(&T::zero()).unwrap_or(Ordering::Equal)
    }

    /// `Σ c_k C(n, k) u^k v^(n-k)`.
    fn homogeneous(&self, u: T, v: T) -> T {
        let n = self.c.len() - 1;
        let mut power = T::one();
        let terms = self.c.iter().zip(binomials::<T>(n)).rev();
        let scaled = terms.map(|(c, binomial)| {
            let term = binomial * c * &power;
            power *= &v;
            term
        });
        scaled.fold(T::zero(), |sum, term| sum * &u + term)
    }

    /// The parts left and right of `x`, by the algorithm of de Casteljau.
    ///
    /// # Examples
    /// ```
    /// use symspline::roots::Polynomial;
    /// let (left, right) = Polynomial::new(0.0, 2.0, vec![0.0, 0.0, 4.0])?.split(&1.0)?;
    /// assert_eq!((left.coeffs(), right.coeffs()), (&[0.0, 0.0, 1.0][..], &[1.0, 2.0, 4.0][..]));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::EmptyDomain`] unless `x` is inside the interval.
    pub fn split(&self, x: &T) -> Result<(Self, Self)> {
        if !(self.a < *x && *x < self.b) {
            return Err(Error::EmptyDomain { start: self.a.to_string(), end: self.b.to_string() });
        }
        Ok(self.split_inside(x))
    }

    /// The parts left and right of an `x` that is known to be inside.
    pub(crate) fn split_inside(&self, x: &T) -> (Self, Self) {
        let width = self.b.clone() - &self.a;
        let (u, v) = ((x.clone() - &self.a) / &width, (self.b.clone() - x) / &width);
        let (mut c, n) = (self.c.clone(), self.c.len() - 1);
        let (mut left, mut right) = (Vec::with_capacity(n + 1), Vec::with_capacity(n + 1));
        for last in (0..=n).rev() {
            left.push(c[0].clone());
            right.push(c[last].clone());
            (0..last).for_each(|i| c[i] = c[i].clone() * &v + c[i + 1].clone() * &u);
        }
        right.reverse();
        let part = |a: &T, b: &T, c| Self { a: a.clone(), b: b.clone(), c };
        (part(&self.a, x, left), part(x, &self.b, right))
    }

    /// The polynomial on a part `[start, end]` of its interval.
    pub(crate) fn restricted(&self, start: &T, end: &T) -> Self {
        let right = if *start == self.a { self.clone() } else { self.split_inside(start).1 };
        if *end == right.b { right } else { right.split_inside(end).0 }
    }

    /// The sign changes of the coefficients, zeros left out: as many as there are roots inside the interval or more, by an
    /// even number.
    ///
    /// # Examples
    /// ```
    /// use symspline::roots::Polynomial;
    /// assert_eq!(Polynomial::new(0.0, 1.0, vec![0.0, 1.0, 0.0, -1.0, 2.0])?.variations(), 2);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn variations(&self) -> usize {
        let mut signs = self.c.iter().filter(|c| !c.is_zero()).map(|c| *c > T::zero());
        let Some(mut last) = signs.next() else { return 0 };
        signs.filter(|sign| std::mem::replace(&mut last, *sign) != *sign).count()
    }

    /// The middle of the interval, if the field has one.
    pub(super) fn middle(&self) -> Option<T> {
        let middle = self.a.clone() + (self.b.clone() - &self.a) * T::frac(1, 2);
        (self.a < middle && middle < self.b).then_some(middle)
    }

    /// How often the start and the end are roots, if the polynomial is not zero.
    pub(super) fn end_roots(&self) -> Option<(usize, usize)> {
        let start = self.c.iter().position(|c| !c.is_zero())?;
        Some((start, self.c.iter().rev().take_while(|c| c.is_zero()).count()))
    }

    /// The coefficients `C(n, k) c_k`: those of the powers of `(x - a) / (b - x)`.
    pub(super) fn powers(&self) -> Vec<T> {
        let binomials = binomials::<T>(self.c.len() - 1);
        self.c.iter().zip(binomials).map(|(c, binomial)| binomial * c).collect()
    }

    /// The polynomial on the same interval with these coefficients of the powers of `(x - a) / (b - x)`.
    pub(super) fn with_powers(&self, powers: Vec<T>) -> Self {
        let binomials = binomials::<T>(powers.len() - 1);
        self.with_coeffs(powers.into_iter().zip(binomials).map(|(h, binomial)| h / binomial).collect())
    }

    /// The root, anywhere, if the polynomial is linear.
    pub(super) fn linear_root(&self) -> Option<T> {
        let c = &self.c;
        let straight = |c: &[T]| c[0].clone() + &c[2] == c[1].clone() + &c[1];
        let rise = c[c.len() - 1].clone() - &c[0];
        let linear = !rise.is_zero() && c.windows(3).all(straight);
        linear.then(|| self.a.clone() - (self.b.clone() - &self.a) * &c[0] / rise)
    }
}

impl<T: Solvable> Polynomial<T> {
    /// The polynomial, up to a positive factor, divided by its roots at the ends; it is not zero.
    pub(super) fn without_end_roots(&self) -> Self {
        let (start, end) = self.end_roots().unwrap_or((0, 0));
        if start + end == 0 {
            let mut c = self.c.clone();
            T::tidy(&mut c);
            return self.with_coeffs(c);
        }
        let mut powers = self.powers();
        powers.truncate(self.c.len() - end);
        powers.drain(..start);
        T::tidy(&mut powers);
        self.with_powers(powers)
    }
}
