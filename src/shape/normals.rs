//! Unit normals of curves and surfaces under one name.

use crate::error::Result;
use crate::rational::spline::{NurbsCurve, NurbsSurface};
use crate::scalar::Real;
use crate::shape::controlled::Controlled;
use crate::spline::Curve;
use crate::tensor::spline::Surface;
use nalgebra::SVector;

/// Shapes with one unit normal: curves of the plane, to the left; curves of space, towards where they turn; surfaces of
/// space, along `S_u × S_v`.
pub trait UnitNormal<T: Real>: Controlled<T> {
    /// The unit normal at a place [NURBS, (11.46), (11.54)].
    ///
    /// # Errors
    /// [`OutsideDomain`](crate::Error::OutsideDomain); [`Stationary`](crate::Error::Stationary) where the derivative of a
    /// curve vanishes; [`Straight`](crate::Error::Straight) where a curve of space has no curvature;
    /// [`NoNormal`](crate::Error::NoNormal) where `S_u × S_v` vanishes.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace, UnitNormal};
    /// let line = Curve::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![vector![0.0, 0.0], vector![2.0, 0.0]])?;
    /// assert_eq!(line.unit_normal(&0.5)?, vector![0.0, 1.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn unit_normal(&self, at: &Self::Parameter) -> Result<Self::Point>;
}

/// The normal of the frame.
macro_rules! of_frame {
    ($($curve:ty, $n:literal;)*) => {$(
        impl<T: Real> UnitNormal<T> for $curve {
            fn unit_normal(&self, at: &T) -> Result<SVector<T, $n>> {
                Ok(self.frame_at(at)?.normal().clone())
            }
        }
    )*};
}

of_frame! {
    Curve<T, 2>, 2;
    Curve<T, 3>, 3;
    NurbsCurve<T, 2>, 2;
    NurbsCurve<T, 3>, 3;
}

impl<T: Real> UnitNormal<T> for Surface<T, 3> {
    fn unit_normal(&self, (u, v): &(T, T)) -> Result<SVector<T, 3>> {
        self.unit_normal_at(u, v)
    }
}

impl<T: Real> UnitNormal<T> for NurbsSurface<T, 3> {
    fn unit_normal(&self, (u, v): &(T, T)) -> Result<SVector<T, 3>> {
        self.unit_normal_at(u, v)
    }
}
