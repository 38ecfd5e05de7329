//! Lower degrees: undoing elevation, and the best approximation of a lower degree.
//!
//! A spline of degree `q = p - r` that was elevated by `r` has `r` copies more of every knot. On its pieces the degree is
//! lowered one by one ([unblending](crate::ops::unblend) the equations of degree elevation, from both ends to the middle),
//! and the [recomposition](SplineSpace::recomposition) makes the coefficients of the reduced space, each from the piece
//! that amplifies rounding least. Nothing is solved globally, and the cost is linear in the number of spans.
//!
//! What was no elevated spline is approximated in the sense of least squares, [projected](Spline::projected) to a space
//! whose knots the caller chooses ([`Continuity`]), or with knots put where the error asks for them.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::ops::bound::{Approximation, check_tolerance};
use crate::ops::project::Contact;
use crate::ops::removal::Limit;
use crate::ops::unblend::lower_degree;
use crate::parts::Parts;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;

/// How smooth splines of a reduced degree are at the knots they take over.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Continuity {
    /// As many continuous derivatives as before: `m` copies become `m - r`, and knots of at most `r` copies vanish.
    Kept,
    /// The same, but no knot vanishes: `m` copies become `m - r`, at least one.
    Breaks,
    /// No knot vanishes, and at most so many derivatives are continuous: with degree `q` at least `q - n` copies.
    AtMost(usize),
}

impl Continuity {
    /// How many copies a knot of `copies` has after a reduction by `by` to degree `q`.
    fn copies(self, copies: usize, by: usize, q: usize) -> usize {
        let kept = copies.saturating_sub(by);
        match self {
            Self::Kept => kept,
            Self::Breaks => kept.max(1),
            Self::AtMost(smooth) => kept.max(q.saturating_sub(smooth)).max(1),
        }
    }
}

impl<T: Scalar> SplineSpace<T> {
    /// The space whose [elevation](Self::elevated) by `by` holds the splines of this one that are of degree `p - by`: every
    /// distinct knot loses `by` copies, and those of at most `by` copies vanish.
    ///
    /// A clamped space stays clamped. The seam of a ring keeps at least one copy, the ends of the domain too. Outer knots
    /// of an unclamped end that are then missing become copies of the outermost one left, so that of unclamped spaces
    /// elevation is undone up to outer knots.
    ///
    /// # Errors
    /// [`Error::DegreeTooLow`] if `by` is greater than the degree.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let space = SplineSpace::clamped(3, [0.0, 1.0, 2.0, 2.0, 3.0])?;
    /// assert_eq!(space.reduced(1)?, SplineSpace::clamped(2, [0.0, 2.0, 3.0])?);
    /// assert_eq!(space.elevated(2)?.reduced(2)?, space);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn reduced(&self, by: usize) -> Result<Self> {
        self.reduced_with(by, Continuity::Kept)
    }

    /// As [`reduced`](Self::reduced), with a choice of the smoothness at the knots.
    ///
    /// # Errors
    /// As [`reduced`](Self::reduced); [`Error::TooLarge`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Continuity, SplineSpace};
    /// let cubics = SplineSpace::clamped(3, [0.0, 1.0, 2.0])?;
    /// assert_eq!(cubics.reduced_with(1, Continuity::Breaks)?, SplineSpace::clamped(2, [0.0, 1.0, 2.0])?);
    /// assert_eq!(cubics.reduced_with(1, Continuity::AtMost(0))?, SplineSpace::clamped(2, [0.0, 1.0, 1.0, 2.0])?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn reduced_with(&self, by: usize, continuity: Continuity) -> Result<Self> {
        let p = self.degree();
        let q = p.checked_sub(by).ok_or(Error::DegreeTooLow { degree: p, needed: by })?;
        let copies = |knots: Vec<(T, usize)>| -> Vec<(T, usize)> {
            let left = knots.into_iter().map(|(t, m)| (t, continuity.copies(m, by, q)));
            left.filter(|(_, m)| *m > 0).collect()
        };
        if self.is_periodic() {
            let mut round = self.round();
            round[0].1 = round[0].1.max(by + 1);
            return Self::from_round(q, &copies(round), self.domain().1);
        }
        let Parts { left, inner, right } = self.parts();
        let mut outer: Vec<T> = left;
        outer.reverse();
        let (left, right) = (reduced_end(&outer, by, q), reduced_end(&right, by, q));
        Self::from_parts(q, Parts { left: left.into_iter().rev().collect(), inner: copies(inner), right })
    }
}

/// The `q + 1` knots from an end of the domain outwards, of knots that lose `by` copies each.
fn reduced_end<T: Scalar>(knots: &[T], by: usize, q: usize) -> Vec<T> {
    let end = std::iter::once(knots[0].clone());
    let outer = knots.chunk_by(T::eq).enumerate().flat_map(|(i, copies)| {
        let left = copies.len().saturating_sub(if i == 0 { by + 1 } else { by });
        std::iter::repeat_n(copies[0].clone(), left)
    });
    let mut reduced: Vec<T> = end.chain(outer).take(q + 1).collect();
    let last = reduced[reduced.len() - 1].clone();
    reduced.resize(q + 1, last);
    reduced
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The same function in the [reduced](SplineSpace::reduced) space, if it is there: [elevation](Spline::elevated)
    /// undone.
    ///
    /// Over `f64` rounding usually makes this fail where it would succeed exactly; use
    /// [`degree_lowered`](Self::degree_lowered), which is as accurate as the coefficients allow, and its bound.
    ///
    /// # Errors
    /// [`Error::NotReducible`] if the spline is not of that degree; [`Error::DegreeTooLow`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, Function, Q, Scalar};
    /// let line = Function::monomial(1, Q::int(0), Q::int(2))?;
    /// assert_eq!(line.elevated(3)?.degree_reduced_exactly(3)?, line);
    /// let cube = Function::monomial(3, Q::int(0), Q::int(2))?;
    /// assert_eq!(cube.degree_reduced_exactly(1).unwrap_err(), Error::NotReducible { degree: 2 });
    /// # Ok::<(), Error>(())
    /// ```
    #[doc(alias = "degree reduction")]
    pub fn degree_reduced_exactly(&self, by: usize) -> Result<Self> {
        let lowered = self.lowered(by)?;
        if self.same_function(&lowered)? {
            return Ok(lowered);
        }
        Err(Error::NotReducible { degree: lowered.degree() })
    }

    /// The spline of the [reduced](SplineSpace::reduced) space that is this one wherever that is possible, found locally.
    ///
    /// A projection: splines of the lower degree come back, exactly over an exact field and else up to rounding. Others
    /// are approximated, not in any best way; [`degree_reduced`](Self::degree_reduced) does that.
    ///
    /// # Errors
    /// [`Error::DegreeTooLow`] if `by` is greater than the degree; [`Error::NotFinite`] on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let f = Function::new(SplineSpace::clamped(2, [0.0, 1.0, 3.0])?, vec![0.0, 2.0, 1.0, 5.0])?;
    /// let back = f.elevated(2)?.degree_lowered(2)?;
    /// assert_eq!(back.spline.space(), f.space());
    /// assert!(back.bound < 1e-12);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "degree reduction")]
    pub fn degree_lowered(&self, by: usize) -> Result<Approximation<Self, T>> {
        let spline = self.lowered(by)?;
        let bound = self.distance_bound(&spline)?;
        Ok(Approximation { spline, bound })
    }

    fn lowered(&self, by: usize) -> Result<Self> {
        let target = self.space().reduced(by)?;
        if by == 0 {
            return Ok(self.clone());
        }
        let vanishing = |(_, copies): &(T, usize)| *copies <= by;
        let p = self.degree();
        let thinned = self.space().breaks().iter().any(vanishing).then(|| {
            // Only knots that do not show in a spline of the lower degree.
            self.thinned(&Limit::Forced, |_, copies| if copies <= by { copies } else { 0 })
        });
        let thinned = thinned.transpose()?.map(|thinned| thinned.spline);
        let f = thinned.as_ref().unwrap_or(self);
        let pieces = f.bernstein(&f.space().ends())?;
        let mut lowered = Vec::with_capacity(pieces.len() / (p + 1) * (p + 1 - by));
        for piece in pieces.chunks(p + 1) {
            let mut piece = piece.to_vec();
            (0..by).for_each(|_| lower_degree(&mut piece));
            lowered.extend(piece);
        }
        let coeffs = target.recomposed(&target.ends(), &lowered, &[]);
        Spline::new(target, coeffs)
    }

    /// The spline of degree `p - by` with the least `∫ |f - g|²`, with the chosen [`Continuity`] at the knots and
    /// [`Contact`] at the ends.
    ///
    /// # Errors
    /// [`Error::DegreeTooLow`] if `by` is greater than the degree; those of [`projected`](Self::projected).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Contact, Continuity, Function, SplineSpace};
    /// let f = Function::new(SplineSpace::clamped(3, [0.0, 1.0, 2.0])?, vec![0.0, 1.0, 1.5, 1.0, 0.0])?;
    /// let parabolas = f.degree_reduced(1, Continuity::Breaks, Contact::both(1))?;
    /// assert_eq!(parabolas.spline.degree(), 2);
    /// assert_eq!(parabolas.spline.at(&0.0)?, 0.0);
    /// assert!(parabolas.bound < 0.15);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "degree reduction")]
    #[doc(alias = "least squares")]
    pub fn degree_reduced(
        &self,
        by: usize,
        continuity: Continuity,
        contact: Contact,
    ) -> Result<Approximation<Self, T>> {
        self.projected(&self.space().reduced_with(by, continuity)?, contact)
    }

    /// A spline of degree `p - by` within `tolerance`, with knots only where the error asks for them.
    ///
    /// Starts in the [reduced](SplineSpace::reduced) space and goes on as
    /// [`approximated_within`](Self::approximated_within).
    ///
    /// # Errors
    /// [`Error::DegreeTooLow`] if `by` is greater than the degree; those of
    /// [`approximated_within`](Self::approximated_within).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Contact, Function};
    /// let near = Function::monomial(3, 0.0, 1.0)?.degree_reduced_within(1, &1e-3, Contact::both(1))?;
    /// assert_eq!(near.spline.degree(), 2);
    /// assert!(near.bound <= 1e-3);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn degree_reduced_within(
        &self,
        by: usize,
        tolerance: &T,
        contact: Contact,
    ) -> Result<Approximation<Self, T>> {
        check_tolerance(tolerance)?;
        self.approximated_within(&self.space().reduced(by)?, tolerance, contact)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outer_knots_lose_copies_and_missing_ones_repeat_the_outermost() {
        let double = SplineSpace::new(2, [-1.0, -1.0, 0.0, 1.0, 2.0, 2.0]).unwrap();
        assert_eq!(double.reduced(1).unwrap(), SplineSpace::new(1, [-1.0, 0.0, 1.0, 2.0]).unwrap());
        let simple = SplineSpace::new(2, [-2.0, -1.0, 0.0, 1.0, 2.0, 3.0]).unwrap();
        assert_eq!(simple.reduced(1).unwrap(), SplineSpace::bezier(1, 0.0, 1.0).unwrap());
    }
}
