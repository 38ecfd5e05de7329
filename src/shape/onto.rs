//! Projections of points onto lines and planes.
//!
//! ```text
//! plane through Q across N, along W:       P + α W,  α = (Q - P)·N / (W·N)
//! line in space through Q along D:         Q + x D,  x = (P - Q)·M / (D·M)
//! ```
//! A line in the plane is a plane there: `α = (Q - P) × D / (W × D)` [NURBS, section 11.4.2].

use crate::coeff::Coeff;
use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::shape::root::{divided, size, sure_dot};
use crate::vector::dot;
use nalgebra::{SVector, vector};

/// A line or plane that points are projected onto, and how.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::Onto;
/// let diagonal = Onto::line(vector![0.0, 0.0], vector![1.0, 1.0])?;
/// assert_eq!(diagonal.projected(&vector![2.0, 0.0]), vector![1.0, 1.0]);
/// let upwards = Onto::line_along(vector![0.0, 0.0], vector![1.0, 1.0], vector![0.0, 1.0])?;
/// assert_eq!(upwards.projected(&vector![2.0, 0.0]), vector![2.0, 2.0]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Onto<T, const N: usize> {
    origin: SVector<T, N>,
    kind: Kind<T, N>,
}

#[derive(Clone, Debug, PartialEq)]
enum Kind<T, const N: usize> {
    /// Onto what is across `normal`; `rate` is `along · normal`.
    Plane { normal: SVector<T, N>, along: SVector<T, N>, rate: T },
    /// Onto what runs in `direction`; `rate` is `direction · across`.
    Line { direction: SVector<T, N>, across: SVector<T, N>, rate: T },
}

/// One of the two sides of a line or plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// The side its normal points to; of a line in the plane the left one.
    Positive,
    /// The other side.
    Negative,
}

/// Two vectors and their product, which is not zero.
fn paired<T: Scalar, const N: usize>(
    [(what, v), (other, w)]: [(&'static str, SVector<T, N>); 2],
) -> Result<(SVector<T, N>, SVector<T, N>, T)> {
    for (what, v) in [(what, &v), (other, &w)] {
        if v.vanishes() || !v.all_finite() {
            return Err(ShapeError::NoDirection { what }.into());
        }
    }
    let most = T::int(1 << 60);
    let is_moderate = |x: &T| *x <= most && T::one() <= x.clone() * &most;
    let moderate = |v: SVector<T, N>| match size(&v) {
        x if is_moderate(&x) => v,
        x => divided(&v, &x),
    };
    // So that no product overflows or vanishes.
    let (v, w) = (moderate(v), moderate(w));
    let rate = sure_dot(&v, &w);
    if rate.is_zero() { Err(ShapeError::ParallelProjection.into()) } else { Ok((v, w, rate)) }
}

/// Refuses an origin that is not finite.
fn check_origin<T: Scalar, const N: usize>(origin: &SVector<T, N>) -> Result<()> {
    if origin.all_finite() { Ok(()) } else { Err(Error::NotFinite { what: "origin", index: 0 }) }
}

/// `v` turned left by a right angle.
fn left<T: Scalar>(v: &SVector<T, 2>) -> SVector<T, 2> {
    vector![-v[1].clone(), v[0].clone()]
}

impl<T: Scalar> Onto<T, 2> {
    /// The line through `origin` in `direction`, reached at a right angle.
    ///
    /// # Errors
    /// [`ShapeError::NoDirection`]; [`Error::NotFinite`] for the origin.
    pub fn line(origin: SVector<T, 2>, direction: SVector<T, 2>) -> Result<Self> {
        let normal = left(&direction);
        Self::line_along(origin, direction, normal)
    }

    /// The line through `origin` in `direction`, reached along `along`.
    ///
    /// # Errors
    /// [`ShapeError::NoDirection`]; [`ShapeError::ParallelProjection`]; [`Error::NotFinite`] for the origin.
    pub fn line_along(origin: SVector<T, 2>, direction: SVector<T, 2>, along: SVector<T, 2>) -> Result<Self> {
        Self::across(origin, [("line", left(&direction)), ("projection", along)])
    }
}

impl<T: Scalar> Onto<T, 3> {
    /// The plane through `origin` across `normal`, reached at a right angle.
    ///
    /// # Errors
    /// [`ShapeError::NoDirection`]; [`Error::NotFinite`] for the origin.
    pub fn plane(origin: SVector<T, 3>, normal: SVector<T, 3>) -> Result<Self> {
        Self::plane_along(origin, normal.clone(), normal)
    }

    /// The plane through `origin` across `normal`, reached along `along`.
    ///
    /// # Errors
    /// [`ShapeError::NoDirection`]; [`ShapeError::ParallelProjection`]; [`Error::NotFinite`] for the origin.
    pub fn plane_along(origin: SVector<T, 3>, normal: SVector<T, 3>, along: SVector<T, 3>) -> Result<Self> {
        Self::across(origin, [("normal", normal), ("projection", along)])
    }

    /// The line in space through `origin` in `direction`, reached at a right angle.
    ///
    /// # Errors
    /// [`ShapeError::NoDirection`]; [`Error::NotFinite`] for the origin.
    pub fn space_line(origin: SVector<T, 3>, direction: SVector<T, 3>) -> Result<Self> {
        Self::space_line_within(origin, direction.clone(), direction)
    }

    /// The line in space through `origin` in `direction`, reached within planes across `normal`.
    ///
    /// # Errors
    /// [`ShapeError::NoDirection`]; [`ShapeError::ParallelProjection`]; [`Error::NotFinite`] for the origin.
    pub fn space_line_within(
        origin: SVector<T, 3>,
        direction: SVector<T, 3>,
        normal: SVector<T, 3>,
    ) -> Result<Self> {
        check_origin(&origin)?;
        let (direction, across, rate) = paired([("line", direction), ("normal", normal)])?;
        Ok(Self { origin, kind: Kind::Line { direction, across, rate } })
    }
}

impl<T: Scalar, const N: usize> Onto<T, N> {
    fn across(origin: SVector<T, N>, pair: [(&'static str, SVector<T, N>); 2]) -> Result<Self> {
        check_origin(&origin)?;
        let (normal, along, rate) = paired(pair)?;
        Ok(Self { origin, kind: Kind::Plane { normal, along, rate } })
    }

    /// Where a point comes to lie.
    pub fn projected(&self, point: &SVector<T, N>) -> SVector<T, N> {
        let off = self.origin.minus(point);
        match &self.kind {
            Kind::Plane { normal, along, rate } => point.plus_scaled(&(dot(&off, normal) / rate), along),
            Kind::Line { direction, across, rate } => {
                self.origin.plus_scaled(&(-dot(&off, across) / rate), direction)
            }
        }
    }

    /// Whether a point lies on the line or plane; over `f64` without any rounding.
    pub fn holds(&self, point: &SVector<T, N>) -> bool {
        match self.height(point) {
            Ok(height) => height.is_zero(),
            Err(_) => self.projected(point) == *point,
        }
    }

    /// How far a point is on the positive side, times the length of the normal.
    ///
    /// # Errors
    /// [`ShapeError::NoSides`] for a line in space.
    pub fn height(&self, point: &SVector<T, N>) -> Result<T> {
        Ok(dot(&point.minus(&self.origin), self.normal()?))
    }

    /// The normal of the plane; of a line in the plane to its left.
    ///
    /// # Errors
    /// [`ShapeError::NoSides`] for a line in space.
    pub fn normal(&self) -> Result<&SVector<T, N>> {
        match &self.kind {
            Kind::Plane { normal, .. } => Ok(normal),
            Kind::Line { .. } => Err(ShapeError::NoSides.into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_and_parallel_vectors_are_refused() {
        let zero = || vector![0.0, 0.0];
        let none = |what| Error::from(ShapeError::NoDirection { what });
        assert_eq!(Onto::line(zero(), zero()).unwrap_err(), none("line"));
        assert_eq!(Onto::line_along(zero(), vector![1.0, 0.0], zero()).unwrap_err(), none("projection"));
        let parallel = Onto::line_along(zero(), vector![1.0, 2.0], vector![-2.0, -4.0]);
        assert_eq!(parallel.unwrap_err(), ShapeError::ParallelProjection.into());
        let up = || vector![0.0, 0.0, 1.0];
        assert_eq!(Onto::plane(up(), up() * 0.0).unwrap_err(), none("normal"));
        assert!(Onto::plane_along(up(), up(), vector![1.0, 1.0, 0.0]).is_err());
        assert!(Onto::space_line_within(up(), up(), vector![1.0, 1.0, 0.0]).is_err());
        assert_eq!(
            Onto::space_line(up(), up()).unwrap().height(&up()).unwrap_err(),
            ShapeError::NoSides.into()
        );
    }

    /// Over floats what is parallel but for rounding is parallel.
    #[test]
    fn nearly_parallel_is_refused() {
        for i in 1..1000 {
            let s = f64::from(i);
            let (flat, plane) = (vector![s.sin(), (1.3 * s).cos()], vector![s.cos(), s.sin(), 0.0]);
            assert!(Onto::line_along(zero2(), flat, flat * (0.1 * s)).is_err(), "{i}");
            let along = vector![-plane[1], plane[0], 0.0] * (0.3 * s) + vector![0.0, 0.0, 1.0];
            assert!(Onto::plane_along(plane, plane, along).is_err(), "{i}");
        }
        let almost = Onto::line_along(zero2(), vector![1.0, 1.0], vector![1.0, 1.0 + 1e-12]).unwrap();
        assert!((almost.projected(&vector![0.0, 1e-12]) + vector![1.0, 1.0]).norm() < 1e-3);
    }

    fn zero2() -> SVector<f64, 2> {
        vector![0.0, 0.0]
    }

    #[test]
    fn short_and_long_vectors_do_as_well() {
        for size in [1e-300, 1e-200, 1e200, 1e300] {
            let onto =
                Onto::plane_along(vector![0.0, 0.0, 1.0], vector![0.0, 0.0, size], vector![size, 0.0, size]);
            assert_eq!(onto.unwrap().projected(&vector![0.0, 5.0, 3.0]), vector![-2.0, 5.0, 1.0]);
        }
    }

    #[test]
    fn lines_in_space() {
        let onto = Onto::space_line(vector![0.0, 0.0, 1.0], vector![1.0, 1.0, 0.0]).unwrap();
        assert_eq!(onto.projected(&vector![2.0, 0.0, 7.0]), vector![1.0, 1.0, 1.0]);
        assert!(onto.holds(&vector![3.0, 3.0, 1.0]) && !onto.holds(&vector![3.0, 2.0, 1.0]));
        let within =
            Onto::space_line_within(vector![0.0, 0.0, 1.0], vector![1.0, 1.0, 0.0], vector![1.0, 0.0, 0.0])
                .unwrap();
        assert_eq!(within.projected(&vector![2.0, 0.0, 7.0]), vector![2.0, 2.0, 1.0]);
    }
}
