//! Laws of deformable splines: what defines each operator, over `Q` with `==`, on curves and surfaces.

#[path = "../laws/strategies.rs"]
#[allow(dead_code, reason = "the other laws use the rest")]
mod strategies;
#[path = "../laws/rational_strategies.rs"]
#[allow(dead_code, reason = "the other laws use the rest")]
mod rational_strategies;
mod anchors;
mod anchors_floats;
mod body;
mod forces;
mod forces_floats;
mod full_energy;
mod hostile;
mod null_space;
mod pulls;
mod relaxation;
mod sculptor;
mod sculptor_history;
mod stiffness;
