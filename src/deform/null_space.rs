//! The motions that cost nothing.

use crate::deform::breadth::Breadth;
use crate::deform::material::Material;
use crate::deform::stiffness::{ordered, squares};
use crate::error::Result;
use crate::limits::check_entries;
use crate::scalar::Scalar;
use crate::space::SplineSpace;

impl<T: Scalar> Material<T> {
    /// A basis of the motions of the coefficients that `breadth` lets move for which the energy is zero, held coefficients included.
    ///
    /// With the least order `k` of a derivative that has a weight these are the splines that are polynomials below degree `k` on each
    /// span. In a space of degree `p` a knot of multiplicity `m > p + 1 - k` lets them break: bending has a hinge where the spline
    /// is only continuous, and stretching does not feel jumps. If all coefficients may move, the basis therefore has
    ///
    /// ```text
    /// k + Σ max(0, m + k - p - 1)        over the knots inside
    /// ```
    /// vectors, and in a ring with `k > 0` the sum over all knots, at least one. Over floats what is zero but for rounding is zero;
    /// a basis there is as good as the elimination that finds it.
    ///
    /// # Errors
    /// Those of [`Breadth::coeffs`]; [`Error::TooLarge`](crate::Error::TooLarge);
    /// [`Error::NotFinite`](crate::Error::NotFinite) if in floating point the material is beyond the range.
    ///
    /// # Examples
    /// Bending lets linear functions pass, and breaks of them where the spline is only continuous:
    /// ```
    /// use symspline::{Breadth, Material, Q, Scalar, SplineSpace};
    /// let bending = Material::new(Q::int(0), Q::int(1))?;
    /// let smooth = SplineSpace::clamped(2, [0, 1, 2].map(Q::int))?;
    /// assert_eq!(bending.null_space(&smooth, &Breadth::Whole)?.len(), 2);
    /// let hinge = SplineSpace::clamped(2, [0, 1, 1, 2].map(Q::int))?;
    /// let held = bending.null_space(&hinge, &Breadth::BetweenEnds(1))?;
    /// assert_eq!(held, [[Q::int(0), Q::int(1), Q::int(2), Q::int(1), Q::int(0)]]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn null_space(&self, space: &SplineSpace<T>, breadth: &Breadth<T>) -> Result<Vec<Vec<T>>> {
        let (order, width) = ordered(space, &breadth.coeffs(space)?);
        let (factor, loose) = squares(space, self, (&order, width))?.factored();
        check_entries(loose.len(), space.dim())?;
        let spread = |vector: Vec<T>| {
            let mut all = vec![T::zero(); space.dim()];
            order.iter().zip(vector).for_each(|(i, x)| all[*i] = x);
            all
        };
        Ok(factor.null_space(&loose).into_iter().map(spread).collect())
    }
}
