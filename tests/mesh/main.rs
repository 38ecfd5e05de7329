//! Laws of meshes and subdivision surfaces, over `Q` with `==`.

mod doo_sabin;
mod nets;
