//! Laws of surfaces. Along each direction they follow from those of curves; here stands what is new: that there are
//! two directions, and that nothing confuses them.

use crate::strategies::{ANY, Kind, SMOOTH};
use symspline::{Direction, Function, Q, TensorSpline};

mod values;
mod operators;
mod derivative;
mod product;
mod integral;
mod forms;
mod volume;
mod rounding;
mod hostile;

/// Every space, with few knots, since coefficients multiply.
const SIDE: Kind = ANY.few(2);
/// Spaces whose splines have a derivative.
const SMOOTH_SIDE: Kind = SMOOTH.few(2);
/// Spaces for products.
const SMALL: Kind = SIDE.of_degree(0, 3);

/// Both directions.
const BOTH: [Direction; 2] = [Direction::U, Direction::V];

/// The other direction.
fn across(direction: Direction) -> Direction {
    match direction {
        Direction::U => Direction::V,
        Direction::V => Direction::U,
    }
}

/// The surface `f(u) g(v)`.
fn outer(f: &Function<Q>, g: &Function<Q>) -> symspline::Result<TensorSpline<Q>> {
    let rows = f.coeffs().iter().map(|c| g.coeffs().iter().map(|d| c.clone() * d).collect()).collect();
    TensorSpline::from_rows(f.space().clone(), g.space().clone(), rows)
}
