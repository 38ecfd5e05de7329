//! Nodes of spaces, and knots that move them.

use crate::error::Result;
use crate::numbers::Num;
use crate::space::Space;
use pyo3::prelude::*;
use symspline_dynamic::Meeting as _;
use symspline_dynamic::tools::nodes;

/// The knot whose insertion makes `x` a node of the space; none if it is one.
#[pyfunction]
fn node_placing_knot(space: Space, x: Num) -> Result<Option<Num>> {
    Ok(nodes::placing_knot(&*space.0.among(x.0.is_exact())?, &x.0)?.map(Num))
}

/// The last coefficient whose node is at or before `x`, and the one whose node is nearest.
#[pyfunction]
fn nodes_around(space: Space, x: Num) -> Result<(usize, usize)> {
    Ok(nodes::around(&*space.0.among(x.0.is_exact())?, &x.0)?)
}

/// The parameter halfway between nodes `k` and `k + 1`, where the weights of that leg pull evenly.
#[pyfunction]
fn between_nodes(space: &Space, k: usize) -> Result<Num> {
    Ok(Num(nodes::between(&space.0, k)?))
}

/// The knot that puts `x` halfway between two nodes (none if it is there), where that lies ("there", "central", "left_gap",
/// "right_gap"), and the first of the two nodes. A knot that is there already is refused.
#[pyfunction]
fn halfway_knot(space: Space, x: Num) -> Result<(Option<Num>, &'static str, usize)> {
    let (knot, regime, leg) = nodes::halfway(&*space.0.among(x.0.is_exact())?, &x.0, false)?;
    Ok((knot.map(Num), regime, leg))
}

/// As `halfway_knot`, even if there is such a knot already: another copy of it, which makes splines less smooth.
#[pyfunction]
fn halfway_knot_or_copy(space: Space, x: Num) -> Result<(Option<Num>, &'static str, usize)> {
    let (knot, regime, leg) = nodes::halfway(&*space.0.among(x.0.is_exact())?, &x.0, true)?;
    Ok((knot.map(Num), regime, leg))
}

/// Ranges of indices: coefficients without influence outside the interval; knots there that can be removed if the sweep from the
/// left is kept, and if the one from the right is.
#[pyfunction]
fn local_ranges(space: Space, start: Num, end: Num) -> Result<Vec<(usize, usize)>> {
    let space = space.0.among(start.0.is_exact() && end.0.is_exact())?;
    Ok(nodes::local(&space, &start.0, &end.0)?.map(|range| (range.start, range.end)).to_vec())
}

/// Adds the functions to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(node_placing_knot, module)?)?;
    module.add_function(wrap_pyfunction!(nodes_around, module)?)?;
    module.add_function(wrap_pyfunction!(between_nodes, module)?)?;
    module.add_function(wrap_pyfunction!(halfway_knot, module)?)?;
    module.add_function(wrap_pyfunction!(halfway_knot_or_copy, module)?)?;
    module.add_function(wrap_pyfunction!(local_ranges, module)?)
}
