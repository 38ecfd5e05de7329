//! Polynomial curves and surfaces as shapes with control points.

use crate::coeff::{Coeff, check_pair};
use crate::constrain::sparse::SparseRow;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::shape::controlled::{Controlled, get, moved_each};
use crate::space::SplineSpace;
use crate::spline::Spline;
use crate::tensor::along::Direction;
use crate::tensor::spline::TensorSpline;

/// `c_i + d` for each move `(i, d)`.
fn moved<T: Scalar, C: Coeff<T>>(coeffs: &[C], moves: &[(usize, C)]) -> Result<Vec<(usize, C)>> {
    let one = T::one();
    let moved = |c: &C, by: &C| {
        check_pair(c, by)?;
        Ok(c.plus_scaled(&one, by))
    };
    moved_each(coeffs, moves, moved)
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

    fn coordinate(at: &T, _: Direction) -> &T {
        at
    }

    fn order_along(order: usize, direction: Direction) -> usize {
        if direction == Direction::U { order } else { 0 }
    }

    fn order_of(along: impl Fn(Direction) -> usize) -> usize {
        along(Direction::U)
    }

    fn flat(&self, index: usize) -> Result<usize> {
        checked(index, self.coeffs().len())
    }

    fn control_point(&self, flat: usize) -> Result<C> {
        get(self.coeffs(), flat).cloned()
    }

    fn control_weight(&self, flat: usize) -> Result<T> {
        get(self.coeffs(), flat).map(|_| T::one())
    }

    fn reach(&self, at: &T, order: usize) -> Result<Vec<(usize, T)>> {
        along_one(self.space(), at, order)
    }

    fn influence(&self, at: &T, order: usize) -> Result<SparseRow<T>> {
        Ok(SparseRow::new(self.reach(at, order)?))
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

    fn elevated_along(&self, _: Direction, raise: usize) -> Result<Self> {
        self.elevated(raise)
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

    fn coordinate(at: &(T, T), direction: Direction) -> &T {
        match direction {
            Direction::U => &at.0,
            Direction::V => &at.1,
        }
    }

    fn order_along((k, l): (usize, usize), direction: Direction) -> usize {
        if direction == Direction::U { k } else { l }
    }

    fn order_of(along: impl Fn(Direction) -> usize) -> (usize, usize) {
        (along(Direction::U), along(Direction::V))
    }

    fn flat(&self, index: (usize, usize)) -> Result<usize> {
        in_grid(self.u(), self.v(), index)
    }

    fn control_point(&self, flat: usize) -> Result<C> {
        get(self.coeffs(), flat).cloned()
    }

    fn control_weight(&self, flat: usize) -> Result<T> {
        get(self.coeffs(), flat).map(|_| T::one())
    }

    fn reach(&self, at: &(T, T), (k, l): (usize, usize)) -> Result<Vec<(usize, T)>> {
        let (left, right) = (along_one(self.u(), &at.0, k)?, along_one(self.v(), &at.1, l)?);
        let mut terms = Vec::with_capacity(left.len() * right.len());
        for (i, n) in &left {
            terms.extend(right.iter().map(|(j, m)| (i * self.v().dim() + j, n.clone() * m)));
        }
        Ok(terms)
    }

    fn influence(&self, at: &(T, T), order: (usize, usize)) -> Result<SparseRow<T>> {
        Ok(SparseRow::new(self.reach(at, order)?))
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

    fn elevated_along(&self, direction: Direction, raise: usize) -> Result<Self> {
        self.elevated(direction, raise)
    }
}

/// The basis functions of one space that may have influence at `x`, with the places of their coefficients.
fn along_one<T: Scalar>(space: &SplineSpace<T>, x: &T, order: usize) -> Result<Vec<(usize, T)>> {
    let row = space.basis_derivative(x, order)?;
    let first = row.first();
    Ok(row.into_weights().into_iter().enumerate().map(|(i, n)| (space.slot(first + i), n)).collect())
}

fn checked(index: usize, length: usize) -> Result<usize> {
    if index < length { Ok(index) } else { Err(Error::IndexOutOfRange { index, length }) }
}

/// The place of control point `(i, j)` of a grid.
fn in_grid<T: Scalar>(u: &SplineSpace<T>, v: &SplineSpace<T>, (i, j): (usize, usize)) -> Result<usize> {
    Ok(checked(i, u.dim())? * v.dim() + checked(j, v.dim())?)
}
