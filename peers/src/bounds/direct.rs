//! Evaluation from knots and coefficients as they are: a binary search without branches and the basis functions.
//!
//! What a value takes at least when nothing is prepared.

use crate::bounds::plain::point;
use crate::data::Point;
use std::hint::select_unpredictable;

/// The four cubic basis functions on span `k`.
#[inline(always)]
pub fn basis(t: &[f64], k: usize, x: f64) -> [f64; 4] {
    let t: &[f64; 6] = t[k - 2..k + 4].try_into().expect("six knots");
    let [a, b, c, d, e, f] = *t;
    let r = 1.0 / (d - c);
    let (n0, n1) = ((d - x) * r, (x - c) * r);
    let (s0, s1) = (n0 / (d - b), n1 / (e - c));
    let (m0, m1, m2) = ((d - x) * s0, (x - b) * s0 + (e - x) * s1, (x - c) * s1);
    let (s0, s1, s2) = (m0 / (d - a), m1 / (e - b), m2 / (f - c));
    [(d - x) * s0, (x - a) * s0 + (e - x) * s1, (x - b) * s1 + (f - x) * s2, (x - c) * s2]
}

/// The span of `x` in clamped cubic knots.
#[inline(always)]
fn span(t: &[f64], x: f64) -> usize {
    let (mut k, mut size) = (3, t.len() - 7);
    while size > 1 {
        let half = size / 2;
        k = select_unpredictable(t[k + half] <= x, k + half, k);
        size -= half;
    }
    k
}

#[inline(always)]
fn weigh(n: [f64; 4], c: &[Point]) -> Point {
    let [c0, c1, c2, c3]: &[Point; 4] = c.try_into().expect("four points");
    point(|l| n[0] * c0[l] + n[1] * c1[l] + (n[2] * c2[l] + n[3] * c3[l]))
}

/// A point of a curve.
#[inline(always)]
pub fn curve(t: &[f64], c: &[Point], x: f64) -> Point {
    let k = span(t, x);
    weigh(basis(t, k, x), &c[k - 3..=k])
}

/// A point of a surface with the same knots in both directions, `side` points in a row.
#[inline(always)]
pub fn surface(t: &[f64], side: usize, c: &[Point], u: f64, v: f64) -> Point {
    let (k, l) = (span(t, u), span(t, v));
    let (left, right) = (basis(t, k, u), basis(t, l, v));
    let row = |i: usize| {
        let start = (k - 3 + i) * side + l - 3;
        weigh(right, &c[start..start + 4])
    };
    weigh(left, &[row(0), row(1), row(2), row(3)])
}
