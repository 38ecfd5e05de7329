//! Solutions of integer systems digit by digit.
//!
//! Modulo a prime `p` a system has a solution as soon as the determinant is not a multiple of `p`. What it leaves over is a
//! multiple of `p`, and the quotient is a right-hand side of the same size again, which gives the next digit
//! (Dixon's lifting):
//!
//! ```text
//! d_k = A⁻¹ r_k mod p,   r_{k+1} = (r_k - A d_k) / p,   x = d_0 + d_1 p + d_2 p² + ...
//! ```
//!
//! Modulo `m = p^k` this `x` is the solution, a vector of fractions, that is told from its remainders. For a candidate `n / d`
//! all of `A n - d b` are multiples of `m`; if they are less than `m` besides, they are zero and the candidate is the
//! solution. So a result is proved, however it was found.

use super::modular::{Inversion, ModularMatrix, Prime};
use super::reconstruct::fraction;
use num_bigint::{BigInt, BigUint, Sign};
use num_traits::{One, Signed, ToPrimitive, Zero};

/// How many bits a fraction must be shorter than the modulus to be taken for the solution.
const SLACK: u64 = 40;

/// A square matrix of integers as it is lifted: split in digits, `A = Σ A_l 2^(bits l)`, so short that rows times vectors
/// stay in words.
pub(super) struct Lifting {
    size: usize,
    prime: Prime,
    inverse: ModularMatrix,
    /// The digits of the entries, from the lowest.
    planes: Vec<Vec<i32>>,
    bits: u32,
    /// The size of the greatest entry in bits.
    entry_bits: u64,
}

/// What keeps a matrix from being lifted: see [`Inversion::Dependent`].
pub(super) struct Dependent {
    pub(super) column: usize,
    pub(super) rows: Vec<usize>,
}

impl Lifting {
    /// Prepares the matrix with the given entries, row by row, modulo `prime`.
    pub(super) fn new(size: usize, entries: &[BigInt], prime: Prime) -> Result<Self, Dependent> {
        let p = prime.p as i64;
        let residue = |x: &BigInt| -> u32 {
            let rest = match x.to_i64() {
                Some(word) => word % p,
                None => (x % p).to_i64().expect("a remainder is less than its divisor"),
            };
            (if rest < 0 { rest + p } else { rest }) as u32
        };
        let matrix = ModularMatrix { size, entries: entries.iter().map(residue).collect() };
        let inverse = match matrix.inverted(prime) {
            Inversion::Inverse(inverse) => inverse,
            Inversion::Dependent { column, rows } => return Err(Dependent { column, rows }),
        };
        // Digits of 30 bits times digits, added up over a row, stay below 2^63.
        let bits = 32 - (usize::BITS - size.leading_zeros());
        let entry_bits = entries.iter().map(BigInt::bits).max().unwrap_or(0);
        let planes = (0..entry_bits.div_ceil(bits.into())).map(|l| {
            let start = l * u64::from(bits);
            entries.iter().map(|x| digit(x, start, bits)).collect()
        });
        Ok(Self { size, prime, inverse, planes: planes.collect(), bits, entry_bits })
    }

    /// The solution as numerators and a common denominator.
    pub(super) fn solve(&self, right: &[BigInt]) -> (Vec<BigInt>, BigInt) {
        let right_bits = right.iter().map(BigInt::bits).max().unwrap_or(0);
        // Remainders are sums of a right-hand side or a remainder before it and of a row times digits, over p.
        let row_bits = self.entry_bits + u64::from(usize::BITS - self.size.leading_zeros()) + 1;
        if right_bits.max(row_bits) + 31 < 127 {
            let words = right.iter().map(|b| b.to_i128().expect("a number of less than 127 bits")).collect();
            self.lift::<i128>(words, right_bits, row_bits)
        } else {
            self.lift::<BigInt>(right.to_vec(), right_bits, row_bits)
        }
    }

    fn lift<R: Remainder>(&self, mut rest: Vec<R>, right_bits: u64, row_bits: u64) -> (Vec<BigInt>, BigInt) {
        let mut digits: Vec<Vec<u32>> = Vec::new();
        let mut sums = vec![0; self.planes.len()];
        let mut residues = Vec::with_capacity(self.size);
        let mut goal = 4;
        loop {
            while digits.len() < goal {
                let mut next = Vec::with_capacity(self.size);
                residues.clear();
                residues.extend(rest.iter().map(|r| r.modulo(self.prime.p as i64)));
                self.inverse.times(&residues, self.prime, &mut next);
                for (i, r) in rest.iter_mut().enumerate() {
                    let row = i * self.size..(i + 1) * self.size;
                    for (sum, plane) in sums.iter_mut().zip(&self.planes) {
                        let products = plane[row.clone()].iter().zip(&next);
                        *sum = products.map(|(a, d)| i64::from(*a) * i64::from(*d)).sum();
                    }
                    r.reduce(&sums, self.bits, self.prime.p as i64);
                }
                digits.push(next);
            }
            if let Some(solution) = self.told(&digits, right_bits, row_bits) {
                return solution;
            }
            goal += (goal / 4).max(2);
        }
    }

    /// The solution, if its digits so far determine it.
    fn told(&self, digits: &[Vec<u32>], right_bits: u64, row_bits: u64) -> Option<(Vec<BigInt>, BigInt)> {
        let m = num_traits::pow(BigUint::from(self.prime.p), digits.len());
        let room = m.bits().checked_sub(SLACK)?;
        // By Cramer's rule the ratio of numerators and denominator is about that of the right-hand side and the matrix.
        let above = (room + right_bits).saturating_sub(self.entry_bits).min(2 * room) / 2;
        let below = room - above;
        let number = |j: usize| {
            let square = self.prime.p * self.prime.p;
            let pair = |pair: &[Vec<u32>]| {
                u64::from(pair[0][j]) + pair.get(1).map_or(0, |high| u64::from(high[j]) * self.prime.p)
            };
            digits.chunks(2).rev().fold(BigUint::zero(), |number, digits| number * square + pair(digits))
        };
        let half = BigInt::from(&m >> 1);
        let modulus = BigInt::from(m.clone());
        let mut numerators: Vec<BigInt> = Vec::with_capacity(self.size);
        let mut denominator = BigInt::one();
        for j in 0..self.size {
            let x = number(j);
            let mut multiple = BigInt::from(x) * &denominator % &modulus;
            if multiple > half {
                multiple -= &modulus;
            }
            if multiple.bits() > above {
                if multiple.is_negative() {
                    multiple += &modulus;
                }
                let (num, den) = fraction(multiple.magnitude(), &m, above, below)?;
                numerators.iter_mut().for_each(|n| *n *= &den);
                denominator *= den;
                multiple = num;
            }
            numerators.push(multiple);
        }
        let longest = numerators.iter().map(BigInt::bits).max().unwrap_or(0);
        let most = (row_bits + longest).max(right_bits + denominator.bits()) + 1;
        (most < m.bits()).then_some((numerators, denominator))
    }
}

/// The signed digit of `bits` bits of `x` from bit `start`.
fn digit(x: &BigInt, start: u64, bits: u32) -> i32 {
    let (place, shift) = ((start / 64) as usize, start % 64);
    let mut words = x.iter_u64_digits().skip(place);
    let mut word = || u128::from(words.next().unwrap_or(0));
    let size = ((word() | word() << 64) >> shift) as u64 & ((1 << bits) - 1);
    if x.sign() == Sign::Minus { -(size as i32) } else { size as i32 }
}

/// A right-hand side that is used up.
trait Remainder {
    fn modulo(&self, p: i64) -> u32;

    /// Subtracts `Σ sums[l] 2^(bits l)` and divides by `p`.
    fn reduce(&mut self, sums: &[i64], bits: u32, p: i64);
}

impl Remainder for i128 {
    fn modulo(&self, p: i64) -> u32 {
        match i64::try_from(*self) {
            Ok(word) => word.rem_euclid(p) as u32,
            Err(_) => self.rem_euclid(p.into()) as u32,
        }
    }

    fn reduce(&mut self, sums: &[i64], bits: u32, p: i64) {
        let product = sums.iter().rev().fold(0_i128, |product, sum| (product << bits) + i128::from(*sum));
        let rest = *self - product;
        *self = match i64::try_from(rest) {
            Ok(word) => (word / p).into(),
            Err(_) => rest / i128::from(p),
        };
    }
}

impl Remainder for BigInt {
    fn modulo(&self, p: i64) -> u32 {
        let rest = (self % p).to_i64().expect("a remainder is less than its divisor");
        rest.rem_euclid(p) as u32
    }

    fn reduce(&mut self, sums: &[i64], bits: u32, p: i64) {
        let product = sums.iter().rev().fold(Self::zero(), |product, sum| (product << bits) + sum);
        *self -= product;
        *self /= p;
    }
}
