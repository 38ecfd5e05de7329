//! Laws of the shape tools: the defining property of each tool, over `Q` with `==`, on curves and surfaces, polynomial and
//! rational.

#[path = "../laws/strategies.rs"]
#[allow(dead_code, reason = "the other laws use the rest")]
mod strategies;
#[path = "../laws/rational_strategies.rs"]
#[allow(dead_code, reason = "the other laws use the rest")]
mod rational_strategies;
mod bend;
mod bend_cases;
mod constraints;
mod flatten;
mod flatten_cases;
mod halfway;
mod hostile;
mod pairs;
mod regions;
mod reposition;
mod warps;
mod weights;
