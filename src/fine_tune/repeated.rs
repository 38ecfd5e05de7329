//! Fine tuning again and again without raising the degree.
//!
//! After each step the tuned portion, of degree `n + q`, is approximated by a spline of the degree `n` that the curve had,
//! with knots only where the error asks for them [Miura, 2.3], and with the same derivatives at the ends of the portion as
//! far as they are held. The paper bounds nothing; here the distance is certified.

use crate::error::{Error, Result};
use crate::fine_tune::hold::Hold;
use crate::fine_tune::local::LocallyTuned;
use crate::fine_tune::scale::Scale;
use crate::fine_tune::turn::Turnable;
use crate::ops::bound::{Approximation, check_tolerance, out_of_tolerance};
use crate::ops::project::Contact;
use crate::scalar::Scalar;
use crate::spline::{Curve, Function};
use nalgebra::SVector;

/// How many times bounds halve the pieces of the difference.
const HALVINGS: usize = 3;

impl<T: Scalar, const N: usize> LocallyTuned<T, N> {
    /// One spline of the degree that the curve had, within `tolerance` of [`joined`](Self::joined), a distance between
    /// points.
    ///
    /// The tuned portion is [approximated](Curve::approximated_within) by least squares, in the space of the curve refined
    /// where the error asks for it, and keeps the derivatives that are held. Outside the portion nothing changes: control
    /// points are those of the curve with `n`, `n - 1` or `n - 2` copies of `a` and `b` inserted, for held points,
    /// tangents and curvatures, fewer only if they were there before. So steps can follow one another.
    ///
    /// The bound is of the distance from [`joined`](Self::joined). Over inexact fields an eighth of the tolerance is left
    /// for rounding.
    ///
    /// # Errors
    /// [`BadTolerance`](crate::Error::BadTolerance); [`OutOfTolerance`](crate::Error::OutOfTolerance) if that cannot be
    /// reached or proved; [`DegreeTooLow`](crate::Error::DegreeTooLow) if the degree is below the order of the derivatives
    /// that are held. Those of [`approximated_within`](Curve::approximated_within).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, Function, Hold, SplineSpace};
    /// let points = vec![vector![0.0, 0.0], vector![1.0, 2.0], vector![3.0, 2.0], vector![4.0, 0.0]];
    /// let mut curve = Curve::new(SplineSpace::clamped(2, [0.0, 2.0, 4.0])?, points)?;
    /// for (a, b) in [(1.0, 2.0), (0.5, 3.0)] {
    ///     let alpha = Function::new(SplineSpace::bezier(1, a, b)?, vec![1.0, 2.0])?;
    ///     let reduced = curve.fine_tuned_on(&alpha, Hold::Tangents)?.reduced(&1e-3)?;
    ///     assert!(reduced.bound <= 1e-3 && reduced.spline.degree() == 2);
    ///     curve = reduced.spline;
    /// }
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "degree reduction")]
    pub fn reduced(&self, tolerance: &T) -> Result<Approximation<Curve<T, N>, T>> {
        check_tolerance(tolerance)?;
        let (a, b) = self.portion();
        let start = self.original().space().restricted_space(a, b)?;
        let aim = if T::EXACT { tolerance.clone() } else { tolerance.clone() * T::frac(7, 8) };
        let contact = Contact::both(self.order() + 1);
        let near =
            self.tuned().curve.approximated_within(&start, &aim, contact).map_err(|error| match error {
                Error::OutOfTolerance { bound, .. } => {
                    Error::OutOfTolerance { bound, tolerance: tolerance.to_string() }
                }
                other => other,
            })?;
        let spline = self.with_portion(&near.spline)?;
        if T::EXACT {
            return Ok(Approximation { spline, bound: near.bound });
        }
        let bound = spline.distance_bound_halved(&self.joined()?, HALVINGS)?;
        if bound <= *tolerance {
            Ok(Approximation { spline, bound })
        } else {
            Err(out_of_tolerance(&bound, tolerance))
        }
    }
}

impl<T: Scalar, const N: usize> Curve<T, N>
where
    SVector<T, N>: Turnable<T>,
{
    /// The curve fine-tuned over the domain of `alpha`, the whole or a portion, with its degree kept: within `tolerance` of
    /// what [`fine_tuned_on`](Self::fine_tuned_on) makes.
    ///
    /// # Errors
    /// Those of [`fine_tuned_on`](Self::fine_tuned_on) and of [`reduced`](LocallyTuned::reduced).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, Function, Hold, SplineSpace};
    /// let points = vec![vector![0.0, 0.0], vector![1.0, 2.0], vector![3.0, 2.0], vector![4.0, 0.0]];
    /// let curve = Curve::new(SplineSpace::clamped(2, [0.0, 2.0, 4.0])?, points)?;
    /// let alpha = Function::new(SplineSpace::bezier(1, 0.0, 4.0)?, vec![1.0, 2.0])?;
    /// let tuned = curve.fine_tuned_within(&alpha, Hold::Points, &1e-2)?;
    /// assert!(tuned.bound <= 1e-2 && tuned.spline.degree() == 2);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn fine_tuned_within<'a>(
        &self,
        alpha: impl Into<Scale<'a, Function<T>>>,
        hold: Hold,
        tolerance: &T,
    ) -> Result<Approximation<Self, T>> {
        check_tolerance(tolerance)?;
        self.fine_tuned_on(alpha, hold)?.reduced(tolerance)
    }
}
