//! Handles for the curvature of a curve at one place.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::scalar::{Real, Scalar};
use crate::shape::constraints::Constraints;
use crate::shape::controlled::Controlled;
use crate::shape::drag::Drag;
use crate::vector::{fraction_near, length};
use nalgebra::SVector;

/// Point and first derivative held at one place of a curve, ready to change the second derivative there [FB, Figures 3
/// and 4].
///
/// Only the part of `C''` across `C'` bends: `κ = |C' × C''| / |C'|³`. What is along `C'` changes how the curve is run through
/// and how the curvature changes nearby, not the curvature.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Analyse, CurvatureHandle, Curve, SplineSpace};
/// let points = vec![vector![0.0, 0.0], vector![1.0, 2.0], vector![3.0, 2.0], vector![4.0, 0.0]];
/// let mut curve = Curve::new(SplineSpace::bezier(3, 0.0, 1.0)?, points)?;
/// let handle = CurvatureHandle::prepare(&curve, &0.5)?;
/// let old = curve.curvature_at(&0.5)?;
/// handle.slide(&mut curve, &0.25)?;
/// assert!((curve.curvature_at(&0.5)? - old).abs() < 1e-14);
/// handle.set(&mut curve, &-0.1)?;
/// assert!((curve.curvature_at(&0.5)? + 0.1).abs() < 1e-14);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct CurvatureHandle<T> {
    x: T,
    drag: Drag<T>,
}

impl<T: Scalar> CurvatureHandle<T> {
    /// The handle of `curve` at `x`.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; those of [`Constraints::prepare`], as for degree one.
    pub fn prepare<S: Controlled<T, Parameter = T, Order = usize>>(curve: &S, x: &T) -> Result<Self> {
        Self::of(Constraints::on(curve), x)
    }

    /// The handle at `x` with some further wishes: control points held, weights of movement. Constraints among them stay as
    /// they are.
    ///
    /// # Errors
    /// As [`prepare`](Self::prepare).
    pub fn of<S: Controlled<T, Parameter = T, Order = usize>>(
        wishes: Constraints<'_, T, S>,
        x: &T,
    ) -> Result<Self> {
        let held = wishes.derivative(x, 0)?.derivative(x, 1)?.derivative(x, 2)?.prepare()?;
        Ok(Self { x: x.clone(), drag: held.matrix().clone() })
    }

    /// Adds `by` to the second derivative. On an error the curve stays as it is.
    ///
    /// # Errors
    /// As [`Drag::apply`].
    pub fn push<S: Controlled<T>>(&self, curve: &mut S, by: &S::Point) -> Result<()> {
        let mut changes = vec![by.zero_like(); self.drag.columns()];
        if let Some(last) = changes.last_mut() {
            *last = by.clone();
        }
        self.drag.apply(curve, &changes)
    }

    /// Adds `amount C'` to the second derivative, which keeps the curvature [FB, Figure 4 (b)].
    ///
    /// # Errors
    /// As [`push`](Self::push); [`Error::OutsideDomain`] for another curve.
    pub fn slide<S: Controlled<T, Parameter = T, Order = usize>>(
        &self,
        curve: &mut S,
        amount: &T,
    ) -> Result<()> {
        let along = curve.derivative_of(&self.x, 1)?.scaled(amount);
        self.push(curve, &along)
    }

    /// Multiplies the curvature by `factor`: the part of `C''` across `C'` [FB, Figure 4 (a)]. A negative factor bends to the
    /// other side.
    ///
    /// # Errors
    /// As [`slide`](Self::slide); [`Error::Stationary`] where `C'` vanishes.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{CurvatureHandle, Curve, Q, Scalar, SplineSpace};
    /// let points = [[0, 0], [1, 2], [3, 2], [4, 0]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
    /// let mut curve = Curve::new(SplineSpace::bezier(3, Q::int(0), Q::int(1))?, points.to_vec())?;
    /// let x = Q::frac(1, 3);
    /// let bend = |curve: &Curve<Q, 2>| {
    ///     let [_, d, e] = &curve.derivatives_at(&x, 2)?[..] else { unreachable!() };
    ///     Ok::<Q, symspline::Error>(d[0].clone() * &e[1] - d[1].clone() * &e[0])
    /// };
    /// let before = bend(&curve)?;
    /// CurvatureHandle::prepare(&curve, &x)?.scale(&mut curve, &Q::int(3))?;
    /// assert_eq!(bend(&curve)?, before * Q::int(3));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn scale<S, const N: usize>(&self, curve: &mut S, factor: &T) -> Result<()>
    where
        S: Controlled<T, Parameter = T, Order = usize, Point = SVector<T, N>>,
    {
        let across = self.across(curve)?;
        self.push(curve, &across.scaled(&(factor.clone() - T::one())))
    }

    /// The part of the second derivative across the first.
    fn across<S, const N: usize>(&self, curve: &S) -> Result<SVector<T, N>>
    where
        S: Controlled<T, Parameter = T, Order = usize, Point = SVector<T, N>>,
    {
        let (first, second) = (curve.derivative_of(&self.x, 1)?, curve.derivative_of(&self.x, 2)?);
        if first.vanishes() {
            return Err(Error::Stationary { parameter: self.x.to_string() });
        }
        let share = fraction_near(&first, &second);
        Ok(second.plus_scaled(&-share, &first))
    }
}

impl<T: Real> CurvatureHandle<T> {
    /// Gives the curve the curvature `kappa`: in the plane with its sign, in space along the normal it has.
    ///
    /// # Errors
    /// As [`scale`](Self::scale); [`Error::Straight`] if the curve in space has no normal there.
    pub fn set<S, const N: usize>(&self, curve: &mut S, kappa: &T) -> Result<()>
    where
        S: Controlled<T, Parameter = T, Order = usize, Point = SVector<T, N>>,
    {
        let across = self.across(curve)?;
        let first = curve.derivative_of(&self.x, 1)?;
        let speed = length(&first);
        let wanted = if N == 2 {
            // To the left of the tangent.
            let mut left = SVector::<T, N>::zeros();
            (left[0], left[1]) = (-first[1].clone(), first[0].clone());
            left.scaled(&(kappa.clone() * &speed))
        } else {
            let size = length(&across);
            if size.is_zero() {
                return Err(Error::Straight { parameter: self.x.to_string() });
            }
            across.scaled(&(kappa.clone() * &speed * &speed / size))
        };
        self.push(curve, &(wanted - across))
    }
}
