//! What shapes with control points have in common.

mod polynomial;
mod rational;

use crate::coeff::Coeff;
use crate::constrain::sparse::SparseRow;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::tensor::along::Direction;
use std::collections::BTreeMap;
use std::fmt::Debug;

/// A curve or surface `Σ R_i P_i` with control points `P_i` that can be moved, polynomial (`R_i = N_i`) or rational.
///
/// Control points are counted in one list: those of a surface row by row, `P_ij` at `i * v.dim() + j`.
///
/// # Examples
/// One text for a curve and a surface: how much of the first control point there is.
/// ```
/// use nalgebra::vector;
/// use symspline::{Controlled, Curve, Result, SplineSpace, Surface};
/// fn first<S: Controlled<f64>>(shape: &S, at: &S::Parameter) -> Result<Option<f64>> {
///     Ok(shape.influence(at, S::VALUE)?.weight(0).copied())
/// }
/// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
/// let edge = Curve::new(line.clone(), vec![vector![0.0, 0.0], vector![1.0, 0.0]])?;
/// let patch = Surface::new(line.clone(), line, vec![vector![0.0, 0.0, 0.0]; 4])?;
/// assert_eq!(first(&edge, &0.25)?, Some(0.75));
/// assert_eq!(first(&patch, &(0.25, 0.5))?, Some(0.375));
/// # Ok::<(), symspline::Error>(())
/// ```
pub trait Controlled<T: Scalar>: Clone + Debug {
    /// What the control points are.
    type Point: Coeff<T>;
    /// A place on the shape: `u` of a curve, `(u, v)` of a surface.
    type Parameter: Clone + Debug;
    /// A derivative: `k` of a curve, `(k, l)` of a surface.
    type Order: Copy + Debug;
    /// The name of a control point: `i` on a curve, `(i, j)` on a surface.
    type Index: Copy + Debug;

    /// The derivative of order zero.
    const VALUE: Self::Order;
    /// The directions there are: of a curve only `U`.
    const DIRECTIONS: &'static [Direction];

    /// The space along `direction`; of a curve the only one.
    fn space_along(&self, direction: Direction) -> &SplineSpace<T>;

    /// The coordinate of a place along `direction`; of a curve the only one.
    fn coordinate(at: &Self::Parameter, direction: Direction) -> &T;

    /// How many derivatives along `direction`; of a curve along `V` none.
    fn order_along(order: Self::Order, direction: Direction) -> usize;

    /// The derivative with so many along each direction.
    fn order_of(along: impl Fn(Direction) -> usize) -> Self::Order;

    /// The place of a control point in the list.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`].
    fn flat(&self, index: Self::Index) -> Result<usize>;

    /// The control point at a place in the list.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`]; [`Error::Weight`] if its weight is not positive, so that it is at infinity or beyond.
    fn control_point(&self, flat: usize) -> Result<Self::Point>;

    /// The weight of a control point; of a polynomial shape one.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`].
    fn control_weight(&self, flat: usize) -> Result<T>;

    /// Derivatives of the polynomial basis functions that may have influence at a place, zeros too, in one sequence for all
    /// orders; in a small ring a control point may stand several times.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`Error::DegreeTooHigh`].
    fn reach(&self, at: &Self::Parameter, order: Self::Order) -> Result<Vec<(usize, T)>>;

    /// The derivatives of the basis functions, `R_i^(order)(at)`, as weights of the control points [NURBS, (11.66) and
    /// (11.83)].
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`Error::DegreeTooHigh`].
    fn influence(&self, at: &Self::Parameter, order: Self::Order) -> Result<SparseRow<T>>;

    /// The derivative of some order at a place; of order [`VALUE`](Self::VALUE) the point.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`Error::DegreeTooHigh`].
    fn derivative_of(&self, at: &Self::Parameter, order: Self::Order) -> Result<Self::Point>;

    /// Moves control points by vectors, one after the other; weights stay. On an error nothing has moved.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`], [`Error::NotFinite`] on overflow; [`Error::Ragged`] for rows of another length than the
    /// control points.
    fn move_points(&mut self, moves: &[(usize, Self::Point)]) -> Result<()>;

    /// The same shape with `knots` inserted along `direction`.
    ///
    /// # Errors
    /// As [`Spline::inserted`](crate::Spline::inserted).
    fn inserted_along(&self, direction: Direction, knots: &[T]) -> Result<Self>;

    /// The same shape, `raise` degrees higher along `direction`.
    ///
    /// # Errors
    /// As [`Spline::elevated`](crate::Spline::elevated).
    fn elevated_along(&self, direction: Direction, raise: usize) -> Result<Self>;

    /// The number of control points.
    fn control_count(&self) -> usize {
        Self::DIRECTIONS.iter().map(|d| self.space_along(*d).dim()).product()
    }

    /// The place in the list of the control point with the given places along each of [`DIRECTIONS`](Self::DIRECTIONS).
    fn flat_of(&self, places: &[usize]) -> usize {
        let dims = Self::DIRECTIONS.iter().map(|d| self.space_along(*d).dim());
        places.iter().zip(dims).fold(0, |flat, (place, dim)| flat * dim + place)
    }

    /// All control points.
    ///
    /// # Errors
    /// [`Error::Weight`].
    fn control_points(&self) -> Result<Vec<Self::Point>> {
        (0..self.control_count()).map(|i| self.control_point(i)).collect()
    }
}

fn get<C>(coeffs: &[C], index: usize) -> Result<&C> {
    coeffs.get(index).ok_or(Error::IndexOutOfRange { index, length: coeffs.len() })
}

/// The new control points after moves, one for each; of one that is named again all moves count.
fn moved_each<C: Clone, D>(
    coeffs: &[C],
    moves: &[(usize, D)],
    moved: impl Fn(&C, &D) -> Result<C>,
) -> Result<Vec<(usize, C)>> {
    let mut new: Vec<(usize, C)> = Vec::with_capacity(moves.len());
    // Prepared edits name each once, in ascending order.
    let again = !moves.is_sorted_by(|(i, _), (j, _)| i < j);
    let mut last: BTreeMap<usize, usize> = BTreeMap::new();
    for (i, by) in moves {
        let before = if again { last.insert(*i, new.len()) } else { None };
        let old = match before {
            Some(place) => &new[place].1,
            None => get(coeffs, *i)?,
        };
        let moved = moved(old, by)?;
        new.push((*i, moved));
    }
    Ok(new)
}
