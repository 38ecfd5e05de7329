//! Bernstein coefficients of `|A|²` and of `w²`, and what those of `G = |A|² - r² w²` tell.
//!
//! With the binomial factors in the coefficients a product of Bernstein polynomials is one of polynomials:
//!
//! ```text
//! C(2p, k) a_k = Σ_{i+j=k} C(p, i) A_i · C(p, j) A_j
//! ```

use crate::analysis::nearest::split::count;
use crate::coeff::Coeff;

/// Binomial factors of one degree, in a size that keeps the highest degree in the range of numbers.
#[derive(Clone, Debug)]
struct Factors {
    /// `C(p, i) 2^(-p/2)`
    single: Vec<f64>,
    /// `1 / (C(2p, k) 2^-p)`
    double: Vec<f64>,
}

impl Factors {
    fn new(degree: usize) -> Self {
        let root = (-0.5 * degree as f64).exp2();
        let single = scaled_binomials(degree, root);
        // Times the square of the root as it was rounded, so that constants stay constant.
        let double = scaled_binomials(2 * degree, root * root).iter().map(|c| 1.0 / c).collect();
        Self { single, double }
    }
}

/// `C(n, k) scale` for all `k`.
fn scaled_binomials(n: usize, scale: f64) -> Vec<f64> {
    let next = |c: f64, k: usize| c * (n - k) as f64 / (k + 1) as f64;
    let mut row = vec![scale; n + 1];
    // From both ends: a row is symmetric.
    for k in 1..=n / 2 {
        row[k] = next(row[k - 1], k - 1);
        row[n - k] = row[k];
    }
    row
}

/// Makes squares of polynomials whose degree in each direction is the whole one or 0.
#[derive(Clone, Debug)]
pub(super) struct Squaring {
    factors: [[Factors; 2]; 2],
}

impl Squaring {
    pub(super) fn new(degrees: [usize; 2]) -> Self {
        Self { factors: degrees.map(|p| [Factors::new(0), Factors::new(p)]) }
    }

    /// The Bernstein coefficients of the square of the polynomial with `coeffs` under the pairing `dot`, into
    /// `squares`.
    pub(super) fn square<C: Coeff<f64>>(
        &self,
        coeffs: &[C],
        degrees: [usize; 2],
        raised: &mut Vec<C>,
        squares: &mut Vec<f64>,
        dot: impl Fn(&C, &C) -> f64,
    ) {
        let [p, q] = degrees;
        let of = |axis: usize| &self.factors[axis][usize::from(degrees[axis] > 0)];
        let (u, v) = (of(0), of(1));
        raised.clear();
        raised.extend_from_slice(coeffs);
        squares.clear();
        squares.resize(count([2 * p, 2 * q]), 0.0);
        if q == 0 {
            raised.iter_mut().zip(&u.single).for_each(|(c, factor)| c.scale(factor));
            for (i, c) in raised.iter().enumerate() {
                squares[2 * i] += dot(c, c);
                for (square, d) in squares[2 * i + 1..].iter_mut().zip(&raised[i + 1..]) {
                    *square += 2.0 * dot(c, d);
                }
            }
            squares.iter_mut().zip(&u.double).for_each(|(square, factor)| *square *= factor);
            return;
        }
        for (row, along) in raised.chunks_exact_mut(q + 1).zip(&u.single) {
            row.iter_mut().zip(&v.single).for_each(|(c, across)| c.scale(&(along * across)));
        }
        let width = 2 * q + 1;
        for i in 0..=p {
            for j in 0..=q {
                let c = &raised[i * (q + 1) + j];
                squares[2 * i * width + 2 * j] += dot(c, c);
                for (l, d) in (j + 1..=q).zip(&raised[i * (q + 1) + j + 1..]) {
                    squares[2 * i * width + j + l] += 2.0 * dot(c, d);
                }
                for k in i + 1..=p {
                    let start = (i + k) * width + j;
                    let row = &raised[k * (q + 1)..][..q + 1];
                    for (square, d) in squares[start..].iter_mut().zip(row) {
                        *square += 2.0 * dot(c, d);
                    }
                }
            }
        }
        for (row, along) in squares.chunks_exact_mut(width).zip(&u.double) {
            row.iter_mut().zip(&v.double).for_each(|(square, across)| *square *= along * across);
        }
    }
}

/// The polynomial `G` for one `r`, by the coefficients of both squares.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gap<'a> {
    /// Those of `|A|²`.
    pub(super) points: &'a [f64],
    /// Those of `w²`; none if the weight is one.
    pub(super) weights: &'a [f64],
    /// The degrees of both.
    pub(super) degrees: [usize; 2],
    /// `r²`
    pub(super) square: f64,
}

impl Gap<'_> {
    #[inline]
    pub(super) fn at(&self, k: usize) -> f64 {
        match self.weights.get(k) {
            Some(weight) => self.points[k] - self.square * weight,
            // A constant tells nothing about slopes.
            None => self.points[k],
        }
    }

    fn strides(&self) -> [usize; 2] {
        [self.degrees[1] + 1, 1]
    }

    /// Least and greatest coefficient of the derivative along `axis`.
    pub(super) fn slopes(&self, axis: usize) -> (f64, f64) {
        let (stride, p) = (self.strides()[axis], self.degrees[axis] as f64);
        let mut range = (f64::INFINITY, f64::NEG_INFINITY);
        self.for_each([usize::from(axis == 0), usize::from(axis == 1)], |k| {
            let step = self.at(k + stride) - self.at(k);
            range = (range.0.min(step), range.1.max(step));
        });
        (p * range.0, p * range.1)
    }

    /// First and last slope of a polynomial of one direction, `axis`.
    pub(super) fn end_slopes(&self, axis: usize) -> Option<(f64, f64)> {
        let p = self.degrees[axis];
        let slope = |k: usize| self.at(k + 1) - self.at(k);
        (p > 0 && self.degrees[1 - axis] == 0).then(|| (slope(0), slope(p - 1)))
    }

    /// Whether no coefficient is positive.
    pub(super) fn is_nowhere_positive(&self) -> bool {
        let weight = |k: usize| self.weights.get(k).copied().unwrap_or(1.0);
        self.points.iter().enumerate().all(|(k, a)| *a <= self.square * weight(k))
    }

    /// A number that the second derivatives in all directions are not below, less `noise` a coefficient.
    pub(super) fn bend(&self, noise: f64) -> f64 {
        let [p, q] = self.degrees.map(|p| p as f64);
        let least = |axis: usize| {
            let stride = self.strides()[axis];
            let mut least = f64::INFINITY;
            let reach = [2 * usize::from(axis == 0), 2 * usize::from(axis == 1)];
            self.for_each(reach, |k| {
                least = least.min(self.at(k + 2 * stride) - 2.0 * self.at(k + stride) + self.at(k));
            });
            let p = self.degrees[axis] as f64;
            p * (p - 1.0) * (least - 4.0 * noise)
        };
        match self.degrees {
            [0, _] => least(1),
            [_, 0] => least(0),
            _ => {
                let (uu, vv) = (least(0), least(1));
                if uu <= 0.0 || vv <= 0.0 {
                    return uu.min(vv);
                }
                let ([s, t], mut most) = (self.strides(), 0.0_f64);
                self.for_each([1, 1], |k| {
                    most =
                        most.max((self.at(k + s + t) - self.at(k + s) - self.at(k + t) + self.at(k)).abs());
                });
                let uv = p * q * (most + 4.0 * noise);
                // The smaller eigenvalue: determinant over the larger.
                let larger = 0.5 * (uu + vv) + (0.25 * (uu - vv) * (uu - vv) + uv * uv).sqrt();
                (uu * vv - uv * uv) / larger
            }
        }
    }

    /// Visits the coefficients that have another one `reach` further in each direction.
    #[inline]
    fn for_each(&self, reach: [usize; 2], mut visit: impl FnMut(usize)) {
        let [p, q] = self.degrees;
        for i in 0..=p - reach[0] {
            (0..=q - reach[1]).for_each(|j| visit(i * (q + 1) + j));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn squares(coeffs: &[f64], degrees: [usize; 2]) -> Vec<f64> {
        let (mut raised, mut squares) = (Vec::new(), Vec::new());
        Squaring::new(degrees).square(coeffs, degrees, &mut raised, &mut squares, |a, b| a * b);
        squares
    }

    #[test]
    fn the_square_of_a_parabola() {
        // (2 x - 1)² has the coefficients 1, -1, 1.
        let found = squares(&[-1.0, 1.0], [1, 0]);
        assert!(found.iter().zip([1.0, -1.0, 1.0]).all(|(x, y)| (x - y).abs() < 1e-15));
        // Its square is (2 x - 1)^4.
        let found = squares(&[1.0, -1.0, 1.0], [2, 0]);
        assert!(found.iter().zip([1.0, -1.0, 1.0, -1.0, 1.0]).all(|(x, y)| (x - y).abs() < 1e-15));
    }

    #[test]
    fn the_square_of_a_saddle() {
        let found = squares(&[1.0, -1.0, -1.0, 1.0], [1, 1]);
        let expected = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0];
        assert!(found.iter().zip(expected).all(|(x, y)| (x - y).abs() < 1e-15));
        let gap = Gap { points: &found, weights: &[], degrees: [2, 2], square: 0.0 };
        assert!(gap.bend(0.0) < 0.0);
        assert_eq!(gap.slopes(0), (-gap.slopes(0).1, gap.slopes(1).1));
    }

    #[test]
    fn bowls_are_convex() {
        // u² + v² + u v on the unit square: the second derivatives are 2, 1, 2, the smaller eigenvalue 1.
        let entry = |i: usize, j: usize| {
            let square = |i: usize| if i == 2 { 1.0 } else { 0.0 };
            square(i) + square(j) + 0.25 * (i * j) as f64
        };
        let bowl: Vec<f64> = (0..9).map(|k| entry(k / 3, k % 3)).collect();
        let gap = Gap { points: &bowl, weights: &[], degrees: [2, 2], square: 0.0 };
        assert!((gap.bend(0.0) - 1.0).abs() < 1e-14);
    }

    #[test]
    fn high_degrees_stay_in_range() {
        let found = squares(&vec![1.0; 513], [512, 0]);
        assert!(found.iter().all(|x| (x - 1.0).abs() < 1e-10));
    }
}
