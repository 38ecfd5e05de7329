#![allow(dead_code)]
#[path = "../laws/strategies.rs"]
mod strategies;
#[path = "../laws/rational_strategies.rs"]
mod rational_strategies;
#[path = "../laws/zeros.rs"]
mod zeros;
#[path = "../laws/profile.rs"]
mod profile;
