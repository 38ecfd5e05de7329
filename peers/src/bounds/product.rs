//! Products of two functions over the same simple knots: the Bernstein products alone, and all of it.
//!
//! The product of two cubics has degree 6 and knots of multiplicity 4: of each span it takes the Bernstein coefficients
//! 2, 3, 4 as they are, and `f(a, b, b, b, b, c)` by extrapolation from the wider of the two spans beside `b`. The
//! product of two quadratics has degree 4 and knots of multiplicity 3: the inner Bernstein coefficients of all spans.

/// Degree, knots and coefficients of a function.
#[derive(Clone, Debug)]
pub struct Scalars {
    pub degree: usize,
    pub knots: Vec<f64>,
    pub coeffs: Vec<f64>,
}

/// The Bernstein coefficients of all spans of a cubic with simple knots.
pub fn cubic_pieces(t: &[f64], c: &[f64]) -> Vec<[f64; 4]> {
    let mut pieces = Vec::with_capacity(c.len() - 3);
    let (mut start, mut here) = (c[0], cubic_leg(t, c, 1));
    for j in 1..=c.len() - 3 {
        let (end, next) = cubic_end(t, c, j, here);
        pieces.push([start, here[0], here[1], end]);
        (start, here) = (end, next);
    }
    pieces
}

#[inline(always)]
fn cubic_leg(t: &[f64], c: &[f64], j: usize) -> [f64; 2] {
    let slope = (c[j + 1] - c[j]) / (t[j + 4] - t[j + 1]);
    [c[j] + (t[j + 2] - t[j + 1]) * slope, c[j] + (t[j + 3] - t[j + 1]) * slope]
}

/// The value at the end of span `j`, and the leg of the next one.
#[inline(always)]
fn cubic_end(t: &[f64], c: &[f64], j: usize, here: [f64; 2]) -> (f64, [f64; 2]) {
    if j == c.len() - 3 {
        return (c[c.len() - 1], here);
    }
    let next = cubic_leg(t, c, j + 1);
    let s = (t[j + 3] - t[j + 2]) / (t[j + 4] - t[j + 2]);
    (here[1] + s * (next[0] - here[1]), next)
}

/// The Bernstein coefficients of all spans of a quadratic with simple knots.
pub fn quadratic_pieces(t: &[f64], c: &[f64]) -> Vec<[f64; 3]> {
    let mut start = c[0];
    let piece = |j: usize| {
        let end = quadratic_end(t, c, j);
        let piece = [start, c[j], end];
        start = end;
        piece
    };
    (1..c.len() - 1).map(piece).collect()
}

#[inline(always)]
fn quadratic_end(t: &[f64], c: &[f64], j: usize) -> f64 {
    let s = (t[j + 2] - t[j + 1]) / (t[j + 3] - t[j + 1]);
    c[j] + s * (c[j + 1] - c[j])
}

#[inline(always)]
fn times_cubic(a: [f64; 4], b: [f64; 4]) -> [f64; 7] {
    let ([a0, a1, a2, a3], [b0, b1, b2, b3]) = (a, b);
    [
        a0 * b0,
        0.5 * (a0 * b1 + a1 * b0),
        0.2 * (a0 * b2 + a2 * b0) + 0.6 * (a1 * b1),
        0.05 * (a0 * b3 + a3 * b0) + 0.45 * (a1 * b2 + a2 * b1),
        0.2 * (a1 * b3 + a3 * b1) + 0.6 * (a2 * b2),
        0.5 * (a2 * b3 + a3 * b2),
        a3 * b3,
    ]
}

#[inline(always)]
fn times_quadratic([a0, a1, a2]: [f64; 3], [b0, b1, b2]: [f64; 3]) -> [f64; 5] {
    let middle = (a0 * b2 + a2 * b0 + 4.0 * (a1 * b1)) * (1.0 / 6.0);
    [a0 * b0, 0.5 * (a0 * b1 + a1 * b0), middle, 0.5 * (a1 * b2 + a2 * b1), a2 * b2]
}

/// The Bernstein products of pieces at hand.
pub fn multiply_cubic(f: &[[f64; 4]], g: &[[f64; 4]]) -> Vec<[f64; 7]> {
    f.iter().zip(g).map(|(f, g)| times_cubic(*f, *g)).collect()
}

/// The Bernstein products of pieces at hand.
pub fn multiply_quadratic(f: &[[f64; 3]], g: &[[f64; 3]]) -> Vec<[f64; 5]> {
    f.iter().zip(g).map(|(f, g)| times_quadratic(*f, *g)).collect()
}

/// From coefficients to coefficients, in one pass.
pub fn cubic(t: &[f64], f: &[f64], g: &[f64]) -> Scalars {
    let spans = f.len() - 3;
    let mut coeffs = Vec::with_capacity(4 * spans + 3);
    let mut knots = Vec::with_capacity(4 * spans + 10);
    knots.extend([t[0]; 7]);
    coeffs.push(f[0] * g[0]);
    let (mut f_start, mut f_here) = (f[0], cubic_leg(t, f, 1));
    let (mut g_start, mut g_here) = (g[0], cubic_leg(t, g, 1));
    coeffs.push(0.5 * (f_start * g_here[0] + f_here[0] * g_start));
    for j in 1..=spans {
        let ((f_end, f_next), (g_end, g_next)) = (cubic_end(t, f, j, f_here), cubic_end(t, g, j, g_here));
        let [_, _, c2, c3, c4, c5, c6] =
            times_cubic([f_start, f_here[0], f_here[1], f_end], [g_start, g_here[0], g_here[1], g_end]);
        if j < spans {
            let [a, b, c] = [t[j + 2], t[j + 3], t[j + 4]];
            let corner = if b - a >= c - b {
                c4 + (c - a) / (b - a) * (c5 - c4)
            } else {
                let c1 = 0.5 * (f_end * g_next[0] + f_next[0] * g_end);
                let c2 = 0.2 * (f_end * g_next[1] + f_next[1] * g_end) + 0.6 * (f_next[0] * g_next[0]);
                c2 + (a - c) / (b - c) * (c1 - c2)
            };
            coeffs.extend([c2, c3, c4, corner]);
            knots.extend([b; 4]);
        } else {
            coeffs.extend([c2, c3, c4, c5, c6]);
        }
        (f_start, f_here, g_start, g_here) = (f_end, f_next, g_end, g_next);
    }
    knots.extend([t[t.len() - 1]; 7]);
    Scalars { degree: 6, knots, coeffs }
}

/// From coefficients to coefficients, in one pass.
pub fn quadratic(t: &[f64], f: &[f64], g: &[f64]) -> Scalars {
    let spans = f.len() - 2;
    let mut coeffs = Vec::with_capacity(3 * spans + 2);
    let mut knots = Vec::with_capacity(3 * spans + 7);
    knots.extend([t[0]; 5]);
    coeffs.push(f[0] * g[0]);
    let (mut f_start, mut g_start) = (f[0], g[0]);
    for j in 1..=spans {
        let [f_end, g_end] =
            if j < spans { [f, g].map(|c| quadratic_end(t, c, j)) } else { [f, g].map(|c| c[spans + 1]) };
        let [_, c1, c2, c3, _] = times_quadratic([f_start, f[j], f_end], [g_start, g[j], g_end]);
        coeffs.extend([c1, c2, c3]);
        if j < spans {
            knots.extend([t[j + 2]; 3]);
        }
        (f_start, g_start) = (f_end, g_end);
    }
    coeffs.push(f_start * g_start);
    knots.extend([t[t.len() - 1]; 5]);
    Scalars { degree: 4, knots, coeffs }
}
