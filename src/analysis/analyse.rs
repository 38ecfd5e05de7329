//! What is said alike of polynomial and rational curves in the plane and in space.

use crate::analysis::certify::Certified;
use crate::analysis::certify::condition::{Condition, What};
use crate::analysis::curvature::{Curved, tooth};
use crate::analysis::lifted::Lifted;
use crate::analysis::pieces::Pieces;
use crate::analysis::profile::{self, CurvatureProfile};
use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::rational::spline::{NurbsCurve, RationalFunction};
use crate::scalar::{Real, Scalar};
use crate::spline::{Curve, Function};
use crate::vector::{Crossed, dot};
use nalgebra::SVector;

pub(crate) mod sealed {
    use super::*;

    /// A curve as points and weights.
    pub trait Liftable<T, const N: usize> {
        /// Points and weights.
        ///
        /// # Errors
        /// None for a valid curve.
        fn to_lifted(&self) -> Result<Lifted<T, N>>;

        /// Value and derivatives at `x`, from the right.
        ///
        /// # Errors
        /// [`Error::OutsideDomain`].
        fn derivatives(&self, x: &T, order: usize) -> Result<Vec<SVector<T, N>>>;
    }
}

impl<T: Scalar, const N: usize> sealed::Liftable<T, N> for Curve<T, N> {
    fn to_lifted(&self) -> Result<Lifted<T, N>> {
        Ok(Lifted::polynomial(self))
    }

    fn derivatives(&self, x: &T, order: usize) -> Result<Vec<SVector<T, N>>> {
        self.derivatives_at(x, order)
    }
}

impl<T: Scalar, const N: usize> sealed::Liftable<T, N> for NurbsCurve<T, N> {
    fn to_lifted(&self) -> Result<Lifted<T, N>> {
        Lifted::rational(self)
    }

    fn derivatives(&self, x: &T, order: usize) -> Result<Vec<SVector<T, N>>> {
        self.derivatives_at(x, order)
    }
}

impl<T: Scalar, const N: usize, L: sealed::Liftable<T, N>> Analyse<T, N> for L {}

/// Curvature as algebra and with certificates, for [`Curve`] and [`NurbsCurve`] alike.
///
/// All of it is exact over [`Q`](crate::Q). Where a proof is promised, `f64` means the exact numbers that the floats
/// are. Functions are given piece by piece: their spaces have every knot as often as it may be.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Analyse, EventKind, ellipse};
/// let ellipse = ellipse(&vector![0.0, 0.0], &vector![3.0, 0.0], &vector![0.0, 1.0])?;
/// let profile = ellipse.profile()?;
/// // Four vertices, proved.
/// assert_eq!(profile.count(EventKind::Maximum) + profile.count(EventKind::Minimum), 4);
/// # Ok::<(), symspline::Error>(())
/// ```
pub trait Analyse<T: Scalar, const N: usize>: sealed::Liftable<T, N> {
    /// The curvature at `x`, from the right: signed in the plane (positive where the curve turns left), not negative in
    /// space.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::Stationary`] where the derivative vanishes; [`Error::NotFinite`] where the
    /// curvature overflows.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Analyse, Curve, SplineSpace};
    /// let points = vec![vector![-1.0, 1.0], vector![0.0, -1.0], vector![1.0, 1.0]];
    /// let parabola = Curve::new(SplineSpace::bezier(2, -1.0, 1.0)?, points)?; // y = x²
    /// assert_eq!(parabola.curvature_at(&0.0)?, 2.0);
    /// assert_eq!(parabola.reversed()?.curvature_at(&0.0)?, -2.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn curvature_at(&self, x: &T) -> Result<T>
    where
        T: Real,
        SVector<T, N>: Curved<T>,
    {
        let derivatives = self.derivatives(x, 2)?;
        match Curved::curvature(&derivatives[1], &derivatives[2]) {
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
    /// use symspline::{Analyse, Curve, SplineSpace};
    /// let points = vec![vector![-1.0, 1.0], vector![0.0, -1.0], vector![1.0, 1.0]];
    /// let parabola = Curve::new(SplineSpace::bezier(2, -1.0, 1.0)?, points)?;
    /// let profile = parabola.curvature_profile(&[-1.0, 0.0, 1.0])?;
    /// assert!(profile[1] == 2.0 && profile[0] == profile[2] && profile[0] < 0.2);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn curvature_profile(&self, parameters: &[T]) -> Result<Vec<T>>
    where
        T: Real,
        SVector<T, N>: Curved<T>,
    {
        parameters.iter().map(|x| self.curvature_at(x)).collect()
    }

    /// The curvature comb: at each parameter the point of the curve and the tip of its tooth, which stands
    /// `scale * |κ|` off on the outer side. See [`CurvatureProfile::comb_scale`] for a scale.
    ///
    /// # Errors
    /// As [`curvature_at`](Self::curvature_at).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Analyse, Curve, SplineSpace};
    /// let points = vec![vector![-1.0, 1.0], vector![0.0, -1.0], vector![1.0, 1.0]];
    /// let parabola = Curve::new(SplineSpace::bezier(2, -1.0, 1.0)?, points)?;
    /// assert_eq!(parabola.curvature_comb(&[0.0], &0.5)?, [(vector![0.0, 0.0], vector![0.0, -1.0])]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn curvature_comb(&self, parameters: &[T], scale: &T) -> Result<Vec<(SVector<T, N>, SVector<T, N>)>>
    where
        T: Real,
    {
        let pair = |x: &T| {
            let derivatives = self.derivatives(x, 2)?;
            let tip =
                tooth(&derivatives, scale).ok_or_else(|| Error::Stationary { parameter: x.to_string() })?;
            if !tip.all_finite() {
                return Err(Error::NotFinite { what: "tooth", index: 0 });
            }
            Ok((derivatives[0].clone(), tip))
        };
        parameters.iter().map(pair).collect()
    }

    /// The squared speed, `|C'|²`.
    ///
    /// # Errors
    /// [`Error::TooLarge`], [`Error::DegreeTooHigh`], [`Error::NotFinite`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Analyse, Curve, SplineSpace};
    /// let points = vec![vector![0.0, 0.0], vector![3.0, 4.0]];
    /// let line = Curve::new(SplineSpace::bezier(1, 0.0, 1.0)?, points)?;
    /// assert_eq!(line.speed_squared()?.at(&0.5)?, 25.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn speed_squared(&self) -> Result<RationalFunction<T>> {
        let motion = self.to_lifted()?.motion(1)?;
        quotient(motion.speed()?, motion.weights().map(|weight| power(weight, 4)).transpose()?)
    }

    /// The squared curvature, `|C' × C''|² / |C'|⁶`.
    ///
    /// # Errors
    /// [`Error::Pole`] where the curve stands still; [`Error::Undecided`] where it nearly does; and those of
    /// [`speed_squared`](Self::speed_squared).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Analyse, Q, Scalar, circle};
    /// let circle = circle(&vector![Q::int(1), Q::int(2)], &Q::int(3))?;
    /// assert_eq!(circle.curvature_squared()?.at(&Q::frac(1, 7))?, Q::frac(1, 9));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn curvature_squared(&self) -> Result<RationalFunction<T>>
    where
        SVector<T, N>: Crossed<T>,
    {
        let motion = self.to_lifted()?.motion(2)?;
        let bend = motion.bend()?;
        let (square, speed) = (bend.times(&bend, dot)?, motion.speed()?);
        let numerator = match motion.weights() {
            Some(weight) => power(weight, 6)?.product(&square)?,
            None => square,
        };
        quotient(numerator, Some(power(&speed, 3)?))
    }

    /// The torsion, `(C' × C'') · C''' / |C' × C''|²`; in the plane it is zero.
    ///
    /// # Errors
    /// [`Error::Pole`] where the curvature vanishes; and those of [`speed_squared`](Self::speed_squared).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Analyse, Curve, Q, Scalar, SplineSpace};
    /// // (x, x², x³): torsion 3 where curvature is 2.
    /// let points = [[0, 0, 0], [1, 0, 0], [2, 1, 0], [3, 3, 3]].map(|c| c.map(|x| Q::frac(x, 3)));
    /// let cubic = Curve::new(SplineSpace::bezier(3, Q::int(0), Q::int(1))?, points.map(Into::into).to_vec())?;
    /// assert_eq!(cubic.torsion()?.at(&Q::int(0))?, Q::int(3));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn torsion(&self) -> Result<RationalFunction<T>>
    where
        SVector<T, N>: Crossed<T>,
    {
        let motion = self.to_lifted()?.motion(3)?;
        let (twist, bend) = (motion.twist()?, motion.bend()?);
        let numerator = match motion.weights() {
            Some(weight) => weight.product(&twist)?,
            None => twist,
        };
        quotient(numerator, Some(bend.times(&bend, dot)?))
    }

    /// A function with the sign of the curvature in the plane, and with the zeros of the curvature in space: `C' × C''`
    /// or its square, times a power of the weight.
    ///
    /// # Errors
    /// As [`speed_squared`](Self::speed_squared).
    fn bend_condition(&self) -> Result<Function<T>>
    where
        SVector<T, N>: Crossed<T>,
    {
        Condition { curve: self.to_lifted()?, what: What::Bend }.function()?.into_spline()
    }

    /// A function with the sign of the slope of the curvature: its sign changes are the extrema of the curvature.
    ///
    /// ```text
    /// (C'×C''') |C'|² - 3 (C'×C'') (C'·C'')        in space times C'×C''
    /// ```
    /// for a polynomial curve; for a rational one the same of its homogeneous coordinates.
    ///
    /// # Errors
    /// As [`speed_squared`](Self::speed_squared).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Analyse, Curve, SplineSpace};
    /// let points = vec![vector![-1.0, 1.0], vector![0.0, -1.0], vector![1.0, 1.0]];
    /// let parabola = Curve::new(SplineSpace::bezier(2, -1.0, 1.0)?, points)?;
    /// // Its vertex is the one place where the sign changes.
    /// let zeros = parabola.slope_condition()?.zeros()?;
    /// assert!(zeros.len() == 1 && zeros[0].changes_sign());
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn slope_condition(&self) -> Result<Function<T>>
    where
        SVector<T, N>: Crossed<T>,
    {
        Condition { curve: self.to_lifted()?, what: What::Slope }.function()?.into_spline()
    }

    /// The curvature profile: all its events, proved, and samples to draw.
    ///
    /// # Errors
    /// [`Error::TooLarge`], [`Error::DegreeTooHigh`].
    ///
    /// # Examples
    /// See [`CurvatureProfile`].
    fn profile(&self) -> Result<CurvatureProfile<T>>
    where
        T: Certified,
        SVector<T, N>: Crossed<T>,
    {
        profile::profile(self.to_lifted()?, 0.0)
    }

    /// The profile of a curve that is meant to be smooth: corners that turn by no more than the angle `tolerance`, and
    /// jumps of the curvature by no more than that part of it, are passed over. Everything between knots is proved as
    /// before.
    ///
    /// # Errors
    /// [`Error::BadTolerance`] unless `tolerance` is finite and not negative; and those of [`profile`](Self::profile).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Analyse, Curve, EventKind, SplineSpace};
    /// // Two parabolas with nearly the same tangent in 1.
    /// let space = SplineSpace::clamped(2, [0.0, 1.0, 1.0, 2.0])?;
    /// let points = [[0.0, 0.0], [1.0, 1.0], [2.0, 1.0], [3.0, 1.0001], [4.0, 0.0]];
    /// let c = Curve::new(space, points.map(Into::into).to_vec())?;
    /// assert_eq!(c.profile()?.count(EventKind::Corner), 1);
    /// assert_eq!(c.profile_within(0.001)?.count(EventKind::Corner), 0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn profile_within(&self, tolerance: f64) -> Result<CurvatureProfile<T>>
    where
        T: Certified,
        SVector<T, N>: Crossed<T>,
    {
        if !tolerance.is_finite() || tolerance < 0.0 {
            return Err(Error::BadTolerance { tolerance: tolerance.to_string() });
        }
        profile::profile(self.to_lifted()?, tolerance)
    }
}

/// A power of a function, at least the first.
fn power<T: Scalar>(function: &Pieces<T>, exponent: usize) -> Result<Pieces<T>> {
    (1..exponent).try_fold(function.clone(), |power, _| power.product(function))
}

/// A quotient as a rational function.
fn quotient<T: Scalar>(numerator: Pieces<T>, denominator: Option<Pieces<T>>) -> Result<RationalFunction<T>> {
    let numerator = numerator.into_spline()?;
    match denominator {
        Some(denominator) => RationalFunction::from_quotient(&numerator, &denominator.into_spline()?),
        None => RationalFunction::from_polynomial(&numerator),
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
