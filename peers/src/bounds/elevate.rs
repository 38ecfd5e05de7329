//! Elevation of a cubic with simple knots by one degree, in closed form.
//!
//! A coefficient of the quartic is the mean of the four polar values that leave out one of its knots. With the inner
//! Bezier points `E = f(a, a, b)` and `F = f(a, b, b)` on each leg: `f(a, a, b, b) = (E + F) / 2` and
//! `f(a, b, b, c) = (F + 2 f(a, b, c) + E') / 4`. One division a leg.

use crate::bounds::plain::{Plain, point};

pub fn elevate(f: &Plain) -> Plain {
    let (t, c) = (&f.knots, &f.points);
    let spans = c.len() - 3;
    let inner = |j: usize| {
        let slope = 1.0 / (t[j + 4] - t[j + 1]);
        let [e, f] = [t[j + 2], t[j + 3]].map(|x| (x - t[j + 1]) * slope);
        let leg = point(|l| c[j + 1][l] - c[j][l]);
        [point(|l| c[j][l] + e * leg[l]), point(|l| c[j][l] + f * leg[l])]
    };
    let mut points = Vec::with_capacity(2 * spans + 3);
    let mut knots = Vec::with_capacity(2 * spans + 8);
    knots.extend([t[0]; 5]);
    points.push(c[0]);
    let mut here = inner(1);
    points.push(point(|l| 0.25 * (c[0][l] + 3.0 * c[1][l])));
    for j in 1..spans {
        let next = inner(j + 1);
        let middle = point(|l| 0.5 * (here[0][l] + here[1][l]));
        let corner = point(|l| 0.25 * (here[1][l] + 2.0 * c[j + 1][l] + next[0][l]));
        points.extend([middle, corner]);
        knots.extend([t[j + 3]; 2]);
        here = next;
    }
    points.push(point(|l| 0.5 * (here[0][l] + here[1][l])));
    points.push(point(|l| 0.25 * (3.0 * c[spans + 1][l] + c[spans + 2][l])));
    points.push(c[spans + 2]);
    knots.extend([t[t.len() - 1]; 5]);
    Plain { degree: 4, knots, points }
}
