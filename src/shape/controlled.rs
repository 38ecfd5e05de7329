//! What shapes with control points have in common.

use crate::coeff::Coeff;
use crate::constrain::sparse::SparseRow;
use crate::error::{Error, Result};
use crate::rational::domain::{Domain, Interval, Rectangle};
use crate::rational::quotient::quotients;
use crate::rational::spline::Rational;
use crate::row::Row;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;
use crate::tensor::along::Direction;
use crate::tensor::spline::TensorSpline;
use crate::weighted::Weighted;
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

    /// Moves control points by vectors; weights stay. On an error nothing has moved.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`], [`Error::NotFinite`] on overflow.
    fn move_points(&mut self, moves: &[(usize, Self::Point)]) -> Result<()>;

    /// The same shape with `knots` inserted along `direction`.
    ///
    /// # Errors
    /// As [`Spline::inserted`].
    fn inserted_along(&self, direction: Direction, knots: &[T]) -> Result<Self>;

    /// The number of control points.
    fn control_count(&self) -> usize {
        Self::DIRECTIONS.iter().map(|d| self.space_along(*d).dim()).product()
    }

    /// All control points.
    ///
    /// # Errors
    /// [`Error::Weight`].
    fn control_points(&self) -> Result<Vec<Self::Point>> {
        (0..self.control_count()).map(|i| self.control_point(i)).collect()
    }
}

/// `c_i + d` for each move `(i, d)`.
fn moved<T: Scalar, C: Coeff<T>>(coeffs: &[C], moves: &[(usize, C)]) -> Result<Vec<(usize, C)>> {
    let one = T::one();
    let places = moves.iter().map(|(i, by)| Ok((*i, get(coeffs, *i)?.plus_scaled(&one, by))));
    places.collect()
}

/// `(w P + w d, w)` for each move `(i, d)`.
fn moved_weighted<T: Scalar, C: Coeff<T>>(
    coeffs: &[Weighted<T, C>],
    moves: &[(usize, C)],
) -> Result<Vec<(usize, Weighted<T, C>)>> {
    let moved = |(i, by): &(usize, C)| {
        let Weighted { point, weight } = get(coeffs, *i)?;
        Ok((*i, Weighted { point: point.plus_scaled(weight, by), weight: weight.clone() }))
    };
    moves.iter().map(moved).collect()
}

fn get<C>(coeffs: &[C], index: usize) -> Result<&C> {
    coeffs.get(index).ok_or(Error::IndexOutOfRange { index, length: coeffs.len() })
}

fn checked(index: usize, length: usize) -> Result<usize> {
    if index < length { Ok(index) } else { Err(Error::IndexOutOfRange { index, length }) }
}

/// The place of control point `(i, j)` of a grid.
fn in_grid<T: Scalar>(u: &SplineSpace<T>, v: &SplineSpace<T>, (i, j): (usize, usize)) -> Result<usize> {
    Ok(checked(i, u.dim())? * v.dim() + checked(j, v.dim())?)
}

impl<T: Scalar, C: Coeff<T>> Controlled<T> for Spline<T, C> {
    type Point = C;
    type Parameter = T;
    type Order = usize;
    type Index = usize;

    const VALUE: usize = 0;
    const DIRECTIONS: &'static [Direction] = &[Direction::U];

    fn space_along(&self, _: Direction) -> &SplineSpace<T> {
        self.space()
    }

    fn flat(&self, index: usize) -> Result<usize> {
        checked(index, self.coeffs().len())
    }

    fn control_point(&self, flat: usize) -> Result<C> {
        get(self.coeffs(), flat).cloned()
    }

    fn influence(&self, at: &T, order: usize) -> Result<SparseRow<T>> {
        Ok(SparseRow::new(curve_terms(self.space(), at, order)?))
    }

    fn derivative_of(&self, at: &T, order: usize) -> Result<C> {
        self.derivative_at(at, order)
    }

    fn move_points(&mut self, moves: &[(usize, C)]) -> Result<()> {
        let new = moved(self.coeffs(), moves)?;
        self.replace_coeffs(new)
    }

    fn inserted_along(&self, _: Direction, knots: &[T]) -> Result<Self> {
        self.inserted(knots)
    }
}

impl<T: Scalar, C: Coeff<T>> Controlled<T> for TensorSpline<T, C> {
    type Point = C;
    type Parameter = (T, T);
    type Order = (usize, usize);
    type Index = (usize, usize);

    const VALUE: (usize, usize) = (0, 0);
    const DIRECTIONS: &'static [Direction] = &[Direction::U, Direction::V];

    fn space_along(&self, direction: Direction) -> &SplineSpace<T> {
        self.space(direction)
    }

    fn flat(&self, index: (usize, usize)) -> Result<usize> {
        in_grid(self.u(), self.v(), index)
    }

    fn control_point(&self, flat: usize) -> Result<C> {
        get(self.coeffs(), flat).cloned()
    }

    fn influence(&self, at: &(T, T), order: (usize, usize)) -> Result<SparseRow<T>> {
        Ok(SparseRow::new(surface_terms((self.u(), self.v()), at, order)?))
    }

    fn derivative_of(&self, (u, v): &(T, T), (k, l): (usize, usize)) -> Result<C> {
        self.derivative_at(u, v, k, l)
    }

    fn move_points(&mut self, moves: &[(usize, C)]) -> Result<()> {
        let new = moved(self.coeffs(), moves)?;
        self.replace_coeffs(new)
    }

    fn inserted_along(&self, direction: Direction, knots: &[T]) -> Result<Self> {
        self.inserted(direction, knots)
    }
}

impl<T: Scalar, C: Coeff<T>> Controlled<T> for Rational<Interval, T, C> {
    type Point = C;
    type Parameter = T;
    type Order = usize;
    type Index = usize;

    const VALUE: usize = 0;
    const DIRECTIONS: &'static [Direction] = &[Direction::U];

    fn space_along(&self, _: Direction) -> &SplineSpace<T> {
        self.space()
    }

    fn flat(&self, index: usize) -> Result<usize> {
        checked(index, self.space().dim())
    }

    fn control_point(&self, flat: usize) -> Result<C> {
        projected(self.lifted().coeffs(), flat)
    }

    fn influence(&self, at: &T, order: usize) -> Result<SparseRow<T>> {
        rational_row(self.lifted().coeffs(), (order, 0), |k, _| curve_terms(self.space(), at, k))
    }

    fn derivative_of(&self, at: &T, order: usize) -> Result<C> {
        Ok(self.derivatives_at(at, order)?.swap_remove(order))
    }

    fn move_points(&mut self, moves: &[(usize, C)]) -> Result<()> {
        self.move_weighted(moves)
    }

    fn inserted_along(&self, _: Direction, knots: &[T]) -> Result<Self> {
        self.inserted(knots)
    }
}

impl<T: Scalar, C: Coeff<T>> Controlled<T> for Rational<Rectangle, T, C> {
    type Point = C;
    type Parameter = (T, T);
    type Order = (usize, usize);
    type Index = (usize, usize);

    const VALUE: (usize, usize) = (0, 0);
    const DIRECTIONS: &'static [Direction] = &[Direction::U, Direction::V];

    fn space_along(&self, direction: Direction) -> &SplineSpace<T> {
        self.lifted().space(direction)
    }

    fn flat(&self, index: (usize, usize)) -> Result<usize> {
        in_grid(self.u(), self.v(), index)
    }

    fn control_point(&self, flat: usize) -> Result<C> {
        projected(self.lifted().coeffs(), flat)
    }

    fn influence(&self, at: &(T, T), order: (usize, usize)) -> Result<SparseRow<T>> {
        let spaces = (self.u(), self.v());
        rational_row(self.lifted().coeffs(), order, |k, l| surface_terms(spaces, at, (k, l)))
    }

    fn derivative_of(&self, (u, v): &(T, T), (k, l): (usize, usize)) -> Result<C> {
        Ok(self.derivatives_at(u, v, k.max(l))?.swap_remove(k).swap_remove(l))
    }

    fn move_points(&mut self, moves: &[(usize, C)]) -> Result<()> {
        self.move_weighted(moves)
    }

    fn inserted_along(&self, direction: Direction, knots: &[T]) -> Result<Self> {
        self.inserted(direction, knots)
    }
}

impl<D: Domain<T>, T: Scalar, C: Coeff<T>> Rational<D, T, C> {
    /// As [`Controlled::move_points`]: no weight changes.
    fn move_weighted(&mut self, moves: &[(usize, C)]) -> Result<()> {
        let new = moved_weighted(D::coeffs(self.lifted()), moves)?;
        self.replace_points(new)
    }
}

/// The control point of a weighted one.
fn projected<T: Scalar, C: Coeff<T>>(coeffs: &[Weighted<T, C>], index: usize) -> Result<C> {
    let weighted = get(coeffs, index)?;
    if weighted.weight <= T::zero() {
        return Err(Error::Weight { index, weight: weighted.weight.to_string() });
    }
    Ok(weighted.project())
}

/// The weights `R_i^(order)` from the terms of the highest derivative `N_i^(order)` and of those below.
fn rational_row<T: Scalar, C>(
    coeffs: &[Weighted<T, C>],
    (k, l): (usize, usize),
    terms: impl Fn(usize, usize) -> Result<Vec<(usize, T)>>,
) -> Result<SparseRow<T>> {
    let mut last = terms(k, l)?;
    let lifted = |terms: &[(usize, T)]| {
        let point = Row(terms.iter().map(|(i, n)| n.clone() * &coeffs[*i].weight).collect::<Vec<T>>());
        let weight = point.iter().fold(T::zero(), |sum, share| sum + share);
        Weighted { point, weight }
    };
    let row = if (k, l) == (0, 0) {
        lifted(&last).project()
    } else {
        let columns = (0..=k).map(|i| (0..=l).map(|j| Ok(lifted(&terms(i, j)?))).collect());
        let all = quotients(&columns.collect::<Result<Vec<Vec<_>>>>()?);
        all.into_iter().next_back().and_then(|row| row.into_iter().next_back()).expect("there is the value")
    };
    last.iter_mut().zip(row.0).for_each(|((_, n), r)| *n = r);
    Ok(SparseRow::new(last))
}

/// The basis functions of a curve that may have influence at `x`, with indices in its list.
fn curve_terms<T: Scalar>(space: &SplineSpace<T>, x: &T, order: usize) -> Result<Vec<(usize, T)>> {
    let row = space.basis_derivative(x, order)?;
    let first = row.first();
    Ok(row.into_weights().into_iter().enumerate().map(|(i, n)| (space.slot(first + i), n)).collect())
}

/// The basis functions of a surface that may have influence at a place, with indices in its list.
fn surface_terms<T: Scalar>(
    (u, v): (&SplineSpace<T>, &SplineSpace<T>),
    at: &(T, T),
    (k, l): (usize, usize),
) -> Result<Vec<(usize, T)>> {
    let (left, right) = (curve_terms(u, &at.0, k)?, curve_terms(v, &at.1, l)?);
    let in_row = |(i, n): &(usize, T)| {
        let (i, n) = (*i, n.clone());
        right.iter().map(move |(j, m)| (i * v.dim() + j, n.clone() * m)).collect::<Vec<_>>()
    };
    Ok(left.iter().flat_map(in_row).collect())
}
