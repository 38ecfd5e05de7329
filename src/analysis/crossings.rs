//! Where a curve meets lines and planes, and the feet of perpendiculars: zeros of one function of the curve.

use crate::analysis::analyse::sealed;
use crate::analysis::certify::Certified;
use crate::analysis::certify::condition::{Condition, What};
use crate::analysis::zeros::{Zero, zeros};
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::vector::Crossed;
use nalgebra::SVector;

impl<T: Certified, const N: usize, L: sealed::Liftable<T, N>> Crossings<T, N> for L {}

/// Every place where a curve meets a line or plane, with a proof, for [`Curve`](crate::Curve) and
/// [`NurbsCurve`](crate::NurbsCurve) alike.
///
/// Exact over [`Q`](crate::Q); `f64` means the exact numbers that the floats are.
pub trait Crossings<T: Certified, const N: usize>: sealed::Liftable<T, N> {
    /// Where the curve meets the line (in the plane) or plane (in space) of all `x` with `normal · x = offset`: every
    /// place, proved. A curve that runs along it for whole spans is reported as intervals. `before` and `after` tell on
    /// which side the curve is.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::NoLength`] for a normal that is zero.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Crossings, Place, Q, Scalar, circle};
    /// use symspline::roots::RootValue;
    /// // The unit circle is touched at its top, once.
    /// let circle = circle(&vector![Q::int(0), Q::int(0)], &Q::int(1))?;
    /// let top = circle.crossings(&vector![Q::int(0), Q::int(5)], &Q::int(5))?;
    /// assert_eq!((top.len(), top[0].multiplicity, top[0].changes_sign()), (1, 2, false));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn crossings(&self, normal: &SVector<T, N>, offset: &T) -> Result<Vec<Zero<T>>> {
        check_finite("normal", normal.iter())?;
        check_finite("offset", [offset])?;
        if normal.iter().all(T::is_zero) {
            return Err(Error::NoLength);
        }
        let what = What::Above { normal: normal.clone(), offset: offset.clone() };
        zeros(&Condition { curve: self.to_lifted()?, what })
    }

    /// Where a plane curve meets the line through `origin` along `direction`: every place, proved, as by
    /// [`crossings`](Self::crossings), and without rounding the line. `before` and `after` are `Greater` where the
    /// curve is left of it.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::NoLength`] for a direction that is zero.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use std::cmp::Ordering;
    /// use symspline::{Crossings, circle};
    /// let circle = circle(&vector![0.0, 0.0], &1.0)?;
    /// let places = circle.meet_line(&vector![0.0, 0.5], &vector![1.0, 0.0])?;
    /// assert_eq!((places.len(), places[0].after), (2, Some(Ordering::Greater)));
    /// let (low, high) = places[0].place.bounds();
    /// assert!((circle.at(low)?[1] - 0.5).abs() < 1e-15 && high - low < 1e-15);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn meet_line(&self, origin: &SVector<T, N>, direction: &SVector<T, N>) -> Result<Vec<Zero<T>>>
    where
        SVector<T, N>: Crossed<T, Product = T>,
    {
        check_finite("coordinate", origin.iter().chain(direction.iter()))?;
        if direction.iter().all(T::is_zero) {
            return Err(Error::NoLength);
        }
        let what = What::Left { origin: origin.clone(), direction: direction.clone() };
        zeros(&Condition { curve: self.to_lifted()?, what })
    }

    /// The feet of all perpendiculars from `point` to the curve: where the distance has a slope of zero, or turns at a
    /// knot, proved. The nearest point is one of them, or an end. Where the curve stands still there is one too; an arc
    /// about the point is an interval.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::TooLarge`], [`Error::DegreeTooHigh`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Crossings, Curve, Q, Scalar, SplineSpace};
    /// let points = [[-1, 1], [0, -1], [1, 1]].map(|c| c.map(Q::int).into());
    /// let parabola = Curve::new(SplineSpace::bezier(2, Q::int(-1), Q::int(1))?, points.to_vec())?;
    /// // From (0, 1): the vertex is farther than the two feet beside it, at ±√½.
    /// let feet = parabola.feet(&vector![Q::int(0), Q::int(1)])?;
    /// assert_eq!(feet.len(), 3);
    /// let (low, high) = feet[2].place.bounds();
    /// assert!(low * low < Q::frac(1, 2) && Q::frac(1, 2) < high * high);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn feet(&self, point: &SVector<T, N>) -> Result<Vec<Zero<T>>> {
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
