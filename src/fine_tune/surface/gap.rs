//! How far the two paths end from one another.
//!
//! ```text
//! T_uv - T_vu = ∫_a^u ∫_c^v (α_u S_v - α_v S_u) dv du
//! ```
//! The paths agree everywhere exactly if `α_u S_v = α_v S_u`, which on a regular surface means that `α` is constant. Else each
//! path gives a surface of its own, and their mean is half of the gap away from both.

use crate::error::Result;
use crate::fine_tune::scale::Scale;
use crate::ops::bound::{epsilon, finite, largest};
use crate::scalar::Scalar;
use crate::tensor::along::Direction::{U, V};
use crate::tensor::spline::{Surface, TensorSpline};

use super::path::Path;

/// The difference between the surfaces of two paths.
#[derive(Clone, Debug, PartialEq)]
pub struct PathGap<T: Scalar, const N: usize> {
    /// `T_uv - T_vu`.
    pub difference: Surface<T, N>,
    /// At least the largest distance between both.
    pub bound: T,
}

impl<T: Scalar, const N: usize> Surface<T, N> {
    /// How far apart the surfaces are that scaling by `alpha` makes along either path.
    ///
    /// Over an exact field the bound is that of the control points of the difference; elsewhere rounding is counted: with `n`
    /// control points along the longer direction, `d` the sum of all degrees, `|S|` the largest control point and `W` the
    /// largest coefficient of `α` times those of `S_u` and `S_v` times the lengths of the domain,
    /// `8 (d + 2) (n + 10) ε (|S| + W)`, since each leg is made in ten steps whose weights are convex, and `n` of them are
    /// added. Underflow is not accounted for.
    ///
    /// # Errors
    /// As [`fine_tuned`](Self::fine_tuned), but for the sign of `alpha`.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Q, Scalar, SplineSpace, Surface, TensorSpline};
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let corners = [[0, 0], [0, 1], [1, 0], [1, 1]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
    /// let square = Surface::new(line.clone(), line.clone(), corners.to_vec())?;
    /// // α = 1 + u: the gap is (0, u v).
    /// let alpha = TensorSpline::new(line.clone(), line, [1, 1, 2, 2].map(Q::int).to_vec())?;
    /// let gap = square.path_gap(&alpha)?;
    /// assert_eq!(gap.difference.at(&Q::int(1), &Q::frac(1, 2))?, vector![Q::int(0), Q::frac(1, 2)]);
    /// assert_eq!(gap.bound, Q::int(1));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "integrability")]
    pub fn path_gap(&self, alpha: &TensorSpline<T>) -> Result<PathGap<T, N>> {
        let [uv, vu] = [Path::UThenV, Path::VThenU].map(|path| self.fine_tuned(Scale::Signed(alpha), path));
        let difference = uv?.difference(&vu?)?;
        let mut bound = largest(difference.coeffs());
        if !T::EXACT {
            let (mut width, mut degrees) = (largest(self.coeffs()), 0);
            for direction in [U, V] {
                let (a, b) = self.space(direction).domain();
                let speed = largest(self.derivative(direction)?.coeffs()) * largest(alpha.coeffs());
                width += speed * (b.clone() - a);
                degrees += difference.space(direction).degree();
            }
            let steps = difference.u().dim().max(difference.v().dim()) + 10;
            bound += width * T::int(8 * (degrees as i64 + 2) * steps as i64) * epsilon::<T>();
        }
        Ok(PathGap { bound: finite(bound)?, difference })
    }
}
