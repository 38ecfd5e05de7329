//! Choices that Python makes by words.

use crate::error::Failure;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use symspline::{Contact, Continuity, Direction, Ends, Keep};
use symspline_dynamic::{Meeting, Result};

/// A direction of a surface: `"u"` or `"v"`, or 0 or 1.
#[derive(Debug)]
pub struct Along(pub Direction);

impl<'py> FromPyObject<'_, 'py> for Along {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(axis) = object.extract::<usize>() {
            return match axis {
                0 => Ok(Self(Direction::U)),
                1 => Ok(Self(Direction::V)),
                _ => Err(unknown("direction", &axis.to_string(), "\"u\", \"v\", 0 or 1")),
            };
        }
        match object.extract::<String>()?.as_str() {
            "u" => Ok(Self(Direction::U)),
            "v" => Ok(Self(Direction::V)),
            other => Err(unknown("direction", other, "\"u\", \"v\", 0 or 1")),
        }
    }
}

/// What an approximation keeps at the ends: a number of derivatives, the value counting as the first, or a pair of them.
#[derive(Debug)]
pub struct Touch(pub Contact);

impl<'py> FromPyObject<'_, 'py> for Touch {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(both) = object.extract::<usize>() {
            return Ok(Self(Contact::both(both)));
        }
        let (start, end) = object.extract::<(usize, usize)>()?;
        Ok(Self(Contact { start, end }))
    }
}

impl Default for Touch {
    fn default() -> Self {
        Self(Contact::FREE)
    }
}

/// How smooth a spline of a reduced degree is: `"kept"`, `"breaks"`, or at most so many derivatives.
#[derive(Debug)]
pub struct Smooth(pub Continuity);

impl<'py> FromPyObject<'_, 'py> for Smooth {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(at_most) = object.extract::<usize>() {
            return Ok(Self(Continuity::AtMost(at_most)));
        }
        match object.extract::<String>()?.as_str() {
            "kept" => Ok(Self(Continuity::Kept)),
            "breaks" => Ok(Self(Continuity::Breaks)),
            other => Err(unknown("continuity", other, "\"kept\", \"breaks\" or a number")),
        }
    }
}

impl Default for Smooth {
    fn default() -> Self {
        Self(Continuity::Kept)
    }
}

/// The side of a knot: `"left"` or `"right"`.
#[derive(Debug)]
pub struct Side(pub Keep);

impl<'py> FromPyObject<'_, 'py> for Side {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        match object.extract::<String>()?.as_str() {
            "left" => Ok(Self(Keep::Left)),
            "right" => Ok(Self(Keep::Right)),
            other => Err(unknown("side", other, "\"left\" or \"right\"")),
        }
    }
}

/// What least squares do with the first and last point: `"free"`, `"held"`.
#[derive(Debug)]
pub struct AtEnds(pub Ends);

impl<'py> FromPyObject<'_, 'py> for AtEnds {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        match object.extract::<String>()?.as_str() {
            "free" => Ok(Self(Ends::Free)),
            "held" => Ok(Self(Ends::Held)),
            other => Err(unknown("ends", other, "\"free\" or \"held\"")),
        }
    }
}

fn unknown(what: &str, found: &str, possible: &str) -> PyErr {
    PyValueError::new_err(format!("'{found}' is no {what}: {possible} is"))
}

/// The same over fractions (`exact=True`), over floats (`exact=False`), or as it is.
pub fn forced<M: Meeting>(
    of: M,
    exact: Option<bool>,
    to_exact: impl Fn(&M) -> Result<M>,
) -> std::result::Result<M, Failure> {
    Ok(match exact {
        Some(true) => to_exact(&of)?,
        Some(false) => of.rounded()?,
        None => of,
    })
}
