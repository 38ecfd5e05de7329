//! A symmetric positive matrix of unknowns on a ring of which only neighbours meet, and how to solve with it.
//!
//! Places on the ring are taken in the order `0, m - 1, 1, m - 2, ...`. Then places up to two apart on the ring are up to
//! four apart in the order, so the matrix has a band without corners, and Cholesky's factor keeps it:
//!
//! ```text
//! A = L Lᵀ,   A_rc = 0 = L_rc   for |r - c| >= 5 N
//! ```
//! with `N` unknowns a place.

use nalgebra::SVector;

/// The largest distance in the order of places up to two apart on the ring.
const REACH: usize = 4;

/// Such a matrix, or its factor.
#[derive(Clone, Debug)]
pub(crate) struct RingMatrix {
    places: usize,
    size: usize,
    /// Row `r` has the entries of columns `r + 1 - width ..= r`.
    rows: Vec<f64>,
}

impl RingMatrix {
    /// The zero matrix for `places` on a ring with `size` unknowns each.
    pub(crate) fn zero(places: usize, size: usize) -> Self {
        Self { places, size, rows: vec![0.0; places * size * (REACH + 1) * size] }
    }

    fn width(&self) -> usize {
        (REACH + 1) * self.size
    }

    /// Sets all entries to zero, but those on the diagonal to `diagonal`.
    pub(crate) fn reset(&mut self, diagonal: f64) {
        let width = self.width();
        self.rows.fill(0.0);
        self.rows.iter_mut().skip(width - 1).step_by(width).for_each(|entry| *entry = diagonal);
    }

    /// Adds `value` to the diagonal at a place.
    pub(crate) fn add_diagonal(&mut self, place: usize, value: f64) {
        let (width, rank) = (self.width(), self.rank(place));
        (rank * self.size..(rank + 1) * self.size).for_each(|r| self.rows[(r + 1) * width - 1] += value);
    }

    /// Where place `i` stands in the order.
    fn rank(&self, i: usize) -> usize {
        if 2 * i < self.places { 2 * i } else { 2 * (self.places - 1 - i) + 1 }
    }

    /// Adds `w wᵀ` where `w` has the given values at some places, none more than two from another.
    pub(crate) fn add_square<const K: usize, const N: usize>(
        &mut self,
        places: [usize; K],
        values: [SVector<f64, N>; K],
    ) {
        let width = self.width();
        let ranks = places.map(|i| self.rank(i));
        for (rank, value) in ranks.iter().zip(&values) {
            for (other, factor) in ranks.iter().zip(&values) {
                if other > rank {
                    continue;
                }
                for a in 0..N {
                    let r = rank * N + a;
                    let last = if other == rank { a + 1 } else { N };
                    for b in 0..last {
                        self.rows[r * width + width - 1 + other * N + b - r] += value[a] * factor[b];
                    }
                }
            }
        }
    }

    /// Replaces the matrix by its factor `L`. A pivot that rounding made negative is replaced by its magnitude, one that it made
    /// too small by a small one: less than the magnitude, and rows would grow from one such pivot to the next.
    pub(crate) fn factor(&mut self) {
        const LEAST: f64 = 64.0 * f64::EPSILON;
        let width = self.width();
        let count = self.places * self.size;
        for r in 0..count {
            let low = (r + 1).saturating_sub(width);
            let (above, row) = self.rows.split_at_mut(r * width);
            // Entry (r, c) is `row[c + shift]`.
            let shift = width - 1 - r.min(width - 1);
            let row = &mut row[shift..width];
            for c in low..r {
                let theirs = &above[c * width..(c + 1) * width];
                let first = low.max((c + 1).saturating_sub(width));
                let offset = width - 1 + first - c;
                let mine = &row[first - low..c - low];
                let sum: f64 = mine.iter().zip(&theirs[offset..]).map(|(x, y)| x * y).sum();
                row[c - low] = (row[c - low] - sum) / theirs[width - 1];
            }
            let (before, pivot) = row.split_at_mut(r - low);
            let left = pivot[0] - before.iter().map(|x| x * x).sum::<f64>();
            pivot[0] = left.abs().max(LEAST * pivot[0]).sqrt();
        }
    }

    /// Solves `L Lᵀ z = g` for `g`, given place by place, and puts `z` there. `room` is overwritten.
    pub(crate) fn solve(&self, g: &mut [f64], room: &mut [f64]) {
        let (width, size) = (self.width(), self.size);
        for i in 0..self.places {
            let rank = self.rank(i);
            room[rank * size..(rank + 1) * size].copy_from_slice(&g[i * size..(i + 1) * size]);
        }
        for r in 0..room.len() {
            let low = (r + 1).saturating_sub(width);
            let row = &self.rows[r * width + width - 1 + low - r..(r + 1) * width];
            let (done, rest) = room.split_at_mut(r);
            let sum: f64 = row.iter().zip(&done[low..]).map(|(x, y)| x * y).sum();
            rest[0] = (rest[0] - sum) / row[r - low];
        }
        for r in (0..room.len()).rev() {
            let low = (r + 1).saturating_sub(width);
            let row = &self.rows[r * width + width - 1 + low - r..(r + 1) * width];
            let (rest, done) = room.split_at_mut(r);
            done[0] /= row[r - low];
            rest[low..].iter_mut().zip(row).for_each(|(x, y)| *x -= y * done[0]);
        }
        for i in 0..self.places {
            let rank = self.rank(i);
            g[i * size..(i + 1) * size].copy_from_slice(&room[rank * size..(rank + 1) * size]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};

    #[test]
    fn solutions_satisfy_the_system() {
        const N: usize = 2;
        for places in 1..12 {
            let mut matrix = RingMatrix::zero(places, N);
            let mut dense = DMatrix::<f64>::identity(places * N, places * N) * 0.5;
            matrix.reset(0.5);
            let value = |i: usize, k: usize| {
                SVector::<f64, N>::new((i * 7 + k) as f64 % 5.0 - 2.0, (i + 3 * k) as f64 % 3.0)
            };
            for i in 0..places {
                let at = [i, (i + 1) % places, (i + 2) % places];
                let values = [0, 1, 2].map(|k| value(i, k));
                if places > 2 {
                    matrix.add_square(at, values);
                    let mut w = DVector::zeros(places * N);
                    for (place, v) in at.iter().zip(&values) {
                        w.rows_mut(place * N, N).copy_from(v);
                    }
                    dense += &w * w.transpose();
                }
            }
            matrix.add_diagonal(0, 3.0);
            (0..N).for_each(|a| dense[(a, a)] += 3.0);
            matrix.factor();
            let g: Vec<f64> = (0..places * N).map(|k| (k * k % 7) as f64 - 3.0).collect();
            let (mut z, mut room) = (g.clone(), vec![9.0; places * N]);
            matrix.solve(&mut z, &mut room);
            let left = dense * DVector::from_vec(z) - DVector::from_vec(g);
            assert!(left.amax() < 1e-11, "{places}: {left}");
        }
    }

    #[test]
    fn singular_matrices_solve_to_finite_numbers() {
        let mut matrix = RingMatrix::zero(5, 1);
        matrix.reset(0.0);
        for i in 0..5 {
            matrix.add_square([i, (i + 1) % 5], [SVector::<f64, 1>::new(1.0), SVector::<f64, 1>::new(-1.0)]);
        }
        matrix.factor();
        let mut z = vec![1.0, -1.0, 2.0, -2.0, 0.0];
        matrix.solve(&mut z, &mut [0.0; 5]);
        assert!(z.iter().all(|x| x.is_finite()));
        assert!((2.0 * z[1] - z[0] - z[2] + 1.0).abs() < 1e-6);
    }

    #[test]
    fn pivots_lost_one_after_the_other_do_not_add_up() {
        // Stiff couplings without pattern: of most pivots rounding leaves nothing.
        for places in [8_usize, 40, 200] {
            let mut matrix = RingMatrix::zero(places, 2);
            matrix.reset(1e-6);
            for i in 0..places {
                let stiff = |k: usize| {
                    let [x, y] = [i * 7 + 3 * k, i * 5 + 11 * k].map(|n| (n * n % 17) as f64 - 8.0);
                    SVector::from([x, y]) * 10_f64.powi((i * i % 13) as i32)
                };
                let [near, far] = [stiff(1), stiff(2)];
                matrix.add_square([i, (i + 1) % places, (i + 2) % places], [near, -near - far, far]);
            }
            matrix.factor();
            assert!(matrix.rows.iter().all(|entry| entry.abs() < 1e20), "{places}");
            let (mut z, mut room) = (vec![1.0; 2 * places], vec![0.0; 2 * places]);
            matrix.solve(&mut z, &mut room);
            assert!(z.iter().all(|x| x.is_finite()), "{places}");
        }
    }
}
