//! Removal of every second knot of a cubic with simple knots, known to be superfluous, in one pass, with the residual.
//!
//! `f(a, b, c)` is extrapolated from the three fine coefficients `f(a, m, b)`, `f(m, b, n)`, `f(b, n, c)` around it;
//! what the coarse legs say of `f(a, m, b)` is compared with it.

use crate::bounds::plain::{Plain, point};

/// The coarse spline and the largest residual.
pub fn remove(f: &Plain) -> (Plain, f64) {
    let (t, q) = (&f.knots, &f.points);
    let spans = (q.len() - 3) / 2;
    let last = t.len() - 1;
    // Breaks of the coarse spline are `t[3 + 2 k]`, the middles in between `t[4 + 2 k]`.
    let mut points = Vec::with_capacity(spans + 3);
    let mut knots = Vec::with_capacity(spans + 7);
    knots.extend([t[0]; 4]);
    points.push(q[0]);
    let s = (t[5] - t[3]) / (t[4] - t[3]);
    points.push(point(|l| q[0][l] + s * (q[1][l] - q[0][l])));
    for k in 1..spans {
        let i = 2 * k;
        let [a, m, b, n, c] = [t[i + 1], t[i + 2], t[i + 3], t[i + 4], t[i + 5]];
        let (s, r) = ((c - a) / (n - a), (m - a) / (n - m));
        points.push(point(|l| {
            let along = q[i][l] + s * (q[i + 1][l] - q[i][l]);
            along - r * (q[i + 2][l] - along)
        }));
        knots.push(b);
    }
    let s = (t[last] - t[last - 5]) / (t[last] - t[last - 4]);
    let n = q.len() - 1;
    points.push(point(|l| q[n][l] + s * (q[n - 1][l] - q[n][l])));
    points.push(q[n]);
    knots.extend([t[last]; 4]);

    let mut most: [f64; 3] = [0.0; 3];
    for j in 1..=spans {
        let (z, m, c) = (knots[j + 1], t[2 * j + 2], knots[j + 4]);
        let s = (m - z) / (c - z);
        for l in 0..3 {
            let on_leg = points[j][l] + s * (points[j + 1][l] - points[j][l]);
            most[l] = most[l].max((on_leg - q[2 * j][l]).abs());
        }
    }
    (Plain { degree: 3, knots, points }, most[0].max(most[1]).max(most[2]))
}
