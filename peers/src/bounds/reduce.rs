//! A quartic with double knots that is an elevated cubic, back to the cubic, in one pass, with the residual.
//!
//! `f(b, b, c, c)` and its neighbours are means of points on legs of the cubic (see `elevate.rs`): three of them
//! determine `f(a, b, c)` with weights of alternating signs, `-1/4, 3/2, -1/4` for even knots.

use crate::bounds::plain::{Plain, point};

/// The cubic and the largest residual.
pub fn reduce(f: &Plain) -> (Plain, f64) {
    let (t, q) = (&f.knots, &f.points);
    let spans = (q.len() - 3) / 2;
    let last = q.len() - 1;
    let mut points = Vec::with_capacity(spans + 3);
    let mut knots = Vec::with_capacity(spans + 7);
    // Break `k` is `t[4 + 2 k]`, the last one too.
    knots.extend([t[0]; 4]);
    knots.extend((1..spans).map(|k| t[4 + 2 * k]));
    knots.extend([t[t.len() - 1]; 4]);
    points.push(q[0]);
    points.push(point(|l| (4.0 * q[1][l] - q[0][l]) * (1.0 / 3.0)));
    for j in 1..spans {
        let [a, b, c] = [knots[j + 2], knots[j + 3], knots[j + 4]];
        let left = (c - b) / (c - 0.5 * (a + b));
        let right = (b - a) / (0.5 * (b + c) - a);
        let whole = 1.0 / (4.0 - left - right);
        points
            .push(point(|l| whole * (4.0 * q[2 * j + 1][l] - left * q[2 * j][l] - right * q[2 * j + 2][l])));
    }
    points.push(point(|l| (4.0 * q[last - 1][l] - q[last][l]) * (1.0 / 3.0)));
    points.push(q[last]);

    let mut most: [f64; 3] = [0.0; 3];
    for j in 1..=spans {
        let (z, c) = (knots[j + 1], knots[j + 4]);
        let s = (0.5 * (knots[j + 2] + knots[j + 3]) - z) / (c - z);
        for l in 0..3 {
            let on_leg = points[j][l] + s * (points[j + 1][l] - points[j][l]);
            most[l] = most[l].max((on_leg - q[2 * j][l]).abs());
        }
    }
    (Plain { degree: 3, knots, points }, most[0].max(most[1]).max(most[2]))
}
