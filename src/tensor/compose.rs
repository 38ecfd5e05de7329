//! Curves on surfaces: a surface along a curve in its parameter domain.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::ops::compose::composition;
use crate::roots::Solvable;
use crate::spline::{Curve, Spline};
use crate::tensor::patches::patches;
use crate::tensor::spline::TensorSpline;

impl<T: Solvable, C: Coeff<T>> TensorSpline<T, C> {
    /// The curve `t -> S(u(t), v(t))` on the surface, for a curve `(u, v)` in its parameter domain: a spline of degree
    /// `(p + q) r`.
    ///
    /// Knots, touching, and what counts at jumps are as for [`Spline::composed`], in both directions.
    ///
    /// # Errors
    /// As [`Spline::composed`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{SplineSpace, TensorSpline, segment};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// // Along the diagonal.
    /// let diagonal = grid.composed(&segment(&vector![0.0, 0.0], &vector![1.0, 1.0])?)?;
    /// assert_eq!(diagonal.coeffs(), [0.0, 1.5, 5.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn composed(&self, curve: &Curve<T, 2>) -> Result<Spline<T, C>> {
        let columns = self.v().breaks().len() - 1;
        let patches = patches(self)?;
        let (u, v) = (curve.coordinate(0)?, curve.coordinate(1)?);
        composition([(self.u(), &u), (self.v(), &v)], |[i, j]| patches[i * columns + j].clone())
    }
}
