//! A curve with its derivative scaled.
//!
//! ```text
//! D(t) = C(a) + ∫_a^t α C'          [Miura, (1)]
//! D' = α C',   κ_D = κ / |α|        [Miura, (3)], (5) corrected
//! ```
//! With `C` of degree `n` and `α` of degree `q`, `D` has degree `n + q`; the tangent keeps its direction at every
//! parameter where `α > 0`.

use crate::error::Result;
use crate::ops::bound::{Approximation, out_of_tolerance};
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::{Curve, Function};
use crate::tensor::spline::TensorSpline;

/// A scale function `α`, and whether it must be positive.
///
/// A [`Function`] for curves, a [`TensorSpline`] for surfaces. It turns into [`Scale::Positive`] by itself; other signs are
/// asked for by name.
///
/// # Examples
/// ```
/// use symspline::{Error, Function, Q, Scale, Scalar, arc, segment};
/// use nalgebra::vector;
/// let line = segment(&vector![Q::int(0), Q::int(0)], &vector![Q::int(4), Q::int(0)])?;
/// let alpha = Function::monomial(1, Q::int(0), Q::int(1))?.translated(&Q::frac(-1, 2))?;
/// assert!(matches!(line.fine_tuned(&alpha), Err(Error::NotPositive { .. })));
/// let back = line.fine_tuned(Scale::Signed(&alpha))?;
/// assert_eq!(back.at(&Q::int(1))?, vector![Q::int(0), Q::int(0)]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub enum Scale<'a, F> {
    /// It must be positive, and that is proved before it is used.
    Positive(&'a F),
    /// It may have any sign: the tangent is reversed where it is negative, and the curve stands still at zeros.
    Signed(&'a F),
}

impl<'a, F> From<&'a F> for Scale<'a, F> {
    fn from(function: &'a F) -> Self {
        Self::Positive(function)
    }
}

impl<'a, F: ScaleFunction> Scale<'a, F> {
    /// The function, if its sign is as asked for.
    ///
    /// # Errors
    /// Those of [`positive_bound`](Function::positive_bound).
    pub fn function(self) -> Result<&'a F> {
        match self {
            Self::Positive(function) => function.check_positive().map(|()| function),
            Self::Signed(function) => Ok(function),
        }
    }
}

/// Functions that can be proved to be positive, of one parameter or of two.
pub trait ScaleFunction {
    /// Refuses functions that are not proved to be positive.
    ///
    /// # Errors
    /// Those of [`Function::positive_bound`].
    fn check_positive(&self) -> Result<()>;
}

impl<T: Scalar> ScaleFunction for Function<T> {
    fn check_positive(&self) -> Result<()> {
        self.positive_bound().map(drop)
    }
}

impl<T: Scalar> ScaleFunction for TensorSpline<T> {
    fn check_positive(&self) -> Result<()> {
        self.positive_bound().map(drop)
    }
}

impl<T: Scalar, const N: usize> Curve<T, N> {
    /// The curve that starts where this one does and has its derivative multiplied by `alpha`.
    ///
    /// For `C` of degree `n` an `alpha` of degree `n - 1` keeps the continuity of `C` with the fewest knots; the space of
    /// `C'` is one for it. The result is clamped. A periodic curve comes back open, since nothing holds its ends together:
    /// `fine_tuned_closed` and [`FineTuner::constrained`](crate::FineTuner::constrained) do that.
    ///
    /// # Errors
    /// [`NotPositive`](crate::Error::NotPositive), [`Undecided`](crate::Error::Undecided) unless `alpha` is proved to be
    /// positive, or allowed any sign by [`Scale::Signed`]; [`DomainMismatch`](crate::Error::DomainMismatch);
    /// [`Discontinuous`](crate::Error::Discontinuous) if the curve may jump; [`NotFinite`](crate::Error::NotFinite) on
    /// overflow.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Analyse, Curve, Function, SplineSpace};
    /// let points = vec![vector![0.0, 0.0], vector![1.0, 2.0], vector![2.0, 0.0]];
    /// let curve = Curve::new(SplineSpace::bezier(2, 0.0, 1.0)?, points)?;
    /// let alpha = Function::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![1.0, 2.0])?;
    /// let tuned = curve.fine_tuned(&alpha)?;
    /// let ratio = tuned.curvature_at(&0.5)? / curve.curvature_at(&0.5)?;
    /// assert!((ratio - 1.0 / 1.5).abs() < 1e-15);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn fine_tuned<'a>(&self, alpha: impl Into<Scale<'a, Function<T>>>) -> Result<Self> {
        self.fine_tuned_from_origin(alpha)?.translated(&self.at(self.domain().0)?)
    }

    /// The same moved so that it starts at the origin.
    pub(crate) fn fine_tuned_from_origin<'a>(
        &self,
        alpha: impl Into<Scale<'a, Function<T>>>,
    ) -> Result<Self> {
        let alpha = alpha.into().function()?;
        self.derivative()?.times(alpha)?.clamped_ends()?.antiderivative()
    }
}

impl<T: Scalar> SplineSpace<T> {
    /// A scale function of this space that makes of the curvature about `ratio` times what it was.
    ///
    /// ```text
    /// α ≈ 1 / ρ,     |κ_D / κ - ρ| <= bound · ρ
    /// ```
    /// It [quasi-interpolates](Self::quasi_interpolant) `1 / ρ`, and the bound is certified: with `|α ρ - 1| <= e` it is
    /// `e / (1 - e)`. A constant ratio is met exactly; for others more spans make the bound small.
    ///
    /// # Errors
    /// [`NotPositive`](crate::Error::NotPositive), [`Undecided`](crate::Error::Undecided) unless `ratio` is positive;
    /// [`DomainMismatch`](crate::Error::DomainMismatch); [`OutOfTolerance`](crate::Error::OutOfTolerance) if this space is too
    /// coarse to promise a positive scale; [`NotFinite`](crate::Error::NotFinite) on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// // From the curvature as it is to half of it.
    /// let ratio = Function::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![1.0, 0.5])?;
    /// let alpha = SplineSpace::uniform(2, 8, 0.0, 1.0)?.scale_for_curvature_ratio(&ratio)?;
    /// assert!((alpha.spline.at(&1.0)? - 2.0).abs() < 1e-3 && alpha.bound < 1e-3);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn scale_for_curvature_ratio(&self, ratio: &Function<T>) -> Result<Approximation<Function<T>, T>> {
        self.check_same_domain(ratio.space())?;
        ratio.positive_bound()?;
        let mut span = ratio.degree();
        let spline = self.quasi_interpolant(|x| Ok(T::one() / ratio.at_near(x, &mut span)?))?;
        let product = spline.times(ratio)?;
        let one = Function::constant(product.space().clone(), T::one())?;
        let error = product.distance_bound_halved(&one, 3)?;
        let rest = T::one() - &error;
        if rest <= T::zero() {
            return Err(out_of_tolerance(&error, &T::one()));
        }
        Ok(Approximation { spline, bound: error / rest })
    }
}
