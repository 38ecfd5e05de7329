//! A knot in the middle of each span of a cubic with simple knots, all in one pass.
//!
//! With middles `m, n` of `[a, b]` and `[b, c]`: `f(a, m, b)` is on one leg; `f(m, b, n)` lies between `f(a, b, n)` and
//! `f(b, n, c)`, which are on two legs.

use crate::bounds::plain::{Plain, point};
use crate::data::Point;

pub fn refine(f: &Plain) -> Plain {
    let (t, c) = (&f.knots, &f.points);
    let spans = c.len() - 3;
    // The slope of leg `j`, which goes from the knot `t_{j+1}` to `t_{j+4}`.
    let slope = |j: usize| -> Point {
        let factor = 1.0 / (t[j + 4] - t[j + 1]);
        point(|l| factor * (c[j + 1][l] - c[j][l]))
    };
    let middle = |j: usize| 0.5 * (t[j + 2] + t[j + 3]);
    let mut points = Vec::with_capacity(2 * spans + 3);
    let mut knots = Vec::with_capacity(2 * spans + 7);
    knots.extend([t[0]; 4]);
    let (mut m, mut here) = (middle(1), slope(1));
    let first = slope(0);
    points.push(c[0]);
    points.push(point(|l| c[0][l] + (m - t[1]) * first[l]));
    for j in 1..spans {
        let (n, next) = (middle(j + 1), slope(j + 1));
        let (z, a, b, d) = (t[j + 1], t[j + 2], t[j + 3], t[j + 4]);
        let share = (m - a) / (d - a);
        points.push(point(|l| c[j][l] + (m - z) * here[l]));
        points.push(point(|l| {
            let left = c[j][l] + (n - z) * here[l];
            let right = c[j + 1][l] + (n - a) * next[l];
            left + share * (right - left)
        }));
        knots.extend([m, b]);
        (m, here) = (n, next);
    }
    let last = slope(spans + 1);
    points.push(point(|l| c[spans][l] + (m - t[spans + 1]) * here[l]));
    points.push(point(|l| c[spans + 1][l] + (m - t[spans + 2]) * last[l]));
    points.push(c[spans + 2]);
    knots.push(m);
    knots.extend([t[t.len() - 1]; 4]);
    Plain { degree: 3, knots, points }
}
