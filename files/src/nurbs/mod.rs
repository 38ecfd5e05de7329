//! Splines as most files tell them: degrees, full knots, control points and weights, all of them floats.
//!
//! A periodic space is told by its unrolled knots and by control points that come again: the same function, for readers that know no
//! periodic spaces. What was told so with the word that it is periodic is read as periodic, if that gives the same numbers to the
//! last bit. Where the seam has several copies, knots and control points that count nowhere in the domain are left out; with `degree + 1`
//! copies the space is told, and comes back, as the clamped one that it is.

mod from_value;
mod into_value;
pub(crate) mod real;
pub(crate) mod shapes;

/// The space of one parameter as it is told.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Along {
    pub degree: usize,
    /// The full knots, `degree + 1` more than there are control points.
    pub knots: Vec<f64>,
    /// Whether it is called periodic or, in a format that has no such word, closed.
    pub periodic: bool,
}

impl Along {
    /// How many control points there are.
    pub(crate) fn count(&self) -> usize {
        self.knots.len().saturating_sub(self.degree).saturating_sub(1)
    }

    /// Start and end of the domain.
    pub(crate) fn domain(&self) -> [f64; 2] {
        [self.knots[self.degree], self.knots[self.count()]]
    }

    /// The distinct knots with their multiplicities.
    pub(crate) fn multiplicities(&self) -> Vec<(f64, usize)> {
        self.knots.chunk_by(|s, t| s == t).map(|copies| (copies[0], copies.len())).collect()
    }
}

/// The places of a grid in the order of its columns: in many files the index of `u`, the row, runs first.
pub(crate) fn by_columns(rows: usize, columns: usize) -> impl Iterator<Item = usize> {
    (0..columns).flat_map(move |j| (0..rows).map(move |i| i * columns + j))
}

/// A curve, with one parameter, or a surface, with two.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Nurbs {
    pub along: Vec<Along>,
    /// Two or three coordinates.
    pub dim: usize,
    /// The coordinates of the control points one after the other; of a surface row by row, each row of one `u`.
    pub coords: Vec<f64>,
    /// The weights of a rational one.
    pub weights: Option<Vec<f64>>,
}

impl Nurbs {
    /// The control points.
    pub(crate) fn points(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        self.coords.chunks_exact(self.dim)
    }

    /// A control point with three coordinates, the third zero in the plane.
    pub(crate) fn in_space(point: &[f64]) -> [f64; 3] {
        [point[0], point[1], point.get(2).copied().unwrap_or(0.0)]
    }

    /// Whether the last control point is where the first is, in the direction of a parameter: the ends of clamped splines meet.
    pub(crate) fn closes(&self, direction: usize) -> bool {
        let points: Vec<&[f64]> = self.points().collect();
        match self.along.as_slice() {
            [_] => points.first() == points.last(),
            [_, v] if direction == 0 => points[..v.count()] == points[points.len() - v.count()..],
            [_, v] => points.chunks_exact(v.count()).all(|row| row.first() == row.last()),
            _ => false,
        }
    }
}
