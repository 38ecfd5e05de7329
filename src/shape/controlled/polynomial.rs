//! Polynomial curves and surfaces as shapes with control points.

use crate::coeff::Coeff;
use crate::constrain::sparse::SparseRow;
use crate::error::Result;
use crate::scalar::Scalar;
use crate::shape::controlled::{Controlled, checked, curve_terms, get, in_grid, surface_terms};
use crate::space::SplineSpace;
use crate::spline::Spline;
use crate::tensor::along::Direction;
use crate::tensor::spline::TensorSpline;

/// `c_i + d` for each move `(i, d)`.
fn moved<T: Scalar, C: Coeff<T>>(coeffs: &[C], moves: &[(usize, C)]) -> Result<Vec<(usize, C)>> {
    let one = T::one();
    let places = moves.iter().map(|(i, by)| Ok((*i, get(coeffs, *i)?.plus_scaled(&one, by))));
    places.collect()
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

    fn flat(&self, index: usize) -> Result<usize> {
        checked(index, self.coeffs().len())
    }

    fn control_point(&self, flat: usize) -> Result<C> {
        get(self.coeffs(), flat).cloned()
    }

    fn control_weight(&self, flat: usize) -> Result<T> {
        get(self.coeffs(), flat).map(|_| T::one())
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

    fn flat(&self, index: (usize, usize)) -> Result<usize> {
        in_grid(self.u(), self.v(), index)
    }

    fn control_point(&self, flat: usize) -> Result<C> {
        get(self.coeffs(), flat).cloned()
    }

    fn control_weight(&self, flat: usize) -> Result<T> {
        get(self.coeffs(), flat).map(|_| T::one())
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

    fn elevated_along(&self, direction: Direction, raise: usize) -> Result<Self> {
        self.elevated(direction, raise)
    }
}
