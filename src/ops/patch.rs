//! Polynomials on boxes of any number of directions, by their Bernstein coefficients: curves have one, surfaces two.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::scalar::Scalar;
use crate::spline::Spline;
use crate::weighted::Weighted;

/// Coefficients that stand for a number each.
pub(crate) trait Ordinate<T: Scalar>: Coeff<T> {
    /// The number.
    fn ordinate(&self) -> T;

    /// The coefficient that stands for its negative.
    fn mirrored(&self) -> Self;
}

impl<T: Scalar> Ordinate<T> for T {
    fn ordinate(&self) -> T {
        self.clone()
    }

    fn mirrored(&self) -> T {
        -self.clone()
    }
}

/// With positive weights: values of the quotient lie between those of its coefficients.
impl<T: Scalar> Ordinate<T> for Weighted<T> {
    fn ordinate(&self) -> T {
        self.point.clone() / &self.weight
    }

    fn mirrored(&self) -> Self {
        Self { point: -self.point.clone(), weight: self.weight.clone() }
    }
}

/// A polynomial on a box of `D` directions, by its Bernstein coefficients, the last direction running fastest.
#[derive(Clone, Debug)]
pub(crate) struct Patch<T, const D: usize, C = T> {
    /// The degree in each direction.
    pub degrees: [usize; D],
    /// From where to where in each direction.
    pub sides: [(T, T); D],
    /// `Π (degree + 1)` coefficients.
    pub coeffs: Vec<C>,
}

/// A value and where it is met.
pub(crate) struct Meeting<T, const D: usize> {
    pub value: T,
    pub parameter: [T; D],
}

impl<T: Scalar, const D: usize, C: Ordinate<T>> Patch<T, D, C> {
    /// The least value at a corner.
    pub(crate) fn lowest_corner(&self) -> Meeting<T, D> {
        let lower = |low: (usize, T), other: (usize, T)| if other.1 < low.1 { other } else { low };
        let values = self.corners().map(C::ordinate).enumerate();
        let (corner, value) = values.reduce(lower).expect("a box has a corner");
        let place = |d: usize| {
            let (a, b) = &self.sides[d];
            if is_far(corner, d) { b.clone() } else { a.clone() }
        };
        Meeting { value, parameter: std::array::from_fn(place) }
    }
}

impl<T: Scalar, const D: usize, C: Coeff<T>> Patch<T, D, C> {
    /// The coefficients at the corners, which stand for values.
    pub(crate) fn corners(&self) -> impl Iterator<Item = &C> {
        (0..1 << D).map(|corner| self.corner(corner))
    }

    fn corner(&self, corner: usize) -> &C {
        let end = |d: usize| if is_far(corner, d) { self.degrees[d] } else { 0 };
        &self.coeffs[(0..D).fold(0, |index, d| index * (self.degrees[d] + 1) + end(d))]
    }

    /// The two halves, cut across the directions in turn; `turn` counts.
    pub(crate) fn halves(self, turn: usize) -> [Self; 2] {
        let axes: Vec<usize> = (0..D).filter(|&d| self.degrees[d] > 0).collect();
        let axis = axes[turn % axes.len()];
        let p = self.degrees[axis];
        let stride: usize = self.degrees[axis + 1..].iter().map(|q| q + 1).product();
        let (mut left, mut right) = (self.clone(), self);
        let half = T::frac(1, 2);
        let middle = |a: &C, b: &C| a.scaled(&half).plus_scaled(&half, b);
        let starts = (0..left.coeffs.len()).filter(|i| (i / stride).is_multiple_of(p + 1));
        for start in starts {
            let c = |i: usize| start + i * stride;
            for r in 1..=p {
                for i in (r..=p).rev() {
                    left.coeffs[c(i)] = middle(&left.coeffs[c(i - 1)], &left.coeffs[c(i)]);
                }
                right.coeffs[c(p - r)] = left.coeffs[c(p)].clone();
            }
        }
        let (a, b) = &left.sides[axis];
        let cut = a.clone() * &half + b.clone() * &half;
        left.sides[axis].1 = cut.clone();
        right.sides[axis].0 = cut;
        [left, right]
    }
}

/// Bit `d` of the number of a corner says at which end of direction `d` it is.
fn is_far(corner: usize, d: usize) -> bool {
    corner >> d & 1 == 1
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The pieces.
    pub(crate) fn patches(&self) -> Result<Vec<Patch<T, 1, C>>> {
        let p = self.degree();
        let ends = self.space().ends();
        let pieces = self.bernstein(&ends)?;
        let patch = |(ends, coeffs): (&[T], &[C])| Patch {
            degrees: [p],
            sides: [(ends[0].clone(), ends[1].clone())],
            coeffs: coeffs.to_vec(),
        };
        Ok(ends.windows(2).zip(pieces.chunks(p + 1)).map(patch).collect())
    }
}
