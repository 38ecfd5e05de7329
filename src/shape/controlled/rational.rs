//! Rational curves and surfaces as shapes with control points: points move, weights stay.
//!
//! One text for both: what is asked of spaces and places the lifted spline answers, and values and influences are quotients.

use crate::coeff::{Coeff, check_pair};
use crate::constrain::sparse::SparseRow;
use crate::error::{Error, Result};
use crate::rational::domain::Domain;
use crate::rational::quotient::quotients;
use crate::rational::spline::Rational;
use crate::row::Row;
use crate::scalar::Scalar;
use crate::shape::controlled::{Controlled, get, moved_each};
use crate::space::SplineSpace;
use crate::tensor::along::Direction;
use crate::weighted::Weighted;

/// The spline that a rational one is in homogeneous coordinates.
type Lifted<D, T, C> = <D as Domain<T>>::Spline<Weighted<T, C>>;

impl<D: Domain<T>, T: Scalar, C: Coeff<T>> Controlled<T> for Rational<D, T, C>
where
    Lifted<D, T, C>: Controlled<T, Point = Weighted<T, C>>,
{
    type Point = C;
    type Parameter = <Lifted<D, T, C> as Controlled<T>>::Parameter;
    type Order = <Lifted<D, T, C> as Controlled<T>>::Order;
    type Index = <Lifted<D, T, C> as Controlled<T>>::Index;

    const VALUE: Self::Order = Lifted::<D, T, C>::VALUE;
    const DIRECTIONS: &'static [Direction] = Lifted::<D, T, C>::DIRECTIONS;

    fn space_along(&self, direction: Direction) -> &SplineSpace<T> {
        self.lifted().space_along(direction)
    }

    fn coordinate(at: &Self::Parameter, direction: Direction) -> &T {
        Lifted::<D, T, C>::coordinate(at, direction)
    }

    fn order_along(order: Self::Order, direction: Direction) -> usize {
        Lifted::<D, T, C>::order_along(order, direction)
    }

    fn order_of(along: impl Fn(Direction) -> usize) -> Self::Order {
        Lifted::<D, T, C>::order_of(along)
    }

    fn flat(&self, index: Self::Index) -> Result<usize> {
        self.lifted().flat(index)
    }

    fn control_point(&self, flat: usize) -> Result<C> {
        match get(D::coeffs(self.lifted()), flat)? {
            Weighted { weight, .. } if *weight <= T::zero() => {
                Err(Error::Weight { index: flat, weight: weight.to_string() })
            }
            weighted => Ok(weighted.project()),
        }
    }

    fn control_weight(&self, flat: usize) -> Result<T> {
        get(D::coeffs(self.lifted()), flat).map(|c| c.weight.clone())
    }

    fn reach(&self, at: &Self::Parameter, order: Self::Order) -> Result<Vec<(usize, T)>> {
        self.lifted().reach(at, order)
    }

    fn influence(&self, at: &Self::Parameter, order: Self::Order) -> Result<SparseRow<T>> {
        let mut terms = self.reach(at, order)?;
        let lifted = |terms: &[(usize, T)]| {
            let weight = |i: usize| &D::coeffs(self.lifted())[i].weight;
            let point = Row(terms.iter().map(|(i, n)| n.clone() * weight(*i)).collect::<Vec<T>>());
            let weight = point.iter().fold(T::zero(), |sum, share| sum + share);
            Weighted { point, weight }
        };
        let row =
            quotient_at::<_, Self, _>(order, lifted(&terms), |order| Ok(lifted(&self.reach(at, order)?)))?;
        terms.iter_mut().zip(row.0).for_each(|((_, n), r)| *n = r);
        Ok(SparseRow::new(terms))
    }

    fn derivative_of(&self, at: &Self::Parameter, order: Self::Order) -> Result<C> {
        let derivative = |order| self.lifted().derivative_of(at, order);
        quotient_at::<_, Self, _>(order, derivative(order)?, derivative)
    }

    fn move_points(&mut self, moves: &[(usize, C)]) -> Result<()> {
        let moved = |Weighted { point, weight }: &Weighted<T, C>, by: &C| {
            check_pair(point, by)?;
            Ok(Weighted { point: point.plus_scaled(weight, by), weight: weight.clone() })
        };
        let new = moved_each(D::coeffs(self.lifted()), moves, moved)?;
        self.replace_points(new)
    }

    fn inserted_along(&self, direction: Direction, knots: &[T]) -> Result<Self> {
        Self::known(self.lifted().inserted_along(direction, knots)?)
    }

    fn elevated_along(&self, direction: Direction, raise: usize) -> Result<Self> {
        Self::known(self.lifted().elevated_along(direction, raise)?)
    }
}

/// The derivative of some order of a quotient, from that of numerator and denominator and all below.
fn quotient_at<T: Scalar, S: Controlled<T>, C: Coeff<T>>(
    order: S::Order,
    highest: Weighted<T, C>,
    lower: impl Fn(S::Order) -> Result<Weighted<T, C>>,
) -> Result<C> {
    let [k, l] = [Direction::U, Direction::V].map(|d| S::order_along(order, d));
    if (k, l) == (0, 0) {
        return Ok(highest.project());
    }
    let of = |i: usize, j: usize| {
        if (i, j) == (k, l) {
            return Ok(highest.clone());
        }
        lower(S::order_of(|d| if d == Direction::U { i } else { j }))
    };
    let columns = (0..=k).map(|i| (0..=l).map(|j| of(i, j)).collect()).collect::<Result<Vec<Vec<_>>>>()?;
    let last = quotients(&columns).pop().and_then(|mut row| row.pop());
    Ok(last.expect("there is at least the value"))
}
