//! What is said alike of polynomial and rational curves in the plane and in space.

use crate::analysis::certify::Certified;
use crate::analysis::certify::condition::{Condition, What};
use crate::analysis::lifted::Lifted;
use crate::analysis::pieces::Pieces;
use crate::analysis::profile::{self, CurvatureProfile};
use crate::analysis::zeros::{Zero, zeros};
use crate::error::{Error, Result};
use crate::rational::spline::{NurbsCurve, RationalFunction};
use crate::scalar::Scalar;
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
    }
}

impl<T: Scalar, const N: usize> sealed::Liftable<T, N> for Curve<T, N> {
    fn to_lifted(&self) -> Result<Lifted<T, N>> {
        Ok(Lifted::polynomial(self))
    }
}

impl<T: Scalar, const N: usize> sealed::Liftable<T, N> for NurbsCurve<T, N> {
    fn to_lifted(&self) -> Result<Lifted<T, N>> {
        Lifted::rational(self)
    }
}

impl<T: Scalar, const N: usize, L: sealed::Liftable<T, N>> Analyse<T, N> for L {}

/// Curvature as algebra and with certificates, for [`Curve`] and [`NurbsCurve`] alike.
///
/// All of it is exact over [`Q`](crate::Q). Where a proof is promised, `f64` means the exact numbers that the floats are.
/// Functions are given piece by piece: their spaces have every knot as often as it may be.
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

    /// A function with the sign of the curvature in the plane, and with the zeros of the curvature in space: `C' × C''` or its
    /// square, times a power of the weight.
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
        profile::profile(self.to_lifted()?)
    }

    /// Where the curve meets the line (in the plane) or plane (in space) of all `x` with `normal · x = offset`: every place,
    /// proved. A curve that runs along it for whole spans is reported as intervals. `before` and `after` tell on which side the
    /// curve is.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::NoLength`] for a normal that is zero.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Analyse, Place, Q, Scalar, circle};
    /// use symspline::roots::RootValue;
    /// // The unit circle is touched at its top, once.
    /// let circle = circle(&vector![Q::int(0), Q::int(0)], &Q::int(1))?;
    /// let top = circle.crossings(&vector![Q::int(0), Q::int(5)], &Q::int(5))?;
    /// assert_eq!((top.len(), top[0].multiplicity, top[0].changes_sign()), (1, 2, false));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn crossings(&self, normal: &SVector<T, N>, offset: &T) -> Result<Vec<Zero<T>>>
    where
        T: Certified,
    {
        check_finite("normal", normal.iter())?;
        check_finite("offset", [offset])?;
        if normal.iter().all(T::is_zero) {
            return Err(Error::NoLength);
        }
        let what = What::Above { normal: normal.clone(), offset: offset.clone() };
        zeros(&Condition { curve: self.to_lifted()?, what })
    }

    /// The feet of all perpendiculars from `point` to the curve: where the distance has a slope of zero, or turns at a knot, proved. The nearest
    /// point is one of them, or an end. Where the curve stands still there is one too; an arc about the point is an interval.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::TooLarge`], [`Error::DegreeTooHigh`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Analyse, Curve, Q, Scalar, SplineSpace};
    /// let points = [[-1, 1], [0, -1], [1, 1]].map(|c| c.map(Q::int).into());
    /// let parabola = Curve::new(SplineSpace::bezier(2, Q::int(-1), Q::int(1))?, points.to_vec())?;
    /// // From (0, 1): the vertex is farther than the two feet beside it, at ±√½.
    /// let feet = parabola.feet(&vector![Q::int(0), Q::int(1)])?;
    /// assert_eq!(feet.len(), 3);
    /// let (low, high) = feet[2].place.bounds();
    /// assert!(low * low < Q::frac(1, 2) && Q::frac(1, 2) < high * high);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn feet(&self, point: &SVector<T, N>) -> Result<Vec<Zero<T>>>
    where
        T: Certified,
    {
        check_finite("coordinate", point.iter())?;
        zeros(&Condition { curve: self.to_lifted()?, what: What::Foot { point: point.clone() } })
    }
}

/// Refuses numbers that are not finite.
fn check_finite<'a, T: Scalar>(what: &'static str, numbers: impl IntoIterator<Item = &'a T>) -> Result<()> {
    match numbers.into_iter().position(|x| !x.is_finite()) {
        Some(index) => Err(Error::NotFinite { what, index }),
        None => Ok(()),
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
