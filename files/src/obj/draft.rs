//! A free-form element while it is read.

use super::knots::{Kind, space};
use super::lines::Statement;
use crate::error::{FileError, Problem, Result};
use symspline::{Direction, SplineSpace};
use symspline_dynamic::{
    AnyRational, AnyRationalSurface, AnySpace, AnySpline, AnySurface, Coords, Number, Value,
};

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

    fn space(&self, parameter: usize) -> std::result::Result<SplineSpace<f64>, Problem> {
        let letter = ["u", "v"][parameter];
        let missing = |what: &str| Problem::Syntax(format!("{what} of {letter} is missing"));
        let degree = *self.degrees.get(parameter).ok_or_else(|| missing("the degree"))?;
        let values = self.knots[parameter].as_ref().ok_or_else(|| missing("'parm'"))?;
        space(self.kind, degree, values)
    }

    fn made(&self) -> std::result::Result<Value, Problem> {
        let dim = if self.element == Element::PlaneCurve { 2 } else { 3 };
        if self.element == Element::Surface {
            let (u, v) = (self.space(0)?, self.space(1)?);
            let expected = u.dim().saturating_mul(v.dim());
            if expected != self.points.len() {
                let found = self.points.len();
                return Err(symspline::Error::CoefficientCount { expected, found }.into());
            }
            // In the file the index of u runs first, here that of v.
            let order = (0..u.dim()).flat_map(|i| (0..v.dim()).map(move |j| (i, j)));
            let points: Vec<_> = order.map(|(i, j)| self.points[j * u.dim() + i]).collect();
            let (coords, weights) = apart(&points, dim);
            return self.surface(u, v, coords, weights);
        }
        let space = self.space(0)?;
        let (coords, weights) = apart(&self.points, dim);
        let domain = space.domain();
        let part = self.part(&self.range, (*domain.0, *domain.1));
        let space = AnySpace::from(space);
        Ok(match self.is_rational {
            true => {
                let curve = AnyRational::new(space, dim, coords, weights)?;
                part.map_or(Ok(curve.clone()), |[a, b]| curve.restricted(&a, &b))?.into()
            }
            false => {
                let curve = AnySpline::new(space, dim, coords)?;
                part.map_or(Ok(curve.clone()), |[a, b]| curve.restricted(&a, &b))?.into()
            }
        })
    }

    fn surface(
        &self,
        u: SplineSpace<f64>,
        v: SplineSpace<f64>,
        coords: Coords,
        weights: Coords,
    ) -> std::result::Result<Value, Problem> {
        let ends = |space: &SplineSpace<f64>| (*space.domain().0, *space.domain().1);
        let parts = [self.part(&self.range[..2], ends(&u)), self.part(&self.range[2..], ends(&v))];
        /// One text for both kinds.
        macro_rules! restricted {
            ($surface:expr) => {{
                let mut surface = $surface;
                for (direction, part) in [Direction::U, Direction::V].into_iter().zip(parts) {
                    if let Some([a, b]) = part {
                        surface = surface.restricted(direction, &a, &b)?;
                    }
                }
                surface.into()
            }};
        }
        let (u, v) = (AnySpace::from(u), AnySpace::from(v));
        Ok(match self.is_rational {
            true => restricted!(AnyRationalSurface::new(u, v, 3, coords, weights)?),
            false => restricted!(AnySurface::new(u, v, 3, coords)?),
        })
    }

    /// The range, unless it is the whole domain or not told.
    fn part(&self, range: &[f64], domain: (f64, f64)) -> Option<[Number; 2]> {
        match range {
            [a, b] if (*a, *b) != domain => Some([Number::Float(*a), Number::Float(*b)]),
            _ => None,
        }
    }
}

fn apart(points: &[([f64; 3], f64)], dim: usize) -> (Coords, Coords) {
    let coords = points.iter().flat_map(|(point, _)| &point[..dim]).copied().collect();
    (Coords::Float(coords), Coords::Float(points.iter().map(|(_, weight)| *weight).collect()))
}
