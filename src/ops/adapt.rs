//! Approximation to a tolerance: knots where the error asks for them, and nowhere else.
//!
//! Project, bound the error on every span, halve the spans where it is too large, and project again. All failing spans
//! are halved at once, so that the number of rounds is that of the deepest halving.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::limits::MAX_ADAPTED;
use crate::ops::bound::{Approximation, check_tolerance, out_of_tolerance};
use crate::ops::project::Contact;
use crate::scalar::{Scalar, larger};
use crate::space::SplineSpace;
use crate::spline::Spline;

/// How many times bounds on spans halve the pieces of the difference.
const HALVINGS: usize = 3;

/// How many rounds there are at most: halving goes no deeper.
const ROUNDS: usize = 100;

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The [projection](Self::projected) to the first refinement of `start` that is certainly within `tolerance`.
    ///
    /// Each round adds knots in every span where the error bound is above the tolerance. A knot at its ends where this
    /// spline is rougher gets the copies for that; otherwise the knot of this spline inside nearest to the middle is
    /// added, or the middle. There are at most a hundred rounds.
    ///
    /// # Errors
    /// Those of [`projected`](Self::projected); [`BadTolerance`](crate::Error::BadTolerance);
    /// [`OutOfTolerance`](crate::Error::OutOfTolerance) if the tolerance is below what rounding allows, or if it would take more than
    /// [`MAX_ADAPTED`] coefficients or rounds than there are.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Contact, Function, SplineSpace};
    /// let f = Function::monomial(4, 0.0, 1.0)?;
    /// let lines = f.approximated_within(&SplineSpace::bezier(1, 0.0, 1.0)?, &0.01, Contact::both(1))?;
    /// assert!(lines.bound <= 0.01 && lines.spline.space().dim() < 12);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn approximated_within(
        &self,
        start: &SplineSpace<T>,
        tolerance: &T,
        contact: Contact,
    ) -> Result<Approximation<Self, T>> {
        check_tolerance(tolerance)?;
        let mut space = start.clone();
        let mut rounds = 0..ROUNDS;
        loop {
            let spline = self.projection(&space, contact)?;
            let allowance = self.allowance(&spline, HALVINGS);
            let enough = tolerance.clone() - &allowance;
            let difference = self.difference(&spline)?;
            let bounds = difference.piece_bounds(HALVINGS, Some(&larger(enough.clone(), T::zero())))?;
            let worst = bounds.iter().cloned().fold(T::zero(), larger);
            let bound = worst.clone() + allowance;
            if bound <= *tolerance {
                return Ok(Approximation { spline, bound });
            }
            let fails = |bound: &T| *bound > enough;
            let breaks: Vec<T> = difference.space().breaks().into_iter().map(|(t, _)| t).collect();
            let failing: Vec<&[T]> = breaks
                .windows(2)
                .zip(&bounds)
                .filter(|(_, bound)| fails(bound))
                .map(|(ends, _)| ends)
                .collect();
            let added = self.wanted(&space, &failing);
            let hopeful = rounds.next().is_some() && (enough > T::zero() || T::EXACT);
            let refined = hopeful.then(|| space.refined(&added));
            let small = |space: &SplineSpace<T>| space.dim() <= MAX_ADAPTED;
            match refined.and_then(Result::ok).filter(small).filter(|_| !added.is_empty()) {
                Some(refined) => space = refined,
                None => return Err(out_of_tolerance(&bound, tolerance)),
            }
        }
    }

    /// Knots for every span of `space` that holds one of the `failing` intervals, which are in order.
    fn wanted(&self, space: &SplineSpace<T>, failing: &[&[T]]) -> Vec<T> {
        let all = self.space().breaks();
        let (mut failing, mut own) = (failing.iter().peekable(), all.as_slice());
        let (start, end) = space.domain();
        let mut added: Vec<T> = Vec::new();
        for ends in space.breaks().windows(2) {
            let (a, b) = (&ends[0].0, &ends[1].0);
            let mut fails = false;
            while failing.next_if(|interval| interval[0] < *b).is_some() {
                fails = true;
            }
            own = &own[own.partition_point(|(t, _)| t < a)..];
            let here = &own[..own.partition_point(|(t, _)| t <= b)];
            if !fails {
                continue;
            }
            let mut rough = false;
            for (t, n) in ends {
                let own_copies = here.iter().find(|(s, _)| s == t).map_or(0, |(_, m)| *m);
                // The copies for the continuity of this spline.
                let needed =
                    (own_copies + space.degree()).saturating_sub(self.degree()).min(space.degree() + 1);
                let t = if space.is_periodic() && t == end { start } else { t };
                if own_copies > 0 && needed > *n && (space.is_periodic() || (t != start && t != end)) {
                    rough = true;
                    // The span before may have asked for it, and for a seam the first span.
                    if added.last() != Some(t) && added.first() != Some(t) {
                        added.extend(std::iter::repeat_n(t.clone(), needed - n));
                    }
                }
            }
            if !rough {
                added.push(split_of(a, b, here));
            }
        }
        added
    }
}

/// Where to split `[a, b]`: at the break inside that is nearest to the middle, or at the middle.
fn split_of<T: Scalar>(a: &T, b: &T, breaks: &[(T, usize)]) -> T {
    let middle = a.clone() + (b.clone() - a) / T::int(2);
    let distance = |t: &T| (t.clone() - &middle).magnitude();
    let inside = breaks.iter().map(|(t, _)| t).filter(|t| a < *t && *t < b);
    let nearest = inside.reduce(|s, t| if distance(t) < distance(s) { t } else { s });
    nearest.cloned().unwrap_or(middle)
}
