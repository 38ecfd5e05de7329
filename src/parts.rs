//! Spaces taken apart and put together again: how one space is made from another.

use crate::error::{Error, Result};
use crate::knots::KnotVector;
use crate::limits::check_dim;
use crate::scalar::Scalar;
use crate::space::SplineSpace;

/// The parts of an open space: what its knots are left of, inside, and right of the domain.
pub(crate) struct Parts<T> {
    /// The `degree + 1` knots that end with the start of the domain.
    pub left: Vec<T>,
    /// The knots strictly inside the domain.
    pub inner: Vec<(T, usize)>,
    /// The `degree + 1` knots that start with the end of the domain.
    pub right: Vec<T>,
}

impl<T: Scalar> SplineSpace<T> {
    /// The parts of an open space; a periodic one is taken as the open space over its unrolled knots.
    pub(crate) fn parts(&self) -> Parts<T> {
        let t = self.knots();
        let first_copy_of_end = self.last_span() + 1;
        Parts {
            left: t[..=self.degree()].to_vec(),
            inner: runs(&t[self.degree() + 1..first_copy_of_end]),
            right: t[first_copy_of_end..=first_copy_of_end + self.degree()].to_vec(),
        }
    }

    /// The distinct knots of the domain, both ends included.
    pub(crate) fn ends(&self) -> Vec<T> {
        let (t, first, last) = (self.knots(), self.degree(), self.unrolled_dim());
        let mut ends = Vec::with_capacity(last - first + 1);
        ends.push(t[first].clone());
        ends.extend(t[first..=last].windows(2).filter(|pair| pair[0] < pair[1]).map(|pair| pair[1].clone()));
        ends
    }

    /// The same space over another field.
    ///
    /// # Errors
    /// The first error of `convert`, and those of [`new`](Self::new) if the converted knots do not serve.
    pub fn map_scalars<U: Scalar>(&self, mut convert: impl FnMut(&T) -> Result<U>) -> Result<SplineSpace<U>> {
        if self.is_periodic() {
            let end = convert(self.domain().1)?;
            let round = self.round_knots().iter().map(&mut convert).collect::<Result<Vec<U>>>()?;
            return SplineSpace::joined(self.degree(), &KnotVector::new(round)?, end);
        }
        SplineSpace::new(self.degree(), self.knots().iter().map(convert).collect::<Result<Vec<U>>>()?)
    }

    /// The periodic space whose `knots` run once round from the seam, `knots[0]`, which comes again at `end`.
    ///
    /// As [`periodic`](Self::periodic) with the end of the domain instead of a period: over `f64` the end is then this number
    /// to the last bit, not a rounded sum. With [`knots_round`](Self::knots_round) it gives any periodic space again.
    ///
    /// # Errors
    /// As [`periodic`](Self::periodic).
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let ring = SplineSpace::periodic(2, [0.1, 1.0, 3.0], 4.2)?;
    /// let round = ring.knots_round().expect("periodic").to_vec();
    /// assert_eq!(SplineSpace::periodic_up_to(2, round, *ring.domain().1)?, ring);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn periodic_up_to(degree: usize, knots: impl IntoIterator<Item = T>, end: T) -> Result<Self> {
        match KnotVector::new(knots)? {
            round if round.is_empty() => Err(Error::TooFewKnots { expected: 1, found: 0 }),
            round => Self::joined(degree, &round, end),
        }
    }

    /// The knots of a periodic space once round, the seam at the start only; none of an open one.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// assert_eq!(SplineSpace::uniform_periodic(3, 4, 0.0, 4.0)?.knots_round(), Some([0.0, 1.0, 2.0, 3.0].as_slice()));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn knots_round(&self) -> Option<&[T]> {
        self.is_periodic().then(|| self.round_knots())
    }

    /// The open space of `degree` with these parts.
    pub(crate) fn from_parts(degree: usize, parts: Parts<T>) -> Result<Self> {
        let Parts { left, inner, right } = parts;
        let count = inner.iter().map(|(_, count)| count).sum();
        check_dim(count)?;
        let mut knots = Vec::with_capacity(left.len() + count + right.len());
        knots.extend(left);
        inner.into_iter().for_each(|(t, count)| knots.extend(std::iter::repeat_n(t, count)));
        knots.extend(right);
        Self::new(degree, knots)
    }

    /// The distinct knots of a period with their multiplicities, the seam at the start only.
    pub(crate) fn round(&self) -> Vec<(T, usize)> {
        runs(self.round_knots())
    }

    /// The periodic space of `degree` with these distinct knots and multiplicities, whose seam comes again at `end`.
    pub(crate) fn from_round(degree: usize, round: &[(T, usize)], end: &T) -> Result<Self> {
        check_dim(round.iter().map(|(_, count)| count).sum())?;
        let copies = round.iter().flat_map(|(t, count)| std::iter::repeat_n(t.clone(), *count));
        Self::joined(degree, &KnotVector::new(copies)?, end.clone())
    }
}

/// The distinct ones of ascending knots with their numbers of copies.
fn runs<T: Scalar>(knots: &[T]) -> Vec<(T, usize)> {
    let mut runs: Vec<(T, usize)> = Vec::with_capacity(knots.len());
    for t in knots {
        match runs.last_mut() {
            Some((last, count)) if last == t => *count += 1,
            _ => runs.push((t.clone(), 1)),
        }
    }
    runs
}
