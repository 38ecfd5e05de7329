//! Nodes of a space, and knots that move them.

use crate::both;
use crate::error::Result;
use crate::number::{Field, Number};
use crate::over::AnySpace;
use symspline::{Keep, Regime};

/// The knot that makes a parameter a node; none if it is one.
///
/// # Errors
/// Those of [`SplineSpace::node_placing_knot`](symspline::SplineSpace::node_placing_knot).
pub fn placing_knot(space: &AnySpace, x: &Number) -> Result<Option<Number>> {
    both!(space, T, s => Ok(s.node_placing_knot(&T::of(x)?)?.map(Field::number)))
}

/// The last coefficient with a node at or before a parameter, and the one with the nearest.
///
/// # Errors
/// Those of [`SplineSpace::node_before`](symspline::SplineSpace::node_before).
pub fn around(space: &AnySpace, x: &Number) -> Result<(usize, usize)> {
    both!(space, T, s => Ok((s.node_before(&T::of(x)?)?, s.nearest_node(&T::of(x)?)?)))
}

/// The parameter halfway between a node and the next.
///
/// # Errors
/// Those of [`SplineSpace::between_nodes`](symspline::SplineSpace::between_nodes).
pub fn between(space: &AnySpace, k: usize) -> Result<Number> {
    both!(space, s => Ok(s.between_nodes(k)?.number()))
}

/// The knot that puts a parameter halfway between nodes, where it lies, and the first of the nodes; see
/// [`Halfway`](symspline::Halfway). With `copy` it may be another copy of a knot that is there.
///
/// # Errors
/// Those of [`SplineSpace::halfway_knot`](symspline::SplineSpace::halfway_knot).
pub fn halfway(space: &AnySpace, x: &Number, copy: bool) -> Result<(Option<Number>, &'static str, usize)> {
    let name = |regime| match regime {
        Regime::There => "there",
        Regime::Central => "central",
        Regime::LeftGap => "left_gap",
        Regime::RightGap => "right_gap",
    };
    both!(space, T, s => {
        let x = T::of(x)?;
        let found = if copy { s.halfway_knot_or_copy(&x) } else { s.halfway_knot(&x) }?;
        Ok((found.knot.map(Field::number), name(found.regime), found.leg))
    })
}

/// The coefficients without influence outside an interval, and the knots in it that can be removed, by which sweep is kept.
///
/// # Errors
/// Those of [`SplineSpace::local_coeffs`](symspline::SplineSpace::local_coeffs).
pub fn local(space: &AnySpace, start: &Number, end: &Number) -> Result<[std::ops::Range<usize>; 3]> {
    both!(space, T, s => {
        let (a, b) = (T::of(start)?, T::of(end)?);
        let [left, right] = [Keep::Left, Keep::Right].map(|keep| s.removable_knots(&a, &b, keep));
        Ok([s.local_coeffs(&a, &b)?, left?, right?])
    })
}
