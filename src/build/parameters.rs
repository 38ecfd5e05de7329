//! Parameters for points, and knots for parameters.

use crate::error::{Error, Result};
use crate::limits::check_degree;
use crate::scalar::{Real, Scalar};
use crate::space::SplineSpace;
use crate::vector::length;
use nalgebra::SVector;

/// Parameters from 0 to 1 that advance like the lengths of the polygon's legs [NURBS, 9.5].
///
/// # Errors
/// [`Error::TooFewPoints`] for fewer than two points; [`Error::NotFinite`] for points that are not, or a length that
/// overflows; [`Error::NoLength`] if all points coincide.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::chord_length;
/// let parameters = chord_length(&[vector![0.0, 0.0], vector![3.0, 0.0], vector![3.0, 1.0]])?;
/// assert_eq!(parameters, [0.0, 0.75, 1.0]);
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn chord_length<T: Real, const N: usize>(points: &[SVector<T, N>]) -> Result<Vec<T>> {
    if points.len() < 2 {
        return Err(Error::TooFewPoints { expected: 2, found: points.len() });
    }
    if let Some(index) = points.iter().position(|point| !point.iter().all(T::is_finite)) {
        return Err(Error::NotFinite { what: "point", index });
    }
    let leg = |pair: &[SVector<T, N>]| length(&(&pair[1] - &pair[0]));
    let mut sums = vec![T::zero()];
    for pair in points.windows(2) {
        sums.push(sums[sums.len() - 1].clone() + leg(pair));
    }
    let total = sums[sums.len() - 1].clone();
    if total.is_zero() {
        return Err(Error::NoLength);
    }
    if !total.is_finite() {
        return Err(Error::NotFinite { what: "length", index: 0 });
    }
    sums.iter_mut().for_each(|sum| *sum /= &total);
    Ok(sums)
}

/// The clamped space for interpolation at `parameters`, with as many coefficients: each knot inside is the mean of
/// `p` consecutive parameters, so that interpolation at distinct parameters is always possible
/// [NURBS, 9.8].
///
/// # Errors
/// [`Error::TooFewPoints`] for fewer than `p + 1` parameters, and those of [`SplineSpace::new`].
///
/// # Examples
/// ```
/// use symspline::{SplineSpace, interpolation_space};
/// let space = interpolation_space(2, &[0.0, 1.0, 2.0, 4.0])?;
/// assert_eq!(space, SplineSpace::clamped(2, [0.0, 1.5, 4.0])?);
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn interpolation_space<T: Scalar>(degree: usize, parameters: &[T]) -> Result<SplineSpace<T>> {
    check_degree(degree)?;
    let count = parameters.len();
    if count < degree + 1 || count < 2 {
        return Err(Error::TooFewPoints { expected: (degree + 1).max(2), found: count });
    }
    let ends = [parameters[0].clone(), parameters[count - 1].clone()];
    if degree == 0 {
        // Cells around the parameters: the averages of none are replaced by the middles of neighbours.
        let middles = parameters.windows(2).map(|pair| (pair[0].clone() + &pair[1]) / T::int(2));
        let [a, b] = ends;
        return SplineSpace::clamped(0, [a].into_iter().chain(middles).chain([b]));
    }
    let mean = |window: &[T]| window.iter().fold(T::zero(), |sum, x| sum + x) / T::int(degree as i64);
    let inner = parameters[1..count - 1].windows(degree).map(mean);
    let [a, b] = ends;
    SplineSpace::clamped(degree, [a].into_iter().chain(inner).chain([b]))
}

/// The clamped space with `controls` coefficients for least squares at `parameters`: the knots inside spread the
/// parameters evenly, so that every span holds one [NURBS, 9.68, 9.69].
///
/// # Errors
/// [`Error::TooFewPoints`] if there are fewer parameters than `controls`; [`Error::CoefficientCount`] if `controls`
/// is less than `p + 1`; those of [`SplineSpace::new`].
///
/// # Examples
/// ```
/// use symspline::approximation_space;
/// let parameters: Vec<f64> = (0..=10).map(f64::from).collect();
/// assert_eq!(approximation_space(3, &parameters, 6)?.dim(), 6);
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn approximation_space<T: Scalar>(
    degree: usize,
    parameters: &[T],
    controls: usize,
) -> Result<SplineSpace<T>> {
    check_degree(degree)?;
    if controls < degree + 1 {
        return Err(Error::CoefficientCount { expected: degree + 1, found: controls });
    }
    let count = parameters.len();
    if count < controls.max(2) {
        return Err(Error::TooFewPoints { expected: controls.max(2), found: count });
    }
    let spans = controls - degree;
    let knot = |j: usize| {
        // The position j * count / spans among the parameters, as whole and fractional part; steps change half way.
        let (i, rest) = (j * count / spans, j * count % spans);
        let part = if degree == 0 { T::frac(1, 2) } else { T::frac(rest as i64, spans as i64) };
        parameters[i - 1].clone() + (parameters[i].clone() - &parameters[i - 1]) * part
    };
    let (a, b) = (parameters[0].clone(), parameters[count - 1].clone());
    SplineSpace::clamped(degree, [a].into_iter().chain((1..spans).map(knot)).chain([b]))
}
