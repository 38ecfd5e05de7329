//! The tools: functions and classes over the shapes.

// From the ground up: a module uses only what stands above it.
mod values;
mod words;
mod tune;
mod tuner;
mod shape;
mod weights;
mod form;
mod deform;
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
    shape::register(module)?;
    weights::register(module)?;
    form::register(module)?;
    deform::register(module)?;
    sculptor::register(module)?;
    subdivision::register(module)?;
    curvature::register(module)?;
    measure::register(module)?;
    meet::register(module)?;
    files::register(module)
}
