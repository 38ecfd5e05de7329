//! Which control points of elastic bodies may move.

use crate::error::Failure;
use crate::numbers::Num;
use pyo3::prelude::*;
use pyo3::types::{PyString, PyTuple};
use symspline_dynamic::tools::elastic::AnyBreadth;

/// Which coefficients may move: "whole", "all" (but the ends), ("ends", n), ("range", a, b), ("around", x, n), ("within", a, b), a
/// list of indices; of a sculptor also ("nearest", n) and ("distance", d).
#[derive(Debug)]
pub struct Breadth(AnyBreadth, bool);

impl<'py> FromPyObject<'_, 'py> for Breadth {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let wrong = || Failure::new("Word", format!("{} tells of no breadth", &*object));
        if let Ok(word) = object.cast::<PyString>() {
            return match word.to_string().as_str() {
                "whole" => Ok(Self(AnyBreadth::Whole, true)),
                "all" => Ok(Self(AnyBreadth::All, true)),
                _ => Err(wrong().into()),
            };
        }
        let tuple = match object.cast::<PyTuple>() {
            Ok(tuple) => tuple,
            Err(_) => return Ok(Self(AnyBreadth::Listed(object.extract()?), true)),
        };
        let items: Vec<Bound<'_, PyAny>> = tuple.iter().collect();
        let Some((Ok(word), items)) = items.split_first().map(|(w, rest)| (w.extract::<String>(), rest))
        else {
            return Ok(Self(AnyBreadth::Listed(object.extract()?), true));
        };
        let number = |x: &Bound<'_, PyAny>| x.extract::<Num>().map(|x| x.0);
        Ok(match (word.as_str(), items) {
            ("ends", [n]) => Self(AnyBreadth::BetweenEnds(n.extract()?), true),
            ("range", [a, b]) => Self(AnyBreadth::Range(a.extract()?, b.extract()?), true),
            ("nearest", [n]) => Self(AnyBreadth::Nearest(n.extract()?), true),
            ("around", [x, n]) => {
                let x = number(x)?;
                let exact = x.is_exact();
                Self(AnyBreadth::Around(x, n.extract()?), exact)
            }
            ("within", [a, b]) => {
                let (a, b) = (number(a)?, number(b)?);
                let exact = a.is_exact() && b.is_exact();
                Self(AnyBreadth::Within(a, b), exact)
            }
            ("distance", [d]) => {
                let d = number(d)?;
                let exact = d.is_exact();
                Self(AnyBreadth::Distance(d), exact)
            }
            _ => return Err(wrong().into()),
        })
    }
}

impl Breadth {
    /// All of them.
    pub fn whole() -> Self {
        Self(AnyBreadth::Whole, true)
    }

    /// The breadth, and whether its numbers are exact.
    pub fn parts(self) -> (AnyBreadth, bool) {
        (self.0, self.1)
    }
}

/// Breadths, and whether their numbers are exact.
pub fn breadths(all: Vec<Breadth>) -> (Vec<AnyBreadth>, bool) {
    let exact = all.iter().all(|b| b.1);
    (all.into_iter().map(|b| b.0).collect(), exact)
}

/// A reach as it is given: one breadth for a curve, a list of two for a surface.
#[derive(Debug)]
pub struct Breadths(pub Vec<Breadth>);

impl<'py> FromPyObject<'_, 'py> for Breadths {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        match object.extract::<Breadth>() {
            Ok(one) => Ok(Self(vec![one])),
            Err(_) => object.extract::<Vec<Breadth>>().map(Self),
        }
    }
}
