//! De Casteljau's algorithm on rows of Bernstein coefficients that are short arrays of numbers.

/// Coefficients `start + i * stride` for `i = 0 ..= degree`, one row of a grid or a list.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    pub start: usize,
    pub stride: usize,
    pub degree: usize,
}

impl Line {
    /// The whole of a list.
    pub(crate) fn whole(count: usize) -> Self {
        Self { start: 0, stride: 1, degree: count - 1 }
    }

    fn at(&self, i: usize) -> usize {
        self.start + i * self.stride
    }
}

fn between<const K: usize>(a: &[f64; K], b: &[f64; K], x: f64) -> [f64; K] {
    std::array::from_fn(|k| (1.0 - x) * a[k] + x * b[k])
}

/// Replaces the coefficients by those over `[0, x]`.
fn keep_left<const K: usize>(c: &mut [[f64; K]], line: Line, x: f64) {
    for r in 1..=line.degree {
        for i in (r..=line.degree).rev() {
            c[line.at(i)] = between(&c[line.at(i - 1)], &c[line.at(i)], x);
        }
    }
}

/// Replaces the coefficients by those over `[x, 1]`.
fn keep_right<const K: usize>(c: &mut [[f64; K]], line: Line, x: f64) {
    for r in 1..=line.degree {
        for i in 0..=line.degree - r {
            c[line.at(i)] = between(&c[line.at(i)], &c[line.at(i + 1)], x);
        }
    }
}

/// Replaces the coefficients by those over `[a, b]`, which may reach a little beyond `[0, 1]`. The second of the two
/// cuts is a convex combination, and the first one too unless the interval reaches out.
pub(crate) fn restrict<const K: usize>(c: &mut [[f64; K]], line: Line, a: f64, b: f64) {
    if a < 0.5 {
        if a != 0.0 {
            keep_right(c, line, a);
        }
        if b != 1.0 {
            keep_left(c, line, (b - a) / (1.0 - a));
        }
    } else {
        if b != 1.0 {
            keep_left(c, line, b);
        }
        keep_right(c, line, a / b);
    }
}

/// Value and derivative at `x` of the polynomial with coefficients `c`, which are spoilt.
pub(crate) fn value_and_slope<const K: usize>(c: &mut [[f64; K]], x: f64) -> [[f64; K]; 2] {
    let p = c.len() - 1;
    for r in 1..p {
        for i in 0..=p - r {
            c[i] = between(&c[i], &c[i + 1], x);
        }
    }
    match p {
        0 => [c[0], [0.0; K]],
        _ => [between(&c[0], &c[1], x), std::array::from_fn(|k| p as f64 * (c[1][k] - c[0][k]))],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cubic(x: f64) -> f64 {
        1.0 - 3.0 * x + 6.0 * x * x - 2.0 * x * x * x
    }

    #[test]
    fn parts_are_the_same_polynomial() {
        let whole = [[1.0], [0.0], [1.0], [2.0]];
        for (a, b) in
            [(0.0, 0.5), (0.25, 1.0), (0.1, 0.3), (0.7, 0.9), (-0.01, 0.02), (0.98, 1.01), (0.5, 0.5)]
        {
            let mut c = whole;
            restrict(&mut c, Line::whole(4), a, b);
            assert!((c[0][0] - cubic(a)).abs() < 1e-14 && (c[3][0] - cubic(b)).abs() < 1e-14, "[{a}, {b}]");
            let [value, slope] = value_and_slope(&mut c, 0.5);
            let middle = a / 2.0 + b / 2.0;
            assert!((value[0] - cubic(middle)).abs() < 1e-14);
            let expected = (b - a) * (-3.0 + 12.0 * middle - 6.0 * middle * middle);
            assert!((slope[0] - expected).abs() < 1e-14);
        }
    }

    #[test]
    fn constants_have_no_slope() {
        assert_eq!(value_and_slope(&mut [[2.0, 3.0]], 0.3), [[2.0, 3.0], [0.0, 0.0]]);
    }
}
