//! Polynomial splines near rational ones, to a certified tolerance.
//!
//! For `R = n / w` and a polynomial spline `S` the difference is a rational spline again,
//!
//! ```text
//! R - S = (n - S w) / w
//! ```
//! On each patch it has Bernstein coefficients `r_i` above and `w_i` below, and lies between its control points: so
//! `|R - S| <= max |r_i| / w_i` (see [`fraction`](crate::ops::fraction)). Patches where that is above the tolerance are halved, and `S` is made anew.
//!
//! `S` is the [quasi-interpolant](SplineSpace::quasi_interpolant) of `R` in a space with the smoothness that the space of `R` promises.
//! On equal spans its error is one shape on all of them, plus a multiple of the derivative of order `q + 1` that comes of where the samples are:
//! so the mean error of a span in the middle of its support is added to each coefficient.
//! As the error is a power `q + 1` of the length of spans, about `τ^{-1 / (q + 1)}` spans meet the tolerance `τ`.
//!
//! Over inexact fields `r` and `w` are rounded: `s` steps of convex combinations (pieces of both and their product in each
//! direction, and halvings) leave them off by at most
//!
//! ```text
//! γ (|n| + |S| w)  and  γ |w|        γ = 8 (p + q + 1) (s + 1) ε,   ε = 2^-52
//! ```
//! as in [`bound`](crate::ops::bound). These are splines too, whose coefficients are made of the sizes of coefficients.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::limits::MAX_ADAPTED;
use crate::ops::bound::{Approximation, check_tolerance, epsilon, largest, out_of_tolerance, size};
use crate::ops::fraction::{FractionBound, HALVINGS};
use crate::rational::domain::Domain;
use crate::rational::spline::Rational;
use crate::scalar::{Scalar, larger, larger_size};
use crate::space::SplineSpace;
use crate::weighted::Weighted;

/// The least degree of an approximation.
const LEAST_DEGREE: usize = 3;

/// The largest number of coefficients over exact fields, whose numbers are long.
const MAX_EXACT: usize = MAX_ADAPTED / 16;

/// How many rounds there are at most: halving goes no deeper.
const ROUNDS: usize = 100;

impl<D: Domain<T>, T: Scalar, C: Coeff<T>> Rational<D, T, C> {
    /// A polynomial spline that is certainly within `tolerance`, a distance between points at the same parameter.
    ///
    /// What asks for polynomials takes rational input this way: to fine-tune a rational curve or surface, fine-tune its
    /// approximation. What the bound certifies is the distance before tuning; for curves `Approximation::fine_tuned` says what
    /// follows for the tuned one. There is no rational answer to ask for: the integral of a scaled derivative is not rational in general.
    ///
    /// - The degree is that of this spline, 3 at least, in each direction; but see
    ///   [`polynomial_of_degree_within`](Self::polynomial_of_degree_within).
    /// - Knots keep their smoothness: a kink stays one, and where the space allows a kink `S` may have a small one even if this
    ///   spline has none. New knots are simple, and stand only where the tolerance asks for them; on surfaces they are lines
    ///   across the direction that needs them.
    /// - Clamped curves keep their end points and clamped surfaces their corners; the rest of a boundary is within
    ///   `tolerance`. Periodic splines stay periodic, unclamped ones unclamped.
    /// - Equal weights give the numerator over them, in its own space. That is exact, as is what comes of tolerance zero.
    ///
    /// The bound is a certificate, rounding included, and not more than the tolerance. Over exact fields numbers get long where weights
    /// differ much: then hundreds of coefficients take a minute. In `f64` what is found to be out of reach late takes seconds.
    ///
    /// # Errors
    /// [`Error::BadTolerance`]; [`Error::OutOfTolerance`] if the tolerance is below what rounding allows, or is zero and the spline is
    /// not found to be polynomial, or if it would take more than [`MAX_ADAPTED`] coefficients, over exact
    /// fields a sixteenth of that; [`Error::NotFinite`] on overflow;
    /// [`Error::Undecided`] if the denominator is too near zero; [`Error::TooLarge`], [`Error::DegreeTooHigh`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::circle;
    /// let unit = circle(&vector![0.0, 0.0], &1.0)?;
    /// let near = unit.polynomial_within(&1e-6)?;
    /// assert!(near.bound <= 1e-6 && near.spline.degree() == 3);
    /// assert_eq!(near.spline.at(&0.0)?, unit.at(&0.0)?);
    /// assert!((near.spline.at(&0.3)? - unit.at(&0.3)?).norm() <= near.bound);
    /// // A polynomial to work with.
    /// assert!((near.spline.derivative()?.times(&near.spline.coordinate(0)?)?.integral()?[1] - std::f64::consts::PI).abs() < 1e-5);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn polynomial_within(&self, tolerance: &T) -> Result<Approximation<D::Spline<C>, T>> {
        self.polynomial_of_degree_within(LEAST_DEGREE, tolerance)
    }

    /// As [`polynomial_within`](Self::polynomial_within), of `degree` in each direction, or that of this spline if it is higher.
    ///
    /// Fine tolerances take fewer coefficients in a higher degree: of the unit circle to `1e-4`, `1e-7` and `1e-10` it is
    /// 41, 259 and 1348 in degree 3, and 47, 89 and 235 in degree 5. Beyond degree 5 rounding grows fast.
    ///
    /// # Errors
    /// As [`polynomial_within`](Self::polynomial_within).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::circle;
    /// let unit = circle(&vector![0.0, 0.0], &1.0)?;
    /// let [cubic, quintic] = [3, 5].map(|degree| unit.polynomial_of_degree_within(degree, &1e-8));
    /// assert!(2 * quintic?.spline.space().dim() < cubic?.spline.space().dim());
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn polynomial_of_degree_within(
        &self,
        degree: usize,
        tolerance: &T,
    ) -> Result<Approximation<D::Spline<C>, T>> {
        check_tolerance(tolerance)?;
        if let Some(same) = self.with_equal_weights()?.filter(|same| same.bound <= *tolerance) {
            return Ok(same);
        }
        let raised = |space: &SplineSpace<T>| space.elevated(degree.saturating_sub(space.degree()));
        let mut spaces = D::spaces(self.lifted()).iter().map(raised).collect::<Result<Vec<_>>>()?;
        let mut reached = None;
        for _ in 0..ROUNDS {
            let spline = self.quasi_interpolated(&spaces)?;
            let bounds = self.distance_bounds(&spline, &spaces, tolerance)?;
            reached = worst(&bounds);
            if let Some(bound) = reached.clone().filter(|bound| bound <= tolerance) {
                return Ok(Approximation { spline, bound });
            }
            let hopeless = tolerance.is_zero() || bounds.iter().any(|patch| patch.floor > *tolerance);
            // Where spans of different lengths meet the error is larger: all that is near the tolerance goes along in the end.
            let near = reached.as_ref().is_some_and(|bound| *bound <= tolerance.clone() * T::int(4));
            let level = if near { tolerance.clone() / T::int(4) } else { tolerance.clone() };
            match refined(&spaces, &bounds, &level).filter(|_| !hopeless) {
                Some(finer) => spaces = finer,
                None => break,
            }
        }
        Err(match reached {
            Some(bound) => out_of_tolerance(&bound, tolerance),
            None => Error::Undecided,
        })
    }

    /// The numerator over the weight, if there is but one.
    fn with_equal_weights(&self) -> Result<Option<Approximation<D::Spline<C>, T>>> {
        let weight = D::coeffs(self.lifted())[0].weight.clone();
        if self.weights().any(|other| *other != weight) {
            return Ok(None);
        }
        let divided = |c: &Weighted<T, C>| {
            let mut point = c.point.clone();
            point.divide(&weight);
            point
        };
        let spline = D::map_coeffs(self.lifted(), divided)?;
        let exact = T::EXACT || weight.is_one();
        let bound = if exact { T::zero() } else { largest(D::coeffs(&spline)) * epsilon::<T>() };
        Ok(Some(Approximation { spline, bound }))
    }

    /// The quasi-interpolant and its mean error, with the end points of clamped curves and corners of clamped surfaces.
    fn quasi_interpolated(&self, spaces: &[SplineSpace<T>]) -> Result<D::Spline<C>> {
        let values: Vec<C> = D::samples(self.lifted(), spaces)?.iter().map(Weighted::project).collect();
        let mut spline = D::from_samples(spaces, values.clone(), SplineSpace::quasi_coeffs)?;
        let reached = D::samples(&spline, spaces)?;
        let errors = values.iter().zip(&reached).map(|(value, reached)| value.minus(reached)).collect();
        let means = D::from_samples(spaces, errors, SplineSpace::middle_means)?;
        let pairs = D::coeffs(&spline).iter().zip(D::coeffs(&means)).enumerate();
        let corrected = pairs.map(|(i, (c, mean))| (i, c.plus_scaled(&T::one(), mean))).collect();
        D::replace_coeffs(&mut spline, corrected)?;
        Ok(spline)
    }

    /// Bounds of the distance to `spline` on the patches of its `spaces`.
    fn distance_bounds(
        &self,
        spline: &D::Spline<C>,
        spaces: &[SplineSpace<T>],
        enough: &T,
    ) -> Result<Vec<FractionBound<T>>> {
        let own = D::spaces(self.lifted());
        let pieces = |degrees: &[SplineSpace<T>]| -> Result<Vec<SplineSpace<T>>> {
            spaces.iter().zip(degrees).map(|(space, like)| space.pieces(like.degree())).collect()
        };
        let (left, right) = (pieces(spaces)?, pieces(&own)?);
        let one = |point: &C| Weighted { point: point.clone(), weight: T::one() };
        let near = D::embedded(&D::map_coeffs(spline, one)?, &left)?;
        let lifted = D::embedded(self.lifted(), &right)?;
        // Patches are independent of each other in these spaces: the product is that of Bernstein polynomials.
        let difference = D::product(&near, &lifted, |s: &Weighted<T, C>, c: &Weighted<T, C>| Weighted {
            point: c.point.scaled(&s.weight).plus_scaled(&-c.weight.clone(), &s.point),
            weight: c.weight.clone() * &s.weight,
        })?;
        if T::EXACT {
            return D::fraction_bounds(&difference, None, enough);
        }
        let degree = (0..spaces.len()).map(|d| spaces[d].degree() + own[d].degree()).max().unwrap_or(0);
        let steps = (3 + HALVINGS) * spaces.len() + 1;
        let share = T::int(8 * (degree as i64 + 1) * steps as i64) * epsilon::<T>();
        let sizes = |c: &Weighted<T, C>| Weighted { point: size(&c.point), weight: c.weight.magnitude() };
        let one = |point: &C| Weighted { point: size(point), weight: T::one() };
        let near = D::embedded(&D::map_coeffs(spline, one)?, &left)?;
        let lifted = D::embedded(&D::map_coeffs(self.lifted(), sizes)?, &right)?;
        let noise = D::product(&near, &lifted, |s: &Weighted<T>, c: &Weighted<T>| Weighted {
            point: (c.point.clone() + s.point.clone() * &c.weight) * &share,
            weight: c.weight.clone() * &share,
        })?;
        D::fraction_bounds(&difference, Some(&noise), enough)
    }
}

/// The bound on all patches, if there is one on each.
fn worst<T: Scalar>(bounds: &[FractionBound<T>]) -> Option<T> {
    bounds.iter().try_fold(T::zero(), |most, patch| Some(larger(most, patch.bound.clone()?)))
}

/// The spaces with knots in the middle of spans under patches that fail, in the directions along which these change most; nothing if
/// there is no room, or if a patch fails that is too narrow to be halved.
fn refined<T: Scalar>(
    spaces: &[SplineSpace<T>],
    bounds: &[FractionBound<T>],
    tolerance: &T,
) -> Option<Vec<SplineSpace<T>>> {
    let is_wide = |ends: &[T]| middle(&ends[0], &ends[1]).is_some();
    let wide: Vec<Vec<bool>> =
        spaces.iter().map(|space| space.ends().windows(2).map(is_wide).collect()).collect();
    let mut failing: Vec<Vec<bool>> = wide.iter().map(|wide| vec![false; wide.len()]).collect();
    for (i, patch) in bounds.iter().enumerate() {
        if patch.bound.as_ref().is_some_and(|bound| bound <= tolerance) {
            continue;
        }
        let most = patch.rises.iter().cloned().fold(T::zero(), larger_size);
        let (mut rest, mut is_stuck) = (i, true);
        for d in (0..spaces.len()).rev() {
            let k = rest % wide[d].len();
            // A direction along which the error changes a quarter as much as along another counts as well.
            if patch.rises[d].clone() * T::int(16) >= most {
                failing[d][k] = true;
                is_stuck &= !wide[d][k];
            }
            rest /= wide[d].len();
        }
        if is_stuck {
            return None;
        }
    }
    let finer = spaces.iter().zip(&failing).map(|(space, failing)| {
        let middles = middles(space, failing);
        if middles.is_empty() { Some(space.clone()) } else { space.refined(&middles).ok() }
    });
    let finer: Vec<SplineSpace<T>> = finer.collect::<Option<_>>()?;
    let size = finer.iter().fold(1_usize, |size, space| size.saturating_mul(space.dim()));
    let most = if T::EXACT { MAX_EXACT } else { MAX_ADAPTED };
    (size <= most && finer != spaces).then_some(finer)
}

/// The middles of the `failing` spans, and of longer ones next to them, whose polynomials have a share in the coefficients there.
fn middles<T: Scalar>(space: &SplineSpace<T>, failing: &[bool]) -> Vec<T> {
    let (ends, count) = (space.ends(), failing.len());
    let length = |i: usize| ends[i + 1].clone() - &ends[i];
    let next = |i: usize| if i + 1 < count { Some(i + 1) } else { space.is_periodic().then_some(0) };
    let mut halved = failing.to_vec();
    for (i, j) in (0..count).filter_map(|i| Some((i, next(i)?))) {
        let (two, three) = (T::int(2), T::int(3));
        let is_longer = |i: usize, j: usize| length(i) * &two > length(j) * &three;
        halved[i] |= failing[j] && is_longer(i, j);
        halved[j] |= failing[i] && is_longer(j, i);
    }
    (0..count).filter(|&i| halved[i]).filter_map(|i| middle(&ends[i], &ends[i + 1])).collect()
}

/// The middle of a span, if rounding leaves it inside.
fn middle<T: Scalar>(a: &T, b: &T) -> Option<T> {
    let middle = a.clone() + (b.clone() - a) / T::int(2);
    (*a < middle && middle < *b).then_some(middle)
}
