//! Fine tuning of a rectangle of a surface, while the rest stays what it is.
//!
//! The domain of the scale function says which rectangle. The surface is cut there and the middle is fine-tuned with its
//! [edges held](crate::fine_tune::surface::held) [Miura, 3.4]. One surface is made of both again as for
//! [curves](crate::fine_tune::local), in each direction: with `B_i`, `M_j` the basis functions of the tuned rectangle,
//!
//! ```text
//! I + Σ_ij (Q_ij - I_ij) B_i M_j
//! ```
//! where the outermost `Q_ij` are those of `I`, since they are held, and the others have basis functions that the whole surface
//! has too, if it has `p - k` copies of an edge where derivatives up to order `k` are held.

use crate::error::Result;
use crate::error::tune::TuneError;
use crate::fine_tune::place::{Inside, room_for};
use crate::fine_tune::scale::Scale;
use crate::fine_tune::turn::Turnable;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::tensor::along::Direction::{self, U, V};
use crate::tensor::spline::{Surface, TensorSpline};
use nalgebra::SVector;

use super::edges::{Edge, Edges, Fit};
use super::held::HeldSurface;
use super::path::Path;

/// A surface with a rectangle of it fine-tuned.
///
/// Across each edge of the rectangle it meets the rest as the [`Fit`] there says, as far as the surface itself was as smooth.
#[derive(Clone, Debug, PartialEq)]
pub struct LocallyTunedSurface<T: Scalar, const N: usize> {
    original: Surface<T, N>,
    tuned: HeldSurface<T, N>,
    edges: Edges,
}

impl<T: Scalar, const N: usize> LocallyTunedSurface<T, N> {
    /// The whole surface as it was.
    pub fn original(&self) -> &Surface<T, N> {
        &self.original
    }

    /// The rectangle, tuned, with its edges held.
    pub fn tuned(&self) -> &HeldSurface<T, N> {
        &self.tuned
    }

    /// How the rectangle fits at its edges.
    pub fn edges(&self) -> Edges {
        self.edges
    }

    /// Start and end of the rectangle in a direction.
    pub fn portion(&self, direction: Direction) -> (&T, &T) {
        self.tuned.surface.space(direction).domain()
    }

    /// Both as one surface, of degrees `(p + a, q + b)` if the scale function has degrees `(a, b)`.
    ///
    /// Inside the rectangle it has the knots of the tuned part, outside those of the elevated surface; knots of a tensor product
    /// go all through it. Exact over an exact field. Control points whose basis functions lie inside the rectangle are those of
    /// [`tuned`](Self::tuned), the others those of the elevated surface; in `f64` that holds to the bit, and the order of
    /// continuity is that of the space, not subject to rounding.
    ///
    /// # Errors
    /// [`DegreeTooHigh`](crate::Error::DegreeTooHigh), [`TooLarge`](crate::Error::TooLarge);
    /// [`SpanOutOfRange`](crate::Error::SpanOutOfRange) if in `f64` knots are too near.
    pub fn joined(&self) -> Result<Surface<T, N>> {
        let portion = &self.tuned.surface;
        let room = |direction: Direction| -> Result<(SplineSpace<T>, Inside)> {
            let orders = self.edges.orders(direction).map(Option::unwrap_or_default);
            let (whole, part) = (self.original.space(direction), portion.space(direction));
            // A rectangle that goes around a ring has no ends in that direction.
            if part.is_periodic() {
                return Ok((part.clone(), Inside { first: 0, inner: 0..part.dim() }));
            }
            let space = room_for(whole, part, orders)?;
            let inside = Inside::of(&space, part);
            Ok((space, inside))
        };
        let ((u, rows), (v, columns)) = (room(U)?, room(V)?);
        let whole = self.original.embedded(&u, &v)?;
        let mut points = whole.into_coeffs();
        for (i, row) in rows.inner.clone().enumerate() {
            let from = &portion.coeffs()[row * portion.v().dim()..][columns.inner.clone()];
            let to = (rows.first + i) * v.dim() + columns.first;
            points[to..to + from.len()].clone_from_slice(from);
        }
        Surface::new(u, v, points)
    }
}

impl<T: Scalar, const N: usize> Surface<T, N>
where
    SVector<T, N>: Turnable<T>,
{
    /// The surface with the rectangle over the domain of `alpha` fine-tuned, and the rest as it is.
    ///
    /// The domain of `alpha` lies inside that of the surface; its ends need not be knots. Edges of the rectangle inside the
    /// surface have to be held; those on its boundary may be free. Of a surface that is periodic in a direction the rectangle
    /// may end at the seam but not go over it; or it goes all around, with a scale that is periodic too, along a path that ends
    /// in the other direction.
    ///
    /// # Errors
    /// [`OutsideDomain`](crate::Error::OutsideDomain) unless the domain of `alpha` lies inside; [`TuneError::FreeEdge`] for an
    /// edge inside the surface that is not held; [`TuneError::Open`] if a rectangle that goes all around does not close; the others of [`fine_tuned_holding`](Self::fine_tuned_holding);
    /// [`SpanOutOfRange`](crate::Error::SpanOutOfRange) if in `f64` knots are too near.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Edges, Fit, Path, Q, Scalar, SplineSpace, Surface, TensorSpline};
    /// let cubic = SplineSpace::uniform(3, 2, Q::int(0), Q::int(4))?;
    /// let points = (0..25).map(|i| vector![Q::int(i / 5), Q::int(i % 5)]).collect();
    /// let square = Surface::new(cubic.clone(), cubic, points)?;
    /// let part = SplineSpace::bezier(2, Q::int(1), Q::int(3))?;
    /// let values = [1, 1, 1, 1, 4, 1, 1, 1, 1].map(Q::int).to_vec();
    /// let alpha = TensorSpline::new(part.clone(), part, values)?;
    /// let local = square.fine_tuned_on(&alpha, Path::UThenV, Edges::all(Fit::Tangent))?;
    /// let (whole, half) = (local.joined()?, Q::frac(1, 2));
    /// assert_eq!(whole.at(&half, &half)?, square.at(&half, &half)?);
    /// let inside = (Q::int(2), Q::frac(5, 3));
    /// assert_ne!(whole.at(&inside.0, &inside.1)?, square.at(&inside.0, &inside.1)?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "local fine tuning")]
    pub fn fine_tuned_on<'a>(
        &self,
        alpha: impl Into<Scale<'a, TensorSpline<T>>>,
        path: Path,
        edges: Edges,
    ) -> Result<LocallyTunedSurface<T, N>> {
        let alpha = alpha.into().function()?;
        let mut middle = self.clone();
        for direction in [U, V] {
            let (whole, part) = (self.space(direction), alpha.space(direction));
            if whole.is_periodic() && part.is_periodic() {
                continue;
            }
            let ((start, end), (a, b)) = (whole.domain(), part.domain());
            for edge in Edge::ALL.into_iter().filter(|edge| edge.direction() == direction) {
                let on_boundary = if edge.is_end() { b == end } else { a == start };
                if edges.fit(edge) == Fit::Free && (whole.is_periodic() || !on_boundary) {
                    return Err(TuneError::FreeEdge { edge: edge.to_string() }.into());
                }
            }
            middle = middle.restricted(direction, a, b)?;
        }
        let tuned = middle.fine_tuned_holding(Scale::Signed(alpha), path, edges)?;
        for direction in [U, V] {
            if middle.space(direction).is_periodic() && !tuned.surface.space(direction).is_periodic() {
                return Err(TuneError::Open { direction: direction.to_string() }.into());
            }
        }
        Ok(LocallyTunedSurface { original: self.clone(), tuned, edges })
    }
}
