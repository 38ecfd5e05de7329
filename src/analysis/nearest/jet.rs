//! Value and derivatives of a Bernstein polynomial on the unit square.

use crate::coeff::Coeff;

/// Value, first and second derivatives.
#[derive(Clone, Debug)]
pub(super) struct Jet<C> {
    /// The value.
    pub(super) value: C,
    /// Along each direction.
    pub(super) first: [C; 2],
    /// `uu`, `uv`, `vv`.
    pub(super) second: [C; 3],
}

/// Room for the steps, kept between calls.
#[derive(Clone, Debug)]
pub(super) struct Room<C> {
    line: Vec<C>,
    columns: [Vec<C>; 3],
}

impl<C> Default for Room<C> {
    fn default() -> Self {
        Self { line: Vec::new(), columns: [Vec::new(), Vec::new(), Vec::new()] }
    }
}

impl<C: Coeff<f64>> Room<C> {
    /// The jet at `t` of the polynomial with these coefficients.
    pub(super) fn jet(&mut self, coeffs: &[C], degrees: [usize; 2], t: [f64; 2]) -> Jet<C> {
        let zero = || coeffs[0].zero_like();
        let [p, q] = degrees;
        if q == 0 {
            let [value, u, uu] = self.along(coeffs, p, t[0]);
            return Jet { value, first: [u, zero()], second: [uu, zero(), zero()] };
        }
        self.columns.iter_mut().for_each(Vec::clear);
        for row in coeffs.chunks_exact(q + 1) {
            let entries = self.along(row, q, t[1]);
            self.columns.iter_mut().zip(entries).for_each(|(column, entry)| column.push(entry));
        }
        let columns = std::mem::take(&mut self.columns);
        let [value, u, uu] = self.along(&columns[0], p, t[0]);
        let [v, uv, _] = self.along(&columns[1], p, t[0]);
        let [vv, ..] = self.along(&columns[2], p, t[0]);
        self.columns = columns;
        Jet { value, first: [u, v], second: [uu, uv, vv] }
    }

    /// Value and derivatives of degree `p` at `t`, by de Casteljau's steps, the last two of which give the differences.
    fn along(&mut self, coeffs: &[C], p: usize, t: f64) -> [C; 3] {
        match (coeffs, p) {
            ([c], _) => [c.clone(), c.zero_like(), c.zero_like()],
            ([a, b], _) => [blend(a, b, t), b.minus(a), a.zero_like()],
            ([a, b, c], _) => last_steps(a, b, c, 2, t),
            ([a, b, c, d], _) => last_steps(&blend(a, b, t), &blend(b, c, t), &blend(c, d, t), 3, t),
            _ => {
                self.line.clear();
                self.line.extend_from_slice(coeffs);
                for r in 0..p - 2 {
                    for i in 0..p - r {
                        self.line[i] = blend(&self.line[i], &self.line[i + 1], t);
                    }
                }
                last_steps(&self.line[0], &self.line[1], &self.line[2], p, t)
            }
        }
    }
}

#[inline]
fn blend<C: Coeff<f64>>(a: &C, b: &C, t: f64) -> C {
    a.scaled(&(1.0 - t)).plus_scaled(&t, b)
}

#[inline]
fn last_steps<C: Coeff<f64>>(a: &C, b: &C, c: &C, p: usize, t: f64) -> [C; 3] {
    let p = p as f64;
    let (low, high) = (blend(a, b, t), blend(b, c, t));
    let bend = c.plus_scaled(&-2.0, b).plus_scaled(&1.0, a);
    [blend(&low, &high, t), high.minus(&low).scaled(&p), bend.scaled(&(p * (p - 1.0)))]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_product_of_powers() {
        // u^4 v^2 by their coefficients.
        let (u, v) = ([0.0, 0.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
        let coeffs: Vec<f64> = u.iter().flat_map(|a| v.iter().map(move |b| a * b)).collect();
        let jet = Room::default().jet(&coeffs, [4, 2], [0.5, 0.25]);
        assert_eq!(jet.value, 0.5_f64.powi(4) / 16.0);
        assert_eq!(jet.first, [4.0 / 8.0 / 16.0, 2.0 * 0.25 / 16.0]);
        assert_eq!(jet.second, [12.0 / 4.0 / 16.0, 4.0 / 8.0 * 0.5, 2.0 / 16.0]);
        let line = Room::default().jet(&[1.0, 3.0], [1, 0], [0.5, 0.0]);
        assert_eq!((line.value, line.first, line.second), (2.0, [2.0, 0.0], [0.0; 3]));
    }
}
