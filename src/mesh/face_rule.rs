//! The rules that move the corners of a face inwards, each by weights that depend on the distance around the face alone.
//!
//! For a face with the corners `P_0 .. P_{n-1}`
//!
//! ```text
//! P̄_i = x P_i + y M + z K_i / n,   M = Σ P_j / n,   K_i = Σ_j cos(2π (i - j) / n) P_j
//! ```
//! with `x + y = 1`. With `(x, y, z) = (1, 3, 2) / 4` it is Doo and Sabin's rule, with the weights `(n + 5) / 4n` and
//! `(3 + 2 cos(2π |i - j| / n)) / 4n`; with `(4, 5, 4) / 9` it is the conversion [Miura] (24). The map is diagonal in waves around the face:
//! the mean stays, the first wave shrinks by `x + z / 2`, which is 1/2 and 2/3, all others by `x`.

use crate::error::Result;
use crate::error::mesh::MeshError;
use crate::scalar::Scalar;
use nalgebra::SVector;

/// Such a rule: the weights of a corner itself, of the mean, and of the first wave.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct FaceRule {
    own: (i64, i64),
    mean: (i64, i64),
    wave: (i64, i64),
}

/// Doo and Sabin's rule.
pub(crate) const DOO_SABIN: FaceRule = FaceRule { own: (1, 4), mean: (3, 4), wave: (1, 2) };
/// The rule of [Miura] (24).
pub(crate) const CONVERSION: FaceRule = FaceRule { own: (4, 9), mean: (5, 9), wave: (4, 9) };

impl FaceRule {
    /// The weights of the corners in the first new one.
    pub(crate) fn weights<T: Scalar>(&self, sides: usize) -> Result<Vec<T>> {
        let unit = |k: usize| SVector::<T, 1>::new(if k == 0 { T::one() } else { T::zero() });
        let corners: Vec<_> = (0..sides).map(unit).collect();
        let mut moved = Vec::new();
        self.apply(&corners, &mut Waves::default(), &mut moved)?;
        // Of corner 0 in all new ones: the same, as the rule is symmetric.
        Ok(moved.into_iter().map(|weight| weight[0].clone()).collect())
    }

    /// Appends the new corners to `moved`.
    pub(crate) fn apply<T: Scalar, const N: usize>(
        &self,
        corners: &[SVector<T, N>],
        waves: &mut Waves<T, N>,
        moved: &mut Vec<SVector<T, N>>,
    ) -> Result<()> {
        let [own, mean, wave] = [self.own, self.mean, self.wave].map(|(p, q)| T::frac(p, q));
        let share = T::frac(1, corners.len() as i64);
        let (mean, wave) = (mean * &share, wave * &share);
        let mean = waves.run(corners)? * mean;
        let new = |(corner, turned): (&SVector<T, N>, &SVector<T, N>)| {
            corner * own.clone() + &mean + turned * wave.clone()
        };
        moved.extend(corners.iter().zip(&waves.first).map(new));
        Ok(())
    }
}

/// The first wave of the corners of a face, `K_i`.
#[derive(Clone, Debug)]
pub(crate) struct Waves<T: Scalar, const N: usize> {
    pub(crate) first: Vec<SVector<T, N>>,
    /// Cosines and sines of the multiples of `2π / n`, for the number `n` of corners that came last.
    turns: Vec<[T; 2]>,
}

impl<T: Scalar, const N: usize> Default for Waves<T, N> {
    fn default() -> Self {
        Self { first: Vec::new(), turns: Vec::new() }
    }
}

impl<T: Scalar, const N: usize> Waves<T, N> {
    /// Finds the wave, and returns the sum of the corners. The cost is linear in their number.
    pub(crate) fn run(&mut self, corners: &[SVector<T, N>]) -> Result<SVector<T, N>> {
        let sum = corners.iter().fold(SVector::zeros(), |sum, corner| sum + corner);
        let n = corners.len();
        self.first.clear();
        match n {
            // cos = -1/2.
            3 => {
                let half = &sum * T::frac(1, 2);
                self.first.extend(corners.iter().map(|corner| corner * T::frac(3, 2) - &half));
            }
            4 => self.first.extend((0..4).map(|i| &corners[i] - &corners[(i + 2) % 4])),
            // cos = 1/2, -1/2, -1.
            6 => self.first.extend((0..6).map(|i| {
                let [near, far] = [1, 2].map(|k| &corners[(i + k) % 6] + &corners[(i + 6 - k) % 6]);
                &corners[i] - &corners[(i + 3) % 6] + (near - far) * T::frac(1, 2)
            })),
            _ if T::EXACT => return Err(MeshError::IrrationalWeights { sides: n }.into()),
            _ => {
                if self.turns.len() != n {
                    self.turns = (0..n).map(|k| turn(k, n)).collect();
                }
                let parts = [0, 1].map(|part| {
                    let terms = corners.iter().zip(&self.turns);
                    terms.fold(SVector::zeros(), |sum, (corner, turn)| sum + corner * turn[part].clone())
                });
                let wave = |[cos, sin]: &[T; 2]| &parts[0] * cos.clone() + &parts[1] * sin.clone();
                self.first.extend(self.turns.iter().map(wave));
            }
        }
        Ok(sum)
    }
}

/// The cosine and sine of `2π k / n`, to about 16 digits.
fn turn<T: Scalar>(k: usize, n: usize) -> [T; 2] {
    const UNIT: i64 = 1 << 53;
    let (sin, cos) = (std::f64::consts::TAU * (k as f64 / n as f64)).sin_cos();
    [cos, sin].map(|x| T::frac((x * UNIT as f64) as i64, UNIT))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;

    #[test]
    fn weights_are_those_of_the_formulas() {
        let quarters = |n: &[i64], d: i64| n.iter().map(|n| Q::frac(*n, d)).collect::<Vec<_>>();
        assert_eq!(DOO_SABIN.weights(4), Ok(quarters(&[9, 3, 1, 3], 16)));
        assert_eq!(CONVERSION.weights(4), Ok(quarters(&[25, 5, 1, 5], 36)));
        assert_eq!(CONVERSION.weights(3), Ok(quarters(&[7, 1, 1], 9)));
        assert_eq!(CONVERSION.weights(6), Ok(quarters(&[33, 7, 3, 1, 3, 7], 54)));
        assert_eq!(DOO_SABIN.weights::<Q>(5), Err(MeshError::IrrationalWeights { sides: 5 }.into()));
        for n in [3, 4, 5, 6, 7, 12, 101] {
            let cos = |k: usize| (std::f64::consts::TAU * k as f64 / n as f64).cos();
            let size = n as f64;
            for (k, w) in DOO_SABIN.weights::<f64>(n).unwrap().into_iter().enumerate() {
                let own = if k == 0 { 0.25 } else { 0.0 };
                assert!((w - own - (3.0 + 2.0 * cos(k)) / (4.0 * size)).abs() < 4e-16, "{k} of {n}");
            }
            for (k, w) in CONVERSION.weights::<f64>(n).unwrap().into_iter().enumerate() {
                let own = if k == 0 { 4.0 / 9.0 } else { 0.0 };
                assert!((w - own - (5.0 + 4.0 * cos(k)) / (9.0 * size)).abs() < 4e-16, "{k} of {n}");
            }
        }
    }
}
