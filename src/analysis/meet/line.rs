//! Where a line meets a surface.
//!
//! With two normals `n_i` of a line through `A`, the points of the surface on the line are the solutions of the two
//! equations `n_i · (P(u, v) - A w(u, v)) = 0`.

use crate::analysis::meet::arc::{shifted, unit_exponent};
use crate::analysis::meet::curves::check;
use crate::analysis::meet::frame::Coefficients;
use crate::analysis::meet::merge::{Axis, Place, groups, hull};
use crate::analysis::meet::patch::{Piece, Point, axis_of};
use crate::analysis::meet::report::{Certainty, LineMeeting, LineMeetings, LineOverlap};
use crate::analysis::meet::solve::{Budget, solve};
use crate::analysis::meet::stretch::{Stretch, joined, stretches};
use crate::analysis::meet::system::{Grid, Pair, Problem, rounding};
use crate::error::{Error, Result};
use crate::rational::spline::NurbsSurface;
use crate::tensor::spline::Surface;
use crate::vector::{dot, unit, unit_cross};
use nalgebra::{SVector, vector};

impl Surface<f64, 3> {
    /// Where the line `origin + x direction` meets the surface.
    ///
    /// As for [curves](crate::Curve::intersections): simple meetings are proved and exact up to rounding; what cannot
    /// be decided down to boxes in which the surface is smaller than `tolerance`, or down to rounding, is reported as
    /// [`Contact`](Certainty::Contact), such as places where the line is tangent to the surface, or passes a pole of
    /// it. Stretches of the line that lie in the surface are reported as overlaps. Nothing is reported twice.
    ///
    /// # Errors
    /// [`Error::BadTolerance`] unless `tolerance` is positive and finite; [`Error::NotFinite`]; [`Error::NoLength`] if
    /// the direction is zero; [`Error::OutOfTolerance`] if the origin is so far away that its rounding exceeds the size
    /// of the surface; [`Error::TooLarge`] if the line comes near the surface in too many places; [`Error::Undecided`]
    /// if weights cannot be made positive by halving.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Certainty, SplineSpace, Surface};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let corners = vec![vector![0.0, 0.0, 0.0], vector![0.0, 1.0, 0.0], vector![1.0, 0.0, 0.0], vector![1.0, 1.0, 1.0]];
    /// let saddle = Surface::new(line.clone(), line, corners)?; // z = x y
    /// let found = saddle.meet_line(&vector![0.5, 0.25, 9.0], &vector![0.0, 0.0, -2.0], &1e-9)?;
    /// assert_eq!((found.meetings.len(), found.meetings[0].certainty), (1, Certainty::Proved));
    /// assert!((found.meetings[0].point - vector![0.5, 0.25, 0.125]).norm() < 1e-15);
    /// assert!((found.meetings[0].along - 4.4375).abs() < 1e-14);
    /// // The surface is ruled: lines lie in it.
    /// let found = saddle.meet_line(&vector![0.0, 0.5, 0.0], &vector![1.0, 0.0, 0.5], &1e-9)?;
    /// assert!(found.meetings.is_empty());
    /// assert_eq!(found.overlaps[0].along, (0.0, 1.0));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn meet_line(
        &self,
        origin: &SVector<f64, 3>,
        direction: &SVector<f64, 3>,
        tolerance: &f64,
    ) -> Result<LineMeetings> {
        let boxes = self.boxes()?.into_iter().map(|patch| Piece::of(patch, |c| [c[0], c[1], c[2], 1.0]));
        Query::new(boxes.collect(), origin, direction, *tolerance)?.answer()
    }
}

impl NurbsSurface<f64, 3> {
    /// Where the line `origin + x direction` meets the surface, as [`Surface::meet_line`].
    ///
    /// # Errors
    /// As [`Surface::meet_line`].
    pub fn meet_line(
        &self,
        origin: &SVector<f64, 3>,
        direction: &SVector<f64, 3>,
        tolerance: &f64,
    ) -> Result<LineMeetings> {
        let boxes = self.lifted().boxes()?.into_iter();
        let pieces = boxes.map(|patch| Piece::of(patch, |c| [c.point[0], c.point[1], c.point[2], c.weight]));
        Query::new(pieces.collect(), origin, direction, *tolerance)?.answer()
    }
}

/// A line and a surface of unit size.
struct Query {
    pieces: Vec<Piece>,
    axes: [Axis; 2],
    exponent: i32,
    /// A point of the line near the surface, and the parameter there times the length of the direction.
    base: Point,
    along: f64,
    direction: Point,
    normals: [Point; 2],
    /// The length of the direction.
    length: f64,
    tolerance: f64,
    /// Rounding of the base.
    slack: f64,
}

/// A place that a patch found.
struct Found {
    piece: usize,
    x: Pair,
    place: Place,
    proved: bool,
}

impl Query {
    fn new(pieces: Vec<Piece>, origin: &Point, direction: &Point, tolerance: f64) -> Result<Self> {
        check(tolerance)?;
        for (what, point) in [("origin", origin), ("direction", direction)] {
            if let Some(index) = point.iter().position(|x| !x.is_finite()) {
                return Err(Error::NotFinite { what, index });
            }
        }
        let (unit_direction, length) = unit(direction).ok_or(Error::NoLength)?;
        let positive = pieces.into_iter().map(Piece::positive).collect::<Result<Vec<_>>>()?;
        let mut pieces: Vec<Piece> = positive.into_iter().flatten().collect();
        let sizes = pieces.iter().map(|piece| piece.points().map(|c| c.amax()).fold(0.0, f64::max));
        let size = sizes.fold(0.0, f64::max);
        if !size.is_finite() {
            return Err(Error::NotFinite { what: "control point", index: 0 });
        }
        let exponent = unit_exponent(if size > 0.0 { size } else { origin.amax() });
        pieces = pieces.into_iter().map(|piece| piece.scaled(exponent)).collect();
        let origin = origin.map(|x| shifted(x, exponent));
        let slack = 16.0 * f64::EPSILON * origin.amax();
        if slack.is_nan() || slack > 1.0 {
            let bound = shifted(slack, -exponent).to_string();
            return Err(Error::OutOfTolerance { bound, tolerance: tolerance.to_string() });
        }
        let along = -dot(&origin, &unit_direction);
        let base = origin + unit_direction * along;
        let least = (0..3).min_by(|i, j| unit_direction[*i].abs().total_cmp(&unit_direction[*j].abs()));
        let axis = Point::from_fn(|i, _| f64::from(u8::from(Some(i) == least)));
        let normal = unit_cross(&unit_direction, &axis).expect("an axis across the direction");
        let other = unit_cross(&unit_direction, &normal).expect("a normal is across the direction");
        let axes = [0, 1].map(|k| axis_of(&pieces, k));
        let normals = [normal, other];
        let tolerance = shifted(tolerance, exponent).min(f64::MAX);
        Ok(Self {
            pieces,
            axes,
            exponent,
            base,
            along,
            direction: unit_direction,
            normals,
            length,
            tolerance,
            slack,
        })
    }

    fn problem(&self, piece: &Piece) -> Problem<Grid> {
        let equations = |c: &[f64; 4]| {
            let off = vector![c[0], c[1], c[2]] - self.base * c[3];
            self.normals.map(|n| dot(&n, &off))
        };
        let size = piece.coeffs.iter().flat_map(|c| c[..3].iter()).fold(0.0, |m: f64, x| m.max(x.abs()));
        let [low, high] = piece.weights();
        Problem {
            noise: rounding(piece.degrees, 2.0 * size + 2.0 * self.base.amax() * high) + self.slack * high,
            speeds: piece.speeds(),
            weight: low,
            system: Grid { degrees: piece.degrees, coeffs: piece.coeffs.iter().map(equations).collect() },
        }
    }

    /// The parameter of the line next to a point of unit size.
    fn along(&self, point: &Point) -> f64 {
        shifted(self.along + dot(&(point - self.base), &self.direction), -self.exponent) / self.length
    }

    fn answer(&self) -> Result<LineMeetings> {
        let mut budget = Budget::new();
        let (mut found, mut parts) = (Vec::new(), Vec::new());
        // The line misses the unit ball around the surface.
        let near = self.base.norm() <= 2.0 + self.slack;
        for (i, piece) in self.pieces.iter().enumerate().filter(|_| near) {
            let problem = self.problem(piece);
            let system = &problem.system;
            let all = Coefficients { degrees: piece.degrees, coeffs: &system.coeffs, noise: problem.noise };
            if all.misses() {
                continue;
            }
            let findings = solve(&problem, self.tolerance, &mut budget)?;
            let place = |low: Pair, high: Pair| {
                let (low, high) = (piece.parameters(low), piece.parameters(high));
                [0, 1].map(|k| [low[k], high[k]])
            };
            for root in &findings.roots {
                let [low, high] = [-1.0, 1.0].map(|s| [0, 1].map(|k| root.x[k] + s * root.radius[k]));
                let x = root.x.map(|x| x.clamp(0.0, 1.0));
                found.push(Found { piece: i, x, place: place(low, high), proved: true });
            }
            for [u, v] in &findings.left {
                let x = [0.5 * (u[0] + u[1]), 0.5 * (v[0] + v[1])];
                found.push(Found { piece: i, x, place: place([u[0], v[0]], [u[1], v[1]]), proved: false });
            }
            for trace in &findings.traces {
                let [start, end] = trace.ends();
                let points = [piece.at(start), piece.at(end), piece.at(trace.points[trace.points.len() / 2])];
                let apart = |p: &Point| (p - points[0]).norm() > self.tolerance;
                if points.iter().any(apart) {
                    parts.extend(stretches(trace, &self.axes, |x| piece.parameters(x)));
                } else {
                    // A side of the patch that is a point.
                    let bounds = |pick: fn(f64, f64) -> f64| [0, 1].map(|k| pick(start[k], end[k]));
                    let place = place(bounds(f64::min), bounds(f64::max));
                    found.push(Found { piece: i, x: start, place, proved: false });
                }
            }
        }
        let overlaps = joined(parts.clone(), &self.axes);
        found.retain(|f| !parts.iter().any(|part| part.ends_at(&f.place, &self.axes)));
        let places: Vec<Place> = found.iter().map(|f| f.place).collect();
        let group = |group: &Vec<usize>| self.meeting(&group.iter().map(|&i| &found[i]).collect::<Vec<_>>());
        let mut meetings: Vec<LineMeeting> = groups(&places, &self.axes).iter().map(group).collect();
        meetings.sort_by(|a, b| a.along.total_cmp(&b.along));
        let mut overlaps: Vec<LineOverlap> = overlaps.iter().map(|part| self.overlap(part)).collect();
        overlaps.sort_by(|a, b| a.along.0.total_cmp(&b.along.0));
        Ok(LineMeetings { meetings, overlaps })
    }

    fn meeting(&self, group: &[&Found]) -> LineMeeting {
        let places: Vec<Place> = group.iter().map(|f| f.place).collect();
        let ranges = hull(&places, &self.axes);
        let proved = group.iter().all(|f| f.proved);
        let (piece, x) = self.best(group, &ranges);
        let (point, parameters) = (self.pieces[piece].at(x), self.pieces[piece].parameters(x));
        LineMeeting {
            parameters: [0, 1].map(|k| self.axes[k].inside(parameters[k])),
            ranges: ranges.map(|[from, to]| (from, to)),
            along: self.along(&point),
            point: point.map(|x| shifted(x, -self.exponent)),
            certainty: if proved { Certainty::Proved } else { Certainty::Contact },
        }
    }

    /// A place to stand for a group: a proved solution, else the middle of the ranges, unless the surface is much
    /// nearer to the line elsewhere.
    fn best(&self, group: &[&Found], ranges: &Place) -> (usize, Pair) {
        if let Some(f) = group.iter().find(|f| f.proved) {
            return (f.piece, f.x);
        }
        let middle = self.place([0, 1].map(|k| self.axes[k].inside(0.5 * (ranges[k][0] + ranges[k][1]))));
        let off = |(piece, x): &(usize, Pair)| {
            let point = self.pieces[*piece].at(*x) - self.base;
            (point - self.direction * dot(&point, &self.direction)).norm()
        };
        let others = group.iter().step_by(group.len().div_ceil(16)).map(|f| (f.piece, f.x));
        let nearest = others.min_by(|a, b| off(a).total_cmp(&off(b))).expect("a group has a member");
        if off(&middle) <= 2.0 * off(&nearest) + 16.0 * f64::EPSILON { middle } else { nearest }
    }

    fn overlap(&self, part: &Stretch) -> LineOverlap {
        let along = |parameters: Pair| self.along(&self.point(parameters));
        let (from, to) = (along(part.from), along(part.to));
        if from <= to {
            LineOverlap { along: (from, to), parameters: [part.from, part.to] }
        } else {
            LineOverlap { along: (to, from), parameters: [part.to, part.from] }
        }
    }

    /// The point of the surface at parameters of its domain.
    fn point(&self, parameters: Pair) -> Point {
        let (piece, x) = self.place(parameters);
        self.pieces[piece].at(x)
    }

    /// The patch that holds parameters of the domain, and where in it.
    fn place(&self, x: Pair) -> (usize, Pair) {
        let holds = |piece: &Piece| (0..2).all(|k| piece.sides[k][0] <= x[k] && x[k] <= piece.sides[k][1]);
        let index = self.pieces.iter().position(holds).expect("the patches fill the domain");
        let sides = &self.pieces[index].sides;
        (index, [0, 1].map(|k| (x[k] - sides[k][0]) / (sides[k][1] - sides[k][0])))
    }
}
