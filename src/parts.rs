//! Spaces taken apart and put together again: how one space is made from another.

use crate::error::Result;
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
        let inner = t[self.degree() + 1..first_copy_of_end].chunk_by(T::eq);
        Parts {
            left: t[..=self.degree()].to_vec(),
            inner: inner.map(|copies| (copies[0].clone(), copies.len())).collect(),
            right: t[first_copy_of_end..=first_copy_of_end + self.degree()].to_vec(),
        }
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

    /// The open space of `degree` with these parts.
    pub(crate) fn from_parts(degree: usize, parts: Parts<T>) -> Result<Self> {
        let Parts { left, inner, right } = parts;
        check_dim(inner.iter().map(|(_, count)| count).sum())?;
        let copies = inner.into_iter().flat_map(|(t, count)| std::iter::repeat_n(t, count));
        Self::new(degree, left.into_iter().chain(copies).chain(right))
    }

    /// The distinct knots of a period with their multiplicities, the seam at the start only.
    pub(crate) fn round(&self) -> Vec<(T, usize)> {
        let copies = self.round_knots().chunk_by(T::eq);
        copies.map(|copies| (copies[0].clone(), copies.len())).collect()
    }

    /// The periodic space of `degree` with these distinct knots and multiplicities, whose seam comes again at `end`.
    pub(crate) fn from_round(degree: usize, round: &[(T, usize)], end: &T) -> Result<Self> {
        check_dim(round.iter().map(|(_, count)| count).sum())?;
        let copies = round.iter().flat_map(|(t, count)| std::iter::repeat_n(t.clone(), *count));
        Self::joined(degree, &KnotVector::new(copies)?, end.clone())
    }
}
