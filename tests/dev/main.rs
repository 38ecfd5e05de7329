#![allow(dead_code)]
#[path = "../laws/strategies.rs"] mod strategies;
#[path = "../laws/least_change.rs"] mod least_change;
#[path = "../laws/nearest_scale.rs"] mod nearest_scale;
