//! Uniform closed splines from closed polygons.
//!
//! Coefficient `i` of a uniform periodic space over `[0, 1]` with `m` spans starts at the knot `(i - p) / m`. So in degree 2
//! the curve meets the middle of leg `i`, from `p_i` to `p_{i+1}`, at `i / m`, and a function of degree 1 has its coefficient
//! `i` as value there.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The uniform periodic spline of `degree` over `[0, 1]` whose control polygon has these vertices, closed.
    ///
    /// **Chaikin's curves** have degree 2. Bisecting the spans gives the vertices of his rule [Miura, (9), (10)], one more
    /// degree those of the cubic over double knots [Miura, (11), (12), (22)]:
    ///
    /// ```text
    /// bisected()      3/4 p_i + 1/4 p_{i+1},   1/4 p_i + 3/4 p_{i+1}
    /// elevated(1)     5/6 p_i + 1/6 p_{i+1},   1/6 p_i + 5/6 p_{i+1}
    /// ```
    /// as coefficients `2 i`, `2 i + 1`.
    ///
    /// **Scale functions** for a curve of degree `p` have degree `p - 1` and as many coefficients, coefficient `i` for the leg
    /// from `p_i` to `p_{i+1}`. For `p = 2` it is the value at `i / m`, where two segments meet in the middle of the leg: the
    /// virtual vertex of [Miura, 4.1].
    ///
    /// # Errors
    /// [`Error::TooFewPoints`] if there is none; [`Error::DegreeTooHigh`], [`Error::TooLarge`], [`Error::Ragged`],
    /// [`Error::NotFinite`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, Q, Scalar};
    /// let q = |x: i64, y: i64| vector![Q::int(x), Q::int(y)];
    /// let curve = Curve::closed(2, vec![q(0, 0), q(12, 0), q(0, 12)])?;
    /// assert_eq!(curve.at(&Q::frac(1, 3))?, q(6, 6));
    /// assert_eq!(curve.embedded(&curve.space().bisected()?)?.coeffs()[..3], [q(3, 0), q(9, 0), q(9, 3)]);
    /// assert_eq!(curve.elevated(1)?.coeffs()[..3], [q(2, 0), q(10, 0), q(10, 2)]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn closed(degree: usize, vertices: Vec<C>) -> Result<Self> {
        if vertices.is_empty() {
            return Err(Error::TooFewPoints { expected: 1, found: 0 });
        }
        Self::new(SplineSpace::uniform_periodic(degree, vertices.len(), T::zero(), T::one())?, vertices)
    }
}
