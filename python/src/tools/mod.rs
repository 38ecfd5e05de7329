//! The tools: functions and classes over the shapes.

// From the ground up: a module uses only what stands above it.
mod values;
mod words;
mod tune;
mod tuner;
mod nodes;
mod shape;
mod coupled;
mod weights;
mod gravity;
mod form;
mod bend;
mod load;
mod breadth;
mod material;
mod deform;
mod full_energy;
mod relax;
mod sculptor;
mod subdivision;
mod curvature;
mod measure;
mod meet;
mod files;

use pyo3::prelude::*;

/// Adds all of them to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    tune::register(module)?;
    tuner::register(module)?;
    nodes::register(module)?;
    shape::register(module)?;
    coupled::register(module)?;
    weights::register(module)?;
    gravity::register(module)?;
    form::register(module)?;
    bend::register(module)?;
    load::register(module)?;
    material::register(module)?;
    deform::register(module)?;
    full_energy::register(module)?;
    relax::register(module)?;
    sculptor::register(module)?;
    subdivision::register(module)?;
    curvature::register(module)?;
    measure::register(module)?;
    meet::register(module)?;
    files::register(module)
}
