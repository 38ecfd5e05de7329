//! Two equations in two unknowns on the unit square, in Bernstein form.

use crate::analysis::meet::casteljau::{Line, restrict, value_and_slope};

/// Two numbers: a point of the square, or the two sides of the equations.
pub(crate) type Pair = [f64; 2];

/// Values and derivatives at a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Local {
    pub value: Pair,
    /// The derivative by each of the unknowns.
    pub slopes: [Pair; 2],
}

/// A polynomial map from the unit square to the plane.
pub(crate) trait System: Clone {
    fn degrees(&self) -> [usize; 2];

    /// The Bernstein coefficients, the second direction running fastest.
    fn fill(&self, coeffs: &mut Vec<Pair>);

    /// The same map with `[from, to]` of one axis as the unit interval; it may reach a little beyond.
    fn restricted(&self, axis: usize, from: f64, to: f64) -> Self;

    /// Value and derivatives, also a little outside of the square.
    fn at(&self, x: Pair) -> Local;
}

/// A system with what is known about its size.
#[derive(Clone, Debug)]
pub(crate) struct Problem<S> {
    pub system: S,
    /// Values below this are rounding.
    pub noise: f64,
    /// How far the point moves at most for a unit of each unknown.
    pub speeds: Pair,
    /// A value of the system is at least this times the distance of the points.
    pub weight: f64,
}

/// The rounding errors of a system of these degrees with terms of this size.
pub(crate) fn rounding(degrees: [usize; 2], size: f64) -> f64 {
    4.0 * (degrees[0] + degrees[1] + 4) as f64 * f64::EPSILON * size
}

/// A system given by all of its coefficients.
#[derive(Clone, Debug)]
pub(crate) struct Grid {
    pub degrees: [usize; 2],
    pub coeffs: Vec<Pair>,
}

impl System for Grid {
    fn degrees(&self) -> [usize; 2] {
        self.degrees
    }

    fn fill(&self, coeffs: &mut Vec<Pair>) {
        coeffs.clear();
        coeffs.extend_from_slice(&self.coeffs);
    }

    fn restricted(&self, axis: usize, from: f64, to: f64) -> Self {
        let mut coeffs = self.coeffs.clone();
        let [p, q] = self.degrees;
        let lines = if axis == 0 { q + 1 } else { p + 1 };
        for line in 0..lines {
            let line = match axis {
                0 => Line { start: line, stride: q + 1, degree: p },
                _ => Line { start: line * (q + 1), stride: 1, degree: q },
            };
            restrict(&mut coeffs, line, from, to);
        }
        Self { degrees: self.degrees, coeffs }
    }

    fn at(&self, x: Pair) -> Local {
        // Each row becomes its value and its derivative along the second direction.
        let row = |row: &[Pair]| {
            let [[a, b], [c, d]] = value_and_slope(&mut row.to_vec(), x[1]);
            [a, b, c, d]
        };
        let mut rows: Vec<[f64; 4]> = self.coeffs.chunks_exact(self.degrees[1] + 1).map(row).collect();
        let [value, slope] = value_and_slope(&mut rows, x[0]);
        Local { value: [value[0], value[1]], slopes: [[slope[0], slope[1]], [value[2], value[3]]] }
    }
}

/// The difference of two plane pieces `P / v` and `Q / w`: `F(s, t) = P(s) w(t) - Q(t) v(s)`.
#[derive(Clone, Debug)]
pub(crate) struct Difference {
    /// Coefficients `(x, y, weight)` of each piece, the point multiplied by the weight.
    pub pieces: [Vec<[f64; 3]>; 2],
}

impl System for Difference {
    fn degrees(&self) -> [usize; 2] {
        [self.pieces[0].len() - 1, self.pieces[1].len() - 1]
    }

    fn fill(&self, coeffs: &mut Vec<Pair>) {
        let [p, q] = &self.pieces;
        coeffs.clear();
        for [x, y, v] in p {
            coeffs.extend(q.iter().map(|[a, b, w]| [x * w - a * v, y * w - b * v]));
        }
    }

    fn restricted(&self, axis: usize, from: f64, to: f64) -> Self {
        let mut part = self.clone();
        let piece = &mut part.pieces[axis];
        let line = Line::whole(piece.len());
        restrict(piece, line, from, to);
        part
    }

    fn at(&self, x: Pair) -> Local {
        let [[p, dp], [q, dq]] = [0, 1].map(|i| value_and_slope(&mut self.pieces[i].clone(), x[i]));
        let difference = |p: &[f64; 3], q: &[f64; 3]| [0, 1].map(|k| p[k] * q[2] - q[k] * p[2]);
        Local { value: difference(&p, &q), slopes: [difference(&dp, &q), difference(&p, &dq)] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_kinds_are_one_map() {
        let pieces =
            [vec![[0.0, 1.0, 1.0], [2.0, 0.5, 0.5], [1.0, 3.0, 2.0]], vec![[1.0, 0.0, 1.0], [0.0, 2.0, 3.0]]];
        let difference = Difference { pieces };
        let mut coeffs = Vec::new();
        difference.fill(&mut coeffs);
        let grid = Grid { degrees: difference.degrees(), coeffs };
        let same = |a: Pair, b: Pair| (0..2).all(|k| (a[k] - b[k]).abs() < 1e-13);
        for (axis, from, to) in [(0, 0.0, 1.0), (0, 0.2, 0.7), (1, 0.5, 0.75), (1, 0.9, 1.0)] {
            let (d, g) = (difference.restricted(axis, from, to), grid.restricted(axis, from, to));
            for x in [[0.0, 0.0], [0.3, 0.8], [1.0, 0.5], [1.01, -0.01]] {
                let (d, g) = (d.at(x), g.at(x));
                assert!(same(d.value, g.value) && (0..2).all(|k| same(d.slopes[k], g.slopes[k])));
                let mut inner = x;
                inner[axis] = from + (to - from) * x[axis];
                assert!(same(d.value, grid.at(inner).value));
            }
        }
    }
}
