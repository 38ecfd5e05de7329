//! A bound of `G` that is off by the cube of the extent of a part, not by its square.
//!
//! Where the nearest points are a curve on a surface, as the edge to which a folded surface collapses, `G` is a trough:
//! it is nowhere convex, and bounds by its coefficients cover the curve with very many parts. So a quadratic polynomial
//! `q` is taken off. What is left has third derivatives only, its least coefficient is a bound, and the minimum of `q`
//! is known:
//!
//! ```text
//! G >= min_k (G_k - q_k) + min q
//! ```

use crate::analysis::nearest::square::Gap;

/// Determinants that are smaller parts of their products are taken for zero.
const SINGULAR: f64 = 1e-6;

/// A quadratic polynomial `s·x + x·H x / 2`.
#[derive(Clone, Copy, Debug)]
struct Quadratic {
    slopes: [f64; 2],
    /// `H`: uu, uv, vv.
    seconds: [f64; 3],
}

impl Gap<'_> {
    /// A number that `G` is not below on the unit square, less `noise` a coefficient.
    pub(super) fn least(&self, noise: f64) -> f64 {
        let q = Quadratic::near(self).tamed();
        let [degree_u, degree_v] = self.degrees;
        let (line, column) = (squares(degree_u), squares(degree_v));
        let mut least = f64::INFINITY;
        for i in 0..=degree_u {
            let (u, uu) = line(i);
            let start = q.slopes[0] * u + 0.5 * q.seconds[0] * uu;
            let slope = q.slopes[1] + q.seconds[1] * u;
            for j in 0..=degree_v {
                let (v, vv) = column(j);
                let own = start + slope * v + 0.5 * q.seconds[2] * vv;
                least = least.min(self.at(i * (degree_v + 1) + j) - own);
            }
        }
        // Without weights coefficients leave out the constant.
        let constant = if self.weights.is_empty() { self.square } else { 0.0 };
        least + q.least() - constant - noise - 16.0 * f64::EPSILON * q.size()
    }
}

/// The coefficients of `x` and of `x²` in a degree.
fn squares(degree: usize) -> impl Fn(usize) -> (f64, f64) {
    let n = degree as f64;
    let (first, second) = (1.0 / n.max(1.0), 1.0 / (n * (n - 1.0)).max(1.0));
    move |i: usize| (i as f64 * first, (i as f64 - 1.0) * i as f64 * second)
}

impl Quadratic {
    /// The one with the mean slopes and second derivatives of `G`.
    fn near(gap: &Gap<'_>) -> Self {
        let [p, q] = gap.degrees;
        let at = |i: usize, j: usize| gap.at(i * (q + 1) + j);
        // The mean of differences is one of ends.
        let along = |degree: usize, across: usize, at: &dyn Fn(usize, usize) -> f64| {
            let (mut slope, mut second) = (0.0, 0.0);
            if degree > 0 {
                for j in 0..=across {
                    slope += at(degree, j) - at(0, j);
                    second += (at(degree, j) - at(degree - 1, j)) - (at(1, j) - at(0, j));
                }
            }
            let lines = (across + 1) as f64;
            (slope / lines, degree as f64 * second / lines)
        };
        let (u, uu) = along(p, q, &at);
        let (v, vv) = along(q, p, &|i, j| at(j, i));
        let uv = (at(p, q) - at(p, 0)) - (at(0, q) - at(0, 0));
        Self { slopes: [u - 0.5 * (uu + uv), v - 0.5 * (uv + vv)], seconds: [uu, uv, vv] }
    }

    /// A lower one whose determinant is not positive if it was next to zero: its least value is at the border.
    fn tamed(mut self) -> Self {
        let [uu, uv, vv] = self.seconds;
        if uu > 0.0 && vv > 0.0 && uu * vv - uv * uv <= SINGULAR * uu * vv {
            let lowered = |other: f64, own: f64| own.min(uv * uv / other * (1.0 - 4.0 * f64::EPSILON));
            let axis = if uu > vv { 2 } else { 0 };
            self.seconds[axis] = lowered(self.seconds[2 - axis], self.seconds[axis]);
        }
        self
    }

    fn at(&self, [u, v]: [f64; 2]) -> f64 {
        let [uu, uv, vv] = self.seconds;
        u * (self.slopes[0] + 0.5 * uu * u + uv * v) + v * (self.slopes[1] + 0.5 * vv * v)
    }

    /// The least value on the unit square.
    fn least(&self) -> f64 {
        let ([s, t], [uu, uv, vv]) = (self.slopes, self.seconds);
        let lowest = |slope: f64, second: f64| {
            let vertex = if second > 0.0 { (-slope / second).clamp(0.0, 1.0) } else { 0.0 };
            [0.0, vertex, 1.0]
        };
        let along_u = [0.0, 1.0].map(|v| lowest(s + uv * v, uu).map(|u| [u, v]));
        let along_v = [0.0, 1.0].map(|u| lowest(t + uv * u, vv).map(|v| [u, v]));
        let border = along_u.into_iter().chain(along_v).flatten().map(|x| self.at(x));
        let least = border.fold(f64::INFINITY, f64::min);
        let determinant = uu * vv - uv * uv;
        if uu > 0.0 && determinant > 0.0 {
            let vertex = [(uv * t - vv * s) / determinant, (uv * s - uu * t) / determinant];
            if vertex.iter().all(|x| (0.0..=1.0).contains(x)) {
                return least.min(self.at(vertex));
            }
        }
        least
    }

    fn size(&self) -> f64 {
        self.slopes.iter().chain(&self.seconds).map(|x| x.abs()).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `G` of degree 2 or 3 in each direction, by its coefficients.
    fn gap(points: &[f64], degrees: [usize; 2]) -> Gap<'_> {
        Gap { points, weights: &[], degrees, square: 0.0 }
    }

    fn quadratic(slopes: [f64; 2], seconds: [f64; 3]) -> Quadratic {
        Quadratic { slopes, seconds }
    }

    fn coefficients(q: &Quadratic, degrees: [usize; 2]) -> Vec<f64> {
        let (line, column) = (squares(degrees[0]), squares(degrees[1]));
        let each = |i: usize, j: usize| {
            let ((u, uu), (v, vv)) = (line(i), column(j));
            let [h, k, l] = q.seconds;
            q.slopes[0] * u + q.slopes[1] * v + 0.5 * h * uu + k * u * v + 0.5 * l * vv
        };
        let rows = (0..=degrees[0]).flat_map(|i| (0..=degrees[1]).map(move |j| (i, j)));
        rows.map(|(i, j)| each(i, j)).collect()
    }

    #[test]
    fn quadratics_have_their_minimum() {
        // (u - v)², (u + v - 1)², (u - 1/4)² + (v - 1/2)², u v - u, u².
        let cases = [
            (quadratic([0.0, 0.0], [2.0, -2.0, 2.0]), 0.0),
            (quadratic([-2.0, -2.0], [2.0, 2.0, 2.0]), -1.0),
            (quadratic([-0.5, -1.0], [2.0, 0.0, 2.0]), -0.3125),
            (quadratic([-1.0, 0.0], [0.0, 1.0, 0.0]), -1.0),
            (quadratic([0.0, 0.0], [2.0, 0.0, 0.0]), 0.0),
        ];
        for (q, least) in cases {
            for degrees in [[2, 2], [4, 2], [3, 6]] {
                let coefficients = coefficients(&q, degrees);
                assert!((gap(&coefficients, degrees).least(0.0) - least).abs() < 1e-13, "{q:?} {degrees:?}");
            }
        }
    }

    #[test]
    fn parabolas_have_their_minimum() {
        // (x - 1/4)², of one direction.
        for degrees in [[2, 0], [0, 2]] {
            assert!((gap(&[0.0, -0.25, 0.5], degrees).least(0.0) + 0.0625).abs() < 1e-13);
        }
        assert_eq!(gap(&[3.0], [0, 0]).least(1.0), 2.0);
        let far = Gap { square: 5.0, ..gap(&[3.0], [0, 0]) };
        assert_eq!(far.least(1.0), -3.0);
        assert_eq!(Gap { weights: &[1.0], ..far }.least(1.0), -3.0);
    }

    #[test]
    fn nothing_is_below_the_bound() {
        let entry = |k: usize| (1.7 * (k * k) as f64).sin();
        for shift in 0..50 {
            let points: Vec<f64> = (0..20).map(|k| entry(k + shift)).collect();
            let bound = gap(&points, [3, 4]).least(0.0);
            assert!(bound <= [0, 4, 15, 19].map(|corner| points[corner]).into_iter().fold(9.0, f64::min));
            let value = |u: f64, v: f64| -> f64 {
                let basis = |n: usize, i: usize, x: f64| {
                    let binomial: f64 = (0..i).map(|l| (n - l) as f64 / (l + 1) as f64).product();
                    binomial * x.powi(i as i32) * (1.0 - x).powi((n - i) as i32)
                };
                (0..20).map(|k| points[k] * basis(3, k / 5, u) * basis(4, k % 5, v)).sum()
            };
            let sampled = (0..=400).map(|k| value(f64::from(k / 20) / 20.0, f64::from(k % 20) / 20.0));
            assert!(bound <= sampled.fold(f64::INFINITY, f64::min));
        }
    }
}
