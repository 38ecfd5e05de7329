//! Between which values a scalar surface runs, and in which box a surface lies.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::ops::bound::{largest, rounding};
use crate::ops::enclose::{Enclosure, enclose};
use crate::ops::patch::Patch;
use crate::ops::positive::positive_bound_of;
use crate::ops::range::{box_of, each_axis, ends};
use crate::scalar::Scalar;
use crate::tensor::patches::patches;
use crate::tensor::spline::{Surface, TensorSpline};
use nalgebra::SVector;

impl<T: Scalar> TensorSpline<T> {
    /// The least and the greatest coefficient, between which all values lie.
    pub fn coefficient_range(&self) -> (T, T) {
        ends(self.coeffs().iter())
    }

    /// The least and the greatest value, each enclosed as by [`Function::range`](crate::Function::range).
    ///
    /// # Errors
    /// As [`Function::range`](crate::Function::range); [`TooLarge`](crate::Error::TooLarge) if the extreme value is met along
    /// a whole curve, so that too many patches would have to be halved.
    ///
    /// # Examples
    /// ```
    /// use symspline::{SplineSpace, TensorSpline};
    /// let parabola = SplineSpace::bezier(2, 0.0, 1.0)?;
    /// let coeffs = vec![0.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 0.0];
    /// // A hill of height 1 in the middle.
    /// let range = TensorSpline::new(parabola.clone(), parabola, coeffs)?.range(&1e-9)?;
    /// assert_eq!((range.least.bound, range.greatest.value), (0.0, 1.0));
    /// assert_eq!(range.greatest.parameter, (0.5, 0.5));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn range(&self, accuracy: &T) -> Result<Enclosure<T, (T, T)>> {
        Ok(enclose(self.boxes()?, accuracy)?.map_parameters(|[u, v]| (u, v)))
    }

    /// A positive number that no value is below, as [`Function::positive_bound`](crate::Function::positive_bound): a proof that
    /// the function is positive.
    ///
    /// # Errors
    /// As [`Function::positive_bound`](crate::Function::positive_bound).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, Q, Scalar, SplineSpace, TensorSpline};
    /// let parabola = SplineSpace::bezier(2, Q::int(0), Q::int(1))?;
    /// let hollow = |middle: i64| {
    ///     let coeffs = [1, 1, 1, 1, middle, 1, 1, 1, 1].map(Q::int);
    ///     TensorSpline::new(parabola.clone(), parabola.clone(), coeffs.to_vec())
    /// };
    /// // 1 - (1 - middle) / 4 in the middle.
    /// assert!(hollow(-2)?.positive_bound()? > Q::int(0));
    /// let touching = hollow(-3)?.positive_bound().unwrap_err();
    /// assert_eq!(touching, Error::NotPositive { parameter: "(1/2, 1/2)".into(), value: "0".into() });
    /// # Ok::<(), Error>(())
    /// ```
    pub fn positive_bound(&self) -> Result<T> {
        let (size, degree) = (largest(self.coeffs()), self.u().degree() + self.v().degree());
        let noise = |halvings: usize| rounding(&size, degree, (degree, size.clone()), halvings);
        positive_bound_of(self.coeffs(), || self.boxes(), noise)
    }
}

impl<T: Scalar, C: Coeff<T>> TensorSpline<T, C> {
    /// The patches with their rectangles.
    pub(crate) fn boxes(&self) -> Result<Vec<Patch<T, 2, C>>> {
        let degrees = [self.u().degree(), self.v().degree()];
        let (us, vs) = (self.u().breaks(), self.v().breaks());
        let side = |ends: &[(T, usize)]| (ends[0].0.clone(), ends[1].0.clone());
        let sides = us.windows(2).flat_map(|u| vs.windows(2).map(move |v| [side(u), side(v)]));
        let patch = |(coeffs, sides)| Patch { degrees, sides, coeffs };
        Ok(patches(self)?.into_iter().zip(sides).map(patch).collect())
    }
}

impl<T: Scalar, const N: usize> Surface<T, N> {
    /// The lowest and the highest corner of the box of the control points, in which the surface lies.
    pub fn control_box(&self) -> (SVector<T, N>, SVector<T, N>) {
        box_of(self.coeffs())
    }

    /// The range of every coordinate, enclosed as by [`range`](TensorSpline::range): a box around the surface that is too
    /// large by `accuracy` at most on every side.
    ///
    /// # Errors
    /// As [`range`](TensorSpline::range).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{SplineSpace, Surface};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let corners = vec![vector![0.0, 0.0], vector![0.0, 2.0], vector![1.0, 0.0], vector![1.0, 2.0]];
    /// let [x, y] = Surface::new(line.clone(), line, corners)?.bounding_box(&1e-9)?;
    /// assert_eq!((x.greatest.bound, y.greatest.bound), (1.0, 2.0));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn bounding_box(&self, accuracy: &T) -> Result<[Enclosure<T, (T, T)>; N]> {
        each_axis(|axis| self.coordinate(axis)?.range(accuracy))
    }
}
