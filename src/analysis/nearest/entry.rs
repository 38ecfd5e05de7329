//! Nearest points as methods of curves and surfaces, polynomial and rational.

use crate::analysis::nearest::foot::Nearest;
use crate::analysis::nearest::pieces::Axis;
use crate::analysis::nearest::projector::Projector;
use crate::error::Result;
use crate::rational::spline::{NurbsCurve, NurbsSurface};
use crate::spline::Curve;
use crate::tensor::spline::Surface;
use nalgebra::SVector;

/// The methods of one kind, over its projector.
macro_rules! methods {
    ($type:ident, $parameter:ty, $what:literal, $example:literal) => {
        impl<const N: usize> $type<f64, N> {
            #[doc = concat!("The points of the ", $what, " that are nearest to `point`, as [`Projector::nearest`].")]
            ///
            /// Of many points a [projector](Self::projector) asks faster.
            ///
            /// # Errors
            /// As [`Projector::nearest`] and [`projector`](Self::projector).
            ///
            /// # Examples
            #[doc = $example]
            pub fn nearest(&self, point: &SVector<f64, N>, accuracy: f64) -> Result<Nearest<$parameter, N>> {
                self.projector()?.nearest(point, accuracy)
            }

            #[doc = concat!("The parameters at which the ", $what, " passes within `tolerance` of `point`, as [`Projector::parameters_of`].")]
            ///
            /// # Errors
            /// As [`Projector::parameters_of`] and [`projector`](Self::projector).
            pub fn parameters_of(&self, point: &SVector<f64, N>, tolerance: f64) -> Result<Vec<$parameter>> {
                self.projector()?.parameters_of(point, tolerance)
            }
        }
    };
}

methods!(
    Curve,
    f64,
    "curve",
    "```
use nalgebra::vector;
use symspline::{Curve, SplineSpace};
let line = Curve::new(SplineSpace::bezier(1, 0.0, 4.0)?, vec![vector![0.0, 0.0], vector![4.0, 0.0]])?;
let nearest = line.nearest(&vector![1.0, 2.0], 1e-9)?;
assert_eq!((nearest.feet.len(), nearest.feet[0].parameter, nearest.feet[0].distance), (1, 1.0, 2.0));
assert!(nearest.bound <= 2.0 && nearest.bound > 2.0 - 1e-9);
# Ok::<(), symspline::Error>(())
```"
);

methods!(
    NurbsCurve,
    f64,
    "curve",
    "```
use nalgebra::vector;
use symspline::circle;
let nearest = circle(&vector![1.0, 0.0], &2.0)?.nearest(&vector![1.0, 5.0], 1e-9)?;
assert!((nearest.feet[0].point - vector![1.0, 2.0]).norm() < 1e-12);
# Ok::<(), symspline::Error>(())
```"
);

methods!(
    Surface,
    (f64, f64),
    "surface",
    "```
use nalgebra::vector;
use symspline::{SplineSpace, Surface};
let line = SplineSpace::bezier(1, 0.0, 1.0)?;
let corners = vec![vector![0.0, 0.0, 0.0], vector![0.0, 1.0, 0.0], vector![1.0, 0.0, 0.0], vector![1.0, 1.0, 0.0]];
let nearest = Surface::new(line.clone(), line, corners)?.nearest(&vector![0.5, 3.0, 0.0], 1e-9)?;
assert_eq!((nearest.feet[0].parameter, nearest.feet[0].distance), ((0.5, 1.0), 2.0));
# Ok::<(), symspline::Error>(())
```"
);

methods!(
    NurbsSurface,
    (f64, f64),
    "surface",
    "```
use nalgebra::vector;
use symspline::{NurbsSurface, SplineSpace};
let line = SplineSpace::bezier(1, 0.0, 1.0)?;
let corners = vec![vector![0.0, 0.0, 0.0], vector![0.0, 1.0, 0.0], vector![1.0, 0.0, 0.0], vector![1.0, 1.0, 0.0]];
let nearest = NurbsSurface::new(line.clone(), line, corners, vec![1.0; 4])?.nearest(&vector![0.5, 0.5, 2.0], 1e-9)?;
assert_eq!((nearest.feet[0].parameter, nearest.feet[0].distance), ((0.5, 0.5), 2.0));
# Ok::<(), symspline::Error>(())
```"
);

impl<const N: usize> Curve<f64, N> {
    /// The curve prepared for the nearest points of many points.
    ///
    /// # Errors
    /// [`TooLarge`](crate::Error::TooLarge).
    pub fn projector(&self) -> Result<Projector<f64, N>> {
        Projector::new(self.patches()?, [Axis::of(self.space()), Axis::none()])
    }
}

impl<const N: usize> NurbsCurve<f64, N> {
    /// The curve prepared for the nearest points of many points.
    ///
    /// # Errors
    /// [`TooLarge`](crate::Error::TooLarge); [`NotFinite`](crate::Error::NotFinite) if a control point overflows;
    /// [`Undecided`](crate::Error::Undecided) if halving does not make the weights positive.
    pub fn projector(&self) -> Result<Projector<f64, N>> {
        Projector::new(self.lifted().patches()?, [Axis::of(self.space()), Axis::none()])
    }
}

impl<const N: usize> Surface<f64, N> {
    /// The surface prepared for the nearest points of many points.
    ///
    /// # Errors
    /// [`TooLarge`](crate::Error::TooLarge).
    pub fn projector(&self) -> Result<Projector<(f64, f64), N>> {
        Projector::new(self.boxes()?, [Axis::of(self.u()), Axis::of(self.v())])
    }
}

impl<const N: usize> NurbsSurface<f64, N> {
    /// The surface prepared for the nearest points of many points.
    ///
    /// # Errors
    /// As for [rational curves](NurbsCurve::projector).
    pub fn projector(&self) -> Result<Projector<(f64, f64), N>> {
        Projector::new(self.lifted().boxes()?, [Axis::of(self.u()), Axis::of(self.v())])
    }
}
