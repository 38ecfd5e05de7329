//! Errors of functions that the library calls.

use crate::error::{Error, Result};
use std::cell::RefCell;

/// What such a function refused waits here: the library knows its own errors alone, and one of these stands for it.
#[derive(Debug, Default)]
pub(crate) struct Aside(RefCell<Option<Error>>);

impl Aside {
    /// What the library is told.
    pub(crate) fn told<R>(&self, found: Result<R>) -> symspline::Result<R> {
        found.map_err(|error| {
            self.0.replace(Some(error));
            symspline::Error::NoLength
        })
    }

    /// What was refused, if anything was, else what the library found.
    ///
    /// # Errors
    /// Either.
    pub(crate) fn out<R>(&self, found: symspline::Result<R>) -> Result<R> {
        match self.0.take() {
            Some(error) => Err(error),
            None => Ok(found?),
        }
    }
}
