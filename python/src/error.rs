//! The one exception, with the kind and the data of the Rust error.

use pyo3::create_exception;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::{Value as Json, json};

create_exception!(
    symspline,
    SymsplineError,
    PyValueError,
    "What the library refused.\n\n`kind` is the name of the kind of error, such as \"OutsideDomain\", and `data` a dict of what belongs to it: places, sizes, values."
);

/// An error on its way to Python: a message, the kind, the data.
#[derive(Debug)]
pub struct Failure {
    message: String,
    kind: String,
    data: Json,
}

/// The result of a method.
pub type Result<T> = std::result::Result<T, Failure>;

impl Failure {
    /// An error that has its own kind here.
    pub fn new(kind: &str, message: impl Into<String>) -> Self {
        Self { message: message.into(), kind: kind.to_owned(), data: Json::Object(Default::default()) }
    }
}

/// The innermost kind, and its data.
fn innermost(error: Json) -> (String, Json) {
    match error {
        Json::String(kind) => (kind, Json::Object(Default::default())),
        Json::Object(fields) if fields.len() == 1 => {
            let (kind, inside) = fields.into_iter().next().expect("one field");
            match inside {
                Json::Object(ref data)
                    if data.len() == 1 && data.keys().all(|k| k.starts_with(char::is_uppercase)) =>
                {
                    innermost(inside)
                }
                Json::String(ref inner) if inner.starts_with(char::is_uppercase) && !inner.contains(' ') => {
                    (inner.clone(), Json::Object(Default::default()))
                }
                inside => (kind, inside),
            }
        }
        other => (String::from("Error"), other),
    }
}

impl From<symspline::Error> for Failure {
    fn from(error: symspline::Error) -> Self {
        let (kind, data) = innermost(serde_json::to_value(&error).unwrap_or(Json::Null));
        Self { message: error.to_string(), kind, data }
    }
}

impl From<symspline_dynamic::Error> for Failure {
    fn from(error: symspline_dynamic::Error) -> Self {
        match error {
            symspline_dynamic::Error::Spline(error) => error.into(),
            error => {
                let kind = format!("{error:?}");
                let kind = kind.split(|c: char| !c.is_alphanumeric()).next().unwrap_or("Error").to_owned();
                Self { message: error.to_string(), kind, data: dynamic_data(&error) }
            }
        }
    }
}

/// What belongs to an error of kinds, fields and dimensions.
fn dynamic_data(error: &symspline_dynamic::Error) -> Json {
    use symspline_dynamic::Error::{Dimension, Dimensions, Fields, NoSuch, NotANumber, Torn};
    match error {
        Fields { left, right } => json!({ "left": left, "right": right }),
        Dimensions { left, right } => json!({ "left": left, "right": right }),
        Dimension { found, least } => json!({ "found": found, "least": least }),
        Torn { count, dim } => json!({ "count": count, "dim": dim }),
        NoSuch { operation, left, right } => json!({ "operation": operation, "left": left, "right": right }),
        NotANumber { text } => json!({ "text": text }),
        _ => json!({}),
    }
}

impl From<symspline_files::FileError> for Failure {
    fn from(error: symspline_files::FileError) -> Self {
        let data = json!({ "file": error.file, "place": error.place.to_string() });
        Self { message: error.to_string(), kind: String::from("File"), data }
    }
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> Self {
        let error = SymsplineError::new_err(failure.message);
        Python::attach(|py| {
            let value = error.value(py);
            // A class made here takes attributes.
            let set = value
                .setattr("kind", failure.kind)
                .and_then(|()| value.setattr("data", python(py, &failure.data)?));
            match set {
                Ok(()) => error,
                Err(other) => other,
            }
        })
    }
}

/// JSON as Python's own.
fn python<'py>(py: Python<'py>, json: &Json) -> PyResult<Bound<'py, PyAny>> {
    Ok(match json {
        Json::Null => py.None().into_bound(py),
        Json::Bool(b) => b.into_pyobject(py)?.to_owned().into_any(),
        Json::Number(n) => match (n.as_i64(), n.as_u64()) {
            (Some(n), _) => n.into_pyobject(py)?.into_any(),
            (None, Some(n)) => n.into_pyobject(py)?.into_any(),
            (None, None) => n.as_f64().into_pyobject(py)?,
        },
        Json::String(text) => text.into_pyobject(py)?.into_any(),
        Json::Array(all) => {
            let all = all.iter().map(|x| python(py, x)).collect::<PyResult<Vec<_>>>()?;
            all.into_pyobject(py)?
        }
        Json::Object(fields) => {
            let dict = PyDict::new(py);
            for (key, value) in fields {
                dict.set_item(key, python(py, value)?)?;
            }
            dict.into_any()
        }
    })
}

/// Adds the exception to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("SymsplineError", module.py().get_type::<SymsplineError>())
}
