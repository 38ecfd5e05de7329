//! Curvature of curves: signed in the plane, not negative in space.
//!
//! ```text
//! κ = C' × C'' / |C'|³        (in space |C' × C''|)          [Miura, (2)]
//! ```

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::scalar::Real;
use crate::spline::{Curve, Spline};
use crate::vector::{cross2, cross3, dot, length, unit};
use nalgebra::SVector;

/// Points whose curves have a curvature: those of the plane and of space.
pub trait Curved<T: Real>: Coeff<T> {
    /// The curvature of a curve with these first and second derivatives, if the first does not vanish.
    fn curvature(first: &Self, second: &Self) -> Option<T>;
}

impl<T: Real> Curved<T> for SVector<T, 2> {
    fn curvature(first: &Self, second: &Self) -> Option<T> {
        let (tangent, speed) = unit(first)?;
        Some(cross2(&tangent, second) / &speed / speed)
    }
}

impl<T: Real> Curved<T> for SVector<T, 3> {
    fn curvature(first: &Self, second: &Self) -> Option<T> {
        let (tangent, speed) = unit(first)?;
        Some(length(&cross3(&tangent, second)) / &speed / speed)
    }
}

impl<T: Real, C: Curved<T>> Spline<T, C> {
    /// The curvature at `x`, from the right.
    ///
    /// Signed in the plane (positive where the curve turns left), not negative in space.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::Stationary`] where the derivative vanishes; [`Error::NotFinite`] where the
    /// curvature overflows.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// let points = vec![vector![-1.0, 1.0], vector![0.0, -1.0], vector![1.0, 1.0]];
    /// let parabola = Curve::new(SplineSpace::bezier(2, -1.0, 1.0)?, points)?; // y = x²
    /// assert_eq!(parabola.curvature_at(&0.0)?, 2.0);
    /// assert_eq!(parabola.reversed()?.curvature_at(&0.0)?, -2.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn curvature_at(&self, x: &T) -> Result<T> {
        let derivatives = self.derivatives_at(x, 2)?;
        match C::curvature(&derivatives[1], &derivatives[2]) {
            Some(curvature) if curvature.is_finite() => Ok(curvature),
            Some(_) => Err(Error::NotFinite { what: "curvature", index: 0 }),
            None => Err(Error::Stationary { parameter: x.to_string() }),
        }
    }

    /// The curvatures at `parameters`.
    ///
    /// # Errors
    /// As [`curvature_at`](Self::curvature_at).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// let points = vec![vector![-1.0, 1.0], vector![0.0, -1.0], vector![1.0, 1.0]];
    /// let parabola = Curve::new(SplineSpace::bezier(2, -1.0, 1.0)?, points)?;
    /// let profile = parabola.curvature_profile(&[-1.0, 0.0, 1.0])?;
    /// assert!(profile[1] == 2.0 && profile[0] == profile[2] && profile[0] < 0.2);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn curvature_profile(&self, parameters: &[T]) -> Result<Vec<T>> {
        parameters.iter().map(|x| self.curvature_at(x)).collect()
    }
}

impl<T: Real, const N: usize> Curve<T, N> {
    /// The curvature comb: at each parameter the point of the curve and the tip of its tooth, which stands
    /// `scale * |κ|` off on the outer side.
    ///
    /// # Errors
    /// As [`curvature_at`](Spline::curvature_at).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// let points = vec![vector![-1.0, 1.0], vector![0.0, -1.0], vector![1.0, 1.0]];
    /// let parabola = Curve::new(SplineSpace::bezier(2, -1.0, 1.0)?, points)?;
    /// assert_eq!(parabola.curvature_comb(&[0.0], &0.5)?, [(vector![0.0, 0.0], vector![0.0, -1.0])]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn curvature_comb(&self, parameters: &[T], scale: &T) -> Result<Vec<(SVector<T, N>, SVector<T, N>)>> {
        let tooth = |x: &T| {
            let derivatives = self.derivatives_at(x, 2)?;
            let (tangent, speed) =
                unit(&derivatives[1]).ok_or_else(|| Error::Stationary { parameter: x.to_string() })?;
            // The part of C'' across the tangent, over the squared speed, points inwards with length κ.
            let across = derivatives[2].plus_scaled(&-dot(&tangent, &derivatives[2]), &tangent);
            let tip = derivatives[0].plus_scaled(&-(scale.clone() / &speed / speed), &across);
            if !tip.all_finite() {
                return Err(Error::NotFinite { what: "tooth", index: 0 });
            }
            Ok((derivatives[0].clone(), tip))
        };
        parameters.iter().map(tooth).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::SplineSpace;
    use nalgebra::vector;

    fn parabola(size: f64) -> Curve<f64, 2> {
        let points = vec![vector![-size, size], vector![0.0, -size], vector![size, size]];
        Curve::new(SplineSpace::bezier(2, -1.0, 1.0).unwrap(), points).unwrap()
    }

    #[test]
    fn curvature_has_the_inverse_unit() {
        for size in [1e-300, 1e-150, 1e150, 1e300] {
            assert!(
                (parabola(size).curvature_at(&0.5).unwrap() * size - 0.5_f64.sqrt()).abs() < 1e-14,
                "{size}"
            );
        }
    }

    #[test]
    fn curvature_beyond_the_range_is_an_error() {
        assert_eq!(
            parabola(1e-310).curvature_at(&0.0),
            Err(Error::NotFinite { what: "curvature", index: 0 })
        );
    }

    #[test]
    fn a_point_has_no_curvature() {
        let point = Curve::constant(SplineSpace::bezier(3, 0.0, 1.0).unwrap(), vector![1.0, 2.0]).unwrap();
        for x in [0.0, 0.065_074_244_953_946_05, 1.0] {
            assert!(matches!(point.curvature_at(&x), Err(Error::Stationary { .. })));
        }
    }
}
