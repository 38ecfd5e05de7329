//! Python functions that are called in the midst of the library's work, which may have released the interpreter's lock.

use crate::error::Failure;
use pyo3::prelude::*;
use std::sync::Mutex;

/// What a called function raised.
#[derive(Debug, Default)]
pub struct Called(Mutex<Option<PyErr>>);

impl Called {
    /// What a function gives that is called with the lock. An exception is kept, and an error stands for it.
    ///
    /// # Errors
    /// One that stands for the exception.
    pub fn call<R>(&self, function: impl FnOnce(Python<'_>) -> PyResult<R>) -> symspline_dynamic::Result<R> {
        Python::attach(function).map_err(|error| {
            self.0.lock().unwrap_or_else(std::sync::PoisonError::into_inner).get_or_insert(error);
            symspline_dynamic::Error::NoSuch {
                operation: "result",
                left: String::from("what a Python function refused"),
                right: String::new(),
            }
        })
    }

    /// The exception, if there was one, else the result.
    ///
    /// # Errors
    /// The exception, or that of the result.
    pub fn out<R>(self, result: Result<R, Failure>) -> PyResult<R> {
        match self.0.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner) {
            Some(error) => Err(error),
            None => Ok(result?),
        }
    }
}
