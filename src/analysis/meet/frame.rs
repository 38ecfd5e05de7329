//! What the coefficients of a box tell: that it holds no solution, or where in it solutions can be, or that there is
//! one at most.
//!
//! The equations are combined first. Where the mean Jacobian is regular, its inverse makes them nearly `x - a = 0` and
//! `y - b = 0`; else they are turned so that one equation takes the direction in which the map grows and the other what
//! is left. The graph of a polynomial lies in the convex hull of its coefficients over their places `i / p`: where the
//! hull of the least and of the greatest coefficients across misses zero there is no solution.

use crate::analysis::meet::system::Pair;

/// The coefficients of a box, and what rounding makes of them.
pub(crate) struct Coefficients<'a> {
    pub degrees: [usize; 2],
    pub coeffs: &'a [Pair],
    pub noise: f64,
}

/// What the combined equations are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Nearly the unknowns themselves.
    Regular,
    /// The first grows, the second is what is left.
    Turned,
}

/// The combined equations of a box.
pub(crate) struct Frame {
    pub kind: Kind,
    pub degrees: [usize; 2],
    pub coeffs: Vec<Pair>,
    /// The noise of each equation.
    pub noise: Pair,
}

/// Determinants below this part of the product of the columns count as zero.
const SINGULAR: f64 = 1e-9;

pub(crate) fn cross(a: Pair, b: Pair) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

pub(crate) fn norm(a: Pair) -> f64 {
    a[0].hypot(a[1])
}

/// The sum of magnitudes of a row times `noise`.
fn spread(row: Pair, noise: f64) -> f64 {
    (row[0].abs() + row[1].abs()) * noise
}

/// The inverse of the matrix with these columns, by rows, if it is regular.
pub(crate) fn inverse(a: Pair, b: Pair) -> Option<[Pair; 2]> {
    let det = cross(a, b);
    let rows = [[b[1] / det, -b[0] / det], [-a[1] / det, a[0] / det]];
    (det.abs() > SINGULAR * norm(a) * norm(b) && rows.iter().flatten().all(|x| x.is_finite())).then_some(rows)
}

/// A rotation whose first row is the direction in which a map with these derivatives grows.
pub(crate) fn turn(a: Pair, b: Pair) -> [Pair; 2] {
    // The greater eigenvector of J Jᵀ.
    let (xx, xy, yy) = (a[0] * a[0] + b[0] * b[0], a[0] * a[1] + b[0] * b[1], a[1] * a[1] + b[1] * b[1]);
    let angle = 0.5 * (2.0 * xy).atan2(xx - yy);
    let (sin, cos) = angle.sin_cos();
    [[cos, sin], [-sin, cos]]
}

impl Coefficients<'_> {
    fn at(&self, i: usize, j: usize) -> Pair {
        self.coeffs[i * (self.degrees[1] + 1) + j]
    }

    /// Whether one of the two equations has no zero.
    pub(crate) fn misses(&self) -> bool {
        (0..2).any(|k| {
            let [low, high] = range(self.coeffs.iter().map(|c| c[k]));
            low > self.noise || high < -self.noise
        })
    }

    /// The mean derivatives.
    pub(crate) fn slopes(&self) -> [Pair; 2] {
        let [p, q] = self.degrees;
        let mean = |count: usize, step: &dyn Fn(usize) -> [Pair; 2]| {
            let mut sum = [0.0; 2];
            for i in 0..=count {
                let [from, to] = step(i);
                (0..2).for_each(|k| sum[k] += (to[k] - from[k]) / (count + 1) as f64);
            }
            sum
        };
        [mean(q, &|j| [self.at(0, j), self.at(p, j)]), mean(p, &|i| [self.at(i, 0), self.at(i, q)])]
    }

    /// The greatest steps between neighbouring coefficients along each axis, times the degree.
    pub(crate) fn steps(&self) -> Pair {
        let [p, q] = self.degrees;
        let size = |a: Pair, b: Pair| (a[0] - b[0]).abs().max((a[1] - b[1]).abs());
        let along = (0..p).flat_map(|i| (0..=q).map(move |j| (i, j)));
        let across = (0..=p).flat_map(|i| (0..q).map(move |j| (i, j)));
        let u = along.map(|(i, j)| size(self.at(i + 1, j), self.at(i, j))).fold(0.0, f64::max);
        let v = across.map(|(i, j)| size(self.at(i, j + 1), self.at(i, j))).fold(0.0, f64::max);
        [u * p as f64, v * q as f64]
    }

    /// The equations combined by `rows`.
    pub(crate) fn combined(&self, kind: Kind, rows: [Pair; 2]) -> Frame {
        let combine = |c: &Pair| rows.map(|row| row[0] * c[0] + row[1] * c[1]);
        Frame {
            kind,
            degrees: self.degrees,
            coeffs: self.coeffs.iter().map(combine).collect(),
            noise: rows.map(|row| spread(row, self.noise)),
        }
    }

    /// The equations combined as suits them.
    pub(crate) fn frame(&self) -> Frame {
        let [a, b] = self.slopes();
        // Solutions must be sharper than the box for clipping to help.
        let regular = inverse(a, b).filter(|rows| rows.iter().all(|row| spread(*row, self.noise) < 0.05));
        match regular {
            Some(rows) => self.combined(Kind::Regular, rows),
            None => self.combined(Kind::Turned, turn(a, b)),
        }
    }
}

impl Frame {
    fn at(&self, i: usize, j: usize) -> Pair {
        self.coeffs[i * (self.degrees[1] + 1) + j]
    }

    /// Whether a combined equation has no zero.
    pub(crate) fn misses(&self) -> bool {
        (0..2).any(|k| {
            let [low, high] = range(self.coeffs.iter().map(|c| c[k]));
            low > self.noise[k] || high < -self.noise[k]
        })
    }

    /// Whether equation `k` is rounding all over the box.
    pub(crate) fn is_flat(&self, k: usize) -> bool {
        self.coeffs.iter().all(|c| c[k].abs() <= 2.0 * self.noise[k])
    }

    /// Between which values the derivative of equation `k` by the unknown `axis` runs.
    pub(crate) fn slope_range(&self, k: usize, axis: usize) -> Pair {
        let [p, q] = self.degrees;
        let count = if axis == 0 { p } else { q };
        if count == 0 {
            return [0.0; 2];
        }
        let (di, dj) = if axis == 0 { (1, 0) } else { (0, 1) };
        let places = (0..=p - di).flat_map(|i| (0..=q - dj).map(move |j| (i, j)));
        let steps = places.map(|(i, j)| self.at(i + di, j + dj)[k] - self.at(i, j)[k]);
        range(steps).map(|x| x * count as f64)
    }

    /// Whether equation `k` grows or falls along one of the axes all over the box.
    pub(crate) fn is_monotone(&self, k: usize) -> bool {
        (0..2).any(|axis| {
            let [low, high] = self.slope_range(k, axis);
            low > 0.0 || high < 0.0
        })
    }

    /// Whether the Jacobian of the combined equations is strictly dominated by its diagonal all over the box: then the
    /// map is one to one there.
    pub(crate) fn is_dominated(&self) -> bool {
        (0..2).all(|k| {
            let [low, high] = self.slope_range(k, k);
            let [a, b] = self.slope_range(k, 1 - k);
            low.max(-high) > a.abs().max(b.abs()) * (1.0 + 1e-9)
        })
    }

    /// Where along `axis` equation `k` can have zeros: a part of `[0, 1]`, if any.
    pub(crate) fn clip(&self, k: usize, axis: usize) -> Option<Pair> {
        let [p, q] = self.degrees;
        let (along, across) = if axis == 0 { (p, q) } else { (q, p) };
        if along == 0 {
            return Some([0.0, 1.0]);
        }
        let at = |i: usize, j: usize| if axis == 0 { self.at(i, j)[k] } else { self.at(j, i)[k] };
        let ends: Vec<Pair> = (0..=along).map(|i| range((0..=across).map(|j| at(i, j)))).collect();
        let below = sublevel(along, |i| ends[i][0] - self.noise[k])?;
        let above = sublevel(along, |i| -ends[i][1] - self.noise[k])?;
        let part = [below[0].max(above[0]), below[1].min(above[1])];
        (part[0] <= part[1]).then_some(part)
    }
}

/// Least and greatest.
fn range(values: impl Iterator<Item = f64>) -> Pair {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
}

/// Where the lower convex hull of the points `(i / n, value(i))` is not above zero.
fn sublevel(n: usize, value: impl Fn(usize) -> f64) -> Option<Pair> {
    let (mut from, mut to) = (f64::INFINITY, f64::NEG_INFINITY);
    for j in (0..=n).filter(|&j| value(j) <= 0.0) {
        from = from.min(j as f64);
        to = to.max(j as f64);
        for i in (0..=n).filter(|&i| value(i) > 0.0) {
            // The chord from a point above to one below enters here.
            let enters = i as f64 + (j as f64 - i as f64) * (value(i) / (value(i) - value(j)));
            if i < j {
                from = from.min(enters);
            } else {
                to = to.max(enters);
            }
        }
    }
    (from <= to).then(|| [from / n as f64, to / n as f64])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hulls_are_cut_at_zero() {
        let hull = |values: &[f64]| sublevel(values.len() - 1, |i| values[i]);
        assert_eq!(hull(&[1.0, 1.0, 2.0]), None);
        assert_eq!(hull(&[1.0, -1.0]), Some([0.5, 1.0]));
        assert_eq!(hull(&[3.0, -1.0, 1.0]), Some([0.375, 0.75]));
        // The middle point lies below the chord and lets the hull enter earlier.
        assert_eq!(hull(&[4.0, 1.0, -5.0]), Some([4.0 / 9.0, 1.0]));
        assert_eq!(hull(&[4.0, 0.5, -1.0]), Some([0.5 + 0.5 / 3.0, 1.0]));
        assert_eq!(hull(&[0.0, 5.0, 0.0]), Some([0.0, 1.0]));
    }

    #[test]
    fn the_rotation_finds_the_growth() {
        let [along, across] = turn([3.0, 4.0], [-6.0, -8.0]);
        assert!((along[0].abs() - 0.6).abs() < 1e-15 && (along[1].abs() - 0.8).abs() < 1e-15);
        assert!((across[0] * 3.0 + across[1] * 4.0).abs() < 1e-14);
    }
}
