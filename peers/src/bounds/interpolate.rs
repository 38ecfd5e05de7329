//! The cubic through points at their chord lengths: a banded system, eliminated without a search for pivots, which
//! total positivity allows.

use crate::bounds::direct::basis;
use crate::bounds::plain::{Plain, point};
use crate::data::Point;

pub fn interpolate(data: &[Point]) -> Plain {
    let n = data.len();
    let mut u = Vec::with_capacity(n);
    u.push(0.0);
    for pair in data.windows(2) {
        let [x, y, z] = point(|l| pair[1][l] - pair[0][l]);
        u.push(u[u.len() - 1] + (x * x + y * y + z * z).sqrt());
    }
    let scale = 1.0 / u[n - 1];
    u.iter_mut().for_each(|x| *x *= scale);
    u[n - 1] = 1.0;
    let mut t = Vec::with_capacity(n + 4);
    t.extend([0.0; 4]);
    t.extend((1..n - 3).map(|i| (u[i] + u[i + 1] + u[i + 2]) * (1.0 / 3.0)));
    t.extend([1.0; 4]);

    // Row `i` holds the columns `i - 3 ..= i + 3`.
    let mut rows = vec![[0.0; 7]; n];
    let mut points = data.to_vec();
    let mut k = 3;
    for i in 0..n {
        while k < n - 1 && t[k + 1] <= u[i] {
            k += 1;
        }
        let weights = basis(&t, k, u[i]);
        (0..4).for_each(|r| rows[i][k + r - i] = weights[r]);
    }
    for i in 0..n {
        let (pivot, right) = (rows[i], points[i]);
        let inverse = 1.0 / pivot[3];
        for below in 1..4.min(n - i) {
            let factor = rows[i + below][3 - below] * inverse;
            (0..4).for_each(|r| rows[i + below][3 - below + r] -= factor * pivot[3 + r]);
            (0..3).for_each(|l| points[i + below][l] -= factor * right[l]);
        }
        rows[i][3] = inverse;
    }
    for i in (0..n).rev() {
        let mut sum = points[i];
        for right in 1..4.min(n - i) {
            (0..3).for_each(|l| sum[l] -= rows[i][3 + right] * points[i + right][l]);
        }
        points[i] = point(|l| sum[l] * rows[i][3]);
    }
    Plain { degree: 3, knots: t, points }
}
