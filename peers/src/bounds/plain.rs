//! A spline as two lists, and the operators that are one loop over them: derivative, antiderivative, Bezier pieces.

use crate::data::Point;

/// Degree, knots and coefficients, checked by nobody.
#[derive(Clone, Debug)]
pub struct Plain {
    pub degree: usize,
    pub knots: Vec<f64>,
    pub points: Vec<Point>,
}

#[inline(always)]
pub fn point(term: impl FnMut(usize) -> f64) -> Point {
    std::array::from_fn(term)
}

/// `p (c_{j+1} - c_j) / (t_{j+p+1} - t_{j+1})`.
pub fn derivative(f: &Plain) -> Plain {
    let (t, p) = (&f.knots, f.degree);
    let legs = f.points.windows(2).zip(t[1..].iter().zip(&t[p + 1..]));
    let slopes = legs.map(|(leg, (a, b))| {
        let factor = p as f64 / (b - a);
        point(|l| factor * (leg[1][l] - leg[0][l]))
    });
    Plain { degree: p - 1, points: slopes.collect(), knots: t[1..t.len() - 1].to_vec() }
}

/// The running sum of `c_j (t_{j+p+1} - t_j) / (p + 1)`.
pub fn antiderivative(f: &Plain) -> Plain {
    let (t, p) = (&f.knots, f.degree);
    let share = 1.0 / (p + 1) as f64;
    let (mut sum, mut points) = ([0.0; 3], Vec::with_capacity(f.points.len() + 1));
    points.push(sum);
    points.extend(f.points.iter().zip(t.iter().zip(&t[p + 1..])).map(|(c, (a, b))| {
        let width = (b - a) * share;
        sum = point(|l| sum[l] + width * c[l]);
        sum
    }));
    let mut knots = Vec::with_capacity(t.len() + 2);
    knots.push(t[0]);
    knots.extend_from_slice(t);
    knots.push(t[t.len() - 1]);
    Plain { degree: p + 1, knots, points }
}

/// All Bezier pieces of a cubic with simple knots as one list of points; knots have multiplicity 4.
pub fn split(f: &Plain) -> Plain {
    let (t, c) = (&f.knots, &f.points);
    let spans = c.len() - 3;
    let inner = |j: usize| {
        let slope = 1.0 / (t[j + 4] - t[j + 1]);
        [t[j + 2], t[j + 3]].map(|x| {
            let s = (x - t[j + 1]) * slope;
            point(|l| c[j][l] + s * (c[j + 1][l] - c[j][l]))
        })
    };
    let mut points = Vec::with_capacity(4 * spans);
    let mut knots = Vec::with_capacity(4 * spans + 4);
    knots.extend([t[0]; 4]);
    let (mut start, mut here) = (c[0], inner(1));
    for j in 1..spans {
        let (next, s) = (inner(j + 1), (t[j + 3] - t[j + 2]) / (t[j + 4] - t[j + 2]));
        let end = point(|l| here[1][l] + s * (next[0][l] - here[1][l]));
        points.extend([start, here[0], here[1], end]);
        knots.extend([t[j + 3]; 4]);
        (start, here) = (end, next);
    }
    points.extend([start, here[0], here[1], c[spans + 2]]);
    knots.extend([t[t.len() - 1]; 4]);
    Plain { degree: 3, knots, points }
}
