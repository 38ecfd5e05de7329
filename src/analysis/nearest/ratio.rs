//! The slope of a rational squared distance `a / b`, with `a = |A|²` and `b = w²`:
//!
//! ```text
//! (a / b)' = (a' b - a b') / b²
//! ```
//!
//! The numerator says whether the distance grows whatever the distance is, which the gap `G` says for one distance
//! only. On a surface of revolution it vanishes about the axis. It costs more, so it is the last resort, in low
//! degrees.

use crate::analysis::nearest::split::count;
use crate::bernstein::binomials;

/// The highest degree for which slopes are made.
const HIGHEST: usize = 8;

/// Binomial coefficients for products of squares.
#[derive(Clone, Debug)]
pub(super) struct Slopes {
    rows: Vec<Vec<f64>>,
}

impl Slopes {
    /// For splines of these degrees, if they are low.
    pub(super) fn new(degrees: [usize; 2]) -> Option<Self> {
        let highest = degrees[0].max(degrees[1]);
        (highest <= HIGHEST).then(|| Self { rows: (0..=4 * highest).map(binomials).collect() })
    }

    /// Least and greatest coefficient of `a' b - a b'`, the derivatives along `axis`, of two polynomials of the same
    /// degrees.
    pub(super) fn range(&self, a: &[f64], b: &[f64], degrees: [usize; 2], axis: usize) -> (f64, f64) {
        let mut lower = degrees;
        lower[axis] -= 1;
        let (slope_a, slope_b) = (slope(a, degrees, axis), slope(b, degrees, axis));
        let mut sums = vec![0.0; count([degrees[0] + lower[0], degrees[1] + lower[1]])];
        self.add_product((&slope_a, lower), (b, degrees), 1.0, &mut sums);
        self.add_product((&slope_b, lower), (a, degrees), -1.0, &mut sums);
        let [p, q] = [degrees[0] + lower[0], degrees[1] + lower[1]];
        let mut range = (f64::INFINITY, f64::NEG_INFINITY);
        for (k, sum) in sums.iter().enumerate() {
            let value = sum / (self.rows[p][k / (q + 1)] * self.rows[q][k % (q + 1)]);
            range = (range.0.min(value), range.1.max(value));
        }
        range
    }

    /// Adds the products of coefficients with their binomial factors.
    fn add_product(&self, a: (&[f64], [usize; 2]), b: (&[f64], [usize; 2]), sign: f64, sums: &mut [f64]) {
        let raised = |(coeffs, [p, q]): (&[f64], [usize; 2])| -> Vec<f64> {
            let factor = |k: usize| self.rows[p][k / (q + 1)] * self.rows[q][k % (q + 1)];
            coeffs.iter().enumerate().map(|(k, c)| c * factor(k)).collect()
        };
        let (left, right, [q, s]) = (raised(a), raised(b), [a.1[1], b.1[1]]);
        for (i, x) in left.iter().enumerate() {
            for (row, line) in right.chunks_exact(s + 1).enumerate() {
                let start = (i / (q + 1) + row) * (q + s + 1) + i % (q + 1);
                let places = sums[start..].iter_mut();
                places.zip(line).for_each(|(sum, y)| *sum += sign * x * y);
            }
        }
    }
}

/// The coefficients of the derivative along `axis`.
fn slope(coeffs: &[f64], degrees: [usize; 2], axis: usize) -> Vec<f64> {
    let (width, p) = (degrees[1] + 1, degrees[axis] as f64);
    let stride = if axis == 0 { width } else { 1 };
    let inside = |k: &usize| axis == 0 || k % width < degrees[1];
    let last = coeffs.len() - stride;
    (0..last).filter(inside).map(|k| p * (coeffs[k + stride] - coeffs[k])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_of_quotients() {
        // a = u² v², b = u² on the unit square: a' b - a b' vanishes along u and is 2 u⁴ v along v.
        let squares = [0.0, 0.0, 1.0];
        let a: Vec<f64> = (0..9).map(|k| squares[k / 3] * squares[k % 3]).collect();
        let b: Vec<f64> = (0..9).map(|k| squares[k / 3]).collect();
        let slopes = Slopes::new([1, 1]).unwrap();
        assert_eq!(slopes.range(&a, &b, [2, 2], 0), (0.0, 0.0));
        assert_eq!(slopes.range(&a, &b, [2, 2], 1), (0.0, 2.0));
        assert!(Slopes::new([9, 1]).is_none());
    }
}
