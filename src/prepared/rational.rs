//! Evaluators of rational splines: those of the lifted splines, projected.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::prepared::curve::Evaluator;
use crate::prepared::evaluate::Evaluate;
use crate::prepared::surface::SurfaceEvaluator;
use crate::rational::domain::{Interval, Rectangle};
use crate::rational::quotient::quotient;
use crate::rational::spline::Rational;
use crate::scalar::{Scalar, larger};
use crate::weighted::Weighted;

/// A rational spline prepared for values at many parameters: an evaluator `E` of its lifted spline.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Evaluate, Q, Scalar, circle};
/// let circle = circle(&vector![Q::int(0), Q::int(0)], &Q::int(1))?.evaluator()?;
/// let [point, speed] = circle.derivatives_at::<2>(&Q::frac(1, 7))?;
/// assert_eq!((point.dot(&point), point.dot(&speed)), (Q::int(1), Q::int(0)));
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct RationalEvaluator<E> {
    lifted: E,
}

impl<T: Scalar, C: Coeff<T>> Rational<Interval, T, C> {
    /// The curve prepared for many values, as [`Spline::evaluator`](crate::Spline::evaluator).
    ///
    /// In `f64` what is said there of rounding holds for numerator and denominator. Where the denominator is `r` times smaller
    /// than the largest weight under the span, a value is off by about `2 r` times as much. With weights that differ more than
    /// a thousandfold only the search for spans is prepared.
    ///
    /// # Errors
    /// As [`Spline::evaluator`](crate::Spline::evaluator).
    pub fn evaluator(&self) -> Result<RationalEvaluator<Evaluator<T, Weighted<T, C>>>> {
        let lifted = self.lifted();
        let lifted = if uneven(lifted.coeffs()) { lifted.plain_evaluator() } else { lifted.evaluator() };
        Ok(RationalEvaluator { lifted: lifted? })
    }
}

impl<T: Scalar, C: Coeff<T>> Rational<Rectangle, T, C> {
    /// The surface prepared for many values, as [`TensorSpline::evaluator`](crate::TensorSpline::evaluator). Weights that differ
    /// much cost accuracy as for curves; with weights that differ more than a thousandfold the surface is kept as it is.
    ///
    /// # Errors
    /// As [`TensorSpline::evaluator`](crate::TensorSpline::evaluator).
    pub fn evaluator(&self) -> Result<RationalEvaluator<SurfaceEvaluator<T, Weighted<T, C>>>> {
        let lifted = self.lifted();
        let lifted = if uneven(lifted.coeffs()) { Ok(lifted.plain_evaluator()) } else { lifted.evaluator() };
        Ok(RationalEvaluator { lifted: lifted? })
    }
}

/// Whether rounding of powers could matter beside the smallest weight.
fn uneven<T: Scalar, C: Coeff<T>>(lifted: &[Weighted<T, C>]) -> bool {
    let weights = || lifted.iter().map(|c| c.weight.clone());
    let smallest = weights().reduce(|least, w| if w < least { w } else { least });
    let largest = weights().reduce(larger);
    !T::EXACT && largest > smallest.map(|weight| weight * T::int(1000))
}

/// Curves: the quotient rule with one column.
impl<T: Scalar, C: Coeff<T>> Evaluate for RationalEvaluator<Evaluator<T, Weighted<T, C>>> {
    type Parameter = T;
    type Value = C;
    type Derivatives<const COUNT: usize> = [C; COUNT];

    #[inline]
    fn at(&self, x: &T) -> Result<C> {
        Ok(self.lifted.at(x)?.project())
    }

    #[inline]
    fn derivatives_at<const COUNT: usize>(&self, x: &T) -> Result<[C; COUNT]> {
        Ok(column(&self.lifted.derivatives_at(x)?))
    }

    fn for_each(&self, parameters: &[T], mut take: impl FnMut(C)) -> Result<()> {
        self.lifted.for_each(parameters, |value| take(value.project()))
    }

    fn for_each_derivatives<const COUNT: usize>(
        &self,
        parameters: &[T],
        mut take: impl FnMut([C; COUNT]),
    ) -> Result<()> {
        self.lifted.for_each_derivatives::<COUNT>(parameters, |lifted| take(column(&lifted)))
    }
}

impl<T: Scalar, C: Coeff<T>> Evaluate for RationalEvaluator<SurfaceEvaluator<T, Weighted<T, C>>> {
    type Parameter = (T, T);
    type Value = C;
    type Derivatives<const COUNT: usize> = [[C; COUNT]; COUNT];

    #[inline]
    fn at(&self, x: &(T, T)) -> Result<C> {
        Ok(self.lifted.at(x)?.project())
    }

    #[inline]
    fn derivatives_at<const COUNT: usize>(&self, x: &(T, T)) -> Result<[[C; COUNT]; COUNT]> {
        Ok(table(&self.lifted.derivatives_at(x)?))
    }

    fn for_each(&self, parameters: &[(T, T)], mut take: impl FnMut(C)) -> Result<()> {
        self.lifted.for_each(parameters, |value| take(value.project()))
    }

    fn for_each_derivatives<const COUNT: usize>(
        &self,
        parameters: &[(T, T)],
        mut take: impl FnMut([[C; COUNT]; COUNT]),
    ) -> Result<()> {
        self.lifted.for_each_derivatives::<COUNT>(parameters, |lifted| take(table(&lifted)))
    }
}

fn column<const COUNT: usize, T: Scalar, C: Coeff<T>>(lifted: &[Weighted<T, C>; COUNT]) -> [C; COUNT] {
    let mut found: [C; COUNT] = std::array::from_fn(|d| lifted[d].point.zero_like());
    for d in 0..COUNT {
        found[d] = quotient((d, 0), |i, _| &lifted[i], |i, _| &found[i]);
    }
    found
}

fn table<const COUNT: usize, T: Scalar, C: Coeff<T>>(
    lifted: &[[Weighted<T, C>; COUNT]; COUNT],
) -> [[C; COUNT]; COUNT] {
    let mut found: [[C; COUNT]; COUNT] =
        std::array::from_fn(|k| std::array::from_fn(|l| lifted[k][l].point.zero_like()));
    for k in 0..COUNT {
        for l in 0..COUNT {
            found[k][l] = quotient((k, l), |i, j| &lifted[i][j], |i, j| &found[i][j]);
        }
    }
    found
}
