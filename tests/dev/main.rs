#![allow(dead_code, missing_docs)]
#[path = "../laws/strategies.rs"]
mod strategies;
#[path = "../laws/tuned_surface.rs"]
mod tuned_surface;
