//! Reading and writing files.

use crate::error::{Failure, Result};
use crate::value::Thing;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use std::path::PathBuf;
use symspline_files::{Entry, Format};

/// A name, if there is one, and a value.
type Named = (Option<String>, Thing);

fn out(entries: Vec<Entry>) -> Vec<Named> {
    entries.into_iter().map(|entry| (entry.name, Thing(entry.value))).collect()
}

/// What is to be written: a dict of names and values, a list of pairs of a name or `None` and a value or of values alone, or one value.
fn entries(object: &Bound<'_, PyAny>) -> PyResult<Vec<Entry>> {
    if let Ok(dict) = object.cast::<PyDict>() {
        return dict
            .iter()
            .map(|(name, value)| {
                Ok(Entry { name: Some(name.extract()?), value: value.extract::<Thing>()?.0 })
            })
            .collect();
    }
    if let Ok(pairs) = object.extract::<Vec<Named>>() {
        return Ok(pairs.into_iter().map(|(name, value)| Entry { name, value: value.0 }).collect());
    }
    if let Ok(one) = object.extract::<Thing>() {
        return Ok(vec![Entry { name: None, value: one.0 }]);
    }
    let all: Vec<Thing> = object.extract()?;
    Ok(all.into_iter().map(|value| Entry { name: None, value: value.0 }).collect())
}

/// What a file holds, in the format that its name tells: a list of pairs of a name, or `None`, and a value.
#[pyfunction]
fn read(py: Python<'_>, path: PathBuf) -> Result<Vec<Named>> {
    Ok(out(py.detach(|| symspline_files::read(&path))?))
}

/// Writes values to a file in the format that its name tells: a dict of them by name, a list of pairs of a name and a value, a list of
/// values, or one value.
#[pyfunction]
fn write(py: Python<'_>, path: PathBuf, values: &Bound<'_, PyAny>) -> PyResult<()> {
    let entries = entries(values)?;
    Ok(py.detach(|| symspline_files::write(&path, &entries)).map_err(Failure::from)?)
}

/// What the bytes or the text of a file of a format hold, named by the ending of its files.
#[pyfunction]
#[pyo3(signature = (content, format="json"))]
fn loads(py: Python<'_>, content: &Bound<'_, PyAny>, format: &str) -> PyResult<Vec<Named>> {
    let format = Format::by_name(format).map_err(Failure::from)?;
    let bytes = match content.extract::<String>() {
        Ok(text) => text.into_bytes(),
        Err(_) => content.extract::<Vec<u8>>()?,
    };
    Ok(out(py.detach(|| symspline_files::from_bytes(&bytes, format)).map_err(Failure::from)?))
}

/// The bytes of a file of a format that holds these values, as `write` takes them.
#[pyfunction]
#[pyo3(signature = (values, format="json"))]
fn dumps<'py>(py: Python<'py>, values: &Bound<'py, PyAny>, format: &str) -> PyResult<Bound<'py, PyBytes>> {
    let format = Format::by_name(format).map_err(Failure::from)?;
    let entries = entries(values)?;
    let bytes = py.detach(|| symspline_files::to_bytes(&entries, format)).map_err(Failure::from)?;
    Ok(PyBytes::new(py, &bytes))
}

/// The endings of names of files that are known: for each whether it is read and whether it is written.
#[pyfunction]
fn formats() -> Vec<(&'static str, bool, bool)> {
    let all = Format::all();
    all.flat_map(|f| f.endings().iter().map(move |ending| (*ending, f.is_read(), f.is_written()))).collect()
}

/// Adds the functions to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(read, module)?)?;
    module.add_function(wrap_pyfunction!(write, module)?)?;
    module.add_function(wrap_pyfunction!(loads, module)?)?;
    module.add_function(wrap_pyfunction!(dumps, module)?)?;
    module.add_function(wrap_pyfunction!(formats, module)?)
}
