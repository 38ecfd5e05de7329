#![allow(dead_code, missing_docs)]
#[path = "../laws/strategies.rs"]
mod strategies;
#[path = "../laws/surface_scale.rs"]
mod surface_scale;
