//! Laws of meshes and of the surfaces that come of subdividing them, over `Q` with `==`.

#[path = "../laws/strategies.rs"]
#[allow(dead_code, reason = "the other laws use the rest")]
mod strategies;
mod catmull_clark;
mod doo_sabin;
mod doo_sabin_meshes;
mod extremes;
mod grids;
mod limits;
mod meshes;
mod nets;
mod polygons;
mod tuning;
