//! A free-form element while it is read.

use super::knots::{Kind, full_knots};
use super::lines::Statement;
use crate::error::{FileError, Problem, Result};
use crate::nurbs::{Along, Nurbs, by_columns};
use symspline_dynamic::Value;

/// What kind of element it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Element {
    /// A curve in space.
    Curve,
    /// A curve in the plane.
    PlaneCurve,
    /// A surface.
    Surface,
}

/// A free-form element: its points are known, its knots follow.
#[derive(Debug)]
pub(super) struct Draft<'a> {
    pub element: Element,
    pub kind: Kind,
    pub is_rational: bool,
    pub degrees: Vec<usize>,
    /// The statement that it began with, for its line.
    pub start: Statement<'a>,
    /// The ends of the range of each parameter, if they are told.
    pub range: Vec<f64>,
    /// The coordinates of the points and their weights.
    pub points: Vec<([f64; 3], f64)>,
    /// The knots of each parameter, as they are told.
    pub knots: [Option<Vec<f64>>; 2],
}

impl Draft<'_> {
    /// The curve or surface.
    pub fn finished(&self) -> Result<Value> {
        self.made().map_err(|problem| self.wrong(problem))
    }

    fn wrong(&self, problem: Problem) -> FileError {
        problem.at_line(self.start.line)
    }

    fn along(&self, parameter: usize) -> std::result::Result<Along, Problem> {
        let letter = ["u", "v"][parameter];
        let missing = |what: &str| Problem::Syntax(format!("{what} of {letter} is missing"));
        let degree = *self.degrees.get(parameter).ok_or_else(|| missing("the degree"))?;
        let values = self.knots[parameter].as_ref().ok_or_else(|| missing("'parm'"))?;
        Ok(Along { degree, knots: full_knots(self.kind, degree, values)?, periodic: false })
    }

    fn made(&self) -> std::result::Result<Value, Problem> {
        let dim = if self.element == Element::PlaneCurve { 2 } else { 3 };
        let directions = if self.element == Element::Surface { 2 } else { 1 };
        let along = (0..directions).map(|i| self.along(i)).collect::<std::result::Result<Vec<_>, _>>()?;
        let rows = along[0].count();
        let columns = along.get(1).map_or(1, Along::count);
        let (expected, found) = (rows.saturating_mul(columns), self.points.len());
        if expected != found {
            return Err(symspline::Error::CoefficientCount { expected, found }.into());
        }
        let points = || by_columns(columns, rows).map(|i| &self.points[i]);
        let nurbs = Nurbs {
            along,
            dim,
            coords: points().flat_map(|(point, _)| &point[..dim]).copied().collect(),
            weights: self.is_rational.then(|| points().map(|(_, weight)| *weight).collect()),
        };
        let ends: Vec<[f64; 2]> = self.range.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect();
        nurbs.into_part(&ends)
    }
}
