//! Words for what fine tuning holds, and where.

use crate::arguments::word;
use crate::error::Result;
use pyo3::prelude::*;
use std::collections::HashMap;
use symspline::{Edge, Edges, Fit, Hold, Norm, Path};

const HOLDS: [(&str, Hold); 4] = [
    ("start", Hold::Start),
    ("points", Hold::Points),
    ("tangents", Hold::Tangents),
    ("curvatures", Hold::Curvatures),
];
const NORMS: [(&str, Norm); 2] = [("coefficients", Norm::Coefficients), ("l2", Norm::L2)];
const PATHS: [(&str, Path); 3] = [("uv", Path::UThenV), ("vu", Path::VThenU), ("both", Path::Both)];
const EDGES: [(&str, Edge); 4] =
    [("u_start", Edge::UStart), ("u_end", Edge::UEnd), ("v_start", Edge::VStart), ("v_end", Edge::VEnd)];
const FITS: [(&str, Fit); 4] = [
    ("free", Fit::Free),
    ("position", Fit::Position),
    ("tangent", Fit::Tangent),
    ("curvature", Fit::Curvature),
];

/// What ends do, by its word.
pub fn hold(name: &str) -> Result<Hold> {
    word("hold", name, &HOLDS)
}

/// A norm by its word.
pub fn norm(name: &str) -> Result<Norm> {
    word("norm", name, &NORMS)
}

/// A path by its word.
pub fn path(name: &str) -> Result<Path> {
    word("path", name, &PATHS)
}

/// An edge by its word.
pub fn edge(name: &str) -> Result<Edge> {
    word("edge", name, &EDGES)
}

/// How edges fit: one word for all, or a word for some, the others free.
#[derive(Debug, FromPyObject)]
pub enum Fits {
    /// The same at all edges.
    All(String),
    /// At some.
    Some(HashMap<String, String>),
}

/// What these words say.
pub fn edges(fits: Option<Fits>) -> Result<Edges> {
    match fits {
        None => Ok(Edges::all(Fit::Position)),
        Some(Fits::All(fit)) => Ok(Edges::all(word("fit", &fit, &FITS)?)),
        Some(Fits::Some(some)) => some.iter().try_fold(Edges::all(Fit::Free), |edges, (at, fit)| {
            Ok(edges.with(edge(at)?, word("fit", fit, &FITS)?))
        }),
    }
}
