//! Knots removed: one knot, as many as a tolerance allows, or one whatever it changes.
//!
//! The bounds that come with the results are sums of bounds of single removals on the spans they change
//! ([`removal`](crate::ops::removal)), and compare with the spline at the start. In `f64` rounding counts as a change, and
//! what was inserted can be removed again only within a tolerance that leaves room for it.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::ops::bound::{Approximation, check_tolerance};
use crate::ops::removal::{Limit, Removal};
use crate::ops::tight::thin_tight;
use crate::ops::trial::Keep;
use crate::ops::zone::Zone;
use crate::scalar::{Scalar, larger};
use crate::spline::Spline;

/// A spline that lost a knot, and where it changed.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Dropped<T, C = T> {
    /// The spline without the knot.
    pub spline: Spline<T, C>,
    /// At least the largest distance from the spline with the knot.
    pub bound: T,
    /// Outside this interval nothing changed. In a ring it may reach beyond the domain, over the seam.
    pub changed: (T, T),
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The spline without up to `times` copies of `knot`: as many as keep the bound at or below `tolerance`.
    ///
    /// How many were removed shows in the space. Over an exact field tolerance zero removes what changes nothing, down to
    /// the smoothness that the spline has there; over inexact ones it removes nothing. The seam of a ring keeps one copy.
    ///
    /// # Errors
    /// [`Error::NotRemovable`] if `knot` is none inside the domain (in a ring the seam counts as inside);
    /// [`Error::BadTolerance`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, Scalar, SplineSpace};
    /// let f = Function::new(SplineSpace::bezier(2, Q::int(0), Q::int(2))?, [1, 5, 3].map(Q::int).to_vec())?;
    /// let back = f.inserted(&[Q::int(1)])?.removed(&Q::int(1), 1, &Q::int(0))?;
    /// assert_eq!((back.spline, back.bound), (f, Q::int(0)));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "knot removal")]
    pub fn removed(&self, knot: &T, times: usize, tolerance: &T) -> Result<Approximation<Self, T>> {
        check_tolerance(tolerance)?;
        let mut removal = Removal::new(self);
        let copies = seek(&mut removal, knot)?;
        let limit = Limit::Within(tolerance.clone());
        let gone = removal.remove(copies, times, &limit, None);
        let tight = removal.is_tight();
        let (spline, bound) = removal.finish()?;
        if tight && gone < times.min(copies) {
            let times = |t: &T, _: usize| if t == knot { times - gone } else { 0 };
            return thin_tight(spline, bound, times, &limit);
        }
        Ok(Approximation { spline, bound })
    }

    /// The spline without the knots that it can do without: each is tried once, and goes if the bound stays at or below
    /// `tolerance`.
    ///
    /// Passes go from left to right and leave a knot after one that went for the next pass: spans grow evenly, which keeps
    /// rounding small. A removal takes a time that depends on the degree only, so the cost is linear in the number of
    /// coefficients, but for walking past them once a pass. Over an exact field tolerance zero gives the smallest space of
    /// this degree that holds the function. With a positive tolerance the result is no smallest one. Coefficients at
    /// clamped ends stay, but in degree 0.
    ///
    /// # Errors
    /// [`Error::BadTolerance`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, Scalar, SplineSpace};
    /// let f = Function::new(SplineSpace::clamped(1, [0, 1, 2].map(Q::int))?, [0, 3, 1].map(Q::int).to_vec())?;
    /// let fine = f.inserted(&[Q::frac(1, 2), Q::frac(3, 2)])?;
    /// assert_eq!(fine.without_spare_knots(&Q::int(0))?.spline, f);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "knot removal")]
    #[doc(alias = "data reduction")]
    pub fn without_spare_knots(&self, tolerance: &T) -> Result<Approximation<Self, T>> {
        check_tolerance(tolerance)?;
        self.thinned(&Limit::Within(tolerance.clone()), |_, copies| copies)
    }

    /// As [`without_spare_knots`](Self::without_spare_knots), but only with knots from `start` to `end`, and with the spline
    /// as it is outside.
    ///
    /// A knot goes if the removal changes the spline by a multiple of a basis function without influence in the domain outside
    /// the interval [NURBS, (11.41)], or, over an exact field, not at all. Outside the interval nothing changes, over inexact
    /// fields but for rounding, which is in the bound. Rings of fewer than `p + 2` coefficients keep their knots.
    ///
    /// # Errors
    /// [`Error::BadTolerance`]; [`Error::OutsideDomain`]; [`Error::EmptyDomain`] unless `start < end`.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, Scalar, SplineSpace};
    /// let space = SplineSpace::clamped(1, (0..6).map(Q::int))?;
    /// let f = Function::new(space, [0, 3, 0, 4, 0, 5].map(Q::int).to_vec())?;
    /// // The knots 2 and 3 go, since the function may change between 1 and 4 alone.
    /// let thin = f.without_spare_knots_on(&Q::int(1), &Q::int(4), &Q::int(9))?;
    /// assert_eq!(thin.spline.coeffs(), [0, 3, 0, 5].map(Q::int));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "knot removal")]
    pub fn without_spare_knots_on(
        &self,
        start: &T,
        end: &T,
        tolerance: &T,
    ) -> Result<Approximation<Self, T>> {
        self.thinned_in(tolerance, (start, end), &|_| T::zero())
    }

    /// The spline without one copy of knot `index`, whatever that changes, and with the change in the narrowest interval.
    ///
    /// One of the equations of the insertion cannot hold. It is the one in the middle, and of two in the middle the one
    /// that leaves the side `keep` alone; the others are solved from both ends. [`removed`](Self::removed) leaves out
    /// the equation with the smallest error instead.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`]; [`Error::NotRemovable`] for a knot at or beyond an end of the domain, or the last copy
    /// of a seam; [`Error::TooFewKnots`] for a ring of fewer than `p + 2` coefficients;
    /// [`Error::NotFinite`] on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Keep, Q, Scalar, SplineSpace};
    /// let f = Function::new(SplineSpace::clamped(2, [0, 1, 2].map(Q::int))?, [0, 0, 4, 4].map(Q::int).to_vec())?;
    /// let dropped = f.without_knot(3, Keep::Left)?;
    /// assert_eq!(dropped.spline.coeffs(), [0, 0, 4].map(Q::int));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn without_knot(&self, index: usize, keep: Keep) -> Result<Dropped<T, C>> {
        let t = self.space().knots();
        let knot = t.get(index).ok_or(Error::IndexOutOfRange { index, length: t.len() })?;
        let mut removal = Removal::new(self);
        if removal.is_tight() {
            return Err(Error::TooFewKnots { expected: self.degree() + 2, found: self.space().dim() });
        }
        let copies = seek(&mut removal, knot)?;
        if copies == 1 && knot == self.domain().0 {
            return Err(Error::NotRemovable { knot: knot.to_string() });
        }
        let mut changed = removal.drop_one(copies, keep);
        if !self.space().is_periodic() {
            let (a, b) = self.domain();
            let end = if *b < changed.1 { b.clone() } else { changed.1 };
            changed = (larger(changed.0, a.clone()), end);
        }
        let (spline, bound) = removal.finish()?;
        Ok(Dropped { spline, bound, changed })
    }

    /// The spline without `times(knot, copies)` copies of every knot inside, as far as `limit` allows.
    pub(crate) fn thinned(
        &self,
        limit: &Limit<T>,
        times: impl Fn(&T, usize) -> usize,
    ) -> Result<Approximation<Self, T>> {
        let removal = self.thinning(limit, &times, None);
        let tight = removal.is_tight();
        let (spline, bound) = removal.finish()?;
        if tight { thin_tight(spline, bound, times, limit) } else { Ok(Approximation { spline, bound }) }
    }

    /// As [`thinned`](Self::thinned), with changes from `start` to `end` alone, of which nothing is `beyond`. Small rings keep
    /// their knots.
    pub(crate) fn thinned_in(
        &self,
        tolerance: &T,
        (start, end): (&T, &T),
        beyond: &dyn Fn(&C) -> T,
    ) -> Result<Approximation<Self, T>> {
        check_tolerance(tolerance)?;
        if start >= end {
            return Err(Error::EmptyDomain { start: start.to_string(), end: end.to_string() });
        }
        self.space().locate(start)?;
        self.space().locate_left(end)?;
        let zone = Zone::of(self.space(), (start, end), beyond);
        let period = self.space().is_periodic().then(|| self.space().length());
        let times = |t: &T, copies: usize| if zone.holds((t, t), period.as_ref()) { copies } else { 0 };
        let (spline, bound) =
            self.thinning(&Limit::Within(tolerance.clone()), times, Some(&zone)).finish()?;
        Ok(Approximation { spline, bound })
    }

    /// The removal behind [`thinned`](Self::thinned).
    fn thinning(
        &self,
        limit: &Limit<T>,
        times: impl Fn(&T, usize) -> usize,
        zone: Option<&Zone<'_, T, C>>,
    ) -> Removal<T, C> {
        let mut removal = Removal::new(self);
        // A knot after one that went waits for the next pass, so that spans grow evenly.
        let mut waiting = true;
        while std::mem::replace(&mut waiting, false) && !removal.is_tight() {
            removal.rewind();
            let mut wait = false;
            while let Some((knot, copies)) = removal.advance().filter(|_| !removal.is_tight()) {
                if removal.tried() {
                    wait = false;
                } else if std::mem::replace(&mut wait, false) {
                    waiting = true;
                } else {
                    wait = removal.remove(copies, times(&knot, copies), limit, zone) > 0;
                }
            }
        }
        removal
    }
}

/// Moves on to `knot`; returns its number of copies.
fn seek<T: Scalar, C: Coeff<T>>(removal: &mut Removal<T, C>, knot: &T) -> Result<usize> {
    let absent = || Error::NotRemovable { knot: knot.to_string() };
    std::iter::from_fn(|| removal.advance())
        .find(|(t, _)| t == knot)
        .map(|(_, copies)| copies)
        .ok_or_else(absent)
}
