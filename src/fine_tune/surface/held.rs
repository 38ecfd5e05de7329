//! Edges put back after fine tuning, line by line of control points.
//!
//! Where the path ends in `v` every column of control points along `v` is put back at its ends as a
//! [curve](crate::fine_tune::hold) is, by a rotation and scaling of its own, to the column of the invariant surface (`α = 1`);
//! where it ends in `u`, every row [Miura, 3.3]. The edge where the path starts is then not integrated along.
//!
//! That holds the edges across the end of the path. At the others, and everywhere for the mean of two paths, the surface keeps
//! its boundary if `α = 1` there, and its derivatives across it up to order `j` if `α - 1` vanishes to order `j`: the paper's
//! examples are like that. So that every `α` does, the `j + 1` outermost lines of control points at an edge that is held are
//! copied from the invariant surface in the end, and [`HeldSurface::forced`] tells how far that moved them.

use crate::coeff::Coeff;
use crate::error::tune::TuneError;
use crate::error::{Error, Result};
use crate::fine_tune::ends::{check_count, hold_line, restore};
use crate::fine_tune::scale::Scale;
use crate::fine_tune::turn::Turnable;
use crate::ops::bound::{finite, size};
use crate::scalar::{Scalar, larger};
use crate::tensor::along::Direction::{self, U, V};
use crate::tensor::spline::{Surface, TensorSpline};
use nalgebra::SVector;

use super::edges::Edges;
use super::path::Path;

/// A fine-tuned surface whose edges were put back.
#[derive(Clone, Debug, PartialEq)]
pub struct HeldSurface<T: Scalar, const N: usize> {
    /// The surface.
    pub surface: Surface<T, N>,
    /// At least the largest distance by which control points were moved to hold what the path alone did not: zero where
    /// `α = 1` along the edges.
    pub forced: T,
}

impl<T: Scalar, const N: usize> Surface<T, N>
where
    SVector<T, N>: Turnable<T>,
{
    /// The surface with its derivatives multiplied by `alpha` along `path`, and the edges put back as `edges` says.
    ///
    /// Of a surface that is periodic in `u`, tuned along a path that ends in `v` with an edge of `v` held, the result is
    /// periodic in `u`. Plane surfaces are exact over any field, those in space need a [`Real`](crate::Real).
    ///
    /// # Errors
    /// Those of [`fine_tuned`](Self::fine_tuned); [`TuneError::NoChord`] if a line of control points begins and ends at one
    /// point, or comes to do so, but was more than a point; [`TuneError::NoEdge`] for edges of a direction in which the surface
    /// is periodic; [`Error::CoefficientCount`] if there are too few lines to hold.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Fit, Path, Q, Scalar, Edges, SplineSpace, Surface, TensorSpline};
    /// let parabola = SplineSpace::bezier(2, Q::int(0), Q::int(1))?;
    /// let points = (0..9).map(|i| vector![Q::int(i / 3), Q::int(i % 3)]).collect();
    /// let square = Surface::new(parabola.clone(), parabola.clone(), points)?;
    /// // A bump in the middle, one at the edges.
    /// let values = [1, 1, 1, 1, 5, 1, 1, 1, 1].map(Q::int).to_vec();
    /// let alpha = TensorSpline::new(parabola.clone(), parabola, values)?;
    /// let held = square.fine_tuned_holding(&alpha, Path::Both, Edges::all(Fit::Position))?;
    /// assert_eq!(held.forced, Q::int(0));
    /// let (third, one) = (Q::frac(1, 3), Q::int(1));
    /// assert_eq!(held.surface.at(&third, &one)?, square.at(&third, &one)?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn fine_tuned_holding<'a>(
        &self,
        alpha: impl Into<Scale<'a, TensorSpline<T>>>,
        path: Path,
        edges: Edges,
    ) -> Result<HeldSurface<T, N>> {
        edges.check(self)?;
        let alpha = alpha.into().function()?;
        let walked = path.walked(|last| match edges.orders(last) {
            [None, None] => self.fine_tuned(Scale::Signed(alpha), Path::ending_in(last)),
            orders => {
                let swept = self.swept(last, alpha)?;
                let invariant = self.invariant(&swept)?;
                lines_held(&swept, &invariant, last, orders)
            }
        })?;
        let invariant = self.invariant(&walked)?;
        let surface = restored(&walked, &invariant, edges)?;
        let moved = surface.coeffs().iter().zip(walked.coeffs()).map(|(to, from)| size(&to.minus(from)));
        Ok(HeldSurface { forced: finite(moved.fold(T::zero(), larger))?, surface })
    }
}

impl<T: Scalar, const N: usize> Surface<T, N> {
    /// This surface over the spaces of a tuned one.
    pub(super) fn invariant(&self, tuned: &Self) -> Result<Self> {
        let mut opened = self.clone();
        for direction in [U, V] {
            if !tuned.space(direction).is_periodic() {
                opened = opened.along(direction, |rows| rows.clamped_ends())?;
            }
        }
        opened.embedded(tuned.u(), tuned.v())
    }
}

/// The surface with the ends of each line of control points along `direction` put back.
fn lines_held<T: Scalar, const N: usize>(
    tuned: &Surface<T, N>,
    invariant: &Surface<T, N>,
    direction: Direction,
    orders: [Option<usize>; 2],
) -> Result<Surface<T, N>>
where
    SVector<T, N>: Turnable<T>,
{
    let turned = |s: &Surface<T, N>| if direction == V { s.clone() } else { s.transposed() };
    let (tuned, invariant) = (turned(tuned), turned(invariant));
    let (u, v) = (tuned.u().clone(), tuned.v().clone());
    let mut points = tuned.into_coeffs();
    hold_lines(&mut points, invariant.coeffs(), v.dim(), orders)
        .map_err(|(line, error)| in_line(error, direction, line))?;
    Ok(turned(&Surface::new(u, v, points)?))
}

/// Puts the ends of all lines of `length` control points back; an error comes with the index of its line.
pub(super) fn hold_lines<T: Scalar, const N: usize>(
    points: &mut [SVector<T, N>],
    invariant: &[SVector<T, N>],
    length: usize,
    orders: [Option<usize>; 2],
) -> std::result::Result<(), (usize, Error)>
where
    SVector<T, N>: Turnable<T>,
{
    let lines = points.chunks_exact_mut(length).zip(invariant.chunks_exact(length));
    lines.enumerate().try_for_each(|(line, (q, i))| hold_line(q, i, orders).map_err(|error| (line, error)))
}

/// An error that says which line it is about.
pub(super) fn in_line(error: Error, direction: Direction, line: usize) -> Error {
    match error {
        Error::NoChord => TuneError::NoChord { direction: direction.to_string(), line }.into(),
        other => other,
    }
}

/// The surface with the control points at the edges that are held copied from the invariant one.
fn restored<T: Scalar, const N: usize>(
    walked: &Surface<T, N>,
    invariant: &Surface<T, N>,
    edges: Edges,
) -> Result<Surface<T, N>> {
    let mut points = walked.coeffs().to_vec();
    restore_edges(&mut points, invariant.coeffs(), [walked.u().dim(), walked.v().dim()], edges)?;
    Surface::new(walked.u().clone(), walked.v().clone(), points)
}

/// Copies the control points at the edges that are held.
pub(super) fn restore_edges<C: Clone>(
    points: &mut [C],
    invariant: &[C],
    [rows, columns]: [usize; 2],
    edges: Edges,
) -> Result<()> {
    for (direction, count) in [(U, rows), (V, columns)] {
        let held: usize = edges.orders(direction).iter().flatten().map(|j| j + 1).sum();
        check_count(count, held)?;
    }
    let [start, end] = edges.orders(U).map(|order| order.map_or(0, |j| j + 1) * columns);
    let far = points.len() - end;
    points[..start].clone_from_slice(&invariant[..start]);
    points[far..].clone_from_slice(&invariant[far..]);
    let lines = points.chunks_exact_mut(columns).zip(invariant.chunks_exact(columns));
    lines.for_each(|(q, i)| restore(q, i, edges.orders(V)));
    Ok(())
}
