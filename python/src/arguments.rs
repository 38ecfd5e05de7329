//! Choices that Python makes by words.

use crate::error::{Failure, Result};
use pyo3::prelude::*;
use symspline::{Contact, Continuity, Direction, Ends, Keep};
use symspline_dynamic::Meeting;

/// The one a word names, of those there are.
///
/// # Errors
/// "Word".
pub fn word<T: Copy>(what: &str, word: &str, all: &[(&str, T)]) -> Result<T> {
    match all.iter().find(|(name, _)| *name == word) {
        Some((_, one)) => Ok(*one),
        None => {
            let names: Vec<String> = all.iter().map(|(name, _)| format!("\"{name}\"")).collect();
            Err(Failure::new("Word", format!("{what} is one of {}, not \"{word}\"", names.join(", "))))
        }
    }
}

/// A direction of a surface: `"u"` or `"v"`, or 0 or 1.
#[derive(Clone, Copy, Debug)]
pub struct Along(pub Direction);

impl<'py> FromPyObject<'_, 'py> for Along {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let name = match object.extract::<usize>() {
            Ok(axis) => axis.to_string(),
            Err(_) => object.extract::<String>()?,
        };
        let all = [("u", Direction::U), ("v", Direction::V), ("0", Direction::U), ("1", Direction::V)];
        Ok(Self(word("direction", &name, &all)?))
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
        let all = [("kept", Continuity::Kept), ("breaks", Continuity::Breaks)];
        Ok(Self(word("continuity", &object.extract::<String>()?, &all)?))
    }
}

impl Default for Smooth {
    fn default() -> Self {
        Self(Continuity::Kept)
    }
}

/// The side of a knot: `"left"` or `"right"`.
pub const SIDES: [(&str, Keep); 2] = [("left", Keep::Left), ("right", Keep::Right)];

/// What least squares do with the first and last point.
pub const ENDS: [(&str, Ends); 2] = [("free", Ends::Free), ("held", Ends::Held)];

/// The same over fractions (`exact=True`), over floats (`exact=False`), or as it is.
pub fn forced<M: Meeting>(
    of: M,
    exact: Option<bool>,
    to_exact: impl Fn(&M) -> symspline_dynamic::Result<M>,
) -> Result<M> {
    Ok(match exact {
        Some(true) => to_exact(&of)?,
        Some(false) => of.rounded()?,
        None => of,
    })
}
