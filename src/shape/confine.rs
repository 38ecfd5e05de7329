//! Pulls confined to an interval: enough knots that one control point has influence only there.

use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::shape::region::Refinement;
use crate::space::SplineSpace;
use crate::tensor::along::Direction;
use std::cmp::Ordering;

/// The shape with knots along `direction` so that `x` is the node of a control point without influence outside
/// `[start, end]`, or near it, and the place of that control point along the direction [NURBS, section 11.2].
///
/// The ends of the interval become knots, then the middles of the longest spans to both sides of `x`, until there is such a
/// control point with influence at `x`; then the knot that makes `x` its node, where that is not a knot already. No knot is
/// inserted twice.
///
/// # Errors
/// [`Error::OutsideDomain`]; [`Error::EmptyDomain`] unless `start < x < end`; [`Error::DegreeTooLow`] for degree zero;
/// [`Error::SpanOutOfRange`] if floating point has no numbers left between them; those of the insertion.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Curve, Direction, Drag, Q, Scalar, SplineSpace, confined};
/// let points = [[0, 0], [1, 2], [3, 2], [4, 0]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
/// let curve = Curve::new(SplineSpace::bezier(3, Q::int(0), Q::int(1))?, points.to_vec())?;
/// let [start, x, end] = [1, 2, 4].map(|i| Q::frac(i, 5));
/// let (finer, k) = confined(&curve, Direction::U, &x, (&start, &end))?;
/// let pulled = Drag::by_one(&finer, &x, k)?.applied(&finer, &[vector![Q::int(0), Q::int(1)]])?;
/// assert_eq!(pulled.at(&end)?, curve.at(&end)?);
/// assert_eq!(finer.space().node(k)?, x);
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn confined<T: Scalar, S: Controlled<T>>(
    shape: &S,
    direction: Direction,
    x: &T,
    (start, end): (&T, &T),
) -> Result<(S, usize)> {
    let space = shape.space_along(direction);
    if space.degree() == 0 {
        return Err(Error::DegreeTooLow { degree: 0, needed: 1 });
    }
    if !(start < x && x < end) {
        return Err(Error::EmptyDomain { start: start.to_string(), end: end.to_string() });
    }
    let mut search = Search { space: space.clone(), added: Vec::new(), x, start, end };
    let k = search.run()?;
    Ok((shape.inserted_along(direction, &search.added)?, k))
}

/// The search for knots.
struct Search<'a, T> {
    space: SplineSpace<T>,
    added: Vec<T>,
    x: &'a T,
    start: &'a T,
    end: &'a T,
}

impl<T: Scalar> Search<'_, T> {
    /// Adds knots until there is a control point, and gives its place.
    fn run(&mut self) -> Result<usize> {
        self.add(Refinement::Count(0).knots(&self.space, self.start, self.end)?)?;
        let mut left = true;
        loop {
            if let Some(k) = nearest_local(&self.space, self.x, (self.start, self.end))? {
                let k = self.place_node().unwrap_or(k);
                return Ok(self.space.slot(k));
            }
            // To the side with fewer knots, so that the node comes to lie near x.
            let (before, after) = (self.count(self.start, self.x), self.count(self.x, self.end));
            left = if before == after { !left } else { before < after };
            let (from, to) = if left { (self.start, self.x) } else { (self.x, self.end) };
            let mut middle = Refinement::Count(1).knots(&self.space, from, to)?;
            // As the end of the side x is a knot of the refinement, but is not wanted.
            middle.retain(|t| t != self.x);
            self.add(middle)?;
        }
    }

    fn add(&mut self, knots: Vec<T>) -> Result<()> {
        self.space = self.space.refined(&knots)?;
        self.added.extend(knots);
        Ok(())
    }

    /// How many knots are between two values, the ends left out.
    fn count(&self, from: &T, to: &T) -> usize {
        let t = self.space.knots();
        t.partition_point(|k| k < to) - t.partition_point(|k| k <= from)
    }

    /// Adds the knot that makes `x` a node, if that leaves a control point with influence nowhere else.
    fn place_node(&mut self) -> Option<usize> {
        let knot = self.space.node_placing_knot(self.x).ok()??;
        let inside = *self.start < knot && knot < *self.end;
        let finer = if inside { self.space.refined(std::slice::from_ref(&knot)).ok()? } else { return None };
        let k = nearest_local(&finer, self.x, (self.start, self.end)).ok()??;
        self.space = finer;
        self.added.push(knot);
        Some(k)
    }
}

/// The coefficient without influence outside the interval and with influence at `x` whose node is nearest.
fn nearest_local<T: Scalar>(space: &SplineSpace<T>, x: &T, (start, end): (&T, &T)) -> Result<Option<usize>> {
    let basis = space.basis(x)?;
    let local = space.local_coeffs(start, end)?;
    let near = |i: &usize| (space.mean_of_knots(*i) - x).magnitude();
    let active = basis.weights().iter().enumerate().filter(|(_, n)| !n.is_zero());
    let active = active.map(|(i, _)| basis.first() + i).filter(|i| local.contains(i));
    Ok(active.min_by(|i, j| near(i).partial_cmp(&near(j)).unwrap_or(Ordering::Equal)))
}
