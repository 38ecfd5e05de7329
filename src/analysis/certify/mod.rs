//! Zeros with a proof: of functions of curves, by exact numbers or by floats with error bounds.
//!
//! Over the rationals the function is made exactly, and its pieces are solved (see [`roots`](crate::roots)). Over `f64`
//! it is made over balls first, floats with a bound of their error. Where sign variations of balls decide, they prove
//! as much as exact ones; where they do not, as at multiple zeros and at zeros on knots, the one piece is made again
//! over the rationals, from the exact numbers that the floats are.

pub(crate) mod condition;
mod float;

use crate::analysis::ball::Ball;
use crate::analysis::certify::condition::Condition;
use crate::error::Result;
use crate::exact::Q;
use crate::roots::float::close_roots;
use crate::roots::{Polynomial, RootValue, Roots, Solvable};
use std::cmp::Ordering;

/// What a polynomial does on its interval.
#[derive(Clone, Debug)]
pub struct Course<T> {
    /// The signs right of the start and left of the end; equal only if the polynomial is zero.
    pub(crate) signs: [Ordering; 2],
    /// The multiplicities of the ends as zeros.
    pub(crate) at_ends: [usize; 2],
    /// The zeros inside, ascending, with their multiplicities.
    pub(crate) inside: Vec<(RootValue<T>, usize)>,
}

pub(crate) mod sealed {
    use super::*;

    /// How a field proves what the zeros of functions are.
    pub trait Engine: Solvable {
        /// The number as an exact one.
        ///
        /// # Errors
        /// [`Error::NotFinite`](crate::Error::NotFinite).
        fn exact(&self) -> Result<Q>;

        /// A ball around the number.
        fn ball(&self) -> Ball;

        /// The courses of the pieces of a function.
        ///
        /// # Errors
        /// [`Error::TooLarge`](crate::Error::TooLarge), [`Error::DegreeTooHigh`](crate::Error::DegreeTooHigh).
        fn courses<const N: usize>(condition: &Condition<Self, N>) -> Result<Vec<Course<Self>>>;
    }
}

/// A field over which zeros of functions of curves are found with a proof: `f64` and [`Q`].
///
/// `f64` means the exact numbers that the floats are.
pub trait Certified: Solvable + sealed::Engine {}

impl Certified for Q {}

impl Certified for f64 {}

impl sealed::Engine for Q {
    fn exact(&self) -> Result<Q> {
        Ok(self.clone())
    }

    fn ball(&self) -> Ball {
        Ball::around(self)
    }

    fn courses<const N: usize>(condition: &Condition<Self, N>) -> Result<Vec<Course<Self>>> {
        let function = condition.function()?;
        (0..function.count()).map(|i| Ok(course(&function.polynomial(i)?, close_roots))).collect()
    }
}

/// The course of a polynomial with exact coefficients, whose roots `solve` finds.
fn course<T>(polynomial: &Polynomial<Q>, solve: impl Fn(&Polynomial<Q>) -> Roots<T>) -> Course<T> {
    let c = polynomial.coeffs();
    let sign = |c: &Q| c.cmp(&Q::default());
    let first = c.iter().position(|c| sign(c) != Ordering::Equal);
    let Some((first, Roots::At(roots))) = first.map(|first| (first, solve(polynomial))) else {
        return Course { signs: [Ordering::Equal; 2], at_ends: [c.len(); 2], inside: Vec::new() };
    };
    let last = c.iter().rposition(|c| sign(c) != Ordering::Equal).unwrap_or(first);
    let at_ends = [first, c.len() - 1 - last];
    let inside = roots.into_iter().map(|root| (root.value, root.multiplicity));
    let [start, end] = at_ends.map(|count| usize::from(count > 0));
    let count = inside.len() - end;
    Course {
        signs: [sign(&c[first]), sign(&c[last])],
        at_ends,
        inside: inside.take(count).skip(start).collect(),
    }
}
