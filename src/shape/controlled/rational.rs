//! Rational curves and surfaces as shapes with control points: points move, weights stay.

use crate::coeff::Coeff;
use crate::constrain::sparse::SparseRow;
use crate::error::{Error, Result};
use crate::rational::domain::{Domain, Interval, Rectangle};
use crate::rational::quotient::quotients;
use crate::rational::spline::Rational;
use crate::row::Row;
use crate::scalar::Scalar;
use crate::shape::controlled::{Controlled, checked, curve_terms, get, in_grid, surface_terms};
use crate::space::SplineSpace;
use crate::tensor::along::Direction;
use crate::weighted::Weighted;

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

    fn coordinate(at: &T, _: Direction) -> &T {
        at
    }

    fn flat(&self, index: usize) -> Result<usize> {
        checked(index, self.space().dim())
    }

    fn control_point(&self, flat: usize) -> Result<C> {
        projected(self.lifted().coeffs(), flat)
    }

    fn control_weight(&self, flat: usize) -> Result<T> {
        get(self.lifted().coeffs(), flat).map(|c| c.weight.clone())
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

    fn elevated_along(&self, _: Direction, raise: usize) -> Result<Self> {
        self.elevated(raise)
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
        projected(self.lifted().coeffs(), flat)
    }

    fn control_weight(&self, flat: usize) -> Result<T> {
        get(self.lifted().coeffs(), flat).map(|c| c.weight.clone())
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

    fn elevated_along(&self, direction: Direction, raise: usize) -> Result<Self> {
        self.elevated(direction, raise)
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
