//! Linear algebra modulo a prime below `2^30`, for exact solves.

/// The greatest prime below `2^30`.
pub(super) const FIRST: u64 = (1 << 30) - 35;

/// A prime between `2^29` and `2^30`, with what makes remainders cheap.
#[derive(Clone, Copy)]
pub(super) struct Prime {
    pub(super) p: u64,
    /// `2^60 / p`, rounded down.
    inverse: u64,
}

impl Prime {
    pub(super) fn first() -> Self {
        Self::new(FIRST)
    }

    fn new(p: u64) -> Self {
        Self { p, inverse: (1 << 60) / p }
    }

    /// The next prime downwards.
    pub(super) fn next(self) -> Self {
        let is_prime = |n: &u64| (3..).step_by(2).take_while(|d| d * d <= *n).all(|d| !n.is_multiple_of(d));
        Self::new(
            (1..self.p - 1).rev().step_by(2).find(is_prime).expect("there are primes enough below 2^30"),
        )
    }

    /// `x mod p` for `x < 2^60`, where `p` is above `2^29`.
    #[inline]
    pub(super) fn remainder(self, x: u64) -> u64 {
        // The quotient is too small by two at most: both factors are rounded down.
        let quotient = ((x >> 29) * self.inverse) >> 31;
        let rest = x - quotient * self.p;
        let rest = rest.min(rest.wrapping_sub(self.p));
        rest.min(rest.wrapping_sub(self.p))
    }

    /// `base^exponent mod p`.
    pub(super) fn power(self, mut base: u64, mut exponent: u64) -> u64 {
        let mut power = 1;
        while exponent > 0 {
            if exponent % 2 == 1 {
                power = self.remainder(power * base);
            }
            base = self.remainder(base * base);
            exponent /= 2;
        }
        power
    }

    /// `Σ a b mod p`.
    fn dot(self, a: &[u32], b: &[u32]) -> u64 {
        let (mut low, mut high) = (0, 0);
        for (a, b) in a.chunks(8).zip(b.chunks(8)) {
            // Eight products stay below 2^63.
            let sum: u64 = a.iter().zip(b).map(|(a, b)| u64::from(*a) * u64::from(*b)).sum();
            low += sum & u64::from(u32::MAX);
            high += sum >> 32;
        }
        (((high % self.p) << 32) + low % self.p) % self.p
    }
}

/// A square matrix modulo a prime, row by row.
pub(super) struct ModularMatrix {
    pub(super) size: usize,
    pub(super) entries: Vec<u32>,
}

/// What comes of an inversion.
pub(super) enum Inversion {
    Inverse(ModularMatrix),
    /// The first column that depends on those before it, and independent rows of those before it.
    Dependent {
        column: usize,
        rows: Vec<usize>,
    },
}

impl ModularMatrix {
    /// The inverse, by the method of Gauss and Jordan.
    pub(super) fn inverted(mut self, prime: Prime) -> Inversion {
        let n = self.size;
        // The right half becomes the inverse.
        let mut rows: Vec<Vec<u32>> = (0..n)
            .map(|i| {
                let mut row = self.entries[i * n..(i + 1) * n].to_vec();
                row.extend((0..n).map(|j| u32::from(i == j)));
                row
            })
            .collect();
        let mut order: Vec<usize> = (0..n).collect();
        for k in 0..n {
            let Some(found) = (k..n).find(|i| rows[*i][k] != 0) else {
                order.truncate(k);
                return Inversion::Dependent { column: k, rows: order };
            };
            rows.swap(k, found);
            order.swap(k, found);
            let mut pivot = std::mem::take(&mut rows[k]);
            // What is left of column k is settled, and the unit vectors right of the diagonal have no entries yet.
            let factor = prime.power(pivot[k].into(), prime.p - 2);
            pivot[k..].iter_mut().for_each(|x| *x = prime.remainder(u64::from(*x) * factor) as u32);
            for row in rows.iter_mut().filter(|row| !row.is_empty() && row[k] != 0) {
                let factor = prime.p - u64::from(row[k]);
                for (x, y) in row[k..].iter_mut().zip(&pivot[k..]) {
                    *x = prime.remainder(u64::from(*x) + factor * u64::from(*y)) as u32;
                }
            }
            rows[k] = pivot;
        }
        self.entries = rows.into_iter().flat_map(|row| row.into_iter().skip(n)).collect();
        Inversion::Inverse(self)
    }

    /// The product with a vector.
    pub(super) fn times(&self, x: &[u32], prime: Prime, product: &mut Vec<u32>) {
        product.clear();
        product.extend(self.entries.chunks(self.size).map(|row| prime.dot(row, x) as u32));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn remainders_are_right_at_the_ends() {
        for prime in [Prime::first(), Prime::first().next(), Prime::new((1 << 29) + 11)] {
            let p = prime.p;
            let squares = (p - 1) * (p - 1);
            for x in [0, 1, p - 1, p, p + 1, 2 * p - 1, 2 * p, squares, squares + p - 1] {
                assert_eq!(prime.remainder(x), x % p, "{x} modulo {p}");
            }
        }
    }

    #[test]
    fn the_first_primes_are_prime() {
        assert_eq!(Prime::first().next().p, (1 << 30) - 41);
        assert_eq!(Prime::new((1 << 30) - 33).next().p, FIRST);
    }

    #[test]
    fn inverses_undo() {
        let prime = Prime::first();
        let entries = vec![0, 2, 1, 1, 0, 0, 5, 1, 7];
        let x = [3, 1, 4];
        let (mut y, mut back) = (Vec::new(), Vec::new());
        ModularMatrix { size: 3, entries: entries.clone() }.times(&x, prime, &mut y);
        let Inversion::Inverse(inverse) = (ModularMatrix { size: 3, entries }).inverted(prime) else {
            panic!("a determinant that is not zero")
        };
        inverse.times(&y, prime, &mut back);
        assert_eq!(back, x);
    }

    #[test]
    fn dependent_columns_are_named() {
        let matrix = ModularMatrix { size: 3, entries: vec![0, 0, 1, 1, 2, 0, 3, 6, 0] };
        let Inversion::Dependent { column, rows } = matrix.inverted(Prime::first()) else {
            panic!("rank two")
        };
        assert_eq!((column, rows), (1, vec![1]));
    }
}
