//! Surfaces with scaled derivatives, integrated along one path or two.
//!
//! ```text
//! T_uv(u, v) = S(a, c) + ∫_a^u α(u, c) S_u(u, c) du + ∫_c^v α S_v dv
//! T_vu(u, v) = S(a, c) + ∫_c^v α(a, v) S_v(a, v) dv + ∫_a^u α S_u du          [Miura, (8)]
//! T = (T_uv + T_vu) / 2                                                       [Miura, (7)]
//! ```
//! with `(a, c)` the corner where both domains start. Each integral is the fine tuning of curves: of one edge first, then of
//! all isocurves that leave it. So `∂T_uv/∂v = α S_v` and `∂T_vu/∂u = α S_u` everywhere, but unless `α` is constant the other
//! derivative is not the scaled one, and no law tells the curvatures of `T` from those of `S`.
//!
//! Degrees `(p, q)` of `S` and `(a, b)` of `α` give `(p + a, q + b)`. An inner knot of `u` with `m` copies in `S` and `k` in
//! `α` has `max(a + m, p + k)` copies in `T_uv`, where `u` is not integrated, and `max(a + m, p - 1 + k)` in `T_vu`: to lose no
//! smoothness of `S` give `α` the degree of `S` and simple knots, or no knots inside.

use crate::error::Result;
use crate::fine_tune::scale::Scale;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Curve;
use crate::tensor::along::Direction::{self, U, V};
use crate::tensor::spline::{Surface, TensorSpline};

use super::edges::Edge;

/// The way from the first corner of a surface to a point on it, along which the scaled derivative is integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Path {
    /// Along `u` on the edge where `v` starts, then along `v`: `T_uv`. The surface is tuned in `v`.
    UThenV,
    /// Along `v` on the edge where `u` starts, then along `u`: `T_vu`. The surface is tuned in `u`.
    VThenU,
    /// The mean of both: tuned in both directions, half each.
    Both,
}

impl<T: Scalar, const N: usize> Surface<T, N> {
    /// The surface that starts at the same corner and has its derivatives multiplied by `alpha` along `path`.
    ///
    /// Linear in `alpha`, exact over an exact field; `α = 1` gives the surface back, over finer knots. The result is clamped,
    /// also where the surface is periodic, since nothing holds its seam together: [`fine_tuned_from`](Self::fine_tuned_from)
    /// and conditions on the scale ([`NearestScale`](crate::NearestScale)) do that.
    ///
    /// The integral of the scaled derivative of a rational surface is not rational, so those are approximated first, within a
    /// certified tolerance: [`polynomial_within`](crate::Rational::polynomial_within).
    ///
    /// # Errors
    /// [`NotPositive`](crate::Error::NotPositive), [`Undecided`](crate::Error::Undecided) unless `alpha` is proved to be
    /// positive, or allowed any sign by [`Scale::Signed`]; [`DomainMismatch`](crate::Error::DomainMismatch);
    /// [`Discontinuous`](crate::Error::Discontinuous) if the surface may jump; [`DegreeTooHigh`](crate::Error::DegreeTooHigh),
    /// [`TooLarge`](crate::Error::TooLarge); [`NotFinite`](crate::Error::NotFinite) on overflow.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Path, Q, Scalar, SplineSpace, Surface, TensorSpline};
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let corners = [[0, 0], [0, 1], [1, 0], [1, 1]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
    /// let square = Surface::new(line.clone(), line.clone(), corners.to_vec())?;
    /// // α = 1 + u v
    /// let alpha = TensorSpline::new(line.clone(), line, [1, 1, 1, 2].map(Q::int).to_vec())?;
    /// let [across, both] = [Path::UThenV, Path::Both].map(|path| square.fine_tuned(&alpha, path));
    /// let (one, half) = (Q::int(1), Q::frac(1, 2));
    /// assert_eq!(across?.at(&one, &one)?, vector![Q::int(1), Q::frac(3, 2)]);
    /// assert_eq!(both?.at(&half, &one)?, vector![Q::frac(9, 16), Q::frac(9, 8)]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn fine_tuned<'a>(&self, alpha: impl Into<Scale<'a, TensorSpline<T>>>, path: Path) -> Result<Self> {
        let alpha = alpha.into().function()?;
        path.walked(|last| self.tuned_last(last, alpha))
    }

    /// The surface that agrees with this one at `edge` and has the derivative that leads away from there multiplied by
    /// `alpha`.
    ///
    /// ```text
    /// T(u, v) = S(u, c) + ∫_c^v α S_v dv          for the edge where v is c, and likewise for the others
    /// ```
    /// A surface that is periodic along the edge stays so, if `alpha` is periodic too.
    ///
    /// # Errors
    /// As [`fine_tuned`](Self::fine_tuned).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Q, Scalar, Edge, SplineSpace, Surface, TensorSpline};
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let corners = [[0, 0], [0, 1], [1, 0], [1, 1]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
    /// let square = Surface::new(line.clone(), line.clone(), corners.to_vec())?;
    /// let double = TensorSpline::constant(line.clone(), line, Q::int(2))?;
    /// let longer = square.fine_tuned_from(&double, Edge::VEnd)?;
    /// assert_eq!(longer.at(&Q::int(1), &Q::int(0))?, vector![Q::int(1), Q::int(-1)]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn fine_tuned_from<'a>(
        &self,
        alpha: impl Into<Scale<'a, TensorSpline<T>>>,
        edge: Edge,
    ) -> Result<Self> {
        let (alpha, last) = (alpha.into().function()?, edge.direction());
        if edge.is_end() {
            self.reversed(last)?.swept(last, &alpha.reversed(last)?)?.reversed(last)
        } else {
            self.swept(last, alpha)
        }
    }

    /// One path, `last` the direction in which it ends.
    fn tuned_last(&self, last: Direction, alpha: &TensorSpline<T>) -> Result<Self> {
        let start = self.space(last).domain().0;
        let edge = self.isocurve(last, start)?.fine_tuned(Scale::Signed(&alpha.isocurve(last, start)?))?;
        self.swept_from(&edge, last, alpha)
    }

    /// Away from the edge where `last` starts, which stays.
    pub(super) fn swept(&self, last: Direction, alpha: &TensorSpline<T>) -> Result<Self> {
        self.swept_from(&self.isocurve(last, self.space(last).domain().0)?, last, alpha)
    }

    /// `edge + ∫ α S_last`; periodic across `last` if all three are.
    fn swept_from(&self, edge: &Curve<T, N>, last: Direction, alpha: &TensorSpline<T>) -> Result<Self> {
        let across = last.other();
        let mut way =
            self.derivative(last)?.times(alpha)?.along(last, |rows| rows.clamped_ends()?.antiderivative())?;
        let (a, b) = self.space(last).domain();
        let still = SplineSpace::bezier(0, a.clone(), b.clone())?;
        let mut edge = match last {
            V => Self::new(edge.space().clone(), still, edge.coeffs().to_vec())?,
            U => Self::new(still, edge.space().clone(), edge.coeffs().to_vec())?,
        };
        if !(edge.space(across).is_periodic() && way.space(across).is_periodic()) {
            way = way.along(across, |rows| rows.clamped_ends())?;
            edge = edge.along(across, |rows| rows.clamped_ends())?;
        }
        way.sum(&edge)
    }
}

impl Path {
    /// The one path that ends in a direction.
    pub(super) fn ending_in(last: Direction) -> Self {
        match last {
            U => Self::VThenU,
            V => Self::UThenV,
        }
    }

    /// The directions in which the paths end, one or two.
    pub(super) fn lasts(self) -> &'static [Direction] {
        match self {
            Self::UThenV => &[V],
            Self::VThenU => &[U],
            Self::Both => &[V, U],
        }
    }

    /// The surface that `one` makes of a path by the direction in which that ends, or the mean of two.
    pub(super) fn walked<T: Scalar, const N: usize>(
        self,
        one: impl Fn(Direction) -> Result<Surface<T, N>>,
    ) -> Result<Surface<T, N>> {
        match self {
            Self::UThenV => one(V),
            Self::VThenU => one(U),
            Self::Both => one(V)?.sum(&one(U)?)?.scaled(&T::frac(1, 2)),
        }
    }
}
