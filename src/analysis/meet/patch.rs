//! The patches of surfaces, polynomial and rational, as Bernstein coefficients of weighted points.

use crate::analysis::meet::arc::{shifted, unit_exponent};
use crate::analysis::meet::casteljau::{Line, restrict};
use crate::analysis::meet::merge::Axis;
use crate::analysis::meet::system::Pair;
use crate::error::{Error, Result};
use crate::ops::patch::Patch;
use nalgebra::{SVector, vector};

pub(crate) type Point = SVector<f64, 3>;

/// From where to where a side of a patch runs, and its control points.
type Row = (Pair, Vec<Point>);

/// How often a patch is halved at most to make its weights positive.
const HALVINGS: usize = 40;

/// A patch of the surface.
#[derive(Clone, Debug)]
pub(crate) struct Piece {
    pub degrees: [usize; 2],
    pub sides: [Pair; 2],
    /// `(x w, y w, z w, w)`.
    pub coeffs: Vec<[f64; 4]>,
}

impl Piece {
    pub(crate) fn of<C>(patch: Patch<f64, 2, C>, weighted: impl Fn(&C) -> [f64; 4]) -> Self {
        let coeffs = patch.coeffs.iter().map(weighted).collect();
        Self { degrees: patch.degrees, sides: patch.sides.map(|(a, b)| [a, b]), coeffs }
    }

    fn part(&self, axis: usize, from: f64, to: f64) -> Self {
        let (mut part, [p, q]) = (self.clone(), self.degrees);
        for line in 0..if axis == 0 { q + 1 } else { p + 1 } {
            let line = match axis {
                0 => Line { start: line, stride: q + 1, degree: p },
                _ => Line { start: line * (q + 1), stride: 1, degree: q },
            };
            restrict(&mut part.coeffs, line, from, to);
        }
        let [a, b] = self.sides[axis];
        let place = |x: f64| if x == 1.0 { b } else { a + (b - a) * x };
        part.sides[axis] = [place(from), place(to)];
        part
    }

    /// The parts with positive weights.
    pub(crate) fn positive(self) -> Result<Vec<Self>> {
        let (mut open, mut done) = (vec![(self, 0)], Vec::new());
        while let Some((piece, depth)) = open.pop() {
            if piece.coeffs.iter().all(|c| c[3] > 0.0) {
                done.push(piece);
                continue;
            }
            if depth == HALVINGS {
                return Err(Error::Undecided);
            }
            let axis = if piece.degrees[depth % 2] > 0 { depth % 2 } else { 1 - depth % 2 };
            open.extend(
                [piece.part(axis, 0.5, 1.0), piece.part(axis, 0.0, 0.5)].map(|half| (half, depth + 1)),
            );
        }
        Ok(done)
    }

    pub(crate) fn points(&self) -> impl Iterator<Item = Point> {
        self.coeffs.iter().map(|c| vector![c[0] / c[3], c[1] / c[3], c[2] / c[3]])
    }

    pub(crate) fn weights(&self) -> Pair {
        self.coeffs.iter().fold([f64::INFINITY, 0.0], |[low, high], c| [low.min(c[3]), high.max(c[3])])
    }

    pub(crate) fn scaled(mut self, exponent: i32) -> Self {
        let weight = unit_exponent(self.weights()[1]);
        for c in &mut self.coeffs {
            (0..3).for_each(|k| c[k] = shifted(c[k], exponent + weight));
            c[3] = shifted(c[3], weight);
        }
        self
    }

    pub(crate) fn at(&self, x: Pair) -> Point {
        let mut point = self.part(0, x[0], x[0]);
        point = point.part(1, x[1], x[1]);
        let first = point.points().next();
        first.expect("a patch has a coefficient")
    }

    pub(crate) fn parameters(&self, x: Pair) -> Pair {
        std::array::from_fn(|k| {
            let [a, b] = self.sides[k];
            if x[k] == 1.0 { b } else { (a + (b - a) * x[k]).clamp(a, b) }
        })
    }

    /// Bounds of the derivatives, as those of a curve.
    pub(crate) fn speeds(&self) -> Pair {
        let points: Vec<Point> = self.points().collect();
        let ([p, q], [low, high]) = (self.degrees, self.weights());
        let ratio = if low == high { 1.0 } else { (high / low).powi(2) };
        let step = |i: usize, j: usize| (points[j] - points[i]).norm();
        let along = (0..p * (q + 1)).map(|i| step(i, i + q + 1)).fold(0.0, f64::max);
        let across =
            (0..points.len()).filter(|i| i % (q + 1) < q).map(|i| step(i, i + 1)).fold(0.0, f64::max);
        [p as f64 * along * ratio, q as f64 * across * ratio]
    }
}

/// The domain of a parameter, closed if the points of both ends coincide.
pub(crate) fn axis_of(pieces: &[Piece], k: usize) -> Axis {
    let ends = pieces.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], piece| {
        [a.min(piece.sides[k][0]), b.max(piece.sides[k][1])]
    });
    let side = |end: usize| -> Vec<Row> {
        let at_end = pieces.iter().filter(|piece| piece.sides[k][end] == ends[end]);
        let mut side: Vec<_> = at_end
            .map(|piece| {
                let points: Vec<Point> = piece.points().collect();
                let ([p, q], last) = (piece.degrees, end * piece.degrees[k]);
                let row = match k {
                    0 => points[last * (q + 1)..][..=q].to_vec(),
                    _ => (0..=p).map(|i| points[i * (q + 1) + last]).collect(),
                };
                (piece.sides[1 - k], row)
            })
            .collect();
        side.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]));
        side
    };
    let near = |a: &Point, b: &Point| (a - b).amax() <= 64.0 * f64::EPSILON;
    let same = |((a, p), (b, q)): (&Row, &Row)| a == b && p.iter().zip(q).all(|(p, q)| near(p, q));
    let (first, last) = (side(0), side(1));
    Axis { domain: ends, closed: first.len() == last.len() && first.iter().zip(&last).all(same) }
}
