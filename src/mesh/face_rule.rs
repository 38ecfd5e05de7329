//! The rules that move the corners of a face inwards, each by weights that depend on the distance around the face alone.
//!
//! A leg of a quadratic's polygon, with the joint `E` on it, gives way to `(1 - s) P + s E` beside each end `P`: with `s = 1/2` this is
//! Chaikin's cut, with `s = 1/3` elevation to degree 3. In two directions, with equal intervals, and for any number of corners
//!
//! ```text
//! P̄_i = (1 - s)² P_i + s (2 - s) M + 2 s (1 - s) K_i / n
//! M = Σ P_j / n,   K_i = Σ_j cos(2π (i - j) / n) P_j
//! ```
//! which is Doo and Sabin's rule for `s = 1/2`, with the weights `(n + 5) / 4n` and `(3 + 2 cos(2π |i - j| / n)) / 4n`, and
//! [Miura, (24)] for `s = 1/3`. The map is diagonal in waves around the face: the mean stays, the first wave shrinks by `1 - s`, all
//! others by `(1 - s)²`.

use crate::error::Result;
use crate::error::mesh::MeshError;
use crate::scalar::Scalar;
use nalgebra::SVector;

/// Such a rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FaceRule {
    /// Doo and Sabin's: half of the way to the joints.
    DooSabin,
    /// That of [Miura, (24)]: a third of the way.
    Elevation,
}

impl FaceRule {
    /// How far the corners go towards the joints: `s`.
    pub(crate) fn share<T: Scalar>(self) -> T {
        match self {
            Self::DooSabin => T::frac(1, 2),
            Self::Elevation => T::frac(1, 3),
        }
    }

    /// Appends the new corners of a face with equal intervals to `moved`.
    pub(crate) fn apply<T: Scalar, const N: usize>(
        self,
        corners: &[SVector<T, N>],
        waves: &mut Waves<T, N>,
        moved: &mut Vec<SVector<T, N>>,
    ) -> Result<()> {
        let [own, mean, wave] = match self {
            Self::DooSabin => [(1, 4), (3, 4), (1, 2)],
            Self::Elevation => [(4, 9), (5, 9), (4, 9)],
        };
        let own = T::frac(own.0, own.1);
        let [mean, wave] = [mean, wave].map(|(p, q)| T::frac(p, q * corners.len() as i64));
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
            // Around a vertex that was in two faces of a closed mesh: cos = -1.
            2 => self.first.extend([&corners[0] - &corners[1], &corners[1] - &corners[0]]),
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
pub(super) fn turn<T: Scalar>(k: usize, n: usize) -> [T; 2] {
    const UNIT: i64 = 1 << 53;
    let (sin, cos) = (std::f64::consts::TAU * (k as f64 / n as f64)).sin_cos();
    [cos, sin].map(|x| T::frac((x * UNIT as f64) as i64, UNIT))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;

    /// The weights of corner 0 in all new ones: those of all corners in the first, as the rule is symmetric.
    fn weights<T: Scalar>(rule: FaceRule, sides: usize) -> Result<Vec<T>> {
        let unit = |k: usize| SVector::<T, 1>::new(if k == 0 { T::one() } else { T::zero() });
        let corners: Vec<_> = (0..sides).map(unit).collect();
        let mut moved = Vec::new();
        rule.apply(&corners, &mut Waves::default(), &mut moved)?;
        Ok(moved.into_iter().map(|weight| weight[0].clone()).collect())
    }

    #[test]
    fn weights_are_those_of_the_formulas() {
        let quarters = |n: &[i64], d: i64| n.iter().map(|n| Q::frac(*n, d)).collect::<Vec<_>>();
        assert_eq!(weights(FaceRule::DooSabin, 4), Ok(quarters(&[9, 3, 1, 3], 16)));
        assert_eq!(weights(FaceRule::Elevation, 4), Ok(quarters(&[25, 5, 1, 5], 36)));
        assert_eq!(weights(FaceRule::Elevation, 3), Ok(quarters(&[7, 1, 1], 9)));
        assert_eq!(weights(FaceRule::Elevation, 6), Ok(quarters(&[33, 7, 3, 1, 3, 7], 54)));
        assert_eq!(
            weights::<Q>(FaceRule::DooSabin, 5),
            Err(MeshError::IrrationalWeights { sides: 5 }.into())
        );
        for n in [3, 4, 5, 6, 7, 12, 101] {
            let cos = |k: usize| (std::f64::consts::TAU * k as f64 / n as f64).cos();
            let size = n as f64;
            for (k, w) in weights::<f64>(FaceRule::DooSabin, n).unwrap().into_iter().enumerate() {
                let own = if k == 0 { 0.25 } else { 0.0 };
                assert!((w - own - (3.0 + 2.0 * cos(k)) / (4.0 * size)).abs() < 4e-16, "{k} of {n}");
            }
            for (k, w) in weights::<f64>(FaceRule::Elevation, n).unwrap().into_iter().enumerate() {
                let own = if k == 0 { 4.0 / 9.0 } else { 0.0 };
                assert!((w - own - (5.0 + 4.0 * cos(k)) / (9.0 * size)).abs() < 4e-16, "{k} of {n}");
            }
        }
    }
}
