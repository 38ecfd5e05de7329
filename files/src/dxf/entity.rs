//! The groups of one entity, by code.

use crate::dxf::groups::{Group, unescaped};
use crate::dxf::{APPLICATION, flags};
use crate::error::{FileError, Place, Problem, Result};
use crate::nurbs::{Along, Nurbs};
use nalgebra::Vector3;
use symspline_dynamic::Value;

/// An entity: its groups after the first, which is its kind.
pub(super) struct Entity<'a> {
    pub kind: String,
    pub line: usize,
    pub groups: Vec<Group<'a>>,
}

impl Entity<'_> {
    /// An error of the entity as a whole.
    pub(super) fn failed(&self, problem: impl Into<Problem>) -> FileError {
        problem.into().at_line(self.line)
    }

    pub(super) fn wrong(&self, what: &str) -> FileError {
        self.failed(Problem::Syntax(format!("{}: {what}", self.kind)))
    }

    fn all(&self, code: i32) -> impl Iterator<Item = &Group<'_>> {
        self.groups.iter().filter(move |group| group.code == code)
    }

    pub(super) fn real(&self, code: i32) -> Result<Option<f64>> {
        self.all(code).next().map(Group::real).transpose()
    }

    pub(super) fn needed(&self, code: i32, what: &str) -> Result<f64> {
        self.real(code)?.ok_or_else(|| self.wrong(&format!("{what} (group {code}) is missing")))
    }

    pub(super) fn reals(&self, code: i32) -> Result<Vec<f64>> {
        self.all(code).map(Group::real).collect()
    }

    pub(super) fn whole(&self, code: i32) -> Result<Option<i64>> {
        self.all(code).next().map(Group::whole).transpose()
    }

    /// The vector whose coordinates have the codes `code`, `code + 10` and `code + 20`.
    pub(super) fn vector(&self, code: i32) -> Result<Option<Vector3<f64>>> {
        Ok(match self.real(code)? {
            Some(x) => {
                let (y, z) = (self.needed(code + 10, "a coordinate")?, self.real(code + 20)?);
                Some(Vector3::new(x, y, z.unwrap_or(0.0)))
            }
            None => None,
        })
    }

    /// The points of these codes, and for each the value of the last of `besides` after it.
    pub(super) fn points(&self, code: i32, besides: i32) -> Result<Vec<(Vector3<f64>, Option<f64>)>> {
        // Which coordinates of the last point were met.
        let (mut points, mut met) = (Vec::new(), [true; 3]);
        let lacking = |line| {
            Problem::Syntax(format!("a point has no group {}, or twice a coordinate", code + 10))
                .at_line(line)
        };
        for group in &self.groups {
            let axis = match group.code - code {
                0 => 0,
                10 => 1,
                20 => 2,
                _ if group.code == besides => {
                    if let Some((_, beside)) = points.last_mut() {
                        *beside = Some(group.real()?);
                    }
                    continue;
                }
                _ => continue,
            };
            if axis == 0 {
                if !met[1] {
                    return Err(lacking(group.line));
                }
                points.push((Vector3::zeros(), None));
                met = [false; 3];
            }
            match points.last_mut() {
                Some((point, _)) if !met[axis] => point[axis] = group.real()?,
                _ => return Err(lacking(group.line)),
            }
            met[axis] = true;
        }
        if met[1] { Ok(points) } else { Err(lacking(self.line)) }
    }

    /// What it is called: by this library, or by its layer.
    pub(super) fn name(&self, block: Option<&str>) -> Option<String> {
        let ours =
            self.groups.iter().position(|group| group.code == 1001 && group.value.trim() == APPLICATION);
        let name = ours.and_then(|at| self.groups.get(at + 1)).filter(|group| group.code == 1000);
        let layer = || {
            let layer = self.all(8).next()?.value.trim();
            (layer != "0" && !layer.is_empty()).then(|| unescaped(layer))
        };
        // Blocks whose names start with a star are the drawing itself, or have no name of their own.
        let block = block.filter(|block| !block.starts_with('*')).map(unescaped);
        name.map(|name| unescaped(&name.value)).or(block).or_else(layer)
    }

    /// The curve of a SPLINE.
    pub(super) fn spline(&self) -> Result<Value> {
        let flags = self.whole(70)?.unwrap_or(0);
        let degree = self.whole(71)?.ok_or_else(|| self.wrong("the degree (group 71) is missing"))?;
        let Some(degree) =
            usize::try_from(degree).ok().filter(|p| (1..=symspline::limits::MAX_DEGREE).contains(p))
        else {
            return Err(self.wrong(&format!("a degree of {degree} is not possible")));
        };
        let points = self.points(10, 0)?;
        if points.is_empty() {
            return Err(self.wrong(match self.all(11).next() {
                Some(_) => "there are fit points and no control points: the file does not tell the curve",
                None => "there are no control points",
            }));
        }
        let (knots, weights) = (self.reals(40)?, self.reals(41)?);
        self.counted(72, knots.len(), "knots")?;
        self.counted(73, points.len(), "control points")?;
        if knots.len() != points.len() + degree + 1 {
            let (k, n) = (knots.len(), points.len());
            return Err(self.wrong(&format!("{k} knots and {n} control points do not make degree {degree}")));
        }
        if !weights.is_empty() && weights.len() != points.len() {
            let (w, n) = (weights.len(), points.len());
            return Err(self.wrong(&format!("{n} control points have {w} weights")));
        }
        // Weights are left out if all are one.
        let weights = match (weights.is_empty(), flags & flags::RATIONAL != 0) {
            (true, false) => None,
            (true, true) => Some(vec![1.0; points.len()]),
            (false, _) => Some(weights),
        };
        let upright = self.vector(210)? == Some(Vector3::z());
        let plane = flags & flags::PLANAR != 0 && upright && points.iter().all(|(point, _)| point.z == 0.0);
        let dim = if plane { 2 } else { 3 };
        let told = Nurbs {
            along: vec![Along { degree, knots, periodic: flags & (flags::CLOSED | flags::PERIODIC) != 0 }],
            dim,
            coords: points.iter().flat_map(|(point, _)| point.iter().take(dim).copied()).collect(),
            weights,
        };
        told.into_value().map_err(|problem| self.failed(problem))
    }

    /// Checks a count that the file claims.
    pub(super) fn counted(&self, code: i32, found: usize, what: &str) -> Result<()> {
        match self.whole(code)? {
            Some(claimed) if usize::try_from(claimed) != Ok(found) => {
                Err(self.wrong(&format!("{claimed} {what} are told, {found} are there")))
            }
            _ => Ok(()),
        }
    }
}

/// That a file ends too early.
pub(super) fn cut_off(line: usize, what: &str) -> FileError {
    Problem::Syntax(format!("the file ends before {what}")).at(Place::Line { line, column: 0 })
}
