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
    /// added, or the middle. There are at most a hundred rounds. A clamped start with too few coefficients for `contact` is
    /// refined beforehand.
    ///
    /// Over an exact field tolerance zero adds knots of this spline only: halving would never come to an end. Projections
    /// over `Q` grow with the cube of the number of coefficients; a tolerance that takes thousands takes minutes.
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
        let mut space = self.with_room(start, contact)?;
        let halves = *tolerance > T::zero();
        let mut rounds = 0..ROUNDS;
        loop {
            let spline = self.projection(&space, contact)?;
            let allowance = self.allowance(&spline, HALVINGS);
            let enough = tolerance.clone() - &allowance;
            let difference = self.difference(&spline)?;
            let bounds = difference.piece_bounds(HALVINGS, Some(&larger(enough.clone(), T::zero())))?;
            let worst = bounds.iter().cloned().fold(T::zero(), larger);
            let bound = worst + &allowance;
            if bound <= *tolerance {
                return Ok(Approximation { spline, bound });
            }
            let fails = |bound: &T| bound.clone() + &allowance > *tolerance;
            let breaks: Vec<T> = difference.space().breaks().into_iter().map(|(t, _)| t).collect();
            let failing: Vec<&[T]> = breaks
                .windows(2)
                .zip(&bounds)
                .filter(|(_, bound)| fails(bound))
                .map(|(ends, _)| ends)
                .collect();
            let added = self.wanted(&space, &failing, halves);
            let hopeful = rounds.next().is_some() && (enough > T::zero() || T::EXACT);
            let refined = hopeful.then(|| space.refined(&added));
            let small = |space: &SplineSpace<T>| space.dim() <= MAX_ADAPTED;
            match refined.and_then(Result::ok).filter(small).filter(|_| !added.is_empty()) {
                Some(refined) => space = refined,
                None => return Err(out_of_tolerance(&bound, tolerance)),
            }
        }
    }

    /// The first refinement of `start` with coefficients for all that `contact` keeps, if these are what it lacks.
    fn with_room(&self, start: &SplineSpace<T>, contact: Contact) -> Result<SplineSpace<T>> {
        self.space().check_same_domain(start)?;
        let mut space = start.clone();
        let possible = space.is_clamped() && contact.start.max(contact.end) <= space.degree() + 1;
        while possible && contact.start + contact.end > space.dim() {
            let breaks: Vec<T> = space.breaks().into_iter().map(|(t, _)| t).collect();
            let all: Vec<&[T]> = breaks.windows(2).collect();
            space = space.refined(&self.wanted(&space, &all, true))?;
        }
        Ok(space)
    }

    /// Knots for every span of `space` that holds one of the `failing` intervals, which are in order: those of this
    /// spline, and middles if spans may be halved.
    fn wanted(&self, space: &SplineSpace<T>, failing: &[&[T]], halves: bool) -> Vec<T> {
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
                let at_end = t == start || t == end;
                let own_copies = match here.iter().find(|(s, _)| s == t) {
                    // What does not go round jumps over the seam.
                    Some(_) if at_end && !self.space().is_periodic() => self.degree() + 1,
                    own => own.map_or(0, |(_, m)| *m),
                };
                // The copies for the continuity of this spline.
                let needed =
                    (own_copies + space.degree()).saturating_sub(self.degree()).min(space.degree() + 1);
                let t = if space.is_periodic() && t == end { start } else { t };
                if own_copies > 0 && needed > *n && (space.is_periodic() || !at_end) {
                    rough = true;
                    // The span before may have asked for it, and for a seam the first span.
                    if added.last() != Some(t) && added.first() != Some(t) {
                        added.extend(std::iter::repeat_n(t.clone(), needed - n));
                    }
                }
            }
            if !rough {
                added.extend(split_of(a, b, here, halves));
            }
        }
        added
    }
}

/// Where to split `[a, b]`: at the break inside that is nearest to the middle, or, if it may be halved, at the middle.
fn split_of<T: Scalar>(a: &T, b: &T, breaks: &[(T, usize)], halves: bool) -> Option<T> {
    let middle = a.clone() + (b.clone() - a) / T::int(2);
    let distance = |t: &T| (t.clone() - &middle).magnitude();
    let inside = breaks.iter().map(|(t, _)| t).filter(|t| a < *t && *t < b);
    let nearest = inside.reduce(|s, t| if distance(t) < distance(s) { t } else { s });
    nearest.cloned().or(halves.then_some(middle))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Error;
    use crate::exact::Q;
    use crate::spline::Function;

    #[test]
    fn exact_tolerance_zero_ends() {
        let cube = Function::monomial(3, Q::int(0), Q::int(1)).unwrap();
        let lines = SplineSpace::bezier(1, Q::int(0), Q::int(1)).unwrap();
        let none = cube.approximated_within(&lines, &Q::int(0), Contact::FREE);
        assert!(matches!(none, Err(Error::OutOfTolerance { .. })));
        let kinks = SplineSpace::clamped(1, [0, 1, 2, 3].map(Q::int)).unwrap();
        let kinks = Function::new(kinks, [0, 5, 1, 1].map(Q::int).to_vec()).unwrap();
        let parabolas = SplineSpace::bezier(2, Q::int(0), Q::int(3)).unwrap();
        let same = kinks.approximated_within(&parabolas, &Q::int(0), Contact::FREE).unwrap();
        assert!(same.spline.same_function(&kinks).unwrap() && same.bound == Q::int(0));
    }

    #[test]
    fn contact_finds_room() {
        let cube = Function::monomial(3, 0.0, 1.0).unwrap();
        let tangents = cube.degree_reduced_within(1, &0.1, Contact::both(2)).unwrap();
        assert!(tangents.spline.space().dim() >= 4 && tangents.bound <= 0.1);
        assert!((tangents.spline.derivative_at(&1.0, 1).unwrap() - 3.0).abs() < 1e-12);
        let refused = cube.degree_reduced_within(1, &0.1, Contact::both(4));
        assert_eq!(refused, Err(Error::DegreeTooLow { degree: 2, needed: 3 }));
    }

    #[test]
    fn an_open_spline_jumps_over_the_seam_of_a_ring() {
        let ring = SplineSpace::uniform_periodic(2, 2, 0.0, 1.0).unwrap();
        let unclamped = SplineSpace::new(2, [-2.0, -1.0, 0.0, 1.0, 2.0, 3.0]).unwrap();
        let rise = Function::new(unclamped, vec![0.0, 1.0, 5.0]).unwrap();
        let near = rise.approximated_within(&ring, &1e-3, Contact::FREE).unwrap();
        assert!(near.spline.space().dim() < 8);
    }
}
