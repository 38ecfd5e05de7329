//! The Bezier points of a cubic with simple knots, in closed form, and the power form of the pieces.
//!
//! Leg `j` of the polygon, from `f(z, a, b)` to `f(a, b, c)`, carries the two inner Bezier points of the span
//! `[a, b]`, at `a` and `b` of `[z, c]`; the points at the breaks lie between inner ones.

use crate::bounds::{Lanes, lanes};

/// The four Bezier points of every span.
pub fn bezier(t: &[f64], c: &[Lanes]) -> Vec<[Lanes; 4]> {
    let spans = c.len() - 3;
    let inner = |j: usize| {
        let slope = 1.0 / (t[j + 4] - t[j + 1]);
        let [at_a, at_b] = [t[j + 2], t[j + 3]].map(|x| (x - t[j + 1]) * slope);
        let leg = |s: f64| lanes(|l| c[j][l] + s * (c[j + 1][l] - c[j][l]));
        [leg(at_a), leg(at_b)]
    };
    let mut pieces = Vec::with_capacity(spans);
    let (mut start, mut here) = (c[0], inner(1));
    for j in 1..=spans {
        let (next, end) = if j < spans {
            let next = inner(j + 1);
            let s = (t[j + 3] - t[j + 2]) / (t[j + 4] - t[j + 2]);
            (next, lanes(|l| here[1][l] + s * (next[0][l] - here[1][l])))
        } else {
            (here, c[spans + 2])
        };
        pieces.push([start, here[0], here[1], end]);
        (start, here) = (end, next);
    }
    pieces
}

/// The coefficients of the powers of `x - a` of a cubic on `[a, a + h]`.
#[inline(always)]
pub fn powers(b: [Lanes; 4], h: f64) -> [Lanes; 4] {
    let r = 1.0 / h;
    let first = lanes(|l| 3.0 * (b[1][l] - b[0][l]) * r);
    let second = lanes(|l| 3.0 * (b[2][l] - 2.0 * b[1][l] + b[0][l]) * (r * r));
    let third = lanes(|l| (b[3][l] - 3.0 * (b[2][l] - b[1][l]) - b[0][l]) * (r * r * r));
    [b[0], first, second, third]
}
