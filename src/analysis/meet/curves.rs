//! Where two curves of the plane meet.

use crate::analysis::meet::arc::{Arc, PlaneCurve, arcs, extent, scaled, shifted, unit_exponent};
use crate::analysis::meet::casteljau::value_and_slope;
use crate::analysis::meet::frame::{cross, norm};
use crate::analysis::meet::merge::{Axis, Place, groups, hull};
use crate::analysis::meet::pairs::pairs;
use crate::analysis::meet::report::{Certainty, Intersections, Meeting, Overlap, Passage};
use crate::analysis::meet::solve::{Budget, solve};
use crate::analysis::meet::stretch::{Stretch, joined, stretches};
use crate::analysis::meet::system::{Difference, Pair, Problem, rounding};
use crate::error::{Error, Result};
use crate::rational::spline::NurbsCurve;
use crate::spline::Curve;
use nalgebra::vector;

/// Tangents whose cross product is below this part of their lengths are not told apart.
const PARALLEL: f64 = 1e-6;

/// Nearer to an end of a piece than this, a place counts as the end.
const EDGE: f64 = 1e-9;

impl Curve<f64, 2> {
    /// Where the curve meets another one, polynomial or rational.
    ///
    /// Simple meetings are proved to exist and to be the only ones in their ranges of parameters; they are exact up to
    /// rounding, whatever the tolerance. The `tolerance` is a length: what cannot be decided down to boxes of that
    /// size, or down to rounding, is reported as [`Contact`](Certainty::Contact), such as places where the curves
    /// touch. Stretches that coincide up to rounding, and perhaps others along which the curves stay within the
    /// tolerance, are reported as overlaps. Nothing is reported twice: a meeting at a knot, at the seam of a periodic
    /// curve, or where a closed curve starts and ends, is one.
    ///
    /// In `f64` bounds count rounding errors of a few units of the size of the pieces. A curve that jumps has no points
    /// in between.
    ///
    /// # Errors
    /// [`Error::BadTolerance`] unless `tolerance` is positive and finite; [`Error::TooLarge`] if the curves come near
    /// each other in too many places; [`Error::Undecided`] if weights cannot be made positive by halving;
    /// [`Error::NotFinite`] if a control point is not.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Certainty, Curve, SplineSpace, circle};
    /// let parabola = vec![vector![-1.0, 1.0], vector![0.0, -1.0], vector![1.0, 1.0]]; // y = x²
    /// let parabola = Curve::new(SplineSpace::bezier(2, -1.0, 1.0)?, parabola)?;
    /// let circle = circle(&vector![0.0, 1.0], &1.0)?; // x² + (y - 1)² = 1
    /// let found = parabola.intersections(&circle, &1e-9)?;
    /// // They touch at the origin and cross at (±1, 1), where the parabola ends.
    /// let certainties: Vec<_> = found.meetings.iter().map(|m| m.certainty).collect();
    /// assert_eq!(certainties, [Certainty::Proved, Certainty::Contact, Certainty::Proved]);
    /// assert!((found.meetings[2].point - vector![1.0, 1.0]).norm() < 1e-15);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn intersections(&self, other: &impl PlaneCurve, tolerance: &f64) -> Result<Intersections> {
        intersections(self, other, *tolerance)
    }
}

impl NurbsCurve<f64, 2> {
    /// Where the curve meets another one, as [`Curve::intersections`].
    ///
    /// # Errors
    /// As [`Curve::intersections`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::circle;
    /// let [one, other] = [0.0, 1.0].map(|x| circle(&vector![x, 0.0], &1.0));
    /// let found = one?.intersections(&other?, &1e-9)?;
    /// assert!(found.is_proved() && found.meetings.len() == 2);
    /// assert!((found.meetings[0].point - vector![0.5, 0.75_f64.sqrt()]).norm() < 1e-15);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn intersections(&self, other: &impl PlaneCurve, tolerance: &f64) -> Result<Intersections> {
        intersections(self, other, *tolerance)
    }
}

/// Refuses tolerances that are not positive.
pub(crate) fn check(tolerance: f64) -> Result<()> {
    if tolerance.is_finite() && tolerance > 0.0 {
        return Ok(());
    }
    Err(Error::BadTolerance { tolerance: tolerance.to_string() })
}

fn intersections(first: &impl PlaneCurve, second: &impl PlaneCurve, tolerance: f64) -> Result<Intersections> {
    check(tolerance)?;
    let pieces = [arcs(first)?, arcs(second)?];
    let exponent = unit_exponent(extent(&pieces[0]).max(extent(&pieces[1])));
    let curves = Curves::new(pieces.map(|arcs| scaled(arcs, exponent)), exponent);
    let tolerance = shifted(tolerance, exponent);
    curves.intersections(if tolerance.is_finite() { tolerance } else { f64::MAX })
}

/// A place that two pieces found.
struct Found {
    arcs: [usize; 2],
    /// In the unit square of the pieces.
    x: Pair,
    place: Place,
    proved: bool,
}

/// The pieces of two curves of unit size.
struct Curves {
    arcs: [Vec<Arc>; 2],
    axes: [Axis; 2],
    exponent: i32,
}

impl Curves {
    fn new(arcs: [Vec<Arc>; 2], exponent: i32) -> Self {
        let axis = |arcs: &Vec<Arc>| {
            let (a, b) = (&arcs[0], &arcs[arcs.len() - 1]);
            let closed = distance(a.start(), b.end()) <= 16.0 * f64::EPSILON;
            Axis { domain: [a.sides[0], b.sides[1]], closed }
        };
        let axes = [axis(&arcs[0]), axis(&arcs[1])];
        Self { arcs, axes, exponent }
    }

    fn problem(&self, [i, j]: [usize; 2]) -> Problem<Difference> {
        let (p, q) = (&self.arcs[0][i], &self.arcs[1][j]);
        let ([v, v1], [w, w1]) = (p.weights(), q.weights());
        let degrees = [p.coeffs.len() - 1, q.coeffs.len() - 1];
        Problem {
            noise: rounding(degrees, p.size() * w1 + q.size() * v1),
            speeds: [p.speed(), q.speed()],
            weight: v * w,
            system: Difference { pieces: [p.coeffs.clone(), q.coeffs.clone()] },
        }
    }

    /// The parameters at a point of the unit square of two pieces.
    fn parameters(&self, arcs: [usize; 2], x: Pair) -> Pair {
        std::array::from_fn(|k| self.arcs[k][arcs[k]].parameter(x[k]))
    }

    fn intersections(&self, tolerance: f64) -> Result<Intersections> {
        let corners = self.arcs.each_ref().map(|arcs| arcs.iter().map(|arc| arc.corners).collect::<Vec<_>>());
        let mut budget = Budget::new();
        let (mut found, mut parts) = (Vec::new(), Vec::new());
        for arcs in pairs(&corners[0], &corners[1], 16.0 * f64::EPSILON, &mut budget)? {
            let findings = solve(&self.problem(arcs), tolerance, &mut budget)?;
            let place = |low: Pair, high: Pair| {
                let (low, high) = (self.parameters(arcs, low), self.parameters(arcs, high));
                [0, 1].map(|k| [low[k], high[k]])
            };
            for root in &findings.roots {
                let [low, high] = [-1.0, 1.0].map(|s| [0, 1].map(|k| root.x[k] + s * root.radius[k]));
                let x = root.x.map(|x| x.clamp(0.0, 1.0));
                found.push(Found { arcs, x, place: place(low, high), proved: true });
            }
            for [u, v] in &findings.left {
                let x = [0.5 * (u[0] + u[1]), 0.5 * (v[0] + v[1])];
                found.push(Found { arcs, x, place: place([u[0], v[0]], [u[1], v[1]]), proved: false });
            }
            for trace in &findings.traces {
                parts.extend(stretches(trace, &self.axes, |x| self.parameters(arcs, x)));
            }
        }
        let overlaps = joined(parts.clone(), &self.axes);
        found.retain(|f| !parts.iter().any(|part| part.ends_at(&f.place, &self.axes)));
        let places: Vec<Place> = found.iter().map(|f| f.place).collect();
        let mut meetings: Vec<Meeting> = groups(&places, &self.axes)
            .iter()
            .map(|group| self.meeting(&group.iter().map(|&i| &found[i]).collect::<Vec<_>>()))
            .collect();
        let place = |m: &Meeting| m.parameters;
        meetings
            .sort_by(|a, b| place(a)[0].total_cmp(&place(b)[0]).then(place(a)[1].total_cmp(&place(b)[1])));
        let overlap =
            |part: Stretch| Overlap { first: (part.from[0], part.to[0]), second: (part.from[1], part.to[1]) };
        Ok(Intersections { meetings, overlaps: overlaps.into_iter().map(overlap).collect() })
    }

    /// What the places of one group are.
    fn meeting(&self, group: &[&Found]) -> Meeting {
        let places: Vec<Place> = group.iter().map(|f| f.place).collect();
        let ranges = hull(&places, &self.axes);
        let proved = group.iter().all(|f| f.proved);
        let (arcs, x) = self.best(group, &ranges);
        let parameters = self.parameters(arcs, x);
        let parameters = [0, 1].map(|k| self.axes[k].inside(parameters[k]));
        let [c, _] = value_and_slope(&mut self.arcs[0][arcs[0]].coeffs.clone(), x[0]);
        Meeting {
            parameters,
            ranges: ranges.map(|[from, to]| (from, to)),
            point: vector![c[0] / c[2], c[1] / c[2]].map(|x| shifted(x, -self.exponent)),
            certainty: if proved { Certainty::Proved } else { Certainty::Contact },
            passage: if proved { self.passage(arcs, x, group) } else { Passage::Unknown },
        }
    }

    /// A place to stand for a group: a proved solution, else the middle of the ranges, unless the curves are much
    /// nearer to each other elsewhere.
    fn best(&self, group: &[&Found], ranges: &Place) -> ([usize; 2], Pair) {
        if let Some(f) = group.iter().find(|f| f.proved) {
            return (f.arcs, f.x);
        }
        let middle = [0, 1].map(|k| self.piece(k, self.axes[k].inside(0.5 * (ranges[k][0] + ranges[k][1]))));
        let middle = (middle.map(|(arc, _)| arc), middle.map(|(_, x)| x));
        let gap = |(arcs, x): &([usize; 2], Pair)| {
            let [p, q] = [0, 1].map(|k| {
                let [c, _] = value_and_slope(&mut self.arcs[k][arcs[k]].coeffs.clone(), x[k]);
                [c[0] / c[2], c[1] / c[2]]
            });
            distance(p, q)
        };
        let others = group.iter().step_by(group.len().div_ceil(16)).map(|f| (f.arcs, f.x));
        let nearest = others.min_by(|a, b| gap(a).total_cmp(&gap(b))).expect("a group has a member");
        if gap(&middle) <= 2.0 * gap(&nearest) + 16.0 * f64::EPSILON { middle } else { nearest }
    }

    /// The piece of a curve that holds a parameter, and where in it.
    fn piece(&self, curve: usize, x: f64) -> (usize, f64) {
        let arcs = &self.arcs[curve];
        let arc = arcs.partition_point(|arc| arc.sides[1] < x).min(arcs.len() - 1);
        let [a, b] = arcs[arc].sides;
        (arc, ((x - a) / (b - a)).clamp(0.0, 1.0))
    }

    /// How the curves pass each other at a proved meeting, by the directions in which they come and go.
    fn passage(&self, arcs: [usize; 2], x: Pair, group: &[&Found]) -> Passage {
        let inside = |k: usize| x[k] > EDGE && x[k] < 1.0 - EDGE;
        if group.len() == 1 && inside(0) && inside(1) {
            return Passage::Crosses;
        }
        let [Some([p, q]), Some([r, s])] = [0, 1].map(|k| self.directions(k, arcs[k], x[k])) else {
            return Passage::Ends;
        };
        passage([p, q], [r, s])
    }

    /// The directions from a point of a curve, backwards and forwards, if it goes on both ways.
    fn directions(&self, curve: usize, arc: usize, x: f64) -> Option<[Pair; 2]> {
        let arcs = &self.arcs[curve];
        let direction = |arc: usize, x: f64| {
            let [c, d] = value_and_slope(&mut arcs[arc].coeffs.clone(), x);
            [d[0] * c[2] - c[0] * d[2], d[1] * c[2] - c[1] * d[2]]
        };
        let next = |arc: usize, forwards: bool| match (forwards, self.axes[curve].closed) {
            (true, closed) if arc + 1 == arcs.len() => closed.then_some(0),
            (false, closed) if arc == 0 => closed.then_some(arcs.len() - 1),
            (true, _) => Some(arc + 1),
            (false, _) => Some(arc - 1),
        };
        let near = |a: Pair, b: Pair| distance(a, b) <= 64.0 * f64::EPSILON;
        let (before, after) = if x <= EDGE {
            let before = next(arc, false).filter(|&i| near(arcs[i].end(), arcs[arc].start()))?;
            ((before, 1.0), (arc, 0.0))
        } else if x >= 1.0 - EDGE {
            let after = next(arc, true).filter(|&i| near(arcs[i].start(), arcs[arc].end()))?;
            ((arc, 1.0), (after, 0.0))
        } else {
            ((arc, x), (arc, x))
        };
        Some([direction(before.0, before.1).map(|x| -x), direction(after.0, after.1)])
    }
}

/// Whether the rays of one curve lie on both sides of the other.
fn passage([p, q]: [Pair; 2], [r, s]: [Pair; 2]) -> Passage {
    let rays = [p, q, r, s];
    let pairs = [(0, 2), (0, 3), (1, 2), (1, 3)];
    let parallel = |(i, j): &(usize, usize)| {
        let (a, b) = (rays[*i], rays[*j]);
        // Opposite rays tell sides as well as others; equal ones do not.
        let along = a[0] * b[0] + a[1] * b[1] > 0.0;
        norm(a) * norm(b) == 0.0 || along && cross(a, b).abs() <= PARALLEL * norm(a) * norm(b)
    };
    if pairs.iter().any(parallel) {
        return Passage::Unknown;
    }
    let angle = |a: Pair| a[1].atan2(a[0]);
    let turn = |a: Pair| (angle(a) - angle(p)).rem_euclid(std::f64::consts::TAU);
    let (end, [one, other]) = (turn(q), [turn(r), turn(s)]);
    if (one < end) == (other < end) { Passage::Touches } else { Passage::Crosses }
}

fn distance(a: Pair, b: Pair) -> f64 {
    (a[0] - b[0]).abs().max((a[1] - b[1]).abs())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::SplineSpace;

    #[test]
    fn a_curve_that_closes_up_to_rounding_is_met_once_at_its_seam() {
        let polygon = |points: &[[f64; 2]]| {
            let knots = (0..points.len()).map(|i| i as f64);
            let points = points.iter().copied().map(Into::into).collect();
            Curve::new(SplineSpace::clamped(1, knots).unwrap(), points).unwrap()
        };
        // 0.1 + 0.2 is above 0.3.
        let triangle = polygon(&[[0.1 + 0.2, 0.0], [1.0, 1.0], [-1.0, 1.0], [0.3, 0.0]]);
        let line = polygon(&[[-0.7, 0.0], [1.3, 0.0]]);
        let found = triangle.intersections(&line, &1e-9).unwrap();
        assert_eq!((found.meetings.len(), found.meetings[0].passage), (1, Passage::Touches), "{found:?}");
    }
}
